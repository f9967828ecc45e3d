/* SPDX-License-Identifier: MIT
 *
 * The twin is the compiler's 128-bit integer, which 64-bit hosts have.
 */
#include <stdio.h>

#include "rng.h"
#include "unity.h"
#include "wide.h"

__extension__ typedef __int128 i128_t;
__extension__ typedef unsigned __int128 u128_t;

enum { SEED = 20110602, RANDOM_TRIALS = 300000 };

#define LARGEST ((int64_t)1 << 62)

static rng_t rng;

void setUp(void) {
    rng = rng_seed(SEED);
}

void tearDown(void) {
}

static i128_t twin_of(const ocel_i128_t *v) {
    return (i128_t)(((u128_t)(uint64_t)v->hi << 64) | v->lo);
}

static ocel_i128_t wide_of(i128_t v) {
    const ocel_i128_t wide = {(int64_t)(v >> 64), (uint64_t)v};
    return wide;
}

static void assert_same(i128_t expected, const ocel_i128_t *v) {
    const ocel_i128_t wide = wide_of(expected);
    TEST_ASSERT_EQUAL_HEX64((uint64_t)wide.hi, (uint64_t)v->hi);
    TEST_ASSERT_EQUAL_HEX64(wide.lo, v->lo);
}

/* Any value of the stated range, all magnitudes and both signs. */
static int64_t any_factor(void) {
    const int64_t size = (int64_t)(rng_u64(&rng) >> (2U + rng_below(&rng, 62U)));
    return ((rng_u32(&rng) & 1U) != 0U) ? -size : size;
}

static const int64_t EDGES[] = {0,
                                1,
                                -1,
                                LARGEST,
                                -LARGEST,
                                LARGEST - 1,
                                1 - LARGEST,
                                LARGEST - (1LL << 32),
                                0xFFFFFFFFLL,
                                -0xFFFFFFFFLL,
                                1LL << 32,
                                -(1LL << 32),
                                0x3FFFFFFF00000000LL,
                                -0x3FFFFFFF00000001LL,
                                0x7FFFFFFFLL,
                                -0x80000000LL};
enum { EDGE_COUNT = (int)(sizeof(EDGES) / sizeof(EDGES[0])) };

static void products_of_the_edges(void) {
    for (int i = 0; i < EDGE_COUNT; i++) {
        for (int j = 0; j < EDGE_COUNT; j++) {
            for (int k = 0; k < EDGE_COUNT; k++) {
                /* Start anywhere, so that carries from both words occur. */
                const i128_t start = ((i128_t)EDGES[k] * LARGEST) + EDGES[(k + 3) % EDGE_COUNT];
                i128_t twin = start;
                ocel_i128_t acc = wide_of(twin);
                ocel_i128_mac(&acc, EDGES[i], EDGES[j]);
                twin += (i128_t)EDGES[i] * EDGES[j];
                assert_same(twin, &acc);
                acc = wide_of(start);
                ocel_i128_mac_by_parts(&acc, EDGES[i], EDGES[j]);
                assert_same(twin, &acc);
            }
        }
    }
}

static void sums_of_random_products(void) {
    i128_t twin = 0;
    ocel_i128_t acc = {0, 0U};
    ocel_i128_t by_parts = {0, 0U};
    for (int i = 0; i < RANDOM_TRIALS; i++) {
        const int64_t a = any_factor();
        const int64_t b = any_factor();
        const int64_t c = (int64_t)rng_u64(&rng);
        if ((i % 4) == 0) {
            twin = 0; /* the sum stays far below 2^127 */
            acc = wide_of(0);
            by_parts = wide_of(0);
        }
        twin += (i128_t)a * b;
        ocel_i128_mac(&acc, a, b);
        assert_same(twin, &acc);
        ocel_i128_mac_by_parts(&by_parts, a, b);
        assert_same(twin, &by_parts);
        twin += c;
        ocel_i128_add64(&acc, c);
        assert_same(twin, &acc);
        ocel_i128_add64(&by_parts, c);
    }
}

