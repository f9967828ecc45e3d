/* SPDX-License-Identifier: MIT
 *
 * A step of Gauss and Newton in (x, y, radius), from a guess that is off by g px, leaves
 * g^2 / R.  Each sector says how far the outline lies from the guess's there, and how much
 * that is worth:
 *
 * - A sharp mask's outline passes between the two pixels of each crack, so it lies between
 *   low and high.  The middle is the estimate, and the width its worth: of n cracks it is
 *   narrow as 1 / n, where the mean of their midpoints is good to 1 / sqrt(n) only.
 * - Noise, or what is not the ball's, makes low exceed high.  Then the mean is the
 *   estimate, kept between the two, and how much they overlap its worth.
 */
#include "cone_step.h"

#include <string.h>

#include "../base/int_math.h"
#include "../base/q60.h"

/* First by the sectors' own worth, then also by how far each is from the others' outline. */
#define ROUNDS 2U

/* Variances that add to a width's square, px^2 in Q24: what a sector's angle blurs (1/16
 * px); a few cracks that happen to leave little room (1/2 px over their number); points
 * nearby that do not consent, so that some that do may not be the ball's either (1/2 px). */
#define BLUR_Q24 65536U
#define FEW_Q24 ((uint32_t)1U << 22U)
#define MIXED_Q24 ((uint32_t)1U << 22U)

/* What an estimate's interval misses the others' outline by, up to 2 px, counts three times. */
#define MISS_MAX_Q13 16384
#define MISS_TIMES 3U

static const int16_t cosine_q14[OCEL_SECTORS] = {
    16305,  15679,  14449,  12665,  10394,  7723,   4756,   1606,   -1606,  -4756,  -7723,
    -10394, -12665, -14449, -15679, -16305, -16305, -15679, -14449, -12665, -10394, -7723,
    -4756,  -1606,  1606,   4756,   7723,   10394,  12665,  14449,  15679,  16305};

/* The cosine of eight sectors before. */
static int32_t sine_q14(uint32_t sector) {
    return cosine_q14[(sector + 24U) % OCEL_SECTORS];
}

int32_t ocel_cone_shift_q16(const ocel_cone_step_t *step, uint32_t sector) {
    return (int32_t)ocel_asr64(((int64_t)step->x_px_q24[0] * cosine_q14[sector]) +
                                   ((int64_t)step->x_px_q24[1] * sine_q14(sector)) +
                                   ((int64_t)step->x_px_q24[2] * 16384),
                               22U);
}

/* The mean of a sector's d: the sum is below 2^31, so times 2^31 / n it fits. */
static int32_t mean_q13(const ocel_cone_sums_t *sums, uint32_t k) {
    const uint32_t n = sums->inliers[k];
    const uint32_t up = ocel_clz32(n | 1U); /* 17 .. 31 */
    const int64_t y_q31 = ocel_recip32(n << up);

    return (int32_t)ocel_shift_round64(sums->d_px_q16[k] * y_q31, 65U - up);
}

/* Puts a sector's estimate and width in the place of low and high; returns the overlap. */
static int32_t estimate(ocel_cone_sums_t *sums, uint32_t k) {
    const int32_t low = sums->low_px_q13[k];
    const int32_t high = sums->high_px_q13[k];
    int32_t d = ocel_asr32(low + high + 1, 1U); /* each was floored */
    int32_t overlap = low - high;

    if (overlap > 0) {
        d = mean_q13(sums, k);
        d = (d > low) ? low : ((d < high) ? high : d);
    }
    sums->low_px_q13[k] = (int16_t)d;
    sums->high_px_q13[k] = (int16_t)((overlap > 0) ? overlap : -overlap);
    return (overlap > 0) ? overlap : 0;
}

/* All sectors' estimates, and the least variance, Q24 px^2: of twice the mean overlap, which
 * is what noise looks like.  An overlap is below 2.5 px. */
static uint32_t estimate_all(ocel_cone_sums_t *sums, uint32_t *sectors) {
    uint32_t overlap_q13 = 0U;
    uint32_t mean_q12;

    *sectors = 0U;
    for (uint32_t k = 0U; k < OCEL_SECTORS; k++) { /* bound: OCEL_SECTORS = 32 */
        if (sums->inliers[k] > 0U) {
            overlap_q13 += (uint32_t)estimate(sums, k);
            *sectors += 1U;
        }
    }
    mean_q12 = (uint32_t)ocel_udiv64(overlap_q13, (*sectors > 0U) ? *sectors : 1U);
    return BLUR_Q24 + (mean_q12 * mean_q12);
}

/* The least variance over a sector's own, Q25.  With v = m 2^e, 1 / m is taken for the line
 * (3 - m) / 2, right at both ends and up to 12 % too large between, which a weight can
 * bear.  The least is below 2^28.8, v below 2^30.3. */
static int32_t ratio_q25(uint32_t least_q24, uint32_t variance_q24) {
    const uint32_t up = ocel_clz32(variance_q24 | 1U); /* 1 .. 15 */
    const uint32_t y_q31 = 0xC0000000U - ((variance_q24 << up) >> 1U);

    return (int32_t)(uint32_t)(((uint64_t)least_q24 * y_q31) >> (37U - up));
}

/* A sector's weight, Q25, at most 2^25; of points, of which nothing is known but their number,
 * that over the power of two above all, at most 2^30 for all together. */
