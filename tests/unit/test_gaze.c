/* SPDX-License-Identifier: MIT
 *
 * The gaze in closed loop with heads of head.h: the sign of each axis, convergence
 * without overshoot, and limits that hold whatever comes in.
 */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <ocellus/ocellus.h>

#include "board.h"
#include "rng.h"
#include "unity.h"

enum { SEED = 20111125, MODELS = 3, FRAME_US = 33333 };

#define TURN 4294967296.0
#define DEGREE (TURN / 360.0)

typedef struct {
    const char *name;
    const ocel_head_model_t *model;
    const ocel_gaze_config_t *config;
} robot_t;

static const robot_t ROBOTS[MODELS] = {{"paper", &ocel_head_paper, &ocel_gaze_paper},
                                       {"icub v1", &ocel_head_icub_v1, &ocel_gaze_icub},
                                       {"icub v2", &ocel_head_icub_v2, &ocel_gaze_icub}};

static rng_t rng;

void setUp(void) {
    rng = rng_seed(SEED);
}

void tearDown(void) {
}

/* ---- A head that does as it is told ---- */

typedef struct {
    const robot_t *robot;
    double q[OCEL_JOINT_COUNT]; /* turns * 2^32 */
} plant_t;

static void encoders(const plant_t *plant, int32_t joints[OCEL_JOINT_COUNT]) {
    for (int i = 0; i < OCEL_JOINT_COUNT; i++) {
        joints[i] = (int32_t)lround(plant->q[i]);
    }
}

static void eyes(const plant_t *plant, ocel_pose_t poses[OCEL_EYE_COUNT]) {
    int32_t joints[OCEL_JOINT_COUNT];
    encoders(plant, joints);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_head_forward(plant->robot->model, joints, poses));
}

/* Where an eye sees a point of the root frame, in double. */
static void seen_at(const ocel_pose_t *X, const double p[3], double d[3]) {
    for (int k = 0; k < 3; k++) {
        d[k] = 0.0;
        for (int i = 0; i < 3; i++) {
            d[k] += (p[i] - X->p_u[i]) * X->r_q30[i][k] / 1073741824.0;
        }
    }
}

static void look(const plant_t *plant, const double target[3],
                 ocel_gaze_error_t errors[OCEL_EYE_COUNT]) {
    ocel_pose_t poses[OCEL_EYE_COUNT];
    eyes(plant, poses);
    for (int eye = 0; eye < OCEL_EYE_COUNT; eye++) {
        double d[3];
        int32_t d_cam[3];
        seen_at(&poses[eye], target, d);
        for (int k = 0; k < 3; k++) {
            d_cam[k] = (int32_t)lround(d[k]);
        }
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_gaze_error(d_cam, &errors[eye]));
    }
}

/* A point `distance` in front of the middle of the eyes, off its axis by angles. */
static void place(const plant_t *plant, double distance, double right, double down,
                  double target[3]) {
    ocel_pose_t poses[OCEL_EYE_COUNT];
    eyes(plant, poses);
    const double d[3] = {distance * sin(right) * cos(down), distance * sin(down),
                         distance * cos(right) * cos(down)};
    for (int i = 0; i < 3; i++) {
        target[i] = (poses[0].p_u[i] + (double)poses[1].p_u[i]) / 2.0;
        for (int k = 0; k < 3; k++) {
            target[i] += poses[0].r_q30[i][k] / 1073741824.0 * d[k];
        }
    }
}

static void move(plant_t *plant, const int32_t command[OCEL_JOINT_COUNT], double seconds) {
    for (int i = 0; i < OCEL_JOINT_COUNT; i++) {
        plant->q[i] += command[i] * seconds;
    }
}

/* Baselines away: .4 m for an iCub, its like for the paper's head. */
static double reach_of(const robot_t *robot) {
    const plant_t plant = {robot, {0}};
    ocel_pose_t poses[OCEL_EYE_COUNT];
    double square = 0.0;
    eyes(&plant, poses);
    for (int i = 0; i < 3; i++) {
        const double d = (double)poses[0].p_u[i] - poses[1].p_u[i];
        square += d * d;
    }
    return 6.0 * sqrt(square);
}

static ocel_gaze_t gaze_of(const robot_t *robot) {
    ocel_gaze_t gaze;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_gaze_init(&gaze, robot->model, robot->config));
    return gaze;
}

/* ---- Errors ---- */

static void errors_are_angles(void) {
    for (int k = 0; k < TEST_TRIALS(20000); k++) {
        const int32_t d[3] = {(int32_t)rng_u32(&rng), (int32_t)rng_u32(&rng),
                              (int32_t)rng_u32(&rng)};
        ocel_gaze_error_t error;
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_gaze_error(d, &error));
        TEST_ASSERT_TRUE(error.seen);
        TEST_ASSERT_DOUBLE_WITHIN(2.0, atan2(d[0], d[2]) * TURN / 6.283185307179586,
                                  error.right_q32);
        TEST_ASSERT_DOUBLE_WITHIN(2.0, atan2(d[1], hypot(d[0], d[2])) * TURN / 6.283185307179586,
                                  error.down_q32);
    }
    const int32_t right[3] = {10, 0, 1000};
    const int32_t below[3] = {0, 10, 1000};
    const int32_t nowhere[3] = {0, 0, 0};
    ocel_gaze_error_t error;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_gaze_error(right, &error));
    TEST_ASSERT_TRUE((error.right_q32 > 0) && (error.down_q32 == 0));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_gaze_error(below, &error));
    TEST_ASSERT_TRUE((error.right_q32 == 0) && (error.down_q32 > 0));
    TEST_ASSERT_EQUAL(OCEL_OUT_OF_RANGE, ocel_gaze_error(nowhere, &error));
    TEST_ASSERT_FALSE(error.seen);
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_gaze_error(NULL, &error));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_gaze_error(right, NULL));
}

