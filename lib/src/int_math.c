/* SPDX-License-Identifier: MIT
 *
 * 64-bit division and square root, one result bit a trip, without branches on
 * the operands.
 */
#include "int_math.h"

#define DIVISION_TRIPS 64U /* bits of the quotient */
#define ROOT_TRIPS 32U     /* bits of the root: half of those of a uint64_t */

/* Schoolbook division.  Invariant: rest < den before each trip (den > 0), so
 * 2 rest + 1 < 2^65 and its 65th bit is `carry`; when it is set the
 * subtraction, modulo 2^64, is still exact, since the difference is < den.
 * With den = 0 every trip "fits" and the quotient is all ones. */
uint64_t ocel_udiv64(uint64_t num, uint64_t den) {
    uint64_t rest = 0U;
    uint64_t digits = num; /* dividend above, quotient growing below */

    for (uint32_t trip = 0U; trip < DIVISION_TRIPS; trip++) { /* bound: DIVISION_TRIPS = 64 */
        const uint64_t carry = rest >> 63U;
        uint64_t fits;

        rest = (rest << 1U) | (digits >> 63U);
        fits = carry | ((rest >= den) ? (uint64_t)1U : (uint64_t)0U);
        rest -= den & (0U - fits);
        digits = (digits << 1U) | fits;
    }
    return digits;
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
