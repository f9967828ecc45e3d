/* SPDX-License-Identifier: MIT
 *
 * The robust cone fit: exact points, rendered balls with and without what hides them,
 * the same algorithm in double beside it, and what no fit may trip over.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <ocellus/cone.h>

#include "ball_scene.h"
#include "base/sector.h"
#include "base/sym3.h"
#include "board.h"
#include "fit_support.h"
#include "reference/cone_reference.h"
#include "unity.h"

enum { SEED = 20110812, TRIALS = TEST_TRIALS(400), MAX_POINTS = 4096 };

#define Q30 1073741824.0
#define Q60 (Q30 * Q30)

static rng_t rng;
static ocel_camera_t camera;
static ocel_eye_t eye;
static uint8_t mask[SCENE_PIXELS];
static const ref_camera_t ref_camera = {SCENE_F_PX, SCENE_F_PX, SCENE_CX_PX, SCENE_CY_PX};

void setUp(void) {
    rng = rng_seed(SEED);
    scene_camera(&camera);
}

void tearDown(void) {
}

static bool is_zero(const ocel_cone_t *cone) {
    ocel_cone_t zero;
    memset(&zero, 0, sizeof(zero));
    return memcmp(cone, &zero, sizeof(zero)) == 0;
}

/* The boundary of the scene's largest blob. */
static size_t boundary_of(const scene_t *scene, const ocel_crack_t **cracks) {
    ocel_detection_t detection;
    size_t count = 0;
    scene_draw(scene, &rng, mask);
    (void)scene_look(mask, &eye, &detection);
    *cracks = ocel_eye_boundary(&eye, &count);
    TEST_ASSERT_NOT_NULL(*cracks);
    TEST_ASSERT_EQUAL_UINT32(1U, detection.boundary_stride);
    return count;
}

static ref_cone_t to_double(const ocel_cone_t *cone) {
    ref_cone_t r;
    memset(&r, 0, sizeof(r));
    for (int i = 0; i < 3; i++) {
        r.axis[i] = cone->axis_cam_q30[i] / Q30;
    }
    r.sine = cone->sin_q30 / Q30;
    r.rms_px = cone->rms_px_q16 / 65536.0;
    r.coverage = cone->arc_coverage_q16 / 65536.0;
    r.inliers = cone->inlier_count;
    return r;
}

/* Errors against the truth: of the position over the range, and of its two parts. */
typedef struct {
    double position;
    double range;
    double angle_px;
} error_t;

static error_t error_of(const ref_cone_t *cone, const scene_ball_t *ball) {
    const double range = scene_norm(ball->centre);
    const double guess = ball->radius / cone->sine;
    error_t e = {0.0, guess / range - 1.0, 0.0};
    double squares = 0.0;
    double dot = 0.0;
    for (int i = 0; i < 3; i++) {
        const double d = cone->axis[i] * guess - ball->centre[i];
        squares += d * d;
        dot += cone->axis[i] * ball->centre[i];
    }
    e.position = sqrt(squares) / range;
    e.angle_px = SCENE_F_PX * sqrt(fmax(0.0, e.position * e.position - e.range * e.range));
    return e;
}

static scene_t hidden_scene(double radius_px, double share) {
    scene_t scene;
    scene_occluded(&scene, radius_px, share, true, &rng);
    scene.edges = (share > 0.0) ? 1 : 0;
    return scene;
}

/* ---- Exact points ---- */

