/* SPDX-License-Identifier: MIT */
#include "ellipse.h"

#include <stdbool.h>

#include "../base/int_math.h"
#include "../base/q60.h"
#include "../base/scale.h"
#include "../base/scale_all.h"
#include "../base/terms.h"
#include "../base/trig.h"

/* A centre farther than 2^8 half-sides from the points' box is none: arcs
 * under about 15 degrees of a circle. */
#define CENTRE_BITS 56 /* of Q48 */

/* A squared size below 2^-44 of the points' spread is what rounding leaves of
 * zero: an imaginary ellipse. */
#define NOTHING_Q60 ((int64_t)0x10000)

#define EIGHTH_Q60 ((int64_t)0x200000000000000)

/* What is found here, after the solution and its form. */
enum {
    V = OCEL_F_V,
    W = OCEL_F_W,
    D = OCEL_F_D_Q48,
    E = OCEL_F_E_Q48,
    FORM_XX = OCEL_F_FORM_XX,
    FORM_YY = OCEL_F_FORM_YY,
    G11 = OCEL_F_G11,
    G21 = OCEL_F_G21,
    G22 = OCEL_F_G22,

    ROOT = OCEL_F_FREE, /* of 1 / flatness, without its exponent */
    CX_Q48,             /* the centre; in the end G times it */
    CY_Q48,
    MXX, /* the points' second moments about it, over 2 * 4^reach: each <= 1 */
    MXY,
    MYY,
    LEVEL, /* half of the conic's level, over 4^reach */
    GRADIENT,
    A0, /* for a moment */
    A1,
    OWN_END
};

/* Where the solution has what is of no more use when these are found. */
enum {
    SHAPE_XX = OCEL_F_D_Q48,
    SHAPE_XY,
    SHAPE_YY,
    SQUARE = OCEL_F_ENERGY,
    A2 = OCEL_F_X, /* for a moment */
    A3,
    A4,
    A5,
    A6,
    G11_UPPER = MXX, /* g11 and g22 without their exponents */
    G22_UPPER
};
typedef char ocel_assert_own_t[((uint32_t)OWN_END <= (uint32_t)OCEL_F_PLACES) ? 1 : -1];

/* The conic's flatness as every affine frame sees it: 4AC - B^2 over (A + C)^2
 * in the frame in which the points do not correlate.  An arc of a turn's
 * fraction t has about tan^2(90 t): .017 at 30 degrees, 2^-9 at 10. */
static bool is_too_flat(int64_t *r) {
    static const ocel_term_t terms[] = {
        /* the covariance's determinant, and half of the form's trace with it */
        {OCEL_GOES_ON, OCEL_F_XX, OCEL_F_YY}, {OCEL_MINUS | A0, OCEL_F_XY, OCEL_F_XY},
        {OCEL_GOES_ON, FORM_XX, OCEL_F_XX},   {OCEL_GOES_ON, W, OCEL_F_XY},
        {OCEL_GOES_ON, W, OCEL_F_XY},         {OCEL_LAST | A1, FORM_YY, OCEL_F_YY},
    };
    int64_t half;

    ocel_sum_terms(r, terms);
    half = ocel_asr64(r[A1], 1U);
    return ocel_mul_q60(r[OCEL_F_FLATNESS], r[A0]) < ocel_asr64(ocel_mul_q60(half, half), 9U);
}

/* Solves [1+v w; w 1-v] (cx, cy) = -(D, E) with the inverse determinant
 * 1/flatness = root^2.  |D|, |E| < 2^10 makes the numerators below
 * 2^13 * 2^48 = 2^61; flatness >= 2^-28 makes each factor's exponent <= 15. */
