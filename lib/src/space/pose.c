/* SPDX-License-Identifier: MIT */
#include "pose.h"

#include <string.h>

#include "../base/int_math.h"

/* By Cauchy and Schwarz the sum, and each partial sum, is at most |a| |b|. */
int64_t ocel_dot(const int32_t a[3], const int32_t b[3]) {
    return ((int64_t)a[0] * b[0]) + ((int64_t)a[1] * b[1]) + ((int64_t)a[2] * b[2]);
}

/* |r v| <= (1 + 2^-20) 2^30 |v|: below 2^61.1. */
void ocel_pose_direction(const ocel_pose_t *X_A_B, const int32_t v_B[3], int32_t v_A[3]) {
    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
        v_A[i] = (int32_t)ocel_shift_round64(ocel_dot(X_A_B->r_q30[i], v_B), 30U);
    }
}

/* |r p_B| <= 2^30 * sqrt(3) 2^31, below 2^61.9; with p in Q30, at most 2^61, the
 * sum is below 2^62.6. */
bool ocel_pose_point(const ocel_pose_t *X_A_B, const int32_t p_B_u[3], int32_t p_A_u[3]) {
    bool inside = true;

    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
        const int64_t p_q30 =
            ocel_dot(X_A_B->r_q30[i], p_B_u) + ocel_shl64((int64_t)X_A_B->p_u[i], 30U);
        const int64_t p_u = ocel_shift_round64(p_q30, 30U);

        inside = inside && (ocel_abs64(p_u) <= OCEL_MAX_POSITION_U);
        p_A_u[i] = (int32_t)p_u;
    }
    if (!inside) {
        (void)memset(p_A_u, 0, 3U * sizeof(p_A_u[0]));
    }
    return inside;
}
