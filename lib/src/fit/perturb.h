/* SPDX-License-Identifier: MIT
 *
 * The LCSE perturbation of one point (Greggio et al., "Real-time least-square
 * fitting of ellipses applied to the RobotCub platform", section 3.1, eqs.
 * 11-13): rho + A sin(2 pi f theta), A = 0.001, f = 1000, in Maini's
 * normalised frame.
 */
#ifndef OCEL_PERTURB_H
#define OCEL_PERTURB_H

#include <stdint.h>

/* Perturbs a point in place.  Q26: |x|, |y| <= 2^26 = 1.0 in; the point moves
 * by at most 0.001 (67109 LSB), so |x|, |y| < 2^26 + 2^17 out.
 * Error: 0.501 LSB for theta in the format of perturb.c, 0.82 LSB against the
 * formula in real numbers.  (0, 0) has no direction and stays. */
void ocel_perturb_point(int32_t *x_q26, int32_t *y_q26);

#endif
