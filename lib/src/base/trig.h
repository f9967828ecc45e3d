/* SPDX-License-Identifier: MIT
 *
 * Angles as fractions of a turn: 2^32 is a full turn, so an angle wraps as
 * unsigned arithmetic does and no range reduction is needed.
 */
#ifndef OCEL_TRIG_H
#define OCEL_TRIG_H

#include <stdint.h>

/* Cartesian to polar.  |x|, |y| <= 2^60, in any unit.
 *   magnitude  hypot(x, y) in the same unit, at most 2^60.5; error: half an
 *              LSB and 2^-52 of it.
 *   turn_q32   the angle from +x towards +y, 2^32 = a turn; error below 0.51
 *              LSB, for small vectors as for large ones.
 * (0, 0) gives 0 and 0. */
void ocel_polar(int64_t x, int64_t y, int64_t *magnitude, uint32_t *turn_q32);

/* Sine and cosine of an angle, 2^30 = 1.0, in [-2^30, 2^30]; error below
 * 1 LSB.  Multiples of a quarter turn are exact. */
void ocel_sincos(uint32_t turn_q32, int32_t *sin_q30, int32_t *cos_q30);

#endif
