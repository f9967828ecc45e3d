/* SPDX-License-Identifier: MIT */
#include "ellipse.h"

#include <stdbool.h>

#include "../base/int_math.h"
#include "../base/q60.h"
#include "../base/scale.h"
#include "../base/trig.h"

/* A centre farther than 2^8 half-sides from the points' box is none: arcs
 * under about 15 degrees of a circle. */
#define CENTRE_MAX_Q48 ((int64_t)0x100000000000000)

/* A squared size below 2^-44 of the points' spread is what rounding leaves of
 * zero: an imaginary ellipse. */
#define NOTHING_Q60 ((int64_t)0x10000)

/* The centre and the points' second moments about it. */
typedef struct {
    int64_t cx_q48;
    int64_t cy_q48;
    int64_t xx_q60; /* the moments over 2 * 4^reach: each <= 1 */
    int64_t xy_q60;
    int64_t yy_q60;
    int32_t reach; /* 0..9: the centre is within 2^reach of the centroid */
} about_centre_t;

/* The quadratic part [1+v w; w 1-v] = 2 [A B/2; B/2 C], each entry below 2. */
typedef struct {
    int64_t xx_q60;
    int64_t xy_q60;
    int64_t yy_q60;
} form_t;

static form_t form_of_conic(const ocel_conic_t *conic) {
    form_t form;

    form.xx_q60 = OCEL_Q60_ONE + conic->v_q60;
    form.xy_q60 = conic->w_q60;
    form.yy_q60 = OCEL_Q60_ONE - conic->v_q60;
    return form;
}

/* Solves [1+v w; w 1-v] (cx, cy) = -(D, E) with the inverse determinant
 * 1/flatness = root_inverse^2.  |D|, |E| < 2^10 makes the numerators below
 * 2^13 * 2^48 = 2^61; flatness >= 2^-28 makes each factor's exponent <= 15. */
static bool find_centre(const ocel_conic_t *conic, const form_t *form,
                        const ocel_scaled_t *root_inverse, about_centre_t *about) {
    const int64_t inverse_q60 = ocel_mul_q60(root_inverse->y_q60, root_inverse->y_q60);
    const int32_t e = 2 * root_inverse->e;
    const uint64_t most = (uint64_t)CENTRE_MAX_Q48 >> (uint32_t)((e > 0) ? e : 0);
    const int64_t num_x =
        ocel_mul_q60(form->xy_q60, conic->e_q48) - ocel_mul_q60(form->yy_q60, conic->d_q48);
    const int64_t num_y =
        ocel_mul_q60(form->xy_q60, conic->d_q48) - ocel_mul_q60(form->xx_q60, conic->e_q48);
    const int64_t x = ocel_mul_q60(num_x, inverse_q60);
    const int64_t y = ocel_mul_q60(num_y, inverse_q60);
    const bool near = (ocel_abs64(x) < most) && (ocel_abs64(y) < most);

    if (near) {
        about->cx_q48 = ocel_scale_q60(x, e);
        about->cy_q48 = ocel_scale_q60(y, e);
    }
    return near;
}

/* The smallest r >= 0 with |x|, |y| < 2^(r + 48). */
static int32_t reach_of(int64_t x_q48, int64_t y_q48) {
    const int32_t bits = 64 - (int32_t)ocel_clz64(ocel_abs64(x_q48) | ocel_abs64(y_q48));

    return (bits > 48) ? (bits - 48) : 0;
}

/* A covariance and a product of offsets to a moment about the centre, over
 * 2 * 4^reach; both parts are positive semi-definite, so nothing cancels. */
static int64_t moment_about(int64_t covariance_q60, int64_t product_q60, int32_t reach) {
    return ocel_scale_q60(covariance_q60, -1 - (2 * reach)) + ocel_shift_round64(product_q60, 1U);
}

static void moments_about(const ocel_spread_t *spread, about_centre_t *about) {
    const int64_t dx_q48 = ocel_shift_round64(spread->x, 12U) - about->cx_q48;
    const int64_t dy_q48 = ocel_shift_round64(spread->y, 12U) - about->cy_q48;
    const int32_t reach = reach_of(dx_q48, dy_q48);
    const int64_t dx = ocel_scale_q60(dx_q48, 12 - reach);
    const int64_t dy = ocel_scale_q60(dy_q48, 12 - reach);

    about->reach = reach;
    about->xx_q60 = moment_about(spread->xx, ocel_mul_q60(dx, dx), reach);
    about->xy_q60 = moment_about(spread->xy, ocel_mul_q60(dx, dy), reach);
    about->yy_q60 = moment_about(spread->yy, ocel_mul_q60(dy, dy), reach);
}

/* value * 2^e as an int32, 0 for a negative value; at 2^30 and beyond (16384 px
 * in Q16) INT32_MAX, which the caller takes as out of range. */
static int32_t to_int32(int64_t value, int32_t e) {
    int32_t result = 0;

    if ((value > 0) && (e >= -62)) {
        const int32_t bits = 64 - (int32_t)ocel_clz64((uint64_t)value);

        result = ((bits + e) > 30) ? INT32_MAX : (int32_t)ocel_scale_q60(value, e);
    }
    return result;
}

