/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdio.h>

#include "base/int_math.h"
#include "board.h"
#include "rng.h"
#include "unity.h"

enum { SEED = 20110601, RANDOM_TRIALS = TEST_TRIALS(1000000) };

static rng_t rng;

void setUp(void) {
    rng = rng_seed(SEED);
}

void tearDown(void) {
}

/* A 64-bit value of any magnitude, all bit lengths equally likely. */
static uint64_t any_u64(void) {
    return rng_u64(&rng) >> rng_below(&rng, 64U);
}

/* Division that rounds down, from C's, which rounds towards 0. */
static int64_t floor_div(int64_t v, int64_t d) {
    return (v / d) - (((v % d) < 0) ? 1 : 0);
}

/* The values at which arithmetic breaks first. */
static const int64_t EDGES[] = {0,
                                1,
                                -1,
                                2,
                                -2,
                                3,
                                -3,
                                -4,
                                INT32_MAX,
                                INT32_MIN,
                                INT64_MAX,
                                INT64_MIN,
                                5,
                                -5,
                                1LL << 32,
                                -(1LL << 32),
                                INT64_MAX - 1,
                                INT64_MIN + 1};
enum { EDGE_COUNT = (int)(sizeof(EDGES) / sizeof(EDGES[0])) };

static int64_t edge_or_random(int i) {
    return (i < EDGE_COUNT) ? EDGES[i] : (int64_t)rng_u64(&rng);
}

static void right_shift_is_floor(void) {
    for (int i = 0; i < TEST_TRIALS(2000); i++) {
        const int64_t v = edge_or_random(i);
        for (uint32_t n = 0U; n < 63U; n++) {
            TEST_ASSERT_EQUAL_INT64(floor_div(v, 1LL << n), ocel_asr64(v, n));
            if (n < 32U) {
                TEST_ASSERT_EQUAL_INT64(floor_div(v, 1LL << n), ocel_asr64_short(v, n));
            }
        }
        TEST_ASSERT_EQUAL_INT64((v < 0) ? -1 : 0, ocel_asr64(v, 63U));
        const int32_t w = (int32_t)v;
        for (uint32_t n = 0U; n < 32U; n++) {
            TEST_ASSERT_EQUAL_INT32(floor_div(w, 1LL << n), ocel_asr32(w, n));
        }
    }
}

static void rounded_shift_is_within_half(void) {
    for (int i = 0; i < TEST_TRIALS(2000); i++) {
        const int64_t any = edge_or_random(i);
        for (uint32_t n = 0U; n <= 62U; n++) {
            const int64_t unit = 1LL << n;
            const int64_t largest = INT64_MAX - (unit / 2); /* the stated range */
            const int64_t v = (any > largest) ? largest : any;
            int64_t nearest = floor_div(v, unit);
            const int64_t rest = v - (nearest * unit); /* 0 .. unit - 1, no overflow */
            nearest += ((n > 0U) && (rest >= (unit / 2))) ? 1 : 0;
            TEST_ASSERT_EQUAL_INT64(nearest, ocel_shift_round64(v, n));
        }
    }
    TEST_ASSERT_EQUAL_INT64(3, ocel_shift_round64(5, 1U));
    TEST_ASSERT_EQUAL_INT64(-2, ocel_shift_round64(-5, 1U)); /* halves go up */
}

static void magnitude_of_every_sign(void) {
    for (int i = 0; i < TEST_TRIALS(10000); i++) {
        const int64_t v = edge_or_random(i);
        const uint64_t expected = (v < 0) ? ((uint64_t)(-(v + 1)) + 1U) : (uint64_t)v;
        TEST_ASSERT_EQUAL_UINT64(expected, ocel_abs64(v));
    }
}

/* Counting one bit at a time. */
static uint32_t slow_leading(uint64_t v, uint32_t width) {
    uint32_t count = 0U;
    while ((count < width) && (((v >> (width - 1U - count)) & 1U) == 0U)) {
        count++;
    }
    return count;
}

static uint32_t slow_trailing(uint32_t v) {
    uint32_t count = 0U;
    while ((count < 32U) && (((v >> count) & 1U) == 0U)) {
        count++;
    }
    return count;
}

static void check_scans(uint64_t v) {
    TEST_ASSERT_EQUAL_UINT32(slow_leading(v, 64U), ocel_clz64(v));
    TEST_ASSERT_EQUAL_UINT32(slow_leading((uint32_t)v, 32U), ocel_clz32((uint32_t)v));
    TEST_ASSERT_EQUAL_UINT32(slow_leading((uint32_t)v, 32U), ocel_clz32_portable((uint32_t)v));
    TEST_ASSERT_EQUAL_UINT32(slow_trailing((uint32_t)v), ocel_ctz32((uint32_t)v));
}

