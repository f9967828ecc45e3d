/* SPDX-License-Identifier: MIT
 *
 * The first estimate: cones through three points, and which of them the points
 * consent to.
 */
#ifndef OCELLUS_CONE_VOTE_H
#define OCELLUS_CONE_VOTE_H

#include <stdbool.h>
#include <stdint.h>

#include "cone_frame.h"
#include "cone_samples.h"

/* A cone about an axis, and the scatter of the points that gave it. */
typedef struct {
    int64_t tan_q46; /* of half the opening angle, 2^-20 .. 1 */
    int32_t axis_cam_q30[3];
    uint16_t rms_px_q15; /* below 2 px */
    uint16_t hypothesis_count;
} ocel_cone_guess_t;

/* False when no three of the samples determine a cone of at most 90 degrees. */
bool ocel_cone_elect(const ocel_cone_samples_t *samples, const ocel_cone_place_t *place,
                     ocel_cone_guess_t *guess);

#endif
