/* SPDX-License-Identifier: MIT
 *
 * References: the compiler's 128-bit integer for products, or where it has none
 * products of halves; long double for reciprocals and roots.
 */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>

#include "base/q60.h"
#include "board.h"
#include "rng.h"
#include "unity.h"

enum { SEED = 20110603, RANDOM_TRIALS = TEST_TRIALS(1000000) };

static rng_t rng;

void setUp(void) {
    rng = rng_seed(SEED);
}

void tearDown(void) {
}

#define LIMIT ((int64_t)1 << 61)

#ifdef __SIZEOF_INT128__
__extension__ typedef __int128 i128_t;

static int64_t floor_of_product(int64_t a, int64_t b) {
    const i128_t product = (i128_t)a * b;
    const i128_t whole = product / OCEL_Q60_ONE; /* towards 0 */
    return (int64_t)whole - (((product % OCEL_Q60_ONE) < 0) ? 1 : 0);
}
#else
static uint64_t magnitude(int64_t v) {
    return (v < 0) ? (0U - (uint64_t)v) : (uint64_t)v;
}

/* The magnitudes' product as two words, then the floor of it or of its negative. */
static int64_t floor_of_product(int64_t a, int64_t b) {
    const uint64_t mask = 0xFFFFFFFFU;
    const uint64_t p = magnitude(a);
    const uint64_t q = magnitude(b);
    const uint64_t low = (p & mask) * (q & mask);
    const uint64_t cross = (p >> 32U) * (q & mask) + (low >> 32U);
    const uint64_t other = (p & mask) * (q >> 32U) + (cross & mask);
    const uint64_t high = (p >> 32U) * (q >> 32U) + (cross >> 32U) + (other >> 32U);
    const uint64_t bottom = (other << 32U) | (low & mask);
    const int64_t whole = (int64_t)((high << 4U) | (bottom >> 60U));
    const bool exact = (bottom & ((uint64_t)OCEL_Q60_ONE - 1U)) == 0U;
    return ((a < 0) == (b < 0)) ? whole : (-whole - (exact ? 0 : 1));
}
#endif

/* Products are floored, by either way. */
static void check_product(int64_t a, int64_t b) {
    const int64_t product = ocel_mul_q60(a, b);
    TEST_ASSERT_EQUAL_INT64(floor_of_product(a, b), product);
    TEST_ASSERT_EQUAL_INT64(product, ocel_mul_q60_by_parts(a, b));
}

static int64_t any_q60(void) {
    const int64_t size = (int64_t)(rng_u64(&rng) >> (3U + rng_below(&rng, 61U)));
    return ((rng_u32(&rng) & 1U) != 0U) ? -size : size;
}

static void products_are_the_floor(void) {
    static const int64_t EDGES[] = {0,
                                    1,
                                    -1,
                                    LIMIT - 1,
                                    1 - LIMIT,
                                    OCEL_Q60_ONE,
                                    -OCEL_Q60_ONE,
                                    OCEL_Q60_ONE - 1,
                                    0x3FFFFFFF,
                                    -0x3FFFFFFF,
                                    0x40000000,
                                    -0x40000000,
                                    LIMIT - 0x40000000,
                                    0x20000000,
                                    0x1FFFFFFF};
    for (size_t i = 0; i < sizeof(EDGES) / sizeof(EDGES[0]); i++) {
        for (size_t j = 0; j < sizeof(EDGES) / sizeof(EDGES[0]); j++) {
            check_product(EDGES[i], EDGES[j]);
        }
    }
    for (int i = 0; i < RANDOM_TRIALS; i++) {
        check_product(any_q60(), any_q60());
    }
}

static void products_by_one_and_zero_are_exact(void) {
    for (int i = 0; i < 10000; i++) {
        const int64_t v = any_q60();
        TEST_ASSERT_EQUAL_INT64(v, ocel_mul_q60(v, OCEL_Q60_ONE));
        TEST_ASSERT_EQUAL_INT64(v, ocel_mul_q60(OCEL_Q60_ONE, v));
        TEST_ASSERT_EQUAL_INT64(0, ocel_mul_q60(v, 0));
        TEST_ASSERT_EQUAL_INT64(0, ocel_mul_q60(0, v));
    }
}

/* Arguments on which normalising, the start or the last step break first:
 * powers of two and their neighbours, and upper halves with extreme lower
 * ones; then all magnitudes at random. */
enum { EDGE_TRIALS = 64 * 5 };
static uint64_t any_argument(int i) {
    uint64_t p;
    if (i < EDGE_TRIALS) {
        const uint64_t power = (uint64_t)1U << (uint32_t)(i / 5);
        const uint64_t around[5] = {power, power + 1U, power - 1U, power + (power >> 1U),
                                    UINT64_MAX - power};
        p = around[i % 5];
    } else {
        p = rng_u64(&rng);
        p |= ((i % 4) == 0) ? 0xFFFFFFFFU : 0U;
        p &= ((i % 4) == 1) ? ~(uint64_t)0xFFFFFFFFU : UINT64_MAX;
        p |= ((i % 8) < 4) ? ((uint64_t)1U << 63U) : 0U;
        p >>= rng_below(&rng, 64U);
    }
    return (p == 0U) ? 1U : p;
}

/* y 2^e / exact - 1, all in long double. */
static long double relative_error(int64_t y, int bits, int32_t e, long double exact) {
    return (ldexpl((long double)y, (int)e - bits) - exact) / exact;
}