static bool find_centre(int64_t *r, int32_t root_e) {
    static const ocel_term_t terms[] = {
        {A0, ROOT, ROOT},
        {OCEL_GOES_ON, W, E},
        {OCEL_MINUS | CX_Q48, FORM_YY, D},
        {OCEL_GOES_ON, W, D},
        {OCEL_MINUS | CY_Q48, FORM_XX, E},
        {CX_Q48, CX_Q48, A0},
        {OCEL_LAST | CY_Q48, CY_Q48, A0},
    };
    const int32_t e = 2 * root_e;
    int32_t bits;

    ocel_sum_terms(r, terms);
    bits = ocel_bits_of(&r[CX_Q48], 2U);
    ocel_scale_all(&r[CX_Q48], 2U, e);
    return (bits + ((e > 0) ? e : 0)) <= CENTRE_BITS;
}

/* The points' moments about the centre, and the level: the mean of the quadratic form
 * about the centre, less the polynomial's mean; k / 4^reach <= 4.  A moment is a
 * covariance and a product of offsets, both positive semi-definite, so nothing cancels.
 * Returns reach, 0..9: the centre is within 2^reach of the centroid. */
static int32_t find_level(int64_t *r) {
    static const ocel_term_t products[] = {
        {MXX, A0, A0},
        {MXY, A0, A1},
        {OCEL_LAST | MYY, A1, A1},
    };
    static const ocel_term_t level[] = {
        {OCEL_GOES_ON, FORM_XX, MXX},
        {OCEL_GOES_ON, W, MXY},
        {OCEL_GOES_ON, W, MXY},
        {OCEL_LAST | LEVEL, FORM_YY, MYY},
    };
    int32_t reach;

    r[A0] = ocel_shift_round64(r[OCEL_F_X], 12U) - r[CX_Q48];
    r[A1] = ocel_shift_round64(r[OCEL_F_Y], 12U) - r[CY_Q48];
    reach = ocel_bits_of(&r[A0], 2U) - 48;
    reach = (reach > 0) ? reach : 0;
    ocel_scale_all(&r[A0], 2U, 12 - reach);
    ocel_sum_terms(r, products);
    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 */
        r[MXX + i] =
            ocel_scale_q60(r[OCEL_F_XX + i], -1 - (2 * reach)) + ocel_shift_round64(r[MXX + i], 1U);
    }
    ocel_sum_terms(r, level);
    r[LEVEL] = ocel_asr64(r[LEVEL] - ocel_scale_q60(r[OCEL_F_MEAN], -2 * reach), 1U);
    return reach;
}

/* value * 2^e as an int32, 0 for a negative value; at 2^30 and beyond (16384 px
 * in Q16) INT32_MAX, which the caller takes as out of range. */
static int32_t to_int32(const int64_t *value, int32_t e) {
    int32_t result = 0;

    if ((*value > 0) && (e >= -62)) {
        result =
            ((ocel_bits_of(value, 1U) + e) > 30) ? INT32_MAX : (int32_t)ocel_scale_q60(*value, e);
    }
    return result;
}

/* What of the image does not need the conic's size.
 *
 * The shape matrix (inverse of the form over 2k) in the image is
 * 2k/flatness G [1-v -w; -w 1+v] G'; G <= 1/2 keeps the products within 3/2.
 *
 * The mean squared gradient of the conic's polynomial over the points, in the image, times
 * (det G)^2 / (16 * 4^reach): tr(adj(G)' U adj(G)) with U = form M form.  M/16 has a trace
 * of at most 1/4 and form a norm below 2, so form M/16 form is within 1.
 *
 * The mean square of the polynomial, and G times the centre. */
