/* SPDX-License-Identifier: MIT
 *
 * Numbers with an exponent of their own, for what has no natural scale: the
 * inverse of a pivot, the residual of a perfect fit.
 */
#ifndef OCELLUS_SCALE_H
#define OCELLUS_SCALE_H

#include <stdint.h>

/* A number y * 2^e, y in Q60. */
typedef struct {
    int64_t y_q60;
    int32_t e;
} ocel_scaled_t;

/* value * 2^e, -62 <= e <= 62, rounded to nearest when e < 0.  The caller
 * bounds |value| * 2^e below 2^63. */
int64_t ocel_scale_q60(int64_t value, int32_t e);

#endif