static void bit_scans_count_bits(void) {
    printf("bit scans: OCEL_PORTABLE_BITS = %d\n", OCEL_PORTABLE_BITS);
    check_scans(0U); /* 64 and 32, as stated */
    for (uint32_t k = 0U; k < 64U; k++) {
        const uint64_t bit = (uint64_t)1U << k;
        check_scans(bit);
        check_scans(bit - 1U);
        check_scans(bit + 1U);
        check_scans(~bit);
        check_scans(0U - bit);
    }
    for (int i = 0; i < TEST_TRIALS(100000); i++) {
        check_scans(any_u64());
    }
}

/* Every upper half of 64 bits is allowed below m, so both ends are tried. */
static void short_reciprocal_within_its_bound(void) {
    long double worst = 0.0L;
    uint64_t m = (uint64_t)1U << 31U;
    while (m < ((uint64_t)1U << 32U)) {
        const uint32_t y = ocel_recip32((uint32_t)m);
        const long double below = ldexpl((long double)y * (long double)m, -62) - 1.0L;
        const long double above = ldexpl((long double)y * (long double)(m + 1U), -62) - 1.0L;
        worst = fmaxl(worst, fmaxl(fabsl(below), fabsl(above)));
        TEST_ASSERT_TRUE((y >= ((uint32_t)1U << 30U)) && (y <= ((uint32_t)1U << 31U)));
        m += (m < ((uint64_t)1U << 31U) + 1000U)
                 ? 1U
                 : (1U + rng_below(&rng, 2000U * OCEL_TEST_REDUCED));
    }
    const uint32_t last = ocel_recip32(UINT32_MAX);
    TEST_ASSERT_UINT32_WITHIN(2U, (uint32_t)1U << 30U, last);
    printf("recip32: worst relative error 2^%.2f (stated 2^-29)\n", (double)log2l(worst));
    TEST_ASSERT_TRUE(worst < ldexpl(1.0L, -29));
}

static void check_division(uint64_t num, uint64_t den) {
    if (den == 0U) {
        TEST_ASSERT_EQUAL_UINT64(UINT64_MAX, ocel_udiv64(num, den));
    } else if (ocel_udiv64(num, den) != (num / den)) {
        printf("num %llu den %llu\n", (unsigned long long)num, (unsigned long long)den);
        TEST_ASSERT_EQUAL_UINT64(num / den, ocel_udiv64(num, den));
    }
}

/* Quotients just below, at and above a whole number are where a digit or the
 * last subtraction goes wrong. */
static void check_division_around(uint64_t num, uint64_t den) {
    check_division(num, den);
    if (den != 0U) {
        const uint64_t whole = num - (num % den);
        check_division(whole, den);
        check_division(whole - 1U, den);
        check_division(whole + (den - 1U), den);
    }
}

static void division_is_exact(void) {
    for (uint32_t k = 0U; k < 64U; k++) {
        for (uint32_t j = 0U; j < 64U; j++) {
            for (uint64_t d = 0U; d < 3U; d++) {
                const uint64_t den = ((uint64_t)1U << j) - 1U + d;
                check_division_around(((uint64_t)1U << k) - 1U, den);
                check_division_around((uint64_t)1U << k, den);
                check_division_around(UINT64_MAX - k, den);
            }
        }
    }
    for (uint64_t den = 0U; den < 300U; den += TEST_STEP) {
        for (uint64_t num = 0U; num < 300U; num++) {
            check_division(num, den);
            check_division(UINT64_MAX - num, den);
        }
    }
    for (int i = 0; i < RANDOM_TRIALS; i++) {
        uint64_t den = any_u64();
        den |= ((i % 3) == 0) ? 0xFFFFFFFFU : 0U; /* the reciprocal's worst lower half */
        check_division_around(((i % 2) == 0) ? any_u64() : UINT64_MAX - any_u64(), den);
    }
}

static void check_root(uint64_t v) {
    const uint64_t root = ocel_isqrt64(v);
    TEST_ASSERT_TRUE((root * root) <= v);
    /* (root + 1)^2 > v, without the overflow at root = 2^32 - 1 */
    TEST_ASSERT_TRUE((v - (root * root)) <= (2U * root));
}

static void square_root_is_the_floor(void) {
    for (uint64_t v = 0U; v < 10000U; v += TEST_STEP) {
        check_root(v);
        check_root(UINT64_MAX - v);
    }
    for (int i = 0; i < RANDOM_TRIALS / 4; i++) {
        const uint64_t root = any_u64() >> 32U;
        check_root(any_u64());
        check_root(root * root);
        check_root((root * root) - ((root > 0U) ? 1U : 0U));
        check_root((root * root) + (2U * root));
    }
}

int main(void) {
    printf("seed %d\n", SEED);
    UNITY_BEGIN();
    RUN_TEST(right_shift_is_floor);
    RUN_TEST(rounded_shift_is_within_half);
    RUN_TEST(magnitude_of_every_sign);
    RUN_TEST(bit_scans_count_bits);
    RUN_TEST(short_reciprocal_within_its_bound);
    RUN_TEST(division_is_exact);
    RUN_TEST(square_root_is_the_floor);
    return UNITY_END();
}
