/* SPDX-License-Identifier: MIT
 *
 * Colour against an independent twin: textbook formulas in double, one pixel at
 * a time.  Compiled a second time with OCEL_WORD_BITS=32 as test_colour_narrow.
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
#include "colour/bounds.h"
#include "colour/lanes.h"
#include "colour/pixel.h"
#include "colour/row16.h"
#include "colour/row24.h"
#include "rng.h"
#include "unity.h"

#define SEED 20240607U

enum { SPACES = 4, FORMATS = 5 };

static ocel_colour_table_t table;

void setUp(void) {
}

void tearDown(void) {
}

/* ---- The twin ---- */

typedef struct {
    double c[3];
} triple_t;

static double clip(double v) {
    return fmin(fmax(v, 0.0), 255.0);
}

static triple_t twin_rgb565(unsigned p) {
    const unsigned r = p >> 11;
    const unsigned g = (p >> 5) & 63U;
    const unsigned b = p & 31U;
    const triple_t rgb = {
        {(double)((r * 33U) >> 2), (double)((g * 65U) >> 4), (double)((b * 33U) >> 2)}};
    return rgb;
}

static triple_t twin_rgb_of_yuv(triple_t yuv) {
    const double y = yuv.c[0];
    const double u = yuv.c[1] - 128.0;
    const double v = yuv.c[2] - 128.0;
    const triple_t rgb = {{clip(floor(y + v * (91881.0 / 65536.0) + 0.5)),
                           clip(floor(y - u * (22554.0 / 65536.0) - v * (46802.0 / 65536.0) + 0.5)),
                           clip(floor(y + u * (116130.0 / 65536.0) + 0.5))}};
    return rgb;
}

/* Y rounds halves up, U and V halves down. */
static triple_t twin_yuv_of_rgb(triple_t rgb) {
    const double r = rgb.c[0];
    const double g = rgb.c[1];
    const double b = rgb.c[2];
    const triple_t yuv = {{floor((77.0 * r + 150.0 * g + 29.0 * b) / 256.0 + 0.5),
                           ceil(128.0 + (-43.0 * r - 85.0 * g + 128.0 * b) / 256.0 - 0.5),
                           ceil(128.0 + (128.0 * r - 107.0 * g - 21.0 * b) / 256.0 - 0.5)}};
    return yuv;
}

static triple_t twin_hsv_of_rgb(triple_t rgb) {
    const double r = rgb.c[0];
    const double g = rgb.c[1];
    const double b = rgb.c[2];
    const double top = fmax(r, fmax(g, b));
    const double chroma = top - fmin(r, fmin(g, b));
    double h = 0.0;
    if (chroma > 0.0) {
        if (top == r) {
            h = fmod((g - b) / chroma + 6.0, 6.0);
        } else if (top == g) {
            h = (b - r) / chroma + 2.0;
        } else {
            h = (r - g) / chroma + 4.0;
        }
    }
    const triple_t hsv = {{60.0 * h, (top > 0.0) ? 255.0 * chroma / top : 0.0, top}};
    return hsv;
}

/* Every value here is a fraction with a denominator of at most 255, so what
 * comes within 1e-6 of a whole number is that number. */
static bool at_least(double v, double bound) {
    return v > bound - 1e-6;
}

static bool twin_channel(const ocel_colour_range_t *range, int k, double v) {
    const bool from = at_least(v, range->lo[k]);
    const bool to = at_least(range->hi[k], v);
    return (range->lo[k] <= range->hi[k]) ? (from && to) : (from || to);
}

static bool twin_in(const ocel_colour_range_t *range, triple_t rgb, const triple_t *yuv) {
    const triple_t as_yuv = (yuv != NULL) ? *yuv : twin_yuv_of_rgb(rgb);
    const triple_t as_hsv = twin_hsv_of_rgb(rgb);
    const triple_t *const v = (range->space == OCEL_SPACE_RGB)   ? &rgb
                              : (range->space == OCEL_SPACE_HSV) ? &as_hsv
                                                                 : &as_yuv;
    const int channels = (range->space == OCEL_SPACE_GRAY) ? 1 : 3;
    bool in = true;
    for (int k = 0; k < channels; k++) {
        in = in && twin_channel(range, k, v->c[k]);
    }
    return in;
}

static bool twin_pixel(const ocel_colour_range_t *range, ocel_format_t format, const uint8_t *line,
                       int x) {
    triple_t rgb = {{0.0, 0.0, 0.0}};
    triple_t yuv;
    const triple_t *given = NULL;
    switch (format) {
    case OCEL_FORMAT_RGB565:
        rgb = twin_rgb565((unsigned)line[2 * x] + 256U * line[2 * x + 1]);
        break;
    case OCEL_FORMAT_RGB888:
    case OCEL_FORMAT_BGR888:
        for (int k = 0; k < 3; k++) {
            rgb.c[k] = line[3 * x + ((format == OCEL_FORMAT_RGB888) ? k : 2 - k)];
        }
        break;
    case OCEL_FORMAT_YUYV:
        yuv.c[0] = line[2 * x];
        yuv.c[1] = line[4 * (x / 2) + 1];
        yuv.c[2] = line[4 * (x / 2) + 3];
        rgb = twin_rgb_of_yuv(yuv);
        given = &yuv;
        break;
    case OCEL_FORMAT_GRAY8:
    default:
        rgb.c[0] = line[x];
        rgb.c[1] = line[x];
        rgb.c[2] = line[x];
        break;
    }
    return twin_in(range, rgb, given);
}

