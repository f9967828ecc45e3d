/* SPDX-License-Identifier: MIT
 *
 * Lines of three bytes a pixel, a group of as many pixels as a word has bytes at
 * a time.
 *
 * A group is three words.  As 3 has no divisor in common with 4 or 8, the bytes
 * of one channel stand at different places in the three: masked and or-ed, they
 * are all in one word, the channel's plane, pixel k of channel c in byte
 * (3k + c) mod OCEL_GROUP.  Rotated by c bytes, the planes of all channels have
 * the same order, OCEL_ORDER_BY_THREES, so that answers can be and-ed.
 */
#include "row24.h"

#include <stdbool.h>

#include "int_math.h"
#include "lanes.h"
#include "pixel.h"

#define PIXEL_BYTES 3U

/* The bytes of a word whose index is 0, 1 or 2 modulo 3. */
#define THIRDS_0 OCEL_PATTERN(0x00FF0000FF0000FF)
#define THIRDS_1 OCEL_PATTERN(0xFF0000FF0000FF00)
#define THIRDS_2 OCEL_PATTERN(0x0000FF0000FF0000)

/* Where in the three words of a group the bytes of one channel stand. */
typedef struct {
    ocel_word_t mask[3];
} plane_t;

/* Word k begins with byte k OCEL_GROUP of the group, which is k mod 3 more for
 * groups of four and 2k mod 3 for groups of eight. */
static inline plane_t plane_at(uint32_t at) {
#if OCEL_WORD_BITS == 64
    static const plane_t planes[3] = {{{THIRDS_0, THIRDS_1, THIRDS_2}},
                                      {{THIRDS_1, THIRDS_2, THIRDS_0}},
                                      {{THIRDS_2, THIRDS_0, THIRDS_1}}};
#else
    static const plane_t planes[3] = {{{THIRDS_0, THIRDS_2, THIRDS_1}},
                                      {{THIRDS_1, THIRDS_0, THIRDS_2}},
                                      {{THIRDS_2, THIRDS_1, THIRDS_0}}};
#endif

    return planes[at];
}

/* The same without the bits that are not in `bits`. */
static inline plane_t plane_bits(const plane_t *plane, ocel_word_t bits) {
    const plane_t part = {{plane->mask[0] & bits, plane->mask[1] & bits, plane->mask[2] & bits}};

    return part;
}

static inline ocel_word_t take(const plane_t *plane, const uint8_t *group) {
    return (ocel_load_word(group) & plane->mask[0]) |
           (ocel_load_word(&group[OCEL_WORD_BYTES]) & plane->mask[1]) |
           (ocel_load_word(&group[2U * OCEL_WORD_BYTES]) & plane->mask[2]);
}

static inline void put(uint32_t *row, uint32_t x, uint32_t bits) {
    row[x >> 5U] |= bits << (x & 31U);
}

/* ---- Tests ---- */

typedef struct {
    plane_t plane;
    uint32_t rotation; /* bits, to OCEL_ORDER_BY_THREES */
    ocel_lane_range_t range;
} channel_test_t;

static inline channel_test_t channel_test(uint32_t begin, uint32_t end, uint32_t at) {
    const channel_test_t test = {plane_at(at), 8U * at, ocel_lane_range(begin, end)};

    return test;
}

static inline ocel_word_t channel_in(const channel_test_t *test, const uint8_t *group) {
    const ocel_word_t plane = ocel_rotate_right(take(&test->plane, group), test->rotation);

    return ocel_lanes_in(plane, &test->range);
}

/* The upper seven bits of one channel: what most groups are rejected by, so it
 * is the whole of the inner loop and has no more than it needs. */
typedef struct {
    plane_t upper;
    ocel_lane_range_t range;
} glance_t;

static inline glance_t glance_at(uint32_t begin, uint32_t end, uint32_t at) {
    const plane_t plane = plane_at(at);
    const glance_t glance = {plane_bits(&plane, ~OCEL_LOW_BITS), ocel_lane_range(begin, end)};

    return glance;
}

static inline ocel_word_t glance(const glance_t *first, const uint8_t *group) {
    return ocel_lanes_may_be_in(take(&first->upper, group) >> 1U, &first->range);
}

/* Pixels up to the first pair of groups in which a glance is not enough; without
 * any, up to the end of the last pair. */
