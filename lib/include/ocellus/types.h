/* SPDX-License-Identifier: MIT
 *
 * The data in which the stages meet.  Plain structs, no pointers inside, so
 * they can be copied, stored and compared.
 *
 * Conventions, everywhere: pixel (0,0) has its centre at (0,0), x right, y
 * down; a pixel covers +-0.5.  `_hpx` is in half pixels (an integer that is
 * twice the coordinate), `_px_q16` in pixels times 65536.
 */
#ifndef OCELLUS_TYPES_H
#define OCELLUS_TYPES_H

#include <stdbool.h>
#include <stdint.h>

#include <ocellus/config.h>

/* The midpoint of a crack, the unit edge between a pixel inside and one
 * outside: one coordinate is a whole pixel, the other a half. */
typedef struct {
    int16_t x_hpx; /* -1 .. 2*4096-1 */
    int16_t y_hpx; /* -1 .. 2*4096-1 */
} ocel_crack_t;

/* A point anywhere, |x| and |y| <= OCEL_MAX_COORDINATE_PX. */
typedef struct {
    int32_t x_px_q16;
    int32_t y_px_q16;
} ocel_point_t;

/* A rectangle of whole pixels. */
typedef struct {
    uint16_t left;
    uint16_t top;
    uint16_t width;
    uint16_t height;
} ocel_rect_t;

/* One connected component.  The sums run over its pixels, exactly; at
 * 4096x4096 the largest, sum_xx, is below 2^24 * 2^24 = 2^48. */
typedef struct {
    ocel_rect_t box;
    uint16_t first_x;  /* column of the first pixel in raster order; its row is box.top */
    bool touches_edge; /* the box reaches a border of the image */
    uint32_t area;     /* pixels */
    uint64_t sum_x;    /* of x, of y, of x*x, x*y and y*y, in px and px^2 */
    uint64_t sum_y;
    uint64_t sum_xx;
    uint64_t sum_xy;
    uint64_t sum_yy;
} ocel_blob_t;

typedef enum {
    OCEL_FIT_B2AC = 0, /* Fitzgibbon's constrained least squares, reduced in closed form */
    OCEL_FIT_LCSE,     /* the same, on points perturbed as in the paper when unstable */
    OCEL_FIT_HYPER     /* bias-corrected, for arcs and noise */
} ocel_fit_method_t;

typedef enum {
    OCEL_PERTURB_AUTO = 0, /* perturb when the unperturbed fit is unstable (fit.h) */
    OCEL_PERTURB_ALWAYS,
    OCEL_PERTURB_NEVER
} ocel_perturb_t;

typedef struct {
    ocel_fit_method_t method;
    ocel_perturb_t perturb; /* read by OCEL_FIT_LCSE only */
    bool closed;            /* the points are a whole closed boundary, which covers the full
                               turn: arc_coverage is 1 and need not be measured */
} ocel_fit_options_t;

/* A fitted ellipse. */
typedef struct {
    int32_t cx_px_q16; /* centre */
    int32_t cy_px_q16;
    int32_t a_px_q16; /* semi-axes, a >= b > 0 */
    int32_t b_px_q16;
    uint32_t angle_turn_q32;      /* major axis from +x towards +y, [0, 2^31): half a turn */
    uint32_t rms_px_q16;          /* residual: Taubin's approximation of the RMS distance */
    uint32_t centre_sigma_px_q16; /* expected standard deviation of the centre (fit.h) */
    uint32_t arc_coverage_q16;    /* fraction of the turn that the points cover, <= 65536 */
    uint32_t point_count;
    ocel_fit_method_t method;
    bool perturbed; /* the LCSE perturbation was applied */
} ocel_ellipse_t;

#endif
