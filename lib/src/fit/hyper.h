/* SPDX-License-Identifier: MIT
 *
 * The bias-corrected fit, for arcs and noise.
 */
#ifndef OCELLUS_HYPER_H
#define OCELLUS_HYPER_H

#include <ocellus/status.h>

#include "moments.h"
#include "solution.h"

/* Hyper least squares without its terms in 1/n ("semi-hyper": Kanatani and
 * Rangarajan, Hyper least squares fitting of circles and ellipses, CSDA 55
 * (2011), eqs. 20-24).  Eliminating the constant turns that 6x6 problem, up to
 * the square of the noise's variance, into Taubin's 5x5
 *   cov(xi) t = lambda N_T t,  then  mean of F = lambda (p A + q B + r C),
 * p, q, r the noise's covariance in the frame (DESIGN.md derives it).
 * Wants the frame and the moments of `solution`, writes its conic and where the points lie.
 * OCEL_OK, OCEL_DEGENERATE, OCEL_NOT_AN_ELLIPSE. */
ocel_status_t ocel_conic_hyper(ocel_solution_t *solution);

#endif
