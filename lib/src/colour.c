/* SPDX-License-Identifier: MIT
 *
 * From camera lines to bits, eight pixels at a time.
 *
 * A line is gone through twice at most.  The test passes every pixel in range
 * and, eight at a time in one 64-bit word, rejects nearly all others: by bounds
 * of the channels, the most selective first, or by how much one channel leads
 * another.  Where the bounds are not the range itself, what passed is then
 * decided exactly.  RGB565 needs neither: its table is the range.
 */
#include <ocellus/colour.h>

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

#include "bounds.h"
#include "pixel.h"
#include "row16.h"
#include "row24.h"

/* Pixels that the line tests take at a time, and the most bytes of those. */
#define GROUP 8U
#define GROUP_BYTES_MAX 24U

#define RGB565_COLOURS 65536U

/* ocel_colour_t.test */
enum { TEST_NONE = 0, TEST_TABLE, TEST_ALL24, TEST_BOX24, TEST_LEAD24, TEST_YUYV, TEST_GRAY8 };

/* ocel_colour_t.decision */
enum { DECIDED = 0, DECIDE_YUV24, DECIDE_HSV24, DECIDE_YUYV };

/* Below this a lead says little: then the bounds are the better test. */
#define LEAD_MIN 8

/* Bounds wider than this reject too little to be worth testing, when to decide
 * is as cheap as it is for Y, U and V. */
#define WIDTH_MAX 192U

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

static bool channel_valid(const ocel_colour_range_t *range, uint32_t k) {
    return (range->lo[k] <= range->hi[k]) && (range->hi[k] <= 255U);
}

static bool range_valid(const ocel_colour_range_t *range) {
    bool valid = false;

    switch (range->space) {
    case OCEL_SPACE_RGB:
    case OCEL_SPACE_YUV:
        valid = channel_valid(range, 0U) && channel_valid(range, 1U) && channel_valid(range, 2U);
        break;
    case OCEL_SPACE_HSV:
        valid = (range->lo[0] <= 360U) && (range->hi[0] <= 360U) && channel_valid(range, 1U) &&
                channel_valid(range, 2U);
        break;
    case OCEL_SPACE_GRAY:
        valid = channel_valid(range, 0U);
        break;
    default:
        valid = false;
        break;
    }
    return valid;
}

/* The definition of "in range", for a pixel that is given as R, G and B. */
static bool rgb_in_range(const ocel_colour_range_t *range, const ocel_pixel_t *rgb) {
    ocel_pixel_t yuv;
    uint32_t gray;
    bool in = false;

    switch (range->space) {
    case OCEL_SPACE_RGB:
        in = ocel_pixel_in_box(range->lo, range->hi, rgb);
        break;
    case OCEL_SPACE_HSV:
        in = ocel_pixel_in_hsv(range->lo, range->hi, rgb);
        break;
    case OCEL_SPACE_YUV:
        yuv = ocel_pixel_to_yuv(rgb);
        in = ocel_pixel_in_box(range->lo, range->hi, &yuv);
        break;
    case OCEL_SPACE_GRAY:
        gray = ocel_pixel_gray(rgb);
        in = (gray >= range->lo[0]) && (gray <= range->hi[0]);
        break;
    default:
        in = false;
        break;
    }
    return in;
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

static ocel_bounds_t bounds_of_range(const ocel_colour_range_t *range) {
    ocel_bounds_t bounds;

    for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 channels */
        bounds.lo[k] = (int32_t)range->lo[k];
        bounds.hi[k] = (int32_t)range->hi[k];
    }
    return bounds;
}

/* Bounds within 0..255, into channel order.  One empty channel empties all, as
 * 0 <= v < 0, which the lane tests never pass. */
static void set_bounds(ocel_colour_t *colour, const ocel_bounds_t *bounds) {
    bool empty = false;

    for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 channels */
        empty = empty || (bounds->lo[k] > bounds->hi[k]);
    }
    for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 channels */
        colour->begin[k] = empty ? 0U : (uint16_t)bounds->lo[k];
        colour->end[k] = empty ? 0U : (uint16_t)(bounds->hi[k] + 1);
        colour->at[k] = (uint8_t)k;
    }
}

static uint32_t width_of(const ocel_colour_t *colour, uint32_t k) {
    return (uint32_t)colour->end[k] - (uint32_t)colour->begin[k];
}

static void swap_channels(ocel_colour_t *colour, uint32_t a, uint32_t b) {
    const uint16_t begin = colour->begin[a];
    const uint16_t end = colour->end[a];
    const uint8_t at = colour->at[a];

    colour->begin[a] = colour->begin[b];
    colour->end[a] = colour->end[b];
    colour->at[a] = colour->at[b];
    colour->begin[b] = begin;
    colour->end[b] = end;
    colour->at[b] = at;
}

/* Narrowest first: over a background of any colours it rejects most. */
static void order_channels(ocel_colour_t *colour) {
    for (uint32_t k = 1U; k < 3U; k++) { /* bound: 3 channels */
        if (width_of(colour, k) < width_of(colour, 0U)) {
            swap_channels(colour, 0U, k);
        }
    }
}

