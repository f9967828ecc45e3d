/* SPDX-License-Identifier: MIT
 *
 * A step of Gauss and Newton in (x, y, radius), from a guess that is off by g px, leaves
 * g^2 / R.
 */
#include "cone_refine.h"

#include <string.h>

#include "../base/int_math.h"
#include "../base/q60.h"
#include "../base/scale.h"
#include "../base/sym3.h"

/* Neighbouring cracks err alike: the variance of a mean of n is twice that of n
 * independent errors, and more when the residuals bend. */
#define CORRELATION_LOG2 1

/* Residuals that deviate together: a sector's sum of n has a variance of more than
 * BENT_LIMIT * n times that of one. */
#define BENT_LIMIT 3U

/* Corrections are in units of 8 px. */
#define UNIT_LOG2 3U

/* 1.0: the variance of what is not known. */
#define UNKNOWN_Q60 OCEL_Q60_ONE

/* The cosine of a sector's middle, Q14; its sine is that of eight sectors before. */
static const int16_t cosine_q14[OCEL_SECTORS] = {
    16305,  15679,  14449,  12665,  10394,  7723,   4756,   1606,   -1606,  -4756,  -7723,
    -10394, -12665, -14449, -15679, -16305, -16305, -15679, -14449, -12665, -10394, -7723,
    -4756,  -1606,  1606,   4756,   7723,   10394,  12665,  14449,  15679,  16305};

static int32_t sine_q14(uint32_t sector) {
    return cosine_q14[(sector + 24U) % OCEL_SECTORS];
}

static int64_t within(int64_t v, int64_t most) {
    return (v > most) ? most : ((v < -most) ? -most : v);
}

/* The normal equations, Q60, over the power of two above the inliers' count: a square
 * of a cosine is 2^28, a distance at most 1.5 px.  m and b are zero before. */
static void normal_of(const ocel_cone_sums_t *sums, int64_t m[OCEL_SYM3_COUNT], int64_t b[3]) {
    const uint32_t down = ocel_ceil_log2((uint64_t)sums->inlier_count); /* <= 14 */

    for (uint32_t k = 0U; k < OCEL_SECTORS; k++) { /* bound: OCEL_SECTORS = 32 */
        const int64_t n = sums->inliers[k];
        const int64_t d = sums->d_px_q16[k];
        const int32_t c = cosine_q14[k];
        const int32_t s = sine_q14(k);
        const int32_t cc_q28 = c * c;
        const int32_t cs_q28 = c * s;
        const int32_t ss_q28 = s * s;
        const int32_t c_q28 = c * 16384;
        const int32_t s_q28 = s * 16384;

        m[OCEL_XX] += n * cc_q28;
        m[OCEL_XY] += n * cs_q28;
        m[OCEL_XZ] += n * c_q28;
        m[OCEL_YY] += n * ss_q28;
        m[OCEL_YZ] += n * s_q28;
        m[OCEL_ZZ] += n * 0x10000000;
        b[0] += d * c;
        b[1] += d * s;
        b[2] += d * 16384;
    }
    for (uint32_t k = 0U; k < (uint32_t)OCEL_SYM3_COUNT; k++) { /* bound: 6 */
        m[k] = ocel_shl64(m[k], 32U - down);
    }
    for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 */
        b[k] = ocel_shl64(b[k], (30U - UNIT_LOG2) - down);
    }
}

/* The sum of the squares of what is left in the sectors, and of what is left in the
 * points, both Q24 px^2.  A sector's sum is below 2^31 in Q16 and kept in Q12. */
typedef struct {
    uint64_t sectors_q24;
    uint64_t points_q24;
} rest_t;

static rest_t rest_of(const ocel_cone_sums_t *sums, const int64_t x_q60[3]) {
    int64_t explained_q32 = 0;
    rest_t rest = {0U, 0U};
    int32_t x_q24[3]; /* px */

    for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 */
        x_q24[k] = (int32_t)ocel_shift_round64(x_q60[k], 36U - UNIT_LOG2);
    }
    for (uint32_t k = 0U; k < OCEL_SECTORS; k++) { /* bound: OCEL_SECTORS = 32 */
        const int64_t step_q16 =
            ocel_asr64(((int64_t)x_q24[0] * cosine_q14[k]) + ((int64_t)x_q24[1] * sine_q14(k)) +
                           ((int64_t)x_q24[2] * 16384),
                       22U);
        const int64_t left_q12 =
            ocel_asr64(sums->d_px_q16[k] - (step_q16 * (int64_t)sums->inliers[k]), 4U);

        explained_q32 += step_q16 * sums->d_px_q16[k];
        rest.sectors_q24 += (uint64_t)left_q12 * (uint64_t)left_q12;
    }
    if (sums->squares_q32 > explained_q32) {
        rest.points_q24 = (uint64_t)ocel_asr64(sums->squares_q32 - explained_q32, 8U);
    }
    return rest;
}

static ocel_scaled_t product_of(ocel_scaled_t a, ocel_scaled_t b) {
    const ocel_scaled_t product = {ocel_mul_q60(a.y_q60, b.y_q60), a.e + b.e};

    return product;
}