/* ---- Random ranges and lines ---- */

static void random_interval(rng_t *rng, int top, uint16_t *lo, uint16_t *hi) {
    const int32_t a = rng_between(rng, 0, top);
    const int32_t b = rng_between(rng, 0, top);
    const int32_t width = rng_between(rng, 0, top / 8);
    *lo = (uint16_t)((a < b) ? a : b);
    *hi = (uint16_t)((a < b) ? b : a);
    switch (rng_below(rng, 8U)) {
    case 0U: /* one-sided */
        *lo = 0U;
        break;
    case 1U:
        *hi = (uint16_t)top;
        break;
    case 2U: /* narrow */
        *hi = (uint16_t)((*lo + width > top) ? top : *lo + width);
        break;
    case 3U: /* all */
        *lo = 0U;
        *hi = (uint16_t)top;
        break;
    default:
        break;
    }
}

static ocel_colour_range_t random_range(rng_t *rng, ocel_space_t space) {
    ocel_colour_range_t range = {space, {0U, 0U, 0U}, {0U, 0U, 0U}};
    for (int k = 0; k < 3; k++) {
        random_interval(rng, 255, &range.lo[k], &range.hi[k]);
    }
    if (space == OCEL_SPACE_HSV) {
        random_interval(rng, 360, &range.lo[0], &range.hi[0]);
        if (rng_below(rng, 3U) == 0U) { /* wrap */
            const uint16_t lo = range.lo[0];
            range.lo[0] = range.hi[0];
            range.hi[0] = lo;
        }
    }
    return range;
}

static uint8_t byte_of(double v) {
    return (uint8_t)floor(clip(v) + 0.5);
}

/* On a bound, beside it, between the bounds or anywhere. */
static double near_range(rng_t *rng, const ocel_colour_range_t *range, int k) {
    double v = 0.0;
    switch (rng_below(rng, 6U)) {
    case 0U:
        v = range->lo[k] - (double)rng_below(rng, 2U);
        break;
    case 1U:
        v = range->hi[k] + (double)rng_below(rng, 2U);
        break;
    case 2U:
        v = rng_uniform(rng, 0.0, (range->space == OCEL_SPACE_HSV && k == 0) ? 360.0 : 255.0);
        break;
    default:
        v = rng_uniform(rng, range->lo[k], range->hi[k]);
        break;
    }
    return v;
}

static triple_t rgb_of_hsv(triple_t hsv) {
    const double chroma = clip(hsv.c[1]) / 255.0 * clip(hsv.c[2]);
    triple_t rgb;
    for (int k = 0; k < 3; k++) {
        const double h = fmod(hsv.c[0] + 720.0 - 120.0 * k, 360.0);
        const double t = fmin(fmax(2.0 - fmin(h, 360.0 - h) / 60.0, 0.0), 1.0);
        rgb.c[k] = clip(hsv.c[2]) - chroma * (1.0 - t);
    }
    return rgb;
}

/* A colour in or about the range, as R, G, B. */
static triple_t random_rgb(rng_t *rng, const ocel_colour_range_t *range) {
    triple_t v;
    for (int k = 0; k < 3; k++) {
        v.c[k] = near_range(rng, range, k);
    }
    if (range->space == OCEL_SPACE_HSV) {
        v = rgb_of_hsv(v);
    } else if (range->space == OCEL_SPACE_YUV) {
        v = twin_rgb_of_yuv(v);
    }
    if ((range->space == OCEL_SPACE_GRAY) || (rng_below(rng, 16U) == 0U)) {
        v.c[1] = v.c[0]; /* grey, so the threshold is met now and then */
        v.c[2] = v.c[0];
    }
    for (int k = 0; k < 3; k++) {
        v.c[k] = byte_of(v.c[k] + (double)rng_between(rng, -1, 1));
    }
    return v;
}

static void put_pixel(rng_t *rng, ocel_format_t format, triple_t rgb, uint8_t *line, int x) {
    const triple_t yuv = twin_yuv_of_rgb(rgb);
    unsigned p = 0U;
    switch (format) {
    case OCEL_FORMAT_RGB565:
        p = ((unsigned)rgb.c[0] >> 3 << 11) | ((unsigned)rgb.c[1] >> 2 << 5) |
            ((unsigned)rgb.c[2] >> 3);
        line[2 * x] = (uint8_t)(p & 0xFFU);
        line[2 * x + 1] = (uint8_t)(p >> 8);
        break;
    case OCEL_FORMAT_RGB888:
    case OCEL_FORMAT_BGR888:
        for (int k = 0; k < 3; k++) {
            line[3 * x + ((format == OCEL_FORMAT_RGB888) ? k : 2 - k)] = (uint8_t)rgb.c[k];
        }
        break;
    case OCEL_FORMAT_YUYV:
        line[2 * x] = (uint8_t)yuv.c[0];
        if ((x % 2) == 0) { /* the other pixel of the pair shares them */
            line[2 * x + 1] = (uint8_t)yuv.c[1];
            line[2 * x + 3] = (uint8_t)yuv.c[2];
        }
        break;
    case OCEL_FORMAT_GRAY8:
    default:
        line[x] = (uint8_t)((rng_below(rng, 4U) == 0U) ? rng_below(rng, 256U)
                                                       : (uint32_t)rgb.c[rng_below(rng, 3U)]);
        break;
    }
}

