/* SPDX-License-Identifier: MIT
 *
 * Teaching: histograms against sorted values and exhaustive arcs, and round
 * trips from the taught pixels to the compiled range.
 */
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <ocellus/colour.h>

#include "board.h"
#include "rng.h"
#include "unity.h"

#define SEED 20240608U

enum { SPACES = 4, FORMATS = 5, LINE = 300 };

static ocel_teach_t teach;
static ocel_colour_table_t table;
static uint8_t line[3 * LINE];

void setUp(void) {
}

void tearDown(void) {
}

static int clip(int v) {
    return (v < 0) ? 0 : (v > 255) ? 255 : v;
}

static void put_rgb(int x, int r, int g, int b) {
    line[3 * x] = (uint8_t)clip(r);
    line[3 * x + 1] = (uint8_t)clip(g);
    line[3 * x + 2] = (uint8_t)clip(b);
}

static ocel_colour_range_t learn(ocel_space_t space, ocel_format_t format, int count) {
    ocel_colour_range_t range;
    memset(&range, 0xFF, sizeof range);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_teach_begin(&teach, space, format));
    TEST_ASSERT_EQUAL(OCEL_OK,
                      ocel_teach_line(&teach, line, ocel_colour_line_bytes(format, (uint16_t)count),
                                      0U, (uint16_t)count));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_teach_end(&teach, &range));
    TEST_ASSERT_EQUAL(space, range.space);
    return range;
}

/* ---- Channels that are bytes ---- */

/* 100 values, 50..149 once each: 2 % are the two at either end, so the middle is
 * 52..147; a quarter of that width, 23, is more than the margin. */
static void test_middle_of_known_values(void) {
    for (int x = 0; x < 100; x++) {
        put_rgb(x, 50 + (x * 37) % 100, 200, 10);
    }
    const ocel_colour_range_t range = learn(OCEL_SPACE_RGB, OCEL_FORMAT_RGB888, 100);
    TEST_ASSERT_EQUAL(28, range.lo[0]); /* 29, outwards to even */
    TEST_ASSERT_EQUAL(171, range.hi[0]);
    TEST_ASSERT_EQUAL(192, range.lo[1]); /* no width: the margin of 8 */
    TEST_ASSERT_EQUAL(209, range.hi[1]); /* 208, outwards to odd */
    TEST_ASSERT_EQUAL(2, range.lo[2]);
    TEST_ASSERT_EQUAL(19, range.hi[2]);
}

static void test_clipped_to_the_space(void) {
    for (int x = 0; x < 64; x++) {
        put_rgb(x, 0, 255, (x % 2 != 0) ? 0 : 255);
    }
    const ocel_colour_range_t range = learn(OCEL_SPACE_RGB, OCEL_FORMAT_RGB888, 64);
    TEST_ASSERT_EQUAL(0, range.lo[0]);
    TEST_ASSERT_EQUAL(9, range.hi[0]);
    TEST_ASSERT_EQUAL(246, range.lo[1]);
    TEST_ASSERT_EQUAL(255, range.hi[1]);
    TEST_ASSERT_EQUAL(0, range.lo[2]);
    TEST_ASSERT_EQUAL(255, range.hi[2]);
}

static int by_value(const void *a, const void *b) {
    return *(const int *)a - *(const int *)b;
}

/* The definition, by sorting. */
static void twin_channel(int *values, int count, int margin, int *lo, int *hi) {
    qsort(values, (size_t)count, sizeof values[0], by_value);
    const int from = values[count / 50];
    const int to = values[count - 1 - count / 50];
    const int widen = ((to - from) / 4 > margin) ? (to - from) / 4 : margin;
    *lo = clip(from - widen) & ~1;
    *hi = clip(to + widen) | 1;
}

static void expect_twin(const ocel_colour_range_t *range, int k, int *values, int count,
                        int margin) {
    int lo = 0;
    int hi = 0;
    char text[80];
    twin_channel(values, count, margin, &lo, &hi);
    (void)snprintf(text, sizeof text, "seed %u channel %d count %d", SEED, k, count);
    TEST_ASSERT_EQUAL_MESSAGE(lo, range->lo[k], text);
    TEST_ASSERT_EQUAL_MESSAGE(hi, range->hi[k], text);
}