static void map(int64_t *r) {
    static const ocel_term_t terms[] = {
        /* A0 = -w, A1 = -g21; the shape, whose g12 is 0 */
        {A2, G11, FORM_YY},
        {A3, G11, A0},
        {OCEL_GOES_ON, G21, FORM_YY},
        {A4, G22, A0},
        {OCEL_GOES_ON, G21, A0},
        {A5, G22, FORM_XX},
        {SHAPE_XX, A2, G11},
        {OCEL_GOES_ON, A2, G21},
        {SHAPE_XY, A3, G22},
        {OCEL_GOES_ON, A4, G21},
        {SHAPE_YY, A5, G22},
        /* M over 8, and form M */
        {MXX, MXX, A6},
        {MXY, MXY, A6},
        {MYY, MYY, A6},
        {OCEL_GOES_ON, FORM_XX, MXX},
        {A2, W, MXY},
        {OCEL_GOES_ON, FORM_XX, MXY},
        {A3, W, MYY},
        {OCEL_GOES_ON, W, MXX},
        {A4, FORM_YY, MXY},
        {OCEL_GOES_ON, W, MXY},
        {A5, FORM_YY, MYY},
        /* U: xx, xy, yy */
        {OCEL_GOES_ON, A2, FORM_XX},
        {A6, A3, W},
        {OCEL_GOES_ON, A2, W},
        {A3, A3, FORM_YY},
        {OCEL_GOES_ON, A4, W},
        {A5, A5, FORM_YY},
        /* U adj(G), and the trace */
        {OCEL_GOES_ON, G22, A6},
        {A2, A1, A3},
        {OCEL_GOES_ON, G22, A3},
        {A3, A1, A5},
        {A4, G11, A5},
        {OCEL_GOES_ON, A2, G22},
        {OCEL_GOES_ON, A3, A1},
        {GRADIENT, A4, G11},
        {SQUARE, OCEL_F_ENERGY, OCEL_F_WEIGHT},
        {OCEL_GOES_ON, G21, CX_Q48},
        {CY_Q48, G22, CY_Q48},
        {OCEL_LAST | CX_Q48, G11, CX_Q48},
    };

    r[A0] = -r[W];
    r[A1] = -r[G21];
    r[A6] = EIGHTH_Q60;
    ocel_sum_terms(r, terms);
}

/* A0 * A1 / ... : lengths of the image, but for their exponents.  From AREA on
 * A4 = det G * A0 / root, A1 the root's inverse: where the area of the frame's unit square
 * enters. */
#define AREA 3U
static const ocel_term_t lengths[] = {
    {A2, A0, ROOT},      {A3, A6, A1},        {A5, A2, A3},
    {A2, A0, G11_UPPER}, {A3, G22_UPPER, A1}, {OCEL_LAST | A4, A2, A3},
};

/* Semi-axes and angle.  a^2 is the larger eigenvalue of the shape matrix, E, and
 * b^2 = det E / a^2, whose determinant is known without cancellation.  scale: what both
 * exponents have of the frame. */
static void find_axes(int64_t *r, int32_t root_e, int32_t area_e, int32_t scale,
                      ocel_ellipse_t *ellipse) {
    int64_t difference;
    uint32_t turn_q32;
    int32_t e; /* of the inverse of the eigenvalue's root */

    ocel_polar(ocel_asr64(r[SHAPE_XX] - r[SHAPE_YY], 1U), r[SHAPE_XY], &difference, &turn_q32);
    ellipse->angle_turn_q32 = turn_q32 >> 1U;
    r[A6] = ocel_asr64(r[SHAPE_XX] + r[SHAPE_YY], 1U) + difference;
    r[A0] = ocel_sqrt_q60((uint64_t)r[LEVEL]);
    ocel_rsqrt_q60((uint64_t)r[A6], &r[A1], &e);
    ocel_sum_terms(r, lengths);
    ellipse->a_px_q16 = to_int32(&r[A5], scale + root_e + e);
    ellipse->b_px_q16 = to_int32(&r[A4], scale + area_e + e);
    if (ellipse->b_px_q16 > ellipse->a_px_q16) { /* a circle, rounded */
        ellipse->b_px_q16 = ellipse->a_px_q16;
    }
}

