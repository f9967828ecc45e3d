/* SPDX-License-Identifier: MIT
 *
 * From camera lines to bits.
 *
 * The test of a line passes every pixel in range and, several at a time in one
 * machine word, rejects nearly all others: by bounds of the bytes they are made
 * of, the most selective first.  Where the bounds are not the range itself, each
 * pixel that passed is then decided by the definition.  RGB565 needs neither:
 * its table is the range.
 */
#include <ocellus/colour.h>

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

#include "../base/int_math.h"
#include "bounds.h"
#include "lanes.h"
#include "pixel.h"
#include "row16.h"
#include "row24.h"

/* Pixels that the line tests take at a time, and the most bytes of those. */
#define GROUP 16U
#define GROUP_BYTES_MAX 48U

#define RGB565_COLOURS 65536U
#define GRAYS 256U

/* ocel_colour_t.state of a compiled colour. */
#define STATE_COMPILED 0xC010U

size_t ocel_colour_line_bytes(ocel_format_t format, uint16_t width) {
    size_t pixel_bytes = 0U;

    switch (format) {
    case OCEL_FORMAT_RGB565:
    case OCEL_FORMAT_YUYV:
        pixel_bytes = 2U;
        break;
    case OCEL_FORMAT_RGB888:
    case OCEL_FORMAT_BGR888:
        pixel_bytes = 3U;
        break;
    case OCEL_FORMAT_GRAY8:
        pixel_bytes = 1U;
        break;
    default:
        pixel_bytes = 0U;
        break;
    }
    return pixel_bytes * width;
}

/* ---- Compiling ---- */

/* Of channel k; hue, with ends up to 360, may wrap. */
static bool channel_valid(const ocel_colour_range_t *range, uint32_t k) {
    const bool is_hue = (range->space == OCEL_SPACE_HSV) && (k == 0U);
    const uint32_t top = is_hue ? 360U : 255U;
    const bool in_order = is_hue || (range->lo[k] <= range->hi[k]);

    return in_order && (range->lo[k] <= top) && (range->hi[k] <= top);
}

static bool range_valid(const ocel_colour_range_t *range) {
    bool valid = (range->space == OCEL_SPACE_RGB) || (range->space == OCEL_SPACE_HSV) ||
                 (range->space == OCEL_SPACE_YUV);

    for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 channels */
        valid = valid && channel_valid(range, k);
    }
    return valid;
}

/* Grey is Y, so it is compiled as Y, U and V with the latter two left open. */
static ocel_colour_range_t without_gray(const ocel_colour_range_t *range) {
    ocel_colour_range_t same = *range;

    if (range->space == OCEL_SPACE_GRAY) {
        same.space = OCEL_SPACE_YUV;
        for (uint32_t k = 1U; k < 3U; k++) { /* bound: 3 channels */
            same.lo[k] = 0U;
            same.hi[k] = 255U;
        }
    }
    return same;
}

/* The definition of "in range", for a pixel that is given as R, G and B. */
static bool rgb_in_range(const ocel_colour_range_t *range, const ocel_pixel_t *rgb) {
    bool in = false;

    if (range->space == OCEL_SPACE_HSV) {
        in = ocel_pixel_in_hsv(range->lo, range->hi, rgb);
    } else if (range->space == OCEL_SPACE_YUV) {
        in = ocel_pixel_in_yuv(range->lo, range->hi, rgb);
    } else {
        in = ocel_pixel_in_rgb(range->lo, range->hi, rgb);
    }
    return in;
}

/* The lowest of a channel's values in a mask of those that occur; none: 0. */
static uint32_t lowest_of(uint32_t values) {
    return (values != 0U) ? ocel_ctz32(values) : 0U;
}

/* Of the highest, what it lacks of 31. */
static uint32_t headroom_of(uint32_t values) {
    return (values != 0U) ? ocel_clz32(values) : 0U;
}

/* Greens two by two, so that 32 bits hold which values occur of every channel. */
static void bound_table(ocel_colour_table_t *table) {
    uint32_t reds = 0U;
    uint32_t greens = 0U;
    uint32_t blues = 0U;

    for (uint32_t k = 0U; k < (uint32_t)OCEL_COLOUR_TABLE_WORDS;
         k++) { /* bound: OCEL_COLOUR_TABLE_WORDS */
        const uint32_t some = (table->word[k] != 0U) ? 1U : 0U;

        reds |= some << (k >> 6U);
        greens |= some << ((k >> 1U) & 31U);
        blues |= table->word[k];
    }
    table->least =
        (uint16_t)((lowest_of(reds) << 11U) | (lowest_of(greens) << 6U) | lowest_of(blues));
    table->headroom =
        (uint16_t)((headroom_of(reds) << 11U) | (headroom_of(greens) << 6U) | headroom_of(blues));
}