/* ---- Signs ---- */

/* The second command for a target, from rest. */
static void command_for(const plant_t *plant, const ocel_gaze_error_t errors[OCEL_EYE_COUNT],
                        int32_t command[OCEL_JOINT_COUNT]) {
    ocel_gaze_t gaze = gaze_of(plant->robot);
    int32_t joints[OCEL_JOINT_COUNT];
    encoders(plant, joints);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_gaze_update(&gaze, 0, errors, joints, command));
    for (int i = 0; i < OCEL_JOINT_COUNT; i++) {
        TEST_ASSERT_EQUAL_INT32(0, command[i]);
    }
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_gaze_update(&gaze, FRAME_US, errors, joints, command));
}

/* What one joint alone does to the errors when it obeys its command for a moment. */
static void obey(const plant_t *plant, const int32_t command[OCEL_JOINT_COUNT], int joint,
                 const double target[3], ocel_gaze_error_t after[OCEL_EYE_COUNT]) {
    plant_t moved = *plant;
    moved.q[joint] += command[joint] * 0.02;
    look(&moved, target, after);
}

/* up, left: +1, -1; the eyes' joint of that axis alone diminishes both errors. */
static void check_eye_sign(const robot_t *robot, int up, int left) {
    plant_t plant = {robot, {0}};
    ocel_gaze_error_t before[OCEL_EYE_COUNT];
    ocel_gaze_error_t after[OCEL_EYE_COUNT];
    int32_t command[OCEL_JOINT_COUNT];
    double target[3];
    const int joint = (up != 0) ? OCEL_EYES_TILT : OCEL_EYES_VERSION;
    plant.q[OCEL_EYES_VERGENCE] = 9.5 * DEGREE; /* about that of the distance */
    place(&plant, reach_of(robot), -0.1 * left, -0.1 * up, target);
    look(&plant, target, before);
    command_for(&plant, before, command);
    TEST_ASSERT_TRUE_MESSAGE(command[joint] != 0, robot->name);
    obey(&plant, command, joint, target, after);
    for (int eye = 0; eye < OCEL_EYE_COUNT; eye++) {
        if (up != 0) {
            TEST_ASSERT_TRUE_MESSAGE(abs(after[eye].down_q32) < abs(before[eye].down_q32),
                                     robot->name);
        } else {
            TEST_ASSERT_TRUE_MESSAGE(abs(after[eye].right_q32) < abs(before[eye].right_q32),
                                     robot->name);
        }
    }
}

static void tilt_up(void) {
    for (int k = 0; k < MODELS; k++) {
        check_eye_sign(&ROBOTS[k], 1, 0);
    }
}

static void tilt_down(void) {
    for (int k = 0; k < MODELS; k++) {
        check_eye_sign(&ROBOTS[k], -1, 0);
    }
}

static void version_to_the_left(void) {
    for (int k = 0; k < MODELS; k++) {
        check_eye_sign(&ROBOTS[k], 0, 1);
    }
}

static void version_to_the_right(void) {
    for (int k = 0; k < MODELS; k++) {
        check_eye_sign(&ROBOTS[k], 0, -1);
    }
}

/* Eyes that meet behind the ball come together, those that meet before it part. */
static void check_vergence(double degrees, int sign) {
    for (int k = 0; k < MODELS; k++) {
        plant_t plant = {&ROBOTS[k], {0}};
        ocel_gaze_error_t before[OCEL_EYE_COUNT];
        ocel_gaze_error_t after[OCEL_EYE_COUNT];
        int32_t command[OCEL_JOINT_COUNT];
        double target[3];
        place(&plant, reach_of(&ROBOTS[k]), 0.0, 0.0, target);
        plant.q[OCEL_EYES_VERGENCE] = degrees * DEGREE;
        look(&plant, target, before);
        command_for(&plant, before, command);
        TEST_ASSERT_TRUE_MESSAGE(command[OCEL_EYES_VERGENCE] * (double)sign > 0.0, ROBOTS[k].name);
        obey(&plant, command, OCEL_EYES_VERGENCE, target, after);
        for (int eye = 0; eye < OCEL_EYE_COUNT; eye++) {
            TEST_ASSERT_TRUE_MESSAGE(abs(after[eye].right_q32) < abs(before[eye].right_q32),
                                     ROBOTS[k].name);
        }
    }
}

static void eyes_come_together(void) {
    check_vergence(2.0, 1);
}

static void eyes_part(void) {
    check_vergence(25.0, -1);
}

/* Eyes that look aside at the ball: the neck alone turns to where they look, so the
 * ball moves to the other side of the image; and the eyes turn back. */