/* Where R stands in a pixel of three bytes. */
static uint32_t red_of(const ocel_colour_t *colour) {
    return (colour->format == OCEL_FORMAT_BGR888) ? 2U : 0U;
}

/* Where R, G or B, channel 0..2, stands in it. */
static uint32_t byte_of(const ocel_colour_t *colour, uint32_t channel) {
    return (red_of(colour) == 0U) ? channel : (2U - channel);
}

static void compile_rgb24(ocel_colour_t *colour) {
    const ocel_colour_range_t *const range = &colour->range;
    ocel_bounds_t bounds = bounds_of_range(range);
    ocel_lead_t lead = {0U, 1U, 0};

    colour->decision = (uint8_t)DECIDED;
    switch (range->space) {
    case OCEL_SPACE_HSV:
        bounds = ocel_bounds_of_hsv(range->lo, range->hi, &lead);
        colour->decision = (uint8_t)DECIDE_HSV24;
        break;
    case OCEL_SPACE_YUV:
        bounds = ocel_bounds_of_yuv(range->lo, range->hi, &lead);
        colour->decision = (uint8_t)DECIDE_YUV24;
        break;
    case OCEL_SPACE_GRAY:
        bounds = ocel_bounds_of_gray(range->lo[0], range->hi[0]);
        colour->decision = (uint8_t)DECIDE_YUV24;
        break;
    case OCEL_SPACE_RGB:
    default:
        break; /* the bounds are the range */
    }
    set_bounds(colour, &bounds);
    order_channels(colour);
    for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 channels */
        colour->at[k] = (uint8_t)byte_of(colour, colour->at[k]);
    }
    colour->above = (uint8_t)byte_of(colour, lead.above);
    colour->below = (uint8_t)byte_of(colour, lead.below);
    colour->lead = (uint8_t)lead.least;
    if (lead.least >= LEAD_MIN) {
        colour->test = (uint8_t)TEST_LEAD24;
    } else if ((colour->decision == (uint8_t)DECIDE_YUV24) && (width_of(colour, 0U) > WIDTH_MAX)) {
        colour->test = (uint8_t)TEST_ALL24;
    } else {
        colour->test = (uint8_t)TEST_BOX24;
    }
}

/* Grey of a YUYV pixel is its Y. */
static void compile_yuyv(ocel_colour_t *colour) {
    const ocel_colour_range_t *const range = &colour->range;
    ocel_bounds_t bounds = bounds_of_range(range);
    ocel_lead_t lead;

    colour->decision = (uint8_t)DECIDED;
    switch (range->space) {
    case OCEL_SPACE_RGB:
        bounds = ocel_bounds_to_yuv(&bounds);
        colour->decision = (uint8_t)DECIDE_YUYV;
        break;
    case OCEL_SPACE_HSV:
        bounds = ocel_bounds_of_hsv(range->lo, range->hi, &lead);
        bounds = ocel_bounds_to_yuv(&bounds);
        colour->decision = (uint8_t)DECIDE_YUYV;
        break;
    case OCEL_SPACE_GRAY:
        bounds.lo[1] = 0;
        bounds.hi[1] = 255;
        bounds.lo[2] = 0;
        bounds.hi[2] = 255;
        break;
    case OCEL_SPACE_YUV:
    default:
        break; /* the bounds are the range */
    }
    set_bounds(colour, &bounds);
    colour->test = (uint8_t)TEST_YUYV;
}

/* A grey pixel v is R = G = B = Y = V(alue) = v, U = V = 128, H = S = 0: every
 * range is a range of v, or empty. */
static void compile_gray8(ocel_colour_t *colour) {
    const ocel_colour_range_t *const range = &colour->range;
    ocel_bounds_t bounds = bounds_of_range(range);
    bool some = true;

    switch (range->space) {
    case OCEL_SPACE_RGB:
        for (uint32_t k = 1U; k < 3U; k++) { /* bound: 3 channels */
            bounds.lo[0] = (bounds.lo[k] > bounds.lo[0]) ? bounds.lo[k] : bounds.lo[0];
            bounds.hi[0] = (bounds.hi[k] < bounds.hi[0]) ? bounds.hi[k] : bounds.hi[0];
        }
        break;
    case OCEL_SPACE_HSV:
        some = ((range->lo[0] == 0U) || (range->lo[0] > range->hi[0])) && (range->lo[1] == 0U);
        bounds.lo[0] = bounds.lo[2];
        bounds.hi[0] = bounds.hi[2];
        break;
    case OCEL_SPACE_YUV:
        some = (range->lo[1] <= 128U) && (range->hi[1] >= 128U) && (range->lo[2] <= 128U) &&
               (range->hi[2] >= 128U);
        break;
    case OCEL_SPACE_GRAY:
    default:
        break;
    }
    for (uint32_t k = 1U; k < 3U; k++) { /* bound: 3 channels */
        bounds.lo[k] = 0;
        bounds.hi[k] = some ? 255 : -1;
    }
    set_bounds(colour, &bounds);
    colour->decision = (uint8_t)DECIDED;
    colour->test = (uint8_t)TEST_GRAY8;
}

