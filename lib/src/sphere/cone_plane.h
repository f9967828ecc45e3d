/* SPDX-License-Identifier: MIT
 *
 * A cone as a plane over the directions of points.
 *
 * In a frame that looks at the points a unit vector is (u, v, 1 - e), and
 * d . m = 1 is a plane over (u, v):
 *   e = A u + B v + C,  m = (A, B, 1) / (1 - C).
 * The vectors of a ball's outline have u and v of the order of h and e of h^2; all
 * is in these units here, so that it is well conditioned for a far ball too:
 *   m = (h A, h B, 1) / (1 - h^2 C),
 *   tan^2 = |m|^2 - 1 = h^2 T^2 / (1 - h^2 C)^2, T^2 = A^2 + B^2 + 2 C - h^2 C^2,
 * and a residual r of the plane is a distance of r / T from the outline.
 */
#ifndef OCELLUS_CONE_PLANE_H
#define OCELLUS_CONE_PLANE_H

#include <stdbool.h>
#include <stdint.h>

#include "cone_frame.h"

typedef struct {
    int32_t a_q28;
    int32_t b_q28;
    int32_t c_q25; /* |C| <= 22 */
    int16_t a_q12; /* for residuals */
    int16_t b_q12;
    int64_t t2_q48; /* T^2 */
} ocel_cone_plane_t;

/* Completes a plane whose A, B (Q28) and C (Q25) are known; false, and the plane as it was,
 * when it is no cone of a size that these points can have.  h^2 C < 1/2: a cone under 90
 * degrees has less.  |C| is below 22 through three samples, and moves by less than 1 in a
 * round. */
bool ocel_cone_plane(const int64_t abc[3], const ocel_cone_place_t *place,
                     ocel_cone_plane_t *plane);

/* A distance in px from the outline, below 2 px, as a residual, Q25: T is at most 3.1, a pixel
 * at most h.  T is taken within 3 %, which a gate can bear. */
int32_t ocel_cone_gate_q25(const ocel_cone_plane_t *plane, const ocel_cone_place_t *place,
                           uint32_t px_q16);

#endif
