/* SPDX-License-Identifier: MIT
 *
 * A cone's outline and the cone of an outline.  Reference: the rays of the cone
 * themselves, projected in long double; they must lie on the ellipse.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <ocellus/cone.h>
#include <ocellus/sphere.h>

#include "fit_support.h"
#include "rng.h"
#include "unity.h"

enum { SEED = 20100606, TRIALS = 20000, RAYS = 24 };

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

static ocel_camera_t camera_of(double fx, double fy, double cx, double cy) {
    ocel_intrinsics_t in;
    ocel_camera_t camera;
    memset(&in, 0, sizeof(in));
    in.fx_px_q16 = px(fx);
    in.fy_px_q16 = px(fy);
    in.cx_px_q16 = px(cx);
    in.cy_px_q16 = px(cy);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_camera_init(&camera, &in));
    return camera;
}

/* The cone of a ball at c with radius r. */
static ocel_cone_t cone_of(double x, double y, double z, double r) {
    const double range = sqrt(x * x + y * y + z * z);
    ocel_cone_t cone;
    memset(&cone, 0, sizeof(cone));
    cone.axis_cam_q30[0] = (int32_t)lround(x / range * 1073741824.0);
    cone.axis_cam_q30[1] = (int32_t)lround(y / range * 1073741824.0);
    cone.axis_cam_q30[2] = (int32_t)lround(z / range * 1073741824.0);
    cone.sin_q30 = (uint32_t)lround(r / range * 1073741824.0);
    return cone;
}

typedef struct {
    long double x;
    long double y;
} spot_t;

/* Where the camera sees ray k of the cone's RAYS. */
static spot_t ray_of(const ocel_camera_t *camera, const ocel_cone_t *cone, int k) {
    const ocel_intrinsics_t *in = &camera->intrinsics;
    const long double phi = 2.0L * acosl(-1.0L) * k / RAYS;
    const long double s = cone->sin_q30 / Q30;
    const long double n[3] = {cone->axis_cam_q30[0] / Q30, cone->axis_cam_q30[1] / Q30,
                              cone->axis_cam_q30[2] / Q30};
    const int thin = (fabsl(n[0]) < 0.6L) ? 0 : 1;
    long double u[3] = {-n[0] * n[thin], -n[1] * n[thin], -n[2] * n[thin]};
    u[thin] += 1.0L;
    const long double length = sqrtl(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    for (int i = 0; i < 3; i++) {
        u[i] /= length;
    }
    const long double v[3] = {n[1] * u[2] - n[2] * u[1], n[2] * u[0] - n[0] * u[2],
                              n[0] * u[1] - n[1] * u[0]};
    long double d[3];
    for (int i = 0; i < 3; i++) {
        d[i] = n[i] * sqrtl(1.0L - s * s) + s * (u[i] * cosl(phi) + v[i] * sinl(phi));
    }
    const spot_t spot = {(in->fx_px_q16 * d[0] / d[2] + in->cx_px_q16) / 65536.0L,
                         (in->fy_px_q16 * d[1] / d[2] + in->cy_px_q16) / 65536.0L};
    return spot;
}

/* How far a spot is off the ellipse, to first order, px. */
static long double off_ellipse(const ocel_ellipse_t *e, spot_t p) {
    const long double angle = 2.0L * acosl(-1.0L) * e->angle_turn_q32 / 4294967296.0L;
    const long double a = e->a_px_q16 / 65536.0L;
    const long double b = e->b_px_q16 / 65536.0L;
    const long double dx = p.x - e->cx_px_q16 / 65536.0L;
    const long double dy = p.y - e->cy_px_q16 / 65536.0L;
    const long double u = (dx * cosl(angle) + dy * sinl(angle)) / a;
    const long double v = (dy * cosl(angle) - dx * sinl(angle)) / b;
    return (u * u + v * v - 1.0L) / (2.0L * hypotl(u / a, v / b));
}

/* facts.md's vectors: centre, R to ellipse (f = 257.34, c = (160, 120)). */
typedef struct {
    double x, y, z, r;
    double cx, cy, a, b, angle_deg;
} vector_t;

static const vector_t VECTORS[2] = {
    {.1, .0, .4, .0331, 224.7786, 120.0, 22.0303, 21.3682, 0.0},
    {.1, .06, .3, .0331, 246.8371, 172.1023, 30.6749, 28.5676, 30.964}};

static void outlines_of_the_vectors(void) {
    const ocel_camera_t camera = camera_of(257.34, 257.34, 160.0, 120.0);
    for (int i = 0; i < 2; i++) {
        const vector_t *v = &VECTORS[i];
        ocel_cone_t cone = cone_of(v->x, v->y, v->z, v->r);
        ocel_ellipse_t e;
        cone.rms_px_q16 = 123U;
        cone.arc_coverage_q16 = 456U;
        cone.inlier_count = 78U;
        cone.point_count = 99U;
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_cone_outline(&camera, &cone, &e));
        TEST_ASSERT_TRUE(fabs(e.cx_px_q16 / 65536.0 - v->cx) < 6e-5);
        TEST_ASSERT_TRUE(fabs(e.cy_px_q16 / 65536.0 - v->cy) < 6e-5);
        TEST_ASSERT_TRUE(fabs(e.a_px_q16 / 65536.0 - v->a) < 6e-5);
        TEST_ASSERT_TRUE(fabs(e.b_px_q16 / 65536.0 - v->b) < 6e-5);
        TEST_ASSERT_TRUE(fabs(e.angle_turn_q32 * (360.0 / 4294967296.0) - v->angle_deg) < 6e-4);
        TEST_ASSERT_EQUAL_UINT32(123U, e.rms_px_q16);
        TEST_ASSERT_EQUAL_UINT32(456U, e.arc_coverage_q16);
        TEST_ASSERT_EQUAL_UINT32(78U, e.point_count);
    }
}

