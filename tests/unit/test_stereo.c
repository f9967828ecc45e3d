/* SPDX-License-Identifier: MIT
 *
 * References: lines intersected in double precision, a Monte-Carlo of the cones'
 * errors, and a Kalman step in double.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <ocellus/stereo.h>

#include "board.h"
#include "head_reference.h"
#include "rng.h"
#include "rotations.h"
#include "unity.h"

enum { SEED = 20110615 };

#define ONE_Q30 1073741824.0
#define ONE_Q60 1152921504606846976.0
#define BASELINE_U 68000.0

static rng_t rng;

void setUp(void) {
    rng = rng_seed(SEED);
}

void tearDown(void) {
}

/* ---- doubles ---- */

static double dot(const double a[3], const double b[3]) {
    return (a[0] * b[0]) + (a[1] * b[1]) + (a[2] * b[2]);
}

static double unit(double v[3]) {
    const double length = sqrt(dot(v, v));
    for (int i = 0; i < 3; i++) {
        v[i] /= length;
    }
    return length;
}

static double distance(const double a[3], const int32_t b[3]) {
    const double d[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    return sqrt(dot(d, d));
}

typedef struct {
    double p[3];
    double d[3];
} line_t;

static line_t line_of(const ocel_ray_t *ray) {
    line_t line;
    for (int i = 0; i < 3; i++) {
        line.p[i] = ray->p_u[i];
        line.d[i] = ray->d_q30[i] / ONE_Q30;
    }
    return line;
}

static ocel_ray_t ray_of(const line_t *line) {
    ocel_ray_t ray;
    for (int i = 0; i < 3; i++) {
        ray.p_u[i] = (int32_t)lround(line->p[i]);
        ray.d_q30[i] = rotation_q30(line->d[i]);
    }
    return ray;
}

/* The point half-way at the closest approach, by the 2x2 normal equations; t along each. */
static double meet(const line_t *a, const line_t *b, double p[3], double t[2]) {
    const double w[3] = {b->p[0] - a->p[0], b->p[1] - a->p[1], b->p[2] - a->p[2]};
    const double aa = dot(a->d, a->d);
    const double bb = dot(b->d, b->d);
    const double ab = dot(a->d, b->d);
    const double det = (aa * bb) - (ab * ab);
    double gap = 0.0;
    t[0] = ((dot(w, a->d) * bb) - (dot(w, b->d) * ab)) / det;
    t[1] = ((dot(w, a->d) * ab) - (dot(w, b->d) * aa)) / det;
    for (int i = 0; i < 3; i++) {
        const double pa = a->p[i] + (t[0] * a->d[i]);
        const double pb = b->p[i] + (t[1] * b->d[i]);
        p[i] = (pa + pb) / 2.0;
        gap += (pb - pa) * (pb - pa);
    }
    return sqrt(gap);
}

/* Two eyes somewhere, 68 mm apart and turned anyhow, and a ball before them. */
typedef struct {
    double ball[3];
    line_t lines[2]; /* towards it */
    ocel_pose_t eyes[2];
    double r[2][3][3];
    double range[2];
} scene_t;

static scene_t any_scene(double least, double most) {
    scene_t scene;
    double ahead[3];
    double side[3];
    double across[3];
    rotation_direction(&rng, ahead);
    do {
        rotation_direction(&rng, across);
        rotation_cross(ahead, across, side);
    } while (dot(side, side) < 0.01);
    (void)unit(side);
    const double range = rng_log_uniform(&rng, least, most);
    const double off = rng_uniform(&rng, -0.3, 0.3) * range;
    for (int i = 0; i < 3; i++) {
        const double middle = rng_uniform(&rng, -1e6, 1e6);
        scene.ball[i] = middle + (range * ahead[i]) + (off * side[i]);
        for (int k = 0; k < 2; k++) {
            const double to_side = (k == 0) ? -0.5 : 0.5;
            scene.lines[k].p[i] = round(middle + (to_side * BASELINE_U * side[i]));
        }
    }
    for (int k = 0; k < 2; k++) {
        double forward[3];
        for (int i = 0; i < 3; i++) {
            scene.lines[k].d[i] = scene.ball[i] - scene.lines[k].p[i];
        }
        scene.range[k] = unit(scene.lines[k].d);
        for (int i = 0; i < 3; i++) { /* the eye looks past the ball by up to 17 degrees */
            forward[i] = scene.lines[k].d[i] + rng_uniform(&rng, -0.17, 0.17);
        }
        (void)unit(forward);
        rotation_about(&rng, forward, scene.r[k]);
        scene.eyes[k] = rotation_pose(scene.r[k]);
        for (int i = 0; i < 3; i++) {
            scene.eyes[k].p_u[i] = (int32_t)scene.lines[k].p[i];
        }
    }
    return scene;
}

/* ---- midpoint ---- */

static void midpoint_of_meeting_rays(void) {
    double worst = 0.0;
    for (int trial = 0; trial < TEST_TRIALS(100000); trial++) {
        const scene_t scene = any_scene(1e5, 5e6);
        const ocel_ray_t left = ray_of(&scene.lines[0]);
        const ocel_ray_t right = ray_of(&scene.lines[1]);
        const double lever = scene.range[0] * scene.range[0] / BASELINE_U;
        ocel_midpoint_t m;
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_stereo_midpoint(&left, &right, &m));
        TEST_ASSERT_TRUE(m.gap_u <= 1U);
        TEST_ASSERT_DOUBLE_WITHIN(0.6 + ldexp(lever, -28), scene.range[0], m.range_u[0]);
        TEST_ASSERT_DOUBLE_WITHIN(0.6 + ldexp(lever, -28), scene.range[1], m.range_u[1]);
        TEST_ASSERT_TRUE(distance(scene.ball, m.p_u) < 0.87 + ldexp(lever, -28));
        if (scene.range[0] < 1.05e6) {
            worst = fmax(worst, distance(scene.ball, m.p_u) / fmax(scene.range[0], 1e6));
        }
    }
    printf("midpoint: worst at up to 1 m %.2e of 1 m\n", worst);
    TEST_ASSERT_TRUE(worst < 1e-6);
}

/* Rays that miss each other, at any angle: the same rays in double. */
static void midpoint_of_skew_rays(void) {
    int checked = 0;
    for (int trial = 0; trial < TEST_TRIALS(100000); trial++) {
        line_t a;
        line_t b;
        double p[3];
        double t[2];
        rotation_direction(&rng, a.d);
        rotation_direction(&rng, b.d);
        for (int i = 0; i < 3; i++) {
            a.p[i] = rng_uniform(&rng, -1e6, 1e6);
            b.p[i] = rng_uniform(&rng, -1e6, 1e6);
        }
        const ocel_ray_t left = ray_of(&a);
        const ocel_ray_t right = ray_of(&b);
        a = line_of(&left);
        b = line_of(&right);
        const double gap = meet(&a, &b, p, t);
        ocel_midpoint_t m;
        const ocel_status_t status = ocel_stereo_midpoint(&left, &right, &m);
        if ((t[0] > 2.0) && (t[1] > 2.0)) {
            TEST_ASSERT_EQUAL(OCEL_OK, status);
            TEST_ASSERT_DOUBLE_WITHIN(0.6, gap, m.gap_u);
            TEST_ASSERT_TRUE(distance(p, m.p_u) < 0.9);
            checked++;
        } else if ((t[0] < 0.0) || (t[1] < 0.0)) { /* and perhaps too far too */
            TEST_ASSERT_EQUAL((fmax(t[0], t[1]) < 2e8) ? OCEL_DEGENERATE : status, status);
            TEST_ASSERT_TRUE(status != OCEL_OK);
        } else {
            /* within 2 u of an eye */
        }
    }
    TEST_ASSERT_TRUE(checked > TEST_TRIALS(100000) / 5);
}

