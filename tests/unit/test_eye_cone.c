/* SPDX-License-Identifier: MIT
 *
 * The ball in space from the eye's boundary: masks rendered pixel by pixel from the
 * ball's cone, and each status with its cause.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <ocellus/eye.h>
#include <ocellus/sphere.h>

#include "board.h"
#include "masks.h"
#include "unity.h"

enum { SEED = 20111020, W = 320, H = 240 };

/* The iCub's eye and its ball, in micrometres. */
#define FOCAL_PX 257.34
#define RADIUS_U 33100

static ocel_eye_t eye;
static ocel_camera_t camera;
static ocel_detection_t detection;
static ocel_cone_t cone;
static ocel_cone_t zero;
static mask_t mask;
static rng_t rng;

static ocel_intrinsics_t intrinsics(void) {
    ocel_intrinsics_t in;
    memset(&in, 0, sizeof(in));
    in.fx_px_q16 = (int32_t)lround(FOCAL_PX * 65536.0);
    in.fy_px_q16 = in.fx_px_q16;
    in.cx_px_q16 = 160 * 65536;
    in.cy_px_q16 = 120 * 65536;
    in.width = W;
    in.height = H;
    return in;
}

void setUp(void) {
    const ocel_intrinsics_t in = intrinsics();
    ocel_eye_config_t config;
    rng = rng_seed(SEED);
    memset(&config, 0, sizeof(config));
    config.width = W;
    config.height = H;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_init(&eye, &config));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_camera_init(&camera, &in));
    memset(&zero, 0, sizeof(zero));
    memset(&cone, 0x55, sizeof(cone));
    mask_clear(&mask, W, H);
}

void tearDown(void) {
}

/* The pixels whose centre's ray meets the ball. */
static void draw_ball(double x, double y, double z, double radius) {
    const double square = x * x + y * y + z * z;
    for (int v = 0; v < H; v++) {
        for (int u = 0; u < W; u++) {
            const double dx = (u - 160.0) / FOCAL_PX;
            const double dy = (v - 120.0) / FOCAL_PX;
            const double along = x * dx + y * dy + z;
            const double near = along * along / (dx * dx + dy * dy + 1.0);
            mask_set(&mask, u, v, (along > 0.0) && (square - near <= radius * radius));
        }
    }
}

static ocel_status_t look(void) {
    uint32_t row[OCEL_ROW_WORDS];
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_begin(&eye));
    for (int y = 0; y < H; y++) {
        memset(row, 0, sizeof(row));
        for (int x = 0; x < W; x++) {
            row[x / 32] |= (mask_get(&mask, x, y) ? 1U : 0U) << (x % 32);
        }
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_row(&eye, (uint16_t)y, row));
    }
    return ocel_eye_end(&eye, &detection);
}

/* The error of the centre over its distance. */
static double error_at(double x, double y, double z) {
    ocel_sphere_t sphere;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_sphere_of_cone(&cone, RADIUS_U, &sphere));
    const double dx = sphere.p_cam_u[0] - x;
    const double dy = sphere.p_cam_u[1] - y;
    const double dz = sphere.p_cam_u[2] - z;
    return sqrt((dx * dx + dy * dy + dz * dz) / (x * x + y * y + z * z));
}

static void a_ball_is_placed(void) {
    double worst = 0.0;
    for (int i = 0; i < TEST_TRIALS_AT_LEAST(4, 60); i++) {
        const double z = rng_uniform(&rng, 2e5, 5e5);
        const double x = z * rng_uniform(&rng, -0.3, 0.3);
        const double y = z * rng_uniform(&rng, -0.2, 0.2);
        mask_clear(&mask, W, H);
        draw_ball(x, y, z, RADIUS_U);
        TEST_ASSERT_EQUAL(OCEL_OK, look());
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_cone(&eye, &camera, &detection, &cone));
        TEST_ASSERT_EQUAL_UINT32(detection.boundary_count, cone.point_count);
        TEST_ASSERT_TRUE(cone.inlier_count * 10U > cone.point_count * 9U);
        worst = fmax(worst, error_at(x, y, z));
    }
    printf("whole balls: worst error %.2e of the range\n", worst);
    TEST_ASSERT_TRUE(worst < 0.01);
}

