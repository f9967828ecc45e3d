/* SPDX-License-Identifier: MIT
 *
 * Moments of any points: normalised to Q30, sheared, products rounded to Q60.
 */
#include <string.h>

#include "../base/int_math.h"
#include "../base/q60.h"
#include "../base/scale.h"
#include "moments.h"
#include "perturb.h"

/* Fraction bits of normalised coordinates, so that a square has 60. */
#define UNIT_BITS 30U

/* Fraction bits of the shear, and of the coordinates from which it is found. */
#define SHEAR_BITS 20U
#define COARSE_BITS 13U

/* The steepest shear, 4.0.  Any shear is right (the fit is affine invariant or
 * knows the frame's metric); a steeper one would only lengthen the products. */
#define SHEAR_MAX ((int64_t)0x400000)

/* The perturbation is defined on 26 fraction bits. */
#define PERTURB_BITS (UNIT_BITS - 26U)

typedef struct {
    int64_t min_x;
    int64_t max_x;
    int64_t min_y;
    int64_t max_y;
} span_t;

/* The normalisation: u = (2 x - x0) * rate / 2^32, in Q30. */
typedef struct {
    int64_t x0_q17;
    int64_t y0_q17;
    int64_t side_x_q17; /* half-sides, 1..2^32 */
    int64_t side_y_q17;
    int64_t rate_x; /* 2^62 / half-side */
    int64_t rate_y;
    int64_t shear_q20; /* y' = (y - shear x - centre) / 2^(down - 20) */
    int64_t centre_q50;
    uint32_t down; /* 0..23 */
    bool perturb;
} normal_t;

static span_t span_of_source(const ocel_source_t *source) {
    const ocel_pair_t first = ocel_source_px_q16(source, 0U);
    span_t span = {first.x, first.x, first.y, first.y};
    size_t i;

    /* bound: OCEL_MAX_FIT_POINTS; OCEL_MAX_CRACKS each time in a call of ocel_eye_end or
     * ocel_eye_refit */
    for (i = 1U; i < source->count; i++) {
        const ocel_pair_t p = ocel_source_px_q16(source, i);

        span.min_x = (p.x < span.min_x) ? p.x : span.min_x;
        span.max_x = (p.x > span.max_x) ? p.x : span.max_x;
        span.min_y = (p.y < span.min_y) ? p.y : span.min_y;
        span.max_y = (p.y > span.max_y) ? p.y : span.max_y;
    }
    return span;
}

/* A normalised point: x in Q30, |x| <= 1, and the sheared y in Q50,
 * |y| <= 1 + 4.  2 X - x0 is at most the half-side s in Q17, so its product
 * with rate = 2^62 / s is at most 2^62; y in Q50 is below 2^53. */
static ocel_pair_t sheared_point(const ocel_source_t *source, const normal_t *normal, size_t i) {
    ocel_pair_t p = ocel_source_px_q16(source, i);

    p.x = ocel_shift_round64(((2 * p.x) - normal->x0_q17) * normal->rate_x, 62U - UNIT_BITS);
    p.y = ocel_shift_round64(((2 * p.y) - normal->y0_q17) * normal->rate_y, 62U - UNIT_BITS);
    p.y = ocel_shl64(p.y, SHEAR_BITS) - (p.x * normal->shear_q20);
    return p;
}

/* The slope of y on x, Q20, within +-SHEAR_MAX.  Coarse coordinates of 13 bits:
 * |sums| <= 2^14 * 2^26 = 2^40, shifted up 20 bits for the division. */
static int64_t shear_q20(const ocel_source_t *source, const normal_t *normal) {
    int64_t s_xx = 0;
    int64_t s_xy = 0;
    int64_t shear = 0;
    size_t i;

    /* bound: OCEL_MAX_FIT_POINTS; OCEL_MAX_CRACKS each time in a call of ocel_eye_end or
     * ocel_eye_refit */
    for (i = 0U; i < source->count; i++) {
        const ocel_pair_t p = sheared_point(source, normal, i);
        const int64_t x = ocel_asr64(p.x, UNIT_BITS - COARSE_BITS);

        s_xx += x * x;
        s_xy += x * ocel_asr64(p.y, (UNIT_BITS + SHEAR_BITS) - COARSE_BITS);
    }
    if (s_xx > 0) {
        shear = (int64_t)ocel_udiv64(ocel_abs64(s_xy) << SHEAR_BITS, (uint64_t)s_xx);
        shear = (shear > SHEAR_MAX) ? SHEAR_MAX : shear;
        shear = (s_xy < 0) ? -shear : shear;
    }
    return shear;
}

