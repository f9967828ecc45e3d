/* SPDX-License-Identifier: MIT
 *
 * Reference: the pinhole and the lens in long double.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <ocellus/camera.h>

#include "base/camera_ray.h"
#include "base/lens.h"
#include "board.h"
#include "rng.h"
#include "unity.h"

enum { SEED = 20110921, TRIALS = TEST_TRIALS(200000), LENS_TRIALS = TEST_TRIALS(20000) };

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
    printf("slopes: worst %.4f LSB of Q28 (stated 0.51); %d of %d over 80 degrees\n", (double)worst,
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
    printf("rays: worst %.3f LSB of Q30\n", (double)worst);
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
        printf("%-18s worst %.2e px\n", LENSES[n].name, (double)worst);
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
    printf("project: worst %.2e px; there and back, by 300 px: %.2e\n", (double)worst_px,
           (double)worst_back);
    TEST_ASSERT_TRUE(worst_px < 2e-5L);
    TEST_ASSERT_TRUE(worst_back < 1e-4L);
}

/* Beyond the fold of a barrel lens two rays, or none, lead to a pixel: what has an
 * answer has the near one, and what lies outside the image of the fold has none. */
static void no_ray_beyond_the_fold(void) {
    ocel_intrinsics_t in = intrinsics(300.0);
    in.k1_q24 = q24(-0.35);
    const ocel_camera_t camera = camera_of(&in);
    const double fold = sqrt(1.0 / (3.0 * 0.35)); /* where 1 - 3 * .35 r^2 = 0 */
    const double rim_px = 300.0 * fold * (1.0 - 0.35 * fold * fold);
    int seen = 0;
    for (int i = 0; i < LENS_TRIALS; i++) {
        const double x = rng_uniform(&rng, -0.5, 639.5);
        const double y = rng_uniform(&rng, -0.5, 479.5);
        const double off = hypot(x - 319.5, y - 239.5);
        int32_t xy_q28[2];
        if (ocel_camera_normalise(&camera, px(x), px(y), xy_q28)) {
            TEST_ASSERT_TRUE(hypot(xy_q28[0], xy_q28[1]) < fold * 268435456.0);
            TEST_ASSERT_TRUE(off < rim_px + 1.0 / 32.0);
            seen++;
        } else {
            TEST_ASSERT_TRUE(off > rim_px - 2.0);
        }
    }
    TEST_ASSERT_TRUE((seen > LENS_TRIALS / 4) && (seen < LENS_TRIALS));
    const int32_t inside[3] = {(int32_t)(1e6 * (fold - 0.02)), 0, 1000000};
    const int32_t beyond[3] = {(int32_t)(1e6 * (fold + 0.02)), 0, 1000000};
    ocel_point_t pixel = {1, 1};
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_camera_project(&camera, inside, &pixel));
    TEST_ASSERT_EQUAL(OCEL_OUT_OF_RANGE, ocel_camera_project(&camera, beyond, &pixel));
    TEST_ASSERT_EQUAL_INT32(0, pixel.x_px_q16);
}

/* Coefficients within their range but of no lens, pixels anywhere: an answer is
 * right to 1/64 px, and otherwise there is none. */
