/* SPDX-License-Identifier: MIT
 *
 * Reference: the pinhole and the lens in long double, the lens undone by bisection
 * along the ray of pixels where it is radial.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <ocellus/camera.h>

#include "camera_ray.h"
#include "lens.h"
#include "rng.h"
#include "unity.h"

enum { SEED = 20110921, TRIALS = 200000, LENS_TRIALS = 20000 };

#define Q28 268435456.0L
#define Q30 1073741824.0L

static rng_t rng;

void setUp(void) {
    rng = rng_seed(SEED);
}

void tearDown(void) {
}

static int32_t px(double v) {
    return (int32_t)lround(v * 65536.0);
}

static int32_t q24(double v) {
    return (int32_t)lround(v * 16777216.0);
}

/* A square-pixel 640x480 camera; distortion 0. */
static ocel_intrinsics_t intrinsics(double f) {
    ocel_intrinsics_t in;
    memset(&in, 0, sizeof(in));
    in.fx_px_q16 = px(f);
    in.fy_px_q16 = px(f);
    in.cx_px_q16 = px(319.5);
    in.cy_px_q16 = px(239.5);
    in.width = 640U;
    in.height = 480U;
    return in;
}

static ocel_camera_t camera_of(const ocel_intrinsics_t *in) {
    ocel_camera_t camera;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_camera_init(&camera, in));
    return camera;
}

/* The lens as camera.h defines it. */
static void bend(const ocel_intrinsics_t *in, const long double xy[2], long double out[2]) {
    const long double one = 16777216.0L;
    const long double k1 = in->k1_q24 / one;
    const long double k2 = in->k2_q24 / one;
    const long double k3 = in->k3_q24 / one;
    const long double p1 = in->p1_q24 / one;
    const long double p2 = in->p2_q24 / one;
    const long double x = xy[0];
    const long double y = xy[1];
    const long double r2 = x * x + y * y;
    const long double f = 1.0L + k1 * r2 + k2 * r2 * r2 + k3 * r2 * r2 * r2;
    out[0] = x * f + 2.0L * p1 * x * y + p2 * (r2 + 2.0L * x * x);
    out[1] = y * f + p1 * (r2 + 2.0L * y * y) + 2.0L * p2 * x * y;
}

/* Where the reference sees a ray, px. */
static void see(const ocel_intrinsics_t *in, const long double xy[2], long double pixel[2]) {
    long double bent[2];
    bend(in, xy, bent);
    pixel[0] = (in->fx_px_q16 * bent[0] + in->cx_px_q16) / 65536.0L;
    pixel[1] = (in->fy_px_q16 * bent[1] + in->cy_px_q16) / 65536.0L;
}

/* Without distortion: slopes to half an LSB, over every focal length, aspect and
 * principal point. */
static void slopes_of_a_pinhole(void) {
    long double worst = 0.0L;
    int refused = 0;
    for (int i = 0; i < TRIALS; i++) {
        ocel_intrinsics_t in = intrinsics(1.0);
        in.fx_px_q16 = px(rng_log_uniform(&rng, 16.0, 16384.0));
        in.fy_px_q16 = px(rng_log_uniform(&rng, 16.0, 16384.0));
        in.cx_px_q16 = px(rng_uniform(&rng, -16384.0, 16384.0));
        in.cy_px_q16 = px(rng_uniform(&rng, -16384.0, 16384.0));
        in.width = 0U;
        in.height = 0U;
        const ocel_camera_t camera = camera_of(&in);
        int32_t v[2];
        for (int k = 0; k < 2; k++) {
            v[k] = rng_between(&rng, -1073741824, 1073741824);
        }
        const long double x = ((long double)v[0] - in.cx_px_q16) / in.fx_px_q16;
        const long double y = ((long double)v[1] - in.cy_px_q16) / in.fy_px_q16;
        int32_t xy_q28[2] = {7, 7};
        const bool seen = ocel_camera_normalise(&camera, v[0], v[1], xy_q28);
        const long double limit = tanl(acosl(-1.0L) * 80.0L / 180.0L);
        if (fabsl(hypotl(x, y) - limit) > 1e-7L) {
            TEST_ASSERT_EQUAL(hypotl(x, y) < limit, seen);
        }
        if (!seen) {
            refused++;
            TEST_ASSERT_EQUAL_INT32(7, xy_q28[0]);
            TEST_ASSERT_EQUAL_INT32(7, xy_q28[1]);
            continue;
        }
        worst = fmaxl(worst, fabsl(xy_q28[0] - x * Q28));
        worst = fmaxl(worst, fabsl(xy_q28[1] - y * Q28));
    }
    printf("slopes: worst %.4Lf LSB of Q28 (stated 0.51); %d of %d over 80 degrees\n", worst,
           refused, TRIALS);
    TEST_ASSERT_TRUE(worst < 0.51L);
    TEST_ASSERT_TRUE((refused > TRIALS / 20) && (refused < TRIALS));
}