/* A value's mantissa in [2^59, 2^60) and how far it was shifted up for it. */
static ocel_scaled_t normalised(int64_t value_q60) {
    ocel_scaled_t scaled;

    scaled.e = 4 - (int32_t)ocel_clz64((uint64_t)value_q60);
    scaled.y_q60 = ocel_scale_q60(value_q60, -scaled.e);
    return scaled;
}

/* det G * value / root, value < 2, given the inverse of the root: where the
 * area of the frame's unit square enters. */
static ocel_scaled_t times_area(const ocel_frame_t *frame, int64_t value_q60,
                                const ocel_scaled_t *inverse) {
    const ocel_scaled_t g11 = normalised(frame->g11_q60);
    const ocel_scaled_t g22 = normalised(frame->g22_q60);
    ocel_scaled_t result;

    result.y_q60 =
        ocel_mul_q60(ocel_mul_q60(value_q60, g11.y_q60), ocel_mul_q60(g22.y_q60, inverse->y_q60));
    result.e = g11.e + g22.e + inverse->e;
    return result;
}

/* M S M' for M = [a b; c d] and S symmetric; every |M| below 2, every |S| and
 * every product's sum below 2. */
static form_t congruence(const int64_t m[4], const form_t *s) {
    const int64_t pxx = ocel_mul_q60(m[0], s->xx_q60) + ocel_mul_q60(m[1], s->xy_q60);
    const int64_t pxy = ocel_mul_q60(m[0], s->xy_q60) + ocel_mul_q60(m[1], s->yy_q60);
    const int64_t pyx = ocel_mul_q60(m[2], s->xx_q60) + ocel_mul_q60(m[3], s->xy_q60);
    const int64_t pyy = ocel_mul_q60(m[2], s->xy_q60) + ocel_mul_q60(m[3], s->yy_q60);
    form_t out;

    out.xx_q60 = ocel_mul_q60(pxx, m[0]) + ocel_mul_q60(pxy, m[1]);
    out.xy_q60 = ocel_mul_q60(pxx, m[2]) + ocel_mul_q60(pxy, m[3]);
    out.yy_q60 = ocel_mul_q60(pyx, m[2]) + ocel_mul_q60(pyy, m[3]);
    return out;
}

/* Semi-axes and angle.  The shape matrix (inverse of the form over 2k) in the
 * image is E = 2k/flatness G [1-v -w; -w 1+v] G'; G <= 1/2 keeps the products
 * within 3/2.  a^2 is its larger eigenvalue, b^2 = det E / a^2, whose
 * determinant is known without cancellation. */
static void map_axes(const form_t *form, int64_t half_k_q60, const ocel_scaled_t *root_inverse,
                     const ocel_frame_t *frame, int32_t reach, ocel_ellipse_t *ellipse) {
    const int64_t g[4] = {frame->g11_q60, 0, frame->g21_q60, frame->g22_q60};
    const form_t adjoint = {form->yy_q60, -form->xy_q60, form->xx_q60};
    const form_t e = congruence(g, &adjoint);
    const int64_t root_k = ocel_sqrt_q60((uint64_t)half_k_q60);
    const int32_t scale = frame->scale_log2 + reach - 60;
    int64_t eigenvalue;
    int64_t difference;
    uint32_t turn_q32;
    ocel_scaled_t inverse; /* of the eigenvalue's root */
    ocel_scaled_t b;

    ocel_polar(ocel_asr64(e.xx_q60 - e.yy_q60, 1U), e.xy_q60, &difference, &turn_q32);
    eigenvalue = ocel_asr64(e.xx_q60 + e.yy_q60, 1U) + difference;
    ellipse->angle_turn_q32 = turn_q32 >> 1U;
    ocel_rsqrt_q60((uint64_t)eigenvalue, &inverse.y_q60, &inverse.e);
    ellipse->a_px_q16 = to_int32(ocel_mul_q60(ocel_mul_q60(root_k, root_inverse->y_q60),
                                              ocel_mul_q60(eigenvalue, inverse.y_q60)),
                                 scale + root_inverse->e + inverse.e);
    b = times_area(frame, root_k, &inverse);
    ellipse->b_px_q16 = to_int32(b.y_q60, scale + b.e);
    if (ellipse->b_px_q16 > ellipse->a_px_q16) { /* a circle, rounded */
        ellipse->b_px_q16 = ellipse->a_px_q16;
    }
}

/* Q24 to Q16 with a range check. */
static bool to_q16(int64_t px_q24, int32_t *px_q16) {
    const int64_t rounded = ocel_shift_round64(px_q24, 8U);
    const bool fits = (rounded > INT32_MIN) && (rounded < INT32_MAX);

    *px_q16 = fits ? (int32_t)rounded : 0;
    return fits;
}

/* |c| < 2^8 in Q48 times G <= 1/2, then 2^(scale_log2 + 7) from Q48: a right
 * shift by 41 - scale_log2 >= 5. */
