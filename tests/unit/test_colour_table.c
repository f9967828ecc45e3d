/* SPDX-License-Identifier: MIT
 *
 * Lines by a table alone: against the table read pixel by pixel, and against
 * the compiled range that made the table.
 */
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <ocellus/ocellus.h>

#include "rng.h"
#include "unity.h"

enum { SEED = 20120701, WORDS = OCEL_ROW_WORDS, GUARD = 0x5A };

static rng_t rng;
static ocel_colour_table_t table;
static uint8_t line[2 * OCEL_MAX_WIDTH + 3];
static uint32_t row[WORDS + 1];

void setUp(void) {
    rng = rng_seed(SEED);
    for (size_t i = 0; i < OCEL_COLOUR_TABLE_WORDS; i++) {
        table.word[i] = rng_u32(&rng) & rng_u32(&rng);
    }
}

void tearDown(void) {
}

static void draw_line(uint8_t *at, uint16_t width) {
    for (uint32_t i = 0; i < 2U * width; i++) {
        at[i] = (uint8_t)rng_u32(&rng);
    }
}

/* Every width, at both alignments, with a guard behind line and row. */
static void test_every_width(void) {
    for (uint16_t width = 1; width <= OCEL_MAX_WIDTH; width++) {
        uint8_t *at = &line[width & 1U];
        const uint32_t words = (width + 31U) / 32U;
        draw_line(at, width);
        memset(row, GUARD, sizeof(row));
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_colour_table_row(&table, at, 2U * width, width, row));
        for (uint32_t x = 0; x < 32U * words; x++) {
            const uint32_t pixel =
                (x < width) ? (at[2U * x] | ((uint32_t)at[2U * x + 1U] << 8U)) : 0U;
            const uint32_t wanted =
                (x < width) ? ((table.word[pixel >> 5U] >> (pixel & 31U)) & 1U) : 0U;
            TEST_ASSERT_EQUAL_UINT32(wanted, (row[x / 32U] >> (x % 32U)) & 1U);
        }
        TEST_ASSERT_EQUAL_HEX32(0x5A5A5A5AU, row[words]);
    }
}

static void test_the_bits_of_a_compiled_range(void) {
    const ocel_colour_range_t range = {OCEL_SPACE_HSV, {340, 100, 60}, {25, 255, 255}};
    ocel_colour_t colour;
    uint32_t twin[WORDS];
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_colour_compile(&colour, &range, OCEL_FORMAT_RGB565, &table));
    for (int trial = 0; trial < 500; trial++) {
        const uint16_t width = (uint16_t)(1U + rng_below(&rng, OCEL_MAX_WIDTH));
        const size_t words = (width + 31U) / 32U;
        draw_line(line, width);
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_colour_row(&colour, line, 2U * width, width, twin));
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_colour_table_row(&table, line, 2U * width, width, row));
        TEST_ASSERT_EQUAL_HEX32_ARRAY(twin, row, words);
    }
}

/* A box of colours, and what the table says of it. */
static void draw_box(uint32_t lo[3], uint32_t hi[3]) {
    static const uint32_t top[3] = {31, 63, 31};
    for (int c = 0; c < 3; c++) {
        const uint32_t a = rng_below(&rng, top[c] + 1U);
        const uint32_t b = rng_below(&rng, top[c] + 1U);
        lo[c] = (a < b) ? a : b;
        hi[c] = (a < b) ? b : a;
    }
    for (uint32_t p = 0; p < 65536U; p++) {
        const uint32_t v[3] = {p >> 11U, (p >> 5U) & 63U, p & 31U};
        const bool in = (v[0] >= lo[0]) && (v[0] <= hi[0]) && (v[1] >= lo[1]) && (v[1] <= hi[1]) &&
                        (v[2] >= lo[2]) && (v[2] <= hi[2]);
        const uint32_t bit = 1U << (p % 32U);
        table.word[p / 32U] = in ? (table.word[p / 32U] | bit) : (table.word[p / 32U] & ~bit);
    }
    table.least = (uint16_t)((lo[0] << 11U) | (lo[1] << 5U) | lo[2]);
    table.headroom = (uint16_t)(((31U - hi[0]) << 11U) | ((63U - hi[1]) << 5U) | (31U - hi[2]));
}

/* Lines of stretches that keep to one side of the box in a channel, by one level or
 * more, so that a glance may reject them, and of single pixels in range. */
static void draw_stretches(uint8_t *at, uint16_t width, const uint32_t lo[3],
                           const uint32_t hi[3]) {
    static const uint32_t top[3] = {31, 63, 31};
    uint32_t from[3] = {0, 0, 0};
    uint32_t to[3] = {31, 63, 31};
    for (uint32_t x = 0; x < width; x++) {
        if (rng_below(&rng, 12U) == 0U) {
            const uint32_t c = rng_below(&rng, 3U);
            const bool below = rng_below(&rng, 2U) == 0U;
            for (uint32_t k = 0; k < 3U; k++) {
                from[k] = (rng_below(&rng, 2U) == 0U) ? lo[k] : 0U;
                to[k] = (rng_below(&rng, 2U) == 0U) ? hi[k] : top[k];
            }
            from[c] = below ? 0U : hi[c] + 1U;
            to[c] = below ? lo[c] - 1U : top[c];
        }
        const bool single = rng_below(&rng, 40U) == 0U;
        uint32_t v[3];
        for (uint32_t k = 0; k < 3U; k++) {
            const uint32_t first = single ? lo[k] : from[k];
            const uint32_t last = single ? hi[k] : to[k];
            v[k] = (first <= last) && (last <= top[k])
                       ? first + rng_below(&rng, (last - first) + 1U)
                       : rng_below(&rng, top[k] + 1U);
        }
        const uint32_t p = (v[0] << 11U) | (v[1] << 5U) | v[2];
        at[2U * x] = (uint8_t)p;
        at[2U * x + 1U] = (uint8_t)(p >> 8U);
    }
}

