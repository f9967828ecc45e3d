/* SPDX-License-Identifier: MIT
 *
 * Lines of one and of two bytes a pixel.
 */
#include "row16.h"

#include <stdbool.h>
#include <stddef.h>

#include "lanes.h"

static inline void put(uint32_t *row, uint32_t x, uint32_t bits) {
    row[x >> 5U] |= bits << (x & 31U);
}

/* ---- RGB565 ---- */

/* Sixteen pixels, each two bytes. */
#define TABLE_GROUP 16U
#define TABLE_GROUP_BYTES 32U

/* A pixel's channels, apart in a word that holds it twice: green in bits 26..21,
 * red in 15..11, blue in 4..0.  Above each is a bit for what an addition carries. */
#define CHANNELS 0x07E0F81FU
#define CARRIES 0x08010020U

/* Bits that some pixel of a group has and bits that all have, two pixels (or
 * four) beside each other.  Of each channel the former are at least the group's
 * greatest value and the latter at most its least. */
typedef struct {
    ocel_word_t some;
    ocel_word_t all;
} shared_t;

static inline void share_four(shared_t *shared, const uint8_t *words) {
    const ocel_word_t a = ocel_load_word(words);
    const ocel_word_t b = ocel_load_word(&words[OCEL_WORD_BYTES]);
    const ocel_word_t c = ocel_load_word(&words[2U * OCEL_WORD_BYTES]);
    const ocel_word_t d = ocel_load_word(&words[3U * OCEL_WORD_BYTES]);

    shared->some |= a | b | c | d;
    shared->all &= a & b & c & d;
}

static inline shared_t share(const uint8_t *group) {
    shared_t shared = {0U, ~(ocel_word_t)0U};

    share_four(&shared, group);
#if OCEL_WORD_BITS == 64
    shared.some |= shared.some >> 32U;
    shared.all &= shared.all >> 32U;
#else
    share_four(&shared, &group[4U * OCEL_WORD_BYTES]);
#endif
    return shared;
}

static inline uint32_t halves_swapped(uint32_t word) {
    return (word << 16U) | (word >> 16U);
}

static inline uint32_t channels_of(uint32_t pixel) {
    return (pixel | (pixel << 16U)) & CHANNELS;
}

/* What is to be added to bits that some have, so that a channel carries when it is
 * at least the least in range; and what bits that all have are to be taken from, so
 * that it does not borrow when it is at most the greatest. */
typedef struct {
    uint32_t up;
    uint32_t down;
} extremes_t;

static inline extremes_t glance_of(const ocel_row16_table_t *table) {
    const extremes_t glance = {CARRIES - channels_of(table->least),
                               CARRIES + CHANNELS - channels_of(table->headroom)};

    return glance;
}

/* False when some channel of all pixels is below its least or above its greatest
 * value in range. */
static inline bool may_be_in(const extremes_t *glance, const uint8_t *group) {
    const shared_t shared = share(group);
    const uint32_t some = (uint32_t)shared.some;
    const uint32_t all = (uint32_t)shared.all;
    const uint32_t up = glance->up + ((some | halves_swapped(some)) & CHANNELS);
    const uint32_t down = glance->down - ((all & halves_swapped(all)) & CHANNELS);

    return (up & down & CARRIES) == CARRIES;
}

/* The bits of two pixels, put under those of the pixels after them. */
static inline uint32_t table_bits_of_two(const uint32_t *word, uint32_t two, uint32_t after) {
    const uint32_t second = word[two >> 21U] >> ((two >> 16U) & 31U);
    const uint32_t first = word[(two >> 5U) & 0x7FFU] >> (two & 31U);
    const uint32_t bits = (after << 1U) | (second & 1U);

    return (bits << 1U) | (first & 1U);
}

/* The bits of a group, the last pixels first. */
static inline uint32_t table_bits(const uint32_t *word, const uint8_t *group) {
    uint32_t bits = 0U;

    for (uint32_t at = TABLE_GROUP_BYTES; at > 0U; at -= 8U) { /* bound: TABLE_GROUP / 4 */
        bits = table_bits_of_two(word, ocel_load32(&group[at - 4U]), bits);
        bits = table_bits_of_two(word, ocel_load32(&group[at - 8U]), bits);
    }
    return bits;
}

static inline uint32_t table_words_of_two(const uint32_t *word, uint32_t two) {
    return word[two >> 21U] | word[(two >> 5U) & 0x7FFU];
}

