/* SPDX-License-Identifier: MIT
 *
 * Lines of one and of two bytes a pixel.
 */
#include "row16.h"

#include "int_math.h"
#include "lanes.h"
#include "pixel.h"

static inline void put(uint32_t *row, uint32_t x, uint32_t bits) {
    row[x >> 5U] |= bits << (x & 31U);
}

/* ---- RGB565 ---- */

/* Eight pixels, two a load. */
#define TABLE_GROUP 8U

/* The table word of the first and of the second of two pixels. */
static inline uint32_t either_word(const uint32_t *table, uint32_t two) {
    return table[(two >> 5U) & 0x7FFU] | table[two >> 21U];
}

static inline uint32_t table_bit(const uint32_t *table, uint32_t p) {
    return (table[p >> 5U] >> (p & 31U)) & 1U;
}

static uint32_t table_bits(const uint32_t *table, const uint8_t *group) {
    uint32_t bits = 0U;

    for (uint32_t k = 0U; k < TABLE_GROUP; k += 2U) { /* bound: TABLE_GROUP */
        const uint32_t two = ocel_load32(&group[2U * k]);

        bits |= (table_bit(table, two & 0xFFFFU) | (table_bit(table, two >> 16U) << 1U)) << k;
    }
    return bits;
}

/* A table word holds all blues of one red and green, so most of a background
 * has words of zeros: eight of them or-ed decide eight pixels. */
void ocel_row16_table(const uint32_t table[2048], const uint8_t *line, uint32_t pixels,
                      uint32_t *row) {
    const uint8_t *group = line;

    for (uint32_t x = 0U; x < pixels; x += TABLE_GROUP) { /* bound: OCEL_MAX_WIDTH / TABLE_GROUP */
        const uint32_t any = either_word(table, ocel_load32(group)) |
                             either_word(table, ocel_load32(&group[4])) |
                             either_word(table, ocel_load32(&group[8])) |
                             either_word(table, ocel_load32(&group[12]));

        if (any != 0U) {
            put(row, x, table_bits(table, group));
        }
        group = &group[2U * TABLE_GROUP];
    }
}

/* ---- YUYV ----
 *
 * A group is two words.  The even bytes of both make a word of Y, in
 * OCEL_ORDER_EVEN_ODD; the odd bytes a word in which U and V take turns by
 * twos: each U of the first word beside the U of the second, then their V's. */

#define U_OF_UV OCEL_PATTERN(0x0000FFFF0000FFFF)

static inline ocel_word_t take_even(const uint8_t *group) {
    return (ocel_load_word(group) & OCEL_EVEN_BYTES) |
           ((ocel_load_word(&group[OCEL_WORD_BYTES]) & OCEL_EVEN_BYTES) << 8U);
}

static inline ocel_word_t take_odd(const uint8_t *group) {
    return ((ocel_load_word(group) >> 8U) & OCEL_EVEN_BYTES) |
           (ocel_load_word(&group[OCEL_WORD_BYTES]) & ~OCEL_EVEN_BYTES);
}

/* Of the answers for U and V, both: where the U stands. */
static inline ocel_word_t both(ocel_word_t uv) {
    return uv & (uv >> 16U) & U_OF_UV & OCEL_TOP_BITS;
}

static ocel_word_t mix(ocel_word_t u, ocel_word_t v) {
    return (u & U_OF_UV) | (v & ~U_OF_UV);
}

static ocel_lane_range_t mixed_range(const ocel_lane_range_t *u, const ocel_lane_range_t *v) {
    const ocel_lane_range_t range = {mix(u->begin, v->begin), mix(u->end, v->end),
                                     mix(u->begin_odd, v->begin_odd), mix(u->end_odd, v->end_odd)};

    return range;
}

void ocel_row16_yuyv(const uint16_t begin[3], const uint16_t end[3], const uint8_t *line,
                     uint32_t pixels, uint32_t *row) {
    const ocel_lane_range_t y = ocel_lane_range(begin[0], end[0]);
    const ocel_lane_range_t u = ocel_lane_range(begin[1], end[1]);
    const ocel_lane_range_t v = ocel_lane_range(begin[2], end[2]);
    const ocel_lane_range_t uv = mixed_range(&u, &v);
    const uint8_t *group = line;

    for (uint32_t x = 0U; x < pixels; x += OCEL_GROUP) { /* bound: OCEL_MAX_WIDTH / OCEL_GROUP */
        const ocel_word_t odd = take_odd(group);
        const ocel_word_t half = (odd >> 1U) & OCEL_LOW_SEVEN;

        if (both(ocel_lanes_may_be_in(half, &uv)) != 0U) {
            const ocel_word_t at_u = both(ocel_lanes_in(odd, &uv));
            const ocel_word_t in = (at_u | (at_u << 16U)) & ocel_lanes_in(take_even(group), &y);

            put(row, x, ocel_gather(in, OCEL_ORDER_EVEN_ODD));
        }
        group = &group[2U * OCEL_GROUP];
    }
}

static bool yuyv_in(const uint16_t lo[3], const uint16_t hi[3], bool hsv, const uint8_t *pair,
                    uint32_t second) {
    const ocel_pixel_t yuv = {{pair[2U * second], pair[1], pair[3]}};
    const ocel_pixel_t rgb = ocel_pixel_from_yuv(&yuv);

    return hsv ? ocel_pixel_in_hsv(lo, hi, &rgb) : ocel_pixel_in_box(lo, hi, &rgb);
}

void ocel_row16_decide_yuyv(const uint16_t lo[3], const uint16_t hi[3], bool hsv,
                            const uint8_t *line, uint32_t pixels, uint32_t *row) {
    for (uint32_t x0 = 0U; x0 < pixels; x0 += 32U) { /* bound: OCEL_ROW_WORDS */
        uint32_t passed = row[x0 >> 5U];

        while (passed != 0U) { /* bound: 32 bits of a word */
            const uint32_t k = ocel_ctz32(passed);
            const uint32_t pair = (x0 + k) >> 1U;

            passed &= passed - 1U;
            if (!yuyv_in(lo, hi, hsv, &line[4U * pair], k & 1U)) {
                row[x0 >> 5U] &= ~(1U << k);
            }
        }
    }
}

/* ---- GRAY8 ---- */

void ocel_row8_gray(uint32_t begin, uint32_t end, const uint8_t *line, uint32_t pixels,
                    uint32_t *row) {
    const ocel_lane_range_t range = ocel_lane_range(begin, end);

    for (uint32_t x = 0U; x < pixels; x += OCEL_GROUP) { /* bound: OCEL_MAX_WIDTH / OCEL_GROUP */
        const ocel_word_t lanes = ocel_load_word(&line[x]);
        const ocel_word_t half = (lanes >> 1U) & OCEL_LOW_SEVEN;

        if ((ocel_lanes_may_be_in(half, &range) & OCEL_TOP_BITS) != 0U) {
            put(row, x, ocel_gather(ocel_lanes_in(lanes, &range), OCEL_ORDER_PLAIN));
        }
    }
}
