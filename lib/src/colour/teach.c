/* SPDX-License-Identifier: MIT
 *
 * Learning a range of colours from a rectangle: a histogram per channel, and
 * what is between its tails.
 */
#include <ocellus/colour.h>

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

#include "../base/int_math.h"
#include "lanes.h"
#include "pixel.h"

#define BINS 256U

/* Fewest pixels that 96 % can be spoken of. */
#define PIXELS_MIN 16U

/* So that a bin that counts chroma, at most 255 a pixel, holds them all:
 * 2^24 * 255 < 2^32. */
#define PIXELS_MAX 16777216U

/* Noise of +-2 levels turns the hue of this chroma by 60 * 2 / 8 = 15 degrees. */
#define CHROMA_MIN 8U

/* Pixels whose mean chroma is under this are no better than noise themselves. */
#define CHROMA_WEAK 16U

#define TURN_DEG 360U

/* ocel_teach_t.state; not 0 or 1, as memory that was never begun often is. */
#define STATE_BEGUN 0x7EACU

ocel_status_t ocel_teach_begin(ocel_teach_t *teach, ocel_space_t space, ocel_format_t format) {
    ocel_status_t status = OCEL_OK;

    if (teach == NULL) {
        status = OCEL_NULL_ARGUMENT;
    } else {
        (void)memset(teach, 0, sizeof(*teach));
        if (ocel_colour_line_bytes(format, 1U) == 0U) {
            status = OCEL_BAD_FORMAT;
        } else if ((space != OCEL_SPACE_RGB) && (space != OCEL_SPACE_HSV) &&
                   (space != OCEL_SPACE_YUV) && (space != OCEL_SPACE_GRAY)) {
            status = OCEL_BAD_OPTION;
        } else {
            teach->space = space;
            teach->format = format;
            teach->state = STATE_BEGUN;
        }
    }
    return status;
}

/* ---- Reading pixels ---- */

/* R, G, B of pixel x. */
static ocel_pixel_t read_as_rgb(ocel_format_t format, const uint8_t *line, uint32_t x) {
    ocel_pixel_t rgb;

    if (format == OCEL_FORMAT_RGB565) {
        rgb = ocel_pixel_from_rgb565(ocel_load16(&line[2U * x]));
    } else if (format == OCEL_FORMAT_YUYV) {
        const ocel_pixel_t yuv = ocel_pixel_of_yuyv(line, x);

        rgb = ocel_pixel_from_yuv(&yuv);
    } else {
        const uint32_t first = (format == OCEL_FORMAT_GRAY8) ? x : (3U * x);
        const uint32_t step = (format == OCEL_FORMAT_GRAY8) ? 0U : 1U;
        const bool is_bgr = format == OCEL_FORMAT_BGR888;

        for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 channels */
            rgb.c[k] = line[first + (step * (is_bgr ? (2U - k) : k))];
        }
    }
    return rgb;
}

static void count_channels(ocel_teach_t *teach, const ocel_pixel_t *pixel) {
    for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 channels */
        teach->count[k][pixel->c[k]]++;
    }
}

/* floor(num / den), 0..255: num < 256 den, den < 2^24. */
static uint32_t quotient8(uint32_t num, uint32_t den) {
    uint32_t rest = num;
    uint32_t quotient = 0U;

    for (uint32_t bit = 8U; bit > 0U; bit--) { /* bound: 8 bits */
        const uint32_t step = den << (bit - 1U);

        if (rest >= step) {
            rest -= step;
            quotient |= 1U << (bit - 1U);
        }
    }
    return quotient;
}

/* 256 * hue < 256 * 360 * unit <= 256 * 91800 < 2^25. */
static void count_hsv(ocel_teach_t *teach, const ocel_pixel_t *rgb) {
    const ocel_pixel_hsv_t hsv = ocel_pixel_to_hsv(rgb);
    const uint32_t saturation = quotient8(255U * hsv.chroma, hsv.value_unit);

    if (hsv.chroma < CHROMA_MIN) {
        teach->hueless[0][saturation]++;
        teach->hueless[1][hsv.value]++;
        teach->hueless_pixels++;
    } else {
        const uint32_t hue = quotient8(BINS * hsv.hue, TURN_DEG * hsv.hue_unit);

        teach->count[0][hue] += hsv.chroma;
        teach->count[1][saturation]++;
        teach->count[2][hsv.value]++;
    }
}