static int32_t sector_weight_q25(const ocel_cone_sums_t *sums, uint32_t k, uint32_t least_q24,
                                 uint32_t miss_q12) {
    const uint32_t n = sums->inliers[k];
    const uint32_t width_q12 = (uint32_t)sums->high_px_q13[k] >> 1U;
    const uint32_t variance_q24 = least_q24 + (width_q12 * width_q12) + (miss_q12 * miss_q12) +
                                  (FEW_Q24 >> (2U * (31U - ocel_clz32(n | 1U)))) +
                                  (((sums->mixed >> k) & 1U) * MIXED_Q24);

    return sums->cracks ? ratio_q25(least_q24, variance_q24)
                        : (int32_t)(n << (30U - ocel_ceil_log2((uint64_t)sums->inlier_count)));
}

/* The normal equations; d is below 2^14.4. */
typedef struct {
    int64_t m[OCEL_SYM3_COUNT]; /* Q39, Q25 with z, after sum_sectors Q60 */
    int64_t b_q38[3];           /* after sum_sectors Q60, in 8 px */
    int64_t squares_q51;        /* Q56 over 32 */
} normal_equations_t;

static void add_sector(normal_equations_t *normal, uint32_t k, int32_t weight_q25, int32_t d_q13) {
    const int32_t c_q14 = cosine_q14[k];
    const int32_t s_q14 = sine_q14(k);
    const int32_t wc_q25 = (int32_t)ocel_asr64((int64_t)weight_q25 * c_q14, 14U);
    const int32_t ws_q25 = (int32_t)ocel_asr64((int64_t)weight_q25 * s_q14, 14U);
    const int64_t wd_q38 = (int64_t)weight_q25 * d_q13;

    normal->m[OCEL_XX] += (int64_t)wc_q25 * c_q14;
    normal->m[OCEL_XY] += (int64_t)wc_q25 * s_q14;
    normal->m[OCEL_XZ] += wc_q25;
    normal->m[OCEL_YY] += (int64_t)ws_q25 * s_q14;
    normal->m[OCEL_YZ] += ws_q25;
    normal->m[OCEL_ZZ] += weight_q25;
    normal->b_q38[0] += (int64_t)wc_q25 * d_q13;
    normal->b_q38[1] += (int64_t)ws_q25 * d_q13;
    normal->b_q38[2] += wd_q38;
    normal->squares_q51 += wd_q38 * d_q13;
}

/* How far the step's outline lies outside of a sector's interval, up to 2 px. */
static uint32_t miss_q12(const ocel_cone_sums_t *sums, const ocel_cone_step_t *step, uint32_t k) {
    const int32_t off_q13 = sums->low_px_q13[k] - ocel_asr32(ocel_cone_shift_q16(step, k), 3U);
    const int32_t miss_q13 =
        ((off_q13 < 0) ? -off_q13 : off_q13) - ocel_asr32(sums->high_px_q13[k], 1U);

    return (miss_q13 < 0) ? 0U
                          : ((uint32_t)((miss_q13 > MISS_MAX_Q13) ? MISS_MAX_Q13 : miss_q13) >> 1U);
}

/* Sums over 32 sectors, so Q55 is Q60 of a number of at most 1; and b is over 8 px too. */
static void sum_sectors(const ocel_cone_sums_t *sums, const ocel_cone_step_t *step,
                        uint32_t least_q24, bool first, normal_equations_t *normal) {
    static const uint8_t up[OCEL_SYM3_COUNT] = {16U, 16U, 30U, 16U, 30U, 30U};

    (void)memset(normal, 0, sizeof(*normal));
    for (uint32_t k = 0U; k < OCEL_SECTORS; k++) { /* bound: OCEL_SECTORS = 32 */
        if (sums->inliers[k] > 0U) {
            const uint32_t miss = first ? 0U : (MISS_TIMES * miss_q12(sums, step, k));

            add_sector(normal, k, sector_weight_q25(sums, k, least_q24, miss), sums->low_px_q13[k]);
        }
    }
    for (uint32_t k = 0U; k < (uint32_t)OCEL_SYM3_COUNT; k++) { /* bound: 6 */
        normal->m[k] = ocel_shl64(normal->m[k], up[k]);
    }
    for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 */
        normal->b_q38[k] = ocel_shl64(normal->b_q38[k], 14U);
    }
}

bool ocel_cone_step(ocel_cone_sums_t *sums, ocel_cone_step_t *step) {
    const uint32_t least_q24 = estimate_all(sums, &step->sectors);
    bool known = (sums->inlier_count > 3U) && (sums->r_px_q16 >= 0x10000);
    normal_equations_t normal;

    (void)memset(step->x_px_q24, 0, sizeof(step->x_px_q24));
    for (uint32_t round = 0U; known && (round < ROUNDS); round++) { /* bound: ROUNDS = 2 */
        int64_t x_q60[3];                                           /* in 8 px */

        sum_sectors(sums, step, least_q24, round == 0U, &normal);
        known = ocel_sym3_invert(normal.m, &step->inverse) &&
                ocel_sym3_apply(&step->inverse, normal.b_q38, x_q60);
        for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 */
            step->x_px_q24[k] = known ? (int32_t)ocel_asr64(x_q60[k], 33U) : 0;
            normal.squares_q51 -=
                known ? ocel_shl64(ocel_mul_q60(x_q60[k], normal.b_q38[k]), 2U) : 0;
        }
    }
    step->misfit_q56 = (known && (normal.squares_q51 > 0)) ? (uint64_t)normal.squares_q51 : 0U;
    return known;
}