static void check_neck(int up, int left) {
    for (int k = 0; k < MODELS; k++) {
        plant_t plant = {&ROBOTS[k], {0}};
        ocel_gaze_error_t before[OCEL_EYE_COUNT];
        ocel_gaze_error_t after[OCEL_EYE_COUNT];
        int32_t command[OCEL_JOINT_COUNT];
        double target[3];
        const int eye_joint = (up != 0) ? OCEL_EYES_TILT : OCEL_EYES_VERSION;
        const int neck_joint = (up != 0) ? OCEL_NECK_PITCH : OCEL_NECK_YAW;
        const double way = 10.0 * DEGREE * (up + left);
        plant.q[eye_joint] = way * ROBOTS[k].config->sign[eye_joint];
        place(&plant, 4.0 * reach_of(&ROBOTS[k]), 0.0, 0.0, target);
        look(&plant, target, before);
        const ocel_gaze_error_t none[OCEL_EYE_COUNT] = {{true, 0, 0}, {true, 0, 0}};
        command_for(&plant, none, command);
        TEST_ASSERT_TRUE_MESSAGE(command[neck_joint] != 0, ROBOTS[k].name);
        TEST_ASSERT_TRUE_MESSAGE(command[eye_joint] * plant.q[eye_joint] < 0.0, ROBOTS[k].name);
        obey(&plant, command, neck_joint, target, after);
        for (int eye = 0; eye < OCEL_EYE_COUNT; eye++) {
            const double moved = (up != 0)
                                     ? (double)after[eye].down_q32 - (double)before[eye].down_q32
                                     : (double)after[eye].right_q32 - (double)before[eye].right_q32;
            TEST_ASSERT_TRUE_MESSAGE(moved * (up + left) > 0.0, ROBOTS[k].name);
        }
        /* Neck and eyes together keep the ball where it was, but for the parallax. */
        plant_t together = plant;
        move(&together, command, 0.05);
        look(&together, target, after);
        const double shift = (up != 0) ? (double)after[0].down_q32 - (double)before[0].down_q32
                                       : (double)after[0].right_q32 - (double)before[0].right_q32;
        TEST_ASSERT_TRUE_MESSAGE(fabs(shift) < 0.3 * abs(command[neck_joint]) * 0.05,
                                 ROBOTS[k].name);
    }
}

static void neck_pitches_up(void) {
    check_neck(1, 0);
}

static void neck_pitches_down(void) {
    check_neck(-1, 0);
}

static void neck_yaws_left(void) {
    check_neck(0, 1);
}

static void neck_yaws_right(void) {
    check_neck(0, -1);
}

static void neck_rolls_back(void) {
    for (int k = 1; k < MODELS; k++) {
        for (int way = -1; way <= 1; way += 2) {
            plant_t plant = {&ROBOTS[k], {0}};
            int32_t command[OCEL_JOINT_COUNT];
            const ocel_gaze_error_t none[OCEL_EYE_COUNT] = {{true, 0, 0}, {true, 0, 0}};
            plant.q[OCEL_NECK_ROLL] = way * 10.0 * DEGREE;
            command_for(&plant, none, command);
            TEST_ASSERT_TRUE(command[OCEL_NECK_ROLL] * way < 0);
        }
    }
}

/* ---- Closed loop ---- */

typedef struct {
    double settled_s; /* when the error was last over .1 degrees */
    double overshoot; /* beyond 0 on the other side of the first error, degrees */
    double deviation; /* of tilt and version at the end, degrees */
} answer_t;

static double worst_error(const ocel_gaze_error_t errors[OCEL_EYE_COUNT]) {
    double worst = 0.0;
    for (int eye = 0; eye < OCEL_EYE_COUNT; eye++) {
        worst = fmax(worst,
                     fmax(fabs((double)errors[eye].right_q32), fabs((double)errors[eye].down_q32)));
    }
    return worst / DEGREE;
}

/* late: the images of a frame are answered in the next one. */
static answer_t settle(plant_t *plant, const double target[3], int64_t frame_us, bool late) {
    ocel_gaze_t gaze = gaze_of(plant->robot);
    ocel_gaze_error_t errors[OCEL_EYE_COUNT];
    ocel_gaze_error_t earlier[OCEL_EYE_COUNT];
    answer_t answer = {0.0, 0.0, 0.0};
    double first[2] = {0.0, 0.0};
    for (int64_t time = 0; time < 4000000; time += frame_us) {
        int32_t joints[OCEL_JOINT_COUNT];
        int32_t command[OCEL_JOINT_COUNT];
        look(plant, target, errors);
        const double now[2] = {((double)errors[0].right_q32 + errors[1].right_q32) / 2.0 / DEGREE,
                               ((double)errors[0].down_q32 + errors[1].down_q32) / 2.0 / DEGREE};
        for (int k = 0; k < 2; k++) {
            first[k] = (time == 0) ? now[k] : first[k];
            if (fabs(first[k]) > 1.0) {
                answer.overshoot = fmax(answer.overshoot, (first[k] > 0.0) ? -now[k] : now[k]);
            }
        }
        if (worst_error(errors) > 0.1) {
            answer.settled_s = (double)time * 1e-6;
        }
        encoders(plant, joints);
        TEST_ASSERT_EQUAL(OCEL_OK,
                          ocel_gaze_update(&gaze, time, (late && (time > 0)) ? earlier : errors,
                                           joints, command));
        memcpy(earlier, errors, sizeof(earlier));
        move(plant, command, (double)frame_us * 1e-6);
    }
    answer.deviation =
        fmax(fabs(plant->q[OCEL_EYES_TILT]), fabs(plant->q[OCEL_EYES_VERSION])) / DEGREE;
    return answer;
}

