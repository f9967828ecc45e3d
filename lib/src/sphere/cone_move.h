/* SPDX-License-Identifier: MIT
 *
 * What a step makes of a guess.
 */
#ifndef OCELLUS_CONE_MOVE_H
#define OCELLUS_CONE_MOVE_H

#include <stdint.h>

#include <ocellus/space.h>

#include "cone_frame.h"
#include "cone_step.h"

/* The guess of a frame and a tangent moved by the step: its axis; its tangent, Q60 and at most
 * 3/2. */
int64_t ocel_cone_move(const ocel_cone_frame_t *frame, int64_t tan_q60,
                       const ocel_cone_step_t *step, int32_t r_px_q16, int32_t axis_cam_q30[3]);

/* The covariance of the centre over its distance squared that the step leaves; 1 without a
 * step (null), or where it is not below 1.  Returns the variance of the range over its square;
 * the step's inverse is used up. */
int64_t ocel_cone_spread(const ocel_cone_frame_t *frame, int64_t tan_q60, ocel_cone_step_t *step,
                         int32_t r_px_q16, int64_t cov_q60[OCEL_SYM3_COUNT]);

#endif
