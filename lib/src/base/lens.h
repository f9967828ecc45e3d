/* SPDX-License-Identifier: MIT
 *
 * The lens: from the ray's slopes to where it puts them, and back.
 */
#ifndef OCELLUS_LENS_H
#define OCELLUS_LENS_H

#include <stdbool.h>
#include <stdint.h>

#include <ocellus/camera.h>

/* 80 degrees off the axis: the tangent (rounded down), and its square. */
#define OCEL_TAN_80_Q28 1522373121
#define OCEL_TAN2_80_Q56 ((int64_t)OCEL_TAN_80_Q28 * OCEL_TAN_80_Q28)

/* True when the slopes' squares sum to `reach_q56` at most; any slopes.  The squares
 * are taken only of slopes within 80 degrees, which makes each 2^61.1 at most. */
bool ocel_lens_within(const int64_t xy_q28[2], int64_t reach_q56);

/* The square of the largest slope up to which the radial map rises, and so can
 * be undone; OCEL_TAN2_80_Q56 when it never folds. */
int64_t ocel_lens_reach_q56(const ocel_intrinsics_t *lens);

/* The lens on a ray within 80 degrees.  |bent| < 2^22; error below 2^-28 of the
 * slopes for lenses as they are made (factors below 2). */
void ocel_lens_bend(const ocel_intrinsics_t *lens, const int64_t xy_q28[2], int64_t bent_q40[2]);

/* Undoes the lens in place, in OCEL_UNDISTORT_STEPS steps; any slopes.  False when
 * they lie over 80 degrees off the axis, a step leads there, or the lens does not
 * put the result within 1/64 px of where it came from. */
bool ocel_lens_unbend(const ocel_intrinsics_t *lens, int64_t xy_q28[2]);

#endif