static inline uint32_t look_on(const glance_t *first, const uint8_t *line, uint32_t pixels) {
    const uint32_t pairs = pixels / (2U * OCEL_GROUP);
    const uint8_t *group = line;
    uint32_t left = pairs;

    while (left > 0U) { /* bound: OCEL_MAX_WIDTH / (2 OCEL_GROUP) */
        const ocel_word_t one = glance(first, group);
        const ocel_word_t other = glance(first, &group[PIXEL_BYTES * OCEL_GROUP]);

        if (((one | other) & OCEL_TOP_BITS) != 0U) {
            break;
        }
        group = &group[2U * PIXEL_BYTES * OCEL_GROUP];
        left--;
    }
    return 2U * OCEL_GROUP * (pairs - left);
}

/* The rest of a line, from the first group at which a glance was not enough.
 * Where begin and end are even a glance is exact. */
static void box_from(const glance_t *first, const uint16_t begin[3], const uint16_t end[3],
                     const uint8_t at[3], const uint8_t *line, uint32_t x0, uint32_t pixels,
                     uint32_t *row) {
    const channel_test_t test0 = channel_test(begin[0], end[0], at[0]);
    const channel_test_t test1 = channel_test(begin[1], end[1], at[1]);
    const channel_test_t test2 = channel_test(begin[2], end[2], at[2]);
    const bool exact = (test0.range.begin_odd | test0.range.end_odd) == 0U;
    const uint8_t *group = &line[PIXEL_BYTES * x0];

    for (uint32_t x = x0; x < pixels; x += OCEL_GROUP) { /* bound: OCEL_MAX_WIDTH / OCEL_GROUP */
        ocel_word_t in = glance(first, group) & OCEL_TOP_BITS;

        if (in != 0U) {
            in = ocel_rotate_right(in, test0.rotation);
            if (!exact) {
                in &= channel_in(&test0, group);
            }
            in &= channel_in(&test1, group) & channel_in(&test2, group);
            put(row, x, ocel_gather(in, OCEL_ORDER_BY_THREES));
        }
        group = &group[PIXEL_BYTES * OCEL_GROUP];
    }
}

void ocel_row24_box(const uint16_t begin[3], const uint16_t end[3], const uint8_t at[3],
                    const uint8_t *line, uint32_t pixels, uint32_t *row) {
    const glance_t first = glance_at(begin[0], end[0], at[0]);
    const uint32_t x = look_on(&first, line, pixels);

    if (x < pixels) {
        box_from(&first, begin, end, at, line, x, pixels, row);
    }
}

void ocel_row24_all(uint32_t pixels, uint32_t *row) {
    for (uint32_t x = 0U; x < pixels; x += 32U) { /* bound: OCEL_ROW_WORDS */
        const uint32_t left = pixels - x;

        row[x >> 5U] = (left >= 32U) ? 0xFFFFFFFFU : ((1U << left) - 1U);
    }
}

/* By the upper six bits of both channels, x and y in each byte: x + 128 - n - y
 * reaches bit 7 when x - y >= n.  With x, y <= 63 and n <= 63 it is within
 * 2 .. 191: nothing is borrowed or carried.  above - below >= lead implies
 * 4 x + 3 - 4 y >= lead, and so x - y >= floor(lead / 4). */
void ocel_row24_lead(uint32_t above, uint32_t below, uint32_t lead, const uint8_t *line,
                     uint32_t pixels, uint32_t *row) {
    const ocel_word_t upper_six = OCEL_PATTERN(0xFCFCFCFCFCFCFCFC);
    const plane_t above_plane = plane_at(above);
    const plane_t below_plane = plane_at(below);
    const plane_t above_six = plane_bits(&above_plane, upper_six);
    const plane_t below_six = plane_bits(&below_plane, upper_six);
    const uint32_t between = (8U * (below - above)) & ((uint32_t)OCEL_WORD_BITS - 1U);
    const ocel_word_t reach = ocel_spread(128U - (lead >> 2U));
    const uint8_t *group = line;

    for (uint32_t x = 0U; x < pixels; x += OCEL_GROUP) { /* bound: OCEL_MAX_WIDTH / OCEL_GROUP */
        const ocel_word_t more = take(&above_six, group) >> 2U;
        const ocel_word_t less = ocel_rotate_right(take(&below_six, group), between) >> 2U;
        const ocel_word_t leads = ((more + reach) - less) & OCEL_TOP_BITS;

        if (leads != 0U) {
            put(row, x, ocel_gather(ocel_rotate_right(leads, 8U * above), OCEL_ORDER_BY_THREES));
        }
        group = &group[PIXEL_BYTES * OCEL_GROUP];
    }
}

/* ---- Decisions ---- */

/* Three planes in the order of R, G and B, split into the even and the odd bytes,
 * each byte in a lane of 16 bits. */
typedef struct {
    ocel_word_t even[3];
    ocel_word_t odd[3];
} split_t;

