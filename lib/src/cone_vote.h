/* SPDX-License-Identifier: MIT
 *
 * The first estimate: cones through three points, and which of them the points
 * consent to.
 */
#ifndef OCELLUS_CONE_VOTE_H
#define OCELLUS_CONE_VOTE_H

#include <stdint.h>

#include <ocellus/status.h>

#include "cone_frame.h"

/* A cone about an axis, and the scatter of the points that gave it. */
typedef struct {
    int32_t axis_cam_q30[3];
    int64_t tan_q46;     /* of half the opening angle, 2^-20 .. 1 */
    uint32_t rms_px_q16; /* below 2 px */
} ocel_cone_guess_t;

/* OCEL_OK, OCEL_OUT_OF_RANGE (the camera refuses a point), OCEL_DEGENERATE (no three
 * of the samples determine a cone of at most 90 degrees). */
ocel_status_t ocel_cone_guess(const ocel_cone_source_t *source, const ocel_cone_place_t *place,
                              ocel_cone_guess_t *guess);

#endif