static ocel_ray_t ray(int32_t x, int32_t y, int32_t z, double dx, double dy, double dz) {
    line_t line = {{x, y, z}, {dx, dy, dz}};
    (void)unit(line.d);
    return ray_of(&line);
}

static void check_midpoint(ocel_status_t expected, ocel_ray_t left, ocel_ray_t right) {
    static const ocel_midpoint_t NONE;
    ocel_midpoint_t m;
    for (int swap = 0; swap < 2; swap++) {
        memset(&m, 0x55, sizeof(m));
        TEST_ASSERT_EQUAL(expected, ocel_stereo_midpoint((swap == 0) ? &left : &right,
                                                         (swap == 0) ? &right : &left, &m));
        if (expected != OCEL_OK) {
            TEST_ASSERT_EQUAL_MEMORY(&NONE, &m, sizeof(m));
        }
    }
}

static void midpoint_of_simple_rays_is_exact(void) {
    const ocel_ray_t left = ray(0, 0, 0, 1, 0, 0);
    const ocel_ray_t right = ray(1000, -500, 40, 0, 1, 0);
    ocel_midpoint_t m;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_stereo_midpoint(&left, &right, &m));
    TEST_ASSERT_EQUAL_INT32(1000, m.p_u[0]);
    TEST_ASSERT_EQUAL_INT32(0, m.p_u[1]);
    TEST_ASSERT_EQUAL_INT32(20, m.p_u[2]);
    TEST_ASSERT_EQUAL_UINT32(40U, m.gap_u);
    TEST_ASSERT_EQUAL_UINT32(1000U, m.range_u[0]);
    TEST_ASSERT_EQUAL_UINT32(500U, m.range_u[1]);
}

static void rays_without_a_midpoint(void) {
    const ocel_ray_t ahead = ray(-34000, 0, 0, 0, 0, 1);
    check_midpoint(OCEL_DEGENERATE, ahead, ray(34000, 0, 0, 0, 0, 1));       /* parallel */
    check_midpoint(OCEL_DEGENERATE, ahead, ray(34000, 0, 0, 0, 0, -1));      /* head-on */
    check_midpoint(OCEL_DEGENERATE, ahead, ahead);                           /* one ray twice */
    check_midpoint(OCEL_DEGENERATE, ahead, ray(34000, 0, 0, -0.0002, 0, 1)); /* nearly parallel */
    check_midpoint(OCEL_OK, ahead, ray(34000, 0, 0, -0.0003, 0, 1));
    check_midpoint(OCEL_DEGENERATE, ahead, ray(34000, 0, 0, 0.1, 0, 1)); /* diverge: behind both */
    check_midpoint(OCEL_DEGENERATE, ray(0, 0, 0, 0, 0, 1), ray(1000, 0, -1000, -1, 0, 0));
    check_midpoint(OCEL_DEGENERATE, ahead, ray(-34000, 0, 0, 1, 0, 1)); /* in the eye */
}

static void rays_that_are_none(void) {
    const ocel_ray_t good = ray(0, 0, 0, 0, 0, 1);
    const ocel_ray_t middle = ray(OCEL_MAX_STEREO_U / 2, 0, 0, 0, 0, 1);
    ocel_ray_t bad = good;
    ocel_midpoint_t m;
    memset(bad.d_q30, 0, sizeof(bad.d_q30));
    check_midpoint(OCEL_OUT_OF_RANGE, good, bad);
    bad.d_q30[0] = INT32_MIN;
    check_midpoint(OCEL_OUT_OF_RANGE, good, bad);
    bad.d_q30[1] = INT32_MIN;
    bad.d_q30[2] = INT32_MIN;
    check_midpoint(OCEL_OUT_OF_RANGE, good, bad);
    bad = ray(1000, 0, 0, -0.1, 0, 1);
    check_midpoint(OCEL_OK, good, bad);
    bad.d_q30[2] += 1 << 15; /* 2^-15 too long */
    check_midpoint(OCEL_OUT_OF_RANGE, good, bad);
    check_midpoint(OCEL_OK, middle, ray(OCEL_MAX_STEREO_U, 0, 0, -1, 0, 1));
    check_midpoint(OCEL_OUT_OF_RANGE, middle, ray(OCEL_MAX_STEREO_U + 1, 0, 0, -1, 0, 1));
    check_midpoint(OCEL_OUT_OF_RANGE, ray(-OCEL_MAX_STEREO_U / 2, 0, 0, 0, 0, 1),
                   ray(-OCEL_MAX_STEREO_U - 1, 0, 0, 1, 0, 1));
    check_midpoint(OCEL_OUT_OF_RANGE, good, ray(INT32_MIN, 0, 0, 2, 0, 1));
    /* 268 m away, and a little less */
    check_midpoint(OCEL_OUT_OF_RANGE, good, ray(270000, 0, 0, -0.001, 0, 1));
    check_midpoint(OCEL_OK, good, ray(268000, 0, 0, -0.001, 0, 1));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_stereo_midpoint(NULL, &good, &m));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_stereo_midpoint(&good, NULL, &m));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_stereo_midpoint(&good, &bad, NULL));
}

/* A gap of metres is told. */
static void midpoint_tells_the_gap(void) {
    const ocel_ray_t left = ray(0, 0, -3000000, 0.1, 0, 1);
    const ocel_ray_t right = ray(0, 5000000, -3000000, -0.1, 0, 1);
    const ocel_ray_t crossing = ray(100000, 5000000, -3000000, -0.1, 0, 1);
    ocel_midpoint_t m;
    TEST_ASSERT_EQUAL(OCEL_DEGENERATE, ocel_stereo_midpoint(&left, &right, &m)); /* in the eyes */
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_stereo_midpoint(&left, &crossing, &m));
    TEST_ASSERT_EQUAL_UINT32(5000000U, m.gap_u);
    TEST_ASSERT_INT32_WITHIN(1, 2500000, m.p_u[1]);
}

/* ---- encoders ---- */

static const int32_t NO_RESIDUAL[2] = {0, 0};

/* Vergence that fixates a point at `range` in the direction of the version. */
static double true_range(double version_deg, double vergence_deg) {
    const double gl = (version_deg - (vergence_deg / 2.0)) * REF_DEGREE;
    const double gr = (version_deg + (vergence_deg / 2.0)) * REF_DEGREE;
    const double x = BASELINE_U / (tan(gr) - tan(gl));
    const double y = (BASELINE_U / 2.0) + (x * tan(gl));
    return sqrt((x * x) + (y * y));
}