/* Points on the outline of a cone of half angle `alpha` about `axis`, between two turns. */
static size_t outline_points(const ocel_camera_t *cam, const double axis[3], double alpha,
                             double from, double to, size_t count, ocel_point_t *points) {
    const double helper[3] = {fabs(axis[0]) < 0.5 ? 1.0 : 0.0, fabs(axis[0]) < 0.5 ? 0.0 : 1.0,
                              0.0};
    double e1[3];
    double e2[3];
    double dot = 0.0;
    size_t seen = 0;
    for (int i = 0; i < 3; i++) {
        dot += helper[i] * axis[i];
    }
    for (int i = 0; i < 3; i++) {
        e1[i] = helper[i] - dot * axis[i];
    }
    const double length = scene_norm(e1);
    for (int i = 0; i < 3; i++) {
        e1[i] /= length;
    }
    for (int i = 0; i < 3; i++) {
        e2[i] = axis[(i + 1) % 3] * e1[(i + 2) % 3] - axis[(i + 2) % 3] * e1[(i + 1) % 3];
    }
    for (size_t k = 0; k < count; k++) {
        const double t = 2.0 * SCENE_PI * (from + (to - from) * (double)k / (double)count);
        int32_t p_cam_u[3];
        for (int i = 0; i < 3; i++) {
            p_cam_u[i] = (int32_t)lround(
                1e9 * (cos(alpha) * axis[i] + sin(alpha) * (cos(t) * e1[i] + sin(t) * e2[i])));
        }
        seen += (ocel_camera_project(cam, p_cam_u, &points[seen]) == OCEL_OK) ? 1U : 0U;
    }
    return seen;
}

static void random_axis(double tilt_max, double axis[3]) {
    const double tilt = rng_uniform(&rng, 0.0, tilt_max);
    const double around = rng_uniform(&rng, 0.0, 2.0 * SCENE_PI);
    axis[0] = sin(tilt) * cos(around);
    axis[1] = sin(tilt) * sin(around);
    axis[2] = cos(tilt);
}

/* Outlines of 8 to 1000 px; a pixel is rounded to 2^-17 px. */
static void exact_outlines_give_their_cone(void) {
    static ocel_point_t points[256];
    double worst_px = 0.0;
    for (int i = 0; i < TRIALS; i++) {
        ocel_intrinsics_t in = {0};
        ocel_camera_t cam;
        ocel_cone_t cone;
        double axis[3];
        const double f = rng_log_uniform(&rng, 40.0, 16000.0);
        const double alpha = rng_log_uniform(&rng, 8.0 / f, fmin(0.5, 1000.0 / f));
        in.fx_px_q16 = (int32_t)(f * 65536.0);
        in.fy_px_q16 = (int32_t)(f * rng_uniform(&rng, 0.8, 1.02) * 65536.0);
        in.k1_q24 = ((i % 4) == 3) ? -2000000 : 0;
        TEST_ASSERT_EQUAL_INT(OCEL_OK, ocel_camera_init(&cam, &in));
        random_axis(((i % 4) == 3) ? 0.2 : 0.6, axis);
        const double reach = ((i % 4) == 3) ? 0.25 : 0.5;
        const double half = fmin(alpha, reach);
        const size_t count =
            outline_points(&cam, axis, half, 0.0, 1.0, 12U + rng_below(&rng, 240U), points);
        if (count < 12U) {
            continue; /* outside the range of coordinates */
        }
        TEST_ASSERT_EQUAL_INT_MESSAGE(OCEL_OK, ocel_cone_fit_points(&cam, points, count, &cone),
                                      "an exact outline");
        const ref_cone_t r = to_double(&cone);
        TEST_ASSERT_EQUAL_size_t(count, cone.inlier_count);
        for (int k = 0; k < 3; k++) {
            worst_px = fmax(worst_px, f * fabs(r.axis[k] - axis[k]));
        }
        worst_px = fmax(worst_px, f * fabs(r.sine - sin(half)));
    }
    printf("exact outlines: worst error %.2g px\n", worst_px);
    TEST_ASSERT_TRUE(worst_px < 0.03);
}

/* ---- Rendered balls ---- */

typedef struct {
    double squares; /* of the range's error over the range */
    double angles;  /* px^2 */
    double chi;
    double worst;
    int ok;
    int wrong; /* vouched for, and off by more than 5 % */
} tally_t;

static void tally_add(tally_t *tally, const ref_cone_t *cone, const scene_ball_t *ball, bool ok) {
    const error_t e = error_of(cone, ball);
    if (ok) {
        tally->ok++;
        tally->squares += e.range * e.range;
        tally->angles += e.angle_px * e.angle_px;
        tally->worst = fmax(tally->worst, fabs(e.range));
        tally->wrong += (e.position > 0.05) ? 1 : 0;
    }
}

