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

/* What a result tells of itself.  centre_sigma is the Kanatani-Cramer-Rao bound
 * of the centre's distance for the residual and the arc seen; it leaves out
 * B2AC's own bias, which on arcs of 120 degrees is as large again (use
 * OCEL_FIT_HYPER there).  arc_coverage counts 32 sectors of the ellipse.
 *
 * Points said to be closed are a blob's whole boundary, and so a ball's only if they
 * lie on the ellipse: vouched for is an rms of at most 1/2 px + 1/64 of the semi-minor
 * axis (something that hides 5 % of a ball of 20 px takes it over that).
 * Other points are vouched for when they cover 27/32 of the turn (304 degrees).  A
 * shorter arc wants agreement: B2AC (or LCSE) and
 * hyper must put the centre in the same place, within 10 % of the semi-minor
 * axis, and below 11/32 of the turn (124 degrees) sigma must be under 5 % of it
 * too.  Exact points pass whatever their arc.
 *
 * Fits an ellipse to points in any order.
 *   points   count points; not written; may repeat.
 *   options  null means {OCEL_FIT_B2AC, OCEL_PERTURB_AUTO, false}.
 *   ellipse  out; written for OCEL_OK and OCEL_PARTIAL, zeroed otherwise.
 * OCEL_OK               an ellipse, vouched for
 * OCEL_PARTIAL          an ellipse, but the arc is too short for its noise, or a closed
 *                       boundary is no ellipse's
 * OCEL_TOO_FEW_POINTS   count < OCEL_MIN_FIT_POINTS
 * OCEL_DEGENERATE       collinear, coincident, or no unique best conic
 * OCEL_NOT_AN_ELLIPSE   the best conic is (nearly) a parabola, or no ellipse,
 *                       or an arc of less than about 10 degrees
 * OCEL_OUT_OF_RANGE     a coordinate over OCEL_MAX_COORDINATE_PX, or a result
 *                       beyond 16384 px (axes) or 32767 px (centre)
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
 *           false: the arc is measured, and one under 27/32 of a turn is
 *           OCEL_PARTIAL, for want of a second opinion.
 * Otherwise the bits of ocel_fit_cracks with OCEL_FIT_B2AC.  Statuses the same, but
 * OCEL_OVERFLOW also for what exact 64-bit sums might not hold: a disc of more
 * than 512 px radius (ocel_fit_cracks takes its other path there). */
ocel_status_t ocel_fit_boundary(const ocel_crack_t *cracks, size_t count, bool closed,
                                ocel_ellipse_t *ellipse);

#ifdef __cplusplus
}
#endif

#endif
