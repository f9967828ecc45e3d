/* SPDX-License-Identifier: MIT
 *
 * The format of theta decides the result.  The paper's phase, 2 pi f theta
 * with theta in radians, turns 6283 times in one turn of theta: a change of
 * 1e-4 rad is half a period, so two machines that round theta differently, and
 * even two libm's, perturb differently.  Here the formula is fixed to the bit:
 *
 *   theta  = ocel_polar's angle, an unsigned fraction of a turn with 32 bits,
 *            in [0, 1): the paper's [0, 2 pi)
 *   phase  = frac(2000 pi theta), in turns, where 2000 pi carries 32 fraction
 *            bits; the product's own 32 top fraction bits are kept
 *
 * One LSB of theta is then 6283 LSB of phase, 9.2e-6 rad: 0.62 LSB of the
 * result.  As in the paper theta is in [0, 2 pi) and 1000 * 2 pi is no whole
 * number, so the perturbation jumps across the +x axis.
 */
#include "perturb.h"

#include "../base/int_math.h"
#include "../base/q60.h"
#include "../base/trig.h"

/* f theta_rad in turns of phase per turn of theta: 2 pi * 1000 * 2^32. */
#define PHASE_PER_TURN_Q32 ((uint64_t)26986075409044)

/* A = 0.001 * 2^41. */
#define AMPLITUDE_Q41 ((int64_t)2199023256)

/* v + displacement * v / rho, v one coordinate, 1/rho = inverse * 2^e, e 0..26.
 * |v| <= 2^26, so v * inverse <= 2^57; v / rho is a cosine, |.| <= 1 + 2^-28 in
 * Q30, and the displacement is below 2^26.1, so their product is below 2^57. */
static int32_t moved(int32_t v_q26, uint32_t inverse_q31, int32_t e, int64_t displacement_q36) {
    const int32_t down = 27 - e; /* Q26 * Q31 to Q30, and 2^e */
    const int64_t cosine_q30 =
        ocel_shift_round64((int64_t)v_q26 * (int64_t)inverse_q31, (uint32_t)down);

    return v_q26 + (int32_t)ocel_shift_round64(cosine_q30 * displacement_q36, 40U);
}

void ocel_perturb_point(int32_t *x_q26, int32_t *y_q26) {
    int64_t rho_q60;
    uint32_t theta_q32;
    uint32_t phase_q32;
    int32_t sin_q30;
    int32_t cos_q30;
    uint32_t inverse_q31;
    int32_t e;
    int64_t displacement_q36;

    /* Shifted up to Q60 so that rho has more bits than the coordinates. */
    ocel_polar(ocel_shl64(*x_q26, 34U), ocel_shl64(*y_q26, 34U), &rho_q60, &theta_q32);
    phase_q32 = (uint32_t)(((theta_q32 * PHASE_PER_TURN_Q32) >> 32U) & 0xFFFFFFFFU);
    ocel_sincos(phase_q32, &sin_q30, &cos_q30);
    (void)cos_q30;
    displacement_q36 = ocel_shift_round64(sin_q30 * AMPLITUDE_Q41, 35U);

    /* rho_hat (cos, sin) = (x, y) + displacement * (x, y) / rho: no second
     * sine and cosine, and theta's rounding touches the phase only.  rho is 0
     * or in [2^34, 2^60.5], so e is in 0..26; for rho = 0 the inverse is 0. */
    ocel_recip_short((uint64_t)rho_q60, &inverse_q31, &e);
    *x_q26 = moved(*x_q26, inverse_q31, e, displacement_q36);
    *y_q26 = moved(*y_q26, inverse_q31, e, displacement_q36);
}
