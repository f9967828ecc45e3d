/* SPDX-License-Identifier: MIT */
#include "scatter.h"

#include "../base/int_math.h"
#include "../base/q60.h"

/* The least variance of x, and of y given x, relative to the unit square.
 * Rounding leaves about 2^-57; half a pixel across 4096 is 2^-26. */
#define COLLINEAR_Q60 ((int64_t)0x40000)

#define TRIANGLE ((OCEL_S_COUNT * (OCEL_S_COUNT + 1)) / 2)

/* L[i][k] = a[i][k] / sqrt(pivot): |L[i][k]| <= sqrt(a[i][i]) <= 1.01, so the
 * shift by e <= 30 cannot overflow.  Errors: a few LSB of a, times 2^e. */
bool ocel_scatter_eliminate(ocel_scatter_t *scatter, uint32_t k, int64_t least_q60) {
    int64_t *const diagonal = &scatter->a_q60[ocel_scatter_at(k, k)];
    const bool independent = (*diagonal >= least_q60);

    if (independent) {
        ocel_scaled_t inverse;
        int64_t *row = diagonal - k;
        uint32_t i;

        ocel_rsqrt_q60((uint64_t)*diagonal, &inverse.y_q60, &inverse.e);
        scatter->inverse_q60[k] = inverse.y_q60;
        scatter->inverse_e[k] = (int8_t)inverse.e;
        for (i = k; i < (uint32_t)OCEL_S_COUNT; i++) { /* bound: OCEL_S_COUNT */
            const int64_t *other = diagonal;           /* column k, from row k + 1 down */
            uint32_t j;

            row[k] = ocel_scale_q60(ocel_mul_q60(row[k], inverse.y_q60), inverse.e);
            for (j = k + 1U; j <= i; j++) { /* bound: OCEL_S_COUNT */
                other += j;
                row[j] -= ocel_mul_q60(row[k], *other);
            }
            row += i + 1U; /* the next row of the triangle */
        }
    }
    return independent;
}

/* Mean and covariance, when the constant's column has been eliminated:
 * L[1][1] = sqrt(weight), L[x][1] = weighted mean / sqrt(weight). */
static void read_spread(const ocel_scatter_t *scatter, ocel_solution_t *solution) {
    /* x, y, xx, xy, yy in the triangle */
    static const uint8_t place[5] = {1U, 3U, 2U, 4U, 5U};
    int64_t *const q = solution->q60;
    const ocel_scaled_t inverse = ocel_scatter_inverse(scatter, OCEL_S_1);
    const int64_t root = ocel_scale_q60(inverse.y_q60, inverse.e); /* in [1, 1.42] */
    const int64_t weight = ocel_mul_q60(root, root);

    q[OCEL_F_WEIGHT] = weight;
    for (uint32_t i = 0U; i < 5U; i++) { /* bound: 5 */
        q[OCEL_F_X + i] = ocel_mul_q60(scatter->a_q60[place[i]], (i < 2U) ? root : weight);
    }
}

bool ocel_scatter_reduce(ocel_solution_t *solution, ocel_scatter_t *scatter) {
    /* The moment that each product of two monomials is. */
    static const uint8_t place[TRIANGLE] = {
        OCEL_M_1,    OCEL_M_X,   OCEL_M_XX,   OCEL_M_Y,   OCEL_M_XY,   OCEL_M_YY,   OCEL_M_XX,
        OCEL_M_XXX,  OCEL_M_XXY, OCEL_M_XXXX, OCEL_M_XY,  OCEL_M_XXY,  OCEL_M_XYY,  OCEL_M_XXXY,
        OCEL_M_XXYY, OCEL_M_YY,  OCEL_M_XYY,  OCEL_M_YYY, OCEL_M_XXYY, OCEL_M_XYYY, OCEL_M_YYYY};
    bool independent;
    uint32_t i;

    for (i = 0U; i < (uint32_t)TRIANGLE; i++) { /* bound: TRIANGLE */
        scatter->a_q60[i] = solution->q60[OCEL_F_MOMENTS + place[i]];
    }
    (void)ocel_scatter_eliminate(scatter, (uint32_t)OCEL_S_1, 1); /* weight >= 1/2 */
    read_spread(scatter, solution);
    independent = ocel_scatter_eliminate(scatter, (uint32_t)OCEL_S_X, COLLINEAR_Q60);
    if (independent) {
        independent = ocel_scatter_eliminate(scatter, (uint32_t)OCEL_S_Y, COLLINEAR_Q60);
    }
    return independent;
}
