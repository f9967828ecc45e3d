/* SPDX-License-Identifier: MIT
 *
 * A cone's outline and the cone of an outline.  Reference: the rays of the cone
 * themselves, projected in long double; they must lie on the ellipse.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <ocellus/cone.h>
#include <ocellus/fit.h>
#include <ocellus/sphere.h>

#include "board.h"
#include "fit_support.h"
#include "rng.h"
#include "unity.h"

enum { SEED = 20100606, TRIALS = TEST_TRIALS(20000), RAYS = 24 };

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
    printf("outlines: %d of %d, rays worst %.2e px off\n", seen, TRIALS, (double)worst);
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

/* There and back.  The outline is rounded to Q16 px and the cone to Q30. */
static void cone_of_its_outline(void) {
    double worst_axis = 0.0;
    double worst_sine = 0.0;
    for (int i = 0; i < TRIALS; i++) {
        ocel_camera_t camera;
        const ocel_cone_t cone = any_view(&camera);
        ocel_ellipse_t e;
        ocel_cone_t back;
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_cone_outline(&camera, &cone, &e));
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_cone_of_ellipse(&camera, &e, &back));
        /* Half an LSB of Q16 px is 2^-17 / f rad at most; of the radius, 2^-17 / b. */
        const double f = fmin(camera.intrinsics.fx_px_q16, camera.intrinsics.fy_px_q16) / 65536.0;
        const double b = e.b_px_q16 / 65536.0;
        for (int k = 0; k < 3; k++) {
            const double off = abs(back.axis_cam_q30[k] - cone.axis_cam_q30[k]) / 1073741824.0;
            worst_axis = fmax(worst_axis, off * f);
        }
        const double off = fabs((double)back.sin_q30 / cone.sin_q30 - 1.0);
        worst_sine = fmax(worst_sine, off * b);
    }
    printf("there and back: axis %.2e px, radius %.2e px\n", worst_axis, worst_sine);
    TEST_ASSERT_TRUE(worst_axis < 3e-5);
    TEST_ASSERT_TRUE(worst_sine < 6e-5);
}

static void cones_of_the_vectors(void) {
    const ocel_camera_t camera = camera_of(257.34, 257.34, 160.0, 120.0);
    for (int i = 0; i < 2; i++) {
        const vector_t *v = &VECTORS[i];
        ocel_ellipse_t e;
        ocel_cone_t cone;
        ocel_sphere_t sphere;
        memset(&e, 0, sizeof(e));
        e.cx_px_q16 = px(v->cx);
        e.cy_px_q16 = px(v->cy);
        e.a_px_q16 = px(v->a);
        e.b_px_q16 = px(v->b);
        e.angle_turn_q32 = (uint32_t)llround(v->angle_deg / 360.0 * 4294967296.0);
        e.rms_px_q16 = 12U;
        e.arc_coverage_q16 = 34U;
        e.point_count = 56U;
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_cone_of_ellipse(&camera, &e, &cone));
        TEST_ASSERT_EQUAL(OCEL_OK,
                          ocel_sphere_of_cone(&cone, (int32_t)lround(v->r * 1e6), &sphere));
        /* The vectors have four decimals: 5e-5 px of 21 is 1 um at .4 m. */
        TEST_ASSERT_INT32_WITHIN(3, (int32_t)lround(v->x * 1e6), sphere.p_cam_u[0]);
        TEST_ASSERT_INT32_WITHIN(3, (int32_t)lround(v->y * 1e6), sphere.p_cam_u[1]);
        TEST_ASSERT_INT32_WITHIN(3, (int32_t)lround(v->z * 1e6), sphere.p_cam_u[2]);
        TEST_ASSERT_EQUAL_UINT32(12U, cone.rms_px_q16);
        TEST_ASSERT_EQUAL_UINT32(34U, cone.arc_coverage_q16);
        TEST_ASSERT_EQUAL_UINT32(56U, cone.point_count);
        TEST_ASSERT_EQUAL_UINT32(56U, cone.inlier_count);
        for (int k = 0; k < OCEL_SYM3_COUNT; k++) {
            TEST_ASSERT_EQUAL_INT64(0, cone.cov_q60[k]); /* no sigma */
        }
    }
}