static bool map_centre(const about_centre_t *about, const ocel_frame_t *frame,
                       ocel_ellipse_t *ellipse) {
    const int32_t e = frame->scale_log2 - 41;
    const int64_t x = ocel_mul_q60(frame->g11_q60, about->cx_q48);
    const int64_t y =
        ocel_mul_q60(frame->g21_q60, about->cx_q48) + ocel_mul_q60(frame->g22_q60, about->cy_q48);
    const bool x_fits = to_q16(frame->x0_px_q24 + ocel_scale_q60(x, e), &ellipse->cx_px_q16);
    const bool y_fits = to_q16(frame->y0_px_q24 + ocel_scale_q60(y, e), &ellipse->cy_px_q16);

    return x_fits && y_fits;
}

/* The mean squared gradient of the conic's polynomial over the points, in the
 * image, times (det G)^2 / (16 * 4^reach): tr(adj(G)' W adj(G)) with
 * W = form V form.  V/16 has a trace of at most 1/4 and form a norm below 2, so
 * form V/16 form is within 1. */
static int64_t mean_gradient_q60(const form_t *form, const about_centre_t *about,
                                 const ocel_frame_t *frame) {
    const int64_t f[4] = {form->xx_q60, form->xy_q60, form->xy_q60, form->yy_q60};
    const int64_t adjoint[4] = {frame->g22_q60, -frame->g21_q60, 0, frame->g11_q60};
    const form_t spread = {ocel_asr64(about->xx_q60, 3U), ocel_asr64(about->xy_q60, 3U),
                           ocel_asr64(about->yy_q60, 3U)};
    const form_t w = congruence(f, &spread);
    const form_t gradient = congruence(adjoint, &w);

    return gradient.xx_q60 + gradient.yy_q60;
}

/* Taubin's approximation of the mean squared distance: the mean square of the
 * polynomial over its mean squared gradient (Taubin 1991, PAMI 13, eq. 3.9). */
static int32_t rms_px_q16(const ocel_conic_t *conic, const ocel_spread_t *spread,
                          const form_t *form, const about_centre_t *about,
                          const ocel_frame_t *frame) {
    const int64_t gradient_q60 = mean_gradient_q60(form, about, frame);
    const int64_t square_q60 = ocel_mul_q60(conic->energy.y_q60, spread->inverse_weight);
    int32_t rms = 0;

    if ((square_q60 > 0) && (gradient_q60 > 0)) {
        /* sqrt(s / g) = s / sqrt(s g), with both in [1/2, 1) times powers of two. */
        const ocel_scaled_t s = normalised(square_q60);
        const ocel_scaled_t g = normalised(gradient_q60);
        const int32_t e = conic->energy.e + s.e - g.e;
        const int32_t odd = (int32_t)((uint32_t)e & 1U);
        ocel_scaled_t inverse;
        ocel_scaled_t r;

        ocel_rsqrt_q60((uint64_t)ocel_asr64(ocel_mul_q60(s.y_q60, g.y_q60), (uint32_t)odd),
                       &inverse.y_q60, &inverse.e);
        r = times_area(frame, ocel_asr64(s.y_q60, (uint32_t)odd), &inverse);
        rms = to_int32(r.y_q60, (r.e + ((e + odd) / 2) + frame->scale_log2) - (63 + about->reach));
    }
    return rms;
}

/* Half of the conic's level k: the mean of the quadratic form about the centre,
 * less the polynomial's mean.  k / 4^reach <= 4. */
static int64_t half_level_q60(const ocel_conic_t *conic, const form_t *form,
                              const about_centre_t *about) {
    const int64_t mean = ocel_scale_q60(conic->mean_q60, -2 * about->reach);
    const int64_t k = ocel_mul_q60(form->xx_q60, about->xx_q60) +
                      (2 * ocel_mul_q60(form->xy_q60, about->xy_q60)) +
                      ocel_mul_q60(form->yy_q60, about->yy_q60);

    return ocel_asr64(k - mean, 1U);
}

ocel_status_t ocel_ellipse_of_conic(const ocel_conic_t *conic, const ocel_spread_t *spread,
                                    const ocel_frame_t *frame, ocel_ellipse_t *ellipse) {
    const form_t form = form_of_conic(conic);
    ocel_status_t status = OCEL_NOT_AN_ELLIPSE;
    ocel_scaled_t root_inverse;
    about_centre_t about;

    ocel_rsqrt_q60((uint64_t)ocel_conic_flatness_q60(conic), &root_inverse.y_q60, &root_inverse.e);
    if (find_centre(conic, &form, &root_inverse, &about)) {
        int64_t half_k;

        moments_about(spread, &about);
        half_k = half_level_q60(conic, &form, &about);
        if (half_k >= NOTHING_Q60) {
            map_axes(&form, half_k, &root_inverse, frame, about.reach, ellipse);
            ellipse->rms_px_q16 = (uint32_t)rms_px_q16(conic, spread, &form, &about, frame);
            status = (map_centre(&about, frame, ellipse) && (ellipse->a_px_q16 < INT32_MAX) &&
                      (ellipse->b_px_q16 > 0))
                         ? OCEL_OK
                         : OCEL_OUT_OF_RANGE;
        }
    }
    return status;
}