/* The paper's bias: +1.5 % at 10 degrees of version, 6.4 at 20, 15 at 30; the cosine
 * takes it out to 1e-4 (of targets at .5 m and beyond), and the exact form is exact. */
static void encoders_bias_is_the_papers(void) {
    static const double VERSIONS[4] = {0, 10, 20, 30};
    static const double BIASES[4] = {0, .0154, .0642, .1547};
    for (int v = 0; v < 4; v++) {
        for (int side = -1; side <= 1; side += 2) {
            const int32_t version = ref_angle_q32(side * VERSIONS[v]);
            const int32_t vergence = ref_angle_q32(4.0); /* about 1 m */
            const double range = true_range(side * VERSIONS[v], 4.0);
            double answers[3];
            for (int k = 0; k < 3; k++) {
                int32_t p[3];
                TEST_ASSERT_EQUAL(OCEL_OK,
                                  ocel_stereo_encoders((ocel_encoders_t)k, (int32_t)BASELINE_U,
                                                       version, vergence, NO_RESIDUAL, p));
                TEST_ASSERT_EQUAL_INT32(0, p[1]);
                answers[k] = hypot(p[0], p[2]) / range - 1.0;
            }
            TEST_ASSERT_DOUBLE_WITHIN(4e-4, BIASES[v], answers[OCEL_ENCODERS_PAPER]);
            TEST_ASSERT_DOUBLE_WITHIN(2e-4, 0.0, answers[OCEL_ENCODERS_COSINE]);
            TEST_ASSERT_DOUBLE_WITHIN(1e-6, 0.0, answers[OCEL_ENCODERS_EXACT]);
            printf("version %+3.0f: paper %+.4f %%, cosine %+.4f %%, exact %+.5f %%\n",
                   side * VERSIONS[v], 100 * answers[0], 100 * answers[1], 100 * answers[2]);
        }
    }
}

/* The exact form is where the head's two gazes meet, for every head: encoders, the
 * middle's pose and forward kinematics agree, signs and all. */
static void encoders_agree_with_the_head(void) {
    for (int head = 0; head < REF_HEADS; head++) {
        const int32_t baseline = (head == REF_PAPER) ? 350000 : 68000;
        for (int trial = 0; trial < TEST_TRIALS(2000); trial++) {
            const ocel_head_model_t *model = REF_HEAD_MODELS[head];
            int32_t joints[OCEL_JOINT_COUNT];
            ocel_pose_t eyes[OCEL_EYE_COUNT];
            ocel_pose_t middle;
            ocel_ray_t gazes[2];
            ocel_midpoint_t m;
            int32_t p_middle[3];
            int32_t p_root[3];
            for (int j = 0; j < OCEL_JOINT_COUNT; j++) {
                joints[j] = rng_between(&rng, model->min_q32[j], model->max_q32[j]);
            }
            joints[OCEL_EYES_VERSION] = ref_angle_q32(rng_uniform(&rng, -35, 35));
            joints[OCEL_EYES_VERGENCE] = ref_angle_q32(rng_uniform(&rng, 2, 25)) & ~1;
            TEST_ASSERT_EQUAL(OCEL_OK, ocel_head_forward(model, joints, eyes));
            TEST_ASSERT_EQUAL(OCEL_OK, ocel_head_middle(model, joints, &middle));
            for (int k = 0; k < 2; k++) {
                for (int i = 0; i < 3; i++) {
                    gazes[k].p_u[i] = eyes[k].p_u[i];
                    gazes[k].d_q30[i] = eyes[k].r_q30[i][2];
                }
            }
            TEST_ASSERT_EQUAL(OCEL_OK, ocel_stereo_midpoint(&gazes[0], &gazes[1], &m));
            const int32_t left =
                (head == REF_PAPER) ? joints[OCEL_EYES_VERSION] : -joints[OCEL_EYES_VERSION];
            TEST_ASSERT_EQUAL(OCEL_OK, ocel_stereo_encoders(OCEL_ENCODERS_EXACT, baseline, left,
                                                            joints[OCEL_EYES_VERGENCE], NO_RESIDUAL,
                                                            p_middle));
            TEST_ASSERT_EQUAL(OCEL_OK, ocel_head_place(&middle, p_middle, p_root));
            /* The eyes' positions, half a u off each, move the meeting point by range / baseline.
             */
            const double slack = 3.0 + (2.0 * m.range_u[0] / (double)baseline);
            for (int i = 0; i < 3; i++) {
                TEST_ASSERT_DOUBLE_WITHIN(slack, m.p_u[i], p_root[i]);
            }
        }
    }
}

/* Residuals: the target is seen to the right of both axes, so it is right of the
 * version's direction; and any target's two angles give it back. */
static void encoders_take_what_the_image_still_shows(void) {
    const int32_t rightwards[2] = {ref_angle_q32(5.0), ref_angle_q32(5.0)};
    int32_t p[3];
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_stereo_encoders(OCEL_ENCODERS_EXACT, 68000, 0,
                                                    ref_angle_q32(4.0), rightwards, p));
    TEST_ASSERT_DOUBLE_WITHIN(1e-3, tan(5.0 * REF_DEGREE), (double)p[0] / p[2]);
    for (int trial = 0; trial < TEST_TRIALS(20000); trial++) {
        const double z =
            rng_log_uniform(&rng, 1e5, 3e6); /* seen from the middle, right and ahead */
        const double x = z * rng_uniform(&rng, -0.3, 0.3);
        const double version = rng_uniform(&rng, -0.6, 0.6); /* rad, left */
        const double vergence = rng_uniform(&rng, 0.0, 0.4);
        /* The same point in the eyes' plane, x ahead, y left. */
        const double ahead = (z * cos(version)) + (x * sin(version));
        const double left = (z * sin(version)) - (x * cos(version));
        const double seen[2] = {atan2(left - (BASELINE_U / 2), ahead),
                                atan2(left + (BASELINE_U / 2), ahead)};
        const double gaze[2] = {version - (vergence / 2), version + (vergence / 2)};
        int32_t residual[2];
        for (int k = 0; k < 2; k++) {
            residual[k] = ref_angle_q32((gaze[k] - seen[k]) / REF_DEGREE);
        }
        TEST_ASSERT_EQUAL(OCEL_OK,
                          ocel_stereo_encoders(OCEL_ENCODERS_EXACT, (int32_t)BASELINE_U,
                                               ref_angle_q32(version / REF_DEGREE),
                                               ref_angle_q32(vergence / REF_DEGREE), residual, p));
        const double slack = 1.0 + (z * z / BASELINE_U * 1e-8);
        TEST_ASSERT_DOUBLE_WITHIN(slack, x, p[0]);
        TEST_ASSERT_DOUBLE_WITHIN(slack, z, p[2]);
    }
}

static void check_encoders(ocel_status_t expected, int variant, int32_t baseline, double version,
                           double vergence, double residual) {
    const int32_t residuals[2] = {ref_angle_q32(residual), ref_angle_q32(residual)};
    int32_t p[3] = {1, 1, 1};
    TEST_ASSERT_EQUAL(expected, ocel_stereo_encoders((ocel_encoders_t)variant, baseline,
                                                     ref_angle_q32(version),
                                                     ref_angle_q32(vergence), residuals, p));
    if (expected != OCEL_OK) {
        TEST_ASSERT_EQUAL_INT32(0, p[0] | p[1] | p[2]);
    }
}