/* 1 / v, v in Q60. */
static ocel_scaled_t inverse_of(uint64_t v_q60) {
    ocel_scaled_t inverse;

    ocel_recip_q60(v_q60, &inverse.y_q60, &inverse.e);
    return inverse;
}

/* v * 2^e into a number below 1; false when it is none. */
static bool take_below_one(int64_t v_q60, int32_t e, int64_t *below_q60) {
    const bool below = (int32_t)ocel_clz64(ocel_abs64(v_q60)) >= (e + 4);

    *below_q60 = (below && (e >= -62)) ? ocel_scale_q60(v_q60, e) : 0;
    return below;
}

/* cov = frame' local frame, local in Q60 and below 1; each sum of products with a
 * rotation's row or column is below 2. */
static void rotate_covariance(const ocel_cone_frame_t *frame, int64_t local_q60[3][3],
                              int64_t *cov_q60) {
    uint32_t at = 0U;

    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 */
        int64_t row_q60[3] = {0, 0, 0};

        for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 */
            const int64_t r_q60 = (int64_t)frame->r_q30[k][i] * 0x40000000;

            for (uint32_t j = 0U; j < 3U; j++) { /* bound: 3 */
                row_q60[j] += ocel_mul_q60(local_q60[k][j], r_q60);
            }
        }
        for (uint32_t j = i; j < 3U; j++) { /* bound: 3 */
            cov_q60[at] = 0;
            for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 */
                cov_q60[at] += ocel_mul_q60(row_q60[k], (int64_t)frame->r_q30[k][j] * 0x40000000);
            }
            /* Products are floored: a variance of nothing may be an LSB below it. */
            cov_q60[at] = ((i == j) && (cov_q60[at] < 0)) ? 0 : cov_q60[at];
            at++;
        }
    }
}

/* The variance of a point's distance times what makes it the centre's: over
 * (count - 3), the power of two of the normal equations, their determinant, R^2
 * and (1 + t^2)^2. */
static ocel_scaled_t variance_of(const ocel_cone_sums_t *sums, const rest_t *rest,
                                 const ocel_sym3_inverse_t *inverse, int64_t open_q60) {
    const uint64_t most =
        ((rest->points_q24 > rest->sectors_q24) ? rest->points_q24 : rest->sectors_q24) | 1U;
    const uint32_t shift = ocel_clz64(most) - 4U; /* most < 2^60 */
    const uint32_t down = ocel_ceil_log2((uint64_t)sums->inlier_count);
    ocel_scaled_t rate = inverse_of((uint64_t)sums->r_px_q16 << 30U); /* 2^14 / R */
    const ocel_scaled_t open = inverse_of((uint64_t)open_q60);
    const ocel_scaled_t numerator = {ocel_signed64(most << shift),
                                     (36 + CORRELATION_LOG2 - (int32_t)shift) -
                                         (15 + 28 + (int32_t)down)};

    rate = product_of(product_of(rate, rate), product_of(open, open));
    rate = product_of(rate, inverse_of((uint64_t)(sums->inlier_count - 3U) << 45U));
    return product_of(product_of(rate, inverse->rate), numerator);
}

/* The centre's covariance over its distance squared.  With q = (x, y, radius) / R the
 * axis turns by q t / (1 + t^2) and the distance changes by -q / (1 + t^2) of itself. */
static bool covariance_of(const ocel_cone_frame_t *frame, int64_t tan_q60,
                          const ocel_sym3_inverse_t *inverse, ocel_scaled_t variance,
                          ocel_cone_t *cone, ocel_cone_evidence_t *evidence) {
    const int64_t gain_q60[3] = {tan_q60, tan_q60, -OCEL_Q60_ONE};
    int64_t local_q60[3][3];
    bool known = true;

    for (uint32_t i = 0U; i < 3U; i++) {     /* bound: 3 */
        for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 */
            const int64_t entry = ocel_mul_q60(inverse->adjoint_q60[ocel_sym3_at[i][k]],
                                               ocel_mul_q60(gain_q60[i], gain_q60[k]));

            known =
                take_below_one(ocel_mul_q60(entry, variance.y_q60), variance.e, &local_q60[i][k]) &&
                known;
        }
    }
    if (known) {
        rotate_covariance(frame, local_q60, cone->cov_q60);
        evidence->range_sigma2_q60 = local_q60[2][2];
    }
    return known;
}

/* x / R within 1/2, x in units of 8 px; R is 1 px at least, so 8 / R is below 2^4. */
static int64_t over_radius(int64_t x_q60, int32_t r_px_q16) {
    const int64_t half = ocel_shl64((r_px_q16 < 0x100000) ? r_px_q16 : 0x100000, 40U);
    const ocel_scaled_t inverse = inverse_of((uint64_t)r_px_q16 << 30U);

    return ocel_scale_q60(ocel_mul_q60(within(x_q60, half), inverse.y_q60),
                          inverse.e - 14 + (int32_t)UNIT_LOG2);
}

