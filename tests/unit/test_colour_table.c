/* SPDX-License-Identifier: MIT
 *
 * Lines by a table alone: against the table read pixel by pixel, and against
 * the compiled range that made the table.
 */
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
    RUN_TEST(test_bad_calls);
    return UNITY_END();
}