static void encoders_without_an_answer(void) {
    const int32_t residual[2] = {INT32_MIN, INT32_MAX};
    const int32_t one[2][2] = {{1 << 30, 0}, {0, 1 << 30}};
    int32_t p[3] = {1, 1, 1};
    for (int k = 0; k < 3; k++) {
        for (int eye = 0; eye < 2; eye++) {
            TEST_ASSERT_EQUAL(OCEL_OUT_OF_RANGE,
                              ocel_stereo_encoders((ocel_encoders_t)k, 68000, 0,
                                                   ref_angle_q32(80.0), one[eye], p));
        }
        check_encoders(OCEL_OK, k, 68000, 10, 4, 1);
        check_encoders(OCEL_DEGENERATE, k, 68000, 10, 0, 0);
        check_encoders(OCEL_DEGENERATE, k, 68000, 10, -4, 0);
        check_encoders(OCEL_DEGENERATE, k, 68000, 10, .01, 0);
        check_encoders(OCEL_OUT_OF_RANGE, k, 0, 10, 4, 0);
        check_encoders(OCEL_OUT_OF_RANGE, k, -1, 10, 4, 0);
        check_encoders(OCEL_OK, k, OCEL_MAX_STEREO_U, 10, 80, 0);
        check_encoders(OCEL_OUT_OF_RANGE, k, OCEL_MAX_STEREO_U + 1, 10, 80, 0);
        check_encoders(OCEL_OUT_OF_RANGE, k, OCEL_MAX_STEREO_U, 10, 4, 0); /* 2^31.8 u away */
        check_encoders(OCEL_OUT_OF_RANGE, k, 68000, 91, 4, 0);
        check_encoders(OCEL_OUT_OF_RANGE, k, 68000, 10, 91, 0);
        check_encoders(OCEL_OUT_OF_RANGE, k, 68000, 10, 4, -91);
        TEST_ASSERT_EQUAL(
            OCEL_OUT_OF_RANGE,
            ocel_stereo_encoders((ocel_encoders_t)k, 68000, INT32_MIN, INT32_MIN, residual, p));
        TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT,
                          ocel_stereo_encoders((ocel_encoders_t)k, 68000, 0, 0, NULL, p));
        TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT,
                          ocel_stereo_encoders((ocel_encoders_t)k, 68000, 0, 0, residual, NULL));
    }
    check_encoders(OCEL_DEGENERATE, OCEL_ENCODERS_EXACT, 68000, 80, 4, -80); /* behind */
    check_encoders(OCEL_BAD_OPTION, 3, 68000, 10, 4, 0);
    check_encoders(OCEL_BAD_OPTION, -1, 68000, 10, 4, 0);
}

/* ---- the ball ---- */

/* How exactly a cone is known: its axis, across, and the sine, relatively. */
typedef struct {
    double axis;
    double sine;
} sigma_t;

static const sigma_t USUAL = {2e-4, 1e-3}; /* .05 px and .02 px at f = 257, R = 18 px */

/* The cone that an eye sees, with errors of `noise` sigmas. */
static ocel_cone_t cone_of(const scene_t *scene, int eye, double radius, sigma_t sigma,
                           double noise) {
    ocel_cone_t cone;
    double n[3];
    double axis[3];
    memset(&cone, 0, sizeof(cone));
    for (int i = 0; i < 3; i++) { /* into the camera's frame */
        axis[i] = 0.0;
        for (int k = 0; k < 3; k++) {
            axis[i] += scene->r[eye][k][i] * scene->lines[eye].d[k];
        }
        n[i] = axis[i] + (noise * sigma.axis * rng_gauss(&rng));
    }
    (void)unit(n);
    for (int i = 0; i < 3; i++) {
        cone.axis_cam_q30[i] = rotation_q30(n[i]);
        for (int j = i; j < 3; j++) {
            const double across = ((i == j) ? 1.0 : 0.0) - (n[i] * n[j]);
            const int at = (i == 0) ? j : (i + j + 1);
            cone.cov_q60[at] = llround(ONE_Q60 * ((sigma.axis * sigma.axis * across) +
                                                  (sigma.sine * sigma.sine * n[i] * n[j])));
        }
    }
    cone.sin_q30 = (uint32_t)rotation_q30(radius / scene->range[eye] *
                                          (1.0 + (noise * sigma.sine * rng_gauss(&rng))));
    return cone;
}

static double element(const int64_t *cov, int i, int j) {
    const int low = (i < j) ? i : j;
    const int high = (i < j) ? j : i;
    return (double)cov[(low == 0) ? high : (low + high + 1)];
}

static double quadratic(const int64_t *cov, const double a[3], const double b[3]) {
    double sum = 0.0;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            sum += a[i] * element(cov, i, j) * b[j];
        }
    }
    return sum;
}

/* e^T C^-1 e, by elimination. */
static double mahalanobis(const int64_t *cov, const double e[3]) {
    double m[3][4];
    double sum = 0.0;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            m[i][j] = element(cov, i, j);
        }
        m[i][3] = e[i];
    }
    for (int k = 0; k < 3; k++) {
        for (int i = k + 1; i < 3; i++) {
            const double f = m[i][k] / m[k][k];
            for (int j = k; j < 4; j++) {
                m[i][j] -= f * m[k][j];
            }
        }
    }
    for (int k = 0; k < 3; k++) { /* C = L D L^T, and the last column is L^-1 e */
        sum += m[k][3] * m[k][3] / m[k][k];
    }
    return sum;
}

static const double RADIUS_U = 35000.0;

static void exact_cones_give_the_ball(void) {
    for (int trial = 0; trial < TEST_TRIALS(5000); trial++) {
        const scene_t scene = any_scene(2e5, 2e6);
        const ocel_cone_t left = cone_of(&scene, 0, RADIUS_U, USUAL, 0.0);
        const ocel_cone_t right = cone_of(&scene, 1, RADIUS_U, USUAL, 0.0);
        const double slack = 2.0 + (scene.range[0] * scene.range[0] / BASELINE_U * 1e-8);
        const double slack_radius = 2.0 + (scene.range[0] * scene.range[0] / RADIUS_U * 1e-8);
        ocel_ball_t ball;
        TEST_ASSERT_EQUAL(OCEL_OK,
                          ocel_stereo_ball(&left, &right, scene.eyes, (int32_t)RADIUS_U, &ball));
        TEST_ASSERT_TRUE(ball.has_stereo && ball.has_radius && !ball.disagree);
        TEST_ASSERT_TRUE(distance(scene.ball, ball.stereo.p_root_u) < slack);
        TEST_ASSERT_TRUE(distance(scene.ball, ball.by_radius.p_root_u) < slack_radius);
        TEST_ASSERT_TRUE(distance(scene.ball, ball.best.p_root_u) < slack + slack_radius);
        TEST_ASSERT_DOUBLE_WITHIN(1.0, RADIUS_U, ball.radius_u);
        TEST_ASSERT_TRUE(ball.gap_u <= 2U);
        /* The radius not told: the same but for it. */
        const ocel_estimate_t stereo = ball.stereo;
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_stereo_ball(&left, &right, scene.eyes, 0, &ball));
        TEST_ASSERT_TRUE(ball.has_stereo && !ball.has_radius && !ball.disagree);
        TEST_ASSERT_EQUAL_MEMORY(&stereo, &ball.stereo, sizeof(stereo));
        TEST_ASSERT_EQUAL_MEMORY(&stereo, &ball.best, sizeof(stereo));
        TEST_ASSERT_DOUBLE_WITHIN(1.0, RADIUS_U, ball.radius_u);
    }
}