static answer_t worst_answer(const robot_t *robot, bool late) {
    answer_t worst = {0.0, 0.0, 0.0};
    for (int trial = 0; trial < TEST_TRIALS(300); trial++) {
        plant_t plant = {robot, {0}};
        double target[3];
        plant.q[OCEL_NECK_PITCH] = rng_uniform(&rng, -15.0, 10.0) * DEGREE;
        plant.q[OCEL_NECK_YAW] = rng_uniform(&rng, -25.0, 25.0) * DEGREE;
        plant.q[OCEL_EYES_VERGENCE] = rng_uniform(&rng, 0.0, 20.0) * DEGREE;
        /* Half of 320x240 at f = 277 px is 30 x 23 degrees; the neck tips up to 30. */
        place(&plant, reach_of(robot) * rng_uniform(&rng, 0.6, 3.0), rng_uniform(&rng, -0.4, 0.4),
              rng_uniform(&rng, -0.25, 0.4), target);
        const answer_t answer = settle(&plant, target, (trial % 2 == 0) ? 33333 : 16667, late);
        worst.settled_s = fmax(worst.settled_s, answer.settled_s);
        worst.overshoot = fmax(worst.overshoot, answer.overshoot);
        worst.deviation = fmax(worst.deviation, answer.deviation);
    }
    printf("%s%s: below .1 degrees after %.2f s, overshoot %.2f degrees, eyes %.2f off\n",
           robot->name, late ? ", a frame late" : "", worst.settled_s, worst.overshoot,
           worst.deviation);
    return worst;
}

/* What it goes beyond comes from the neck, whose turning moves the eyes too. */
static void converges_from_any_visible_target(void) {
    for (int k = 0; k < MODELS; k++) {
        const answer_t worst = worst_answer(&ROBOTS[k], false);
        TEST_ASSERT_TRUE(worst.settled_s < 2.5);
        TEST_ASSERT_TRUE(worst.overshoot < 1.0);
        TEST_ASSERT_TRUE(worst.deviation < 0.1);
    }
}

static void converges_a_frame_late(void) {
    for (int k = 0; k < MODELS; k++) {
        const answer_t worst = worst_answer(&ROBOTS[k], true);
        TEST_ASSERT_TRUE(worst.settled_s < 2.5);
        TEST_ASSERT_TRUE(worst.overshoot < 2.0);
        TEST_ASSERT_TRUE(worst.deviation < 0.1);
    }
}

/* A roll that was there goes. */
static void roll_goes(void) {
    for (int k = 1; k < MODELS; k++) {
        plant_t plant = {&ROBOTS[k], {0}};
        double target[3];
        plant.q[OCEL_NECK_ROLL] = -20.0 * DEGREE;
        place(&plant, reach_of(&ROBOTS[k]), 0.1, 0.1, target);
        const answer_t answer = settle(&plant, target, FRAME_US, false);
        TEST_ASSERT_TRUE(answer.settled_s < 3.0);
        TEST_ASSERT_DOUBLE_WITHIN(0.1 * DEGREE, 0.0, plant.q[OCEL_NECK_ROLL]);
    }
}

/* ---- Who sees ---- */

static void one_eye_leads_and_vergence_rests(void) {
    for (int k = 0; k < MODELS; k++) {
        for (int eye = 0; eye < OCEL_EYE_COUNT; eye++) {
            plant_t plant = {&ROBOTS[k], {0}};
            ocel_gaze_t gaze = gaze_of(&ROBOTS[k]);
            double target[3];
            plant.q[OCEL_EYES_VERGENCE] = 6.0 * DEGREE;
            place(&plant, reach_of(&ROBOTS[k]), 0.2, -0.1, target);
            ocel_gaze_error_t errors[OCEL_EYE_COUNT];
            for (int64_t time = 0; time < 4000000; time += FRAME_US) {
                int32_t joints[OCEL_JOINT_COUNT];
                int32_t command[OCEL_JOINT_COUNT];
                look(&plant, target, errors);
                errors[1 - eye].seen = false;
                errors[1 - eye].right_q32 = INT32_MIN; /* not to be read */
                errors[1 - eye].down_q32 = INT32_MIN;
                encoders(&plant, joints);
                TEST_ASSERT_EQUAL(OCEL_OK, ocel_gaze_update(&gaze, time, errors, joints, command));
                TEST_ASSERT_EQUAL_INT32(0, command[OCEL_EYES_VERGENCE]);
                move(&plant, command, FRAME_US * 1e-6);
            }
            TEST_ASSERT_TRUE(abs(errors[eye].right_q32) < 0.1 * DEGREE);
            TEST_ASSERT_TRUE(abs(errors[eye].down_q32) < 0.1 * DEGREE);
        }
    }
}

