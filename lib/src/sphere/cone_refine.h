/* SPDX-License-Identifier: MIT
 *
 * From an estimate of the cone to the cone of all points, with what they tell of it.
 */
#ifndef OCELLUS_CONE_REFINE_H
#define OCELLUS_CONE_REFINE_H

#include <stdbool.h>
#include <stdint.h>

#include <ocellus/cone.h>

#include "cone_sums.h"
#include "cone_vote.h"

/* What the status is decided by, beside the cone itself. */
typedef struct {
    uint32_t outside;         /* points beyond the outline */
    uint32_t sectors;         /* of 32, that inliers cover */
    bool bent;                /* inliers deviate together and not each for itself */
    int64_t range_sigma2_q60; /* variance of the range over its square */
} ocel_cone_evidence_t;

/* One step of least squares from the guess.  Writes all of the cone but its point
 * count. */
void ocel_cone_refine(const ocel_cone_sums_t *sums, const ocel_cone_guess_t *guess,
                      ocel_cone_t *cone, ocel_cone_evidence_t *evidence);

#endif
