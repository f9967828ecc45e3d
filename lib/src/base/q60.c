/* SPDX-License-Identifier: MIT
 *
 * Reciprocal and reciprocal square root: normalise, start from a small
 * polynomial, Newton steps in 32 bits, one last step in 64.
 *
 * Newton's iteration for the root, y (3 - m y^2) / 2, turns a relative error d
 * into -(3/2) d^2 - d^3/2, so after the first step every value is at or below
 * the true one and, before rounding, at most 1: it fits its format.
 */
#include "q60.h"

#include "scale.h"

#define RSQRT_TRIPS 3U /* 2^-5.4, 2^-10.2, 2^-19.8, 2^-39: past the 32 bits */

#define ONE_Q61 ((uint64_t)1U << 61U)
#define ONE_Q62 ((uint64_t)1U << 62U)

void ocel_recip_short(uint64_t p, uint32_t *y_q31, int32_t *e) {
    if (p == 0U) {
        *y_q31 = 0U;
        *e = 0;
    } else {
        const uint32_t shift = ocel_clz64(p);

        /* p / 2^60 = (m / 2^63) * 2^(3 - shift). */
        *y_q31 = ocel_recip32((uint32_t)((p << shift) >> 32U));
        *e = (int32_t)shift - 3;
    }
}

/* The last step in 64 bits: r = 1 - m y, floored by less than 2^-62, then
 * y + y r.  With d = 2^-29.8, the error of the 32-bit reciprocal, r in Q60 is
 * below 2^31 and y r below 2^62.  Error: d^2 from the step, and two roundings
 * of half an LSB of 2^-60, y being 1/2 or more: below 2^-58. */
void ocel_recip_q60(uint64_t p, int64_t *y_q60, int32_t *e) {
    if (p == 0U) {
        *y_q60 = 0;
        *e = 0;
    } else {
        const uint32_t shift = ocel_clz64(p);
        const uint64_t m_q63 = p << shift;
        const uint32_t m_high = (uint32_t)(m_q63 >> 32U);
        const uint32_t m_low = (uint32_t)(m_q63 & 0xFFFFFFFFU);
        const uint32_t y_q31 = ocel_recip32(m_high);
        const uint64_t product_q62 =
            ((uint64_t)m_high * y_q31) + (((uint64_t)m_low * y_q31) >> 32U);
        const int64_t r_q60 = ocel_shift_round64(ocel_signed64(ONE_Q62 - product_q62), 2U);

        *y_q60 = ocel_shl64((int64_t)y_q31, 29U) + ocel_shift_round64((int64_t)y_q31 * r_q60, 31U);
        *e = (int32_t)shift - 3;
    }
}

/* One 32-bit Newton step of the reciprocal root.  m_q30 in [2^30, 2^32) is
 * [1, 4), y_q31 within 3 % of 1/sqrt(m) and at most 2^31.  y^2 <= 2^31 in Q31;
 * m y^2 is within 6 % of 2^61; 3 - m y^2 in Q30 below 2.06 * 2^30; y d below
 * 2.06 * 2^61. */
static uint32_t rsqrt_step(uint32_t m_q30, uint32_t y_q31) {
    const uint32_t square_q31 =
        (uint32_t)((((uint64_t)y_q31 * y_q31) + ((uint64_t)1U << 30U)) >> 31U);
    const uint64_t product_q61 = (uint64_t)m_q30 * square_q31;
    const uint32_t d_q30 = (uint32_t)(((3U * ONE_Q61) - product_q61) >> 31U);

    return (uint32_t)((((uint64_t)y_q31 * d_q30) + ((uint64_t)1U << 30U)) >> 31U);
}

/* 1/sqrt(m) in Q31 for m_q30 in [2^30, 2^32).  Start: the quadratic minimax
 * 1.335418 - 0.410670 m + 0.0512052 m^2, relative error 0.0241 = 2^-5.4; the
 * steps bring it to 2^-10.2, 2^-19.8, 2^-39, below the roundings, 2^-29.4 together. */
static uint32_t rsqrt_q31(uint32_t m_q30) {
    /* Horner.  The slope is 0.206 to 0.359, so the product is below 0.83. */
    const uint32_t slope_q32 = 1763812373U - (uint32_t)(((uint64_t)m_q30 * 879699390U) >> 32U);
    uint32_t y_q31 = 2867787663U - (uint32_t)(((uint64_t)m_q30 * slope_q32) >> 31U);

    for (uint32_t trip = 0U; trip < RSQRT_TRIPS; trip++) { /* bound: RSQRT_TRIPS = 3 */
        y_q31 = rsqrt_step(m_q30, y_q31);
    }
    return y_q31;
}

/* y in Q60 for m_q62 in [2^62, 2^64), [1, 4): r = 1 - m y^2, then y + y r / 2.
 * m y <= 2 in Q61, m y^2 close to 1.  With d = 2^-29.4, the error of the 32-bit
 * root, |r| < 2 d < 2^-28: in Q60 below 2^32, and y r below 2^63.  Error: -1.5
 * d^2 = -2^-58.2 from the step; r is up to 2 LSB too large, y then by 1, and
 * the rounding: at most 1.5 LSB of 2^-60, y being 1/2 or more. */
static int64_t rsqrt_mantissa(uint64_t m_q62) {
    const uint32_t m_high = (uint32_t)(m_q62 >> 32U);
    const uint32_t m_low = (uint32_t)(m_q62 & 0xFFFFFFFFU);
    const uint32_t y_q31 = rsqrt_q31(m_high);
    const uint64_t root_q61 = ((uint64_t)m_high * y_q31) + (((uint64_t)m_low * y_q31) >> 32U);
    const uint64_t one_q60 =
        ((root_q61 >> 32U) * y_q31) + (((root_q61 & 0xFFFFFFFFU) * y_q31) >> 32U);
    const int64_t r_q60 = OCEL_Q60_ONE - ocel_signed64(one_q60);

    return ocel_shl64((int64_t)y_q31, 29U) + ocel_shift_round64((int64_t)y_q31 * r_q60, 32U);
}

void ocel_rsqrt_q60(uint64_t p, int64_t *y_q60, int32_t *e) {
    if (p == 0U) {
        *y_q60 = 0;
        *e = 0;
    } else {
        /* An even shift: p / 2^60 = (m / 2^62) * 2^(2 - shift). */
        const uint32_t shift = ocel_clz64(p) & ~1U;
        const uint32_t half_shift = shift >> 1U;

        *y_q60 = rsqrt_mantissa(p << shift);
        *e = (int32_t)half_shift - 1;
    }
}

/* sqrt(m) = m / sqrt(m), with p / 2^60 = (m / 2^62) * 2^(2 - shift), m in Q59 (below
 * 2^61) and the reciprocal root in Q60: the product is in [2^59, 2^60].  p < 2^62, so
 * shift >= 2 and the last shift is -1 (one bit left) or a right one of up to 29. */
int64_t ocel_sqrt_q60(uint64_t p) {
    int64_t y_q60;
    int64_t m_q59;
    int32_t e; /* shift / 2 - 1 */

    ocel_rsqrt_q60(p, &y_q60, &e);
    m_q59 = ocel_signed64((p << (uint32_t)(2 * (e + 1))) >> 3U);
    /* sqrt(p / 2^60) = sqrt(m) * 2^(1 - shift / 2); one more for Q59. */
    return ocel_asr64(ocel_asr64(ocel_mul_q60(m_q59, y_q60) * 4, (uint32_t)e) + 1, 1U);
}