static void unseen_it_comes_to_rest(void) {
    const robot_t *const robot = &ROBOTS[1];
    ocel_gaze_t gaze = gaze_of(robot);
    /* Eyes off their middle, which the neck would follow. */
    const int32_t joints[OCEL_JOINT_COUNT] = {0, 0, 0, 50000000, 100000000, 0};
    ocel_gaze_error_t errors[OCEL_EYE_COUNT] = {{true, 200000000, 100000000},
                                                {true, 100000000, 100000000}};
    int32_t last[OCEL_JOINT_COUNT];
    int64_t time = 0;
    for (; time < 300000; time += 30000) {
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_gaze_update(&gaze, time, errors, joints, last));
    }
    for (int i = 0; i < OCEL_JOINT_COUNT; i++) {
        TEST_ASSERT_TRUE((last[i] != 0) || (i == OCEL_NECK_ROLL));
    }
    memset(errors, 0, sizeof(errors));
    for (; time < 600000; time += 10000) {
        int32_t command[OCEL_JOINT_COUNT];
        TEST_ASSERT_EQUAL(OCEL_NOT_SEEN, ocel_gaze_update(&gaze, time, errors, joints, command));
        for (int i = 0; i < OCEL_JOINT_COUNT; i++) {
            TEST_ASSERT_TRUE(labs((long)command[i]) <= labs((long)last[i]));
        }
        memcpy(last, command, sizeof(last));
    }
    for (int i = 0; i < OCEL_JOINT_COUNT; i++) {
        TEST_ASSERT_EQUAL_INT32(0, last[i]);
    }
}

/* Within the dead band nothing moves. */
static void the_dead_band_is_still(void) {
    const ocel_gaze_config_t *const config = ROBOTS[0].config;
    const int32_t band = config->dead_band_q32;
    const int32_t joints[OCEL_JOINT_COUNT] = {0};
    int32_t command[OCEL_JOINT_COUNT];
    ocel_gaze_t gaze = gaze_of(&ROBOTS[0]);
    /* Vergence's error is the difference of two. */
    const ocel_gaze_error_t within[OCEL_EYE_COUNT] = {{true, band, band}, {true, band, band}};
    const ocel_gaze_error_t beyond[OCEL_EYE_COUNT] = {{true, 2 * band, 0}, {true, 2 * band, 0}};
    for (int64_t time = 0; time < 1000000; time += FRAME_US) {
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_gaze_update(&gaze, time, within, joints, command));
        for (int i = 0; i < OCEL_JOINT_COUNT; i++) {
            TEST_ASSERT_EQUAL_INT32(0, command[i]);
        }
    }
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_gaze_update(&gaze, 1000001, beyond, joints, command));
    TEST_ASSERT_TRUE(command[OCEL_EYES_VERSION] < 0);
}

/* An error that cannot be had for seconds leaves nothing behind. */
static void nothing_winds_up(void) {
    const robot_t *const robot = &ROBOTS[0];
    ocel_gaze_t gaze = gaze_of(robot);
    int32_t joints[OCEL_JOINT_COUNT] = {0};
    int32_t command[OCEL_JOINT_COUNT];
    ocel_gaze_error_t errors[OCEL_EYE_COUNT] = {{true, 0, -200000000}, {true, 0, -200000000}};
    int64_t time = 0;
    joints[OCEL_NECK_PITCH] = robot->model->max_q32[OCEL_NECK_PITCH];
    joints[OCEL_EYES_TILT] = robot->model->max_q32[OCEL_EYES_TILT];
    for (; time < 10000000; time += FRAME_US) {
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_gaze_update(&gaze, time, errors, joints, command));
        TEST_ASSERT_EQUAL_INT32(0, command[OCEL_EYES_TILT]);
    }
    errors[0].down_q32 = 50000000;
    errors[1].down_q32 = 50000000;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_gaze_update(&gaze, time, errors, joints, command));
    TEST_ASSERT_TRUE(command[OCEL_EYES_TILT] < -200000000);
}

/* One second of small errors that persist, in all directions. */
static ocel_gaze_t integrated(int64_t *time) {
    ocel_gaze_config_t config = *ROBOTS[0].config;
    const ocel_gaze_error_t small[OCEL_EYE_COUNT] = {{true, 15000000, 10000000},
                                                     {true, 5000000, 10000000}};
    const int32_t joints[OCEL_JOINT_COUNT] = {0};
    int32_t command[OCEL_JOINT_COUNT];
    ocel_gaze_t gaze;
    config.neck_gain_q16 = 0;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_gaze_init(&gaze, ROBOTS[0].model, &config));
    for (*time = 0; *time < 1000000; *time += FRAME_US) {
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_gaze_update(&gaze, *time, small, joints, command));
    }
    return gaze;
}

/* Frames of `before`, then the command without an error: what the integral is still. */
static void check_forgotten(const ocel_gaze_error_t before[OCEL_EYE_COUNT], int frames,
                            bool vergence_only) {
    const ocel_gaze_error_t none[OCEL_EYE_COUNT] = {{true, 0, 0}, {true, 0, 0}};
    const int32_t joints[OCEL_JOINT_COUNT] = {0};
    int32_t command[OCEL_JOINT_COUNT];
    int64_t time;
    ocel_gaze_t gaze = integrated(&time);
    for (int frame = 0; frame < frames; frame++) {
        (void)ocel_gaze_update(&gaze, time, before, joints, command);
        time += FRAME_US;
    }
    for (int frame = 0; frame < 2; frame++) {
        (void)ocel_gaze_update(&gaze, time, none, joints, command);
        time += FRAME_US;
    }
    for (int i = vergence_only ? OCEL_EYES_VERGENCE : 0; i < OCEL_JOINT_COUNT; i++) {
        TEST_ASSERT_TRUE(abs(command[i]) <= 1);
    }
}

