/* SPDX-License-Identifier: MIT
 *
 * References: atan2l, hypotl, sinl, cosl.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/trig.h"
#include "board.h"
#include "rng.h"
#include "unity.h"

enum { SEED = 20110604, RANDOM_TRIALS = TEST_TRIALS(1000000) };

#define LIMIT ((int64_t)1 << 60)
#define ONE_Q30 ((int32_t)1 << 30)
#define TURN 4294967296.0L

/* Stated is 2^-52. */
#define MAGNITUDE_LOG2 ((TEST_REFERENCE_LOG2 > -52) ? TEST_REFERENCE_LOG2 : -52)

static rng_t rng;

void setUp(void) {
    rng = rng_seed(SEED);
}

void tearDown(void) {
}

static long double two_pi(void) {
    return 2.0L * acosl(-1.0L);
}

typedef struct {
    long double turn_lsb;
    long double magnitude; /* relative, beyond the half LSB of rounding */
} polar_error_t;

static polar_error_t polar_error(int64_t x, int64_t y) {
    const long double length = hypotl((long double)x, (long double)y);
    const long double turn = atan2l((long double)y, (long double)x) / two_pi() * TURN;
    int64_t magnitude = -1;
    uint32_t turn_q32 = 0U;
    ocel_polar(x, y, &magnitude, &turn_q32);
    const long double off = (long double)turn_q32 - turn;
    const polar_error_t error = {fabsl(off - (TURN * roundl(off / TURN))),
                                 (fabsl((long double)magnitude - length) - 0.5L) / length};
    return error;
}

static polar_error_t worst_polar = {0.0L, 0.0L};

static void check_polar(int64_t x, int64_t y) {
    const polar_error_t error = polar_error(x, y);
    worst_polar.turn_lsb = fmaxl(worst_polar.turn_lsb, error.turn_lsb);
    worst_polar.magnitude = fmaxl(worst_polar.magnitude, error.magnitude);
    if ((error.turn_lsb > 0.51L) || (error.magnitude > ldexpl(1.0L, MAGNITUDE_LOG2))) {
        printf("x %lld y %lld: %f LSB, %g\n", (long long)x, (long long)y, (double)error.turn_lsb,
               (double)error.magnitude);
        TEST_FAIL_MESSAGE("polar beyond its stated error");
    }
}

static int64_t any_coordinate(void) {
    const int64_t size = (int64_t)(rng_u64(&rng) >> (4U + rng_below(&rng, 60U)));
    return ((rng_u32(&rng) & 1U) != 0U) ? -size : size;
}

static void polar_of_random_vectors(void) {
    for (int i = 0; i < RANDOM_TRIALS; i++) {
        const int64_t x = any_coordinate();
        const int64_t y = any_coordinate();
        if ((x != 0) || (y != 0)) {
            check_polar(x, y);
        }
    }
    for (int i = 0; i < RANDOM_TRIALS; i++) { /* any angle, any length */
        const double length = rng_log_uniform(&rng, 4.0, 1.1e18);
        const double angle = rng_uniform(&rng, 0.0, 7.0);
        check_polar((int64_t)(length * cos(angle)), (int64_t)(length * sin(angle)) | 1);
    }
    printf("polar: worst angle %.4f LSB (stated 0.51), magnitude 2^%.2f beyond half an LSB "
           "(stated 2^-52, held to 2^%d)\n",
           (double)worst_polar.turn_lsb, (double)log2l(worst_polar.magnitude), MAGNITUDE_LOG2);
}

/* Small vectors are as exact as large ones: all of a small grid (every third on a board). */
static void polar_of_small_vectors(void) {
    for (int64_t y = -40; y <= 40; y += ((OCEL_TEST_REDUCED == 1) ? 1 : 3)) {
        for (int64_t x = -40; x <= 40; x += ((OCEL_TEST_REDUCED == 1) ? 1 : 3)) {
            if ((x != 0) || (y != 0)) {
                check_polar(x, y);
                check_polar(x * (LIMIT / 64), y * (LIMIT / 64));
            }
        }
    }
}

static void polar_of_the_edges(void) {
    static const int64_t EDGES[] = {0,
                                    1,
                                    LIMIT,
                                    LIMIT - 1,
                                    LIMIT / 2,
                                    (LIMIT / 2) - 1,
                                    LIMIT / 4,
                                    (LIMIT / 4) - 1,
                                    (LIMIT / 4) + 1};
    for (size_t i = 0; i < sizeof(EDGES) / sizeof(EDGES[0]); i++) {
        for (size_t j = 0; j < sizeof(EDGES) / sizeof(EDGES[0]); j++) {
            if ((i != 0U) || (j != 0U)) {
                check_polar(EDGES[i], EDGES[j]);
                check_polar(-EDGES[i], EDGES[j]);
                check_polar(EDGES[i], -EDGES[j]);
                check_polar(-EDGES[i], -EDGES[j]);
            }
        }
    }
}

/* On the axes the angle is exact and the length too, as far as its bits go. */
static void polar_on_the_axes(void) {
    for (uint32_t k = 0U; k <= 60U; k++) {
        for (int64_t d = -1; d <= 1; d++) {
            const int64_t v = ((int64_t)1 << k) + d;
            if ((v <= 0) || (v > LIMIT)) {
                continue;
            }
            const int64_t xs[4] = {v, 0, -v, 0};
            const int64_t ys[4] = {0, v, 0, -v};
            for (uint32_t q = 0U; q < 4U; q++) {
                int64_t magnitude = -1;
                uint32_t turn = 1U;
                ocel_polar(xs[q], ys[q], &magnitude, &turn);
                TEST_ASSERT_EQUAL_HEX32(q * 0x40000000U, turn);
                TEST_ASSERT_INT64_WITHIN((v >> 52U), v, magnitude);
            }
        }
    }
}