/* The errors are as large as the covariances say: e^T C^-1 e has the mean 3. */
static void covariances_are_those_of_the_errors(void) {
    const int trials = TEST_TRIALS_AT_LEAST(1000, 20000);
    double sums[3] = {0.0, 0.0, 0.0};
    double squares[3] = {0.0, 0.0, 0.0};
    int disagreed = 0;
    for (int trial = 0; trial < trials; trial++) {
        const scene_t scene = any_scene(3e5, 1e6);
        const ocel_cone_t left = cone_of(&scene, 0, RADIUS_U, USUAL, 1.0);
        const ocel_cone_t right = cone_of(&scene, 1, RADIUS_U, USUAL, 1.0);
        ocel_ball_t ball;
        const ocel_status_t status =
            ocel_stereo_ball(&left, &right, scene.eyes, (int32_t)RADIUS_U, &ball);
        const ocel_estimate_t *const all[3] = {&ball.stereo, &ball.by_radius, &ball.best};
        disagreed += (status == OCEL_OK) ? 0 : 1;
        for (int k = 0; k < 3; k++) {
            double e[3];
            for (int i = 0; i < 3; i++) {
                e[i] = all[k]->p_root_u[i] - scene.ball[i];
            }
            sums[k] += mahalanobis(all[k]->cov_root_u2, e);
            squares[k] += dot(e, e) / (scene.range[0] * scene.range[0]);
        }
    }
    printf(
        "stereo, by radius, best: mean e C^-1 e %.3f %.3f %.3f, RMS of the range %.2e %.2e %.2e\n",
        sums[0] / trials, sums[1] / trials, sums[2] / trials, sqrt(squares[0] / trials),
        sqrt(squares[1] / trials), sqrt(squares[2] / trials));
    TEST_ASSERT_EQUAL_INT(0, disagreed);
    for (int k = 0; k < 3; k++) { /* its deviation is sqrt(6 / trials): 4 of them, and rounding */
        TEST_ASSERT_DOUBLE_WITHIN(0.03 + (4.0 * sqrt(6.0 / trials)), 3.0, sums[k] / trials);
    }
    TEST_ASSERT_TRUE((squares[2] < squares[0]) && (squares[2] < squares[1]));
}

/* Rank one: sigma along v, which is in the root's frame, the cone's in its camera's. */
static void add_uncertainty(ocel_cone_t *cone, double r[3][3], const double v[3], double sigma) {
    double v_cam[3];
    for (int i = 0; i < 3; i++) {
        v_cam[i] = (r[0][i] * v[0]) + (r[1][i] * v[1]) + (r[2][i] * v[2]);
    }
    for (int i = 0; i < 3; i++) {
        for (int j = i; j < 3; j++) {
            cone->cov_q60[(i == 0) ? j : (i + j + 1)] +=
                llround(ONE_Q60 * sigma * sigma * v_cam[i] * v_cam[j]);
        }
    }
}

/* What the directions' errors, not the same every way, do to the midpoint: by moving each
 * a little in double. */
static void stereo_covariance_is_propagated(void) {
    for (int trial = 0; trial < TEST_TRIALS(500); trial++) {
        scene_t scene = any_scene(2e5, 3e6);
        ocel_cone_t cones[2];
        double expected[3][3] = {{0.0}};
        ocel_ball_t ball;
        for (int k = 0; k < 2; k++) {
            double axes[3][3];
            cones[k] = cone_of(&scene, k, RADIUS_U, USUAL, 0.0);
            memset(cones[k].cov_q60, 0, sizeof(cones[k].cov_q60));
            add_uncertainty(&cones[k], scene.r[k], scene.lines[k].d, 1e-3);
            rotation_about(&rng, scene.lines[k].d, axes);
            for (int across = 0; across < 2; across++) { /* the two ways to move a direction */
                const double sigma = rng_log_uniform(&rng, 1e-5, 3e-4);
                const double v[3] = {axes[0][across], axes[1][across], axes[2][across]};
                double ends[2][3];
                double t[2];
                add_uncertainty(&cones[k], scene.r[k], v, sigma);
                for (int sign = 0; sign < 2; sign++) {
                    line_t lines[2] = {scene.lines[0], scene.lines[1]};
                    for (int i = 0; i < 3; i++) {
                        lines[k].d[i] += ((sign == 0) ? -1e-6 : 1e-6) * v[i];
                    }
                    (void)meet(&lines[0], &lines[1], ends[sign], t);
                }
                for (int i = 0; i < 3; i++) {
                    for (int j = 0; j < 3; j++) {
                        expected[i][j] += sigma * sigma * (ends[1][i] - ends[0][i]) *
                                          (ends[1][j] - ends[0][j]) / 4e-12;
                    }
                }
            }
        }
        const double size = expected[0][0] + expected[1][1] + expected[2][2];
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_stereo_ball(&cones[0], &cones[1], scene.eyes, 0, &ball));
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                const double slack =
                    3.0 + (1e-6 * size) + (1e-4 * sqrt(expected[i][i] * expected[j][j]));
                TEST_ASSERT_DOUBLE_WITHIN(slack, expected[i][j],
                                          element(ball.stereo.cov_root_u2, i, j));
            }
        }
    }
}

/* `best` is stereo after two Kalman steps with the ranges, and its covariance too. */
static void best_is_the_kalman_step(void) {
    for (int trial = 0; trial < TEST_TRIALS(500); trial++) {
        const scene_t scene = any_scene(3e5, 2e6);
        const sigma_t sigma = {rng_log_uniform(&rng, 5e-5, 5e-4),
                               rng_log_uniform(&rng, 2e-4, 2e-2)};
        const ocel_cone_t cones[2] = {cone_of(&scene, 0, RADIUS_U, sigma, 0.7),
                                      cone_of(&scene, 1, RADIUS_U, sigma, 0.7)};
        ocel_ball_t ball;
        double p[3];
        double c[3][3];
        TEST_ASSERT_EQUAL(
            OCEL_OK, ocel_stereo_ball(&cones[0], &cones[1], scene.eyes, (int32_t)RADIUS_U, &ball));
        for (int i = 0; i < 3; i++) {
            p[i] = ball.stereo.p_root_u[i];
            for (int j = 0; j < 3; j++) {
                c[i][j] = element(ball.stereo.cov_root_u2, i, j);
            }
        }
        for (int k = 0; k < 2; k++) {
            const double range = RADIUS_U / (cones[k].sin_q30 / ONE_Q30);
            double d[3];
            double cd[3];
            double along = 0.0;
            double s = range * range * sigma.sine * sigma.sine;
            for (int i = 0; i < 3; i++) {
                d[i] = 0.0;
                for (int j = 0; j < 3; j++) {
                    d[i] += scene.r[k][i][j] * cones[k].axis_cam_q30[j] / ONE_Q30;
                }
                along += d[i] * (p[i] - scene.lines[k].p[i]);
            }
            for (int i = 0; i < 3; i++) {
                cd[i] = dot(c[i], d);
                s += cd[i] * d[i];
            }
            for (int i = 0; i < 3; i++) {
                p[i] += cd[i] / s * (range - along);
                for (int j = 0; j < 3; j++) {
                    c[i][j] -= cd[i] * cd[j] / s;
                }
            }
        }
        const double size = c[0][0] + c[1][1] + c[2][2];
        TEST_ASSERT_TRUE(distance(p, ball.best.p_root_u) < 3.0);
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                TEST_ASSERT_DOUBLE_WITHIN(10.0 + (1e-5 * size), c[i][j],
                                          element(ball.best.cov_root_u2, i, j));
            }
        }
    }
}