/* ---- Rows against the twin ---- */

typedef struct {
    ocel_colour_range_t range;
    ocel_format_t format;
    int width;
} case_t;

static const char *describe(const case_t *c, int x) {
    static char text[200];
    (void)snprintf(text, sizeof text,
                   "seed %u format %d space %d range %u-%u,%u-%u,%u-%u width %d pixel %d", SEED,
                   (int)c->format, (int)c->range.space, c->range.lo[0], c->range.hi[0],
                   c->range.lo[1], c->range.hi[1], c->range.lo[2], c->range.hi[2], c->width, x);
    return text;
}

#define GUARD 0xA5C3F00DU

/* One line, compiled and tested; returns how many pixels were in range. */
static int check_line(const case_t *c, const uint8_t *line, size_t bytes) {
    uint32_t row[OCEL_ROW_WORDS + 2];
    ocel_colour_t colour;
    const int words = (c->width + 31) / 32;
    int hits = 0;
    for (int k = 0; k < OCEL_ROW_WORDS + 2; k++) {
        row[k] = GUARD;
    }
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_colour_compile(&colour, &c->range, c->format, &table));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_colour_row(&colour, line, bytes, (uint16_t)c->width, row));
    for (int x = 0; x < 32 * words; x++) {
        const bool got = ((row[x / 32] >> (x % 32)) & 1U) != 0U;
        const bool want = (x < c->width) && twin_pixel(&c->range, c->format, line, x);
        if (got != want) {
            TEST_FAIL_MESSAGE(describe(c, x));
        }
        hits += want ? 1 : 0;
    }
    for (int k = words; k < OCEL_ROW_WORDS + 2; k++) {
        TEST_ASSERT_EQUAL_HEX32(GUARD, row[k]);
    }
    return hits;
}

/* The line's memory ends where the line does, for the sanitizer to see. */
static int check_random(rng_t *rng, ocel_format_t format, ocel_space_t space) {
    case_t c = {random_range(rng, space), format, (int)rng_between(rng, 1, OCEL_MAX_WIDTH)};
    if (rng_below(rng, 3U) == 0U) {
        c.width = (int)rng_between(rng, 1, 40);
    }
    if (format == OCEL_FORMAT_YUYV) {
        c.width += c.width % 2;
    }
    const size_t bytes = ocel_colour_line_bytes(format, (uint16_t)c.width);
    const size_t offset = rng_below(rng, 8U);
    uint8_t *const memory = malloc(offset + bytes);
    TEST_ASSERT_NOT_NULL(memory);
    for (int x = 0; x < c.width; x++) {
        put_pixel(rng, format, random_rgb(rng, &c.range), &memory[offset], x);
    }
    const int hits = check_line(&c, &memory[offset], bytes);
    free(memory);
    return hits;
}

static void rows_of(ocel_format_t format) {
    const int trials = (format == OCEL_FORMAT_RGB565) ? TEST_TRIALS_AT_LEAST(2, 40)
                                                      : TEST_TRIALS_AT_LEAST(30, 1500);
    for (int space = 0; space < SPACES; space++) {
        rng_t rng = rng_seed(SEED + 10U * (unsigned)format + (unsigned)space);
        int hits = 0;
        for (int trial = 0; trial < trials; trial++) {
            hits += check_random(&rng, format, (ocel_space_t)space);
        }
        TEST_ASSERT_GREATER_THAN_INT(trials / 2, hits); /* the trials are not all empty rows */
    }
}

static void test_rows_rgb565(void) {
    rows_of(OCEL_FORMAT_RGB565);
}

static void test_rows_rgb888(void) {
    rows_of(OCEL_FORMAT_RGB888);
}

static void test_rows_bgr888(void) {
    rows_of(OCEL_FORMAT_BGR888);
}

static void test_rows_yuyv(void) {
    rows_of(OCEL_FORMAT_YUYV);
}

static void test_rows_gray8(void) {
    rows_of(OCEL_FORMAT_GRAY8);
}

/* Every width, so every tail, with every pixel in range and with none. */
static void test_every_width(void) {
    static uint8_t line[3 * OCEL_MAX_WIDTH];
    memset(line, 128, sizeof line);
    for (int format = 0; format < FORMATS; format++) {
        const int step = (format == (int)OCEL_FORMAT_YUYV) ? 2 : 1;
        for (int all = 0; all < 2; all++) {
            case_t c = {
                {OCEL_SPACE_YUV, {0U, 0U, 0U}, {255U, 255U, 255U}}, (ocel_format_t)format, 0};
            c.range.lo[0] = (all != 0) ? 0U : 200U;
            for (c.width = step; c.width <= OCEL_MAX_WIDTH;
                 c.width += step * ((format == 0) ? 37 + TEST_STEP - 1 : TEST_STEP)) {
                const int hits =
                    check_line(&c, line, ocel_colour_line_bytes(c.format, (uint16_t)c.width));
                TEST_ASSERT_EQUAL(((all != 0) ? c.width : 0), hits);
            }
        }
    }
}

