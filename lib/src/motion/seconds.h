/* SPDX-License-Identifier: MIT
 *
 * Microseconds to seconds, and sums of products with them.
 */
#ifndef OCEL_SECONDS_H
#define OCEL_SECONDS_H

#include <stdint.h>

#include "product.h"

/* Fraction bits of seconds, and of the gains that they are multiplied with. */
#define OCEL_SECONDS_BITS 47

/* 2^47 / 10^6, to 3e-9 of it. */
#define OCEL_SECONDS_Q47_PER_US 140737488

/* Any dt_us; the result is below 2^60. */
static inline int64_t ocel_seconds_q47(uint32_t dt_us) {
    return (int64_t)dt_us * OCEL_SECONDS_Q47_PER_US;
}

/* v, or the one of +-limit that it is beyond; limit >= 0. */
int64_t ocel_clamp64(int64_t v, int64_t limit);

/* *sum + a * b in place of *sum, within +-2^60; b in Q47, |*sum| <= 2^60, |a| and |b|
 * < 2^61. */
void ocel_add_product(int64_t *sum, int64_t a, int64_t b_q47);

#endif
