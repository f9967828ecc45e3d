/* SPDX-License-Identifier: MIT
 *
 * References: head_reference.h, the published chains in double precision, and the
 * iCub's published check poses.
 */
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "board.h"
#include "head_reference.h"
#include "rng.h"
#include "unity.h"

enum { SEED = 20110614, TRIALS = TEST_TRIALS(3000) };

#define ONE_Q30 1073741824.0

/* Axes of the camera, columns of its rotation. */
enum { RIGHT_AXIS, DOWN_AXIS, GAZE };

static rng_t rng;

void setUp(void) {
    rng = rng_seed(SEED);
}

void tearDown(void) {
}

static void joints_of(const double deg[OCEL_JOINT_COUNT], int32_t joints[OCEL_JOINT_COUNT]) {
    for (int j = 0; j < OCEL_JOINT_COUNT; j++) {
        joints[j] = ref_angle_q32(deg[j]);
    }
}

/* An axis of a camera in the head's directions: forward, left, up. */
typedef struct {
    double forward, left, up;
} seen_t;

static seen_t axis_of(int head, const ocel_pose_t *eye, int axis) {
    const int32_t column[3] = {eye->r_q30[0][axis], eye->r_q30[1][axis], eye->r_q30[2][axis]};
    int32_t v[3] = {column[0], column[1], column[2]};
    if (head != REF_PAPER) {
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_head_of_icub(column, v));
    }
    const seen_t seen = {v[0] / ONE_Q30, v[1] / ONE_Q30, v[2] / ONE_Q30};
    return seen;
}

/* Both eyes with one joint at `deg`, the others 0. */
static void turn_one(int head, ocel_joint_t joint, double deg, ocel_pose_t eyes[OCEL_EYE_COUNT]) {
    int32_t joints[OCEL_JOINT_COUNT] = {0};
    joints[joint] = ref_angle_q32(deg);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_head_forward(REF_HEAD_MODELS[head], joints, eyes));
}

static void at_zero_both_eyes_look_ahead(void) {
    for (int head = 0; head < REF_HEADS; head++) {
        ocel_pose_t eyes[OCEL_EYE_COUNT];
        turn_one(head, OCEL_NECK_PITCH, 0.0, eyes);
        for (int eye = 0; eye < OCEL_EYE_COUNT; eye++) {
            TEST_ASSERT_EQUAL_DOUBLE(1.0, axis_of(head, &eyes[eye], GAZE).forward);
            TEST_ASSERT_EQUAL_DOUBLE(-1.0, axis_of(head, &eyes[eye], RIGHT_AXIS).left);
            TEST_ASSERT_EQUAL_DOUBLE(-1.0, axis_of(head, &eyes[eye], DOWN_AXIS).up);
        }
    }
}

/* Positive angles turn the gaze where the model says: one joint alone, by 10 degrees. */
static void check_gaze(int head, ocel_joint_t joint, double left, double up) {
    const double s = sin(10.0 * REF_DEGREE);
    ocel_pose_t eyes[OCEL_EYE_COUNT];
    turn_one(head, joint, 10.0, eyes);
    for (int eye = 0; eye < OCEL_EYE_COUNT; eye++) {
        const seen_t gaze = axis_of(head, &eyes[eye], GAZE);
        TEST_ASSERT_DOUBLE_WITHIN(1e-8, left * s, gaze.left);
        TEST_ASSERT_DOUBLE_WITHIN(1e-8, up * s, gaze.up);
        TEST_ASSERT_DOUBLE_WITHIN(1e-8, cos(10.0 * REF_DEGREE), gaze.forward);
    }
}

static void neck_pitch_is_positive_up(void) {
    for (int head = 0; head < REF_HEADS; head++) {
        check_gaze(head, OCEL_NECK_PITCH, 0.0, 1.0);
    }
}

static void neck_yaw_is_positive_left(void) {
    for (int head = 0; head < REF_HEADS; head++) {
        check_gaze(head, OCEL_NECK_YAW, 1.0, 0.0);
    }
}

