/* SPDX-License-Identifier: MIT
 *
 * The sweep over a row.
 */
#ifndef OCEL_SWEEP_H
#define OCEL_SWEEP_H

#include <stdint.h>

#include <ocellus/labeller.h>

#include "frontier.h"

/* Sweeps over the next row, lab->rows[lab->above]: the runs above that it touches
 * hand on to its runs, the others end, and its pixels are added to their components.
 *   holes  pixels of the row that are to be left out of the sums, bit x%32 of word
 *          x/32 counted from the row's first, and one beyond its pixels; null when
 *          there are none.
 *   ended  where components that end above the row are reported. */
void ocel_sweep_row(ocel_labeller_t *lab, ocel_crack_pool_t *pool, const uint32_t *holes,
                    ocel_ended_t *ended);

/* Sweeps over the next row when its runs are those of the row above: each hands
 * on to the one below it.  Its pixels are added when a row comes that is not. */
void ocel_sweep_repeat(ocel_labeller_t *lab, ocel_crack_pool_t *pool);

#endif
