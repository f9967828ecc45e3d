/* SPDX-License-Identifier: MIT
 *
 * The machine's word: as wide as its registers, 64 bits or 32.  What is computed
 * with it is the same either way.
 */
#ifndef OCEL_WORD_H
#define OCEL_WORD_H

#include <stdint.h>

/* OCEL_WORD_BITS may be set for a test of the other width. */
#ifndef OCEL_WORD_BITS
#if UINTPTR_MAX > 0xFFFFFFFFU
#define OCEL_WORD_BITS 64
#else
#define OCEL_WORD_BITS 32
#endif
#endif

#if OCEL_WORD_BITS == 64
typedef uint64_t ocel_word_t;
#else
typedef uint32_t ocel_word_t;
#endif

#endif