static void eyes_tilt_is_positive_up(void) {
    for (int head = 0; head < REF_HEADS; head++) {
        check_gaze(head, OCEL_EYES_TILT, 0.0, 1.0);
    }
}

static void version_is_positive_left_in_the_paper_and_right_in_the_icub(void) {
    check_gaze(REF_PAPER, OCEL_EYES_VERSION, 1.0, 0.0);
    check_gaze(REF_ICUB_V1, OCEL_EYES_VERSION, -1.0, 0.0);
    check_gaze(REF_ICUB_V2, OCEL_EYES_VERSION, -1.0, 0.0);
}

/* Half of it each, inwards. */
static void vergence_turns_the_eyes_inwards(void) {
    const double s = sin(5.0 * REF_DEGREE);
    for (int head = 0; head < REF_HEADS; head++) {
        ocel_pose_t eyes[OCEL_EYE_COUNT];
        turn_one(head, OCEL_EYES_VERGENCE, 10.0, eyes);
        TEST_ASSERT_DOUBLE_WITHIN(1e-8, -s, axis_of(head, &eyes[OCEL_LEFT], GAZE).left);
        TEST_ASSERT_DOUBLE_WITHIN(1e-8, s, axis_of(head, &eyes[OCEL_RIGHT], GAZE).left);
        TEST_ASSERT_DOUBLE_WITHIN(1e-8, 0.0, axis_of(head, &eyes[OCEL_LEFT], GAZE).up);
    }
}

/* The gaze stays, the right ear goes down; the paper's head has no roll. */
static void neck_roll_is_positive_right_ear_down(void) {
    int32_t joints[OCEL_JOINT_COUNT] = {0};
    ocel_pose_t eyes[OCEL_EYE_COUNT];
    for (int head = REF_ICUB_V1; head < REF_HEADS; head++) {
        turn_one(head, OCEL_NECK_ROLL, 10.0, eyes);
        TEST_ASSERT_DOUBLE_WITHIN(1e-8, 1.0, axis_of(head, &eyes[0], GAZE).forward);
        TEST_ASSERT_DOUBLE_WITHIN(1e-8, -sin(10.0 * REF_DEGREE),
                                  axis_of(head, &eyes[0], RIGHT_AXIS).up);
        TEST_ASSERT_TRUE(eyes[OCEL_RIGHT].p_u[2] < eyes[OCEL_LEFT].p_u[2]);
    }
    joints[OCEL_NECK_ROLL] = 1;
    TEST_ASSERT_EQUAL(OCEL_OUT_OF_RANGE, ocel_head_forward(&ocel_head_paper, joints, eyes));
}

static void the_left_eye_is_on_the_left(void) {
    static const int32_t HALF_BASELINE_U[REF_HEADS] = {175000, 34000, 34000};
    for (int head = 0; head < REF_HEADS; head++) {
        ocel_pose_t eyes[OCEL_EYE_COUNT];
        turn_one(head, OCEL_NECK_PITCH, 0.0, eyes);
        const int32_t left = (head == REF_PAPER) ? 1 : -1;
        TEST_ASSERT_EQUAL_INT32(left * HALF_BASELINE_U[head], eyes[OCEL_LEFT].p_u[1]);
        TEST_ASSERT_EQUAL_INT32(-left * HALF_BASELINE_U[head], eyes[OCEL_RIGHT].p_u[1]);
    }
}

/* The iCub's published poses of the left eye, version 1. */
static void icub_v1_is_where_it_is_published(void) {
    static const double DEG[OCEL_JOINT_COUNT] = {10, 0, 20, -5, 3, 0};
    static const double AXIS[3] = {-.95337, -.29107, .07973};
    int32_t joints[OCEL_JOINT_COUNT] = {0};
    ocel_pose_t eyes[OCEL_EYE_COUNT];
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_head_forward(&ocel_head_icub_v1, joints, eyes));
    TEST_ASSERT_EQUAL_INT32(-62810, eyes[OCEL_LEFT].p_u[0]);
    TEST_ASSERT_EQUAL_INT32(-34000, eyes[OCEL_LEFT].p_u[1]);
    TEST_ASSERT_EQUAL_INT32(340800, eyes[OCEL_LEFT].p_u[2]);
    joints_of(DEG, joints);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_head_forward(&ocel_head_icub_v1, joints, eyes));
    TEST_ASSERT_INT32_WITHIN(5, -27260, eyes[OCEL_LEFT].p_u[0]); /* published to 10 u */
    TEST_ASSERT_INT32_WITHIN(5, -50420, eyes[OCEL_LEFT].p_u[1]);
    TEST_ASSERT_INT32_WITHIN(5, 346010, eyes[OCEL_LEFT].p_u[2]);
    for (int i = 0; i < 3; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(5e-6, AXIS[i], eyes[OCEL_LEFT].r_q30[i][GAZE] / ONE_Q30);
    }
}