/* One scene by both. */
static void look(const scene_t *scene, tally_t *fixed, tally_t *twin) {
    static ref_point_t points[MAX_POINTS];
    const ocel_crack_t *cracks = NULL;
    const size_t count = boundary_of(scene, &cracks);
    ocel_cone_t cone;
    ref_cone_t reference;
    const ocel_status_t status = ocel_cone_fit_cracks(&camera, cracks, count, &cone);
    const ref_cone_t answer = to_double(&cone);
    tally_add(fixed, &answer, &scene->ball, status == OCEL_OK);
    if (status == OCEL_OK) {
        const double *a = answer.axis;
        double variance = 0.0; /* along the axis */
        for (int i = 0, at = 0; i < 3; i++) {
            for (int k = i; k < 3; k++, at++) {
                variance += ((i == k) ? 1.0 : 2.0) * a[i] * a[k] * (double)cone.cov_q60[at] / Q60;
            }
        }
        const double e = error_of(&answer, &scene->ball).range;
        fixed->chi += e * e / variance;
    }
    fit_cracks_to_points(cracks, count, points);
    if (ref_cone_fit(&ref_camera, points, count, true, &reference)) {
        tally_add(twin, &reference, &scene->ball, reference.vouched);
    }
}

/* Issue figures: radius within .20 % RMS, centre within .10 px RMS, none refused; fixed
 * point within 2 % of double; the covariance of the right size. */
static void hidden_balls_keep_their_place(void) {
    static const double shares[] = {0.0, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5};
    /* A board's few trials: the mean of a chi^2 of one degree spreads by sqrt(2 / n). */
    const double spread = (OCEL_TEST_REDUCED == 1) ? 0.0 : 4.0 * sqrt(2.0 / TRIALS);
    tally_t all = {0};
    tally_t all_twin = {0};
    for (size_t s = 0; s < sizeof(shares) / sizeof(shares[0]); s++) {
        tally_t fixed = {0};
        tally_t twin = {0};
        for (int i = 0; i < TRIALS; i++) {
            const scene_t scene = hidden_scene(40.0, shares[s]);
            look(&scene, &fixed, &twin);
        }
        printf(
            "R = 40 px, %2.0f %% hidden: range %.4f %% RMS (double %.4f), %.3f %% at worst, centre "
            "%.4f px (%.4f), chi^2 %.2f\n",
            100.0 * shares[s], 100.0 * sqrt(fixed.squares / fixed.ok),
            100.0 * sqrt(twin.squares / twin.ok), 100.0 * fixed.worst,
            sqrt(fixed.angles / fixed.ok), sqrt(twin.angles / twin.ok), fixed.chi / fixed.ok);
        TEST_ASSERT_EQUAL_INT(TRIALS, fixed.ok);
        TEST_ASSERT_EQUAL_INT(TRIALS, twin.ok);
        TEST_ASSERT_TRUE(sqrt(fixed.squares / fixed.ok) <= 0.0020);
        TEST_ASSERT_TRUE(sqrt(fixed.angles / fixed.ok) <= 0.10);
        TEST_ASSERT_TRUE((fixed.chi / fixed.ok > 0.3 - spread) &&
                         (fixed.chi / fixed.ok < 2.0 + spread));
        all.squares += fixed.squares;
        all.angles += fixed.angles;
        all_twin.squares += twin.squares;
        all_twin.angles += twin.angles;
    }
    printf("fixed point over double: range %.4f, centre %.4f\n",
           sqrt(all.squares / all_twin.squares), sqrt(all.angles / all_twin.angles));
    TEST_ASSERT_TRUE(sqrt(all.squares / all_twin.squares) <= 1.02);
    TEST_ASSERT_TRUE(sqrt(all.angles / all_twin.angles) <= 1.02);
}

/* A second ball of the same colour that touches: whatever the fit says, it vouches for
 * no wrong place. */
