/* SPDX-License-Identifier: MIT
 *
 * Rows of bits: their emptiness, their way into the labeller, and a machine word
 * of them at a time.
 */
#ifndef OCEL_RUN_H
#define OCEL_RUN_H

#include <stdbool.h>
#include <stdint.h>

#include <ocellus/labeller.h>

#include "../base/int_math.h"
#include "../base/word.h"

/* Words of a row in a machine word. */
#define OCEL_RUN_WORDS ((uint32_t)OCEL_WORD_BITS / 32U)

static inline ocel_word_t ocel_run_load(const uint32_t *word) {
#if OCEL_WORD_BITS == 64
    return word[0] | ((uint64_t)word[1] << 32U);
#else
    return word[0];
#endif
}

static inline void ocel_run_store(uint32_t *word, ocel_word_t bits) {
    word[0] = (uint32_t)bits;
#if OCEL_WORD_BITS == 64
    word[1] = (uint32_t)(bits >> 32U);
#endif
}

/* Index of the lowest bit of a word that is not 0.  On the builtins see
 * int_math.h. */
static inline uint32_t ocel_run_lowest(ocel_word_t bits) {
#if OCEL_WORD_BITS == 32
    return ocel_ctz32(bits);
#elif OCEL_PORTABLE_BITS
    return 63U - ocel_clz64(bits & (0U - bits));
#else
    return (uint32_t)__builtin_ctzll(bits);
#endif
}

/* Words of a row of `width` pixels, and which bits of the last one are pixels. */
static inline uint32_t ocel_run_words(uint32_t width) {
    return (width + 31U) >> 5U;
}

static inline uint32_t ocel_run_last_mask(uint32_t width) {
    return 0xFFFFFFFFU >> ((0U - width) & 31U);
}

/* Copies a row of `width` pixels, width >= 1; the margins stay as they are.
 * Returns 0 when no pixel is set. */
static inline ocel_word_t ocel_run_copy(ocel_bit_row_t *to, const uint32_t *row, uint32_t width) {
    const uint32_t last = ocel_run_words(width) - 1U;
    ocel_word_t any = row[last] & ocel_run_last_mask(width);
    uint32_t k = 0U;

    to->word[last + 1U] = (uint32_t)any;
    while ((k + OCEL_RUN_WORDS) <= last) { /* bound: OCEL_ROW_WORDS */
        const ocel_word_t bits = ocel_run_load(&row[k]);

        ocel_run_store(&to->word[k + 1U], bits);
        any |= bits;
        k += OCEL_RUN_WORDS;
    }
#if OCEL_WORD_BITS == 64
    if (k < last) {
        to->word[k + 1U] = row[k];
        any |= row[k];
    }
#endif
    return any;
}

#endif
