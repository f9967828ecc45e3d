/* SPDX-License-Identifier: MIT
 *
 * The ball in space.
 */
#include <ocellus/sphere.h>

#include <stddef.h>
#include <string.h>

#include "../base/q60.h"
#include "../base/scale.h"
#include "cone_valid.h"

#define RANGE_MAX_U ((int64_t)0x40000000) /* 2^30 */

/* The distance R / sin = y * 2^e.  R is shifted up to [2^59, 2^60); sin is 2^-30 to 1,
 * so its inverse's exponent is 0..30, e is -59..1 and the distance below 2^61. */
static ocel_scaled_t distance_of(uint32_t sin_q30, int32_t radius_u) {
    const uint32_t up = ocel_clz64((uint64_t)radius_u) - 4U;
    ocel_scaled_t distance;

    ocel_recip_q60((uint64_t)sin_q30 << 30U, &distance.y_q60, &distance.e);
    distance.y_q60 = ocel_mul_q60(ocel_shl64(radius_u, up), distance.y_q60);
    distance.e -= (int32_t)up;
    return distance;
}

/* A covariance of more than the distance itself, which no fit vouches for, is left at
 * that, so that it cannot overflow. */
static int64_t bounded_q60(int64_t cov_q60) {
    int64_t bounded = (cov_q60 > OCEL_Q60_ONE) ? OCEL_Q60_ONE : cov_q60;

    bounded = (bounded < -OCEL_Q60_ONE) ? -OCEL_Q60_ONE : bounded;
    return bounded;
}

/* Components of the axis times the distance are within 2^30.  The covariance times
 * range^2 <= 2^60, upwards on the diagonal. */
static void put_centre(const ocel_cone_t *cone, const ocel_scaled_t *distance,
                       ocel_sphere_t *sphere) {
    const int64_t range_u = (int64_t)sphere->range_u;

    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 */
        const int64_t p =
            ocel_mul_q60((int64_t)cone->axis_cam_q30[i] * (int64_t)OCEL_ONE_Q30, distance->y_q60);

        sphere->p_cam_u[i] = (int32_t)ocel_scale_q60(p, distance->e);
    }
    for (uint32_t i = 0U; i < (uint32_t)OCEL_SYM3_COUNT; i++) { /* bound: OCEL_SYM3_COUNT = 6 */
        sphere->cov_cam_u2[i] = -ocel_mul_q60(-bounded_q60(cone->cov_q60[i]), range_u * range_u);
    }
}

ocel_status_t ocel_sphere_of_cone(const ocel_cone_t *cone, int32_t radius_u,
                                  ocel_sphere_t *sphere) {
    ocel_status_t status = OCEL_NULL_ARGUMENT;

    if (sphere != NULL) {
        (void)memset(sphere, 0, sizeof(*sphere));
    }
    if ((cone != NULL) && (sphere != NULL)) {
        status = OCEL_OUT_OF_RANGE;
        if ((radius_u >= 1) && ocel_cone_is_valid(cone)) {
            const ocel_scaled_t distance = distance_of(cone->sin_q30, radius_u);
            const int64_t range_u = ocel_scale_q60(distance.y_q60, distance.e);

            if (range_u <= RANGE_MAX_U) {
                sphere->radius_u = radius_u;
                sphere->range_u = (uint32_t)range_u;
                put_centre(cone, &distance, sphere);
                status = OCEL_OK;
            }
        }
    }
    return status;
}
