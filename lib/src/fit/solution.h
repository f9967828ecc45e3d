/* SPDX-License-Identifier: MIT
 *
 * What a fit finds, number by number: an array, so that the formulas about it can be
 * tables (base/terms.h).
 */
#ifndef OCELLUS_SOLUTION_H
#define OCELLUS_SOLUTION_H

#include <stdint.h>

/* The conic A xx + B xy + C yy + D x + E y + F = 0 in the normalised frame, scaled so
 * that A + C = 1: A = (1 + v) / 2, B = w, C = (1 - v) / 2.  So 4AC - B^2 is
 * 1 - v^2 - w^2: an ellipse is a point inside the unit disc of (v, w), a circle its
 * centre.
 *
 * Where the points lie: their mean and their covariance.
 *
 * The affine map from the normalised frame to the image, G lower triangular:
 *   (x, y) px = ((x0, y0) in Q24) + 2^scale_log2 * G * (u, v), G in Q17 px.
 *
 * Q60 but where another format is named. */
enum {
    OCEL_F_V = 0,
    OCEL_F_W,
    OCEL_F_FLATNESS, /* 1 - v^2 - w^2: 1 for a circle, 0 for a parabola */
    OCEL_F_D_Q48,    /* |D|, |E| < 2^10 */
    OCEL_F_E_Q48,
    OCEL_F_MEAN,     /* mean of the conic's polynomial over the points */
    OCEL_F_ENERGY,   /* mean of its square, times the points' weight, over 2^energy_e */
    OCEL_F_ENERGY_E, /* a whole number */
    OCEL_F_WEIGHT,   /* inverse of S[1][1]: 2^ceil(log2 n) / n, in [1, 2) */
    OCEL_F_X,
    OCEL_F_Y,
    OCEL_F_XX,
    OCEL_F_XY,
    OCEL_F_YY,
    OCEL_F_X0_Q24, /* px, |.| <= 2^42 */
    OCEL_F_Y0_Q24,
    OCEL_F_G11,        /* 2^24 LSB to 1/2 */
    OCEL_F_G21,        /* within 1/2 */
    OCEL_F_G22,        /* 1 LSB to 1/2 */
    OCEL_F_SCALE_LOG2, /* a whole number, 17..36 */
    OCEL_F_COUNT
};

/* The points' moments (moments.h), until the conic is found. */
enum { OCEL_F_MOMENTS = OCEL_F_COUNT, OCEL_F_PLACES = OCEL_F_MOMENTS + 15 };

/* In their place then, on the way to the ellipse: the quadratic part
 * [1+v w; w 1-v] = 2 [A B/2; B/2 C], each entry below 2, and each step's own. */
enum { OCEL_F_FORM_XX = OCEL_F_COUNT, OCEL_F_FORM_YY, OCEL_F_FREE };

typedef struct {
    int64_t q60[OCEL_F_PLACES];
} ocel_solution_t;

#endif
