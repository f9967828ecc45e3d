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
#include <string.h>

#include "lanes.h"

#define PIXEL_BYTES 3U

/* Where in the three words of a group the bytes of one channel stand. */
typedef struct {
    ocel_word_t mask[3];
} byte_plane_t;

/* The bytes of a word whose index is 0, 1 or 2 modulo 3; and their order for a
 * channel: byte 0 of word k is byte k OCEL_GROUP of the group, which modulo 3 is
 * 2k for groups of eight and k for groups of four. */
#if OCEL_WORD_BITS == 64
#define THIRDS_0 UINT64_C(0x00FF0000FF0000FF)
#define THIRDS_1 UINT64_C(0xFF0000FF0000FF00)
#define THIRDS_2 UINT64_C(0x0000FF0000FF0000)
static const byte_plane_t plane_at[3] = {{{THIRDS_0, THIRDS_1, THIRDS_2}},
                                         {{THIRDS_1, THIRDS_2, THIRDS_0}},
                                         {{THIRDS_2, THIRDS_0, THIRDS_1}}};
#else
#define THIRDS_0 0xFF0000FFU
#define THIRDS_1 0x0000FF00U
#define THIRDS_2 0x00FF0000U
static const byte_plane_t plane_at[3] = {{{THIRDS_0, THIRDS_2, THIRDS_1}},
                                         {{THIRDS_1, THIRDS_0, THIRDS_2}},
                                         {{THIRDS_2, THIRDS_1, THIRDS_0}}};
#endif

static inline ocel_word_t take(const byte_plane_t *plane, const uint8_t *group) {
    return (ocel_load_word(group) & plane->mask[0]) |
           (ocel_load_word(&group[OCEL_WORD_BYTES]) & plane->mask[1]) |
           (ocel_load_word(&group[2U * OCEL_WORD_BYTES]) & plane->mask[2]);
}

/* The upper seven bits of one channel: what most groups are rejected by, so it
 * is the whole of the inner loop and has no more than it needs. */
typedef struct {
    byte_plane_t upper;
    ocel_lane_range_t range;
} glance_t;

static inline glance_t glance_at(const uint32_t lanes[4], uint32_t at) {
    const byte_plane_t *const plane = &plane_at[at];
    const glance_t first = {{{plane->mask[0] & ~OCEL_LOW_BITS, plane->mask[1] & ~OCEL_LOW_BITS,
                              plane->mask[2] & ~OCEL_LOW_BITS}},
                            ocel_lane_range(lanes)};

    return first;
}

static inline ocel_word_t glance(const glance_t *first, const uint8_t *group) {
    return ocel_lanes_may_be_in(take(&first->upper, group) >> 1U, &first->range);
}

/* Of a pair of groups: 0 when no pixel is in range. */
static inline ocel_word_t glance_pair(const glance_t *first, const uint8_t *pair) {
    return (glance(first, pair) | glance(first, &pair[PIXEL_BYTES * OCEL_GROUP])) & OCEL_TOP_BITS;
}

/* Pixels up to the first pair of groups in which a glance is not enough; without
 * any, up to the end of the last pair. */
static inline uint32_t look_on(const glance_t *first, const uint8_t *line, uint32_t pixels) {
    const uint32_t pairs = pixels / (2U * OCEL_GROUP);
    const uint8_t *group = line;
    uint32_t left = pairs;

    /* bound: OCEL_MAX_WIDTH / (2 * OCEL_GROUP); 8 / OCEL_GROUP each time in a call of do_tail */
    while (left > 0U) {
        if (glance_pair(first, group) != 0U) {
            break;
        }
        group = &group[2U * PIXEL_BYTES * OCEL_GROUP];
        left--;
    }
    return 2U * OCEL_GROUP * (pairs - left);
}

#if OCEL_WORD_BITS == 64

/* ---- The whole test, byte by byte ----
 *
 * These loops are for the compiler to make vectors of: a fixed number of trips,
 * nothing that depends on the trip before, no two arrays that may overlap. */

/* Pixels that are tested at once: two groups. */
#define BLOCK (2U * OCEL_GROUP)
#define BLOCK_BYTES (PIXEL_BYTES * BLOCK)

/* Bytes of a vector: a third of a block's. */
#define VECTOR BLOCK

/* A block's bounds: a byte v is in range when v - lo, modulo 256, is at most
 * span. */
typedef struct {
    uint8_t lo[BLOCK_BYTES];
    uint8_t span[BLOCK_BYTES];
} block_range_t;

/* Repeats the first pixel's three bytes over the block, by doubling. */
static inline void repeat_pixel(uint8_t bytes[BLOCK_BYTES]) {
    (void)memcpy(&bytes[3], bytes, 3U);
    (void)memcpy(&bytes[6], bytes, 6U);
    (void)memcpy(&bytes[12], bytes, 12U);
    (void)memcpy(&bytes[24], bytes, 24U);
}

/* One end of a half-open range (lanes.h) back from the lanes: 0 .. 256. */
static inline uint32_t lane_end(uint32_t lane, uint32_t odd) {
    return (2U * (128U - (lane & 0xFFU))) - (odd & 1U);
}