static void test_rgb_against_sorting(void) {
    rng_t rng = rng_seed(SEED);
    for (int trial = 0; trial < TEST_TRIALS(500); trial++) {
        const int count = (int)rng_between(&rng, 16, LINE);
        const int middle[3] = {(int)rng_below(&rng, 256U), (int)rng_below(&rng, 256U),
                               (int)rng_below(&rng, 256U)};
        const double spread = rng_uniform(&rng, 0.0, 60.0);
        int values[3][LINE];
        for (int x = 0; x < count; x++) {
            for (int k = 0; k < 3; k++) {
                values[k][x] = clip(middle[k] + (int)floor(spread * rng_gauss(&rng)));
            }
            put_rgb(x, values[0][x], values[1][x], values[2][x]);
        }
        const ocel_colour_range_t range = learn(OCEL_SPACE_RGB, OCEL_FORMAT_RGB888, count);
        for (int k = 0; k < 3; k++) {
            expect_twin(&range, k, values[k], count, 8);
        }
    }
}

/* YUYV lines are learnt in YUV as they are: two Y, one U, one V a pair. */
static void test_yuyv_against_sorting(void) {
    rng_t rng = rng_seed(SEED + 1U);
    for (int trial = 0; trial < TEST_TRIALS(200); trial++) {
        const int count = 2 * (int)rng_between(&rng, 8, LINE / 2);
        int values[3][LINE];
        for (int x = 0; x < count; x++) {
            values[0][x] = clip((int)rng_between(&rng, 60, 90));
            values[1][x] = ((x % 2) == 0) ? (int)rng_between(&rng, 90, 95) : values[1][x - 1];
            values[2][x] = ((x % 2) == 0) ? (int)rng_between(&rng, 170, 240) : values[2][x - 1];
            line[2 * x] = (uint8_t)values[0][x];
            line[2 * x + 1] = (uint8_t)values[((x % 2) == 0) ? 1 : 2][x];
        }
        const ocel_colour_range_t range = learn(OCEL_SPACE_YUV, OCEL_FORMAT_YUYV, count);
        expect_twin(&range, 0, values[0], count, 8);
        expect_twin(&range, 1, values[1], count, 4);
        expect_twin(&range, 2, values[2], count, 4);
    }
}

static void test_gray_uses_channel_0_only(void) {
    int values[LINE];
    rng_t rng = rng_seed(SEED + 2U);
    for (int x = 0; x < LINE; x++) {
        values[x] = (int)rng_between(&rng, 100, 180);
        line[x] = (uint8_t)values[x];
    }
    const ocel_colour_range_t range = learn(OCEL_SPACE_GRAY, OCEL_FORMAT_GRAY8, LINE);
    expect_twin(&range, 0, values, LINE, 8);
    for (int k = 1; k < 3; k++) {
        TEST_ASSERT_EQUAL(0, range.lo[k]);
        TEST_ASSERT_EQUAL(255, range.hi[k]);
    }
}

/* ---- Hue ---- */

/* R, G, B of a hue in degrees with the largest and smallest channel given. */
static void put_hue(int x, double h_deg, double top, double bottom) {
    int rgb[3];
    for (int k = 0; k < 3; k++) {
        const double h = fmod(h_deg + 720.0 - 120.0 * k, 360.0);
        const double t = fmin(fmax(2.0 - fmin(h, 360.0 - h) / 60.0, 0.0), 1.0);
        rgb[k] = (int)floor(bottom + (top - bottom) * t + 0.5);
    }
    put_rgb(x, rgb[0], rgb[1], rgb[2]);
}

/* Degrees that the range covers, and whether it holds an angle. */
static int covered(const ocel_colour_range_t *range) {
    const int width = (int)range->hi[0] - (int)range->lo[0];
    return (width < 0) ? width + 360 : width;
}

