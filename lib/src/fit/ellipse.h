/* SPDX-License-Identifier: MIT
 *
 * From a conic in the normalised frame to an ellipse in the image: centre,
 * axes and angle are found in the frame and those are mapped (mapping the
 * conic's coefficients instead would lose them far from the origin).
 */
#ifndef OCELLUS_ELLIPSE_H
#define OCELLUS_ELLIPSE_H

#include <ocellus/status.h>
#include <ocellus/types.h>

#include "solution.h"

/* Writes centre, semi-axes, angle and RMS residual of `ellipse`.  r: a solution's
 * places, its form among them; all but the flatness, the form and the frame are used up.
 * OCEL_OK, OCEL_NOT_AN_ELLIPSE (too flat, imaginary, or its centre over 2^8 frame units
 * away), OCEL_OUT_OF_RANGE (int32 Q16 pixels cannot hold it). */
ocel_status_t ocel_ellipse_of_conic(int64_t *r_q60, ocel_ellipse_t *ellipse);

#endif
