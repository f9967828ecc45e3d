/* SPDX-License-Identifier: MIT
 *
 * Specks: holes of one pixel and components of one pixel, found as bits.
 */
#ifndef OCEL_SPECKS_H
#define OCEL_SPECKS_H

#include <stdint.h>

#include <ocellus/labeller.h>

/* Where one of three rows of the labeller stands: 0 the row above, 1 the row
 * held, 2 the row below it. */
static inline uint32_t ocel_specks_row(const ocel_labeller_t *lab, uint32_t which) {
    const uint32_t at = lab->above + which;

    return (at < 3U) ? at : (at - 3U);
}

/* Sweeps over the row that is held, without its specks: fills its holes of one
 * pixel, which are left out of the sums, and takes out its components of one
 * pixel, which are only counted, unless there is no largest component yet: one of
 * them may be it.  All count among the runs.
 *
 * A hole has only pixels of the object around it and an isolated pixel none,
 * across sides and corners where the object is connected that way, else across
 * sides.  What is beyond the image is background.  The row above may have been
 * treated, or not. */
void ocel_specks_sweep(ocel_labeller_t *lab, ocel_crack_pool_t *pool);

#endif