static void the_integral_is_forgotten(void) {
    const ocel_gaze_error_t none[OCEL_EYE_COUNT] = {{true, 0, 0}, {true, 0, 0}};
    const ocel_gaze_error_t unseen[OCEL_EYE_COUNT] = {{false, 0, 0}, {false, 0, 0}};
    const ocel_gaze_error_t one[OCEL_EYE_COUNT] = {{true, 0, 0}, {false, 0, 0}};
    const ocel_gaze_error_t large[OCEL_EYE_COUNT] = {{true, 300000000, 300000000},
                                                     {true, -300000000, 300000000}};
    const int32_t joints[OCEL_JOINT_COUNT] = {0};
    int32_t command[OCEL_JOINT_COUNT];
    int64_t time;
    ocel_gaze_t gaze = integrated(&time);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_gaze_update(&gaze, time, none, joints, command));
    TEST_ASSERT_TRUE(command[OCEL_EYES_TILT] < -50000000);
    TEST_ASSERT_TRUE(command[OCEL_EYES_VERSION] < -50000000);
    TEST_ASSERT_TRUE(command[OCEL_EYES_VERGENCE] > 50000000);
    check_forgotten(unseen, 10, false);
    check_forgotten(one, 10, true);
    check_forgotten(large, 40, true);
}

/* A target that moves evenly is followed closer with the integral than without. */
static void the_integral_catches_up(void) {
    double lag[2];
    for (int with = 0; with < 2; with++) {
        ocel_gaze_config_t config = *ROBOTS[0].config;
        config.eye_integral_q16 *= with;
        config.neck_gain_q16 = 0;
        ocel_gaze_t gaze;
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_gaze_init(&gaze, ROBOTS[0].model, &config));
        double q = -25.0 * DEGREE;
        for (int frame = 0; frame < 60; frame++) {
            const double target = (-25.0 + 0.25 * frame) * DEGREE;
            const int32_t right = (int32_t)lround(q - target);
            const ocel_gaze_error_t errors[OCEL_EYE_COUNT] = {{true, right, 0}, {true, right, 0}};
            int32_t joints[OCEL_JOINT_COUNT] = {0};
            int32_t command[OCEL_JOINT_COUNT];
            joints[OCEL_EYES_VERSION] = (int32_t)lround(q);
            TEST_ASSERT_EQUAL(
                OCEL_OK, ocel_gaze_update(&gaze, (int64_t)frame * 20000, errors, joints, command));
            q += command[OCEL_EYES_VERSION] * 0.02;
            lag[with] = fabs((double)right) / DEGREE;
        }
    }
    TEST_ASSERT_TRUE(lag[1] < 0.7 * lag[0]);
}

/* ---- Limits, whatever comes in ---- */

static ocel_gaze_config_t any_config(const robot_t *robot) {
    ocel_gaze_config_t config = *robot->config;
    config.command_us = (uint32_t)rng_log_uniform(&rng, 1000.0, 1000000.0);
    config.eye_gain_q16 = (int32_t)rng_log_uniform(&rng, 1.0, 64.0 * 65536.0);
    config.eye_integral_q16 = (int32_t)rng_log_uniform(&rng, 1.0, 256.0 * 65536.0);
    config.neck_gain_q16 = (int32_t)rng_log_uniform(&rng, 1.0, 64.0 * 65536.0);
    config.max_vergence_q32 = (int32_t)(rng_uniform(&rng, 0.0, 100.0) * DEGREE);
    for (int i = 0; i < OCEL_JOINT_COUNT; i++) {
        config.sign[i] = ((rng_u32(&rng) & 1U) != 0U) ? 1 : -1;
        config.max_speed_q32[i] = (int32_t)rng_log_uniform(&rng, 1000.0, 2147483647.0);
        config.max_acceleration_q24[i] = (int32_t)rng_log_uniform(&rng, 1.0, 536870912.0);
    }
    return config;
}

static int32_t any_angle(void) {
    const uint32_t kind = rng_below(&rng, 4U);
    int32_t angle = (int32_t)rng_u32(&rng);
    if (kind == 0U) {
        angle = INT32_MIN;
    } else if (kind == 1U) {
        angle = (int32_t)(rng_uniform(&rng, -20.0, 20.0) * DEGREE);
    }
    return angle;
}

static int64_t any_interval(uint32_t command_us) {
    static const int64_t HOURS = 3600000000LL;
    const uint32_t kind = rng_below(&rng, 8U);
    int64_t interval = (int64_t)(rng_unit(&rng) * command_us);
    if (kind == 0U) {
        interval = 0;
    } else if (kind == 1U) {
        interval = -(int64_t)rng_below(&rng, 1000000U);
    } else if (kind == 2U) {
        interval = HOURS * 5;
    } else if (kind == 3U) {
        interval = command_us;
    }
    return interval;
}

/* How far a joint is beyond what it may have, in LSB; 0 within. */
static double beyond(const plant_t *plant, int joint) {
    const ocel_head_model_t *const model = plant->robot->model;
    return fmax(0.0, fmax(plant->q[joint] - model->max_q32[joint],
                          model->min_q32[joint] - plant->q[joint]));
}

static double pan_beyond(const plant_t *plant) {
    return fmax(0.0, fabs(plant->q[OCEL_EYES_VERSION]) + fabs(plant->q[OCEL_EYES_VERGENCE]) / 2.0 -
                         plant->robot->model->max_pan_q32);
}

/* The drives obey to the bit, stop by themselves after command_us, and the encoders
 * round.  Then no joint passes a limit (or goes further out, where it starts beyond),
 * and velocities change within their accelerations. */
