/* SPDX-License-Identifier: MIT
 *
 * A 128-bit accumulator: exact sums of 64x64-bit products in portable C99.
 * (__int128 does not exist on 32-bit targets.)
 */
#ifndef OCEL_WIDE_H
#define OCEL_WIDE_H

#include <stdint.h>

#include "int_math.h"

/* Two's complement: the value is hi * 2^64 + lo. */
typedef struct {
    int64_t hi;
    uint64_t lo;
} ocel_i128_t;

/* acc += v, exact.  |acc| stays below 2^127: the caller's bound. */
static inline void ocel_i128_add64(ocel_i128_t *acc, int64_t v) {
    const uint64_t lo = acc->lo + (uint64_t)v;
    const int64_t carry = (lo < acc->lo) ? 1 : 0;

    acc->lo = lo;
    acc->hi += ocel_sign64(v) + carry;
}

/* acc += a * b, exact.  |a|, |b| <= 2^62; |acc| stays below 2^127: the
 * caller's bound.
 *
 * With a = ah 2^32 + al, 0 <= al < 2^32, |ah| <= 2^30, and b alike:
 *   ah*bh  <= 2^60 in magnitude.
 *   middle = ah*bl + al*bh + (al*bl >> 32).  ah = 2^30 only when al = 0, so
 *            otherwise ah*bl <= (2^30 - 1)(2^32 - 1) = 2^62 - 2^32 - 2^30 + 1,
 *            and the three sum to less than 2^63 - 2^32.  Below, each product
 *            is >= -2^62 + 2^30 and the third term >= 0: above -2^63.
 *   The low halves do not overlap, so acc takes one carry. */
static inline void ocel_i128_mac_by_parts(ocel_i128_t *acc, int64_t a, int64_t b) {
    const int64_t ah = ocel_asr64(a, 32U);
    const int64_t bh = ocel_asr64(b, 32U);
    const uint32_t al = (uint32_t)((uint64_t)a & 0xFFFFFFFFU);
    const uint32_t bl = (uint32_t)((uint64_t)b & 0xFFFFFFFFU);
    const uint64_t low = (uint64_t)al * bl;
    const int64_t middle = (ah * (int64_t)bl) + ((int64_t)al * bh) + ocel_signed64(low >> 32U);
    const uint64_t product_lo = ((uint64_t)middle << 32U) | (low & 0xFFFFFFFFU);
    const uint64_t lo = acc->lo + product_lo;
    const int64_t carry = (lo < product_lo) ? 1 : 0;

    acc->lo = lo;
    acc->hi += (ah * bh) + ocel_asr64(middle, 32U) + carry;
}

#if defined(__SIZEOF_INT128__)
static inline void ocel_i128_mac(ocel_i128_t *acc, int64_t a, int64_t b) {
    const ocel_int128_t product = (ocel_int128_t)a * b;
    const uint64_t product_lo = (uint64_t)product;
    const uint64_t lo = acc->lo + product_lo;

    acc->lo = lo;
    acc->hi += (int64_t)(product >> 64) + ((lo < product_lo) ? 1 : 0);
}
#else
static inline void ocel_i128_mac(ocel_i128_t *acc, int64_t a, int64_t b) {
    ocel_i128_mac_by_parts(acc, a, b);
}
#endif

/* acc / 2^n to the nearest integer, halves towards +infinity; n 0..127.  The
 * result must fit in an int64_t: |acc| < 2^(62 + n) is enough; otherwise its
 * upper bits are lost. */
int64_t ocel_i128_shift_right(const ocel_i128_t *acc, uint32_t n);

/* The same with a signed count, -63..127: a negative one shifts left, exactly,
 * with the same demand that the result fit. */
int64_t ocel_i128_shift(const ocel_i128_t *acc, int32_t n);

/* The fewest bits k such that -2^k <= acc < 2^k: 0 for 0 and -1, 127 at most.
 * So acc shifted right by k - 62 fits in 62 bits and a sign. */
uint32_t ocel_i128_bits(const ocel_i128_t *acc);

#endif