static void one_eye_falls_back_on_the_radius(void) {
    static const ocel_estimate_t NONE;
    for (int eye = 0; eye < 2; eye++) {
        const scene_t scene = any_scene(3e5, 1e6);
        const ocel_cone_t cone = cone_of(&scene, eye, RADIUS_U, USUAL, 0.0);
        const ocel_cone_t *const left = (eye == 0) ? &cone : NULL;
        const ocel_cone_t *const right = (eye == 0) ? NULL : &cone;
        ocel_ball_t ball;
        TEST_ASSERT_EQUAL(OCEL_OK,
                          ocel_stereo_ball(left, right, scene.eyes, (int32_t)RADIUS_U, &ball));
        TEST_ASSERT_TRUE(!ball.has_stereo && ball.has_radius && !ball.disagree);
        TEST_ASSERT_TRUE(distance(scene.ball, ball.best.p_root_u) < 3.0);
        TEST_ASSERT_EQUAL_MEMORY(&ball.best, &ball.by_radius, sizeof(ball.best));
        TEST_ASSERT_EQUAL_MEMORY(&NONE, &ball.stereo, sizeof(NONE));
        TEST_ASSERT_EQUAL_UINT32(0U, ball.radius_u);
        TEST_ASSERT_EQUAL(OCEL_DEGENERATE, ocel_stereo_ball(left, right, scene.eyes, 0, &ball));
    }
}

/* The radius estimate is the surer eye's, its covariance turned into the root's frame. */
static void by_radius_is_the_surer_eye_s(void) {
    static const sigma_t SURE = {1e-4, 5e-4};
    static const sigma_t UNSURE = {3e-4, 5e-3};
    for (int sure = 0; sure < 2; sure++) {
        const scene_t scene = any_scene(3e5, 1e6);
        const ocel_cone_t cones[2] = {
            cone_of(&scene, 0, RADIUS_U, (sure == 0) ? SURE : UNSURE, 0.0),
            cone_of(&scene, 1, RADIUS_U, (sure == 1) ? SURE : UNSURE, 0.0)};
        const double range = RADIUS_U / (cones[sure].sin_q30 / ONE_Q30);
        ocel_ball_t ball;
        TEST_ASSERT_EQUAL(
            OCEL_OK, ocel_stereo_ball(&cones[0], &cones[1], scene.eyes, (int32_t)RADIUS_U, &ball));
        for (int i = 0; i < 3; i++) {
            const double *row = scene.r[sure][i];
            const double variance = quadratic(cones[sure].cov_q60, row, row) / ONE_Q60;
            const double least = range * range * variance * (1.0 - 1e-5); /* the range is whole */
            const double off = element(ball.by_radius.cov_root_u2, i, i) - least;
            TEST_ASSERT_TRUE((off > 0.0) && (off < 1.01 + (2e-5 * least)));
        }
    }
}

/* A ball of another size: stereo stands, the fault is told. */
static void a_wrong_radius_is_a_fault(void) {
    static const double SIZES[3] = {0.8, 0.9, 1.2};
    for (int k = 0; k < 3; k++) {
        const scene_t scene = any_scene(3e5, 6e5);
        const ocel_cone_t left = cone_of(&scene, 0, RADIUS_U * SIZES[k], USUAL, 0.0);
        const ocel_cone_t right = cone_of(&scene, 1, RADIUS_U * SIZES[k], USUAL, 0.0);
        ocel_ball_t ball;
        TEST_ASSERT_EQUAL(OCEL_PARTIAL,
                          ocel_stereo_ball(&left, &right, scene.eyes, (int32_t)RADIUS_U, &ball));
        TEST_ASSERT_TRUE(ball.disagree && ball.has_stereo && ball.has_radius);
        TEST_ASSERT_EQUAL_MEMORY(&ball.best, &ball.stereo, sizeof(ball.best));
        TEST_ASSERT_TRUE(distance(scene.ball, ball.best.p_root_u) < 3.0);
        TEST_ASSERT_DOUBLE_WITHIN(2.0, RADIUS_U * SIZES[k], ball.radius_u);
    }
}

/* One eye's range alone is wrong, the left's or the right's: a hidden edge, say. */
static void a_wrong_range_of_one_eye_is_a_fault(void) {
    for (int eye = 0; eye < 2; eye++) {
        const scene_t scene = any_scene(3e5, 6e5);
        ocel_cone_t cones[2] = {cone_of(&scene, 0, RADIUS_U, USUAL, 0.0),
                                cone_of(&scene, 1, RADIUS_U, USUAL, 0.0)};
        ocel_ball_t ball;
        cones[eye].sin_q30 -= cones[eye].sin_q30 / 8U;
        TEST_ASSERT_EQUAL(OCEL_PARTIAL, ocel_stereo_ball(&cones[0], &cones[1], scene.eyes,
                                                         (int32_t)RADIUS_U, &ball));
        TEST_ASSERT_TRUE(ball.disagree);
        TEST_ASSERT_EQUAL_MEMORY(&ball.best, &ball.stereo, sizeof(ball.best));
    }
}

/* The bound on the disagreement: the deviations of both, and a 32nd of the range. */
static void small_disagreements_are_none(void) {
    const scene_t scene = any_scene(5e5, 5.0001e5);
    const ocel_cone_t right = cone_of(&scene, 1, RADIUS_U, USUAL, 0.0);
    const double sine = RADIUS_U / scene.range[0] * ONE_Q30;
    ocel_cone_t left = cone_of(&scene, 0, RADIUS_U, USUAL, 0.0);
    ocel_ball_t ball;
    left.sin_q30 = (uint32_t)(sine * 1.03);
    TEST_ASSERT_EQUAL(OCEL_OK,
                      ocel_stereo_ball(&left, &right, scene.eyes, (int32_t)RADIUS_U, &ball));
    left.sin_q30 = (uint32_t)(sine * 1.06); /* deviations here: .0018 of the range */
    TEST_ASSERT_EQUAL(OCEL_PARTIAL,
                      ocel_stereo_ball(&left, &right, scene.eyes, (int32_t)RADIUS_U, &ball));
    const sigma_t poor = {2e-4, 1e-2}; /* 5 of these are .05 */
    left = cone_of(&scene, 0, RADIUS_U, poor, 0.0);
    left.sin_q30 = (uint32_t)(sine * 1.06);
    TEST_ASSERT_EQUAL(OCEL_OK,
                      ocel_stereo_ball(&left, &right, scene.eyes, (int32_t)RADIUS_U, &ball));
}

