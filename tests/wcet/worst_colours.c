/* SPDX-License-Identifier: MIT
 *
 * Lines that cannot be rejected at a glance, of every format, by every kind of range.
 */
#include <string.h>

#include <ocellus/ocellus.h>

#include "rng.h"
#include "worst.h"

enum { WIDTH = OCEL_MAX_WIDTH, FORMATS = 5, SPACES = 4, PALETTE = 8, LINES = 3 };

static uint8_t line[3 * WIDTH + 1];
static uint32_t row[OCEL_ROW_WORDS];
static ocel_colour_t colour;
static ocel_colour_table_t table;
static ocel_teach_t teach;

/* Hue wraps in the second, so that both of its sides are looked at. */
static const ocel_colour_range_t ranges[] = {
    {OCEL_SPACE_RGB, {1, 1, 1}, {255, 255, 255}},
    {OCEL_SPACE_RGB, {200, 61, 1}, {255, 150, 80}},
    {OCEL_SPACE_HSV, {300, 1, 1}, {200, 255, 255}},
    {OCEL_SPACE_HSV, {5, 100, 150}, {45, 255, 255}},
    {OCEL_SPACE_HSV, {200, 3, 5}, {330, 250, 253}},
    {OCEL_SPACE_YUV, {1, 1, 1}, {254, 254, 254}},
    {OCEL_SPACE_YUV, {121, 61, 181}, {160, 100, 220}},
    {OCEL_SPACE_GRAY, {1, 0, 0}, {255, 0, 0}},
};

/* Triples on both sides of what the ranges let through. */
static const uint8_t palette[PALETTE][3] = {
    {225, 105, 35}, {35, 225, 105}, {105, 35, 225},  {255, 254, 1},
    {1, 255, 254},  {254, 1, 255},  {128, 128, 127}, {201, 62, 2},
};

static void fill_line(rng_t *rng, int32_t kind) {
    for (int32_t i = 0; i < WIDTH; i++) {
        const uint32_t random = rng_u32(rng);
        const uint32_t which = (kind < PALETTE) ? (uint32_t)kind : (random % (uint32_t)PALETTE);
        memcpy(&line[3 * i], palette[which], 3U);
        if (kind > PALETTE) {
            line[3 * i] = (uint8_t)(random >> 8U);
            line[3 * i + 1] = (uint8_t)(random >> 16U);
            line[3 * i + 2] = (uint8_t)(random >> 24U);
        }
    }
}

static void test_lines(rng_t *rng) {
    for (int32_t kind = 0; kind < PALETTE + LINES; kind++) {
        fill_line(rng, kind);
        for (uint16_t width = WIDTH; width > (WIDTH - 18); width = (uint16_t)(width - 1U)) {
            const uint32_t shift = (uint32_t)width % 2U; /* a line may begin anywhere */
            (void)ocel_colour_row(&colour, &line[shift], sizeof(line) - shift, width, row);
        }
    }
}

static void table_lines(rng_t *rng) {
    for (int32_t kind = 0; kind < PALETTE + LINES; kind++) {
        fill_line(rng, kind);
        for (uint16_t width = WIDTH; width > (WIDTH - 9); width = (uint16_t)(width - 1U)) {
            (void)ocel_colour_table_row(&table, &line[1], sizeof(line) - 1U, width, row);
        }
    }
}

/* Two RGB565 pixels in turn, of which a glance says that the second of `ranges` may have
 * them. */
typedef struct {
    uint16_t pixel[2];
} pair_t;

static pair_t pair_of(char kind) {
    static const pair_t none_by_words = {{0xF800U, 0x034AU}};
    static const pair_t none = {{(31U << 11U) | (26U << 5U) | 31U, 0U}};
    static const pair_t all = {{(28U << 11U) | (26U << 5U) | 4U, (28U << 11U) | (26U << 5U) | 4U}};
    return (kind == 'w') ? none_by_words : ((kind == 'n') ? none : all);
}