static bool holds(const ocel_colour_range_t *range, double h_deg) {
    const double h = fmod(h_deg + 720.0, 360.0);
    return (range->lo[0] <= range->hi[0]) ? (h >= range->lo[0] && h <= range->hi[0])
                                          : (h >= range->lo[0] || h <= range->hi[0]);
}

static void test_hue_arc_wraps_at_red(void) {
    for (int x = 0; x < LINE; x++) {
        put_hue(x, -12.0 + 24.0 * x / (LINE - 1), 220.0, 30.0);
    }
    const ocel_colour_range_t range = learn(OCEL_SPACE_HSV, OCEL_FORMAT_RGB888, LINE);
    TEST_ASSERT_GREATER_THAN(range.hi[0], range.lo[0]); /* wraps */
    TEST_ASSERT_TRUE(holds(&range, -12.0));
    TEST_ASSERT_TRUE(holds(&range, 12.0));
    TEST_ASSERT_LESS_OR_EQUAL(24 * 3 / 2 + 4, covered(&range));
}

/* The widening alone may carry the arc over 0, from either side. */
static void test_hue_widening_wraps(void) {
    for (int x = 0; x < LINE; x++) {
        put_hue(x, 2.0 + 8.0 * x / (LINE - 1), 200.0, 20.0);
    }
    ocel_colour_range_t range = learn(OCEL_SPACE_HSV, OCEL_FORMAT_RGB888, LINE);
    TEST_ASSERT_GREATER_THAN(340, range.lo[0]);
    TEST_ASSERT_LESS_THAN(30, range.hi[0]);
    for (int x = 0; x < LINE; x++) {
        put_hue(x, 350.0 + 8.0 * x / (LINE - 1), 200.0, 20.0);
    }
    range = learn(OCEL_SPACE_HSV, OCEL_FORMAT_RGB888, LINE);
    TEST_ASSERT_GREATER_THAN(330, range.lo[0]);
    TEST_ASSERT_LESS_THAN(20, range.hi[0]);
}

/* The shortest arc by trying all: the weights are the chromas. */
static void twin_arc(const double *hue_deg, const int *chroma, int count, int *first, int *length) {
    long weight[256] = {0};
    long total = 0;
    for (int x = 0; x < count; x++) {
        weight[(int)floor(hue_deg[x] * 256.0 / 360.0 + 1e-9)] += chroma[x];
        total += chroma[x];
    }
    *length = 257;
    for (int from = 0; from < 256; from++) {
        long held = 0;
        for (int n = 1; n <= 256; n++) {
            held += weight[(from + n - 1) % 256];
            if (held >= total - total / 25) {
                if (n < *length) {
                    *first = from;
                    *length = n;
                }
                break;
            }
        }
    }
}

static double hue_of(int r, int g, int b, int chroma) {
    const int top = (r > g) ? ((r > b) ? r : b) : ((g > b) ? g : b);
    double h = 0.0;
    if (top == r) {
        h = fmod((double)(g - b) / chroma + 6.0, 6.0);
    } else if (top == g) {
        h = (double)(b - r) / chroma + 2.0;
    } else {
        h = (double)(r - g) / chroma + 4.0;
    }
    return 60.0 * h;
}