/* Centre and unit that make the sheared y fill [-1, 1].  Points on a line have
 * no spread; down stops at 0 and the fit finds their variance too small. */
static void fill_unit(const ocel_source_t *source, normal_t *normal) {
    int64_t low = INT64_MAX;
    int64_t high = INT64_MIN;
    uint32_t half_log2;
    size_t i;

    /* bound: OCEL_MAX_FIT_POINTS; OCEL_MAX_CRACKS each time in a call of ocel_eye_end or
     * ocel_eye_refit */
    for (i = 0U; i < source->count; i++) {
        const int64_t y = sheared_point(source, normal, i).y;

        low = (y < low) ? y : low;
        high = (y > high) ? y : high;
    }
    normal->centre_q50 = ocel_asr64(low + high, 1U);
    half_log2 = ocel_ceil_log2((uint64_t)(high - normal->centre_q50) + 1U);
    normal->down = (half_log2 > UNIT_BITS) ? (half_log2 - UNIT_BITS) : 0U;
}

/* A point as it enters the sums, Q30; |x|, |y| <= 1.002. */
static ocel_pair_t framed_point(const ocel_source_t *source, const normal_t *normal, size_t i) {
    ocel_pair_t p = sheared_point(source, normal, i);

    p.y = ocel_scale_q60(p.y - normal->centre_q50, -(int32_t)normal->down);
    if (normal->perturb) {
        int32_t x_q26 = (int32_t)ocel_shift_round64(p.x, PERTURB_BITS);
        int32_t y_q26 = (int32_t)ocel_shift_round64(p.y, PERTURB_BITS);

        /* at most: OCEL_MAX_FIT_POINTS in a call of ocel_fit_points or ocel_fit_cracks;
         * OCEL_MAX_CRACKS in a call of ocel_eye_refit */
        ocel_perturb_point(&x_q26, &y_q26);
        p.x = ocel_shl64(x_q26, PERTURB_BITS);
        p.y = ocel_shl64(y_q26, PERTURB_BITS);
    }
    return p;
}

/* Monomials up to the second order, Q60; the places of OCEL_M_*. */
#define LOW_COUNT ((uint32_t)OCEL_M_XXX)

static void low_monomials(ocel_pair_t p, int64_t *v) {
    v[OCEL_M_1] = OCEL_Q60_ONE;
    v[OCEL_M_X] = ocel_shl64(p.x, UNIT_BITS);
    v[OCEL_M_Y] = ocel_shl64(p.y, UNIT_BITS);
    v[OCEL_M_XX] = p.x * p.x;
    v[OCEL_M_XY] = p.x * p.y;
    v[OCEL_M_YY] = p.y * p.y;
}

/* Monomial k, each below 1.01: from the third order on the product of two lower
 * ones. */
static int64_t monomial(const int64_t *v, uint32_t k) {
    static const uint8_t left[OCEL_M_COUNT] = {
        0,         0,         0,         0,         0,         0,         OCEL_M_XX, OCEL_M_XX,
        OCEL_M_YY, OCEL_M_YY, OCEL_M_XX, OCEL_M_XX, OCEL_M_XX, OCEL_M_YY, OCEL_M_YY};
    static const uint8_t right[OCEL_M_COUNT] = {
        0,        0,        0,         0,         0,         0,         OCEL_M_X, OCEL_M_Y,
        OCEL_M_X, OCEL_M_Y, OCEL_M_XX, OCEL_M_XY, OCEL_M_YY, OCEL_M_XY, OCEL_M_YY};

    /* at most: OCEL_M_COUNT - OCEL_M_XXX */
    return (k < LOW_COUNT) ? v[k] : ocel_mul_q60(v[left[k]], v[right[k]]);
}

/* Sums over all points, each divided by 2^ceil(log2 count), in Q60.  Every term
 * is rounded to that quotient's LSB, so a sum of n is off by less than
 * n LSB / 2: 2^-47 for the most points there may be, 2^-52 for 500. */
static void sum_source(const ocel_source_t *source, const normal_t *normal, int64_t *m_q60) {
    const int32_t down = -(int32_t)ocel_ceil_log2(source->count);
    size_t i;

    (void)memset(m_q60, 0, sizeof(int64_t) * (size_t)OCEL_M_COUNT);
    /* bound: OCEL_MAX_FIT_POINTS; OCEL_MAX_CRACKS each time in a call of ocel_eye_end or
     * ocel_eye_refit */
    for (i = 0U; i < source->count; i++) {
        int64_t v[OCEL_M_XXX];
        uint32_t k;

        low_monomials(framed_point(source, normal, i), v);
        for (k = 0U; k < (uint32_t)OCEL_M_COUNT; k++) { /* bound: OCEL_M_COUNT */
            m_q60[k] += ocel_scale_q60(monomial(v, k), down);
        }
    }
}

