/* SPDX-License-Identifier: MIT
 *
 * Numbers with an exponent of their own, for what has no natural scale: the
 * inverse of a pivot, the residual of a perfect fit.
 */
#ifndef OCELLUS_SCALE_H
#define OCELLUS_SCALE_H

#include <stdint.h>

#include "int_math.h"

/* A number y * 2^e, y in Q60. */
typedef struct {
    int64_t y_q60;
    int32_t e;
} ocel_scaled_t;

/* value * 2^e, -62 <= e <= 62, rounded to nearest when e < 0.  The caller
 * bounds |value| * 2^e below 2^63.
 *
 * The right shift is by one less, then by one with its rounding:
 * floor((floor(v / 2^(n-1)) + 1) / 2), which is floor(v / 2^n + 1/2), by one shift that
 * varies. */
static inline int64_t ocel_scale_here(int64_t value, int32_t e) {
    return (e >= 0) ? ocel_shl64(value, (uint32_t)e)
                    : ocel_asr64(ocel_asr64(value, (uint32_t)(-1 - e)) + 1, 1U);
}

/* A call and not inline where registers have 32 bits: there a 64-bit shift by a variable
 * is some twenty instructions, and the fit has forty of them. */
#if OCEL_WORD_BITS == 64
static inline int64_t ocel_scale_q60(int64_t value, int32_t e) {
    return ocel_scale_here(value, e);
}
#else
int64_t ocel_scale_q60(int64_t value, int32_t e);
#endif

#endif
