/* SPDX-License-Identifier: MIT */
#include "cone_refine.h"

#include <string.h>

#include "../base/int_math.h"
#include "../base/q60.h"
#include "../base/scale.h"
#include "../base/sym3.h"
#include "cone_move.h"
#include "cone_step.h"

/* Residuals that deviate together: a sector's sum of n has a variance of more than
 * BENT_LIMIT * n times that of one. */
#define BENT_LIMIT 3U

/* What a cone must show to be vouched for (cone.h tells it in words; DESIGN.md what
 * it was tried on). */
#define INLIERS_MIN_OF 2U      /* more than one of 2 points consents */
#define OUTSIDE_MAX_OF 25U     /* one of 25 points is outside */
#define SECTORS_MIN 8U         /* a quarter of the turn is seen */
#define RMS_PX_Q16 9175U       /* .14 px, */
#define RMS_SECTOR_PX_Q16 786U /* and .012 px for each sector seen */

/* .01^2 in Q60: the range is expected within 1 %. */
#define RANGE_SIGMA2_MAX_Q60 ((int64_t)115292150460685)

static bool is_vouched(const ocel_cone_sums_t *sums, const ocel_cone_t *cone, uint32_t sectors,
                       int64_t range_sigma2_q60) {
    return ((cone->inlier_count * INLIERS_MIN_OF) > cone->point_count) &&
           ((sums->outside * OUTSIDE_MAX_OF) <= cone->point_count) && (sectors >= SECTORS_MIN) &&
           (range_sigma2_q60 <= RANGE_SIGMA2_MAX_Q60) &&
           (cone->rms_px_q16 <= (RMS_PX_Q16 + (RMS_SECTOR_PX_Q16 * sectors)));
}

/* What the step leaves: the points' RMS; true when they deviate together, by the squares of
 * what is left in the sectors that are not mixed beside that of what is left in the points,
 * Q24 px^2.  A sector's sum is below 2^31 in Q16 and kept in Q12; a shift is below 2^21 in
 * Q16, so the points' is below 2^62 in Q32. */
static bool weigh_rest(const ocel_cone_sums_t *sums, const ocel_cone_step_t *step,
                       uint32_t *rms_px_q16) {
    int64_t points_q32 = sums->squares_q32;
    uint64_t sectors_q24 = 0U;

    for (uint32_t k = 0U; k < OCEL_SECTORS; k++) { /* bound: OCEL_SECTORS = 32 */
        const int64_t shift_q16 = ocel_cone_shift_q16(step, k);
        const int64_t sum_q16 = sums->d_px_q16[k];
        const int64_t left_q16 = sum_q16 - (shift_q16 * (int64_t)sums->inliers[k]);
        const int64_t left_q12 = ocel_asr64(left_q16, 4U);

        points_q32 -= shift_q16 * (sum_q16 + left_q16);
        sectors_q24 += (((sums->mixed >> k) & 1U) != 0U) ? 0U : (uint64_t)(left_q12 * left_q12);
    }
    points_q32 = (points_q32 > 0) ? points_q32 : 0;
    if (sums->inlier_count > 0U) {
        *rms_px_q16 = (uint32_t)ocel_asr64(
            ocel_sqrt_q60(ocel_udiv64((uint64_t)points_q32, (uint64_t)sums->inlier_count)), 30U);
    }
    return sectors_q24 >
           ((BENT_LIMIT * ((uint64_t)points_q32 >> 8U)) + ((uint64_t)sums->inlier_count << 18U));
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

/* Moves the cone by the step; what cannot be solved leaves the guess.  Returns the variance of
 * the range over its square. */
static int64_t take_step(ocel_cone_step_t *step, bool known, int32_t r_px_q16,
                         const ocel_cone_guess_t *guess, ocel_cone_t *cone) {
    int64_t tan_q60 = ocel_shl64(guess->tan_q46, 14U);
    ocel_cone_frame_t frame;
    const int64_t guess_q60 = tan_q60;
    int64_t sigma2_q60;

    ocel_cone_frame(guess->axis_cam_q30, &frame);
    (void)memcpy(cone->axis_cam_q30, guess->axis_cam_q30, sizeof(cone->axis_cam_q30));
    if (known) {
        tan_q60 = ocel_cone_move(&frame, tan_q60, step, r_px_q16, cone->axis_cam_q30);
    }
    sigma2_q60 = ocel_cone_spread(&frame, guess_q60, known ? step : NULL, r_px_q16, cone->cov_q60);
    cone->sin_q30 = sine_of(tan_q60);
    return sigma2_q60;
}

bool ocel_cone_refine(ocel_cone_sums_t *sums, const ocel_cone_guess_t *guess, ocel_cone_t *cone) {
    ocel_cone_step_t step;
    const bool known = ocel_cone_step(sums, &step);
    const bool bent = weigh_rest(sums, &step, &cone->rms_px_q16);
    const int64_t sigma2_q60 = take_step(&step, known, sums->r_px_q16, guess, cone);
    const uint32_t sectors = sectors_of(sums);

    cone->inlier_count = sums->inlier_count;
    cone->hypothesis_count = guess->hypothesis_count;
    cone->arc_coverage_q16 = sectors * (65536U / OCEL_SECTORS);
    return (!bent) && is_vouched(sums, cone, sectors, sigma2_q60);
}
