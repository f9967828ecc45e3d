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

#include "lanes.h"

#define PIXEL_BYTES 3U

/* Where in the three words of a group the bytes of one channel stand. */
typedef struct {
    ocel_word_t mask[3];
} plane_t;

/* The bytes of a word whose index is 0, 1 or 2 modulo 3; and their order for a
 * channel: byte 0 of word k is byte k OCEL_GROUP of the group, which modulo 3 is
 * 2k for groups of eight and k for groups of four. */
#if OCEL_WORD_BITS == 64
#define THIRDS_0 UINT64_C(0x00FF0000FF0000FF)
#define THIRDS_1 UINT64_C(0xFF0000FF0000FF00)
#define THIRDS_2 UINT64_C(0x0000FF0000FF0000)
static const plane_t plane_at[3] = {{{THIRDS_0, THIRDS_1, THIRDS_2}},
                                    {{THIRDS_1, THIRDS_2, THIRDS_0}},
                                    {{THIRDS_2, THIRDS_0, THIRDS_1}}};
#else
#define THIRDS_0 0xFF0000FFU
#define THIRDS_1 0x0000FF00U
#define THIRDS_2 0x00FF0000U
static const plane_t plane_at[3] = {{{THIRDS_0, THIRDS_2, THIRDS_1}},
                                    {{THIRDS_1, THIRDS_0, THIRDS_2}},
                                    {{THIRDS_2, THIRDS_1, THIRDS_0}}};
#endif

static inline ocel_word_t take(const plane_t *plane, const uint8_t *group) {
    return (ocel_load_word(group) & plane->mask[0]) |
           (ocel_load_word(&group[OCEL_WORD_BYTES]) & plane->mask[1]) |
           (ocel_load_word(&group[2U * OCEL_WORD_BYTES]) & plane->mask[2]);
}

typedef struct {
    plane_t plane;
    uint32_t rotation; /* bits, to OCEL_ORDER_BY_THREES */
    ocel_lane_range_t range;
} channel_test_t;

static inline channel_test_t channel_test(const uint32_t lanes[4], uint32_t at) {
    const channel_test_t test = {plane_at[at], 8U * at, ocel_lane_range(lanes)};

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

static inline glance_t glance_at(const uint32_t lanes[4], uint32_t at) {
    const plane_t *const plane = &plane_at[at];
    const glance_t first = {{{plane->mask[0] & ~OCEL_LOW_BITS, plane->mask[1] & ~OCEL_LOW_BITS,
                              plane->mask[2] & ~OCEL_LOW_BITS}},
                            ocel_lane_range(lanes)};

    return first;
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
static void box_from(const glance_t *first, const uint32_t lanes[3][4], const uint8_t at[3],
                     const uint8_t *line, uint32_t x0, uint32_t pixels, uint32_t *row) {
    const channel_test_t test0 = channel_test(lanes[0], at[0]);
    const channel_test_t test1 = channel_test(lanes[1], at[1]);
    const channel_test_t test2 = channel_test(lanes[2], at[2]);
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
            row[x >> 5U] |= ocel_gather(in, OCEL_ORDER_BY_THREES) << (x & 31U);
        }
        group = &group[PIXEL_BYTES * OCEL_GROUP];
    }
}

void ocel_row24_box(const uint32_t lanes[3][4], const uint8_t at[3], const uint8_t *line,
                    uint32_t pixels, uint32_t *row) {
    const glance_t first = glance_at(lanes[0], at[0]);
    const uint32_t x = look_on(&first, line, pixels);

    if (x < pixels) {
        box_from(&first, lanes, at, line, x, pixels, row);
    }
}