static void report(const char *name, long double worst, int stated) {
    const int allowed = (stated > TEST_REFERENCE_LOG2) ? stated : TEST_REFERENCE_LOG2;
    printf("%s: worst relative error 2^%.2f (stated 2^%d, held to 2^%d)\n", name,
           (double)log2l(worst), stated, allowed);
    TEST_ASSERT_TRUE(worst < ldexpl(1.0L, allowed));
}

static void reciprocals_within_their_bound(void) {
    long double worst = 0.0L;
    for (int i = 0; i < RANDOM_TRIALS; i++) {
        const uint64_t p = any_argument(i);
        const long double exact = 1.0L / ldexpl((long double)p, -60);
        int64_t y = -1;
        int32_t e = -99;
        ocel_recip_q60(p, &y, &e);
        TEST_ASSERT_TRUE((y >= OCEL_Q60_ONE / 2) && (y <= OCEL_Q60_ONE));
        TEST_ASSERT_TRUE((e >= -3) && (e <= 60));
        worst = fmaxl(worst, fabsl(relative_error(y, 60, e, exact)));
    }
    report("recip_q60", worst, -58);
}

static void short_reciprocals_within_their_bound(void) {
    long double worst = 0.0L;
    for (int i = 0; i < RANDOM_TRIALS; i++) {
        const uint64_t p = any_argument(i);
        const long double exact = 1.0L / ldexpl((long double)p, -60);
        uint32_t y = 0U;
        int32_t e = -99;
        ocel_recip_short(p, &y, &e);
        TEST_ASSERT_TRUE((y >= ((uint32_t)1U << 30U)) && (y <= ((uint32_t)1U << 31U)));
        TEST_ASSERT_TRUE((e >= -3) && (e <= 60));
        worst = fmaxl(worst, fabsl(relative_error((int64_t)y, 31, e, exact)));
    }
    report("recip_short", worst, -29);
}

static void reciprocal_roots_within_their_bound(void) {
    long double worst = 0.0L;
    for (int i = 0; i < RANDOM_TRIALS; i++) {
        const uint64_t p = any_argument(i);
        const long double exact = 1.0L / sqrtl(ldexpl((long double)p, -60));
        int64_t y = -1;
        int32_t e = -99;
        ocel_rsqrt_q60(p, &y, &e);
        TEST_ASSERT_TRUE((y >= OCEL_Q60_ONE / 2) && (y <= OCEL_Q60_ONE));
        TEST_ASSERT_TRUE((e >= -1) && (e <= 30));
        worst = fmaxl(worst, fabsl(relative_error(y, 60, e, exact)));
    }
    report("rsqrt_q60", worst, -57);
}

static void roots_within_their_bound(void) {
    long double worst = 0.0L;
    for (int i = 0; i < RANDOM_TRIALS; i++) {
        const uint64_t p = any_argument(i) >> 2U;
        const long double exact = ldexpl(sqrtl(ldexpl((long double)p, -60)), 60);
        const int64_t root = ocel_sqrt_q60(p);
        const long double beyond_rounding = fabsl((long double)root - exact) - 0.5L;
        TEST_ASSERT_TRUE((root >= 0) && (root <= LIMIT));
        if (p > 0U) {
            worst = fmaxl(worst, beyond_rounding / exact);
        }
    }
    report("sqrt_q60, beyond half an LSB", worst, -57);
}

static void whole_results_are_whole(void) {
    int64_t y = 0;
    int32_t e = 0;
    for (uint32_t k = 0U; k < 64U; k++) { /* 1 / 2^k exactly */
        ocel_recip_q60((uint64_t)1U << k, &y, &e);
        TEST_ASSERT_TRUE(ldexpl((long double)y, (int)e) == ldexpl(1.0L, 120 - (int)k));
    }
    for (uint32_t k = 0U; k < 62U; k += 2U) { /* even powers of two have exact roots */
        TEST_ASSERT_EQUAL_INT64((int64_t)1 << (30U + (k / 2U)), ocel_sqrt_q60((uint64_t)1U << k));
    }
}

static void zero_has_a_stated_answer(void) {
    int64_t y = -1;
    uint32_t y_short = 7U;
    int32_t e = -99;
    ocel_recip_q60(0U, &y, &e);
    TEST_ASSERT_EQUAL_INT64(0, y);
    TEST_ASSERT_EQUAL_INT32(0, e);
    y = -1;
    e = -99;
    ocel_rsqrt_q60(0U, &y, &e);
    TEST_ASSERT_EQUAL_INT64(0, y);
    TEST_ASSERT_EQUAL_INT32(0, e);
    e = -99;
    ocel_recip_short(0U, &y_short, &e);
    TEST_ASSERT_EQUAL_UINT32(0U, y_short);
    TEST_ASSERT_EQUAL_INT32(0, e);
    TEST_ASSERT_EQUAL_INT64(0, ocel_sqrt_q60(0U));
}

int main(void) {
    printf("seed %d\n", SEED);
    UNITY_BEGIN();
    RUN_TEST(products_are_the_floor);
    RUN_TEST(products_by_one_and_zero_are_exact);
    RUN_TEST(reciprocals_within_their_bound);
    RUN_TEST(short_reciprocals_within_their_bound);
    RUN_TEST(reciprocal_roots_within_their_bound);
    RUN_TEST(roots_within_their_bound);
    RUN_TEST(whole_results_are_whole);
    RUN_TEST(zero_has_a_stated_answer);
    return UNITY_END();
}