static void adding_carries_and_borrows(void) {
    static const int64_t ADDENDS[] = {0, 1, -1, INT64_MAX, INT64_MIN, INT64_MIN + 1};
    static const uint64_t LOWS[] = {
        0U, 1U, UINT64_MAX, UINT64_MAX - 1U, (uint64_t)INT64_MAX, (uint64_t)INT64_MAX + 1U};
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            for (int64_t hi = -2; hi <= 2; hi++) {
                ocel_i128_t acc = {hi, LOWS[j]};
                const i128_t expected = twin_of(&acc) + ADDENDS[i];
                ocel_i128_add64(&acc, ADDENDS[i]);
                assert_same(expected, &acc);
            }
        }
    }
}

/* floor(v / 2^n + 1/2) by one bit more. */
static i128_t rounded(i128_t v, uint32_t n) {
    return (n == 0U) ? v : (((v >> (n - 1U)) + 1) >> 1);
}

/* A value whose quotient by 2^n fits in 63 bits. */
static i128_t any_that_fits(uint32_t n) {
    const i128_t v = (i128_t)(((u128_t)rng_u64(&rng) << 64) | rng_u64(&rng));
    const uint32_t spare = (n < 65U) ? (65U - n) : 0U;
    return v >> (spare + rng_below(&rng, 128U - spare));
}

static void right_shift_rounds_to_nearest(void) {
    for (uint32_t n = 0U; n <= 127U; n++) {
        for (int i = 0; i < 2000; i++) {
            const i128_t v = any_that_fits(n);
            const ocel_i128_t wide = wide_of(v);
            TEST_ASSERT_EQUAL_INT64((int64_t)rounded(v, n), ocel_i128_shift_right(&wide, n));
            TEST_ASSERT_EQUAL_INT64((int64_t)rounded(v, n), ocel_i128_shift(&wide, (int32_t)n));
        }
    }
    const ocel_i128_t half = {0, (uint64_t)1U << 59U};
    const ocel_i128_t minus_half = wide_of(-((i128_t)1 << 59));
    TEST_ASSERT_EQUAL_INT64(1, ocel_i128_shift_right(&half, 60U)); /* halves go up */
    TEST_ASSERT_EQUAL_INT64(0, ocel_i128_shift_right(&minus_half, 60U));
}

static void left_shift_is_exact(void) {
    for (int32_t n = 1; n <= 63; n++) {
        for (int i = 0; i < 500; i++) {
            const int64_t fits = ocel_asr64((int64_t)rng_u64(&rng), (uint32_t)n);
            const ocel_i128_t wide = wide_of(fits);
            TEST_ASSERT_EQUAL_INT64((int64_t)((uint64_t)fits << (uint32_t)n),
                                    ocel_i128_shift(&wide, -n));
        }
    }
}

static void check_bits(i128_t v) {
    const ocel_i128_t wide = wide_of(v);
    const uint32_t k = ocel_i128_bits(&wide);
    TEST_ASSERT_TRUE(k <= 127U);
    if (k < 127U) {
        TEST_ASSERT_TRUE((v < ((i128_t)1 << k)) && (v >= -((i128_t)1 << k)));
    }
    if (k > 0U) {
        const i128_t below = (i128_t)1 << (k - 1U);
        TEST_ASSERT_TRUE((v >= below) || (v < -below)); /* and no fewer */
    }
}

static void bits_are_the_fewest(void) {
    check_bits(0);
    for (uint32_t k = 0U; k < 127U; k++) {
        const i128_t power = (i128_t)1 << k;
        check_bits(power);
        check_bits(power - 1);
        check_bits(-power);
        check_bits(-power - 1);
        check_bits(1 - power);
    }
    for (int i = 0; i < RANDOM_TRIALS; i++) {
        check_bits(any_that_fits(127U));
    }
}

int main(void) {
    printf("seed %d\n", SEED);
    UNITY_BEGIN();
    RUN_TEST(products_of_the_edges);
    RUN_TEST(sums_of_random_products);
    RUN_TEST(adding_carries_and_borrows);
    RUN_TEST(right_shift_rounds_to_nearest);
    RUN_TEST(left_shift_is_exact);
    RUN_TEST(bits_are_the_fewest);
    return UNITY_END();
}