static void fill_table(ocel_colour_table_t *table, const ocel_colour_range_t *range) {
    uint32_t word = 0U;

    for (uint32_t p = 0U; p < RGB565_COLOURS; p++) { /* bound: RGB565_COLOURS */
        const ocel_pixel_t rgb = ocel_pixel_from_rgb565(p);

        word |= (rgb_in_range(range, &rgb) ? 1U : 0U) << (p & 31U);
        if ((p & 31U) == 31U) {
            table->word[p >> 5U] = word;
            word = 0U;
        }
    }
}

/* The end of a half-open range; an empty one ends where it begins. */
static uint32_t end_of(const ocel_bounds_t *bounds, uint32_t k) {
    const bool empty = bounds->lo[k] > bounds->hi[k];

    return empty ? (uint32_t)bounds->lo[k] : ((uint32_t)bounds->hi[k] + 1U);
}

/* The bounds of channel k0 for bytes 0 and 1 of the lanes, of k1 for 2 and 3. */
static void set_lanes(uint32_t lanes[4], const ocel_bounds_t *bounds, uint32_t k0, uint32_t k1) {
    ocel_lanes_set(lanes, bounds->lo[k0], end_of(bounds, k0), bounds->lo[k1], end_of(bounds, k1));
}

/* Bounds of the range in R, G and B, or in Y, U and V. */
static ocel_bounds_t compile_bounds(ocel_colour_t *colour, bool in_yuv) {
    const ocel_colour_range_t *const range = &colour->range;
    const bool from_yuv = range->space == OCEL_SPACE_YUV;
    ocel_bounds_t bounds = {{range->lo[0], range->lo[1], range->lo[2]},
                            {range->hi[0], range->hi[1], range->hi[2]}};

    colour->exact = ((range->space != OCEL_SPACE_HSV) && (from_yuv == in_yuv)) ? 1U : 0U;
    if (range->space == OCEL_SPACE_HSV) {
        ocel_bounds_hsv_to_rgb(&bounds);
    }
    if (from_yuv && !in_yuv) {
        ocel_bounds_yuv_to_rgb(&bounds);
    }
    if (in_yuv && !from_yuv) {
        ocel_bounds_rgb_to_yuv(&bounds);
    }
    return bounds;
}

static int32_t width_of(const ocel_bounds_t *bounds, uint32_t k) {
    return (int32_t)bounds->hi[k] - (int32_t)bounds->lo[k];
}

/* The narrowest channel first: over a background of any colours it rejects most. */
static void compile_rgb24(ocel_colour_t *colour) {
    const ocel_bounds_t bounds = compile_bounds(colour, false);
    const bool is_bgr = colour->format == OCEL_FORMAT_BGR888;
    uint32_t channel = 0U;

    for (uint32_t k = 1U; k < 3U; k++) { /* bound: 3 channels */
        channel = (width_of(&bounds, k) < width_of(&bounds, channel)) ? k : channel;
    }
    for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 channels */
        set_lanes(colour->lanes[k], &bounds, channel, channel);
        colour->at[k] = (uint8_t)(is_bgr ? (2U - channel) : channel);
        channel = (channel < 2U) ? (channel + 1U) : 0U;
    }
}

static void compile_yuyv(ocel_colour_t *colour) {
    const ocel_bounds_t bounds = compile_bounds(colour, true);

    set_lanes(colour->lanes[0], &bounds, 0U, 0U);
    set_lanes(colour->lanes[1], &bounds, 1U, 2U);
}

/* A grey pixel v is R = G = B = Y = V(alue) = v, U = V = 128 and H = S = 0.  So
 * every range holds an interval of v, or none, and trying all finds it. */
