/* SPDX-License-Identifier: MIT */
#include "moments.h"

#include <string.h>

#include "int_math.h"
#include "perturb.h"
#include "q60.h"
#include "scale.h"
#include "wide.h"

/* Fraction bits of normalised coordinates in the wide sums: u^4 summed over
 * 2^14 points takes 4*26 + 14 = 118 of the 127 bits. */
#define UNIT_BITS 26U

/* Fraction bits of the shear, and of the coordinates from which it is found. */
#define SHEAR_BITS 20U
#define COARSE_BITS 13U

/* The steepest shear, 4.0.  Any shear is right (the fit is affine invariant or
 * knows the frame's metric); a steeper one would only lengthen the products. */
#define SHEAR_MAX ((int64_t)4 << SHEAR_BITS)

typedef struct {
    int64_t min_x;
    int64_t max_x;
    int64_t min_y;
    int64_t max_y;
} span_t;

/* Powers of x and of y in each moment, in the order of OCEL_M_*. */
static const uint8_t power_x[OCEL_M_COUNT] = {0, 1, 0, 2, 1, 0, 3, 2, 1, 0, 4, 3, 2, 1, 0};
static const uint8_t power_y[OCEL_M_COUNT] = {0, 0, 1, 0, 1, 2, 0, 1, 2, 3, 0, 1, 2, 3, 4};

/* Smallest e with 2^e >= n, n >= 1. */
static uint32_t ceil_log2(uint64_t n) {
    return (n <= 1U) ? 0U : (64U - ocel_clz64(n - 1U));
}

/* ---- Cracks: exact sums in half pixels, in one pass ---- */

typedef struct {
    uint64_t sum[OCEL_M_COUNT]; /* two's complement, modulo 2^64 */
    uint64_t any_xx;            /* the or of all squares: its bits bound every |x| */
    uint64_t any_yy;
} crack_sums_t;

/* Sums of u^i v^j, u and v the offsets from (x0, y0).  Modulo 2^64, so that
 * nothing can overflow here; the caller asks the bits whether the sums fit. */
static void sum_cracks(const ocel_crack_t *cracks, size_t count, int32_t x0, int32_t y0,
                       crack_sums_t *sums) {
    uint64_t s_x = 0U, s_y = 0U, s_xx = 0U, s_xy = 0U, s_yy = 0U;
    uint64_t s_xxx = 0U, s_xxy = 0U, s_xyy = 0U, s_yyy = 0U;
    uint64_t s_xxxx = 0U, s_xxxy = 0U, s_xxyy = 0U, s_xyyy = 0U, s_yyyy = 0U;
    uint64_t any_xx = 0U, any_yy = 0U;
    size_t i;

    for (i = 0U; i < count; i++) { /* bound: count <= OCEL_MAX_FIT_POINTS */
        const uint64_t x = (uint64_t)((int64_t)cracks[i].x_hpx - x0);
        const uint64_t y = (uint64_t)((int64_t)cracks[i].y_hpx - y0);
        const uint64_t xx = x * x;
        const uint64_t xy = x * y;
        const uint64_t yy = y * y;

        any_xx |= xx;
        any_yy |= yy;
        s_x += x;
        s_y += y;
        s_xx += xx;
        s_xy += xy;
        s_yy += yy;
        s_xxx += xx * x;
        s_xxy += xx * y;
        s_xyy += yy * x;
        s_yyy += yy * y;
        s_xxxx += xx * xx;
        s_xxxy += xx * xy;
        s_xxyy += xx * yy;
        s_xyyy += xy * yy;
        s_yyyy += yy * yy;
    }
    sums->any_xx = any_xx;
    sums->any_yy = any_yy;
    sums->sum[OCEL_M_1] = count;
    sums->sum[OCEL_M_X] = s_x;
    sums->sum[OCEL_M_Y] = s_y;
    sums->sum[OCEL_M_XX] = s_xx;
    sums->sum[OCEL_M_XY] = s_xy;
    sums->sum[OCEL_M_YY] = s_yy;
    sums->sum[OCEL_M_XXX] = s_xxx;
    sums->sum[OCEL_M_XXY] = s_xxy;
    sums->sum[OCEL_M_XYY] = s_xyy;
    sums->sum[OCEL_M_YYY] = s_yyy;
    sums->sum[OCEL_M_XXXX] = s_xxxx;
    sums->sum[OCEL_M_XXXY] = s_xxxy;
    sums->sum[OCEL_M_XXYY] = s_xxyy;
    sums->sum[OCEL_M_XYYY] = s_xyyy;
    sums->sum[OCEL_M_YYYY] = s_yyyy;
}