/* The guess moved by x: its axis and its tangent, Q60 and at most 3/2. */
static int64_t step_of(const ocel_cone_frame_t *frame, int32_t r_px_q16, int64_t tan_q60,
                       int64_t open_q60, const int64_t x_q60[3], int32_t axis_cam_q30[3]) {
    const ocel_scaled_t open = inverse_of((uint64_t)open_q60);
    const int64_t gain_q60 = ocel_scale_q60(ocel_mul_q60(tan_q60, open.y_q60), open.e);
    int32_t turn_q28[2];

    for (uint32_t k = 0U; k < 2U; k++) { /* bound: 2 */
        turn_q28[k] = (int32_t)ocel_shift_round64(
            ocel_mul_q60(over_radius(x_q60[k], r_px_q16), gain_q60), 32U);
    }
    ocel_cone_turn(frame, turn_q28[0], turn_q28[1], axis_cam_q30);
    return tan_q60 + ocel_mul_q60(tan_q60, over_radius(x_q60[2], r_px_q16));
}

/* sin = tan / sqrt(1 + tan^2). */
static uint32_t sine_of(int64_t tan_q60) {
    int64_t y_q60;
    int32_t e;

    ocel_rsqrt_q60((uint64_t)OCEL_Q60_ONE + (uint64_t)ocel_mul_q60(tan_q60, tan_q60), &y_q60, &e);
    return (uint32_t)ocel_scale_q60(ocel_mul_q60(tan_q60, y_q60), e - 30);
}

/* The sectors in which inliers are the most, and the gaps that so few of them leave. */
static uint32_t sectors_of(const ocel_cone_sums_t *sums) {
    uint32_t hit = 0U;

    for (uint32_t k = 0U; k < OCEL_SECTORS; k++) { /* bound: OCEL_SECTORS = 32 */
        hit |= (sums->inliers[k] > sums->others[k]) ? ((uint32_t)1U << k) : 0U;
    }
    return ocel_sectors_covered(hit, (2U * OCEL_SECTORS) / (sums->inlier_count + 1U));
}

/* The step, the residual and the covariance; what cannot be solved leaves the guess,
 * with a covariance of 1. */
static void solve_step(const ocel_cone_sums_t *sums, const ocel_cone_guess_t *guess,
                       ocel_cone_t *cone, ocel_cone_evidence_t *evidence) {
    int64_t tan_q60 = ocel_shl64(guess->tan_q46, 14U);
    const int64_t open_q60 = OCEL_Q60_ONE + ocel_mul_q60(tan_q60, tan_q60);
    int64_t x_q60[3] = {0, 0, 0};
    int64_t m_q60[OCEL_SYM3_COUNT] = {0, 0, 0, 0, 0, 0};
    int64_t b_q60[3] = {0, 0, 0};
    ocel_sym3_inverse_t inverse;
    rest_t rest;
    bool known;

    normal_of(sums, m_q60, b_q60);
    known = (sums->inlier_count > 3U) && (sums->r_px_q16 >= 0x10000) &&
            ocel_sym3_invert(m_q60, &inverse) && ocel_sym3_apply(&inverse, b_q60, x_q60);
    rest = rest_of(sums, x_q60);
    evidence->bent =
        rest.sectors_q24 > ((BENT_LIMIT * rest.points_q24) + ((uint64_t)sums->inlier_count << 18U));
    if (known) {
        const int64_t guess_q60 = tan_q60;

        ocel_cone_frame_t frame;

        ocel_cone_frame(guess->axis_cam_q30, &frame);
        tan_q60 = step_of(&frame, sums->r_px_q16, guess_q60, open_q60, x_q60, cone->axis_cam_q30);
        known = covariance_of(&frame, guess_q60, &inverse,
                              variance_of(sums, &rest, &inverse, open_q60), cone, evidence);
    }
    if (!known) {
        cone->cov_q60[OCEL_XX] = UNKNOWN_Q60;
        cone->cov_q60[OCEL_YY] = UNKNOWN_Q60;
        cone->cov_q60[OCEL_ZZ] = UNKNOWN_Q60;
        evidence->range_sigma2_q60 = UNKNOWN_Q60;
    }
    cone->sin_q30 = sine_of(tan_q60);
    if (sums->inlier_count > 0U) {
        const uint64_t square_q32 =
            ocel_udiv64(rest.points_q24 << 8U, (uint64_t)sums->inlier_count);

        cone->rms_px_q16 = (uint32_t)ocel_asr64(ocel_sqrt_q60(square_q32), 30U);
    }
}

void ocel_cone_refine(const ocel_cone_sums_t *sums, const ocel_cone_guess_t *guess,
                      ocel_cone_t *cone, ocel_cone_evidence_t *evidence) {
    (void)memcpy(cone->axis_cam_q30, guess->axis_cam_q30, sizeof(cone->axis_cam_q30));
    cone->inlier_count = sums->inlier_count;
    cone->hypothesis_count = guess->hypothesis_count;
    evidence->outside = sums->outside;
    evidence->sectors = sectors_of(sums);
    cone->arc_coverage_q16 = evidence->sectors * (65536U / OCEL_SECTORS);
    solve_step(sums, guess, cone, evidence);
}