/* Half of it behind a straight edge: what is vouched for is right. */
static void a_half_hidden_ball_is_placed(void) {
    int vouched = 0;
    const int trials = TEST_TRIALS_AT_LEAST(4, 40);
    for (int i = 0; i < trials; i++) {
        const double z = rng_uniform(&rng, 2e5, 4e5);
        const double x = z * rng_uniform(&rng, -0.3, 0.3);
        const double y = z * rng_uniform(&rng, -0.2, 0.2);
        mask_clear(&mask, W, H);
        draw_ball(x, y, z, RADIUS_U);
        mask_box(&mask, 160 + (int)(FOCAL_PX * x / z), 0, W, H, false);
        (void)look();
        const ocel_status_t status = ocel_eye_cone(&eye, &camera, &detection, &cone);
        TEST_ASSERT_TRUE((status == OCEL_OK) || (status == OCEL_PARTIAL));
        if (status == OCEL_OK) {
            TEST_ASSERT_TRUE(error_at(x, y, z) < 0.02);
            vouched++;
        }
    }
    printf("half hidden: %d of %d vouched for\n", vouched, trials);
    TEST_ASSERT_TRUE(vouched > trials / 2);
}

/* Cut by the image's edge: vouched for, or clipped; never partial. */
static void a_cut_ball_is_ok_or_clipped(void) {
    int clipped = 0;
    const int trials = TEST_TRIALS_AT_LEAST(4, 60);
    for (int i = 0; i < trials; i++) {
        const double z = 2.5e5;
        const double edge = -160.0 / FOCAL_PX;
        const double x = z * (edge + ((i == 0) ? -0.135 : rng_uniform(&rng, -0.125, 0.05)));
        mask_clear(&mask, W, H);
        draw_ball(x, 0.0, z, RADIUS_U);
        if (look() != OCEL_CLIPPED) {
            continue;
        }
        const ocel_status_t status = ocel_eye_cone(&eye, &camera, &detection, &cone);
        TEST_ASSERT_TRUE((status == OCEL_OK) || (status == OCEL_CLIPPED));
        clipped += (status == OCEL_CLIPPED) ? 1 : 0;
        if (status == OCEL_OK) {
            TEST_ASSERT_TRUE(error_at(x, 0.0, z) < 0.05);
        } else if (cone.sin_q30 == 0U) {
            TEST_ASSERT_EQUAL_MEMORY(&zero, &cone, sizeof(cone));
        } else {
            TEST_ASSERT_TRUE(cone.point_count > 0U);
        }
    }
    printf("cut by the edge: %d of %d clipped\n", clipped, trials);
    TEST_ASSERT_TRUE((clipped > 0) && (clipped < trials));
}

/* A covered camera has no ball: no estimate, not even the last one. */
static void a_covered_camera_has_none(void) {
    mask_box(&mask, 0, 0, W, H, true);
    TEST_ASSERT_EQUAL(OCEL_CLIPPED, look());
    TEST_ASSERT_EQUAL(OCEL_CLIPPED, ocel_eye_cone(&eye, &camera, &detection, &cone));
    TEST_ASSERT_EQUAL_MEMORY(&zero, &cone, sizeof(cone));
    mask_clear(&mask, W, H);
    memset(&cone, 0x55, sizeof(cone));
    TEST_ASSERT_EQUAL(OCEL_NOT_SEEN, look());
    TEST_ASSERT_EQUAL(OCEL_NOT_SEEN, ocel_eye_cone(&eye, &camera, &detection, &cone));
    TEST_ASSERT_EQUAL_MEMORY(&zero, &cone, sizeof(cone));
}

/* Few cracks of a clipped blob are left beside the edge. */
static void a_sliver_at_the_edge_is_clipped(void) {
    mask_box(&mask, 0, 0, W, 1, true);
    mask_box(&mask, 0, 0, 1, H, true);
    mask_box(&mask, 0, H - 1, W, 1, true);
    mask_box(&mask, W - 1, 0, 1, H, true);
    mask_box(&mask, 0, 0, W, H - 1, true);
    mask_box(&mask, 100, H - 1, 2, 1, false);
    TEST_ASSERT_EQUAL(OCEL_CLIPPED, look());
    TEST_ASSERT_EQUAL_UINT32(4U, detection.boundary_count);
    TEST_ASSERT_EQUAL(OCEL_CLIPPED, ocel_eye_cone(&eye, &camera, &detection, &cone));
    TEST_ASSERT_EQUAL_MEMORY(&zero, &cone, sizeof(cone));
}

/* A wall that fills half of the image has a straight border and no cone; a bar away
 * from the edges is what the fit says it is. */