/* ---- Exhaustive ---- */

static void test_table_holds_all_65536_colours(void) {
    rng_t rng = rng_seed(SEED);
    for (int trial = 0; trial < TEST_TRIALS_AT_LEAST(4, 40); trial++) {
        const case_t c = {random_range(&rng, (ocel_space_t)(trial % SPACES)), OCEL_FORMAT_RGB565,
                          1};
        ocel_colour_t colour;
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_colour_compile(&colour, &c.range, c.format, &table));
        for (unsigned p = 0U; p < 65536U; p++) {
            const bool got = ((table.word[p / 32U] >> (p % 32U)) & 1U) != 0U;
            if (got != twin_in(&c.range, twin_rgb565(p), NULL)) {
                TEST_FAIL_MESSAGE(describe(&c, (int)p));
            }
        }
    }
}

static void test_gray8_every_value(void) {
    uint8_t line[256];
    rng_t rng = rng_seed(SEED);
    for (int v = 0; v < 256; v++) {
        line[v] = (uint8_t)v;
    }
    for (int trial = 0; trial < TEST_TRIALS(4000); trial++) {
        const case_t c = {random_range(&rng, (ocel_space_t)(trial % SPACES)), OCEL_FORMAT_GRAY8,
                          256};
        (void)check_line(&c, line, sizeof line);
    }
}

static ocel_bounds_t bounds_of(const ocel_colour_range_t *range) {
    ocel_bounds_t bounds;
    memcpy(bounds.lo, range->lo, sizeof bounds.lo);
    memcpy(bounds.hi, range->hi, sizeof bounds.hi);
    return bounds;
}

static bool within(const ocel_bounds_t *bounds, triple_t v) {
    bool in = true;
    for (int k = 0; k < 3; k++) {
        in = in && (v.c[k] >= bounds->lo[k]) && (v.c[k] <= bounds->hi[k]);
    }
    return in;
}

/* A lattice of all colours that has the cube's corners and edges. */
enum { LATTICE = 18 * 18 * 18 };

static triple_t lattice(int at) {
    const triple_t v = {{15 * (at % 18), 15 * ((at / 18) % 18), 15 * (at / 324)}};
    return v;
}

/* Bounds may hold what is not in range but must hold all that is. */
static void test_rgb_bounds_hold_the_range(void) {
    rng_t rng = rng_seed(SEED);
    for (int trial = 0; trial < TEST_TRIALS(600); trial++) {
        const ocel_space_t space = (trial % 2 == 0) ? OCEL_SPACE_HSV : OCEL_SPACE_YUV;
        const case_t c = {random_range(&rng, space), OCEL_FORMAT_RGB888, 0};
        ocel_bounds_t bounds = bounds_of(&c.range);
        if (space == OCEL_SPACE_HSV) {
            ocel_bounds_hsv_to_rgb(&bounds);
        } else {
            ocel_bounds_yuv_to_rgb(&bounds);
        }
        for (int at = 0; at < LATTICE; at += TEST_STEP) {
            if (twin_in(&c.range, lattice(at), NULL)) {
                TEST_ASSERT_TRUE_MESSAGE(within(&bounds, lattice(at)), describe(&c, at));
            }
        }
    }
}

static void test_yuv_bounds_hold_the_range(void) {
    rng_t rng = rng_seed(SEED);
    for (int trial = 0; trial < TEST_TRIALS(300); trial++) {
        const case_t c = {random_range(&rng, OCEL_SPACE_RGB), OCEL_FORMAT_YUYV, 0};
        ocel_bounds_t bounds = bounds_of(&c.range);
        ocel_bounds_rgb_to_yuv(&bounds);
        for (int at = 0; at < LATTICE; at += TEST_STEP) {
            if (twin_in(&c.range, twin_rgb_of_yuv(lattice(at)), NULL)) {
                TEST_ASSERT_TRUE_MESSAGE(within(&bounds, lattice(at)), describe(&c, at));
            }
        }
    }
}

/* The margin for rounding holds, and the bounds are no wider than it, on the
 * finest ranges there are: one colour. */
static void test_bounds_of_a_single_yuv(void) {
    for (int at = 0; at < LATTICE; at += TEST_STEP) {
        const triple_t yuv = twin_yuv_of_rgb(lattice(at));
        ocel_bounds_t bounds;
        for (int k = 0; k < 3; k++) {
            bounds.lo[k] = (uint16_t)yuv.c[k];
            bounds.hi[k] = (uint16_t)yuv.c[k];
        }
        ocel_bounds_yuv_to_rgb(&bounds);
        TEST_ASSERT_TRUE(within(&bounds, lattice(at)));
        for (int k = 0; k < 3; k++) {
            TEST_ASSERT_LESS_OR_EQUAL_INT(8, bounds.hi[k] - bounds.lo[k]);
        }
    }
}