static void check_truthful(const robot_t *robot) {
    plant_t plant = {robot, {0}};
    const ocel_gaze_config_t config = any_config(robot);
    ocel_gaze_t gaze;
    int32_t last[OCEL_JOINT_COUNT] = {0};
    double out[OCEL_JOINT_COUNT];
    int64_t time = 0;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_gaze_init(&gaze, robot->model, &config));
    for (int i = 0; i < OCEL_JOINT_COUNT; i++) {
        const double spread = (rng_below(&rng, 4U) == 0U) ? 1.3 : 1.0;
        plant.q[i] =
            (rng_below(&rng, 5U) == 0U)
                ? robot->model->max_q32[i]
                : spread * rng_uniform(&rng, robot->model->min_q32[i], robot->model->max_q32[i]);
        out[i] = beyond(&plant, i);
    }
    double pan_out = pan_beyond(&plant);
    ocel_gaze_error_t errors[OCEL_EYE_COUNT];
    for (int frame = 0; frame < 150; frame++) {
        const int64_t interval = any_interval(config.command_us);
        const bool backwards = interval < 0;
        int32_t joints[OCEL_JOINT_COUNT];
        int32_t command[OCEL_JOINT_COUNT];
        const int64_t held =
            backwards ? 0 : ((interval > config.command_us) ? config.command_us : interval);
        move(&plant, last, (double)held * 1e-6);
        if (interval > config.command_us) {
            memset(last, 0, sizeof(last)); /* the drives have stopped */
        }
        time += backwards ? 0 : interval;
        for (int i = 0; i < OCEL_JOINT_COUNT; i++) {
            const double now = beyond(&plant, i);
            TEST_ASSERT_TRUE(now <= fmax(out[i], 1.0) + 0.5);
            out[i] = fmin(out[i], now);
        }
        TEST_ASSERT_TRUE(pan_beyond(&plant) <= fmax(pan_out, 3.0));
        pan_out = fmin(pan_out, pan_beyond(&plant));
        if ((frame % 7 == 0) || (rng_below(&rng, 6U) == 0U)) {
            for (int eye = 0; eye < OCEL_EYE_COUNT; eye++) {
                errors[eye].seen = rng_below(&rng, 5U) != 0U;
                errors[eye].right_q32 = any_angle();
                errors[eye].down_q32 = any_angle();
            }
        }
        encoders(&plant, joints);
        const ocel_status_t status =
            ocel_gaze_update(&gaze, time + (backwards ? interval : 0), errors, joints, command);
        if (backwards && (frame > 0)) {
            TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, status);
        } else {
            TEST_ASSERT_EQUAL((errors[0].seen || errors[1].seen) ? OCEL_OK : OCEL_NOT_SEEN, status);
        }
        for (int i = 0; i < OCEL_JOINT_COUNT; i++) {
            const double change = fabs((double)command[i] - last[i]);
            const double allowed =
                config.max_acceleration_q24[i] * 256.0 * (double)held * 1e-6 * (1.0 + 1e-8);
            TEST_ASSERT_TRUE(fabs((double)command[i]) <= config.max_speed_q32[i]);
            if (out[i] == 0.0) {
                /* The encoders' LSB, at worst in one command's time. */
                TEST_ASSERT_TRUE(change <= allowed + 32.0 + 1e6 / config.command_us);
            }
        }
        memcpy(last, command, sizeof(last));
        if (backwards && (frame == 0)) {
            time += interval;
        }
    }
}

static void limits_hold_whatever_comes_in(void) {
    for (int run = 0; run < TEST_TRIALS(4000); run++) {
        check_truthful(&ROBOTS[run % MODELS]);
    }
}

/* Encoders that tell anything: still no command leads from there beyond a limit while
 * it stands, and none leads further out. */
static void limits_hold_for_lying_encoders(void) {
    for (int run = 0; run < TEST_TRIALS(600); run++) {
        const robot_t *const robot = &ROBOTS[run % MODELS];
        const ocel_gaze_config_t config = any_config(robot);
        const double seconds = config.command_us * 1e-6;
        ocel_gaze_t gaze;
        int64_t time = INT64_MIN;
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_gaze_init(&gaze, robot->model, &config));
        for (int frame = 0; frame < 60; frame++) {
            plant_t plant = {robot, {0}};
            ocel_gaze_error_t errors[OCEL_EYE_COUNT];
            int32_t joints[OCEL_JOINT_COUNT];
            int32_t command[OCEL_JOINT_COUNT];
            double out[OCEL_JOINT_COUNT];
            for (int i = 0; i < OCEL_JOINT_COUNT; i++) {
                joints[i] = any_angle();
                plant.q[i] = joints[i];
                out[i] = beyond(&plant, i);
            }
            const double pan_out = pan_beyond(&plant);
            for (int eye = 0; eye < OCEL_EYE_COUNT; eye++) {
                errors[eye].seen = rng_below(&rng, 5U) != 0U;
                errors[eye].right_q32 = any_angle();
                errors[eye].down_q32 = any_angle();
            }
            (void)ocel_gaze_update(&gaze, time, errors, joints, command);
            move(&plant, command, seconds);
            for (int i = 0; i < OCEL_JOINT_COUNT; i++) {
                TEST_ASSERT_TRUE(fabs((double)command[i]) <= config.max_speed_q32[i]);
                TEST_ASSERT_TRUE(beyond(&plant, i) <= out[i] + 1.0);
            }
            TEST_ASSERT_TRUE(pan_beyond(&plant) <= pan_out + 3.0);
            time += (int64_t)rng_below(&rng, config.command_us);
        }
    }
}