/* Tables 1 and 2: the eyes' middle .36 SMU ahead of the neck and 3.5 above the floor. */
static void the_papers_middle_is_where_its_tables_say(void) {
    const int32_t joints[OCEL_JOINT_COUNT] = {0};
    ocel_pose_t middle;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_head_middle(&ocel_head_paper, joints, &middle));
    TEST_ASSERT_EQUAL_INT32(360000, middle.p_u[0]);
    TEST_ASSERT_EQUAL_INT32(0, middle.p_u[1]);
    TEST_ASSERT_EQUAL_INT32(3500000, middle.p_u[2]);
}

static void random_joints(int head, double deg[OCEL_JOINT_COUNT],
                          int32_t joints[OCEL_JOINT_COUNT]) {
    const ocel_head_model_t *model = REF_HEAD_MODELS[head];
    for (int j = 0; j < OCEL_JOINT_COUNT; j++) {
        joints[j] = rng_between(&rng, model->min_q32[j], model->max_q32[j]);
    }
    joints[OCEL_EYES_VERGENCE] = rng_between(&rng, 0, ref_angle_q32(30.0));
    joints[OCEL_EYES_VERSION] = rng_between(&rng, ref_angle_q32(-35.0), ref_angle_q32(35.0));
    for (int j = 0; j < OCEL_JOINT_COUNT; j++) {
        deg[j] = joints[j] / REF_TURN_Q32 * 360.0;
    }
}

static void check_pose(const ref_matrix_t *truth, double unit, const ocel_pose_t *pose) {
    for (int i = 0; i < 3; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(0.6, truth->m[i][3] * unit, pose->p_u[i]);
        for (int j = 0; j < 3; j++) {
            TEST_ASSERT_DOUBLE_WITHIN(ldexp(1.0, -26), truth->m[i][j], pose->r_q30[i][j] / ONE_Q30);
        }
    }
}

static void any_pose_is_the_reference_s(void) {
    for (int head = 0; head < REF_HEADS; head++) {
        for (int trial = 0; trial < TRIALS; trial++) {
            double deg[OCEL_JOINT_COUNT];
            int32_t joints[OCEL_JOINT_COUNT];
            ocel_pose_t pose[3];
            random_joints(head, deg, joints);
            TEST_ASSERT_EQUAL(OCEL_OK, ocel_head_forward(REF_HEAD_MODELS[head], joints, pose));
            TEST_ASSERT_EQUAL(OCEL_OK, ocel_head_middle(REF_HEAD_MODELS[head], joints, &pose[2]));
            for (int k = 0; k < 3; k++) {
                static const double SIDES[3] = {-1.0, 1.0, 0.0};
                const ref_matrix_t truth = ref_head_eye(head, deg, SIDES[k]);
                check_pose(&truth, 1e6, &pose[k]);
            }
        }
    }
}