/* Tight where it counts: orange is far from grey in all three channels. */
static void test_bounds_of_orange(void) {
    ocel_bounds_t bounds = {{10U, 150U, 180U}, {35U, 255U, 255U}};
    ocel_bounds_hsv_to_rgb(&bounds);
    TEST_ASSERT_UINT16_WITHIN(1, 180, bounds.lo[0]);
    TEST_ASSERT_UINT16_WITHIN(1, 255, bounds.hi[0]);
    TEST_ASSERT_UINT16_WITHIN(1, 30, bounds.lo[1]);  /* 180 * 10 / 60 */
    TEST_ASSERT_UINT16_WITHIN(1, 192, bounds.hi[1]); /* 255 - 150 * (1 - 35 / 60) */
    TEST_ASSERT_UINT16_WITHIN(1, 0, bounds.lo[2]);
    TEST_ASSERT_UINT16_WITHIN(1, 105, bounds.hi[2]); /* 255 - 150 */
}

/* ---- Lanes ---- */

static void test_loads_are_little_endian(void) {
    uint8_t bytes[16];
    for (unsigned k = 0U; k < 16U; k++) {
        bytes[k] = (uint8_t)(0x11U * k + 1U);
    }
    for (unsigned at = 0U; at < 8U; at++) {
        const uint8_t *const p = &bytes[at];
        const uint32_t low = p[0] + 256U * p[1] + 65536U * p[2] + 16777216U * p[3];
        TEST_ASSERT_EQUAL_HEX32(p[0] + 256U * p[1], ocel_load16(p));
        TEST_ASSERT_EQUAL_HEX32(low, ocel_load32(p));
        ocel_word_t word = 0U;
        for (unsigned k = OCEL_WORD_BYTES; k > 0U; k--) {
            word = (ocel_word_t)(word * 256U) + p[k - 1U];
        }
        TEST_ASSERT_TRUE(word == ocel_load_word(p));
    }
}

/* Value k of a range's bytes: 0 and 1 have one range, 2 and 3 the other. */
static bool lane_want(unsigned v, unsigned k, const unsigned *begin, const unsigned *end) {
    const unsigned which = (k / 2U) % 2U;
    return (v >= begin[which]) && (v < end[which]);
}

static bool bit7(ocel_word_t word, unsigned k) {
    return ((word >> (8U * k + 7U)) & 1U) != 0U;
}

/* Bytes beside each other that would carry or borrow if any could.  The coarse
 * test may pass one level more at an odd end, and nothing else. */
static void check_lanes(const unsigned *begin, const unsigned *end, unsigned v) {
    const ocel_word_t other = ((v & 4U) != 0U) ? 0xFFU : 0U;
    const ocel_word_t bytes = (ocel_word_t)v | (other << 8U) | ((ocel_word_t)v << 16U) |
                              ((ocel_word_t)(v ^ 1U) << (OCEL_WORD_BITS - 8));
    uint32_t lanes[4];
    ocel_lanes_set(lanes, begin[0], end[0], begin[1], end[1]);
    const ocel_lane_range_t range = ocel_lane_range(lanes);
    const ocel_word_t in = ocel_lanes_in(bytes, &range);
    const ocel_word_t may = ocel_lanes_may_be_in((bytes >> 1U) & OCEL_LOW_SEVEN, &range);
    for (unsigned k = 0U; k < OCEL_WORD_BYTES; k++) {
        const unsigned at = (unsigned)(bytes >> (8U * k)) & 0xFFU;
        const unsigned wider_begin[2] = {begin[0] & ~1U, begin[1] & ~1U};
        const unsigned wider_end[2] = {(end[0] + 1U) & ~1U, (end[1] + 1U) & ~1U};
        if ((bit7(in, k) != lane_want(at, k, begin, end)) ||
            (bit7(may, k) != lane_want(at, k, wider_begin, wider_end))) {
            char text[80];
            (void)snprintf(text, sizeof text, "%u-%u %u-%u value %u byte %u", begin[0], end[0],
                           begin[1], end[1], v, k);
            TEST_FAIL_MESSAGE(text);
        }
    }
}

/* Every range and every value. */
static void test_lane_ranges_exhaustively(void) {
    for (unsigned begin = 0U; begin <= 256U; begin += TEST_STEP) {
        for (unsigned end = begin; end <= 256U; end++) {
            const unsigned begins[2] = {begin, (begin * 7U) % (end + 1U)};
            const unsigned ends[2] = {end, end};
            for (unsigned v = 0U; v < 256U; v++) {
                check_lanes(begins, ends, v);
            }
        }
    }
}

static void check_gather(ocel_word_t order, const unsigned *byte_of_pixel) {
    for (unsigned bits = 0U; bits < (1U << OCEL_GROUP); bits++) {
        ocel_word_t flags = ~OCEL_TOP_BITS; /* what is no flag must not matter */
        for (unsigned k = 0U; k < OCEL_GROUP; k++) {
            flags |= (ocel_word_t)((bits >> k) & 1U) << (8U * byte_of_pixel[k] + 7U);
        }
        TEST_ASSERT_EQUAL_HEX32(bits, ocel_gather(flags, order));
    }
}