static void polar_of_nothing_is_zero(void) {
    int64_t magnitude = -1;
    uint32_t turn = 1U;
    ocel_polar(0, 0, &magnitude, &turn);
    TEST_ASSERT_EQUAL_INT64(0, magnitude);
    TEST_ASSERT_EQUAL_UINT32(0U, turn);
}

static void polar_of_right_triangles_is_whole(void) {
    static const int64_t SIDES[4][3] = {{3, 4, 5}, {5, 12, 13}, {20, 21, 29}, {696, 697, 985}};
    for (int i = 0; i < 4; i++) {
        for (int64_t scale = 1; scale < ((int64_t)1 << 40); scale *= 3) {
            int64_t magnitude = -1;
            uint32_t turn = 0U;
            ocel_polar(-SIDES[i][0] * scale, SIDES[i][1] * scale, &magnitude, &turn);
            TEST_ASSERT_EQUAL_INT64(SIDES[i][2] * scale, magnitude);
        }
    }
}

static long double worst_sincos = 0.0L;

static void check_sincos(uint32_t turn) {
    const long double angle = (long double)turn / TURN * two_pi();
    int32_t sine = 0;
    int32_t cosine = 0;
    ocel_sincos(turn, &sine, &cosine);
    const long double sin_error = fabsl((long double)sine - ldexpl(sinl(angle), 30));
    const long double cos_error = fabsl((long double)cosine - ldexpl(cosl(angle), 30));
    worst_sincos = fmaxl(worst_sincos, fmaxl(sin_error, cos_error));
    TEST_ASSERT_TRUE((abs(sine) <= ONE_Q30) && (abs(cosine) <= ONE_Q30));
    if ((sin_error >= 1.0L) || (cos_error >= 1.0L)) {
        printf("turn 0x%08X: sin %f cos %f LSB\n", (unsigned)turn, (double)sin_error,
               (double)cos_error);
        TEST_FAIL_MESSAGE("sincos beyond its stated error");
    }
}

static void sincos_within_its_bound(void) {
    for (uint32_t eighth = 0U; eighth < 8U; eighth++) { /* where the octants meet */
        for (uint32_t d = 0U; d < TEST_TRIALS(2000U); d++) {
            check_sincos((eighth << 29U) + d);
            check_sincos((eighth << 29U) - d);
        }
    }
    for (int i = 0; i < 2 * RANDOM_TRIALS; i++) {
        check_sincos(rng_u32(&rng));
    }
    printf("sincos: worst %.4f LSB (stated 1)\n", (double)worst_sincos);
}

static void sincos_of_quarters_is_exact(void) {
    static const int32_t SINES[5] = {0, ONE_Q30, 0, -ONE_Q30, 0};
    for (uint32_t q = 0U; q < 4U; q++) {
        int32_t sine = 1;
        int32_t cosine = 1;
        ocel_sincos(q << 30U, &sine, &cosine);
        TEST_ASSERT_EQUAL_INT32(SINES[q], sine);
        TEST_ASSERT_EQUAL_INT32(SINES[q + 1U], cosine);
    }
}

/* A quarter turn more: exactly (cos, -sin), whatever the angle. */
static void sincos_is_symmetrical(void) {
    for (int i = 0; i < TEST_TRIALS(10000); i++) {
        const uint32_t turn = rng_u32(&rng);
        int32_t sine[2] = {0, 0};
        int32_t cosine[2] = {0, 0};
        ocel_sincos(turn, &sine[0], &cosine[0]);
        ocel_sincos(turn + 0x40000000U, &sine[1], &cosine[1]);
        TEST_ASSERT_EQUAL_INT32(cosine[0], sine[1]);
        TEST_ASSERT_EQUAL_INT32(-sine[0], cosine[1]);
    }
}

/* Out to an angle and back. */
static void polar_undoes_sincos(void) {
    for (int i = 0; i < TEST_TRIALS(100000); i++) {
        const uint32_t turn = rng_u32(&rng);
        int32_t sine = 0;
        int32_t cosine = 0;
        int64_t magnitude = 0;
        uint32_t back = 0U;
        ocel_sincos(turn, &sine, &cosine);
        ocel_polar(cosine, sine, &magnitude, &back);
        TEST_ASSERT_INT64_WITHIN(2, ONE_Q30, magnitude);
        TEST_ASSERT_INT32_WITHIN(2, 0, (int32_t)(back - turn)); /* 1 LSB of Q30 is 0.64 here */
    }
}

int main(void) {
    printf("seed %d\n", SEED);
    UNITY_BEGIN();
    RUN_TEST(polar_of_random_vectors);
    RUN_TEST(polar_of_small_vectors);
    RUN_TEST(polar_of_the_edges);
    RUN_TEST(polar_on_the_axes);
    RUN_TEST(polar_of_nothing_is_zero);
    RUN_TEST(polar_of_right_triangles_is_whole);
    RUN_TEST(sincos_within_its_bound);
    RUN_TEST(sincos_of_quarters_is_exact);
    RUN_TEST(sincos_is_symmetrical);
    RUN_TEST(polar_undoes_sincos);
    return UNITY_END();
}
