/* SPDX-License-Identifier: MIT
 *
 * Moments of the points up to the fourth order, in a frame in which they fill
 * the square [-1, 1] x [-1, 1]: all that the fits need to know of them.
 */
#ifndef OCELLUS_MOMENTS_H
#define OCELLUS_MOMENTS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <ocellus/status.h>
#include <ocellus/types.h>

#include "solution.h"

/* Places of the moments among a solution's: OCEL_M_XY is the mean of x*y, and so on; sums
 * divided by 2^ceil(log2 n), Q60, |.| <= 1.01. */
enum {
    OCEL_M_1 = 0,
    OCEL_M_X,
    OCEL_M_Y,
    OCEL_M_XX,
    OCEL_M_XY,
    OCEL_M_YY,
    OCEL_M_XXX,
    OCEL_M_XXY,
    OCEL_M_XYY,
    OCEL_M_YYY,
    OCEL_M_XXXX,
    OCEL_M_XXXY,
    OCEL_M_XXYY,
    OCEL_M_XYYY,
    OCEL_M_YYYY,
    OCEL_M_COUNT
};
typedef char ocel_assert_moments_t
    [((uint32_t)OCEL_M_COUNT <= (uint32_t)(OCEL_F_PLACES - OCEL_F_MOMENTS)) ? 1 : -1];

/* Points to be read, of one kind or the other. */
typedef struct {
    const ocel_point_t *points; /* null: cracks */
    const ocel_crack_t *cracks;
    size_t count;
} ocel_source_t;

/* A point in Q16 px; as wide as the arithmetic that follows. */
typedef struct {
    int64_t x;
    int64_t y;
} ocel_pair_t;

/* Point i in Q16 px, i < count. */
static inline ocel_pair_t ocel_source_px_q16(const ocel_source_t *source, size_t i) {
    ocel_pair_t p;

    if (source->points != NULL) {
        p.x = source->points[i].x_px_q16;
        p.y = source->points[i].y_px_q16;
    } else {
        p.x = (int64_t)source->cracks[i].x_hpx * 32768;
        p.y = (int64_t)source->cracks[i].y_hpx * 32768;
    }
    return p;
}

/* Frame and moments of cracks by exact 64-bit sums about a point amid them, in one pass,
 * each axis scaled by a power of two to a mean fourth power of at most 1.
 * Maini's box would cost a second pass and, the fits being affine invariant,
 * change nothing.
 * At least one crack.  False, and nothing usable, when the sums might not fit: the
 * squared offsets from the point midway between the first and the middle crack sum to
 * 2^31 half pixels squared or more (discs of R > 512 px). */
bool ocel_moments_of_cracks(const ocel_crack_t *cracks, size_t count, ocel_solution_t *solution);

/* Frame and moments of any points by 128-bit sums, sheared so that x and y do not
 * correlate; `perturb` applies the LCSE perturbation in Maini's frame instead.
 * OCEL_OK, OCEL_DEGENERATE (no width or no height), OCEL_OUT_OF_RANGE. */
ocel_status_t ocel_moments_of_source(const ocel_source_t *source, bool perturb,
                                     ocel_solution_t *solution);

#endif