static void test_gather_every_pattern(void) {
    unsigned plain[8];
    unsigned threes[8];
    unsigned even_odd[8];
    for (unsigned k = 0U; k < OCEL_GROUP; k++) {
        plain[k] = k;
        threes[k] = (3U * k) % OCEL_GROUP;
        even_odd[k] = (2U * k) % OCEL_GROUP + (2U * k) / OCEL_GROUP;
    }
    check_gather(OCEL_ORDER_PLAIN, plain);
    check_gather(OCEL_ORDER_BY_THREES, threes);
    check_gather(OCEL_ORDER_EVEN_ODD, even_odd);
}

/* ---- One pixel ---- */

static void test_pixel_conversions(void) {
    rng_t rng = rng_seed(SEED);
    for (int trial = 0; trial < TEST_TRIALS(200000); trial++) {
        const ocel_pixel_t p = {
            {rng_below(&rng, 256U), rng_below(&rng, 256U), rng_below(&rng, 256U)}};
        const triple_t v = {{p.c[0], p.c[1], p.c[2]}};
        const triple_t want_yuv = twin_yuv_of_rgb(v);
        const triple_t want_rgb = twin_rgb_of_yuv(v);
        const ocel_pixel_t yuv = ocel_pixel_to_yuv(&p);
        const ocel_pixel_t rgb = ocel_pixel_from_yuv(&p);
        for (int k = 0; k < 3; k++) {
            TEST_ASSERT_EQUAL_UINT32((uint32_t)want_yuv.c[k], yuv.c[k]);
            TEST_ASSERT_EQUAL_UINT32((uint32_t)want_rgb.c[k], rgb.c[k]);
        }
        /* Within one of BT.601 itself. */
        TEST_ASSERT_DOUBLE_WITHIN(1.0, 0.299 * v.c[0] + 0.587 * v.c[1] + 0.114 * v.c[2], yuv.c[0]);
        TEST_ASSERT_DOUBLE_WITHIN(
            1.3, 128.0 + (v.c[2] - 0.299 * v.c[0] - 0.587 * v.c[1] - 0.114 * v.c[2]) / 1.772,
            yuv.c[1]);
        TEST_ASSERT_DOUBLE_WITHIN(
            1.3, 128.0 + (v.c[0] - 0.299 * v.c[0] - 0.587 * v.c[1] - 0.114 * v.c[2]) / 1.402,
            yuv.c[2]);
    }
}

static void test_pixel_extremes(void) {
    const ocel_pixel_t blue = {{0U, 0U, 255U}};
    const ocel_pixel_t red = {{255U, 0U, 0U}};
    TEST_ASSERT_EQUAL_UINT32(255U, ocel_pixel_to_yuv(&blue).c[1]);
    TEST_ASSERT_EQUAL_UINT32(255U, ocel_pixel_to_yuv(&red).c[2]);
    for (uint32_t v = 0U; v < 256U; v++) {
        const ocel_pixel_t gray = {{v, v, v}};
        const ocel_pixel_t yuv = ocel_pixel_to_yuv(&gray);
        const ocel_pixel_t back = ocel_pixel_from_yuv(&yuv);
        TEST_ASSERT_EQUAL_UINT32(v, yuv.c[0]);
        TEST_ASSERT_EQUAL_UINT32(128U, yuv.c[1]);
        TEST_ASSERT_EQUAL_UINT32(128U, yuv.c[2]);
        TEST_ASSERT_EQUAL_UINT32(v, back.c[0]);
        TEST_ASSERT_EQUAL_UINT32(v, back.c[1]);
        TEST_ASSERT_EQUAL_UINT32(v, back.c[2]);
    }
}

static bool in_hsv(uint16_t h0, uint16_t h1, uint32_t r, uint32_t g, uint32_t b) {
    const uint16_t lo[3] = {h0, 0U, 0U};
    const uint16_t hi[3] = {h1, 255U, 255U};
    const ocel_pixel_t rgb = {{r, g, b}};
    return ocel_pixel_in_hsv(lo, hi, &rgb);
}

/* Named colours at their hues; both ends belong to the range; grey is hue 0. */
static void test_hue_ends(void) {
    TEST_ASSERT_TRUE(in_hsv(0U, 0U, 255U, 0U, 0U));
    TEST_ASSERT_TRUE(in_hsv(60U, 60U, 255U, 255U, 0U));
    TEST_ASSERT_TRUE(in_hsv(120U, 120U, 0U, 255U, 0U));
    TEST_ASSERT_TRUE(in_hsv(180U, 180U, 0U, 255U, 255U));
    TEST_ASSERT_TRUE(in_hsv(240U, 240U, 0U, 0U, 255U));
    TEST_ASSERT_TRUE(in_hsv(300U, 300U, 255U, 0U, 255U));
    TEST_ASSERT_TRUE(in_hsv(20U, 20U, 30U, 10U, 0U)); /* 60 / 3 exactly */
    TEST_ASSERT_FALSE(in_hsv(21U, 359U, 30U, 10U, 0U));
    TEST_ASSERT_TRUE(in_hsv(340U, 20U, 200U, 0U, 3U));
    TEST_ASSERT_TRUE(in_hsv(340U, 20U, 200U, 3U, 0U));
    TEST_ASSERT_TRUE(in_hsv(360U, 0U, 9U, 9U, 9U));
    TEST_ASSERT_TRUE(in_hsv(0U, 0U, 9U, 9U, 9U));
    TEST_ASSERT_FALSE(in_hsv(1U, 360U, 9U, 9U, 9U));
    TEST_ASSERT_FALSE(in_hsv(360U, 360U, 255U, 0U, 0U)); /* hue is below 360 */
}

