/* SPDX-License-Identifier: MIT
 *
 * Microseconds to seconds, and products with them.
 */
#ifndef OCEL_SECONDS_H
#define OCEL_SECONDS_H

#include <stdint.h>

/* Fraction bits of seconds, and of the gains that they are multiplied with. */
#define OCEL_SECONDS_BITS 47

/* 2^47 / 10^6, to 3e-9 of it. */
#define OCEL_SECONDS_Q47_PER_US 140737488

/* Any dt_us; the result is below 2^60. */
static inline int64_t ocel_seconds_q47(uint32_t dt_us) {
    return (int64_t)dt_us * OCEL_SECONDS_Q47_PER_US;
}

/* a * b * 2^e, within +-2^60: what is larger becomes that.  |a|, |b| < 2^61,
 * -120 <= e <= 0.  Error: half an LSB, and what two LSB of b would make. */
int64_t ocel_times(int64_t a, int64_t b, int32_t e);

/* *sum + a * b in place of *sum, within +-2^60; b in Q47, |*sum| <= 2^60, the others as
 * above. */
void ocel_add_product(int64_t *sum, int64_t a, int64_t b_q47);

/* v, or the one of +-limit that it is beyond; limit >= 0. */
int64_t ocel_clamp64(int64_t v, int64_t limit);

#endif