/* The eyes look at two different balls, one above the other: metres of gap. */
static void rays_that_miss_are_a_fault(void) {
    scene_t scene = any_scene(4e5, 6e5);
    double side[3];
    double up[3];
    ocel_ball_t ball;
    for (int i = 0; i < 3; i++) {
        side[i] = scene.lines[1].p[i] - scene.lines[0].p[i];
    }
    (void)unit(side);
    rotation_cross(side, scene.lines[0].d, up);
    const scene_t before = scene;
    for (int i = 0; i < 3; i++) {
        scene.lines[1].d[i] = scene.ball[i] + (0.3 * scene.range[0] * up[i]) - scene.lines[1].p[i];
    }
    scene.range[1] = unit(scene.lines[1].d);
    const ocel_cone_t left = cone_of(&scene, 0, RADIUS_U, USUAL, 0.0);
    const ocel_cone_t right = cone_of(&scene, 1, RADIUS_U, USUAL, 0.0);
    TEST_ASSERT_EQUAL(OCEL_PARTIAL,
                      ocel_stereo_ball(&left, &right, scene.eyes, (int32_t)RADIUS_U, &ball));
    TEST_ASSERT_TRUE(ball.disagree);
    TEST_ASSERT_EQUAL_MEMORY(&ball.best, &ball.by_radius, sizeof(ball.best));
    TEST_ASSERT_TRUE(ball.gap_u > 50000U);
    TEST_ASSERT_EQUAL(OCEL_PARTIAL, ocel_stereo_ball(&left, &right, scene.eyes, 0, &ball));
    TEST_ASSERT_TRUE(ball.disagree);
    TEST_ASSERT_EQUAL_MEMORY(&ball.best, &ball.stereo, sizeof(ball.best));
    /* The right eye looks back: the rays meet nowhere, whatever the radius says. */
    for (int i = 0; i < 3; i++) {
        scene.lines[1].d[i] = -before.lines[1].d[i];
    }
    const ocel_cone_t back = cone_of(&scene, 1, RADIUS_U, USUAL, 0.0);
    TEST_ASSERT_EQUAL(OCEL_PARTIAL,
                      ocel_stereo_ball(&left, &back, scene.eyes, (int32_t)RADIUS_U, &ball));
    TEST_ASSERT_TRUE(ball.disagree && !ball.has_stereo);
    TEST_ASSERT_EQUAL(OCEL_DEGENERATE, ocel_stereo_ball(&left, &back, scene.eyes, 0, &ball));
}

/* Axes so unsure that the directions say nothing of the range: the radius alone. */
static void unsure_directions_leave_the_radius(void) {
    static const sigma_t POOR = {3e-2, 1e-3};
    const scene_t scene = any_scene(9e5, 1e6);
    const ocel_cone_t left = cone_of(&scene, 0, RADIUS_U, POOR, 0.0);
    const ocel_cone_t right = cone_of(&scene, 1, RADIUS_U, POOR, 0.0);
    ocel_ball_t ball;
    TEST_ASSERT_EQUAL(OCEL_OK,
                      ocel_stereo_ball(&left, &right, scene.eyes, (int32_t)RADIUS_U, &ball));
    TEST_ASSERT_TRUE(!ball.has_stereo && !ball.disagree);
    TEST_ASSERT_EQUAL_MEMORY(&ball.best, &ball.by_radius, sizeof(ball.best));
    TEST_ASSERT_EQUAL(OCEL_DEGENERATE, ocel_stereo_ball(&left, &right, scene.eyes, 0, &ball));
}

/* The eyes look along one of the root's axes at a ball 1 m away: all that they do not
 * know stands in one element of the covariance. */
static scene_t aligned_scene(int axis) {
    scene_t scene = any_scene(1e6, 1.1e6);
    for (int k = 0; k < 2; k++) {
        double ahead[3] = {0, 0, 0};
        ahead[axis] = 1.0;
        rotation_about(&rng, ahead, scene.r[k]);
        scene.eyes[k] = rotation_pose(scene.r[k]);
        for (int i = 0; i < 3; i++) {
            scene.ball[i] = (i == axis) ? 1e6 : 0.0;
            scene.lines[k].p[i] = (i == (axis + 1) % 3) ? ((k == 0) ? -34000.0 : 34000.0) : 0.0;
            scene.lines[k].d[i] = scene.ball[i] - scene.lines[k].p[i];
            scene.eyes[k].p_u[i] = (int32_t)scene.lines[k].p[i];
        }
        scene.range[k] = unit(scene.lines[k].d);
    }
    return scene;
}

static void unsure_directions_along_any_axis(void) {
    static const ocel_estimate_t NONE;
    static const sigma_t POOR = {3e-2, 1e-3};
    for (int axis = 0; axis < 3; axis++) {
        const scene_t scene = aligned_scene(axis);
        const ocel_cone_t left = cone_of(&scene, 0, RADIUS_U, POOR, 0.0);
        const ocel_cone_t right = cone_of(&scene, 1, RADIUS_U, POOR, 0.0);
        ocel_ball_t ball;
        TEST_ASSERT_EQUAL(OCEL_OK,
                          ocel_stereo_ball(&left, &right, scene.eyes, (int32_t)RADIUS_U, &ball));
        TEST_ASSERT_TRUE(!ball.has_stereo);
        TEST_ASSERT_EQUAL_MEMORY(&NONE, &ball.stereo, sizeof(NONE));
    }
}

/* What is no covariance vouches for nothing: here the variances of the midpoint cancel
 * and what stands beside them does not. */
static void no_covariance_is_refused(void) {
    int refused = 0;
    for (int trial = 0; trial < 50; trial++) {
        const scene_t scene = aligned_scene(trial % 3);
        ocel_cone_t cones[2];
        ocel_ball_t ball;
        for (int k = 0; k < 2; k++) {
            cones[k] = cone_of(&scene, k, RADIUS_U, USUAL, 0.0);
            for (int i = 0; i < OCEL_SYM3_COUNT; i++) {
                cones[k].cov_q60[i] = rng_between(&rng, -1, 1) * ((int64_t)1 << 38);
            }
        }
        refused += (ocel_stereo_ball(&cones[0], &cones[1], scene.eyes, (int32_t)RADIUS_U, &ball) ==
                    OCEL_PARTIAL)
                       ? 1
                       : 0;
    }
    printf("no covariances: %d of 50 refused\n", refused);
    TEST_ASSERT_TRUE(refused >= 1);
}

static void check_ball(ocel_status_t expected, const ocel_cone_t *left, const ocel_cone_t *right,
                       const ocel_pose_t *eyes, int32_t radius) {
    static const ocel_ball_t NONE;
    ocel_ball_t ball;
    memset(&ball, 0x55, sizeof(ball));
    TEST_ASSERT_EQUAL(expected, ocel_stereo_ball(left, right, eyes, radius, &ball));
    TEST_ASSERT_EQUAL_MEMORY(&NONE, &ball, sizeof(ball));
}