static void straight_borders_have_no_cone(void) {
    size_t count = 0U;
    mask_box(&mask, 0, 0, 100, H, true);
    TEST_ASSERT_EQUAL(OCEL_CLIPPED, look());
    const ocel_crack_t *cracks = ocel_eye_boundary(&eye, &count);
    TEST_ASSERT_EQUAL(OCEL_DEGENERATE, ocel_cone_fit_cracks(&camera, cracks, count, &cone));
    TEST_ASSERT_EQUAL(OCEL_CLIPPED, ocel_eye_cone(&eye, &camera, &detection, &cone));
    TEST_ASSERT_EQUAL_MEMORY(&zero, &cone, sizeof(cone));
    mask_clear(&mask, W, H);
    mask_box(&mask, 100, 100, 60, 60, true);
    TEST_ASSERT_EQUAL(OCEL_PARTIAL, look());
    cracks = ocel_eye_boundary(&eye, &count);
    const ocel_status_t status = ocel_cone_fit_cracks(&camera, cracks, count, &cone);
    TEST_ASSERT_TRUE((status == OCEL_PARTIAL) || (status == OCEL_DEGENERATE));
    TEST_ASSERT_EQUAL(status, ocel_eye_cone(&eye, &camera, &detection, &cone));
}

static void a_lost_boundary_is_an_overflow(void) {
    for (int x = 2; x < W - 2; x += 2) { /* a comb: more cracks than the pool holds */
        mask_box(&mask, x, 2, 1, H - 6, true);
    }
    mask_box(&mask, 2, H - 4, W - 4, 1, true);
    TEST_ASSERT_EQUAL(OCEL_OVERFLOW, look());
    TEST_ASSERT_EQUAL(OCEL_OVERFLOW, ocel_eye_cone(&eye, &camera, &detection, &cone));
    TEST_ASSERT_EQUAL_MEMORY(&zero, &cone, sizeof(cone));
}

/* A camera whose image is smaller than the eye's is not the frame's, clipped or not. */
static void a_camera_of_another_size_is_out_of_range(void) {
    ocel_intrinsics_t in = intrinsics();
    in.width = 100U;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_camera_init(&camera, &in));
    draw_ball(0.0, 0.0, 3e5, RADIUS_U);
    TEST_ASSERT_EQUAL(OCEL_OK, look());
    TEST_ASSERT_EQUAL(OCEL_OUT_OF_RANGE, ocel_eye_cone(&eye, &camera, &detection, &cone));
    TEST_ASSERT_EQUAL_MEMORY(&zero, &cone, sizeof(cone));
    mask_clear(&mask, W, H);
    draw_ball(1.85e5, 0.0, 3e5, RADIUS_U);
    TEST_ASSERT_EQUAL(OCEL_CLIPPED, look());
    TEST_ASSERT_EQUAL(OCEL_OUT_OF_RANGE, ocel_eye_cone(&eye, &camera, &detection, &cone));
}

static void calls_out_of_order(void) {
    ocel_camera_t unready;
    memset(&unready, 0, sizeof(unready));
    memset(&detection, 0, sizeof(detection));
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_eye_cone(&eye, &camera, &detection, &cone));
    TEST_ASSERT_EQUAL_MEMORY(&zero, &cone, sizeof(cone));
    draw_ball(0.0, 0.0, 3e5, RADIUS_U);
    TEST_ASSERT_EQUAL(OCEL_OK, look());
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_eye_cone(&eye, &unready, &detection, &cone));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_cone(&eye, &camera, &detection, &cone));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_begin(&eye)); /* the boundary goes */
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_eye_cone(&eye, &camera, &detection, &cone));
    TEST_ASSERT_EQUAL_MEMORY(&zero, &cone, sizeof(cone));
    mask_box(&mask, 0, 0, 40, H, true); /* clipped, and its boundary gone too */
    TEST_ASSERT_EQUAL(OCEL_CLIPPED, look());
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_begin(&eye));
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_eye_cone(&eye, &camera, &detection, &cone));
}

static void null_arguments(void) {
    draw_ball(0.0, 0.0, 3e5, RADIUS_U);
    TEST_ASSERT_EQUAL(OCEL_OK, look());
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_eye_cone(NULL, &camera, &detection, &cone));
    TEST_ASSERT_EQUAL_MEMORY(&zero, &cone, sizeof(cone));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_eye_cone(&eye, NULL, &detection, &cone));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_eye_cone(&eye, &camera, NULL, &cone));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_eye_cone(&eye, &camera, &detection, NULL));
}

int main(void) {
    printf("seed %d\n", SEED);
    UNITY_BEGIN();
    RUN_TEST(a_ball_is_placed);
    RUN_TEST(a_half_hidden_ball_is_placed);
    RUN_TEST(a_cut_ball_is_ok_or_clipped);
    RUN_TEST(a_covered_camera_has_none);
    RUN_TEST(a_sliver_at_the_edge_is_clipped);
    RUN_TEST(straight_borders_have_no_cone);
    RUN_TEST(a_lost_boundary_is_an_overflow);
    RUN_TEST(a_camera_of_another_size_is_out_of_range);
    RUN_TEST(calls_out_of_order);
    RUN_TEST(null_arguments);
    return UNITY_END();
}