static void any_coefficients_are_safe(void) {
    int seen = 0;
    for (int i = 0; i < TRIALS; i++) {
        ocel_intrinsics_t in = intrinsics(rng_log_uniform(&rng, 16.0, 16384.0));
        int32_t *const k[5] = {&in.k1_q24, &in.k2_q24, &in.p1_q24, &in.p2_q24, &in.k3_q24};
        for (int n = 0; n < 5; n++) {
            const double size = rng_log_uniform(&rng, 1e-6, 16.0);
            *k[n] = ((rng_u32(&rng) % 4U) == 0U) ? 0 : q24((rng_u32(&rng) & 1U) ? size : -size);
        }
        in.width = 0U;
        in.height = 0U;
        ocel_camera_t camera;
        if ((i % 16) != 0) { /* reach costs most of the time */
            in.k2_q24 = 0;
        }
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_camera_init(&camera, &in));
        const int32_t v[2] = {in.cx_px_q16 + (int32_t)(in.fx_px_q16 * rng_uniform(&rng, -0.9, 0.9)),
                              in.cy_px_q16 +
                                  (int32_t)(in.fy_px_q16 * rng_uniform(&rng, -0.9, 0.9))};
        int32_t xy_q28[2];
        if (ocel_camera_normalise(&camera, v[0], v[1], xy_q28)) {
            const long double xy[2] = {xy_q28[0] / Q28, xy_q28[1] / Q28};
            long double pixel[2];
            seen++;
            see(&in, xy, pixel);
            for (int n = 0; n < 2; n++) {
                /* The check is made before slopes are rounded to 32 bits. */
                TEST_ASSERT_TRUE(fabsl(pixel[n] - v[n] / 65536.0L) < 1.0L / 60.0L);
            }
        }
        const int32_t p[3] = {(int32_t)rng_u32(&rng) >> rng_below(&rng, 31U),
                              (int32_t)rng_u32(&rng) >> rng_below(&rng, 31U),
                              (int32_t)rng_u32(&rng) >> rng_below(&rng, 31U)};
        ocel_point_t got = {1, 1};
        if (ocel_camera_project(&camera, p, &got) == OCEL_OK) {
            const long double xy[2] = {(long double)p[0] / p[2], (long double)p[1] / p[2]};
            long double pixel[2];
            see(&in, xy, pixel);
            const long double tolerance = 1e-4L + 1e-7L * hypotl(pixel[0], pixel[1]);
            TEST_ASSERT_TRUE(p[2] > 0);
            TEST_ASSERT_TRUE(fabsl(got.x_px_q16 / 65536.0L - pixel[0]) < tolerance * 200.0L);
            TEST_ASSERT_TRUE(fabsl(got.y_px_q16 / 65536.0L - pixel[1]) < tolerance * 200.0L);
        } else {
            TEST_ASSERT_EQUAL_INT32(0, got.x_px_q16);
            TEST_ASSERT_EQUAL_INT32(0, got.y_px_q16);
        }
    }
    printf("any coefficients: %d of %d pixels have a ray\n", seen, TRIALS);
    TEST_ASSERT_TRUE(seen > TRIALS / 10);
}

/* Half a pixel beyond the centres of the outermost ones belongs to them, no more. */
static void the_image_ends_at_its_edge(void) {
    static const int32_t EDGE[2][2] = {{-32768, 640 * 65536 - 32768},
                                       {-32768, 480 * 65536 - 32768}};
    const ocel_intrinsics_t in = intrinsics(300.0);
    const ocel_camera_t camera = camera_of(&in);
    int32_t d[3];
    for (int axis = 0; axis < 2; axis++) {
        for (int end = 0; end < 2; end++) {
            int32_t v[2] = {px(319.5), px(239.5)};
            v[axis] = EDGE[axis][end];
            const ocel_point_t on = {v[0], v[1]};
            v[axis] += (end == 0) ? -1 : 1;
            const ocel_point_t off = {v[0], v[1]};
            TEST_ASSERT_EQUAL(OCEL_OK, ocel_camera_ray(&camera, &on, d));
            TEST_ASSERT_EQUAL(OCEL_OUT_OF_RANGE, ocel_camera_ray(&camera, &off, d));
            TEST_ASSERT_EQUAL_INT32(0, d[0] | d[1] | d[2]);
        }
    }
    static const int32_t FAR[4] = {INT32_MIN, INT32_MAX, INT32_MIN + 1, 1073741825};
    for (int i = 0; i < 4; i++) {
        const ocel_point_t x = {FAR[i], px(239.5)};
        const ocel_point_t y = {px(319.5), FAR[i]};
        TEST_ASSERT_EQUAL(OCEL_OUT_OF_RANGE, ocel_camera_ray(&camera, &x, d));
        TEST_ASSERT_EQUAL(OCEL_OUT_OF_RANGE, ocel_camera_ray(&camera, &y, d));
    }
}

