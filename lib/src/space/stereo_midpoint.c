/* SPDX-License-Identifier: MIT */
#include <ocellus/stereo.h>

#include <stddef.h>
#include <string.h>

#include "../base/int_math.h"
#include "ray_pair.h"

ocel_status_t ocel_stereo_midpoint(const ocel_ray_t *ray_left, const ocel_ray_t *ray_right,
                                   ocel_midpoint_t *midpoint) {
    ocel_status_t status = OCEL_NULL_ARGUMENT;

    if (midpoint != NULL) {
        (void)memset(midpoint, 0, sizeof(*midpoint));
    }
    if ((ray_left != NULL) && (ray_right != NULL) && (midpoint != NULL)) {
        ocel_line_t left;
        ocel_line_t right;
        ocel_crossing_t c;
        bool within;

        status = OCEL_OUT_OF_RANGE;
        within = ocel_line_of(ray_left->p_u, ray_left->d_q30, &left);
        if (ocel_line_of(ray_right->p_u, ray_right->d_q30, &right) && within) {
            status = ocel_line_cross(&left, &right, &c);
        }
        if (status == OCEL_OK) {
            midpoint->gap_u = ocel_line_between(&left, &right, &c, midpoint->p_u);
            for (uint32_t i = 0U; i < 2U; i++) { /* bound: 2 eyes */
                midpoint->range_u[i] = (uint32_t)ocel_shift_round64(c.t_q30[i], 30U);
            }
        }
    }
    return status;
}