/* ---- Hostile input ---- */

static const ocel_colour_range_t any_rgb = {OCEL_SPACE_RGB, {0U, 0U, 0U}, {255U, 255U, 255U}};

static void test_line_bytes(void) {
    TEST_ASSERT_EQUAL(640U, ocel_colour_line_bytes(OCEL_FORMAT_RGB565, 320U));
    TEST_ASSERT_EQUAL(960U, ocel_colour_line_bytes(OCEL_FORMAT_RGB888, 320U));
    TEST_ASSERT_EQUAL(960U, ocel_colour_line_bytes(OCEL_FORMAT_BGR888, 320U));
    TEST_ASSERT_EQUAL(640U, ocel_colour_line_bytes(OCEL_FORMAT_YUYV, 320U));
    TEST_ASSERT_EQUAL(320U, ocel_colour_line_bytes(OCEL_FORMAT_GRAY8, 320U));
    TEST_ASSERT_EQUAL(196605U, ocel_colour_line_bytes(OCEL_FORMAT_BGR888, 65535U));
    TEST_ASSERT_EQUAL(0U, ocel_colour_line_bytes((ocel_format_t)5, 320U));
    TEST_ASSERT_EQUAL(0U, ocel_colour_line_bytes((ocel_format_t)1000, 320U));
}

/* What a failed compilation leaves behind is refused by every row. */
static void refuses(ocel_status_t want, const ocel_colour_range_t *range, ocel_format_t format,
                    ocel_colour_table_t *its_table) {
    const uint8_t line[3] = {0U, 0U, 0U};
    uint32_t row[1] = {GUARD};
    ocel_colour_t colour;
    memset(&colour, 0xFF, sizeof colour);
    TEST_ASSERT_EQUAL(want, ocel_colour_compile(&colour, range, format, its_table));
    TEST_ASSERT_EQUAL(OCEL_BAD_FORMAT, ocel_colour_row(&colour, line, 3U, 1U, row));
    TEST_ASSERT_EQUAL_HEX32(GUARD, row[0]);
}

static void refuses_bounds(ocel_space_t space, int k, uint16_t lo, uint16_t hi) {
    ocel_colour_range_t range = {space, {0U, 0U, 0U}, {255U, 255U, 255U}};
    range.lo[k] = lo;
    range.hi[k] = hi;
    for (int format = 0; format < FORMATS; format++) {
        refuses(OCEL_BAD_OPTION, &range, (ocel_format_t)format, &table);
    }
}

static void test_compile_hostile(void) {
    ocel_colour_range_t range = any_rgb;
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT,
                      ocel_colour_compile(NULL, &range, OCEL_FORMAT_RGB888, NULL));
    refuses(OCEL_NULL_ARGUMENT, NULL, OCEL_FORMAT_RGB888, NULL);
    refuses(OCEL_NULL_ARGUMENT, &range, OCEL_FORMAT_RGB565, NULL);
    refuses(OCEL_BAD_FORMAT, &range, (ocel_format_t)5, &table);
    refuses(OCEL_BAD_FORMAT, &range, (ocel_format_t)77, NULL);
    range.space = (ocel_space_t)4;
    refuses(OCEL_BAD_OPTION, &range, OCEL_FORMAT_RGB888, NULL);
    for (int k = 0; k < 3; k++) {
        refuses_bounds(OCEL_SPACE_RGB, k, 0U, 256U);
        refuses_bounds(OCEL_SPACE_RGB, k, 11U, 10U);
        refuses_bounds(OCEL_SPACE_YUV, k, 256U, 256U);
        refuses_bounds(OCEL_SPACE_YUV, k, 255U, 0U);
    }
    refuses_bounds(OCEL_SPACE_HSV, 0, 361U, 20U);
    refuses_bounds(OCEL_SPACE_HSV, 0, 0U, 361U);
    refuses_bounds(OCEL_SPACE_HSV, 1, 0U, 256U);
    refuses_bounds(OCEL_SPACE_HSV, 2, 65535U, 65535U);
    refuses_bounds(OCEL_SPACE_HSV, 2, 20U, 10U);
    refuses_bounds(OCEL_SPACE_GRAY, 0, 0U, 256U);
    refuses_bounds(OCEL_SPACE_GRAY, 0, 20U, 10U);
}

