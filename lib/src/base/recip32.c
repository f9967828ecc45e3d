/* SPDX-License-Identifier: MIT
 *
 * The reciprocal in 32 bits.  Apart from int_math.c, whose division would hold a copy of
 * it.
 */
#include "int_math.h"

#define TWO_Q62 ((uint64_t)1U << 63U)

/* One 32-bit Newton step of the reciprocal.  m_q31 in [2^31, 2^32) is [1, 2),
 * y_q31 within 6 % of 1/m.  m y is within 6 % of 2^62, so 2 - m y fits Q31 in
 * 32 bits; y d < 1.06 * 2^62.  The step, y (2 - m y), turns a relative error d
 * into -d^2: the result is at most 1/m before rounding, so at most 2^31. */
static uint32_t recip_step(uint32_t m_q31, uint32_t y_q31) {
    const uint64_t product_q62 = (uint64_t)m_q31 * y_q31;
    const uint32_t d_q31 = (uint32_t)((TWO_Q62 - product_q62) >> 31U);

    return (uint32_t)((((uint64_t)y_q31 * d_q31) + ((uint64_t)1U << 30U)) >> 31U);
}

/* 1/m in Q31 for m_q31 in [2^31, 2^32).  Start: the linear minimax
 * 24/17 - (8/17) m, relative error 1/17; the steps square it to 2^-8.1,
 * 2^-16.3, 2^-32.7, below the roundings of m, d and y: 2^-29.8 together. */
uint32_t ocel_recip32(uint32_t m_q31) {
    uint32_t y_q31 = 3031741621U - (uint32_t)(((uint64_t)m_q31 * 2021161080U) >> 32U);

    y_q31 = recip_step(m_q31, y_q31);
    y_q31 = recip_step(m_q31, y_q31);
    return recip_step(m_q31, y_q31);
}