static void count_pixel(ocel_teach_t *teach, const uint8_t *line, uint32_t x) {
    const bool is_yuyv = teach->format == OCEL_FORMAT_YUYV;
    ocel_pixel_t pixel;

    if (teach->space == OCEL_SPACE_HSV) {
        pixel = read_as_rgb(teach->format, line, x);
        count_hsv(teach, &pixel);
    } else if (teach->space == OCEL_SPACE_RGB) {
        pixel = read_as_rgb(teach->format, line, x);
        count_channels(teach, &pixel);
    } else {
        /* YUV, and grey, which is its Y. */
        pixel = is_yuyv ? ocel_pixel_of_yuyv(line, x) : read_as_rgb(teach->format, line, x);
        pixel = is_yuyv ? pixel : ocel_pixel_to_yuv(&pixel);
        count_channels(teach, &pixel);
    }
}

/* A pixel of YUYV has bytes up to the end of its pair. */
static size_t bytes_up_to(ocel_format_t format, uint32_t end_x) {
    const uint32_t whole = (format == OCEL_FORMAT_YUYV) ? (end_x + (end_x & 1U)) : end_x;

    return ocel_colour_line_bytes(format, (uint16_t)whole);
}

static ocel_status_t check_line(const ocel_teach_t *teach, size_t line_bytes, uint16_t first_x,
                                uint16_t count) {
    const uint32_t end_x = (uint32_t)first_x + (uint32_t)count;
    ocel_status_t status = OCEL_OK;

    if (teach->state != STATE_BEGUN) {
        status = OCEL_BAD_ORDER;
    } else if ((count == 0U) || (end_x > (uint32_t)OCEL_MAX_WIDTH)) {
        status = OCEL_BAD_SIZE;
    } else if (line_bytes < bytes_up_to(teach->format, end_x)) {
        status = OCEL_BAD_STRIDE;
    } else if ((PIXELS_MAX - teach->pixels) < count) {
        status = OCEL_OVERFLOW;
    } else {
        status = OCEL_OK;
    }
    return status;
}

ocel_status_t ocel_teach_line(ocel_teach_t *teach, const uint8_t *line, size_t line_bytes,
                              uint16_t first_x, uint16_t count) {
    ocel_status_t status = OCEL_NULL_ARGUMENT;

    if ((teach != NULL) && (line != NULL)) {
        status = check_line(teach, line_bytes, first_x, count);
    }
    if (status == OCEL_OK) {
        for (uint32_t k = 0U; k < count; k++) { /* bound: OCEL_MAX_WIDTH */
            count_pixel(teach, line, (uint32_t)first_x + k);
        }
        teach->pixels += count;
    }
    return status;
}

/* ---- Ranges from counts ---- */

/* Bins of two histograms together, `other` being null when there is but one. */
static uint32_t bin_of(const uint32_t *counts, const uint32_t *other, uint32_t bin) {
    return counts[bin] + ((other != NULL) ? other[bin] : 0U);
}

static uint32_t total_of(const uint32_t *counts, const uint32_t *other) {
    uint32_t total = 0U;

    for (uint32_t bin = 0U; bin < BINS; bin++) { /* bound: BINS */
        total += bin_of(counts, other, bin);
    }
    return total;
}

/* The first bin from one side (step 1) or the other that more than 2 % of the
 * total lie in or before. */
static uint32_t tail_end(const uint32_t *counts, const uint32_t *other, bool from_top) {
    const uint32_t tail = (uint32_t)ocel_udiv64(total_of(counts, other), 50U);
    uint32_t before = 0U;
    uint32_t found = 0U;

    for (uint32_t k = 0U; k < BINS; k++) { /* bound: BINS */
        const uint32_t bin = from_top ? ((BINS - 1U) - k) : k;

        before += bin_of(counts, other, bin);
        if (before > tail) {
            found = bin;
            break;
        }
    }
    return found;
}

static uint32_t widening(uint32_t width, uint32_t margin) {
    const uint32_t quarter = width >> 2U;

    return (quarter > margin) ? quarter : margin;
}

static void learn_channel(ocel_colour_range_t *range, uint32_t k, const uint32_t *counts,
                          const uint32_t *other, uint32_t margin) {
    const uint32_t lo = tail_end(counts, other, false);
    const uint32_t hi = tail_end(counts, other, true);
    const uint32_t widen = widening(hi - lo, margin);

    range->lo[k] = (uint16_t)((lo > widen) ? (lo - widen) : 0U);
    range->hi[k] = (uint16_t)(((hi + widen) < 255U) ? (hi + widen) : 255U);
}

/* The shortest arc of bins that holds all but 4 % of the hue's weight; of equal
 * ones that with the lowest first bin. */
typedef struct {
    uint32_t first;
    uint32_t length; /* 1..256 */
} arc_t;

/* A window that grows until it holds enough and shrinks while it does.  Its
 * first bin goes from 0 to 255, its end never back and not beyond 2 * 255. */