/* Returns false when a range is empty, and so no pixel is in all. */
static inline bool block_range(block_range_t *range, const uint32_t lanes[3][4],
                               const uint8_t at[3]) {
    bool any = true;

    for (uint32_t k = 0U; k < PIXEL_BYTES; k++) { /* bound: PIXEL_BYTES */
        const uint32_t begin = lane_end(lanes[k][OCEL_LANES_BEGIN], lanes[k][OCEL_LANES_BEGIN_ODD]);
        const uint32_t end = lane_end(lanes[k][OCEL_LANES_END], lanes[k][OCEL_LANES_END_ODD]);

        any = any && (begin < end);
        range->lo[at[k]] = (uint8_t)begin;
        range->span[at[k]] = (uint8_t)(end - begin - 1U);
    }
    repeat_pixel(range->lo);
    repeat_pixel(range->span);
    return any;
}

/* The answers for a group of pixels, whose bytes are all[0], all[3] ... all[21]. */
static inline uint32_t gather_group(const uint8_t *all) {
    return ocel_gather(take(&plane_at[0], all), OCEL_ORDER_BY_THREES);
}

/* Tests VECTOR bytes: 255 when in range, else 0. */
static inline void test_bytes(const uint8_t *bytes, const uint8_t *lo, const uint8_t *span,
                              uint8_t *in) {
    for (uint32_t i = 0U; i < VECTOR; i++) { /* bound: VECTOR */
        const uint8_t above = (uint8_t)(bytes[i] - lo[i]);

        in[i] = (above <= span[i]) ? 255U : 0U;
    }
}

/* For VECTOR bytes: whether they and the two that follow are in range. */
static inline void join_bytes(const uint8_t *in, uint8_t *all) {
    for (uint32_t i = 0U; i < VECTOR; i++) { /* bound: VECTOR */
        all[i] = in[i] & in[i + 1U] & in[i + 2U];
    }
}

/* Tests a block: bit k says whether pixel k is in range. */
static inline uint32_t block_bits(const block_range_t *range, const uint8_t *block) {
    uint8_t in[BLOCK_BYTES + 2U];
    uint8_t all[BLOCK_BYTES];

    test_bytes(block, range->lo, range->span, in);
    test_bytes(&block[VECTOR], &range->lo[VECTOR], &range->span[VECTOR], &in[VECTOR]);
    test_bytes(&block[2U * VECTOR], &range->lo[2U * VECTOR], &range->span[2U * VECTOR],
               &in[2U * VECTOR]);
    in[BLOCK_BYTES] = 0U; /* read, but no pixel's first byte */
    in[BLOCK_BYTES + 1U] = 0U;
    join_bytes(in, all);
    join_bytes(&in[VECTOR], &all[VECTOR]);
    join_bytes(&in[2U * VECTOR], &all[2U * VECTOR]);
    return gather_group(all) |
           (gather_group(&all[PIXEL_BYTES * OCEL_GROUP]) << (uint32_t)OCEL_GROUP);
}

/* The rest of a line, from the first block at which a glance was not enough.
 * Where two pixels of a block were in range the next one is tested at once. */
static void box_from(const glance_t *first, const uint32_t lanes[3][4], const uint8_t at[3],
                     const uint8_t *line, uint32_t x0, uint32_t pixels, uint32_t *row) {
    block_range_t range;
    const uint8_t *block = &line[PIXEL_BYTES * x0];
    uint32_t bits = 0U;

    if (block_range(&range, lanes, at)) {
        for (uint32_t x = x0; x < pixels; x += BLOCK) { /* bound: OCEL_MAX_WIDTH / BLOCK */
            if (((bits & (bits - 1U)) != 0U) || (glance_pair(first, block) != 0U)) {
                bits = block_bits(&range, block);
                row[x >> 5U] |= bits << (x & 31U);
            } else {
                bits = 0U;
            }
            block = &block[BLOCK_BYTES];
        }
    }
}

#else

/* ---- The whole test, plane by plane ---- */

/* In the order of the bytes of plane 0. */
static inline ocel_word_t channel_in(const uint32_t lanes[4], uint32_t at, const uint8_t *group) {
    const ocel_lane_range_t range = ocel_lane_range(lanes);

    return ocel_lanes_in(ocel_rotate_right(take(&plane_at[at], group), 8U * at), &range);
}

/* The rest of a line, from the first group at which a glance was not enough.
 * Where begin and end are even a glance is exact. */
static void box_from(const glance_t *first, const uint32_t lanes[3][4], const uint8_t at[3],
                     const uint8_t *line, uint32_t x0, uint32_t pixels, uint32_t *row) {
    const bool exact = (first->range.begin_odd | first->range.end_odd) == 0U;
    const uint8_t *group = &line[PIXEL_BYTES * x0];

    /* bound: OCEL_MAX_WIDTH / OCEL_GROUP; 16 / OCEL_GROUP each time in a call of do_tail */
    for (uint32_t x = x0; x < pixels; x += OCEL_GROUP) {
        ocel_word_t in = glance(first, group) & OCEL_TOP_BITS;

        if (in != 0U) {
            in = ocel_rotate_right(in, 8U * at[0]);
            for (uint32_t k = exact ? 1U : 0U; k < 3U; k++) { /* bound: 3 channels */
                in &= channel_in(lanes[k], at[k], group);
            }
            row[x >> 5U] |= ocel_gather(in, OCEL_ORDER_BY_THREES) << (x & 31U);
        }
        group = &group[PIXEL_BYTES * OCEL_GROUP];
    }
}

#endif

void ocel_row24_box(const uint32_t lanes[][4], const uint8_t at[3], const uint8_t *line,
                    uint32_t pixels, uint32_t *row) {
    const glance_t first = glance_at(lanes[0], at[0]);
    const uint32_t x = look_on(&first, line, pixels);

    if (x < pixels) {
        box_from(&first, lanes, at, line, x, pixels, row);
    }
}