/* Roll, yaw and version the other way round: the other eye, mirrored left to right. */
static void right_and_left_mirror(void) {
    static const int MIRRORED[3] = {OCEL_NECK_ROLL, OCEL_NECK_YAW, OCEL_EYES_VERSION};
    for (int head = 0; head < REF_HEADS; head++) {
        for (int trial = 0; trial < TEST_TRIALS(100); trial++) {
            double deg[OCEL_JOINT_COUNT];
            int32_t joints[OCEL_JOINT_COUNT];
            ocel_pose_t eyes[OCEL_EYE_COUNT];
            ocel_pose_t mirrored[OCEL_EYE_COUNT];
            random_joints(head, deg, joints);
            joints[OCEL_NECK_ROLL] /= 2; /* whose limits are not symmetrical */
            TEST_ASSERT_EQUAL(OCEL_OK, ocel_head_forward(REF_HEAD_MODELS[head], joints, eyes));
            for (int k = 0; k < 3; k++) {
                joints[MIRRORED[k]] = -joints[MIRRORED[k]];
            }
            TEST_ASSERT_EQUAL(OCEL_OK, ocel_head_forward(REF_HEAD_MODELS[head], joints, mirrored));
            for (int eye = 0; eye < OCEL_EYE_COUNT; eye++) {
                const ocel_pose_t *a = &eyes[eye];
                const ocel_pose_t *b = &mirrored[1 - eye];
                for (int i = 0; i < 3; i++) {
                    const int32_t sign = (i == 1) ? -1 : 1; /* the root's y is the side */
                    TEST_ASSERT_INT32_WITHIN(1, a->p_u[i], sign * b->p_u[i]);
                    TEST_ASSERT_INT32_WITHIN(40, a->r_q30[i][GAZE], sign * b->r_q30[i][GAZE]);
                    TEST_ASSERT_INT32_WITHIN(40, a->r_q30[i][DOWN_AXIS],
                                             sign * b->r_q30[i][DOWN_AXIS]);
                    TEST_ASSERT_INT32_WITHIN(40, a->r_q30[i][RIGHT_AXIS],
                                             -sign * b->r_q30[i][RIGHT_AXIS]);
                }
            }
        }
    }
}

/* The target by d0 is the paper's: T05 [0 0 0 1]. */
static void target_is_the_papers(void) {
    for (int trial = 0; trial < TRIALS; trial++) {
        double deg[OCEL_JOINT_COUNT];
        int32_t joints[OCEL_JOINT_COUNT];
        ocel_pose_t middle;
        int32_t p_root[3];
        random_joints(REF_PAPER, deg, joints);
        const int32_t p_middle[3] = {0, 0, rng_between(&rng, 100000, 30000000)};
        const ref_matrix_t t05 = ref_paper_t05(deg, p_middle[2] / 1e6);
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_head_middle(&ocel_head_paper, joints, &middle));
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_head_place(&middle, p_middle, p_root));
        for (int i = 0; i < 3; i++) {
            TEST_ASSERT_DOUBLE_WITHIN(1.1 + (p_middle[2] * 1e-8), t05.m[i][3] * 1e6, p_root[i]);
        }
    }
}

static void check_refused(const ocel_head_model_t *model, const int32_t *joints) {
    static const ocel_pose_t NONE[OCEL_EYE_COUNT];
    ocel_pose_t eyes[OCEL_EYE_COUNT];
    ocel_pose_t middle;
    memset(eyes, 0x55, sizeof(eyes));
    memset(&middle, 0x55, sizeof(middle));
    TEST_ASSERT_EQUAL(OCEL_OUT_OF_RANGE, ocel_head_forward(model, joints, eyes));
    TEST_ASSERT_EQUAL_MEMORY(NONE, eyes, sizeof(eyes));
    TEST_ASSERT_EQUAL(OCEL_OUT_OF_RANGE, ocel_head_middle(model, joints, &middle));
    TEST_ASSERT_EQUAL_MEMORY(NONE, &middle, sizeof(middle));
}

