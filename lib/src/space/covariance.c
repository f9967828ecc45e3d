/* SPDX-License-Identifier: MIT */
#include "covariance.h"

#include "../base/q60.h"
#include "../base/scale.h"
#include "vec3.h"

void ocel_cov_times(const int64_t cov[OCEL_SYM3_COUNT], const int64_t v_q60[3],
                    int64_t product[3]) {
    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
        const int64_t row[3] = {cov[ocel_sym3_at[i][0]], cov[ocel_sym3_at[i][1]],
                                cov[ocel_sym3_at[i][2]]};

        product[i] = ocel_dot_q60(row, v_q60);
    }
}

void ocel_cov_add_sandwich(const ocel_matrix_t *a, const int64_t cov[OCEL_SYM3_COUNT],
                           int64_t sum[OCEL_SYM3_COUNT]) {
    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
        int64_t product[3];

        ocel_cov_times(cov, a->row_q60[i], product); /* row i of A C */
        for (uint32_t j = i; j < 3U; j++) {          /* bound: 3 axes */
            sum[ocel_sym3_at[i][j]] += ocel_dot_q60(product, a->row_q60[j]);
        }
    }
}

void ocel_cov_scale(const int64_t cov[OCEL_SYM3_COUNT], int64_t factor_q60, int32_t shift,
                    int64_t out[OCEL_SYM3_COUNT]) {
    for (uint32_t k = 0U; k < (uint32_t)OCEL_SYM3_COUNT; k++) { /* bound: 6 elements */
        out[k] = ocel_scale_q60(ocel_mul_q60(cov[k], factor_q60), shift);
    }
    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
        out[ocel_sym3_at[i][i]]++;
    }
}
