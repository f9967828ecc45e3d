/* SPDX-License-Identifier: MIT
 *
 * Fixed point with 60 fraction bits, 2^60 = 1.0, for the solve: products,
 * reciprocals and square roots without 128-bit types and without division.
 */
#ifndef OCEL_Q60_H
#define OCEL_Q60_H

#include <stdint.h>

#include "int_math.h"

#define OCEL_Q60_ONE ((int64_t)0x1000000000000000)

/* floor(a * b / 2^60), exactly.  |a|, |b| < 2^61; the result's magnitude is at
 * most 2^62.  Two ways that give the same bits (a test holds them together): a
 * processor with 64-bit products takes one, a 32-bit one takes four 32x32->64.
 *
 * With a = ah 2^30 + al, 0 <= al < 2^30, -2^31 <= ah < 2^31, and b alike:
 *   a b = ah bh 2^60 + (ah bl + al bh) 2^30 + al bl,
 * and floor((x 2^30 + al bl) / 2^60) = floor((x + floor(al bl / 2^30)) / 2^30).
 * Nothing overflows: |ah bl + al bh| < 2 * 2^61 = 2^62, |ah bh| <= 2^62. */
int64_t ocel_mul_q60_by_parts(int64_t a, int64_t b);

#if defined(__SIZEOF_INT128__)
static inline int64_t ocel_mul_q60(int64_t a, int64_t b) {
    return (int64_t)(((ocel_int128_t)a * b) >> 60);
}
#else
static inline int64_t ocel_mul_q60(int64_t a, int64_t b) {
    return ocel_mul_q60_by_parts(a, b);
}
#endif

/* 1 / sqrt(p / 2^60) = (y_q60 / 2^60) * 2^e.  p >= 1, any 64-bit value.
 * y_q60 is in [2^59, 2^60] (1/2 to 1), e in -1..30; the relative error is
 * below 2^-57.  p = 0 gives y_q60 = 0 and e = 0: no reciprocal. */
void ocel_rsqrt_q60(uint64_t p, int64_t *y_q60, int32_t *e);

/* 1 / (p / 2^60) = (y_q60 / 2^60) * 2^e.  p >= 1, any 64-bit value.
 * y_q60 is in [2^59, 2^60], e in -3..60; the relative error is below 2^-58.
 * p = 0 gives y_q60 = 0 and e = 0. */
void ocel_recip_q60(uint64_t p, int64_t *y_q60, int32_t *e);

/* The short one: 1 / (p / 2^60) = (y_q31 / 2^31) * 2^e, with y_q31 in
 * [2^30, 2^31] and the relative error below 2^-29.  p = 0 gives 0, 0. */
void ocel_recip_short(uint64_t p, uint32_t *y_q31, int32_t *e);

/* sqrt(p / 2^60) in Q60.  p < 2^62; the result is below 2^61.  Error: below
 * 2^-57 of the result, plus half an LSB. */
int64_t ocel_sqrt_q60(uint64_t p);

#endif
