/* SPDX-License-Identifier: MIT
 *
 * Specks: holes of one pixel and components of one pixel, found as bits.
 *
 * A 4-connected object has an 8-connected background, so a mask's isolated
 * pixels are the holes of its complement under the other connectivity.  What is
 * called set here is the object, 8-connected, or the background of one that is
 * 4-connected: either way, what is set is isolated when none of its eight
 * neighbours is set, and what is clear when all of its four are.
 */
#include "specks.h"

#include <stddef.h>

#include "../base/word.h"
#include "run.h"
#include "sweep.h"

/* The highest bit of a machine word. */
#define TOP_BIT ((uint32_t)OCEL_WORD_BITS - 1U)

/* Bits of a row with those beside them. */
typedef struct {
    ocel_word_t at;
    ocel_word_t left; /* bit x is pixel x - 1 */
    ocel_word_t right;
} beside_t;

static inline beside_t beside(uint32_t before, ocel_word_t at, uint32_t after) {
    const beside_t bits = {at, (at << 1U) | (before >> 31U),
                           (at >> 1U) | ((ocel_word_t)after << TOP_BIT)};

    return bits;
}

/* invert: all bits when what is clear in the rows is called set, else none. */
static inline ocel_word_t specks(const uint32_t *above, const uint32_t *held, const uint32_t *below,
                                 ocel_word_t invert) {
    const uint32_t inv = (uint32_t)invert;
    const ocel_word_t up = ocel_run_load(above) ^ invert;
    const ocel_word_t down = ocel_run_load(below) ^ invert;
    const beside_t mid =
        beside(held[-1] ^ inv, ocel_run_load(held) ^ invert, held[OCEL_RUN_WORDS] ^ inv);
    const beside_t either = beside((above[-1] ^ inv) | (below[-1] ^ inv), up | down,
                                   (above[OCEL_RUN_WORDS] ^ inv) | (below[OCEL_RUN_WORDS] ^ inv));
    const ocel_word_t some = either.at | either.left | either.right | mid.left | mid.right;
    const ocel_word_t all = up & down & mid.left & mid.right;

    return (mid.at & ~some) | (~mid.at & all);
}

static inline uint32_t count_bits(ocel_word_t bits) {
    uint32_t count = 0U;

    /* bound: OCEL_WORD_BITS; OCEL_MAX_RUNS in a call of ocel_specks_sweep */
    for (ocel_word_t rest = bits; rest != 0U; rest &= rest - 1U) {
        count++;
    }
    return count;
}

static inline uint32_t smaller_word(uint32_t a, uint32_t b) {
    return (a < b) ? a : b;
}

static inline uint32_t larger_word(uint32_t a, uint32_t b) {
    return (a > b) ? a : b;
}

/* Where neither the row held nor the one above has a pixel nothing changes. */
void ocel_specks_sweep(ocel_labeller_t *lab, ocel_crack_pool_t *pool) {
    const ocel_bit_row_t *const above_row = &lab->rows[lab->above];
    ocel_bit_row_t *const held_row = &lab->rows[ocel_specks_row(lab, 1U)];
    const uint32_t *const above = &above_row->word[1];
    uint32_t *const held = &held_row->word[1];
    const uint32_t *const below = &lab->rows[ocel_specks_row(lab, 2U)].word[1];
    const ocel_word_t invert = (ocel_word_t)lab->reach - 1U;
    const uint32_t first = smaller_word(held_row->first, above_row->first);
    const uint32_t end = larger_word(held_row->end, above_row->end);
    const ocel_word_t no_singles = (lab->best.area == 0U) ? ~(ocel_word_t)0U : 0U;
    ocel_ended_t nobody = {NULL, 0U};
    uint32_t holes[OCEL_ROW_WORDS + 1];
    ocel_word_t changes = 0U;
    uint32_t filled = 0U;
    uint32_t singles = 0U;

    for (uint32_t k = first; k < end; k += OCEL_RUN_WORDS) { /* bound: OCEL_ROW_WORDS */
        const ocel_word_t up = ocel_run_load(&above[k]);
        const ocel_word_t bits = ocel_run_load(&held[k]);
        ocel_word_t flips = 0U;

        if (((bits ^ up) & (bits ^ ocel_run_load(&below[k]))) != 0U) {
            flips = specks(&above[k], &held[k], &below[k], invert);
            flips &= ~(bits & no_singles);
            filled += count_bits(flips & ~bits);
            singles += count_bits(flips & bits);
            ocel_run_store(&held[k], bits ^ flips);
        }
        changes |= bits ^ flips ^ up;
        ocel_run_store(&holes[k], flips & ~bits);
    }
    holes[end] = 1U;
    lab->stats.runs += filled + singles;
    lab->stats.components += singles;
    lab->above = (uint16_t)ocel_specks_row(lab, 1U);
    if ((changes == 0U) && (filled == 0U)) {
        ocel_sweep_repeat(lab, pool);
    } else {
        /* at most: 1; OCEL_MAX_HEIGHT as rows in a call of ocel_eye_frame */
        ocel_sweep_row(lab, pool, (filled != 0U) ? &holes[held_row->first] : NULL, &nobody);
    }
}
