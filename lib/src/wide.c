/* SPDX-License-Identifier: MIT
 *
 * Reading the 128-bit accumulator back into 64 bits.
 */
#include "wide.h"

/* Bit n of acc, n 0..127, as 0 or 1. */
static int64_t bit_at(const ocel_i128_t *acc, uint32_t n) {
    const uint64_t word = (n < 64U) ? acc->lo : (uint64_t)acc->hi;

    return ocel_signed64((word >> (n & 63U)) & 1U);
}

/* floor(acc / 2^n), modulo 2^64; n 0..127. */
static int64_t floor_shift(const ocel_i128_t *acc, uint32_t n) {
    int64_t shifted;

    if (n >= 64U) {
        shifted = ocel_asr64(acc->hi, n - 64U);
    } else if (n > 0U) {
        const uint32_t up = 64U - n;
        const uint64_t upper = (uint64_t)acc->hi << up;

        shifted = ocel_signed64(upper | (acc->lo >> n));
    } else {
        shifted = ocel_signed64(acc->lo);
    }
    return shifted;
}

/* floor(v + 1/2) of a binary fraction is floor(v) plus its first fractional
 * bit, so the half is never added to 128 bits. */
int64_t ocel_i128_shift_right(const ocel_i128_t *acc, uint32_t n) {
    int64_t shifted = floor_shift(acc, n);

    if (n > 0U) {
        shifted += bit_at(acc, n - 1U);
    }
    return shifted;
}

int64_t ocel_i128_shift(const ocel_i128_t *acc, int32_t n) {
    int64_t shifted;

    if (n >= 0) {
        shifted = ocel_i128_shift_right(acc, (uint32_t)n);
    } else {
        /* A result that fits has its value in the low word. */
        const int32_t up = -n;

        shifted = ocel_signed64(acc->lo << (uint32_t)up);
    }
    return shifted;
}

uint32_t ocel_i128_bits(const ocel_i128_t *acc) {
    /* Complementing a negative value gives -v - 1 >= 0, with the same k. */
    const uint64_t sign = (uint64_t)ocel_sign64(acc->hi);
    const uint64_t hi = (uint64_t)acc->hi ^ sign;
    const uint64_t lo = acc->lo ^ sign;

    return (hi != 0U) ? (128U - ocel_clz64(hi)) : (64U - ocel_clz64(lo));
}