static ocel_status_t compile_checked(ocel_colour_t *colour, ocel_colour_table_t *table) {
    ocel_status_t status = OCEL_OK;

    switch (colour->format) {
    case OCEL_FORMAT_RGB565:
        fill_table(table, &colour->range);
        colour->table = table;
        colour->decision = (uint8_t)DECIDED;
        colour->test = (uint8_t)TEST_TABLE;
        break;
    case OCEL_FORMAT_RGB888:
    case OCEL_FORMAT_BGR888:
        compile_rgb24(colour);
        break;
    case OCEL_FORMAT_YUYV:
        compile_yuyv(colour);
        break;
    case OCEL_FORMAT_GRAY8:
        compile_gray8(colour);
        break;
    default:
        status = OCEL_BAD_FORMAT;
        break;
    }
    return status;
}

ocel_status_t ocel_colour_compile(ocel_colour_t *colour, const ocel_colour_range_t *range,
                                  ocel_format_t format, ocel_colour_table_t *table) {
    ocel_status_t status = OCEL_OK;

    if (colour == NULL) {
        status = OCEL_NULL_ARGUMENT;
    } else {
        (void)memset(colour, 0, sizeof(*colour)); /* TEST_NONE, until all is well */
        if (range == NULL) {
            status = OCEL_NULL_ARGUMENT;
        } else if (ocel_colour_line_bytes(format, 1U) == 0U) {
            status = OCEL_BAD_FORMAT;
        } else if ((format == OCEL_FORMAT_RGB565) && (table == NULL)) {
            status = OCEL_NULL_ARGUMENT;
        } else if (!range_valid(range)) {
            status = OCEL_BAD_OPTION;
        } else {
            colour->range = *range;
            colour->format = format;
            status = compile_checked(colour, table);
        }
    }
    return status;
}

/* ---- Testing a line ---- */

static void test_line(const ocel_colour_t *colour, const uint8_t *line, uint32_t pixels,
                      uint32_t *row) {
    switch (colour->test) {
    case TEST_TABLE:
        ocel_row16_table(colour->table->word, line, pixels, row);
        break;
    case TEST_ALL24:
        ocel_row24_all(pixels, row);
        break;
    case TEST_BOX24:
        ocel_row24_box(colour->begin, colour->end, colour->at, line, pixels, row);
        break;
    case TEST_LEAD24:
        ocel_row24_lead(colour->above, colour->below, colour->lead, line, pixels, row);
        break;
    case TEST_YUYV:
        ocel_row16_yuyv(colour->begin, colour->end, line, pixels, row);
        break;
    case TEST_GRAY8:
    default:
        ocel_row8_gray(colour->begin[0], colour->end[0], line, pixels, row);
        break;
    }
}

static void decide_line(const ocel_colour_t *colour, const uint8_t *line, uint32_t pixels,
                        uint32_t *row) {
    const ocel_colour_range_t *const range = &colour->range;

    switch (colour->decision) {
    case DECIDE_YUV24:
        ocel_row24_decide_yuv(range->lo, range->hi, (range->space == OCEL_SPACE_GRAY) ? 1U : 3U,
                              red_of(colour), line, pixels, row);
        break;
    case DECIDE_HSV24:
        ocel_row24_decide_hsv(range->lo, range->hi, red_of(colour), line, pixels, row);
        break;
    case DECIDE_YUYV:
        ocel_row16_decide_yuyv(range->lo, range->hi, range->space == OCEL_SPACE_HSV, line, pixels,
                               row);
        break;
    default:
        break;
    }
}

static void do_line(const ocel_colour_t *colour, const uint8_t *line, uint32_t pixels,
                    uint32_t *row) {
    test_line(colour, line, pixels, row);
    if (colour->decision != (uint8_t)DECIDED) {
        decide_line(colour, line, pixels, row);
    }
}

/* The up to seven pixels after the last whole group, in a copy that ends in
 * zeros; what those give is masked away. */
static void do_tail(const ocel_colour_t *colour, const uint8_t *tail, uint16_t count,
                    uint32_t first_x, uint32_t *row) {
    uint8_t copy[GROUP_BYTES_MAX] = {0U};
    uint32_t bits = 0U;

    (void)memcpy(copy, tail, ocel_colour_line_bytes(colour->format, count));
    do_line(colour, copy, GROUP, &bits);
    bits &= (1U << count) - 1U;
    row[first_x >> 5U] |= bits << (first_x & 31U);
}

static ocel_status_t check_row(const ocel_colour_t *colour, size_t line_bytes, uint16_t width) {
    const bool odd = (width & 1U) != 0U;
    ocel_status_t status = OCEL_OK;

    if (colour->test == (uint8_t)TEST_NONE) {
        status = OCEL_BAD_FORMAT;
    } else if ((width == 0U) || (width > OCEL_MAX_WIDTH)) {
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

        (void)memset(row, 0, words * sizeof(row[0]));
        do_line(colour, line, whole, row);
        if (tail > 0U) {
            do_tail(colour, &line[ocel_colour_line_bytes(colour->format, whole)], tail, whole, row);
        }
    }
    return status;
}
