/* SPDX-License-Identifier: MIT
 *
 * Reference: centre = axis * radius / sin in long double.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <ocellus/sphere.h>

#include "board.h"
#include "rng.h"
#include "unity.h"

enum { SEED = 20110722, TRIALS = TEST_TRIALS(200000) };

#define Q30 1073741824.0L
#define Q60 (Q30 * Q30)
#define RANGE_MAX 1073741824.0L

static rng_t rng;

void setUp(void) {
    rng = rng_seed(SEED);
}

void tearDown(void) {
}

/* A cone along a random axis. */
static ocel_cone_t cone_of(double sine) {
    ocel_cone_t cone;
    double d[3];
    double length = 0.0;
    memset(&cone, 0, sizeof(cone));
    for (int i = 0; i < 3; i++) {
        d[i] = rng_gauss(&rng);
        length += d[i] * d[i];
    }
    for (int i = 0; i < 3; i++) {
        cone.axis_cam_q30[i] = (int32_t)lround(d[i] / sqrt(length) * 1073741823.0);
    }
    cone.sin_q30 = (uint32_t)lround(sine * 1073741824.0);
    return cone;
}

static void centres_and_ranges(void) {
    long double worst = 0.0L;
    int refused = 0;
    for (int i = 0; i < TRIALS; i++) {
        const ocel_cone_t cone = cone_of(rng_log_uniform(&rng, 1e-8, 1.0));
        const int32_t radius = (int32_t)rng_log_uniform(&rng, 1.0, 2147483647.0);
        const long double range = radius * Q30 / cone.sin_q30;
        ocel_sphere_t sphere;
        const ocel_status_t status = ocel_sphere_of_cone(&cone, radius, &sphere);
        if (fabsl(range - RANGE_MAX) > 2.0L) {
            TEST_ASSERT_EQUAL((range < RANGE_MAX) ? OCEL_OK : OCEL_OUT_OF_RANGE, status);
        }
        if (status != OCEL_OK) {
            refused++;
            continue;
        }
        TEST_ASSERT_EQUAL_INT32(radius, sphere.radius_u);
        worst = fmaxl(worst, fabsl(sphere.range_u - range));
        for (int k = 0; k < 3; k++) {
            worst = fmaxl(worst, fabsl(sphere.p_cam_u[k] - range * cone.axis_cam_q30[k] / Q30));
        }
    }
    printf("sphere: worst %.4f u; %d of %d too far\n", (double)worst, refused, TRIALS);
    TEST_ASSERT_TRUE(worst <= 0.501L);
    TEST_ASSERT_TRUE((refused > TRIALS / 10) && (refused < TRIALS / 2));
}

/* cov range^2, the diagonal never below, nothing off by more than one. */
static void covariance_scales_with_the_range(void) {
    for (int i = 0; i < TRIALS; i++) {
        ocel_cone_t cone = cone_of(rng_log_uniform(&rng, 1e-4, 1.0));
        const int32_t radius = (int32_t)rng_log_uniform(&rng, 1000.0, 100000.0);
        ocel_sphere_t sphere;
        for (int k = 0; k < OCEL_SYM3_COUNT; k++) {
            const int64_t size = (int64_t)(rng_u64(&rng) >> (4U + rng_below(&rng, 60U)));
            cone.cov_q60[k] = ((rng_u32(&rng) & 1U) != 0U) ? size : -size;
        }
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_sphere_of_cone(&cone, radius, &sphere));
        const long double square = (long double)sphere.range_u * sphere.range_u;
        for (int k = 0; k < OCEL_SYM3_COUNT; k++) {
            const long double exact = (long double)cone.cov_q60[k] * square / Q60;
            const long double off = (long double)sphere.cov_cam_u2[k] - exact;
            const long double own = (LDBL_MANT_DIG >= 64) ? 0.0L : fabsl(ldexpl(exact, -50));
            TEST_ASSERT_TRUE((off > -1e-3L - own) && (off < 1.001L + own));
        }
    }
}

/* What cannot be placed: a radius or a cone that is none. */
static void nothing_to_place(void) {
    static const int32_t RADII[] = {0, -1, INT32_MIN, INT32_MIN + 1};
    const ocel_cone_t good = cone_of(0.1);
    ocel_cone_t bad[6];
    ocel_sphere_t sphere;
    ocel_sphere_t zero;
    memset(&zero, 0, sizeof(zero));
    for (int i = 0; i < 4; i++) {
        memset(&sphere, 0x55, sizeof(sphere));
        TEST_ASSERT_EQUAL(OCEL_OUT_OF_RANGE, ocel_sphere_of_cone(&good, RADII[i], &sphere));
        TEST_ASSERT_EQUAL_MEMORY(&zero, &sphere, sizeof(sphere));
    }
    for (int i = 0; i < 6; i++) {
        bad[i] = good;
    }
    memset(&bad[0], 0, sizeof(bad[0]));
    bad[1].sin_q30 = 0U;
    bad[2].sin_q30 = (1U << 30U) + 1U;
    bad[3].sin_q30 = UINT32_MAX;
    bad[4].axis_cam_q30[1] = (1 << 30) + 1;
    bad[5].axis_cam_q30[2] = INT32_MIN;
    for (int i = 0; i < 6; i++) {
        memset(&sphere, 0x55, sizeof(sphere));
        TEST_ASSERT_EQUAL(OCEL_OUT_OF_RANGE, ocel_sphere_of_cone(&bad[i], 35000, &sphere));
        TEST_ASSERT_EQUAL_MEMORY(&zero, &sphere, sizeof(sphere));
    }
    ocel_cone_t far = good; /* 2^-30 is the least angle */
    far.sin_q30 = 1U;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_sphere_of_cone(&far, 1, &sphere));
    TEST_ASSERT_EQUAL_UINT32(1U << 30U, sphere.range_u);
    TEST_ASSERT_EQUAL(OCEL_OUT_OF_RANGE, ocel_sphere_of_cone(&far, 2, &sphere));
    TEST_ASSERT_EQUAL(OCEL_OUT_OF_RANGE, ocel_sphere_of_cone(&far, INT32_MAX, &sphere));
}

/* Covariances of no fit neither overflow nor turn their sign. */
static void absurd_covariances_are_bounded(void) {
    ocel_cone_t cone = cone_of(0.001);
    ocel_sphere_t sphere;
    cone.cov_q60[OCEL_XX] = INT64_MAX;
    cone.cov_q60[OCEL_XY] = INT64_MIN;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_sphere_of_cone(&cone, 1000000, &sphere));
    const int64_t square = (int64_t)sphere.range_u * (int64_t)sphere.range_u;
    TEST_ASSERT_EQUAL_INT64(square, sphere.cov_cam_u2[OCEL_XX]);
    TEST_ASSERT_EQUAL_INT64(-square, sphere.cov_cam_u2[OCEL_XY]);
}

static void null_arguments(void) {
    const ocel_cone_t cone = cone_of(0.1);
    ocel_sphere_t sphere;
    memset(&sphere, 0x55, sizeof(sphere));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_sphere_of_cone(NULL, 1, &sphere));
    TEST_ASSERT_EQUAL_INT32(0, sphere.p_cam_u[2]);
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_sphere_of_cone(&cone, 1, NULL));
}

int main(void) {
    printf("seed %d\n", SEED);
    UNITY_BEGIN();
    RUN_TEST(centres_and_ranges);
    RUN_TEST(covariance_scales_with_the_range);
    RUN_TEST(nothing_to_place);
    RUN_TEST(absurd_covariances_are_bounded);
    RUN_TEST(null_arguments);
    return UNITY_END();
}