static void compile_gray8(ocel_colour_t *colour) {
    ocel_bounds_t bounds = {{1U, 0U, 0U}, {0U, 0U, 0U}};

    for (uint32_t k = 0U; k < GRAYS; k++) { /* bound: GRAYS */
        const uint32_t v = (GRAYS - 1U) - k;
        const ocel_pixel_t rgb = {{v, v, v}};

        if (rgb_in_range(&colour->range, &rgb)) {
            bounds.hi[0] = (bounds.lo[0] > bounds.hi[0]) ? (uint16_t)v : bounds.hi[0];
            bounds.lo[0] = (uint16_t)v;
        }
    }
    set_lanes(colour->lanes[0], &bounds, 0U, 0U);
    colour->exact = 1U;
}

static void compile_rgb565(ocel_colour_t *colour, ocel_colour_table_t *table) {
    fill_table(table, &colour->range);
    bound_table(table);
    colour->table = table;
    colour->exact = 1U;
}

static void compile_valid(ocel_colour_t *colour, const ocel_colour_range_t *range,
                          ocel_format_t format, ocel_colour_table_t *table) {
    colour->range = *range;
    colour->format = format;
    colour->state = STATE_COMPILED;
    switch (format) {
    case OCEL_FORMAT_RGB565:
        compile_rgb565(colour, table);
        break;
    case OCEL_FORMAT_YUYV:
        compile_yuyv(colour);
        break;
    case OCEL_FORMAT_GRAY8:
        compile_gray8(colour);
        break;
    case OCEL_FORMAT_RGB888:
    case OCEL_FORMAT_BGR888:
    default:
        compile_rgb24(colour);
        break;
    }
}

ocel_status_t ocel_colour_compile(ocel_colour_t *colour, const ocel_colour_range_t *range,
                                  ocel_format_t format, ocel_colour_table_t *table) {
    ocel_status_t status = OCEL_OK;

    if (colour == NULL) {
        status = OCEL_NULL_ARGUMENT;
    } else {
        (void)memset(colour, 0, sizeof(*colour)); /* not compiled, until all is well */
        if (range == NULL) {
            status = OCEL_NULL_ARGUMENT;
        } else if (ocel_colour_line_bytes(format, 1U) == 0U) {
            status = OCEL_BAD_FORMAT;
        } else if ((format == OCEL_FORMAT_RGB565) && (table == NULL)) {
            status = OCEL_NULL_ARGUMENT;
        } else {
            const ocel_colour_range_t same = without_gray(range);

            if (range_valid(&same)) {
                compile_valid(colour, &same, format, table);
            } else {
                status = OCEL_BAD_OPTION;
            }
        }
    }
    return status;
}

/* ---- Testing a line ---- */

static ocel_pixel_t rgb_of_yuyv(const uint8_t *line, uint32_t x) {
    const ocel_pixel_t yuv = ocel_pixel_of_yuyv(line, x);

    return ocel_pixel_from_yuv(&yuv);
}

static ocel_pixel_t read_rgb24(const ocel_colour_t *colour, const uint8_t *line, uint32_t x) {
    const uint8_t *const bytes = &line[3U * x];
    const uint32_t red = (colour->format == OCEL_FORMAT_BGR888) ? 2U : 0U;
    const ocel_pixel_t rgb = {{bytes[red], bytes[1], bytes[2U - red]}};

    return rgb;
}

/* Clears the bit of a pixel that is not in range after all. */
static inline void decide(const ocel_colour_t *colour, const ocel_pixel_t *rgb, uint32_t x,
                          uint32_t *row) {
    if (!rgb_in_range(&colour->range, rgb)) {
        row[x >> 5U] &= ~(1U << (x & 31U));
    }
}

/* A test that passes all in range, then, where it is not exact, the definition: for each
 * format a loop, so that no path, and so no bound, has one's test and another's pixels. */
static void do_yuyv(const ocel_colour_t *colour, const uint8_t *line, uint32_t pixels,
                    uint32_t *row) {
    const uint32_t undecided = (colour->exact == 0U) ? pixels : 0U;

    ocel_row16_yuyv(colour->lanes, line, pixels, row);
    /* bound: OCEL_ROW_WORDS; 1 each time in a call of do_tail */
    for (uint32_t x0 = 0U; x0 < undecided; x0 += 32U) {
        uint32_t passed = row[x0 >> 5U];

        /* bound: 32 bits of a word; 16 each time in a call of do_tail;
         * OCEL_MAX_WIDTH in all rounds of the outer loop */
        while (passed != 0U) {
            const uint32_t x = x0 + ocel_ctz32(passed);
            const ocel_pixel_t rgb = rgb_of_yuyv(line, x);

            passed &= passed - 1U;
            decide(colour, &rgb, x, row);
        }
    }
}

