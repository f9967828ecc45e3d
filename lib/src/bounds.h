/* SPDX-License-Identifier: MIT
 *
 * Bounds around a range of one space in the channels of another: necessary,
 * cheap to test, and never tighter than the range.  The line tests reject by
 * them what they can and decide the rest exactly.
 */
#ifndef OCEL_BOUNDS_H
#define OCEL_BOUNDS_H

#include <stdint.h>

/* Channel k of every pixel in range is within lo[k] .. hi[k], both included.
 * Within 0..255 when made here; lo > hi when no pixel can be in range. */
typedef struct {
    int32_t lo[3];
    int32_t hi[3];
} ocel_bounds_t;

/* Channel `above` of every RGB pixel in range exceeds channel `below` by at
 * least `least`: what colour is and grey is not.  least 0 says nothing. */
typedef struct {
    uint32_t above; /* 0..2 for R, G, B */
    uint32_t below;
    int32_t least; /* 0..255 */
} ocel_lead_t;

/* R, G, B of the pixels whose grey is lo .. hi. */
ocel_bounds_t ocel_bounds_of_gray(uint32_t lo, uint32_t hi);

/* R, G, B of the pixels in an HSV range, which is as in ocel_colour_range_t. */
ocel_bounds_t ocel_bounds_of_hsv(const uint16_t lo[3], const uint16_t hi[3], ocel_lead_t *lead);

/* R, G, B of the pixels whose Y, U, V are within lo .. hi. */
ocel_bounds_t ocel_bounds_of_yuv(const uint16_t lo[3], const uint16_t hi[3], ocel_lead_t *lead);

/* Y, U, V of the pixels that convert to an R, G, B within bounds. */
ocel_bounds_t ocel_bounds_to_yuv(const ocel_bounds_t *rgb);

#endif