/* The unit vector: along the pixel, of length 1. */
static void rays_of_a_pinhole(void) {
    long double worst = 0.0L;
    for (int i = 0; i < TRIALS; i++) {
        ocel_intrinsics_t in = intrinsics(rng_log_uniform(&rng, 60.0, 2000.0));
        in.fy_px_q16 = (int32_t)((double)in.fx_px_q16 * rng_uniform(&rng, 0.5, 2.0));
        const ocel_camera_t camera = camera_of(&in);
        const ocel_point_t pixel = {rng_between(&rng, -32768, 640 * 65536 - 32768),
                                    rng_between(&rng, -32768, 480 * 65536 - 32768)};
        const long double d[3] = {((long double)pixel.x_px_q16 - in.cx_px_q16) / in.fx_px_q16,
                                  ((long double)pixel.y_px_q16 - in.cy_px_q16) / in.fy_px_q16,
                                  1.0L};
        const long double length = sqrtl(d[0] * d[0] + d[1] * d[1] + 1.0L);
        int32_t ray[3];
        if (length > 5.7L) {
            continue; /* beyond 80 degrees, or so near it that either answer is right */
        }
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_camera_ray(&camera, &pixel, ray));
        for (int k = 0; k < 3; k++) {
            worst = fmaxl(worst, fabsl(ray[k] - d[k] / length * Q30));
        }
    }
    printf("rays: worst %.3Lf LSB of Q30\n", worst);
    TEST_ASSERT_TRUE(worst < 3.0L); /* half an LSB of a slope is 2 of Q30 */
}

/* x right, y down, z forward: the signs, one by one. */
static void signs_of_the_axes(void) {
    const ocel_intrinsics_t in = intrinsics(320.0);
    const ocel_camera_t camera = camera_of(&in);
    const ocel_point_t right = {px(319.5 + 320.0), px(239.5)};
    const ocel_point_t down = {px(319.5), px(239.5 + 120.0)};
    const ocel_point_t middle = {px(319.5), px(239.5)};
    int32_t d[3];
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_camera_ray(&camera, &middle, d));
    TEST_ASSERT_EQUAL_INT32(0, d[0]);
    TEST_ASSERT_EQUAL_INT32(0, d[1]);
    TEST_ASSERT_EQUAL_INT32(1 << 30, d[2]);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_camera_ray(&camera, &right, d));
    TEST_ASSERT_INT32_WITHIN(1, (int32_t)lroundl(sqrtl(0.5L) * Q30), d[0]);
    TEST_ASSERT_EQUAL_INT32(0, d[1]);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_camera_ray(&camera, &down, d));
    TEST_ASSERT_EQUAL_INT32(0, d[0]);
    TEST_ASSERT_TRUE((d[1] > 0) && (d[2] > d[1]));
}

/* Lenses of practice, and the brief's strong one; f for 640x480. */
typedef struct {
    const char *name;
    double f;
    double k1, k2, p1, p2, k3;
} lens_t;

static const lens_t LENSES[] = {{"strong barrel", 300.0, -0.35, 0.12, 0.0, 0.0, 0.0},
                                {"decentred", 300.0, -0.35, 0.12, 0.002, -0.001, 0.0},
                                {"stereo pair", 536.0, -0.265, -0.0467, 0.0018, -0.0003, 0.252},
                                {"pincushion", 300.0, 0.3, 0.0, 0.0, 0.0, 0.0},
                                {"strong pincushion", 300.0, 0.3, 0.2, 0.0, 0.0, 0.0},
                                {"wide", 257.0, -0.4, 0.16, 0.001, -0.001, 0.0},
                                {"badly decentred", 400.0, -0.2, 0.05, 0.02, -0.03, 0.0}};

enum { LENS_COUNT = sizeof(LENSES) / sizeof(LENSES[0]) };

static ocel_intrinsics_t intrinsics_of(const lens_t *lens) {
    ocel_intrinsics_t in = intrinsics(lens->f);
    in.fy_px_q16 = px(lens->f * 1.05);
    in.k1_q24 = q24(lens->k1);
    in.k2_q24 = q24(lens->k2);
    in.p1_q24 = q24(lens->p1);
    in.p2_q24 = q24(lens->p2);
    in.k3_q24 = q24(lens->k3);
    return in;
}