/* A camera and a ball before it, up to 60 degrees off, of 3 to 500 px. */
static ocel_cone_t any_view(ocel_camera_t *camera) {
    const double fx = rng_log_uniform(&rng, 60.0, 3000.0);
    const double fy = fx * rng_uniform(&rng, 0.5, 2.0);
    const double r = rng_log_uniform(&rng, 3.0, 300.0) / fx;
    const double s = fmin(0.8, r / sqrt(1.0 + r * r));
    *camera = camera_of(fx, fy, rng_uniform(&rng, 0.0, 640.0), rng_uniform(&rng, 0.0, 480.0));
    double x = 0.0;
    double y = 0.0;
    double reach = 0.0;
    do { /* all of the cone within 70 degrees */
        x = rng_uniform(&rng, -1.7, 1.7);
        y = rng_uniform(&rng, -1.7, 1.7);
        reach = atan(hypot(x, y)) + asin(s);
    } while (reach > 1.2);
    return cone_of(x, y, 1.0, s * sqrt(x * x + y * y + 1.0));
}

static void outlines_of_any_view(void) {
    long double worst = 0.0L;
    int seen = 0;
    for (int i = 0; i < TRIALS; i++) {
        ocel_camera_t camera;
        const ocel_cone_t cone = any_view(&camera);
        ocel_ellipse_t e;
        if (ocel_cone_outline(&camera, &cone, &e) != OCEL_OK) {
            continue;
        }
        seen++;
        TEST_ASSERT_TRUE((e.a_px_q16 >= e.b_px_q16) && (e.b_px_q16 > 0));
        TEST_ASSERT_TRUE(e.angle_turn_q32 < 0x80000000U);
        /* The cone's Q30 is worth 1e-9 rad. */
        const long double scale =
            1.0L + (e.a_px_q16 / 65536.0L) * 1e-4L + camera.intrinsics.fx_px_q16 / 65536.0L * 1e-4L;
        for (int k = 0; k < RAYS; k++) {
            const spot_t spot = ray_of(&camera, &cone, k);
            worst = fmaxl(worst, fabsl(off_ellipse(&e, spot)) / scale);
        }
    }
    printf("outlines: %d of %d, rays worst %.2Le px off\n", seen, TRIALS, worst);
    TEST_ASSERT_TRUE(seen > TRIALS * 9 / 10);
    TEST_ASSERT_TRUE(worst < 3e-5L);
}

/* On the axis an outline is a circle; with fy = 2 fx it stands upright. */
static void outlines_on_the_axis(void) {
    const ocel_cone_t cone = cone_of(0.0, 0.0, 1.0, 0.1);
    const ocel_camera_t square = camera_of(300.0, 300.0, 160.0, 120.0);
    const ocel_camera_t tall = camera_of(150.0, 300.0, 160.0, 120.0);
    const double r = 300.0 * 0.1 / sqrt(1.0 - 0.01);
    ocel_ellipse_t e;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_cone_outline(&square, &cone, &e));
    TEST_ASSERT_INT32_WITHIN(1, px(r), e.a_px_q16);
    TEST_ASSERT_EQUAL_INT32(e.a_px_q16, e.b_px_q16);
    TEST_ASSERT_EQUAL_INT32(px(160.0), e.cx_px_q16);
    TEST_ASSERT_EQUAL_INT32(px(120.0), e.cy_px_q16);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_cone_outline(&tall, &cone, &e));
    TEST_ASSERT_INT32_WITHIN(1, px(r), e.a_px_q16);
    TEST_ASSERT_INT32_WITHIN(1, px(r / 2.0), e.b_px_q16);
    TEST_ASSERT_EQUAL_UINT32(0x40000000U, e.angle_turn_q32);
}

