/* SPDX-License-Identifier: MIT
 *
 * The ball in space: a cone and a known radius give its centre.
 */
#ifndef OCELLUS_SPHERE_H
#define OCELLUS_SPHERE_H

#include <ocellus/cone.h>
#include <ocellus/space.h>
#include <ocellus/status.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    int32_t p_cam_u[3];                  /* the centre */
    int32_t radius_u;                    /* as given */
    uint32_t range_u;                    /* the centre's distance */
    int64_t cov_cam_u2[OCEL_SYM3_COUNT]; /* covariance of the centre, rounded up on the diagonal */
} ocel_sphere_t;

/* Places a ball of known radius: centre = axis * radius / sin.
 *   sphere  out; zero unless OCEL_OK.
 * OCEL_OK
 * OCEL_OUT_OF_RANGE   radius_u < 1, a cone without an angle, or a distance over 2^30 u
 * OCEL_NULL_ARGUMENT  a pointer is null */
ocel_status_t ocel_sphere_of_cone(const ocel_cone_t *cone, int32_t radius_u, ocel_sphere_t *sphere);

#ifdef __cplusplus
}
#endif

#endif