/* The frame of a box whose half-sides are 2^ex and 2^ey Q17 px: exact. */
static void frame_of_powers(ocel_frame_t *frame, uint32_t ex, uint32_t ey) {
    const uint32_t larger = (ex > ey) ? ex : ey;

    frame->scale_log2 = (int32_t)larger + 1; /* so that G is at most 1/2 */
    frame->g11_q60 = (int64_t)1 << (59U - (larger - ex));
    frame->g21_q60 = 0;
    frame->g22_q60 = (int64_t)1 << (59U - (larger - ey));
}

/* The least b with every |x| < 2^b, from the or of the squares. */
static uint32_t bits_of_root(uint64_t any_square) {
    return (65U - ocel_clz64(any_square)) / 2U;
}

bool ocel_moments_of_cracks(const ocel_crack_t *cracks, size_t count, ocel_moments_t *moments) {
    const ocel_crack_t *const first = &cracks[0];
    const ocel_crack_t *const middle = &cracks[count / 2U];
    const int32_t x0 = ocel_asr32((int32_t)first->x_hpx + middle->x_hpx, 1U);
    const int32_t y0 = ocel_asr32((int32_t)first->y_hpx + middle->y_hpx, 1U);
    const uint32_t en = ceil_log2(count);
    crack_sums_t sums;
    uint32_t ex;
    uint32_t ey;
    bool exact;

    sum_cracks(cracks, count, x0, y0, &sums);
    ex = bits_of_root(sums.any_xx);
    ey = bits_of_root(sums.any_yy);
    exact = ((4U * ((ex > ey) ? ex : ey)) + en) <= 62U;
    if (exact) {
        uint32_t i;

        for (i = 0U; i < (uint32_t)OCEL_M_COUNT; i++) { /* bound: OCEL_M_COUNT */
            /* |sum| <= 2^down, so the Q60 value is at most 1. */
            const uint32_t down = (ex * power_x[i]) + (ey * power_y[i]) + en;

            moments->m_q60[i] = ocel_scale_q60((int64_t)sums.sum[i], 60 - (int32_t)down);
        }
        moments->frame.x0_px_q24 = (int64_t)x0 * ((int64_t)1 << 23U);
        moments->frame.y0_px_q24 = (int64_t)y0 * ((int64_t)1 << 23U);
        frame_of_powers(&moments->frame, ex + 16U, ey + 16U);
    }
    return exact;
}

/* ---- Any points: normalised to Q26, sheared, summed in 128 bits ---- */

/* The normalisation: u = (2 x - x0) * rate / 2^36, in Q26. */
typedef struct {
    int64_t x0_q17;
    int64_t y0_q17;
    int64_t side_x_q17; /* half-sides, 1..2^32 */
    int64_t side_y_q17;
    int64_t rate_x; /* 2^62 / half-side */
    int64_t rate_y;
} normal_t;

static span_t span_of_source(const ocel_source_t *source) {
    const ocel_pair_t first = ocel_source_px_q16(source, 0U);
    span_t span = {first.x, first.x, first.y, first.y};
    size_t i;

    for (i = 1U; i < source->count; i++) { /* bound: count <= OCEL_MAX_FIT_POINTS */
        const ocel_pair_t p = ocel_source_px_q16(source, i);

        span.min_x = (p.x < span.min_x) ? p.x : span.min_x;
        span.max_x = (p.x > span.max_x) ? p.x : span.max_x;
        span.min_y = (p.y < span.min_y) ? p.y : span.min_y;
        span.max_y = (p.y > span.max_y) ? p.y : span.max_y;
    }
    return span;
}

/* A normalised point, |x|, |y| <= 2^26.  2 X - x0 is at most the half-side s in
 * Q17, so its product with rate = 2^62 / s is at most 2^62. */
static ocel_pair_t normalised_q26(const ocel_source_t *source, const normal_t *normal, size_t i) {
    ocel_pair_t p = ocel_source_px_q16(source, i);

    p.x = ocel_shift_round64(((2 * p.x) - normal->x0_q17) * normal->rate_x, 62U - UNIT_BITS);
    p.y = ocel_shift_round64(((2 * p.y) - normal->y0_q17) * normal->rate_y, 62U - UNIT_BITS);
    return p;
}

/* The slope of y on x, Q20, within +-SHEAR_MAX.  Coarse coordinates of 13 bits:
 * |sums| <= 2^14 * 2^26 = 2^40, shifted up 20 bits for the division. */
