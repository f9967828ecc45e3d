/* SPDX-License-Identifier: MIT
 *
 * How much of the ellipse the points cover, and what that does to the centre.
 */
#ifndef OCELLUS_ARC_H
#define OCELLUS_ARC_H

#include <stdint.h>

#include <ocellus/types.h>

#include "../base/sector.h"
#include "moments.h"
#include "solution.h"

/* Sectors, 0..32 (sector.h), that the points cover as seen from the ellipse's centre, in a
 * frame in which the ellipse is a circle.  r: as ocel_ellipse_of_conic leaves it. */
uint32_t ocel_arc_sectors(const ocel_source_t *source, int64_t *r_q60,
                          const ocel_ellipse_t *ellipse);

/* Writes arc_coverage and centre_sigma of an ellipse whose residual and point
 * count are there. */
void ocel_arc_judge(uint32_t sectors, ocel_ellipse_t *ellipse);

#endif