static void touching_balls_are_not_vouched_for_wrongly(void) {
    static const double sizes[] = {0.3, 0.6, 1.0, 1.4};
    tally_t fixed = {0};
    tally_t twin = {0};
    for (int i = 0; i < TRIALS; i++) {
        scene_t scene;
        const double size = sizes[i % 4];
        const double around = rng_uniform(&rng, 0.0, 2.0 * SCENE_PI);
        memset(&scene, 0, sizeof(scene));
        scene.ball = scene_ball_at(160.0, 120.0, 400.0, SCENE_RADIUS_MM);
        const double r = scene_outline(&scene.ball).a;
        const double d = 0.95 * r * (1.0 + size);
        scene.other = scene_ball_at(160.0 + d * cos(around), 120.0 + d * sin(around), 400.0,
                                    size * SCENE_RADIUS_MM);
        look(&scene, &fixed, &twin);
    }
    printf("touching balls: %d of %d vouched for, %d wrong\n", fixed.ok, TRIALS, fixed.wrong);
    TEST_ASSERT_EQUAL_INT(0, fixed.wrong);
}

/* Points in any order: the samples are others, so the bits are too, but not the answer. */
static void order_does_not_matter_much(void) {
    static ocel_crack_t shuffled[MAX_POINTS];
    static uint32_t index[MAX_POINTS];
    double worst_px = 0.0;
    for (int i = 0; i < TRIALS / 4; i++) {
        const scene_t scene = hidden_scene(30.0, 0.3 * (i % 2));
        const ocel_crack_t *cracks = NULL;
        const size_t count = boundary_of(&scene, &cracks);
        ocel_cone_t cone;
        ocel_cone_t other;
        rng_shuffle(&rng, index, (uint32_t)count);
        for (size_t k = 0; k < count; k++) {
            shuffled[k] = cracks[index[k]];
        }
        TEST_ASSERT_EQUAL_INT(OCEL_OK, ocel_cone_fit_cracks(&camera, cracks, count, &cone));
        TEST_ASSERT_EQUAL_INT(OCEL_OK, ocel_cone_fit_cracks(&camera, shuffled, count, &other));
        worst_px = fmax(worst_px, SCENE_F_PX * fabs((double)cone.sin_q30 - other.sin_q30) / Q30);
        TEST_ASSERT_EQUAL_INT(OCEL_OK, ocel_cone_fit_cracks(&camera, cracks, count, &other));
        TEST_ASSERT_EQUAL_MEMORY(&cone, &other, sizeof(cone));
    }
    printf("shuffled points: worst change of the radius %.3f px\n", worst_px);
    TEST_ASSERT_TRUE(worst_px < 0.25);
}

/* A crack says between which two pixels the outline is, its midpoint only about where. */
static void cracks_tell_more_than_their_midpoints(void) {
    static ocel_point_t points[MAX_POINTS];
    double of_cracks = 0.0;
    double of_points = 0.0;
    for (int i = 0; i < TRIALS / 4; i++) {
        const scene_t scene = hidden_scene(35.0, 0.2 * (i % 2));
        const ocel_crack_t *cracks = NULL;
        const size_t count = boundary_of(&scene, &cracks);
        const double sine = SCENE_RADIUS_MM / scene_norm(scene.ball.centre) * Q30;
        ocel_cone_t cone;
        for (size_t k = 0; k < count; k++) {
            points[k].x_px_q16 = cracks[k].x_hpx * 32768;
            points[k].y_px_q16 = cracks[k].y_hpx * 32768;
        }
        TEST_ASSERT_EQUAL_INT(OCEL_OK, ocel_cone_fit_cracks(&camera, cracks, count, &cone));
        of_cracks += (cone.sin_q30 - sine) * (cone.sin_q30 - sine);
        TEST_ASSERT_EQUAL_INT(OCEL_OK, ocel_cone_fit_points(&camera, points, count, &cone));
        of_points += (cone.sin_q30 - sine) * (cone.sin_q30 - sine);
    }
    printf("cracks: error %.2f of what their midpoints give\n", sqrt(of_cracks / of_points));
    TEST_ASSERT_TRUE(of_cracks < 0.6 * of_points);
}

/* ---- Statuses ---- */

