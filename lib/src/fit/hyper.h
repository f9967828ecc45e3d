/* SPDX-License-Identifier: MIT
 *
 * The bias-corrected fit, for arcs and noise.
 */
#ifndef OCELLUS_HYPER_H
#define OCELLUS_HYPER_H

#include <ocellus/status.h>

#include "conic.h"
#include "moments.h"
#include "scatter.h"

/* Hyper least squares without its terms in 1/n ("semi-hyper": Kanatani and
 * Rangarajan, Hyper least squares fitting of circles and ellipses, CSDA 55
 * (2011), eqs. 20-24).  Eliminating the constant turns that 6x6 problem, up to
 * the square of the noise's variance, into Taubin's 5x5
 *   cov(xi) t = lambda N_T t,  then  mean of F = lambda (p A + q B + r C),
 * p, q, r the noise's covariance in the frame (DESIGN.md derives it).
 * Writes the spread of the points too.
 * OCEL_OK, OCEL_DEGENERATE, OCEL_NOT_AN_ELLIPSE. */
ocel_status_t ocel_conic_hyper(const ocel_moments_t *moments, const ocel_frame_t *frame,
                               ocel_spread_t *spread, ocel_conic_t *conic);

#endif