static arc_t shortest_arc(const uint32_t *weights) {
    const uint32_t total = total_of(weights, NULL);
    const uint32_t enough = total - (uint32_t)ocel_udiv64(total, 25U);
    arc_t arc = {0U, BINS};
    arc_t window = {0U, 0U};
    uint32_t held = 0U;

    while (window.first < BINS) { /* bound: 3 * BINS steps, of first or of the end */
        if (held < enough) {
            held += weights[(window.first + window.length) % BINS];
            window.length++;
        } else {
            if (window.length < arc.length) {
                arc = window;
            }
            held -= weights[window.first];
            window.first++;
            window.length--;
        }
    }
    return arc;
}

/* Bins to degrees, 360 / 256 = 45 / 32 a bin: down for the first, up for the end.
 * Less than a turn together with what widens them, they wrap once at most:
 * lo - widen > -360, and hi + widen < 360 + lo - widen < 720. */
static void learn_hue(ocel_colour_range_t *range, const uint32_t *weights) {
    const arc_t arc = shortest_arc(weights);
    const uint32_t lo = (arc.first * 45U) >> 5U;
    const uint32_t hi = (((arc.first + arc.length) * 45U) + 31U) >> 5U;
    const uint32_t widen = widening(hi - lo, 4U);

    if (((hi - lo) + (2U * widen)) >= TURN_DEG) {
        range->lo[0] = 0U;
        range->hi[0] = (uint16_t)TURN_DEG;
    } else {
        const uint32_t from = (lo + TURN_DEG) - widen;
        const uint32_t to = hi + widen;

        range->lo[0] = (uint16_t)((from >= TURN_DEG) ? (from - TURN_DEG) : from);
        range->hi[0] = (uint16_t)((to >= TURN_DEG) ? (to - TURN_DEG) : to);
    }
}

/* Whether the object's pixels carry a hue, and those that do not are something
 * else: a minority, and one beside pixels of clear colour unless it is too small
 * to matter.  Products and sums are at most 2^24 * 255. */
static bool is_coloured(const ocel_teach_t *teach) {
    const uint32_t hued = teach->pixels - teach->hueless_pixels;
    const uint32_t chroma = total_of(teach->count[0], NULL);
    const bool few = teach->hueless_pixels <= (teach->pixels / 32U);
    const bool minority = teach->hueless_pixels <= (teach->pixels / 2U);

    return few || (minority && (chroma >= (CHROMA_WEAK * hued)));
}

/* The margins of S and V are wide: brightness changes with the light, and
 * saturation with the brightness. */
static void learn_hsv(ocel_colour_range_t *range, const ocel_teach_t *teach) {
    const bool coloured = is_coloured(teach);

    if (coloured) {
        learn_hue(range, teach->count[0]);
        learn_channel(range, 1U, teach->count[1], NULL, 16U);
        learn_channel(range, 2U, teach->count[2], NULL, 16U);
    } else {
        range->lo[0] = 0U;
        range->hi[0] = (uint16_t)TURN_DEG;
        learn_channel(range, 1U, teach->count[1], teach->hueless[0], 16U);
        learn_channel(range, 2U, teach->count[2], teach->hueless[1], 16U);
    }
}

static void leave_open(ocel_colour_range_t *range, uint32_t k) {
    range->lo[k] = 0U;
    range->hi[k] = 255U;
}

/* Even lower and odd upper bounds cost nothing and spare the row tests a step. */
static void round_outwards(ocel_colour_range_t *range) {
    for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 channels */
        range->lo[k] = (uint16_t)(range->lo[k] - (range->lo[k] & 1U));
        range->hi[k] = (uint16_t)(range->hi[k] | 1U);
    }
}

ocel_status_t ocel_teach_end(const ocel_teach_t *teach, ocel_colour_range_t *range) {
    ocel_status_t status = OCEL_OK;

    if ((teach == NULL) || (range == NULL)) {
        status = OCEL_NULL_ARGUMENT;
    } else if (teach->state != STATE_BEGUN) {
        status = OCEL_BAD_ORDER;
    } else if (teach->pixels < PIXELS_MIN) {
        status = OCEL_TOO_FEW_POINTS;
    } else {
        range->space = teach->space;
        if (teach->space == OCEL_SPACE_HSV) {
            learn_hsv(range, teach);
        } else {
            const uint32_t margin = (teach->space == OCEL_SPACE_YUV) ? 4U : 8U;

            learn_channel(range, 0U, teach->count[0], NULL, 8U);
            learn_channel(range, 1U, teach->count[1], NULL, margin);
            learn_channel(range, 2U, teach->count[2], NULL, margin);
            round_outwards(range);
            if (teach->space == OCEL_SPACE_GRAY) {
                leave_open(range, 1U);
                leave_open(range, 2U);
            }
        }
    }
    return status;
}