static void balls_that_are_none(void) {
    const scene_t scene = any_scene(3e5, 1e6);
    const ocel_cone_t good = cone_of(&scene, 0, RADIUS_U, USUAL, 0.0);
    const ocel_cone_t right = cone_of(&scene, 1, RADIUS_U, USUAL, 0.0);
    ocel_pose_t eyes[2] = {scene.eyes[0], scene.eyes[1]};
    ocel_cone_t bad = good;
    check_ball(OCEL_NOT_SEEN, NULL, NULL, eyes, 35000);
    check_ball(OCEL_NOT_SEEN, NULL, NULL, eyes, -1);
    check_ball(OCEL_OUT_OF_RANGE, &good, &right, eyes, -1);
    check_ball(OCEL_OUT_OF_RANGE, &good, &right, eyes, INT32_MIN);
    check_ball(OCEL_OUT_OF_RANGE, &good, &right, eyes, INT32_MAX); /* over 2^30 u away */
    memset(bad.axis_cam_q30, 0, sizeof(bad.axis_cam_q30));
    check_ball(OCEL_OUT_OF_RANGE, &bad, &right, eyes, 35000);
    check_ball(OCEL_OUT_OF_RANGE, &bad, &right, eyes, 0);
    check_ball(OCEL_OUT_OF_RANGE, &right, &bad, eyes, 0);
    bad = good;
    bad.sin_q30 = 0U;
    check_ball(OCEL_OUT_OF_RANGE, &bad, &right, eyes, 35000);
    bad.sin_q30 = UINT32_MAX;
    check_ball(OCEL_OUT_OF_RANGE, &bad, &right, eyes, 0);
    bad = good;
    bad.cov_q60[OCEL_XY] = -(((int64_t)1 << 58) + 1);
    check_ball(OCEL_OUT_OF_RANGE, &bad, &right, eyes, 35000);
    bad.cov_q60[OCEL_XY] = INT64_MIN;
    check_ball(OCEL_OUT_OF_RANGE, &right, &bad, eyes, 35000);
    eyes[1].p_u[2] = OCEL_MAX_STEREO_U + 1;
    check_ball(OCEL_OUT_OF_RANGE, &good, &right, eyes, 35000);
    check_ball(OCEL_NULL_ARGUMENT, &good, &right, NULL, 35000);
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_stereo_ball(&good, &right, eyes, 35000, NULL));
}

/* An eye at the edge of the stated positions that looks outwards, at a ball 2^30 u away:
 * that is too far from the root. */
static void balls_too_far_from_the_root(void) {
    static const double AHEAD[3] = {0, 0, 1};
    scene_t scene = any_scene(3e5, 1e6);
    double right[3][3];
    rotation_about(&rng, AHEAD, right);
    for (int k = 0; k < 2; k++) {
        memcpy(scene.r[k], right, sizeof(right));
        memcpy(scene.lines[k].d, AHEAD, sizeof(AHEAD));
        scene.eyes[k] = rotation_pose(right);
        scene.range[k] = ldexp(1.0, 29);
    }
    scene.eyes[0].p_u[2] = OCEL_MAX_STEREO_U;
    ocel_cone_t cone = cone_of(&scene, 0, RADIUS_U, USUAL, 0.0);
    ocel_ball_t ball;
    cone.sin_q30 = 1U << 20;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_stereo_ball(&cone, NULL, scene.eyes, 1 << 19, &ball));
    check_ball(OCEL_OUT_OF_RANGE, &cone, NULL, scene.eyes, (1 << 20) - (1 << 17));
}

/* Whatever stands in the cones: a status, no trap (the sanitizers watch), and nothing
 * but zeroes without an answer. */
static void any_cone_gives_a_status(void) {
    static const ocel_ball_t NONE;
    int answered = 0;
    for (int trial = 0; trial < TEST_TRIALS(50000); trial++) {
        scene_t scene = any_scene(1e3, 2e8);
        ocel_cone_t cones[2] = {cone_of(&scene, 0, RADIUS_U, USUAL, 1.0),
                                cone_of(&scene, 1, RADIUS_U, USUAL, 1.0)};
        ocel_ball_t ball;
        int32_t radius = (int32_t)RADIUS_U;
        for (int k = 0; k < 2; k++) {
            const uint32_t small = 5U + rng_below(&rng, 40U);
            for (int i = 0; i < OCEL_SYM3_COUNT; i++) { /* no covariance at all */
                cones[k].cov_q60[i] = (int64_t)rng_u64(&rng) >> (small + rng_below(&rng, 16U));
            }
            if (trial % 2 == 0) { /* and nothing in common */
                cones[k].sin_q30 = rng_u32(&rng) >> (2U + rng_below(&rng, 30U));
                radius = (int32_t)(rng_u32(&rng) >> (1U + rng_below(&rng, 31U)));
            }
        }
        const ocel_status_t status =
            ocel_stereo_ball(&cones[0], &cones[1], scene.eyes, radius, &ball);
        if ((status == OCEL_OK) || (status == OCEL_PARTIAL)) {
            answered++;
        } else {
            TEST_ASSERT_TRUE((status == OCEL_DEGENERATE) || (status == OCEL_OUT_OF_RANGE));
            TEST_ASSERT_EQUAL_MEMORY(&NONE, &ball, sizeof(ball));
        }
    }
    TEST_ASSERT_TRUE(answered > 0);
}

int main(void) {
    printf("seed %d\n", SEED);
    UNITY_BEGIN();
    RUN_TEST(midpoint_of_meeting_rays);
    RUN_TEST(midpoint_of_skew_rays);
    RUN_TEST(midpoint_of_simple_rays_is_exact);
    RUN_TEST(rays_without_a_midpoint);
    RUN_TEST(rays_that_are_none);
    RUN_TEST(midpoint_tells_the_gap);
    RUN_TEST(encoders_bias_is_the_papers);
    RUN_TEST(encoders_agree_with_the_head);
    RUN_TEST(encoders_take_what_the_image_still_shows);
    RUN_TEST(encoders_without_an_answer);
    RUN_TEST(exact_cones_give_the_ball);
    RUN_TEST(covariances_are_those_of_the_errors);
    RUN_TEST(stereo_covariance_is_propagated);
    RUN_TEST(best_is_the_kalman_step);
    RUN_TEST(one_eye_falls_back_on_the_radius);
    RUN_TEST(by_radius_is_the_surer_eye_s);
    RUN_TEST(a_wrong_radius_is_a_fault);
    RUN_TEST(a_wrong_range_of_one_eye_is_a_fault);
    RUN_TEST(small_disagreements_are_none);
    RUN_TEST(rays_that_miss_are_a_fault);
    RUN_TEST(unsure_directions_leave_the_radius);
    RUN_TEST(unsure_directions_along_any_axis);
    RUN_TEST(no_covariance_is_refused);
    RUN_TEST(balls_that_are_none);
    RUN_TEST(balls_too_far_from_the_root);
    RUN_TEST(any_cone_gives_a_status);
    return UNITY_END();
}