/* Taubin's approximation of the mean squared distance: the mean square of the
 * polynomial over its mean squared gradient (Taubin 1991, PAMI 13, eq. 3.9).  scale: what
 * the exponent has of the frame. */
static int32_t rms_px_q16(int64_t *r, int32_t area_e, int32_t scale) {
    int32_t rms = 0;

    if ((r[SQUARE] > 0) && (r[GRADIENT] > 0)) {
        /* sqrt(s / g) = s / sqrt(s g), with both in [1/2, 1) times powers of two. */
        const int32_t square_e = (int32_t)r[OCEL_F_ENERGY_E] + ocel_normalise(&r[SQUARE], 1U, 60);
        const int32_t ratio_e = square_e - ocel_normalise(&r[GRADIENT], 1U, 60);
        const bool odd = ((uint32_t)ratio_e & 1U) != 0U;
        const int32_t half_e = ocel_asr32(ratio_e + 1, 1U); /* rounded up */
        int32_t e;

        int64_t product = ocel_mul_q60(r[SQUARE], r[GRADIENT]);

        r[A0] = r[SQUARE];
        if (odd) {
            r[A0] = ocel_asr64(r[A0], 1U);
            product = ocel_asr64(product, 1U);
        }
        ocel_rsqrt_q60((uint64_t)product, &r[A1], &e);
        ocel_sum_terms(r, &lengths[AREA]);
        rms = to_int32(&r[A4], scale + area_e + half_e + e);
    }
    return rms;
}

/* |c| < 2^8 in Q48 times G <= 1/2, then 2^(scale_log2 + 7) from Q48: a right
 * shift by 41 - scale_log2 >= 5; from Q24 to Q16 with a range check. */
static bool place_centre(const int64_t *r, ocel_ellipse_t *ellipse) {
    int32_t c_px_q16[2];
    bool fits = true;

    for (uint32_t i = 0U; i < 2U; i++) { /* bound: 2 */
        const int64_t c_px_q24 = r[(uint32_t)OCEL_F_X0_Q24 + i] +
                                 ocel_scale_q60(r[CX_Q48 + i], (int32_t)r[OCEL_F_SCALE_LOG2] - 41);
        const int64_t rounded = ocel_shift_round64(c_px_q24, 8U);

        c_px_q16[i] = (int32_t)rounded;
        fits = fits && (rounded > INT32_MIN) && (rounded < INT32_MAX);
    }
    ellipse->cx_px_q16 = c_px_q16[0];
    ellipse->cy_px_q16 = c_px_q16[1];
    return fits;
}

ocel_status_t ocel_ellipse_of_conic(int64_t *r_q60, ocel_ellipse_t *ellipse) {
    int64_t *const r = r_q60;
    ocel_status_t status = OCEL_NOT_AN_ELLIPSE;
    int32_t root_e;

    ocel_rsqrt_q60((uint64_t)r[OCEL_F_FLATNESS], &r[ROOT], &root_e);
    if ((!is_too_flat(r)) && find_centre(r, root_e)) {
        const int32_t reach = find_level(r);

        if (r[LEVEL] >= NOTHING_Q60) {
            const int32_t scale = (int32_t)r[OCEL_F_SCALE_LOG2];
            int32_t area_e;

            map(r);
            r[G11_UPPER] = r[G11];
            r[G22_UPPER] = r[G22];
            area_e = ocel_normalise(&r[G11_UPPER], 1U, 60) + ocel_normalise(&r[G22_UPPER], 1U, 60);
            find_axes(r, root_e, area_e, (scale + reach) - 60, ellipse);
            ellipse->rms_px_q16 = (uint32_t)rms_px_q16(r, area_e, scale - (63 + reach));
            status = (place_centre(r, ellipse) && (ellipse->a_px_q16 < INT32_MAX) &&
                      (ellipse->b_px_q16 > 0))
                         ? OCEL_OK
                         : OCEL_OUT_OF_RANGE;
        }
    }
    return status;
}
