/* SPDX-License-Identifier: MIT */
#include "vec3.h"

#include "../base/q60.h"

void ocel_cross_q60(const int64_t a[3], const int64_t b[3], int64_t product[3]) {
    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
        const uint32_t j = (i == 2U) ? 0U : (i + 1U);
        const uint32_t k = (j == 2U) ? 0U : (j + 1U);

        product[i] = ocel_mul_q60(a[j], b[k]) - ocel_mul_q60(a[k], b[j]);
    }
}

int64_t ocel_dot_q60(const int64_t a[3], const int64_t b[3]) {
    return ocel_mul_q60(a[0], b[0]) + ocel_mul_q60(a[1], b[1]) + ocel_mul_q60(a[2], b[2]);
}