/* Sigma over the radius along the axis, that times the sine over root 2 across it. */
static void cone_has_the_ellipse_s_uncertainty(void) {
    const ocel_camera_t camera = camera_of(300.0, 300.0, 160.0, 120.0);
    const ocel_cone_t cone = cone_of(0.0, 0.0, 1.0, 0.1);
    ocel_ellipse_t e;
    ocel_cone_t back;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_cone_outline(&camera, &cone, &e));
    e.centre_sigma_px_q16 = (uint32_t)e.a_px_q16 / 50U;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_cone_of_ellipse(&camera, &e, &back));
    const double one = 1152921504606846976.0;
    TEST_ASSERT_TRUE(fabs(sqrt((double)back.cov_q60[OCEL_ZZ] / one) - 0.02) < 1e-5);
    TEST_ASSERT_TRUE(fabs(sqrt((double)back.cov_q60[OCEL_XX] / one) - 0.002 / sqrt(2.0)) < 1e-6);
    TEST_ASSERT_EQUAL_INT64(back.cov_q60[OCEL_XX], back.cov_q60[OCEL_YY]);
    e.centre_sigma_px_q16 = UINT32_MAX; /* no idea: as far off as it is away */
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_cone_of_ellipse(&camera, &e, &back));
    TEST_ASSERT_TRUE((double)back.cov_q60[OCEL_ZZ] / one > 0.99);
}

/* A lens bends the outline; its cone is the same to second order. */
static void cone_through_a_lens(void) {
    ocel_camera_t camera = camera_of(300.0, 300.0, 160.0, 120.0);
    ocel_intrinsics_t in = camera.intrinsics;
    in.k1_q24 = (int32_t)(-0.3 * 16777216.0);
    in.k2_q24 = (int32_t)(0.1 * 16777216.0);
    in.width = 320U;
    in.height = 240U;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_camera_init(&camera, &in));
    const ocel_cone_t cone = cone_of(0.2, -0.1, 1.0, 0.05);
    ocel_point_t points[RAYS];
    ocel_ellipse_t e;
    ocel_cone_t back;
    for (int k = 0; k < RAYS; k++) {
        const spot_t flat = ray_of(&camera, &cone, k);
        const int32_t p[3] = {(int32_t)((flat.x - 160.0L) / 300.0L * 1e8L),
                              (int32_t)((flat.y - 120.0L) / 300.0L * 1e8L), 100000000};
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_camera_project(&camera, p, &points[k]));
    }
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_points(points, RAYS, NULL, &e));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_cone_of_ellipse(&camera, &e, &back));
    for (int k = 0; k < 3; k++) {
        TEST_ASSERT_INT32_WITHIN(300000, cone.axis_cam_q30[k], back.axis_cam_q30[k]); /* .1 px */
    }
    TEST_ASSERT_TRUE(fabs((double)back.sin_q30 / cone.sin_q30 - 1.0) < 1e-3);
}

/* Cut by the image's edge: what lies beyond is the cone's all the same. */
static void cone_beyond_the_image(void) {
    ocel_camera_t camera = camera_of(300.0, 300.0, 160.0, 120.0);
    ocel_intrinsics_t in = camera.intrinsics;
    const ocel_cone_t cone = cone_of(-0.55, 0.0, 1.0, 0.1);
    ocel_ellipse_t e;
    ocel_cone_t back;
    in.width = 320U;
    in.height = 240U;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_camera_init(&camera, &in));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_cone_outline(&camera, &cone, &e));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_cone_of_ellipse(&camera, &e, &back));
    TEST_ASSERT_INT32_WITHIN(100, cone.axis_cam_q30[0], back.axis_cam_q30[0]);
}

static ocel_status_t cone_of_axes(const ocel_camera_t *camera, double a, double b, double cx) {
    ocel_cone_t zero;
    ocel_cone_t cone;
    ocel_ellipse_t e;
    memset(&zero, 0, sizeof(zero));
    memset(&e, 0, sizeof(e));
    memset(&cone, 0x55, sizeof(cone));
    e.a_px_q16 = px(a);
    e.b_px_q16 = px(b);
    e.cx_px_q16 = px(cx);
    const ocel_status_t status = ocel_cone_of_ellipse(camera, &e, &cone);
    if (status != OCEL_OK) {
        TEST_ASSERT_EQUAL_MEMORY(&zero, &cone, sizeof(cone));
    }
    return status;
}