static int64_t shear_q20(const ocel_source_t *source, const normal_t *normal) {
    int64_t s_xx = 0;
    int64_t s_xy = 0;
    int64_t shear = 0;
    size_t i;

    for (i = 0U; i < source->count; i++) { /* bound: count <= OCEL_MAX_FIT_POINTS */
        const ocel_pair_t p = normalised_q26(source, normal, i);
        const int64_t x = ocel_asr64(p.x, UNIT_BITS - COARSE_BITS);
        const int64_t y = ocel_asr64(p.y, UNIT_BITS - COARSE_BITS);

        s_xx += x * x;
        s_xy += x * y;
    }
    if (s_xx > 0) {
        const uint64_t rise = (uint64_t)((s_xy < 0) ? -s_xy : s_xy) << SHEAR_BITS;

        shear = (int64_t)ocel_udiv64(rise, (uint64_t)s_xx);
        shear = (shear > SHEAR_MAX) ? SHEAR_MAX : shear;
        shear = (s_xy < 0) ? -shear : shear;
    }
    return shear;
}

/* How y is sheared: y' = (y - shear * x - centre) in Q46, shifted down to Q26
 * of a unit that is 2^(down - 20) of the old one. */
typedef struct {
    int64_t shear_q20;
    int64_t centre_q46;
    uint32_t down; /* 0..23 */
} shear_t;

/* y - shear * x in Q46: |.| <= (1 + 4) * 2^46 < 2^49. */
static int64_t sheared_q46(ocel_pair_t p, int64_t shear) {
    return (p.y * ((int64_t)1 << SHEAR_BITS)) - (p.x * shear);
}

/* Centre and unit that make the sheared y fill [-1, 1].  Points on a line have
 * no spread; down stops at 0 and the fit finds their variance too small. */
static void fill_unit(const ocel_source_t *source, const normal_t *normal, shear_t *shear) {
    int64_t low = INT64_MAX;
    int64_t high = INT64_MIN;
    uint32_t half_log2;
    size_t i;

    for (i = 0U; i < source->count; i++) { /* bound: count <= OCEL_MAX_FIT_POINTS */
        const int64_t y = sheared_q46(normalised_q26(source, normal, i), shear->shear_q20);

        low = (y < low) ? y : low;
        high = (y > high) ? y : high;
    }
    shear->centre_q46 = ocel_asr64(low + high, 1U);
    half_log2 = ceil_log2((uint64_t)(high - shear->centre_q46) + 1U);
    shear->down = (half_log2 > UNIT_BITS) ? (half_log2 - UNIT_BITS) : 0U;
}

/* Adds one point's fourteen monomials; |x|, |y| <= 1.01 * 2^26. */
static void sum_point(ocel_i128_t *sum, ocel_pair_t p) {
    const int64_t xx = p.x * p.x;
    const int64_t xy = p.x * p.y;
    const int64_t yy = p.y * p.y;

    ocel_i128_add64(&sum[OCEL_M_X], p.x);
    ocel_i128_add64(&sum[OCEL_M_Y], p.y);
    ocel_i128_add64(&sum[OCEL_M_XX], xx);
    ocel_i128_add64(&sum[OCEL_M_XY], xy);
    ocel_i128_add64(&sum[OCEL_M_YY], yy);
    ocel_i128_mac(&sum[OCEL_M_XXX], xx, p.x);
    ocel_i128_mac(&sum[OCEL_M_XXY], xx, p.y);
    ocel_i128_mac(&sum[OCEL_M_XYY], yy, p.x);
    ocel_i128_mac(&sum[OCEL_M_YYY], yy, p.y);
    ocel_i128_mac(&sum[OCEL_M_XXXX], xx, xx);
    ocel_i128_mac(&sum[OCEL_M_XXXY], xx, xy);
    ocel_i128_mac(&sum[OCEL_M_XXYY], xx, yy);
    ocel_i128_mac(&sum[OCEL_M_XYYY], xy, yy);
    ocel_i128_mac(&sum[OCEL_M_YYYY], yy, yy);
}

static ocel_pair_t framed_q26(const ocel_source_t *source, const normal_t *normal,
                              const shear_t *shear, bool perturb, size_t i) {
    ocel_pair_t p = normalised_q26(source, normal, i);

    if (perturb) {
        int32_t x = (int32_t)p.x;
        int32_t y = (int32_t)p.y;

        ocel_perturb_point(&x, &y);
        p.x = x;
        p.y = y;
    } else {
        p.y = ocel_shift_round64(sheared_q46(p, shear->shear_q20) - shear->centre_q46, shear->down);
    }
    return p;
}