/* Grey reads channel 0 only, and only RGB565 needs a table. */
static void test_compile_ignores_what_it_does_not_use(void) {
    ocel_colour_range_t range = {OCEL_SPACE_GRAY, {10U, 999U, 700U}, {20U, 3U, 400U}};
    ocel_colour_t colour;
    for (int format = 0; format < FORMATS; format++) {
        TEST_ASSERT_EQUAL(OCEL_OK,
                          ocel_colour_compile(&colour, &range, (ocel_format_t)format,
                                              (format == (int)OCEL_FORMAT_RGB565) ? &table : NULL));
    }
}

static void test_row_hostile(void) {
    uint8_t line[3 * (OCEL_MAX_WIDTH + 1)] = {0U};
    uint32_t row[OCEL_ROW_WORDS + 1];
    ocel_colour_t zeroed;
    ocel_colour_t colour;
    ocel_colour_t yuyv;
    memset(&zeroed, 0, sizeof zeroed);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_colour_compile(&colour, &any_rgb, OCEL_FORMAT_BGR888, NULL));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_colour_compile(&yuyv, &any_rgb, OCEL_FORMAT_YUYV, NULL));
    memset(row, 0x5A, sizeof row);
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_colour_row(NULL, line, sizeof line, 8U, row));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_colour_row(&colour, NULL, sizeof line, 8U, row));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_colour_row(&colour, line, sizeof line, 8U, NULL));
    TEST_ASSERT_EQUAL(OCEL_BAD_FORMAT, ocel_colour_row(&zeroed, line, sizeof line, 8U, row));
    TEST_ASSERT_EQUAL(OCEL_BAD_SIZE, ocel_colour_row(&colour, line, sizeof line, 0U, row));
    TEST_ASSERT_EQUAL(OCEL_BAD_SIZE,
                      ocel_colour_row(&colour, line, sizeof line, OCEL_MAX_WIDTH + 1, row));
    TEST_ASSERT_EQUAL(OCEL_BAD_SIZE, ocel_colour_row(&colour, line, sizeof line, 65535U, row));
    TEST_ASSERT_EQUAL(OCEL_BAD_SIZE, ocel_colour_row(&yuyv, line, sizeof line, 7U, row));
    TEST_ASSERT_EQUAL(OCEL_BAD_STRIDE, ocel_colour_row(&colour, line, 23U, 8U, row));
    TEST_ASSERT_EQUAL(OCEL_BAD_STRIDE, ocel_colour_row(&colour, line, 0U, 1U, row));
    TEST_ASSERT_EQUAL(OCEL_BAD_STRIDE, ocel_colour_row(&yuyv, line, 15U, 8U, row));
    for (int k = 0; k < OCEL_ROW_WORDS + 1; k++) {
        TEST_ASSERT_EQUAL_HEX32(0x5A5A5A5AU, row[k]);
    }
    /* The same contexts go on working. */
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_colour_row(&colour, line, 24U, 8U, row));
    TEST_ASSERT_EQUAL_HEX32(0xFFU, row[0]);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_colour_row(&yuyv, line, 16U, 8U, row));
    TEST_ASSERT_EQUAL_HEX32(0xFFU, row[0]);
}

/* A compiled colour may be copied; the same input gives the same bits. */
static void test_copies_and_repeats(void) {
    const ocel_colour_range_t range = {OCEL_SPACE_HSV, {340U, 90U, 60U}, {20U, 255U, 255U}};
    uint8_t line[3 * 100];
    uint32_t first[4];
    uint32_t second[4];
    ocel_colour_t colour;
    rng_t rng = rng_seed(SEED);
    for (size_t k = 0U; k < sizeof line; k++) {
        line[k] = (uint8_t)rng_below(&rng, 256U);
    }
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_colour_compile(&colour, &range, OCEL_FORMAT_RGB888, NULL));
    const ocel_colour_t copy = colour;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_colour_row(&colour, line, sizeof line, 100U, first));
    memset(&colour, 0, sizeof colour);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_colour_row(&copy, line, sizeof line, 100U, second));
    TEST_ASSERT_EQUAL_HEX32_ARRAY(first, second, 4);
}

int main(void) {
    UNITY_BEGIN();
    RUN_TEST(test_loads_are_little_endian);
    RUN_TEST(test_lane_ranges_exhaustively);
    RUN_TEST(test_gather_every_pattern);
    RUN_TEST(test_pixel_conversions);
    RUN_TEST(test_pixel_extremes);
    RUN_TEST(test_hue_ends);
    RUN_TEST(test_rgb_bounds_hold_the_range);
    RUN_TEST(test_yuv_bounds_hold_the_range);
    RUN_TEST(test_bounds_of_a_single_yuv);
    RUN_TEST(test_bounds_of_orange);
    RUN_TEST(test_table_holds_all_65536_colours);
    RUN_TEST(test_gray8_every_value);
    RUN_TEST(test_every_width);
    RUN_TEST(test_rows_rgb565);
    RUN_TEST(test_rows_rgb888);
    RUN_TEST(test_rows_bgr888);
    RUN_TEST(test_rows_yuyv);
    RUN_TEST(test_rows_gray8);
    RUN_TEST(test_line_bytes);
    RUN_TEST(test_compile_hostile);
    RUN_TEST(test_compile_ignores_what_it_does_not_use);
    RUN_TEST(test_row_hostile);
    RUN_TEST(test_copies_and_repeats);
    return UNITY_END();
}