/* ---- Misuse ---- */

static void bad_configurations_are_refused(void) {
    for (int k = 0; k < 21; k++) {
        ocel_gaze_config_t c = ocel_gaze_icub;
        ocel_head_model_t m = ocel_head_icub_v1;
        ocel_gaze_t gaze;
        const int32_t joints[OCEL_JOINT_COUNT] = {0};
        const ocel_gaze_error_t errors[OCEL_EYE_COUNT] = {{true, 5, 5}, {true, 5, 5}};
        int32_t command[OCEL_JOINT_COUNT] = {1, 1, 1, 1, 1, 1};
        ocel_status_t wanted = OCEL_OUT_OF_RANGE;
        switch (k) {
        case 0:
            c.command_us = 999U;
            break;
        case 1:
            c.command_us = 1000001U;
            break;
        case 2:
            c.max_speed_q32[2] = -1;
            break;
        case 3:
            c.max_acceleration_q24[5] = 0;
            break;
        case 4:
            c.max_acceleration_q24[0] = 536870913;
            break;
        case 5:
            c.max_vergence_q32 = -1;
            break;
        case 6:
            c.max_vergence_q32 = 2 * m.max_pan_q32 + 2;
            break;
        case 7:
            c.dead_band_q32 = -1;
            break;
        case 8:
            c.eye_gain_q16 = -1;
            break;
        case 9:
            c.eye_gain_q16 = 64 * 65536 + 1;
            break;
        case 10:
            c.eye_integral_q16 = -1;
            break;
        case 11:
            c.eye_integral_q16 = 256 * 65536 + 1;
            break;
        case 12:
            c.neck_gain_q16 = INT32_MIN;
            break;
        case 13:
            c.neck_gain_q16 = INT32_MAX;
            break;
        case 14:
            m.min_q32[1] = m.max_q32[1] + 1;
            break;
        case 15:
            m.max_pan_q32 = -1;
            break;
        case 16:
            m.max_pan_q32 = INT32_MIN;
            break;
        case 20:
            c.integral_band_q32 = -1;
            break;
        case 17:
            c.sign[4] = 0;
            wanted = OCEL_BAD_OPTION;
            break;
        case 18:
            c.sign[0] = 2;
            wanted = OCEL_BAD_OPTION;
            break;
        default:
            c.sign[5] = -128;
            wanted = OCEL_BAD_OPTION;
            break;
        }
        TEST_ASSERT_EQUAL(wanted, ocel_gaze_init(&gaze, &m, &c));
        TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_gaze_update(&gaze, 0, errors, joints, command));
        for (int i = 0; i < OCEL_JOINT_COUNT; i++) {
            TEST_ASSERT_EQUAL_INT32(0, command[i]);
        }
    }
}

static void null_pointers_are_refused(void) {
    ocel_gaze_t gaze = gaze_of(&ROBOTS[0]);
    const int32_t joints[OCEL_JOINT_COUNT] = {0};
    const ocel_gaze_error_t errors[OCEL_EYE_COUNT] = {{true, 5, 5}, {true, 5, 5}};
    int32_t command[OCEL_JOINT_COUNT] = {1, 1, 1, 1, 1, 1};
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_gaze_init(NULL, &ocel_head_paper, &ocel_gaze_paper));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_gaze_init(&gaze, NULL, &ocel_gaze_paper));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_gaze_init(&gaze, &ocel_head_paper, NULL));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_gaze_update(NULL, 0, errors, joints, command));
    TEST_ASSERT_EQUAL_INT32(0, command[0]);
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_gaze_update(&gaze, 0, NULL, joints, command));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_gaze_update(&gaze, 0, errors, NULL, command));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_gaze_update(&gaze, 0, errors, joints, NULL));
}

int main(void) {
    printf("seed %d\n", SEED);
    UNITY_BEGIN();
    RUN_TEST(errors_are_angles);
    RUN_TEST(tilt_up);
    RUN_TEST(tilt_down);
    RUN_TEST(version_to_the_left);
    RUN_TEST(version_to_the_right);
    RUN_TEST(eyes_come_together);
    RUN_TEST(eyes_part);
    RUN_TEST(neck_pitches_up);
    RUN_TEST(neck_pitches_down);
    RUN_TEST(neck_yaws_left);
    RUN_TEST(neck_yaws_right);
    RUN_TEST(neck_rolls_back);
    RUN_TEST(converges_from_any_visible_target);
    RUN_TEST(converges_a_frame_late);
    RUN_TEST(roll_goes);
    RUN_TEST(one_eye_leads_and_vergence_rests);
    RUN_TEST(unseen_it_comes_to_rest);
    RUN_TEST(the_dead_band_is_still);
    RUN_TEST(nothing_winds_up);
    RUN_TEST(the_integral_is_forgotten);
    RUN_TEST(the_integral_catches_up);
    RUN_TEST(limits_hold_whatever_comes_in);
    RUN_TEST(limits_hold_for_lying_encoders);
    RUN_TEST(bad_configurations_are_refused);
    RUN_TEST(null_pointers_are_refused);
    return UNITY_END();
}