/* Sums over all points, each divided by 2^ceil(log2 count), in Q60. */
static void sum_source(const ocel_source_t *source, const normal_t *normal, const shear_t *shear,
                       bool perturb, int64_t *m_q60) {
    ocel_i128_t sum[OCEL_M_COUNT];
    const uint32_t en = ceil_log2(source->count);
    uint32_t k;
    size_t i;

    (void)memset(sum, 0, sizeof(sum));
    for (i = 0U; i < source->count; i++) { /* bound: count <= OCEL_MAX_FIT_POINTS */
        sum_point(sum, framed_q26(source, normal, shear, perturb, i));
    }
    m_q60[OCEL_M_1] = (int64_t)((uint64_t)source->count << (60U - en));
    for (k = 1U; k < (uint32_t)OCEL_M_COUNT; k++) { /* bound: OCEL_M_COUNT */
        const uint32_t degree = (uint32_t)power_x[k] + power_y[k];

        m_q60[k] = ocel_i128_shift(&sum[k], (int32_t)((UNIT_BITS * degree) + en) - 60);
    }
}

/* The frame of a sheared square with half-sides sx, sy <= 2^32 in Q17 px:
 *   x = x0 + sx u,  y = y0 + sy (shear u + 2^(down - 20) v + centre).
 * G is scaled by 2^-larger so that it stays within 1/2: |shear| <= 4 and
 * 2^(down - 20) <= 8 ask for four bits over the longer side. */
static void frame_of_sides(ocel_frame_t *frame, const normal_t *normal, const shear_t *shear) {
    const int64_t sx = normal->side_x_q17;
    const int64_t sy = normal->side_y_q17;
    const uint32_t larger = ceil_log2((uint64_t)((sx > sy) ? sx : sy)) + 4U; /* <= 36 */
    const uint32_t up = 60U - larger;
    const int64_t sy_up = sy * ((int64_t)1 << up);                    /* <= 2^56 */
    const int64_t shear_q57 = shear->shear_q20 * ((int64_t)1 << 37U); /* <= 2^59 */

    frame->scale_log2 = (int32_t)larger;
    frame->g11_q60 = sx * ((int64_t)1 << up);
    frame->g21_q60 = ocel_mul_q60(sy_up, shear_q57) * 8;
    frame->g22_q60 = ocel_shift_round64(sy_up, SHEAR_BITS) * ((int64_t)1 << shear->down);
    frame->x0_px_q24 = normal->x0_q17 * 128;
    frame->y0_px_q24 =
        (normal->y0_q17 * 128) + ocel_mul_q60(sy * ((int64_t)1 << 20U), shear->centre_q46 * 2);
}

/* Rates of the sides: of Maini's own for the perturbation, which is not affine
 * invariant; elsewhere of the next powers of two, which are exact. */
static void normal_of_span(const span_t *span, bool maini, normal_t *normal) {
    const int64_t width = span->max_x - span->min_x;
    const int64_t height = span->max_y - span->min_y;

    normal->x0_q17 = span->min_x + span->max_x;
    normal->y0_q17 = span->min_y + span->max_y;
    normal->side_x_q17 = maini ? width : (int64_t)((uint64_t)1 << ceil_log2((uint64_t)width));
    normal->side_y_q17 = maini ? height : (int64_t)((uint64_t)1 << ceil_log2((uint64_t)height));
    normal->rate_x = (int64_t)ocel_udiv64((uint64_t)1 << 62U, (uint64_t)normal->side_x_q17);
    normal->rate_y = (int64_t)ocel_udiv64((uint64_t)1 << 62U, (uint64_t)normal->side_y_q17);
}

static bool within_range(const span_t *span) {
    const int64_t most = (int64_t)OCEL_MAX_COORDINATE_PX * 65536;

    return (span->min_x >= -most) && (span->max_x <= most) && (span->min_y >= -most) &&
           (span->max_y <= most);
}

ocel_status_t ocel_moments_of_source(const ocel_source_t *source, bool perturb,
                                     ocel_moments_t *moments) {
    const span_t span = span_of_source(source);
    shear_t shear = {0, 0, SHEAR_BITS};
    normal_t normal;
    ocel_status_t status = OCEL_OK;

    if (!within_range(&span)) {
        status = OCEL_OUT_OF_RANGE;
    } else if ((span.max_x == span.min_x) || (span.max_y == span.min_y)) {
        status = OCEL_DEGENERATE;
    } else {
        normal_of_span(&span, perturb, &normal);
        if (!perturb) {
            shear.shear_q20 = shear_q20(source, &normal);
            fill_unit(source, &normal, &shear);
        }
        sum_source(source, &normal, &shear, perturb, moments->m_q60);
        frame_of_sides(&moments->frame, &normal, &shear);
    }
    return status;
}