/* The frame of a sheared square with half-sides sx, sy <= 2^32 in Q17 px:
 *   x = x0 + sx u,  y = y0 + sy (shear u + 2^(down - 20) v + centre).
 * G is scaled by 2^-larger so that it stays within 1/2: |shear| <= 4 and
 * 2^(down - 20) <= 8 ask for four bits over the longer side. */
static void frame_of_sides(ocel_solution_t *solution, const normal_t *normal) {
    int64_t *const q = solution->q60;
    const int64_t sx = normal->side_x_q17;
    const int64_t sy = normal->side_y_q17;
    const uint32_t larger = ocel_ceil_log2((uint64_t)((sx > sy) ? sx : sy)) + 4U; /* <= 36 */
    const int32_t up = 60 - (int32_t)larger;
    const int64_t sy_up = ocel_scale_q60(sy, up); /* <= 2^56 */
    const int64_t shear_q57 = ocel_shl64(normal->shear_q20, 57U - SHEAR_BITS);

    q[OCEL_F_SCALE_LOG2] = (int64_t)larger;
    q[OCEL_F_G11] = ocel_scale_q60(sx, up);
    q[OCEL_F_G21] = ocel_mul_q60(sy_up, shear_q57) * 8;
    q[OCEL_F_G22] = ocel_scale_q60(sy_up, (int32_t)normal->down - (int32_t)SHEAR_BITS);
    q[OCEL_F_X0_Q24] = normal->x0_q17 * 128;
    q[OCEL_F_Y0_Q24] =
        (normal->y0_q17 * 128) + ocel_mul_q60(ocel_shl64(sy, 17U), normal->centre_q50);
}

/* The half-side to scale by: Maini's own for the perturbation, which is not
 * affine invariant; elsewhere the next power of two, which is exact. */
static int64_t side_of(int64_t length, bool maini) {
    return maini ? length : ocel_scale_q60(1, (int32_t)ocel_ceil_log2((uint64_t)length));
}

static void normal_of_span(const span_t *span, bool perturb, normal_t *normal) {
    normal->x0_q17 = span->min_x + span->max_x;
    normal->y0_q17 = span->min_y + span->max_y;
    normal->side_x_q17 = side_of(span->max_x - span->min_x, perturb);
    normal->side_y_q17 = side_of(span->max_y - span->min_y, perturb);
    normal->rate_x = (int64_t)ocel_udiv64((uint64_t)1 << 62U, (uint64_t)normal->side_x_q17);
    normal->rate_y = (int64_t)ocel_udiv64((uint64_t)1 << 62U, (uint64_t)normal->side_y_q17);
    normal->shear_q20 = 0;
    normal->centre_q50 = 0;
    normal->down = SHEAR_BITS;
    normal->perturb = perturb;
}

static bool within_range(const span_t *span) {
    const int64_t most = (int64_t)OCEL_MAX_COORDINATE_PX * 65536;

    return (span->min_x >= -most) && (span->max_x <= most) && (span->min_y >= -most) &&
           (span->max_y <= most);
}

ocel_status_t ocel_moments_of_source(const ocel_source_t *source, bool perturb,
                                     ocel_solution_t *solution) {
    const span_t span = span_of_source(source);
    ocel_status_t status = OCEL_OK;

    if (!within_range(&span)) {
        status = OCEL_OUT_OF_RANGE;
    } else if ((span.max_x == span.min_x) || (span.max_y == span.min_y)) {
        status = OCEL_DEGENERATE;
    } else {
        normal_t normal;

        normal_of_span(&span, perturb, &normal);
        if (!perturb) {
            /* at most: 2 in a call of ocel_fit_points or ocel_fit_cracks;
             * 2 * ((OCEL_MAX_CRACKS * (OCEL_MAX_WIDTH * OCEL_MAX_WIDTH +
             * OCEL_MAX_HEIGHT * OCEL_MAX_HEIGHT)) / 536870912) in a call of ocel_eye_refit */
            normal.shear_q20 = shear_q20(source, &normal);
            /* at most: 2 in a call of ocel_fit_points or ocel_fit_cracks;
             * 2 * ((OCEL_MAX_CRACKS * (OCEL_MAX_WIDTH * OCEL_MAX_WIDTH +
             * OCEL_MAX_HEIGHT * OCEL_MAX_HEIGHT)) / 536870912) in a call of ocel_eye_refit */
            fill_unit(source, &normal);
        }
        sum_source(source, &normal, &solution->q60[OCEL_F_MOMENTS]);
        frame_of_sides(solution, &normal);
    }
    return status;
}