static void do_rgb24(const ocel_colour_t *colour, const uint8_t *line, uint32_t pixels,
                     uint32_t *row) {
    const uint32_t undecided = (colour->exact == 0U) ? pixels : 0U;

    ocel_row24_box(colour->lanes, colour->at, line, pixels, row);
    /* bound: OCEL_ROW_WORDS; 1 each time in a call of do_tail */
    for (uint32_t x0 = 0U; x0 < undecided; x0 += 32U) {
        uint32_t passed = row[x0 >> 5U];

        /* bound: 32 bits of a word; 16 each time in a call of do_tail;
         * OCEL_MAX_WIDTH in all rounds of the outer loop */
        while (passed != 0U) {
            const uint32_t x = x0 + ocel_ctz32(passed);
            const ocel_pixel_t rgb = read_rgb24(colour, line, x);

            passed &= passed - 1U;
            decide(colour, &rgb, x, row);
        }
    }
}

static void look_up_line(const ocel_colour_table_t *table, const uint8_t *line, uint32_t pixels,
                         uint32_t *row) {
    const ocel_row16_table_t colours = {table->word, table->least, table->headroom};

    ocel_row16_table(&colours, line, pixels, row);
}

static void do_line(const ocel_colour_t *colour, const uint8_t *line, uint32_t pixels,
                    uint32_t *row) {
    switch (colour->format) {
    case OCEL_FORMAT_RGB565:
        look_up_line(colour->table, line, pixels, row);
        break;
    case OCEL_FORMAT_YUYV:
        do_yuyv(colour, line, pixels, row);
        break;
    case OCEL_FORMAT_GRAY8:
        ocel_row8_gray(colour->lanes[0], line, pixels, row);
        break;
    case OCEL_FORMAT_RGB888:
    case OCEL_FORMAT_BGR888:
    default:
        do_rgb24(colour, line, pixels, row);
        break;
    }
}

/* The up to fifteen pixels after the last whole group, in a copy that ends in
 * zeros; what those give is masked away. */
static void do_tail(const ocel_colour_t *colour, const uint8_t *tail, uint16_t count,
                    uint32_t first_x, uint32_t *row) {
    uint8_t copy[GROUP_BYTES_MAX];
    uint32_t bits = 0U;

    (void)memset(copy, 0, sizeof(copy));
    /* bytes: 45, fifteen pixels */
    (void)memcpy(copy, tail, ocel_colour_line_bytes(colour->format, count));
    do_line(colour, copy, GROUP, &bits);
    bits &= (1U << (uint32_t)count) - 1U;
    row[first_x >> 5U] |= bits << (first_x & 31U);
}

static ocel_status_t check_row(const ocel_colour_t *colour, size_t line_bytes, uint16_t width) {
    const bool odd = (width & 1U) != 0U;
    ocel_status_t status = OCEL_OK;

    if (colour->state != STATE_COMPILED) {
        status = OCEL_BAD_FORMAT;
    } else if ((width == 0U) || ((uint32_t)width > (uint32_t)OCEL_MAX_WIDTH)) {
        status = OCEL_BAD_SIZE;
    } else if (odd && (colour->format == OCEL_FORMAT_YUYV)) {
        status = OCEL_BAD_SIZE;
    } else if (line_bytes < ocel_colour_line_bytes(colour->format, width)) {
        status = OCEL_BAD_STRIDE;
    } else {
        status = OCEL_OK;
    }
    return status;
}

ocel_status_t ocel_colour_row(const ocel_colour_t *colour, const uint8_t *line, size_t line_bytes,
                              uint16_t width, uint32_t *row) {
    ocel_status_t status = OCEL_NULL_ARGUMENT;

    if ((colour != NULL) && (line != NULL) && (row != NULL)) {
        status = check_row(colour, line_bytes, width);
    }
    if (status == OCEL_OK) {
        const uint16_t tail = (uint16_t)(width % GROUP);
        const uint16_t whole = (uint16_t)(width - tail);
        const size_t words = ((size_t)width + 31U) / 32U;

        /* bytes: 4 * OCEL_ROW_WORDS */
        (void)memset(row, 0, words * sizeof(row[0]));
        do_line(colour, line, whole, row);
        if (tail > 0U) {
            do_tail(colour, &line[ocel_colour_line_bytes(colour->format, whole)], tail, whole, row);
        }
    }
    return status;
}