/* Each joint at its limit, rounded either way from degrees, and just beyond. */
static void joints_have_limits(void) {
    static const double LOW[OCEL_JOINT_COUNT] = {-40, -70, -55, -35, -50, 0};
    static const double HIGH[OCEL_JOINT_COUNT] = {30, 60, 55, 15, 50, 100};
    for (int head = 0; head < REF_HEADS; head++) {
        for (int j = 0; j < OCEL_JOINT_COUNT; j++) {
            const bool none = (head == REF_PAPER) && (j == OCEL_NECK_ROLL);
            const double ends[2] = {none ? 0.0 : LOW[j], none ? 0.0 : HIGH[j]};
            for (int end = 0; end < 2; end++) {
                const int32_t outwards = (end == 0) ? -1 : 1;
                int32_t joints[OCEL_JOINT_COUNT] = {0};
                ocel_pose_t eyes[OCEL_EYE_COUNT];
                joints[j] = ref_angle_q32(ends[end]);
                TEST_ASSERT_EQUAL(OCEL_OK, ocel_head_forward(REF_HEAD_MODELS[head], joints, eyes));
                joints[j] += outwards * ((ends[end] == 0.0) ? 1 : 100);
                check_refused(REF_HEAD_MODELS[head], joints);
                joints[j] = (end == 0) ? INT32_MIN : INT32_MAX;
                check_refused(REF_HEAD_MODELS[head], joints);
            }
        }
    }
}

/* Version and vergence within theirs, but one eye turned too far. */
static void eyes_have_a_limit_together(void) {
    for (int head = 0; head < REF_HEADS; head++) {
        for (int sign = -1; sign <= 1; sign += 2) {
            int32_t joints[OCEL_JOINT_COUNT] = {0};
            ocel_pose_t eyes[OCEL_EYE_COUNT];
            joints[OCEL_EYES_VERSION] = sign * ref_angle_q32(40.0);
            joints[OCEL_EYES_VERGENCE] = ref_angle_q32(20.0);
            TEST_ASSERT_EQUAL(OCEL_OK, ocel_head_forward(REF_HEAD_MODELS[head], joints, eyes));
            joints[OCEL_EYES_VERGENCE] = ref_angle_q32(20.001);
            check_refused(REF_HEAD_MODELS[head], joints);
        }
    }
}

static void mistakes_have_a_status(void) {
    static const ocel_pose_t NONE[OCEL_EYE_COUNT];
    const int32_t joints[OCEL_JOINT_COUNT] = {0};
    const int32_t p[3] = {1, 2, 3};
    int32_t q[3] = {1, 1, 1};
    ocel_pose_t eyes[OCEL_EYE_COUNT];
    ocel_head_model_t model = ocel_head_icub_v1;
    memset(eyes, 0x55, sizeof(eyes));
    model.link_count = OCEL_MAX_HEAD_LINKS + 1U;
    TEST_ASSERT_EQUAL(OCEL_BAD_OPTION, ocel_head_forward(&model, joints, eyes));
    TEST_ASSERT_EQUAL_MEMORY(NONE, eyes, sizeof(eyes));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_head_forward(NULL, joints, eyes));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_head_forward(&model, NULL, eyes));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_head_forward(&model, joints, NULL));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_head_middle(NULL, joints, eyes));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_head_middle(&model, NULL, eyes));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_head_middle(&model, joints, NULL));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_head_place(NULL, p, q));
    TEST_ASSERT_EQUAL_INT32(0, q[0] | q[1] | q[2]);
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_head_place(eyes, NULL, q));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_head_place(eyes, p, NULL));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_head_of_icub(NULL, q));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_head_of_icub(p, NULL));
}

/* A link of no joint, or of one that there is not, stays where it is. */
static void links_without_a_joint_stay(void) {
    int32_t joints[OCEL_JOINT_COUNT] = {0};
    ocel_pose_t still[OCEL_EYE_COUNT];
    ocel_pose_t moved[OCEL_EYE_COUNT];
    ocel_head_model_t model = ocel_head_icub_v1;
    model.links[3].joint = 255U;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_head_forward(&model, joints, still));
    joints[OCEL_NECK_PITCH] = ref_angle_q32(20.0);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_head_forward(&model, joints, moved));
    TEST_ASSERT_EQUAL_MEMORY(still, moved, sizeof(still));
}