static void outlines_that_are_none(void) {
    const ocel_camera_t camera = camera_of(300.0, 300.0, 160.0, 120.0);
    ocel_camera_t unready;
    ocel_cone_t cone;
    ocel_ellipse_t e;
    ocel_ellipse_t zero;
    memset(&unready, 0, sizeof(unready));
    memset(&zero, 0, sizeof(zero));
    static const struct {
        double x, y, z, r;
        ocel_status_t status;
    } CASES[] = {{0.0, 0.0, -1.0, 0.1, OCEL_NOT_AN_ELLIPSE}, /* behind */
                 {1.0, 0.0, 0.05, 0.1, OCEL_NOT_AN_ELLIPSE}, /* reaches behind */
                 {1.0, 0.0, 0.1, 0.1, OCEL_NOT_AN_ELLIPSE},  /* touches the plane */
                 {0.0, 0.0, 1.0, 1.0, OCEL_NOT_AN_ELLIPSE},  /* around the camera */
                 {1.0, 0.0, 0.1002, 0.1, OCEL_OUT_OF_RANGE}, /* 1.5e5 px long */
                 {0.0, 0.0, 1.0, 0.0, OCEL_OUT_OF_RANGE},    /* no angle */
                 {0.0, 0.0, 1.0, 3e-9, OCEL_OUT_OF_RANGE}};  /* below a half of 2^-16 px */
    for (size_t i = 0; i < sizeof(CASES) / sizeof(CASES[0]); i++) {
        cone = cone_of(CASES[i].x, CASES[i].y, CASES[i].z, CASES[i].r);
        memset(&e, 0x55, sizeof(e));
        TEST_ASSERT_EQUAL(CASES[i].status, ocel_cone_outline(&camera, &cone, &e));
        TEST_ASSERT_EQUAL_MEMORY(&zero, &e, sizeof(e));
    }
    cone = cone_of(0.0, 0.0, 1.0, 0.1);
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_cone_outline(&unready, &cone, &e));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_cone_outline(NULL, &cone, &e));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_cone_outline(&camera, NULL, &e));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_cone_outline(&camera, &cone, NULL));
}

/* Any bytes for a cone: an ellipse within its ranges, or a status and zeros. */
static void outlines_of_any_bytes(void) {
    ocel_ellipse_t zero;
    memset(&zero, 0, sizeof(zero));
    for (int i = 0; i < TRIALS * 5; i++) {
        const ocel_camera_t camera =
            camera_of(rng_log_uniform(&rng, 16.0, 16384.0), rng_log_uniform(&rng, 16.0, 16384.0),
                      rng_uniform(&rng, -16384.0, 16384.0), rng_uniform(&rng, -16384.0, 16384.0));
        ocel_cone_t cone;
        ocel_ellipse_t e;
        memset(&cone, 0, sizeof(cone));
        for (int k = 0; k < 3; k++) {
            cone.axis_cam_q30[k] = (int32_t)rng_u32(&rng) >> rng_below(&rng, 31U);
        }
        cone.sin_q30 = rng_u32(&rng) >> rng_below(&rng, 32U);
        if (ocel_cone_outline(&camera, &cone, &e) == OCEL_OK) {
            TEST_ASSERT_TRUE((e.a_px_q16 >= e.b_px_q16) && (e.b_px_q16 > 0));
            TEST_ASSERT_TRUE(e.a_px_q16 <= (1 << 30));
        } else {
            TEST_ASSERT_EQUAL_MEMORY(&zero, &e, sizeof(e));
        }
    }
}

int main(void) {
    printf("seed %d\n", SEED);
    UNITY_BEGIN();
    RUN_TEST(outlines_of_the_vectors);
    RUN_TEST(outlines_of_any_view);
    RUN_TEST(outlines_on_the_axis);
    RUN_TEST(outlines_that_are_none);
    RUN_TEST(outlines_of_any_bytes);
    return UNITY_END();
}