/* One intrinsic out of its range at a time. */
static void intrinsics_out_of_range(void) {
    const int32_t one_px = 65536;
    const int32_t too_much = q24(16.0) + 1;
    ocel_intrinsics_t bad[32];
    int count = 0;
    for (int i = 0; i < 32; i++) {
        bad[i] = intrinsics(300.0);
    }
    bad[count++].fx_px_q16 = 0;
    bad[count++].fy_px_q16 = 0;
    bad[count++].fx_px_q16 = -300 * one_px;
    bad[count++].fy_px_q16 = INT32_MIN;
    bad[count++].fx_px_q16 = 16 * one_px - 1;
    bad[count++].fy_px_q16 = 16384 * one_px + 1;
    bad[count++].fx_px_q16 = INT32_MAX;
    bad[count].width = 0U;
    bad[count++].cx_px_q16 = 16384 * one_px + 1;
    bad[count++].cy_px_q16 = INT32_MIN;
    bad[count++].k1_q24 = too_much;
    bad[count++].k2_q24 = -too_much;
    bad[count++].p1_q24 = INT32_MIN;
    bad[count++].p2_q24 = INT32_MAX;
    bad[count++].k3_q24 = too_much;
    bad[count++].width = 16385U;
    bad[count++].height = 65535U;
    bad[count++].cx_px_q16 = -16000 * one_px; /* all of the image over 80 degrees off */
    for (int i = 0; i < count; i++) {
        ocel_camera_t camera;
        ocel_point_t pixel = {0, 0};
        int32_t d[3] = {1, 1, 1};
        const int32_t p[3] = {0, 0, 1};
        memset(&camera, 0x5A, sizeof(camera));
        TEST_ASSERT_EQUAL_MESSAGE(OCEL_OUT_OF_RANGE, ocel_camera_init(&camera, &bad[i]), "init");
        TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_camera_ray(&camera, &pixel, d));
        TEST_ASSERT_EQUAL_INT32(0, d[0] | d[1] | d[2]);
        TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_camera_project(&camera, p, &pixel));
    }
    ocel_intrinsics_t edge = intrinsics(16.0); /* the ends of the ranges themselves */
    ocel_camera_t camera;
    edge.k1_q24 = q24(16.0);
    edge.k3_q24 = -q24(16.0);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_camera_init(&camera, &edge));
    edge = intrinsics(16384.0);
    edge.cx_px_q16 = -16384 * one_px;
    edge.width = 16384U;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_camera_init(&camera, &edge));
}

static void null_arguments(void) {
    const ocel_intrinsics_t in = intrinsics(300.0);
    ocel_camera_t camera = camera_of(&in);
    ocel_point_t pixel = {0, 0};
    int32_t v[3] = {0, 0, 1};
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_camera_init(NULL, &in));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_camera_ray(NULL, &pixel, v));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_camera_ray(&camera, NULL, v));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_camera_ray(&camera, &pixel, NULL));
    v[2] = 1;
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_camera_project(NULL, v, &pixel));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_camera_project(&camera, NULL, &pixel));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_camera_project(&camera, v, NULL));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_camera_init(&camera, NULL));
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_camera_ray(&camera, &pixel, v));
}

/* In front is in front: z of 0 and below has no pixel, the least z has one. */
static void only_what_is_ahead_is_seen(void) {
    const ocel_intrinsics_t in = intrinsics(300.0);
    const ocel_camera_t camera = camera_of(&in);
    static const int32_t UNSEEN[][3] = {{0, 0, 0},         {0, 0, -1},        {1, 1, INT32_MIN},
                                        {6, 0, 1},         {INT32_MIN, 0, 1}, {INT32_MAX, 0, 1},
                                        {0, INT32_MIN, 1}, {100, 100, -1000}};
    ocel_point_t pixel = {1, 1};
    for (size_t i = 0; i < sizeof(UNSEEN) / sizeof(UNSEEN[0]); i++) {
        TEST_ASSERT_EQUAL(OCEL_OUT_OF_RANGE, ocel_camera_project(&camera, UNSEEN[i], &pixel));
    }
    const int32_t near[3] = {1, -1, 1};
    const int32_t far[3] = {INT32_MAX, INT32_MIN + 1, INT32_MAX};
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_camera_project(&camera, near, &pixel));
    TEST_ASSERT_EQUAL_INT32(px(619.5), pixel.x_px_q16);
    TEST_ASSERT_EQUAL_INT32(px(-60.5), pixel.y_px_q16);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_camera_project(&camera, far, &pixel));
    TEST_ASSERT_EQUAL_INT32(px(619.5), pixel.x_px_q16);
}

int main(void) {
    printf("seed %d\n", SEED);
    UNITY_BEGIN();
    RUN_TEST(slopes_of_a_pinhole);
    RUN_TEST(rays_of_a_pinhole);
    RUN_TEST(signs_of_the_axes);
    RUN_TEST(lenses_are_undone);
    RUN_TEST(project_and_ray_are_inverse);
    RUN_TEST(no_ray_beyond_the_fold);
    RUN_TEST(any_coefficients_are_safe);
    RUN_TEST(the_image_ends_at_its_edge);
    RUN_TEST(intrinsics_out_of_range);
    RUN_TEST(null_arguments);
    RUN_TEST(only_what_is_ahead_is_seen);
    return UNITY_END();
}