static void short_arcs_are_partial(void) {
    static ocel_point_t points[64];
    const double axis[3] = {0.0, 0.0, 1.0};
    ocel_cone_t cone;
    const size_t count = outline_points(&camera, axis, 0.15, 0.0, 0.15, 64, points);
    TEST_ASSERT_EQUAL_INT(OCEL_PARTIAL, ocel_cone_fit_points(&camera, points, count, &cone));
    TEST_ASSERT_TRUE(fabs(cone.sin_q30 / Q30 - sin(0.15)) < 0.001);
    TEST_ASSERT_TRUE(cone.arc_coverage_q16 <= 6U * 2048U);
}

static void squares_are_not_balls(void) {
    for (int side = 10; side < 120; side += 7) {
        const ocel_crack_t *cracks = NULL;
        static ocel_crack_t square[4 * 120];
        size_t count = 0;
        ocel_cone_t cone;
        for (int i = 0; i < side; i++) {
            square[count++] = (ocel_crack_t){(int16_t)(200 + 2 * i), 99};
        }
        for (int i = 0; i < side; i++) {
            square[count++] = (ocel_crack_t){(int16_t)(199 + 2 * side), (int16_t)(100 + 2 * i)};
        }
        for (int i = side - 1; i >= 0; i--) {
            square[count++] = (ocel_crack_t){(int16_t)(200 + 2 * i), (int16_t)(99 + 2 * side)};
        }
        for (int i = side - 1; i >= 0; i--) {
            square[count++] = (ocel_crack_t){199, (int16_t)(100 + 2 * i)};
        }
        cracks = square;
        TEST_ASSERT_NOT_EQUAL(OCEL_OK, ocel_cone_fit_cracks(&camera, cracks, count, &cone));
    }
}

static void degenerate_points_have_their_status(void) {
    static ocel_point_t points[100];
    ocel_cone_t cone;
    for (int kind = 0; kind < 4; kind++) { /* coincident, level, upright, slanting */
        for (int i = 0; i < 100; i++) {
            points[i].x_px_q16 = (100 << 16) + (((kind & 1) != 0) ? (i << 16) : 0);
            points[i].y_px_q16 = (60 << 16) + (((kind & 2) != 0) ? (i << 16) : 0);
        }
        memset(&cone, 0xA5, sizeof(cone));
        TEST_ASSERT_EQUAL_INT(OCEL_DEGENERATE, ocel_cone_fit_points(&camera, points, 100, &cone));
        TEST_ASSERT_TRUE(is_zero(&cone));
    }
}

static void mistakes_have_their_status(void) {
    static ocel_point_t points[64];
    static ocel_crack_t many[OCEL_MAX_FIT_POINTS + 1];
    const double axis[3] = {0.0, 0.0, 1.0};
    const ocel_camera_t blank = {0};
    ocel_cone_t cone;
    const size_t count = outline_points(&camera, axis, 0.15, 0.0, 1.0, 64, points);
    TEST_ASSERT_EQUAL_INT(OCEL_OK, ocel_cone_fit_points(&camera, points, count, &cone));
    TEST_ASSERT_EQUAL_INT(OCEL_NULL_ARGUMENT, ocel_cone_fit_points(NULL, points, count, &cone));
    TEST_ASSERT_TRUE(is_zero(&cone));
    TEST_ASSERT_EQUAL_INT(OCEL_NULL_ARGUMENT, ocel_cone_fit_points(&camera, NULL, count, &cone));
    TEST_ASSERT_EQUAL_INT(OCEL_NULL_ARGUMENT, ocel_cone_fit_cracks(&camera, NULL, count, &cone));
    TEST_ASSERT_EQUAL_INT(OCEL_NULL_ARGUMENT, ocel_cone_fit_points(&camera, points, count, NULL));
    TEST_ASSERT_EQUAL_INT(OCEL_BAD_ORDER, ocel_cone_fit_points(&blank, points, count, &cone));
    TEST_ASSERT_EQUAL_INT(OCEL_TOO_FEW_POINTS, ocel_cone_fit_points(&camera, points, 4, &cone));
    TEST_ASSERT_EQUAL_INT(OCEL_OVERFLOW,
                          ocel_cone_fit_cracks(&camera, many, OCEL_MAX_FIT_POINTS + 1U, &cone));
    points[1].x_px_q16 = -(2 << 16); /* outside the image, and no sample's neighbour */
    TEST_ASSERT_EQUAL_INT(OCEL_OUT_OF_RANGE, ocel_cone_fit_points(&camera, points, count, &cone));
    TEST_ASSERT_TRUE(is_zero(&cone));
}