/* Every pixel of the image has a ray, and the lens puts that ray on the pixel. */
static void lenses_are_undone(void) {
    for (int n = 0; n < LENS_COUNT; n++) {
        const ocel_intrinsics_t in = intrinsics_of(&LENSES[n]);
        const ocel_camera_t camera = camera_of(&in);
        long double worst = 0.0L;
        for (int i = 0; i < LENS_TRIALS; i++) {
            const int32_t x = rng_between(&rng, -32768, 640 * 65536 - 32768);
            const int32_t y = rng_between(&rng, -32768, 480 * 65536 - 32768);
            int32_t xy_q28[2];
            if (!ocel_camera_normalise(&camera, x, y, xy_q28)) {
                printf("%s: (%.2f, %.2f) refused\n", LENSES[n].name, x / 65536.0, y / 65536.0);
                TEST_FAIL();
            }
            const long double xy[2] = {xy_q28[0] / Q28, xy_q28[1] / Q28};
            long double pixel[2];
            see(&in, xy, pixel);
            worst = fmaxl(worst, fabsl(pixel[0] - x / 65536.0L));
            worst = fmaxl(worst, fabsl(pixel[1] - y / 65536.0L));
        }
        printf("%-18s worst %.2Le px\n", LENSES[n].name, worst);
        TEST_ASSERT_TRUE(worst < 1e-5L);
    }
}

/* Points in space to pixels and back to the same direction. */
static void project_and_ray_are_inverse(void) {
    long double worst_px = 0.0L;
    long double worst_back = 0.0L;
    for (int n = -1; n < LENS_COUNT; n++) {
        ocel_intrinsics_t in = (n < 0) ? intrinsics(277.0) : intrinsics_of(&LENSES[n]);
        in.width = 0U;
        in.height = 0U;
        const ocel_camera_t camera = camera_of(&in);
        for (int i = 0; i < LENS_TRIALS; i++) {
            const double z = rng_log_uniform(&rng, 1000.0, 1e9);
            int32_t seen_q28[2];
            TEST_ASSERT_TRUE(ocel_camera_normalise(&camera, rng_between(&rng, 0, 639 << 16),
                                                   rng_between(&rng, 0, 479 << 16), seen_q28));
            const int32_t p[3] = {(int32_t)((double)seen_q28[0] / 268435456.0 * z),
                                  (int32_t)((double)seen_q28[1] / 268435456.0 * z), (int32_t)z};
            const long double xy[2] = {(long double)p[0] / p[2], (long double)p[1] / p[2]};
            const long double length = sqrtl(xy[0] * xy[0] + xy[1] * xy[1] + 1.0L);
            long double pixel[2];
            ocel_point_t got = {0, 0};
            int32_t ray[3];
            see(&in, xy, pixel);
            TEST_ASSERT_EQUAL(OCEL_OK, ocel_camera_project(&camera, p, &got));
            worst_px = fmaxl(worst_px, fabsl(got.x_px_q16 / 65536.0L - pixel[0]));
            worst_px = fmaxl(worst_px, fabsl(got.y_px_q16 / 65536.0L - pixel[1]));
            TEST_ASSERT_EQUAL(OCEL_OK, ocel_camera_ray(&camera, &got, ray));
            worst_back = fmaxl(worst_back, fabsl(ray[0] / Q30 - xy[0] / length) * LENSES[0].f);
            worst_back = fmaxl(worst_back, fabsl(ray[1] / Q30 - xy[1] / length) * LENSES[0].f);
            worst_back = fmaxl(worst_back, fabsl(ray[2] / Q30 - 1.0L / length) * LENSES[0].f);
        }
    }
    printf("project: worst %.2Le px; there and back, by 300 px: %.2Le\n", worst_px, worst_back);
    TEST_ASSERT_TRUE(worst_px < 2e-5L);
    TEST_ASSERT_TRUE(worst_back < 1e-4L);
}

int main(void) {
    printf("seed %d\n", SEED);
    UNITY_BEGIN();
    RUN_TEST(slopes_of_a_pinhole);
    RUN_TEST(rays_of_a_pinhole);
    RUN_TEST(signs_of_the_axes);
    RUN_TEST(lenses_are_undone);
    RUN_TEST(project_and_ray_are_inverse);
    return UNITY_END();
}
