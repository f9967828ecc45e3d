/* SPDX-License-Identifier: MIT
 *
 * The conic that fits the points best.
 */
#ifndef OCELLUS_CONIC_H
#define OCELLUS_CONIC_H

#include <stdint.h>

#include <ocellus/status.h>

#include "scatter.h"
#include "solution.h"

/* Fitzgibbon's ellipse (paper, eqs. 4-8) by the closed-form reduction of the
 * 6x6 problem.  Wants a scatter matrix whose first three columns have been
 * eliminated; writes the conic of `solution`.  `eigenvalue_q60` out: the eigenvalue
 * over the trace of the reduced matrix, Q60: 0 when the points lie on a conic.
 * OCEL_OK, OCEL_DEGENERATE (no unique conic), OCEL_NOT_AN_ELLIPSE. */
ocel_status_t ocel_conic_b2ac(const ocel_scatter_t *scatter, ocel_solution_t *solution,
                              int64_t *eigenvalue_q60);

/* Writes the flatness of v and w.  OCEL_OK, or OCEL_NOT_AN_ELLIPSE where it is below
 * 2^-28: an axis ratio under 2^-15, a parabola. */
ocel_status_t ocel_conic_flatten(ocel_solution_t *solution);

#endif
