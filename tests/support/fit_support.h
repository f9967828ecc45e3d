/* SPDX-License-Identifier: MIT
 *
 * Between the library's fixed point and the tests' doubles.
 */
#ifndef SUPPORT_FIT_SUPPORT_H
#define SUPPORT_FIT_SUPPORT_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <ocellus/ocellus.h>

#include "reference/reference.h"

#define FIT_PI 3.14159265358979323846

static inline int32_t fit_to_q16(double v) {
    return (int32_t)lround(v * 65536.0);
}

static inline double fit_from_q16(double v_q16) {
    return v_q16 / 65536.0;
}

/* Rounds the points to the input format, in both forms, so that the library and
 * the reference see the same points. */
static inline void fit_round_points(ref_point_t *points, ocel_point_t *fixed, size_t count) {
    for (size_t i = 0; i < count; i++) {
        fixed[i].x_px_q16 = fit_to_q16(points[i].x);
        fixed[i].y_px_q16 = fit_to_q16(points[i].y);
        points[i].x = fit_from_q16(fixed[i].x_px_q16);
        points[i].y = fit_from_q16(fixed[i].y_px_q16);
    }
}

static inline void fit_cracks_to_points(const ocel_crack_t *cracks, size_t count,
                                        ref_point_t *points) {
    for (size_t i = 0; i < count; i++) {
        points[i].x = cracks[i].x_hpx / 2.0;
        points[i].y = cracks[i].y_hpx / 2.0;
    }
}

static inline double fit_angle(const ocel_ellipse_t *e) {
    return (double)e->angle_turn_q32 * (2.0 * FIT_PI / 4294967296.0);
}

static inline ref_ellipse_t fit_to_double(const ocel_ellipse_t *e) {
    ref_ellipse_t r;
    r.cx = fit_from_q16(e->cx_px_q16);
    r.cy = fit_from_q16(e->cy_px_q16);
    r.a = fit_from_q16(e->a_px_q16);
    r.b = fit_from_q16(e->b_px_q16);
    r.angle = fit_angle(e);
    return r;
}

static inline double fit_centre_distance(const ref_ellipse_t *p, const ref_ellipse_t *q) {
    return hypot(p->cx - q->cx, p->cy - q->cy);
}

static inline double fit_axes_distance(const ref_ellipse_t *p, const ref_ellipse_t *q) {
    return fmax(fabs(p->a - q->a), fabs(p->b - q->b));
}

/* Difference of two axis angles, radians, [0, pi/2]. */
static inline double fit_angle_distance(double p, double q) {
    const double d = fmod(fabs(p - q), FIT_PI);
    return fmin(d, FIT_PI - d);
}

/* Member by member: padding bytes are nobody's. */
static inline bool fit_same_bits(const ocel_ellipse_t *p, const ocel_ellipse_t *q) {
    return (p->cx_px_q16 == q->cx_px_q16) && (p->cy_px_q16 == q->cy_px_q16) &&
           (p->a_px_q16 == q->a_px_q16) && (p->b_px_q16 == q->b_px_q16) &&
           (p->angle_turn_q32 == q->angle_turn_q32) && (p->rms_px_q16 == q->rms_px_q16) &&
           (p->centre_sigma_px_q16 == q->centre_sigma_px_q16) &&
           (p->arc_coverage_q16 == q->arc_coverage_q16) && (p->point_count == q->point_count) &&
           (p->method == q->method) && (p->perturbed == q->perturbed);
}

static inline bool fit_is_zero(const ocel_ellipse_t *p) {
    const ocel_ellipse_t zero = {0, 0, 0, 0, 0, 0, 0, 0, 0, OCEL_FIT_B2AC, false};
    return fit_same_bits(p, &zero);
}

/* Options for points of which nothing is promised (`closed` false). */
static inline ocel_fit_options_t fit_options(ocel_fit_method_t method, ocel_perturb_t perturb) {
    ocel_fit_options_t options;
    options.method = method;
    options.perturb = perturb;
    options.closed = false;
    return options;
}

/* A fit gave an ellipse: vouched for, or an estimate. */
static inline bool fit_has_ellipse(ocel_status_t status) {
    return (status == OCEL_OK) || (status == OCEL_PARTIAL);
}

#endif