/* A group of sixteen pixels for each character: w, none is in range and the table's words
 * tell; n, none is and they do not; a, all are. */
static void fill_groups(const char *groups) {
    for (uint32_t x = 0U; x < (uint32_t)WIDTH; x++) {
        const pair_t pair = pair_of(groups[x / 16U]);
        line[2U * x] = (uint8_t)pair.pixel[x % 2U];
        line[2U * x + 1U] = (uint8_t)(pair.pixel[x % 2U] >> 8U);
    }
}

/* What a search over the kinds of all groups found to take longest: nearly all are looked
 * up, many in vain, and now and then the table's words are asked. */
static void table_groups(void) {
    static const char *const longest[] = {"wnnnnwwnnnnnnnnwwnan", "wnnwnwnwwnnwwnwnwwnw",
                                          "nnnnwnwnnnnnnnnnnwww", "waaaaaaaaaaaaaaaaaaa"};
    for (size_t i = 0U; i < sizeof(longest) / sizeof(longest[0]); i++) {
        fill_groups(longest[i]);
        (void)ocel_colour_table_row(&table, line, sizeof(line), WIDTH, row);
        (void)ocel_colour_table_row(&table, line, sizeof(line), WIDTH - 1, row);
        (void)ocel_colour_row(&colour, line, sizeof(line), WIDTH - 1, row);
    }
}

/* YUYV of which every pixel passes the bounds of the bytes and is denied by its hue, the
 * last that is asked, with which of the formats and ranges a search found to take longest:
 * on M4 the first, on M0 the second. */
static void denied_lines(void) {
    static const ocel_colour_range_t range[] = {{OCEL_SPACE_HSV, {50, 26, 5}, {119, 255, 214}},
                                                {OCEL_SPACE_HSV, {318, 62, 24}, {128, 255, 252}}};
    static const uint8_t denied[][4] = {{55U, 25U, 57U, 81U}, {22U, 179U, 22U, 225U}};

    for (size_t k = 0U; k < sizeof(range) / sizeof(range[0]); k++) {
        (void)ocel_colour_compile(&colour, &range[k], OCEL_FORMAT_YUYV, NULL);
        for (size_t i = 0U; i < (size_t)WIDTH / 2U; i++) {
            memcpy(&line[4U * i], denied[k], sizeof(denied[k]));
        }
        for (uint16_t width = WIDTH; width > (WIDTH - 18); width = (uint16_t)(width - 2U)) {
            (void)ocel_colour_row(&colour, line, sizeof(line), width, row);
        }
    }
}

static void teach_lines(rng_t *rng, ocel_space_t space, ocel_format_t format) {
    ocel_colour_range_t learnt;

    (void)ocel_teach_begin(&teach, space, format);
    for (int32_t kind = 0; kind < PALETTE + LINES; kind++) {
        fill_line(rng, kind);
        (void)ocel_teach_line(&teach, line, sizeof(line), 0U, WIDTH);
    }
    (void)ocel_teach_end(&teach, &learnt);
}

void worst_colours(void) {
    rng_t rng = rng_seed(77U);

    denied_lines();
    for (int32_t format = 0; format < FORMATS; format++) {
        for (size_t i = 0U; i < sizeof(ranges) / sizeof(ranges[0]); i++) {
            (void)ocel_colour_compile(&colour, &ranges[i], (ocel_format_t)format, &table);
            if (format != (int32_t)OCEL_FORMAT_RGB565) {
                test_lines(&rng);
            } else if (i < 3U) {
                test_lines(&rng);
                table_lines(&rng);
                table_groups();
            } else {
                /* Another table is looked up as fast. */
            }
        }
        for (int32_t space = 0; space < SPACES; space++) {
            teach_lines(&rng, (ocel_space_t)space, (ocel_format_t)format);
        }
    }
}
