/* SPDX-License-Identifier: MIT
 *
 * Covariances of a position: symmetric, six elements in the order of sym3.h.
 */
#ifndef OCELLUS_COVARIANCE_H
#define OCELLUS_COVARIANCE_H

#include <stdint.h>

#include "../base/sym3.h"

typedef struct {
    int64_t row_q60[3][3];
} ocel_matrix_t;

/* C v.  |v| <= 1.51 in Q60, elements of C below 2^60. */
void ocel_cov_times(const int64_t cov[OCEL_SYM3_COUNT], const int64_t v_q60[3], int64_t product[3]);

/* sum += A C A^T. */
void ocel_cov_add_sandwich(const ocel_matrix_t *a, const int64_t cov[OCEL_SYM3_COUNT],
                           int64_t sum[OCEL_SYM3_COUNT]);

/* cov factor 2^shift, rounded up on the diagonal. */
void ocel_cov_scale(const int64_t cov[OCEL_SYM3_COUNT], int64_t factor_q60, int32_t shift,
                    int64_t out[OCEL_SYM3_COUNT]);

#endif
