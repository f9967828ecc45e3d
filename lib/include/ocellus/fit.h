/* SPDX-License-Identifier: MIT
 *
 * Ellipse fitting, direct and bounded: moments of the points, the closed-form
 * reduction of the 6x6 constrained eigenproblem, one cubic, one null vector.
 * DESIGN.md derives it; fit.c states ranges and Q formats.
 */
#ifndef OCELLUS_FIT_H
#define OCELLUS_FIT_H

#include <stdbool.h>
#include <stddef.h>

#include <ocellus/status.h>
#include <ocellus/types.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Ranges of the result.  centre_sigma is the Kanatani-Cramer-Rao bound for the
 * residual and the arc seen, of the distance: it leaves out B2AC's own bias,
 * which on arcs of 120 degrees is as large again (use OCEL_FIT_HYPER there).
 * arc_coverage counts 32 sectors of the ellipse, by up to 256 of the points.
 *
 * Fits an ellipse to points in any order.
 *   points   count points; not written; may repeat.
 *   options  null means {OCEL_FIT_B2AC, OCEL_PERTURB_AUTO, false}.
 *   ellipse  out; written for OCEL_OK and OCEL_PARTIAL, zeroed otherwise.
 * OCEL_OK               an ellipse, vouched for
 * OCEL_PARTIAL          an ellipse, but the arc is too short: under 124 degrees,
 *                       and noisy enough that the centre's expected error
 *                       (centre_sigma) is over 5 % of the semi-minor axis
 * OCEL_TOO_FEW_POINTS   count < OCEL_MIN_FIT_POINTS
 * OCEL_DEGENERATE       collinear, coincident, or no unique best conic
 * OCEL_NOT_AN_ELLIPSE   the best conic is (nearly) a parabola, or no ellipse
 * OCEL_OUT_OF_RANGE     a coordinate over OCEL_MAX_COORDINATE_PX, or a result
 *                       that int32 Q16 pixels cannot hold
 * OCEL_OVERFLOW         count > OCEL_MAX_FIT_POINTS
 * OCEL_BAD_OPTION       options hold a value that is none of the enumeration
 * OCEL_NULL_ARGUMENT    points or ellipse is null */
ocel_status_t ocel_fit_points(const ocel_point_t *points, size_t count,
                              const ocel_fit_options_t *options, ocel_ellipse_t *ellipse);

/* The same for boundary cracks, in half pixels: the fast path, with exact
 * 64-bit sums.  Same statuses. */
ocel_status_t ocel_fit_cracks(const ocel_crack_t *cracks, size_t count,
                              const ocel_fit_options_t *options, ocel_ellipse_t *ellipse);

/* B2AC on boundary cracks: what the eye runs, and all that it links.
 *   closed  the cracks are a whole closed boundary, so they cover the full turn;
 *           false: the arc is measured.
 * The bits of ocel_fit_cracks with OCEL_FIT_B2AC.  Statuses the same, but
 * OCEL_OVERFLOW also for what exact 64-bit sums might not hold: a disc of more
 * than 512 px radius (ocel_fit_cracks takes its other path there). */
ocel_status_t ocel_fit_boundary(const ocel_crack_t *cracks, size_t count, bool closed,
                                ocel_ellipse_t *ellipse);

#ifdef __cplusplus
}
#endif

#endif