static void cones_that_are_none(void) {
    const ocel_camera_t camera = camera_of(300.0, 300.0, 0.0, 0.0);
    const ocel_camera_t telephoto = camera_of(16384.0, 16384.0, 0.0, 0.0);
    ocel_camera_t unready;
    ocel_cone_t cone;
    ocel_ellipse_t e;
    memset(&unready, 0, sizeof(unready));
    memset(&e, 0, sizeof(e));
    TEST_ASSERT_EQUAL(OCEL_OK, cone_of_axes(&camera, 20.0, 20.0, 0.0));
    TEST_ASSERT_EQUAL(OCEL_DEGENERATE, cone_of_axes(&camera, 0.0, 0.0, 0.0));
    TEST_ASSERT_EQUAL(OCEL_DEGENERATE, cone_of_axes(&camera, 20.0, 0.0, 0.0));
    TEST_ASSERT_EQUAL(OCEL_DEGENERATE, cone_of_axes(&camera, -20.0, 20.0, 0.0));
    TEST_ASSERT_EQUAL(OCEL_DEGENERATE, cone_of_axes(&telephoto, 1e-3, 1e-3, 0.0));
    TEST_ASSERT_EQUAL(OCEL_OUT_OF_RANGE, cone_of_axes(&camera, 20.0, 20.0, 1700.0));
    TEST_ASSERT_EQUAL(OCEL_OUT_OF_RANGE, cone_of_axes(&camera, 1690.0, 1690.0, 20.0));
    TEST_ASSERT_EQUAL(OCEL_OUT_OF_RANGE, cone_of_axes(&camera, 16384.0, 1.0, 32767.0));
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_cone_of_ellipse(&unready, &e, &cone));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_cone_of_ellipse(NULL, &e, &cone));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_cone_of_ellipse(&camera, NULL, &cone));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_cone_of_ellipse(&camera, &e, NULL));
}

/* Any bytes for an ellipse: a cone that is one, or a status. */
static void cones_of_any_bytes(void) {
    int seen = 0;
    for (int i = 0; i < TRIALS * 5; i++) {
        const ocel_camera_t camera =
            camera_of(rng_log_uniform(&rng, 16.0, 16384.0), rng_log_uniform(&rng, 16.0, 16384.0),
                      rng_uniform(&rng, -16384.0, 16384.0), rng_uniform(&rng, -16384.0, 16384.0));
        ocel_ellipse_t e;
        ocel_cone_t cone;
        memset(&e, 0, sizeof(e));
        e.cx_px_q16 = (int32_t)rng_u32(&rng) >> rng_below(&rng, 31U);
        e.cy_px_q16 = (int32_t)rng_u32(&rng) >> rng_below(&rng, 31U);
        e.a_px_q16 = (int32_t)rng_u32(&rng) >> rng_below(&rng, 31U);
        e.b_px_q16 = (int32_t)rng_u32(&rng) >> rng_below(&rng, 31U);
        e.angle_turn_q32 = rng_u32(&rng);
        e.centre_sigma_px_q16 = rng_u32(&rng) >> rng_below(&rng, 31U);
        if (ocel_cone_of_ellipse(&camera, &e, &cone) == OCEL_OK) {
            double length = 0.0;
            for (int k = 0; k < 3; k++) {
                length += pow(cone.axis_cam_q30[k] / 1073741824.0, 2.0);
            }
            TEST_ASSERT_TRUE(fabs(length - 1.0) < 1e-8);
            TEST_ASSERT_TRUE((cone.sin_q30 > 0U) && (cone.sin_q30 < (1U << 30U)));
            seen++;
        }
    }
    printf("any ellipse: %d of %d have a cone\n", seen, TRIALS * 5);
    TEST_ASSERT_TRUE(seen > TRIALS / 20);
}

int main(void) {
    printf("seed %d\n", SEED);
    UNITY_BEGIN();
    RUN_TEST(outlines_of_the_vectors);
    RUN_TEST(outlines_of_any_view);
    RUN_TEST(outlines_on_the_axis);
    RUN_TEST(outlines_that_are_none);
    RUN_TEST(outlines_of_any_bytes);
    RUN_TEST(cone_of_its_outline);
    RUN_TEST(cones_of_the_vectors);
    RUN_TEST(cone_has_the_ellipse_s_uncertainty);
    RUN_TEST(cone_through_a_lens);
    RUN_TEST(cone_beyond_the_image);
    RUN_TEST(cones_that_are_none);
    RUN_TEST(cones_of_any_bytes);
    return UNITY_END();
}
