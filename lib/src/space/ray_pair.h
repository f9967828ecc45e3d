/* SPDX-License-Identifier: MIT
 *
 * Two lines of sight and where they come closest.
 */
#ifndef OCELLUS_RAY_PAIR_H
#define OCELLUS_RAY_PAIR_H

#include <stdbool.h>

#include <ocellus/stereo.h>

#include "vec3.h"

/* The least sine between two rays, 2^-12: at 68 mm of baseline 278 m. */
#define OCEL_LEAST_SINE_Q30 ((int32_t)0x40000)

typedef struct {
    int64_t p_q30[3]; /* u, at most 2^58 each */
    int64_t d_q60[3];
} ocel_line_t;

/* False for what is no ray: a unit vector to 2^-17, that begins within the stated
 * positions.  Three squares of up to 2^62 fit uint64_t; the sums wrap on purpose. */
bool ocel_line_of(const int32_t p_u[3], const int32_t d_q30[3], ocel_line_t *line);

typedef struct {
    int64_t half_q60[3];   /* half of d_left x d_right, which is the sine times the normal */
    int64_t normal_q60[3]; /* its unit vector */
    int64_t y_q60;         /* 2 / sine = y 2^e, e 1 .. 13 */
    int32_t e;
    int64_t gap_q30;  /* u, along the normal */
    int64_t t_q30[2]; /* along each ray to the closest approach, u: 2^30 .. 2^58 */
} ocel_crossing_t;

/* The closest approach of p_l + t_l d_l and p_r + t_r d_r.  With w = p_r - p_l and
 * n = d_l x d_r: t_l = (w x d_r) . n / n^2, t_r = (w x d_l) . n / n^2, and the gap is
 * w . n / |n|; none of it asks that the directions' length be 1 exactly.
 *
 * n / 2 is at most 2^59 and off by 2^-60; its square, 2^-26 or more, by 3 LSB: 2^-32 of
 * it at the least sine.  |n / 2| 2^e is 1 / y, within 1 and 2.01: halved it is fit for the
 * product, and the normal at most 1.01.  w is at most sqrt(3) 2^59 long, so are its
 * products; t / 2^e is held below 2^(58 - e). */
ocel_status_t ocel_line_cross(const ocel_line_t *left, const ocel_line_t *right,
                              ocel_crossing_t *c);

/* The point half-way and the gap.  Four terms of at most 2^58.1; the gap is at most |w|. */
uint32_t ocel_line_between(const ocel_line_t *left, const ocel_line_t *right,
                           const ocel_crossing_t *c, int32_t p_u[3]);

#endif
