/* SPDX-License-Identifier: MIT
 *
 * The map that makes a guess's outline the unit circle (cone_sums.h), and what is near it.
 */
#ifndef OCELLUS_CONE_CIRCLE_H
#define OCELLUS_CONE_CIRCLE_H

#include <stdint.h>

#include "cone_frame.h"
#include "cone_vote.h"

/* The frame's rows x and y over t z0, in units of 2^side_e,
 * and z over z0. */
typedef struct {
    ocel_cone_map_t scaled;
    uint32_t side_down; /* a component to Q24 */
    int32_t r_px_q16;   /* of the outline, up to 2^30 */
    int32_t gate_px_q16;
    int32_t half_px_q16[2]; /* of a crack along y, along x; points: 0 */
} ocel_cone_circle_t;

void ocel_cone_circle(const ocel_cone_source_t *source, const ocel_cone_guess_t *guess,
                      ocel_cone_circle_t *circle);

#endif
