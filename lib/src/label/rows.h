/* SPDX-License-Identifier: MIT
 *
 * The way of the rows through the labeller: each is held until the next one is
 * there, so that its specks can be told, and then swept.
 */
#ifndef OCEL_ROWS_H
#define OCEL_ROWS_H

#include <stdint.h>

#include <ocellus/labeller.h>

#include "frontier.h"

/* Takes the next row: sweeps over the one that was held, without its specks, and
 * holds this one.  When the caller asks what has ended it is swept over at once,
 * as it is: specks are components too.  row is null at the frame's end: a row
 * without a pixel, so that everything ends. */
void ocel_rows_take(ocel_labeller_t *lab, ocel_crack_pool_t *pool, const uint32_t *row,
                    ocel_ended_t *ended);

#endif
