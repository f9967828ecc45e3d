/* SPDX-License-Identifier: MIT
 *
 * Vectors of 64-bit components, so that one product, ocel_mul_q60, serves all: directions
 * in Q60, lengths in u with 30 fraction bits, relative covariances in Q60 and those in u^2
 * as they are.
 */
#ifndef OCELLUS_VEC3_H
#define OCELLUS_VEC3_H

#include <stdint.h>

/* a x b / 2^60, to 1 LSB.  |a|, |b| < 2^61 as vectors; the result is below 2^62. */
void ocel_cross_q60(const int64_t a[3], const int64_t b[3], int64_t product[3]);

/* a . b / 2^60, up to 3 LSB low; ranges as above. */
int64_t ocel_dot_q60(const int64_t a[3], const int64_t b[3]);

/* A direction's component from Q30 to Q60, a length from u to Q30. */
static inline int64_t ocel_widen_q30(int32_t v) {
    return (int64_t)v * (int64_t)0x40000000;
}

#endif
