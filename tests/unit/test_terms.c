/* SPDX-License-Identifier: MIT
 *
 * Tables of sums of products beside the same sums written down, and numbers that are
 * scaled together beside each scaled alone.
 */
#include <stdbool.h>
#include <stdio.h>

#include "base/int_math.h"
#include "base/q60.h"
#include "base/scale.h"
#include "base/scale_all.h"
#include "base/terms.h"
#include "board.h"
#include "rng.h"
#include "unity.h"

enum { SEED = 20110641, TRIALS = TEST_TRIALS(20000), PLACES = 64, LONGEST = OCEL_MAX_TERMS };

static rng_t rng;

void setUp(void) {
    rng = rng_seed(SEED);
}

void tearDown(void) {
}

/* |.| < 2^59, of any size. */
static int64_t any_number(void) {
    const int64_t v = (int64_t)(rng_u64(&rng) >> (5U + rng_below(&rng, 59U)));

    return (rng_below(&rng, 2U) != 0U) ? -v : v;
}

/* A random table; every fifth term at the latest ends a sum. */
static uint32_t any_table(ocel_term_t *terms) {
    const uint32_t count = 1U + (uint32_t)rng_below(&rng, LONGEST);

    for (uint32_t i = 0U; i < count; i++) {
        const bool last = (i + 1U) == count;
        const bool ends = last || ((i % 5U) == 4U) || (rng_below(&rng, 2U) != 0U);
        uint32_t to = ends ? (1U + (uint32_t)rng_below(&rng, PLACES - 1U)) : OCEL_GOES_ON;

        to |= (rng_below(&rng, 2U) != 0U) ? OCEL_MINUS : 0U;
        to |= last ? OCEL_LAST : 0U;
        terms[i].to = (uint8_t)to;
        terms[i].a = (uint8_t)rng_below(&rng, PLACES);
        terms[i].b = (uint8_t)rng_below(&rng, PLACES);
    }
    return count;
}

/* Numbers start below 2^53 and products of such are smaller still: nothing outgrows 2. */
static void a_table_is_its_sums(void) {
    for (int trial = 0; trial < TRIALS; trial++) {
        ocel_term_t terms[LONGEST];
        int64_t got[PLACES];
        int64_t want[PLACES];
        const uint32_t count = any_table(terms);
        int64_t sum = 0;

        for (uint32_t i = 0U; i < PLACES; i++) {
            got[i] = any_number() / 64;
            want[i] = got[i];
        }
        ocel_sum_terms(got, terms);
        for (uint32_t i = 0U; i < count; i++) {
            const int64_t product = ocel_mul_q60(want[terms[i].a], want[terms[i].b]);
            const uint32_t to = terms[i].to & 0x3FU;

            sum += ((terms[i].to & OCEL_MINUS) != 0U) ? -product : product;
            if (to != 0U) {
                want[to] = sum;
                sum = 0;
            }
        }
        TEST_ASSERT_EQUAL_INT64_ARRAY(want, got, PLACES);
    }
}

static void numbers_are_scaled_as_each_alone(void) {
    for (int trial = 0; trial < TRIALS; trial++) {
        const uint32_t count = 1U + (uint32_t)rng_below(&rng, OCEL_MAX_VECTOR);
        const int32_t e = (int32_t)rng_below(&rng, 66U) - 62;
        int64_t got[OCEL_MAX_VECTOR];
        int64_t want[OCEL_MAX_VECTOR];

        for (uint32_t i = 0U; i < OCEL_MAX_VECTOR; i++) {
            got[i] = any_number();
            want[i] = (i < count) ? ocel_scale_q60(got[i], e) : got[i];
        }
        ocel_scale_all(got, count, e);
        TEST_ASSERT_EQUAL_INT64_ARRAY(want, got, OCEL_MAX_VECTOR);
    }
}

/* floor(v / 2^n + 1/2) by division, and v 2^n. */
static void a_number_is_scaled_to_the_nearest(void) {
    for (int trial = 0; trial < TRIALS; trial++) {
        const int64_t v = any_number();
        const uint32_t n = 1U + (uint32_t)rng_below(&rng, 60U);
        const int64_t unit = (int64_t)1 << n;
        const int64_t up = v + (unit / 2);
        const int64_t nearest = (up / unit) - (((up % unit) < 0) ? 1 : 0);

        TEST_ASSERT_EQUAL_INT64(nearest, ocel_scale_q60(v, -(int32_t)n));
        TEST_ASSERT_EQUAL_INT64(v * 8, ocel_scale_q60(v, 3));
        TEST_ASSERT_EQUAL_INT64(v, ocel_scale_q60(v, 0));
    }
}

static void the_largest_gets_its_bits(void) {
    for (int trial = 0; trial < TRIALS; trial++) {
        const uint32_t count = 1U + (uint32_t)rng_below(&rng, OCEL_MAX_VECTOR);
        const int32_t bits = 29 + (int32_t)rng_below(&rng, 32U);
        int64_t got[OCEL_MAX_VECTOR];
        int64_t was[OCEL_MAX_VECTOR];
        uint64_t most = 0U;
        int32_t most_bits = 0;
        int32_t down;

        for (uint32_t i = 0U; i < count; i++) {
            got[i] = any_number() | 1;
            was[i] = got[i];
            most = (ocel_abs64(got[i]) > most) ? ocel_abs64(got[i]) : most;
        }
        while ((most_bits < 64) && ((most >> (uint32_t)most_bits) != 0U)) {
            most_bits++;
        }
        TEST_ASSERT_EQUAL_INT32(most_bits, ocel_bits_of(got, count));
        down = ocel_normalise(got, count, bits);
        TEST_ASSERT_EQUAL_INT32(most_bits - bits, down);
        for (uint32_t i = 0U; i < count; i++) {
            TEST_ASSERT_EQUAL_INT64(ocel_scale_q60(was[i], -down), got[i]);
        }
    }
}

int main(void) {
    printf("seed %d\n", SEED);
    UNITY_BEGIN();
    RUN_TEST(a_table_is_its_sums);
    RUN_TEST(numbers_are_scaled_as_each_alone);
    RUN_TEST(a_number_is_scaled_to_the_nearest);
    RUN_TEST(the_largest_gets_its_bits);
    return UNITY_END();
}
