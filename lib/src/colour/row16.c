/* SPDX-License-Identifier: MIT
 *
 * Lines of one and of two bytes a pixel.
 */
#include "row16.h"

#include "lanes.h"

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

#define U_OF_UV OCEL_REPEATED(0x0000FFFFU)

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

void ocel_row16_yuyv(const uint32_t lanes[3][4], const uint8_t *line, uint32_t pixels,
                     uint32_t *row) {
    const ocel_lane_range_t y = ocel_lane_range(lanes[0]);
    const ocel_lane_range_t uv = ocel_lane_range(lanes[1]);
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

/* ---- GRAY8 ---- */

void ocel_row8_gray(const uint32_t lanes[4], const uint8_t *line, uint32_t pixels, uint32_t *row) {
    const ocel_lane_range_t range = ocel_lane_range(lanes);

    for (uint32_t x = 0U; x < pixels; x += OCEL_GROUP) { /* bound: OCEL_MAX_WIDTH / OCEL_GROUP */
        const ocel_word_t bytes = ocel_load_word(&line[x]);
        const ocel_word_t half = (bytes >> 1U) & OCEL_LOW_SEVEN;

        if ((ocel_lanes_may_be_in(half, &range) & OCEL_TOP_BITS) != 0U) {
            put(row, x, ocel_gather(ocel_lanes_in(bytes, &range), OCEL_ORDER_PLAIN));
        }
    }
}