/* With what the table says of the range's extremes, and without. */
static void test_a_glance_changes_nothing(void) {
    uint32_t twin[WORDS];
    for (int trial = 0; trial < 100; trial++) {
        uint32_t lo[3];
        uint32_t hi[3];
        draw_box(lo, hi);
        for (int i = 0; i < 40; i++) {
            const uint16_t width = (uint16_t)(1U + rng_below(&rng, OCEL_MAX_WIDTH));
            const ocel_colour_table_t glance = table;
            memset(twin, 0, sizeof(twin));
            draw_stretches(line, width, lo, hi);
            for (uint32_t x = 0; x < width; x++) {
                const uint32_t pixel = line[2U * x] | ((uint32_t)line[2U * x + 1U] << 8U);
                twin[x / 32U] |= ((table.word[pixel / 32U] >> (pixel % 32U)) & 1U) << (x % 32U);
            }
            TEST_ASSERT_EQUAL(OCEL_OK, ocel_colour_table_row(&table, line, 2U * width, width, row));
            TEST_ASSERT_EQUAL_HEX32_ARRAY(twin, row, (width + 31U) / 32U);
            table.least = 0;
            table.headroom = 0;
            TEST_ASSERT_EQUAL(OCEL_OK, ocel_colour_table_row(&table, line, 2U * width, width, row));
            TEST_ASSERT_EQUAL_HEX32_ARRAY(twin, row, (width + 31U) / 32U);
            table = glance;
        }
    }
}

/* The extremes that compiling finds are the colours', greens by twos. */
static void test_the_extremes_of_a_compiled_range(void) {
    for (int trial = 0; trial < 20; trial++) {
        ocel_colour_range_t range = {OCEL_SPACE_RGB, {0, 0, 0}, {0, 0, 0}};
        ocel_colour_t colour;
        uint32_t lo[3] = {31, 63, 31};
        uint32_t hi[3] = {0, 0, 0};
        bool some = false;
        for (int c = 0; c < 3; c++) {
            range.lo[c] = (uint16_t)rng_below(&rng, 256U);
            range.hi[c] = (uint16_t)(range.lo[c] + rng_below(&rng, 256U - range.lo[c]));
        }
        TEST_ASSERT_EQUAL(OCEL_OK,
                          ocel_colour_compile(&colour, &range, OCEL_FORMAT_RGB565, &table));
        for (uint32_t p = 0; p < 65536U; p++) {
            const uint32_t v[3] = {p >> 11U, (p >> 5U) & 63U, p & 31U};
            if (((table.word[p / 32U] >> (p % 32U)) & 1U) != 0U) {
                some = true;
                for (int c = 0; c < 3; c++) {
                    lo[c] = (v[c] < lo[c]) ? v[c] : lo[c];
                    hi[c] = (v[c] > hi[c]) ? v[c] : hi[c];
                }
            }
        }
        const uint32_t least = (lo[0] << 11U) | ((lo[1] & ~1U) << 5U) | lo[2];
        const uint32_t headroom =
            ((31U - hi[0]) << 11U) | (((63U - hi[1]) & ~1U) << 5U) | (31U - hi[2]);
        TEST_ASSERT_EQUAL_HEX16(some ? least : 0U, table.least);
        TEST_ASSERT_EQUAL_HEX16(some ? headroom : 0U, table.headroom);
    }
}

static void test_bad_calls(void) {
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_colour_table_row(NULL, line, 64, 32, row));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_colour_table_row(&table, NULL, 64, 32, row));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_colour_table_row(&table, line, 64, 32, NULL));
    TEST_ASSERT_EQUAL(OCEL_BAD_SIZE, ocel_colour_table_row(&table, line, 64, 0, row));
    TEST_ASSERT_EQUAL(OCEL_BAD_SIZE,
                      ocel_colour_table_row(&table, line, sizeof(line), OCEL_MAX_WIDTH + 1, row));
    TEST_ASSERT_EQUAL(OCEL_BAD_STRIDE, ocel_colour_table_row(&table, line, 63, 32, row));
}

int main(void) {
    printf("seed %d\n", (int)SEED);
    UNITY_BEGIN();
    RUN_TEST(test_every_width);
    RUN_TEST(test_the_bits_of_a_compiled_range);
    RUN_TEST(test_a_glance_changes_nothing);
    RUN_TEST(test_the_extremes_of_a_compiled_range);
    RUN_TEST(test_bad_calls);
    return UNITY_END();
}
