/* SPDX-License-Identifier: MIT
 *
 * The scatter matrix S = D^T D of the monomials 1, x, y, xx, xy, yy (paper,
 * eqs. 5 and 7) and its elimination, column by column.
 */
#ifndef OCELLUS_SCATTER_H
#define OCELLUS_SCATTER_H

#include <stdbool.h>
#include <stdint.h>

#include "../base/scale.h"
#include "moments.h"
#include "solution.h"

/* Columns: the constant and the linear monomials come first, so that three
 * eliminations leave the 3x3 problem of the quadratic ones. */
enum { OCEL_S_1 = 0, OCEL_S_X, OCEL_S_Y, OCEL_S_XX, OCEL_S_XY, OCEL_S_YY, OCEL_S_COUNT };

/* The lower triangle of S, row by row.  An eliminated column k holds the
 * Cholesky factor L from its diagonal down, and its inverse diagonal beside; the
 * rest holds the Schur complement.  Every entry stays within 1.02: S is positive
 * semi-definite with diagonal entries of at most 1.01, and so is each of its
 * complements, so by Cauchy-Schwarz no entry and no factor can outgrow its
 * diagonal. */
typedef struct {
    int64_t a_q60[(OCEL_S_COUNT * (OCEL_S_COUNT + 1)) / 2];
    int64_t inverse_q60[OCEL_S_COUNT]; /* y of y * 2^e; apart, for the stack's sake */
    int8_t inverse_e[OCEL_S_COUNT];    /* -1..30 */
} ocel_scatter_t;

/* The place of row i, column j <= i. */
static inline uint32_t ocel_scatter_at(uint32_t i, uint32_t j) {
    return ((i * (i + 1U)) / 2U) + j;
}

/* 1 / L[k][k]. */
static inline ocel_scaled_t ocel_scatter_inverse(const ocel_scatter_t *scatter, uint32_t k) {
    const ocel_scaled_t inverse = {scatter->inverse_q60[k], scatter->inverse_e[k]};

    return inverse;
}

/* Eliminates column k.  False, and nothing done, when the pivot is below
 * `least_q60` (>= 1): the column depends on those before it. */
bool ocel_scatter_eliminate(ocel_scatter_t *scatter, uint32_t k, int64_t least_q60);

/* Lays a solution's moments out as S, eliminates the constant and the linear columns,
 * and writes where the points lie on the way.  False when they are collinear. */
bool ocel_scatter_reduce(ocel_solution_t *solution, ocel_scatter_t *scatter);

#endif
