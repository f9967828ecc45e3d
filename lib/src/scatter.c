/* SPDX-License-Identifier: MIT */
#include "scatter.h"

#include "int_math.h"
#include "q60.h"

/* The least variance of x, and of y given x, relative to the unit square.
 * Rounding leaves about 2^-57; half a pixel across 4096 is 2^-26. */
#define COLLINEAR_Q60 ((int64_t)1 << 18)

/* Lays the moments out as S. */
static void fill(const ocel_moments_t *moments, ocel_scatter_t *scatter) {
    /* The moment that each product of two monomials is, row by row. */
    static const uint8_t place[OCEL_S_COUNT][OCEL_S_COUNT] = {
        {OCEL_M_1, 0, 0, 0, 0, 0},
        {OCEL_M_X, OCEL_M_XX, 0, 0, 0, 0},
        {OCEL_M_Y, OCEL_M_XY, OCEL_M_YY, 0, 0, 0},
        {OCEL_M_XX, OCEL_M_XXX, OCEL_M_XXY, OCEL_M_XXXX, 0, 0},
        {OCEL_M_XY, OCEL_M_XXY, OCEL_M_XYY, OCEL_M_XXXY, OCEL_M_XXYY, 0},
        {OCEL_M_YY, OCEL_M_XYY, OCEL_M_YYY, OCEL_M_XXYY, OCEL_M_XYYY, OCEL_M_YYYY}};
    uint32_t i;
    uint32_t j;

    for (i = 0U; i < (uint32_t)OCEL_S_COUNT; i++) { /* bound: OCEL_S_COUNT */
        for (j = 0U; j <= i; j++) {                 /* bound: OCEL_S_COUNT */
            scatter->a_q60[i][j] = moments->m_q60[place[i][j]];
        }
    }
}

/* L[i][k] = a[i][k] / sqrt(pivot): |L[i][k]| <= sqrt(a[i][i]) <= 1.01, so the
 * shift by e <= 30 cannot overflow.  Errors: a few LSB of a, times 2^e. */
bool ocel_scatter_eliminate(ocel_scatter_t *scatter, uint32_t k, int64_t least_q60) {
    const int64_t pivot = scatter->a_q60[k][k];
    const bool independent = (pivot >= least_q60);
    uint32_t i;
    uint32_t j;

    if (independent) {
        ocel_scaled_t *const inverse = &scatter->inverse[k];

        ocel_rsqrt_q60((uint64_t)pivot, &inverse->y_q60, &inverse->e);
        scatter->a_q60[k][k] = ocel_scale_q60(ocel_mul_q60(pivot, inverse->y_q60), inverse->e);
        for (i = k + 1U; i < (uint32_t)OCEL_S_COUNT; i++) { /* bound: OCEL_S_COUNT */
            int64_t *const row = scatter->a_q60[i];

            row[k] = ocel_scale_q60(ocel_mul_q60(row[k], inverse->y_q60), inverse->e);
            for (j = k + 1U; j <= i; j++) { /* bound: OCEL_S_COUNT */
                row[j] -= ocel_mul_q60(row[k], scatter->a_q60[j][k]);
            }
        }
    }
    return independent;
}

bool ocel_scatter_reduce(const ocel_moments_t *moments, ocel_scatter_t *scatter) {
    bool independent;

    fill(moments, scatter);
    independent = ocel_scatter_eliminate(scatter, (uint32_t)OCEL_S_1, 1);
    scatter->covariance_xx_q60 = scatter->a_q60[OCEL_S_X][OCEL_S_X];
    scatter->covariance_xy_q60 = scatter->a_q60[OCEL_S_Y][OCEL_S_X];
    scatter->covariance_yy_q60 = scatter->a_q60[OCEL_S_Y][OCEL_S_Y];
    if (independent) {
        independent = ocel_scatter_eliminate(scatter, (uint32_t)OCEL_S_X, COLLINEAR_Q60);
    }
    if (independent) {
        independent = ocel_scatter_eliminate(scatter, (uint32_t)OCEL_S_Y, COLLINEAR_Q60);
    }
    return independent;
}
