/* SPDX-License-Identifier: MIT
 *
 * From a conic to the answer of a fit.
 */
#ifndef OCELLUS_FIT_FINISH_H
#define OCELLUS_FIT_FINISH_H

#include <stdbool.h>

#include <ocellus/status.h>
#include <ocellus/types.h>

#include "moments.h"
#include "solution.h"

/* Writes the ellipse but for its method and whether it was perturbed; zeroes it
 * unless the status is OCEL_OK or OCEL_PARTIAL: the latter for every arc under
 * 27/32 of a turn, which wants a second opinion.  `closed`: the points are a
 * whole closed boundary, so the arc need not be measured. */
ocel_status_t ocel_fit_finish(ocel_solution_t *solution, const ocel_source_t *source, bool closed,
                              ocel_ellipse_t *ellipse);

/* B2AC on moments: the reduced scatter matrix and its conic. */
ocel_status_t ocel_fit_direct(ocel_solution_t *solution, int64_t *eigenvalue_q60);

#endif
