/* SPDX-License-Identifier: MIT
 *
 * The conic that fits the points best: A xx + B xy + C yy + D x + E y + F = 0 in
 * the normalised frame, scaled so that A + C = 1.
 */
#ifndef OCELLUS_CONIC_H
#define OCELLUS_CONIC_H

#include <stdint.h>

#include <ocellus/status.h>

#include "scatter.h"

/* A = (1 + v) / 2, B = w, C = (1 - v) / 2, so 4AC - B^2 = 1 - v^2 - w^2: an
 * ellipse is a point inside the unit disc of (v, w), a circle its centre. */
typedef struct {
    int64_t v_q60;
    int64_t w_q60;
    int64_t d_q48; /* |D|, |E| < 2^10 */
    int64_t e_q48;
    int64_t mean_q60;     /* mean of the conic's polynomial over the points */
    ocel_scaled_t energy; /* mean of its square, times the points' weight */
} ocel_conic_t;

/* Fitzgibbon's ellipse (paper, eqs. 4-8) by the closed-form reduction of the
 * 6x6 problem.  Wants a scatter matrix whose first three columns have been
 * eliminated.  `eigenvalue_q60` out: the eigenvalue over the trace of the
 * reduced matrix, Q60: 0 when the points lie on a conic.
 * OCEL_OK, OCEL_DEGENERATE (no unique conic), OCEL_NOT_AN_ELLIPSE. */
ocel_status_t ocel_conic_b2ac(const ocel_scatter_t *scatter, ocel_conic_t *conic,
                              int64_t *eigenvalue_q60);

/* 4AC - B^2 below 2^-28 of (A + C)^2: an axis ratio under 2^-15, a parabola. */
#define OCEL_CONIC_FLAT_Q60 ((int64_t)4294967296)

/* 4AC - B^2 = 1 - v^2 - w^2: 1 for a circle, 0 for a parabola. */
int64_t ocel_conic_flatness_q60(const ocel_conic_t *conic);

/* D and E that make the mean of the polynomial times x, and times y, vanish.
 * OCEL_OK, or OCEL_NOT_AN_ELLIPSE when one is 2^10 or more. */
ocel_status_t ocel_conic_linear(const ocel_scatter_t *scatter, ocel_conic_t *conic);

#endif
