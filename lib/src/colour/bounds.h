/* SPDX-License-Identifier: MIT
 *
 * Bounds around a range of one space in the channels of another: necessary,
 * cheap to test, and never tighter than the range.  The line tests reject by
 * them what they can; what they pass is decided exactly.
 */
#ifndef OCEL_BOUNDS_H
#define OCEL_BOUNDS_H

#include <stdint.h>

/* Channel k of every pixel in range is within lo[k] .. hi[k], both included and
 * within 0..255; lo > hi when no pixel can be in range. */
typedef struct {
    uint16_t lo[3];
    uint16_t hi[3];
} ocel_bounds_t;

/* Of a range in HSV, whose lo and hi are as in ocel_colour_range_t, makes bounds
 * of R, G and B. */
void ocel_bounds_hsv_to_rgb(ocel_bounds_t *bounds);

/* Of bounds of Y, U and V makes bounds of R, G and B. */
void ocel_bounds_yuv_to_rgb(ocel_bounds_t *bounds);

/* Of bounds of R, G and B makes bounds of the Y, U, V that convert to these. */
void ocel_bounds_rgb_to_yuv(ocel_bounds_t *bounds);

#endif