/* The base's pose is the whole head's: another root moves and turns all of it. */
static void the_base_carries_the_head(void) {
    const int32_t joints[OCEL_JOINT_COUNT] = {0};
    ocel_pose_t eyes[OCEL_EYE_COUNT];
    ocel_head_model_t model = ocel_head_paper;
    memset(&model.X_root_base, 0, sizeof(model.X_root_base));
    model.X_root_base.r_q30[0][1] = -(1 << 30); /* a quarter turn left */
    model.X_root_base.r_q30[1][0] = 1 << 30;
    model.X_root_base.r_q30[2][2] = 1 << 30;
    model.X_root_base.p_u[0] = 1000;
    model.X_root_base.p_u[1] = -2000;
    model.X_root_base.p_u[2] = 30;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_head_forward(&model, joints, eyes));
    TEST_ASSERT_EQUAL_INT32(1000 - 175000, eyes[OCEL_LEFT].p_u[0]);
    TEST_ASSERT_EQUAL_INT32(360000 - 2000, eyes[OCEL_LEFT].p_u[1]);
    TEST_ASSERT_EQUAL_INT32(3500030, eyes[OCEL_LEFT].p_u[2]);
    TEST_ASSERT_EQUAL_INT32(1 << 30, eyes[OCEL_LEFT].r_q30[1][GAZE]);
}

static void places_too_far_are_refused(void) {
    const int32_t joints[OCEL_JOINT_COUNT] = {0};
    const int32_t far[3] = {0, 0, 1 << 30};
    const int32_t farther[3] = {INT32_MAX, INT32_MIN, INT32_MAX};
    int32_t p[3] = {1, 1, 1};
    ocel_pose_t middle;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_head_middle(&ocel_head_paper, joints, &middle));
    TEST_ASSERT_EQUAL(OCEL_OUT_OF_RANGE, ocel_head_place(&middle, far, p)); /* .36 SMU too far */
    TEST_ASSERT_EQUAL_INT32(0, p[0] | p[1] | p[2]);
    TEST_ASSERT_EQUAL(OCEL_OUT_OF_RANGE, ocel_head_place(&middle, farther, p));
}

static void icub_axes_become_the_head_s(void) {
    const int32_t v[3] = {-3, 5, 7}; /* 3 forward, 5 right, 7 up */
    const int32_t least[3] = {INT32_MIN, 1, 1};
    int32_t head[3] = {1, 1, 1};
    int32_t back[3] = {1, 1, 1};
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_head_of_icub(v, head));
    TEST_ASSERT_EQUAL_INT32(3, head[0]);
    TEST_ASSERT_EQUAL_INT32(-5, head[1]);
    TEST_ASSERT_EQUAL_INT32(7, head[2]);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_head_of_icub(head, back));
    TEST_ASSERT_EQUAL_INT32_ARRAY(v, back, 3);
    TEST_ASSERT_EQUAL(OCEL_OUT_OF_RANGE, ocel_head_of_icub(least, head));
    TEST_ASSERT_EQUAL_INT32(0, head[0] | head[1] | head[2]);
}

int main(void) {
    printf("seed %d\n", SEED);
    UNITY_BEGIN();
    RUN_TEST(at_zero_both_eyes_look_ahead);
    RUN_TEST(neck_pitch_is_positive_up);
    RUN_TEST(neck_yaw_is_positive_left);
    RUN_TEST(eyes_tilt_is_positive_up);
    RUN_TEST(version_is_positive_left_in_the_paper_and_right_in_the_icub);
    RUN_TEST(vergence_turns_the_eyes_inwards);
    RUN_TEST(neck_roll_is_positive_right_ear_down);
    RUN_TEST(the_left_eye_is_on_the_left);
    RUN_TEST(icub_v1_is_where_it_is_published);
    RUN_TEST(the_papers_middle_is_where_its_tables_say);
    RUN_TEST(any_pose_is_the_reference_s);
    RUN_TEST(right_and_left_mirror);
    RUN_TEST(target_is_the_papers);
    RUN_TEST(joints_have_limits);
    RUN_TEST(eyes_have_a_limit_together);
    RUN_TEST(mistakes_have_a_status);
    RUN_TEST(links_without_a_joint_stay);
    RUN_TEST(the_base_carries_the_head);
    RUN_TEST(places_too_far_are_refused);
    RUN_TEST(icub_axes_become_the_head_s);
    return UNITY_END();
}