static void test_hue_against_every_arc(void) {
    const int trials = TEST_TRIALS(300);
    rng_t rng = rng_seed(SEED + 3U);
    int full_turns = 0;
    for (int trial = 0; trial < trials; trial++) {
        const double middle = rng_uniform(&rng, 0.0, 360.0);
        const double spread = rng_uniform(&rng, 0.0, 120.0);
        double hue[LINE];
        int chroma[LINE];
        int first = 0;
        int length = 0;
        for (int x = 0; x < LINE; x++) {
            put_hue(x, middle + spread * rng_gauss(&rng) + 720.0, rng_uniform(&rng, 120.0, 255.0),
                    rng_uniform(&rng, 0.0, 100.0));
            const uint8_t *const p = &line[3 * x];
            const int top =
                (p[0] > p[1]) ? ((p[0] > p[2]) ? p[0] : p[2]) : ((p[1] > p[2]) ? p[1] : p[2]);
            const int bottom =
                (p[0] < p[1]) ? ((p[0] < p[2]) ? p[0] : p[2]) : ((p[1] < p[2]) ? p[1] : p[2]);
            chroma[x] = top - bottom;
            TEST_ASSERT_GREATER_OR_EQUAL(8, chroma[x]);
            hue[x] = hue_of(p[0], p[1], p[2], chroma[x]);
        }
        twin_arc(hue, chroma, LINE, &first, &length);
        const ocel_colour_range_t range = learn(OCEL_SPACE_HSV, OCEL_FORMAT_RGB888, LINE);
        const int lo = (int)floor(first * 360.0 / 256.0);
        const int hi = (int)ceil((first + length) * 360.0 / 256.0);
        const int widen = ((hi - lo) / 4 > 4) ? (hi - lo) / 4 : 4;
        char text[60];
        (void)snprintf(text, sizeof text, "seed %u trial %d", SEED + 3U, trial);
        if (hi - lo + 2 * widen >= 360) {
            TEST_ASSERT_EQUAL_MESSAGE(0, range.lo[0], text);
            TEST_ASSERT_EQUAL_MESSAGE(360, range.hi[0], text);
            full_turns++;
        } else {
            TEST_ASSERT_EQUAL_MESSAGE((lo - widen + 360) % 360, range.lo[0], text);
            TEST_ASSERT_EQUAL_MESSAGE((hi + widen) % 360, range.hi[0], text);
        }
    }
    /* Both cases came up. */
    TEST_ASSERT_TRUE((full_turns > trials / 40) && (full_turns < trials - trials / 40));
}

/* An orange ball with white highlights and black shadows: these are left out. */
static void test_highlights_are_left_out(void) {
    rng_t rng = rng_seed(SEED + 4U);
    for (int x = 0; x < LINE; x++) {
        const int noise = (int)rng_between(&rng, -3, 3);
        if (x % 5 == 0) {
            put_rgb(x, 253 + noise, 253 + noise, 252 + noise);
        } else if (x % 5 == 1) {
            put_rgb(x, 6 + noise, 5 + noise, 5 + noise);
        } else {
            put_rgb(x, 225 + noise, 105 - noise, 35 + noise);
        }
    }
    const ocel_colour_range_t range = learn(OCEL_SPACE_HSV, OCEL_FORMAT_RGB888, LINE);
    TEST_ASSERT_TRUE(holds(&range, 22.0));
    TEST_ASSERT_LESS_OR_EQUAL(20, covered(&range));
    TEST_ASSERT_GREATER_THAN(150, range.lo[1]); /* so white walls are not the ball */
    TEST_ASSERT_GREATER_THAN(150, range.lo[2]);
}

/* A grey ball has every hue, and what keeps colours out is its saturation. */
static void test_grey_object_has_every_hue(void) {
    rng_t rng = rng_seed(SEED + 5U);
    for (int x = 0; x < LINE; x++) {
        put_rgb(x, 150 + (int)rng_between(&rng, -3, 3), 150 + (int)rng_between(&rng, -3, 3),
                150 + (int)rng_between(&rng, -3, 3));
    }
    const ocel_colour_range_t range = learn(OCEL_SPACE_HSV, OCEL_FORMAT_RGB888, LINE);
    TEST_ASSERT_EQUAL(0, range.lo[0]);
    TEST_ASSERT_EQUAL(360, range.hi[0]);
    TEST_ASSERT_EQUAL(0, range.lo[1]);
    TEST_ASSERT_LESS_THAN(40, range.hi[1]);
    TEST_ASSERT_GREATER_THAN(120, range.lo[2]);
    TEST_ASSERT_LESS_THAN(180, range.hi[2]);
}

/* 100 pixels of which `colourless` have chroma 7, the others a blue of `chroma`;
 * whether a hue was learnt. */
static bool learns_hue(int colourless, int chroma) {
    for (int x = 0; x < 100; x++) {
        if (x < colourless) {
            put_rgb(x, 100, 107, 100);
        } else {
            put_rgb(x, 100, 100, 100 + chroma);
        }
    }
    const ocel_colour_range_t range = learn(OCEL_SPACE_HSV, OCEL_FORMAT_RGB888, 100);
    TEST_ASSERT_TRUE(holds(&range, 240.0));
    TEST_ASSERT_TRUE((covered(&range) == 10) || (covered(&range) == 360));
    return covered(&range) == 10;
}

