/* SPDX-License-Identifier: MIT
 *
 * All points beside a guessed cone.
 *
 * In the frame of the guess's axis the outline is X^2 + Y^2 = (t Z)^2, t the tangent.
 * With X and Y over t z0 and Z over z0, z0 = 1 / (the axis's z in the camera), it is a
 * circle of radius 1 wherever the ball is in the image, rays need no root to be put
 * there, and one unit of it is R = f t z0^2 px.  A point's distance from it, d, is in px,
 * by the second order of a = (X^2 + Y^2 - Z^2) / 2: d = a - a^2 / 2.
 *
 * Sums are kept by sector, each point's direction rounded to its sector's middle, which
 * loses no more than 1/300 of the precision (its cosine's square, averaged).  With them
 * goes what no sum can tell: the outline passes between the two pixels of a crack, so
 * within a sector between the outermost of the ends inside and the innermost of those
 * outside.
 */
#ifndef OCELLUS_CONE_SUMS_H
#define OCELLUS_CONE_SUMS_H

#include <stdbool.h>
#include <stdint.h>

#include "../base/sector.h"
#include "cone_frame.h"
#include "cone_vote.h"

/* Sums over points, by sector.  |d| <= 1.9 px, so the sum of OCEL_MAX_FIT_POINTS is at most
 * 1.9 * 2^30, and an end is within 2.6 px. */
typedef struct {
    int32_t d_px_q16[OCEL_SECTORS];    /* of the inliers */
    int16_t low_px_q13[OCEL_SECTORS];  /* the largest d of an inlier's end inside */
    int16_t high_px_q13[OCEL_SECTORS]; /* the smallest d of an end outside */
    uint16_t inliers[OCEL_SECTORS];
    uint8_t others[OCEL_SECTORS]; /* 255: or more */
    int64_t squares_q32;
    uint32_t inlier_count;
    uint32_t mixed;   /* bit k: sector k has points that are near, but no inliers */
    int32_t r_px_q16; /* R, at most 2^30 */
    uint16_t outside; /* of the others, those beyond the outline */
    bool cracks;      /* low and high are of use */
} ocel_cone_sums_t;

/* False when the camera refuses a point. */
bool ocel_cone_sum(const ocel_cone_source_t *source, const ocel_cone_guess_t *guess,
                   ocel_cone_sums_t *sums);

#endif