/* Any points at all: a status, the same every time, and sane numbers. */
static void hostile_points_are_survived(void) {
    static ocel_point_t points[300];
    for (int i = 0; i < 20 * TRIALS; i++) {
        ocel_intrinsics_t in = {0};
        ocel_camera_t cam;
        ocel_cone_t cone;
        ocel_cone_t again;
        const uint32_t count = 5U + rng_below(&rng, 295U);
        const double spread = rng_log_uniform(&rng, 1e-4, 40000.0);
        const bool grid = rng_below(&rng, 3U) == 0U;
        in.fx_px_q16 = (int32_t)(rng_log_uniform(&rng, 16.0, 16384.0) * 65536.0);
        in.fy_px_q16 = (int32_t)(rng_log_uniform(&rng, 16.0, 16384.0) * 65536.0);
        in.cx_px_q16 = rng_between(&rng, -(1 << 30), 1 << 30) >> rng_below(&rng, 31U);
        in.cy_px_q16 = rng_between(&rng, -(1 << 30), 1 << 30) >> rng_below(&rng, 31U);
        in.p1_q24 = (rng_below(&rng, 4U) == 0U) ? 1000 : 0;
        if (ocel_camera_init(&cam, &in) != OCEL_OK) {
            continue;
        }
        for (uint32_t k = 0U; k < count; k++) {
            const double x = in.cx_px_q16 + 65536.0 * spread * rng_gauss(&rng);
            const double y = in.cy_px_q16 + 65536.0 * spread * rng_gauss(&rng);
            points[k].x_px_q16 = (int32_t)fmax(-2147483648.0, fmin(2147483647.0, x));
            points[k].y_px_q16 = (int32_t)fmax(-2147483648.0, fmin(2147483647.0, y));
            points[k].x_px_q16 &= grid ? ~0xFFFF : -1;
            points[k].y_px_q16 &= grid ? ~0xFFFF : -1;
        }
        const ocel_status_t status = ocel_cone_fit_points(&cam, points, count, &cone);
        TEST_ASSERT_EQUAL_INT(status, ocel_cone_fit_points(&cam, points, count, &again));
        TEST_ASSERT_EQUAL_MEMORY(&cone, &again, sizeof(cone));
        if ((status == OCEL_OK) || (status == OCEL_PARTIAL)) {
            double length = 0.0;
            for (int k = 0; k < 3; k++) {
                length += (cone.axis_cam_q30[k] / Q30) * (cone.axis_cam_q30[k] / Q30);
            }
            TEST_ASSERT_TRUE(fabs(length - 1.0) < 1e-7);
            TEST_ASSERT_TRUE((cone.sin_q30 > 0U) && (cone.sin_q30 < 1073741824U));
            TEST_ASSERT_TRUE(cone.inlier_count <= cone.point_count);
            TEST_ASSERT_TRUE((cone.hypothesis_count >= 1U) &&
                             (cone.hypothesis_count <= OCEL_CONE_HYPOTHESES));
            TEST_ASSERT_TRUE(cone.arc_coverage_q16 <= 65536U);
            TEST_ASSERT_TRUE((cone.cov_q60[OCEL_XX] >= 0) && (cone.cov_q60[OCEL_YY] >= 0) &&
                             (cone.cov_q60[OCEL_ZZ] >= 0));
        } else {
            TEST_ASSERT_TRUE(is_zero(&cone));
        }
    }
}

/* ---- The helpers ---- */

static void sectors_are_those_of_the_angle(void) {
    for (int i = 0; i < 100 * TRIALS; i++) {
        const int64_t x = rng_between(&rng, INT32_MIN, INT32_MAX);
        const int64_t y = rng_between(&rng, INT32_MIN, INT32_MAX);
        const double turn = atan2((double)y, (double)x) / (2.0 * SCENE_PI) * 32.0;
        const double within = fabs(turn - floor(turn) - 0.5);
        if (within < 0.499) {
            TEST_ASSERT_EQUAL_UINT32((uint32_t)((int)floor(turn) + 32) % 32U, ocel_sector_of(x, y));
        }
    }
}