static void test_when_a_hue_is_learnt(void) {
    TEST_ASSERT_TRUE(learns_hue(0, 8));
    TEST_ASSERT_TRUE(learns_hue(3, 8)); /* 3.1 of 100 */
    TEST_ASSERT_FALSE(learns_hue(4, 15));
    TEST_ASSERT_TRUE(learns_hue(4, 16));
    TEST_ASSERT_TRUE(learns_hue(50, 16));
    TEST_ASSERT_FALSE(learns_hue(51, 100));
    TEST_ASSERT_FALSE(learns_hue(100, 0));
}

/* ---- Round trips ---- */

/* A pixel of the given R, G, B in any format; of YUYV the pair shares U and V. */
static void put_any(ocel_format_t format, int x, int r, int g, int b) {
    const unsigned p = ((unsigned)r >> 3 << 11) | ((unsigned)g >> 2 << 5) | ((unsigned)b >> 3);
    switch (format) {
    case OCEL_FORMAT_RGB565:
        line[2 * x] = (uint8_t)(p & 0xFFU);
        line[2 * x + 1] = (uint8_t)(p >> 8);
        break;
    case OCEL_FORMAT_RGB888:
        put_rgb(x, r, g, b);
        break;
    case OCEL_FORMAT_BGR888:
        put_rgb(x, b, g, r);
        break;
    case OCEL_FORMAT_YUYV:
        line[2 * x] = (uint8_t)clip((77 * r + 150 * g + 29 * b) / 256);
        line[2 * x + 1] = (uint8_t)clip(((x % 2) == 0) ? 128 + (128 * b - 43 * r - 85 * g) / 256
                                                       : 128 + (128 * r - 107 * g - 21 * b) / 256);
        break;
    case OCEL_FORMAT_GRAY8:
    default:
        line[x] = (uint8_t)g;
        break;
    }
}

static int count_in_range(const ocel_colour_range_t *range, ocel_format_t format) {
    uint32_t row[OCEL_ROW_WORDS];
    ocel_colour_t colour;
    int hits = 0;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_colour_compile(&colour, range, format, &table));
    TEST_ASSERT_EQUAL(
        OCEL_OK, ocel_colour_row(&colour, line, ocel_colour_line_bytes(format, LINE), LINE, row));
    for (int x = 0; x < LINE; x++) {
        hits += (int)((row[x / 32] >> (x % 32)) & 1U);
    }
    return hits;
}

/* A shaded, noisy patch of one colour, in every format and space: at least 90 %
 * of its own pixels are in range, and a background of another colour is not. */
static void round_trip(ocel_format_t format, ocel_space_t space, rng_t *rng, const int *rgb) {
    for (int x = 0; x < LINE; x++) {
        const double light = 0.8 + 0.3 * ((x / 2) % 50) / 50.0;
        int noisy[3];
        for (int k = 0; k < 3; k++) {
            noisy[k] = clip((int)(light * rgb[k]) + (int)rng_between(rng, -4, 4));
        }
        put_any(format, x, noisy[0], noisy[1], noisy[2]);
    }
    const ocel_colour_range_t range = learn(space, format, LINE);
    char text[80];
    (void)snprintf(text, sizeof text, "format %d space %d colour %d %d %d", (int)format, (int)space,
                   rgb[0], rgb[1], rgb[2]);
    TEST_ASSERT_GREATER_OR_EQUAL_MESSAGE(LINE * 9 / 10, count_in_range(&range, format), text);
    for (int x = 0; x < LINE; x++) {
        put_any(format, x, 255 - rgb[0], 255 - rgb[1], 255 - rgb[2]);
    }
    TEST_ASSERT_EQUAL_MESSAGE(0, count_in_range(&range, format), text);
}