/* What the table has for all blues, beside the red and green of each pixel of a group. */
static inline uint32_t table_words(const uint32_t *word, const uint8_t *group) {
    uint32_t words = table_words_of_two(word, ocel_load32(group));

    for (uint32_t at = 4U; at < TABLE_GROUP_BYTES; at += 4U) { /* bound: TABLE_GROUP / 2 - 1 */
        words |= table_words_of_two(word, ocel_load32(&group[at]));
    }
    return words;
}

/* What a row's walk goes by; `group` is where it stands. */
typedef struct {
    const uint32_t *word;
    const uint8_t *line;
    const uint8_t *end;
    uint32_t *row;
} walk_t;

/* The bits of a group, which go into the row. */
static inline uint32_t look_up(const walk_t *walk, const uint8_t *group) {
    const uint32_t bits = table_bits(walk->word, group);

    put(walk->row, (uint32_t)(group - walk->line) / 2U, bits);
    return bits;
}

/* Past the groups whose words in the table say that they have no pixel in range.
 *
 * Looks are groups that are glanced at and groups whose words are asked.  One whose words
 * do not tell is both; so are at most half of the groups, as each of these but the last
 * follows one that the words went past, and the first one that was looked up in vain. */
static inline const uint8_t *skip_by_words(const walk_t *walk, const uint8_t *from) {
    const uint8_t *group = from;
    bool none = true;

    /* bound: OCEL_MAX_WIDTH / TABLE_GROUP; 1 each time in a call of do_tail;
     * OCEL_MAX_WIDTH / TABLE_GROUP in a call of ocel_row16_table;
     * 3 * OCEL_MAX_WIDTH / TABLE_GROUP / 2 as looks in a call of ocel_row16_table */
    while (none && (group != walk->end)) {
        none = table_words(walk->word, group) == 0U;
        group = none ? &group[TABLE_GROUP_BYTES] : group;
    }
    return group;
}

/* Most of a background is too dark, too bright or too much of one channel all over
 * a group: a glance at the group's bits together takes a third of what looking all up
 * takes.  Where it varies too much for that, and a group was looked up in vain, the reds and
 * greens often tell that no blue is in range; when they do not, they are not asked again in
 * this row. */
void ocel_row16_table(const ocel_row16_table_t *table, const uint8_t *line, uint32_t pixels,
                      uint32_t *row) {
    const walk_t walk = {table->word, line, &line[2U * pixels], row};
    const extremes_t glance = glance_of(table);
    const uint8_t *group = line;
    bool words_tell = true;

    /* bound: OCEL_MAX_WIDTH / TABLE_GROUP; 1 each time in a call of do_tail;
     * 3 * OCEL_MAX_WIDTH / TABLE_GROUP / 2 as looks in a call of ocel_row16_table */
    while (group != walk.end) {
        const bool in_vain = may_be_in(&glance, group) && (look_up(&walk, group) == 0U);

        group = &group[TABLE_GROUP_BYTES];
        if (in_vain && words_tell) {
            const uint8_t *const asked = group;

            group = skip_by_words(&walk, asked);
            words_tell = group != asked;
        }
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

void ocel_row16_yuyv(const uint32_t lanes[][4], const uint8_t *line, uint32_t pixels,
                     uint32_t *row) {
    const ocel_lane_range_t y = ocel_lane_range(lanes[0]);
    const ocel_lane_range_t uv = ocel_lane_range(lanes[1]);
    const uint8_t *group = line;

    /* bound: OCEL_MAX_WIDTH / OCEL_GROUP; 16 / OCEL_GROUP each time in a call of do_tail */
    for (uint32_t x = 0U; x < pixels; x += OCEL_GROUP) {
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

    /* bound: OCEL_MAX_WIDTH / OCEL_GROUP; 16 / OCEL_GROUP each time in a call of do_tail */
    for (uint32_t x = 0U; x < pixels; x += OCEL_GROUP) {
        const ocel_word_t bytes = ocel_load_word(&line[x]);
        const ocel_word_t half = (bytes >> 1U) & OCEL_LOW_SEVEN;

        if ((ocel_lanes_may_be_in(half, &range) & OCEL_TOP_BITS) != 0U) {
            put(row, x, ocel_gather(ocel_lanes_in(bytes, &range), OCEL_ORDER_PLAIN));
        }
    }
}