static void covered_sectors_are_counted(void) {
    for (int i = 0; i < 20 * TRIALS; i++) {
        const uint32_t hit = rng_u32(&rng) & rng_u32(&rng) & rng_u32(&rng);
        const uint32_t gap = rng_below(&rng, 34U);
        uint32_t wanted = 0U;
        for (uint32_t k = 0U; k < 32U; k++) {
            uint32_t before = 0U; /* empty sectors before and from this one on */
            uint32_t after = 0U;
            while ((before < 32U) && ((hit & (1U << ((k + 32U - before) % 32U))) == 0U)) {
                before++;
            }
            while ((after < 32U) && ((hit & (1U << ((k + after) % 32U))) == 0U)) {
                after++;
            }
            wanted += ((before == 0U) || ((hit != 0U) && (before + after - 1U <= gap))) ? 1U : 0U;
        }
        TEST_ASSERT_EQUAL_UINT32(wanted, ocel_sectors_covered(hit, gap));
    }
}

static void symmetric_systems_are_solved(void) {
    double worst = 0.0;
    for (int i = 0; i < 20 * TRIALS; i++) {
        double m[3][3] = {{0.0}};
        double x[3];
        int64_t m_q60[OCEL_SYM3_COUNT];
        int64_t b_q60[3];
        int64_t x_q60[3] = {0, 0, 0};
        ocel_sym3_inverse_t inverse;
        for (int k = 0; k < 8; k++) {
            const double v[3] = {rng_uniform(&rng, -1.0, 1.0), rng_uniform(&rng, -1.0, 1.0), 1.0};
            for (int j = 0; j < 9; j++) {
                m[j / 3][j % 3] += v[j / 3] * v[j % 3] / 8.0;
            }
        }
        for (int k = 0; k < 3; k++) {
            x[k] = rng_uniform(&rng, -0.3, 0.3);
        }
        for (int j = 0, at = 0; j < 3; j++) {
            b_q60[j] = (int64_t)((m[j][0] * x[0] + m[j][1] * x[1] + m[j][2] * x[2]) * Q60);
            for (int k = j; k < 3; k++, at++) {
                m_q60[at] = (int64_t)(m[j][k] * Q60);
            }
        }
        TEST_ASSERT_TRUE(ocel_sym3_invert(m_q60, &inverse));
        TEST_ASSERT_TRUE(ocel_sym3_apply(&inverse, b_q60, x_q60));
        for (int k = 0; k < 3; k++) {
            worst = fmax(worst, fabs((double)x_q60[k] / Q60 - x[k]));
        }
    }
    TEST_ASSERT_TRUE(worst < 1e-11);
    const int64_t flat[OCEL_SYM3_COUNT] = {OCEL_XX, 0, 0, 0, 0, 0};
    ocel_sym3_inverse_t inverse;
    TEST_ASSERT_FALSE(ocel_sym3_invert(flat, &inverse));
}

int main(void) {
    printf("seed %d\n", SEED);
    UNITY_BEGIN();
    RUN_TEST(exact_outlines_give_their_cone);
    RUN_TEST(hidden_balls_keep_their_place);
    RUN_TEST(touching_balls_are_not_vouched_for_wrongly);
    RUN_TEST(order_does_not_matter_much);
    RUN_TEST(cracks_tell_more_than_their_midpoints);
    RUN_TEST(short_arcs_are_partial);
    RUN_TEST(squares_are_not_balls);
    RUN_TEST(degenerate_points_have_their_status);
    RUN_TEST(mistakes_have_their_status);
    RUN_TEST(hostile_points_are_survived);
    RUN_TEST(sectors_are_those_of_the_angle);
    RUN_TEST(covered_sectors_are_counted);
    RUN_TEST(symmetric_systems_are_solved);
    return UNITY_END();
}