static void test_round_trips(void) {
    static const int colours[][3] = {{225, 105, 35}, {200, 20, 30}, {30, 190, 60},   {20, 60, 200},
                                     {215, 220, 40}, {40, 42, 38},  {230, 228, 231}, {120, 20, 20}};
    rng_t rng = rng_seed(SEED + 6U);
    for (int format = 0; format < FORMATS; format++) {
        for (int space = 0; space < SPACES; space++) {
            for (size_t k = 0U; k < sizeof colours / sizeof colours[0]; k++) {
                const double y =
                    0.299 * colours[k][0] + 0.587 * colours[k][1] + 0.114 * colours[k][2];
                if ((space == (int)OCEL_SPACE_GRAY) && (fabs(y - 127.5) < 50.0)) {
                    continue; /* its complement has about the same grey */
                }
                if ((format == (int)OCEL_FORMAT_GRAY8) && (abs(2 * colours[k][1] - 255) < 100)) {
                    continue;
                }
                round_trip((ocel_format_t)format, (ocel_space_t)space, &rng, colours[k]);
            }
        }
    }
}

/* Lines and parts of lines add up; an odd first pixel of YUYV is the right one. */
static void test_parts_of_lines(void) {
    ocel_colour_range_t range;
    for (int x = 0; x < LINE; x++) {
        line[2 * x] = (uint8_t)((x == 1 || x == 2) ? 90 : 10);
        line[2 * x + 1] = (uint8_t)(((x % 2) == 0) ? 60 : 200);
    }
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_teach_begin(&teach, OCEL_SPACE_YUV, OCEL_FORMAT_YUYV));
    for (int k = 0; k < 8; k++) {
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_teach_line(&teach, line, 8U, 1U, 2U));
    }
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_teach_end(&teach, &range));
    TEST_ASSERT_EQUAL(82, range.lo[0]);
    TEST_ASSERT_EQUAL(99, range.hi[0]);
    TEST_ASSERT_EQUAL(56, range.lo[1]);
    TEST_ASSERT_EQUAL(65, range.hi[1]);
    TEST_ASSERT_EQUAL(196, range.lo[2]);
    TEST_ASSERT_EQUAL(205, range.hi[2]);
}

/* ---- Hostile input ---- */

static void test_begin_hostile(void) {
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT,
                      ocel_teach_begin(NULL, OCEL_SPACE_RGB, OCEL_FORMAT_RGB565));
    for (int format = 5; format < 300; format += 59) {
        TEST_ASSERT_EQUAL(OCEL_BAD_FORMAT,
                          ocel_teach_begin(&teach, OCEL_SPACE_RGB, (ocel_format_t)format));
        TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_teach_line(&teach, line, sizeof line, 0U, 16U));
    }
    TEST_ASSERT_EQUAL(OCEL_BAD_OPTION,
                      ocel_teach_begin(&teach, (ocel_space_t)4, OCEL_FORMAT_RGB565));
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_teach_line(&teach, line, sizeof line, 0U, 16U));
}

static void test_line_hostile(void) {
    ocel_teach_t before;
    memset(&teach, 0, sizeof teach);
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_teach_line(&teach, line, sizeof line, 0U, 16U));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_teach_begin(&teach, OCEL_SPACE_HSV, OCEL_FORMAT_YUYV));
    before = teach;
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_teach_line(NULL, line, sizeof line, 0U, 16U));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_teach_line(&teach, NULL, sizeof line, 0U, 16U));
    TEST_ASSERT_EQUAL(OCEL_BAD_SIZE, ocel_teach_line(&teach, line, sizeof line, 0U, 0U));
    TEST_ASSERT_EQUAL(OCEL_BAD_SIZE,
                      ocel_teach_line(&teach, line, sizeof line, 0U, OCEL_MAX_WIDTH + 1));
    TEST_ASSERT_EQUAL(OCEL_BAD_SIZE,
                      ocel_teach_line(&teach, line, sizeof line, OCEL_MAX_WIDTH, 1U));
    TEST_ASSERT_EQUAL(OCEL_BAD_SIZE, ocel_teach_line(&teach, line, sizeof line, 65535U, 65535U));
    TEST_ASSERT_EQUAL(OCEL_BAD_STRIDE, ocel_teach_line(&teach, line, 31U, 0U, 16U));
    TEST_ASSERT_EQUAL(OCEL_BAD_STRIDE, ocel_teach_line(&teach, line, 31U, 14U, 1U));
    TEST_ASSERT_EQUAL(OCEL_BAD_STRIDE, ocel_teach_line(&teach, line, 0U, 0U, 1U));
    TEST_ASSERT_EQUAL(0, memcmp(&before, &teach, sizeof teach));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_teach_line(&teach, line, 32U, 15U, 1U));
}

