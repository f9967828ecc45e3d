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

/* One step from the guess.  Writes all of the cone but its point count, which is read; of
 * `sums` what ocel_cone_step does.  True when the cone can be vouched for. */
bool ocel_cone_refine(ocel_cone_sums_t *sums, const ocel_cone_guess_t *guess, ocel_cone_t *cone);

#endif
