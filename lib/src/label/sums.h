/* SPDX-License-Identifier: MIT
 *
 * The pixels of a row are added to their components.
 */
#ifndef OCEL_SUMS_H
#define OCEL_SUMS_H

#include <stdint.h>

#include <ocellus/labeller.h>

/* Adds the frontier's runs, which are those of the row in hand, to their components.
 * Labels that were merged away give way to their roots.
 *   holes  pixels that were filled and are left out, as in ocel_sweep_row. */
void ocel_sums_add_row(ocel_labeller_t *lab, const uint32_t *holes);

/* Adds the frontier's runs in the rows that repeated it. */
void ocel_sums_add_repeats(ocel_labeller_t *lab);

#endif