static void test_end_hostile(void) {
    ocel_colour_range_t range;
    ocel_colour_range_t untouched;
    memset(&untouched, 0x5A, sizeof untouched);
    range = untouched;
    memset(&teach, 0, sizeof teach);
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_teach_end(&teach, &range));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_teach_begin(&teach, OCEL_SPACE_HSV, OCEL_FORMAT_RGB888));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_teach_end(NULL, &range));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_teach_end(&teach, NULL));
    TEST_ASSERT_EQUAL(OCEL_TOO_FEW_POINTS, ocel_teach_end(&teach, &range));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_teach_line(&teach, line, 45U, 0U, 15U));
    TEST_ASSERT_EQUAL(OCEL_TOO_FEW_POINTS, ocel_teach_end(&teach, &range));
    TEST_ASSERT_EQUAL(0, memcmp(&untouched, &range, sizeof range));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_teach_line(&teach, line, 3U, 0U, 1U));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_teach_end(&teach, &range));
}

/* As if all that was added had been added so many times. */
static void count_again(uint32_t times) {
    for (int v = 0; v < 256; v++) {
        for (int k = 0; k < 3; k++) {
            teach.count[k][v] *= times;
        }
        teach.hueless[0][v] *= times;
        teach.hueless[1][v] *= times;
    }
    teach.pixels *= times;
    teach.hueless_pixels *= times;
}

/* The most that fits, of the heaviest hue, and one pixel more. */
static void test_capacity(void) {
    const int times = (OCEL_TEST_REDUCED == 1) ? 1 : 64; /* 2^24 pixels take a board long */
    ocel_colour_range_t range;
    for (int x = 0; x < 256; x++) {
        put_rgb(x, 255, 0, 0);
    }
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_teach_begin(&teach, OCEL_SPACE_HSV, OCEL_FORMAT_RGB888));
    for (int k = 0; k < 65536 / times; k++) {
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_teach_line(&teach, line, 768U, 0U, 256U));
    }
    count_again(times);
    TEST_ASSERT_EQUAL(OCEL_OVERFLOW, ocel_teach_line(&teach, line, 768U, 0U, 1U));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_teach_end(&teach, &range));
    TEST_ASSERT_EQUAL(356, range.lo[0]);
    TEST_ASSERT_EQUAL(6, range.hi[0]); /* a bin's 1.4 degrees, up, and 4 */
    TEST_ASSERT_EQUAL(239, range.lo[1]);
    TEST_ASSERT_EQUAL(255, range.hi[2]);
}

int main(void) {
    UNITY_BEGIN();
    RUN_TEST(test_middle_of_known_values);
    RUN_TEST(test_clipped_to_the_space);
    RUN_TEST(test_rgb_against_sorting);
    RUN_TEST(test_yuyv_against_sorting);
    RUN_TEST(test_gray_uses_channel_0_only);
    RUN_TEST(test_hue_arc_wraps_at_red);
    RUN_TEST(test_hue_widening_wraps);
    RUN_TEST(test_hue_against_every_arc);
    RUN_TEST(test_highlights_are_left_out);
    RUN_TEST(test_grey_object_has_every_hue);
    RUN_TEST(test_when_a_hue_is_learnt);
    RUN_TEST(test_round_trips);
    RUN_TEST(test_parts_of_lines);
    RUN_TEST(test_begin_hostile);
    RUN_TEST(test_line_hostile);
    RUN_TEST(test_end_hostile);
    RUN_TEST(test_capacity);
    return UNITY_END();
}
