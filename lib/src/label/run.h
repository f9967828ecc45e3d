/* SPDX-License-Identifier: MIT
 *
 * Rows of bits: their way into the labeller, and a machine word of them at a time.
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

/* How many words of a row of `width` pixels, width >= 1, come before the first with
 * a pixel, or some fewer; ocel_run_words(width) when no pixel is set. */
static inline uint32_t ocel_run_first(const uint32_t *row, uint32_t width) {
    const uint32_t last = ocel_run_words(width) - 1U;
    uint32_t k = 0U;

    /* bound: OCEL_ROW_WORDS */
    while (((k + (OCEL_RUN_WORDS - 1U)) < last) && (ocel_run_load(&row[k]) == 0U)) {
        k += OCEL_RUN_WORDS;
    }
#if OCEL_WORD_BITS == 64
    if ((k < last) && (row[k] == 0U)) {
        k++;
    }
#endif
    if ((k == last) && ((row[last] & ocel_run_last_mask(width)) == 0U)) {
        k++;
    }
    return k;
}

/* Copies a row of `width` pixels that has one, the first in word `first` or later; the
 * margins stay as they are. */
static inline void ocel_run_copy(ocel_bit_row_t *to, const uint32_t *row, uint32_t width,
                                 uint32_t first) {
    const uint32_t words = ocel_run_words(width);
    uint32_t *const word = &to->word[1];
    uint32_t end = words;
    uint32_t k = 0U;

    while ((k + OCEL_RUN_WORDS) <= words) { /* bound: OCEL_ROW_WORDS */
        ocel_run_store(&word[k], ocel_run_load(&row[k]));
        k += OCEL_RUN_WORDS;
    }
#if OCEL_WORD_BITS == 64
    if (k < words) {
        word[k] = row[k];
    }
#endif
    word[words - 1U] &= ocel_run_last_mask(width);
    while (word[end - 1U] == 0U) { /* bound: OCEL_ROW_WORDS */
        end--;
    }
    to->first = (uint16_t)first;
    to->end = (uint16_t)end;
}

#endif
