/* SPDX-License-Identifier: MIT
 *
 * The robust cone fit of the library (DESIGN.md) in double precision, written for
 * clarity and not for speed: what fixed point may cost is measured against it.
 * For a camera without a lens.
 */
#ifndef REFERENCE_CONE_REFERENCE_H
#define REFERENCE_CONE_REFERENCE_H

#include <stdbool.h>
#include <stddef.h>

#include "reference/reference.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    double fx;
    double fy;
    double cx;
    double cy;
} ref_camera_t;

typedef struct {
    double axis[3];     /* unit vector, camera's frame */
    double sine;        /* of half the opening angle */
    double range_sigma; /* standard deviation of the range over the range; 1: not known */
    double rms_px;      /* of the inliers */
    double coverage;    /* fraction of the turn */
    size_t inliers;
    bool vouched;
} ref_cone_t;

/* False when no three of the samples determine a cone.  Cracks are told by their midpoints:
 * the coordinate along the crack is a half. */
bool ref_cone_fit(const ref_camera_t *camera, const ref_point_t *points, size_t count, bool cracks,
                  ref_cone_t *cone);

#ifdef __cplusplus
}
#endif

#endif
