/* SPDX-License-Identifier: MIT
 *
 * Symmetric 3x3 systems, in the order of OCEL_XX .. OCEL_ZZ.
 */
#ifndef OCELLUS_SYM3_H
#define OCELLUS_SYM3_H

#include <stdbool.h>
#include <stdint.h>

#include <ocellus/space.h>

#include "scale.h"

/* Where element (i, k) stands among the six. */
extern const uint8_t ocel_sym3_at[3][3];

/* A matrix's inverse: adjoint * determinant^-1. */
typedef struct {
    int64_t adjoint_q60[OCEL_SYM3_COUNT];
    ocel_scaled_t rate; /* 1 / determinant */
} ocel_sym3_inverse_t;

/* Inverts a positive definite matrix with entries of at most 1; false when its
 * determinant is below 2^-48.  A cofactor is the difference of two products of at
 * most 1; each product is floored, so it is off by less than 2^-59. */
bool ocel_sym3_invert(const int64_t m_q60[OCEL_SYM3_COUNT], ocel_sym3_inverse_t *inverse);

/* x = inverse * b, |b| <= 1; false, and x untouched, unless every |x| < 1. */
bool ocel_sym3_apply(const ocel_sym3_inverse_t *inverse, const int64_t b_q60[3], int64_t x_q60[3]);

#endif