static inline void split_plane(split_t *split, uint32_t channel, uint32_t at,
                               const uint8_t *group) {
    const plane_t plane = plane_at(at);
    const ocel_word_t bytes = ocel_rotate_right(take(&plane, group), 8U * at);

    split->even[channel] = bytes & OCEL_EVEN_BYTES;
    split->odd[channel] = (bytes >> 8U) & OCEL_EVEN_BYTES;
}

/* Y, U or V = (weights . RGB + round) >> 8 in each lane. */
typedef struct {
    ocel_word_t weight[3];
    ocel_word_t round;
    ocel_lane_range_t range;
} sum_t;

static sum_t sum_of(uint32_t k, uint32_t lo, uint32_t hi) {
    static const int32_t weight_q8[3][3] = OCEL_YUV_Q8;
    static const int32_t round_q8[3] = OCEL_YUV_ROUND_Q8;
    const sum_t sum = {
        {(ocel_word_t)weight_q8[k][0], (ocel_word_t)weight_q8[k][1], (ocel_word_t)weight_q8[k][2]},
        (ocel_word_t)round_q8[k] * OCEL_PATTERN(0x0001000100010001),
        ocel_lane_range(lo, hi + 1U)};

    return sum;
}

/* A lane's sum is 0..65535 (pixel.c), although its terms are not: all is done
 * modulo 2^OCEL_WORD_BITS, where whatever is borrowed on the way is paid back. */
static inline ocel_word_t sum_lanes(const sum_t *sum, const ocel_word_t rgb[3]) {
    return (sum->weight[0] * rgb[0]) + (sum->weight[1] * rgb[1]) + (sum->weight[2] * rgb[2]) +
           sum->round;
}

static inline ocel_word_t sum_in(const sum_t *sum, const split_t *split) {
    const ocel_word_t even = (sum_lanes(sum, split->even) >> 8U) & OCEL_EVEN_BYTES;
    const ocel_word_t odd = sum_lanes(sum, split->odd) & ~OCEL_EVEN_BYTES;

    return ocel_lanes_in(even | odd, &sum->range);
}

static uint32_t yuv_in(const sum_t *sum, uint32_t channels, uint32_t red, const uint8_t *group) {
    split_t split;
    ocel_word_t in = 0U;

    split_plane(&split, 0U, red, group);
    split_plane(&split, 1U, 1U, group);
    split_plane(&split, 2U, 2U - red, group);
    in = sum_in(&sum[0], &split);
    if (channels > 1U) {
        in &= sum_in(&sum[1], &split) & sum_in(&sum[2], &split);
    }
    return ocel_gather(in, OCEL_ORDER_BY_THREES);
}

void ocel_row24_decide_yuv(const uint16_t lo[3], const uint16_t hi[3], uint32_t channels,
                           uint32_t red, const uint8_t *line, uint32_t pixels, uint32_t *row) {
    const uint32_t mask = (1U << OCEL_GROUP) - 1U;
    sum_t sum[3];

    for (uint32_t k = 0U; k < channels; k++) { /* bound: 3 channels */
        sum[k] = sum_of(k, lo[k], hi[k]);
    }
    for (uint32_t x = 0U; x < pixels; x += OCEL_GROUP) { /* bound: OCEL_MAX_WIDTH / OCEL_GROUP */
        const uint32_t passed = (row[x >> 5U] >> (x & 31U)) & mask;

        if (passed != 0U) {
            const uint32_t in = yuv_in(sum, channels, red, &line[PIXEL_BYTES * x]);

            row[x >> 5U] &= ~((passed & ~in) << (x & 31U));
        }
    }
}

static bool hsv_in(const uint16_t lo[3], const uint16_t hi[3], uint32_t red, const uint8_t *bytes) {
    const ocel_pixel_t rgb = {{bytes[red], bytes[1], bytes[2U - red]}};

    return ocel_pixel_in_hsv(lo, hi, &rgb);
}

void ocel_row24_decide_hsv(const uint16_t lo[3], const uint16_t hi[3], uint32_t red,
                           const uint8_t *line, uint32_t pixels, uint32_t *row) {
    for (uint32_t x0 = 0U; x0 < pixels; x0 += 32U) { /* bound: OCEL_ROW_WORDS */
        uint32_t passed = row[x0 >> 5U];

        while (passed != 0U) { /* bound: 32 bits of a word */
            const uint32_t k = ocel_ctz32(passed);

            passed &= passed - 1U;
            if (!hsv_in(lo, hi, red, &line[PIXEL_BYTES * (x0 + k)])) {
                row[x0 >> 5U] &= ~(1U << k);
            }
        }
    }
}
