/* SPDX-License-Identifier: MIT
 *
 * 64-bit division and square root in a fixed number of trips,
 * whatever the operands.
 */
#include "int_math.h"

#define DIVISION_TRIPS 3U /* 27 bits of the quotient each */
#define ROOT_TRIPS 32U    /* bits of the root: half of those of a uint64_t */

/* Long division with digits from a reciprocal.  With den = m 2^-shift, m in
 * [2^63, 2^64), and y = 1/m in Q31, a digit is rest * y / 2^(94 - shift).
 * ocel_recip32 is good to 2^-29, at most 4 LSB; y, here in Q32, is made 4 LSB of Q31 smaller, so
 * it is below 1/m by a fraction of less than 2^-27.4, and no digit is too
 * large: rest never goes below 0.  One trip leaves
 *     rest' < 2^-27.4 rest + den,
 * three leave less than 2^-18 + (1 + 2^-27) den from any 64-bit num: at most
 * one den is left to subtract.  The product is below 2^96 / 2^32. */
uint64_t ocel_udiv64(uint64_t num, uint64_t den) {
    uint64_t quotient = UINT64_MAX;

    if (den != 0U) {
        const uint32_t shift = ocel_clz64(den);
        const uint32_t y_q32 = 2U * (ocel_recip32((uint32_t)((den << shift) >> 32U)) - 4U);
        const uint32_t down = 63U - shift;
        uint64_t rest = num;

        quotient = 0U;
        for (uint32_t trip = 0U; trip < DIVISION_TRIPS; trip++) { /* bound: DIVISION_TRIPS = 3 */
            const uint64_t high = (uint64_t)(uint32_t)(rest >> 32U) * y_q32;
            const uint64_t low = (uint64_t)(uint32_t)(rest & 0xFFFFFFFFU) * y_q32;
            const uint64_t digit = (high + (low >> 32U)) >> down;

            quotient += digit;
            rest -= digit * den;
        }
        quotient += (rest >= den) ? (uint64_t)1U : (uint64_t)0U;
    }
    return quotient;
}

/* Schoolbook square root, two bits of v a trip.  Invariant: root = floor(sqrt)
 * of the bits taken so far, and rest = those bits - root^2 <= 2 root; root is
 * below 2^32, so rest is below 2^33 and (rest << 2) | 3 below 2^35. */
uint32_t ocel_isqrt64(uint64_t v) {
    uint64_t bits = v;
    uint64_t rest = 0U;
    uint64_t root = 0U;

    for (uint32_t trip = 0U; trip < ROOT_TRIPS; trip++) { /* bound: ROOT_TRIPS = 32 */
        uint64_t trial;
        uint64_t fits;

        rest = (rest << 2U) | (bits >> 62U);
        bits <<= 2U;
        trial = (root << 2U) | 1U; /* (2 root + 1)^2 - (2 root)^2 */
        fits = (rest >= trial) ? (uint64_t)1U : (uint64_t)0U;
        rest -= trial & (0U - fits);
        root = (root << 1U) | fits;
    }
    return (uint32_t)root;
}

#if OCEL_WORD_BITS != 64
int32_t ocel_bits_of(const int64_t *v, uint32_t count) {
    return ocel_bits_of_here(v, count);
}
#endif

uint32_t ocel_ceil_log2(uint64_t n) {
    return (n <= 1U) ? 0U : (64U - ocel_clz64(n - 1U));
}
