/* SPDX-License-Identifier: MIT
 *
 * From the sums over points to the step that moves the guess onto them.
 */
#ifndef OCELLUS_CONE_STEP_H
#define OCELLUS_CONE_STEP_H

#include <stdbool.h>
#include <stdint.h>

#include "../base/sym3.h"
#include "cone_sums.h"

/* Weighted least squares in (x, y, radius); sums of weights are over OCEL_SECTORS. */
typedef struct {
    ocel_sym3_inverse_t inverse; /* of the normal equations */
    int32_t x_px_q24[3];         /* below 8 px */
    uint64_t misfit_q56;         /* weights times squares of what is left, px^2 */
    uint32_t sectors;            /* that had inliers */
} ocel_cone_step_t;

/* False, and x zero, when the inliers do not determine a step.  In `sums`, each sector's
 * low becomes the estimate of d there and high the width of what it may be in. */
bool ocel_cone_step(ocel_cone_sums_t *sums, ocel_cone_step_t *step);

/* How far the step moves the outline in a sector, px; below 24. */
int32_t ocel_cone_shift_q16(const ocel_cone_step_t *step, uint32_t sector);

#endif
