/* SPDX-License-Identifier: MIT */
#include "sym3.h"

#include "int_math.h"
#include "q60.h"

#define LEAST_Q60 4096

const uint8_t ocel_sym3_at[3][3] = {
    {OCEL_XX, OCEL_XY, OCEL_XZ}, {OCEL_XY, OCEL_YY, OCEL_YZ}, {OCEL_XZ, OCEL_YZ, OCEL_ZZ}};

/* Row i of a matrix times a vector. */
static int64_t row_times(const int64_t *m_q60, uint32_t i, const int64_t *v_q60) {
    return ocel_mul_q60(m_q60[ocel_sym3_at[i][0]], v_q60[0]) +
           ocel_mul_q60(m_q60[ocel_sym3_at[i][1]], v_q60[1]) +
           ocel_mul_q60(m_q60[ocel_sym3_at[i][2]], v_q60[2]);
}

/* Cofactor (i, k) is the minor of the two cyclically next rows and columns: their
 * order gives its sign. */
static int64_t cofactor(const int64_t *m_q60, uint32_t i, uint32_t k) {
    static const uint8_t next[4] = {1U, 2U, 0U, 1U};
    const uint32_t i1 = next[i];
    const uint32_t i2 = next[i + 1U];
    const uint32_t k1 = next[k];
    const uint32_t k2 = next[k + 1U];

    return ocel_mul_q60(m_q60[ocel_sym3_at[i1][k1]], m_q60[ocel_sym3_at[i2][k2]]) -
           ocel_mul_q60(m_q60[ocel_sym3_at[i1][k2]], m_q60[ocel_sym3_at[i2][k1]]);
}

bool ocel_sym3_invert(const int64_t m_q60[OCEL_SYM3_COUNT], ocel_sym3_inverse_t *inverse) {
    int64_t determinant;

    for (uint32_t i = 0U; i < 3U; i++) {    /* bound: 3 */
        for (uint32_t k = i; k < 3U; k++) { /* bound: 3 */
            inverse->adjoint_q60[ocel_sym3_at[i][k]] = cofactor(m_q60, i, k);
        }
    }
    determinant = row_times(m_q60, 0U, inverse->adjoint_q60);
    if (determinant >= LEAST_Q60) {
        ocel_recip_q60((uint64_t)determinant, &inverse->rate.y_q60, &inverse->rate.e);
    }
    return determinant >= LEAST_Q60;
}

bool ocel_sym3_apply(const ocel_sym3_inverse_t *inverse, const int64_t b_q60[3], int64_t x_q60[3]) {
    int64_t v_q60[3];
    uint64_t all = 0U;

    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 */
        v_q60[i] = ocel_mul_q60(ocel_asr64(row_times(inverse->adjoint_q60, i, b_q60), 2U),
                                inverse->rate.y_q60);
        all |= ocel_abs64(v_q60[i]);
    }
    /* x = 4 v 2^e: below 1 when v 2^e is below 1/4, so when v has e + 2 leading
     * zeros more than the four of a number below 1. */
    if ((int32_t)ocel_clz64(all) >= (inverse->rate.e + 6)) {
        for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 */
            x_q60[i] = ocel_scale_q60(v_q60[i], inverse->rate.e + 2);
        }
    }
    return (int32_t)ocel_clz64(all) >= (inverse->rate.e + 6);
}
