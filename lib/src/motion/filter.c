/* SPDX-License-Identifier: MIT */
#include "filter.h"

#include <string.h>

#include "../base/int_math.h"
#include "../base/q60.h"
#include "seconds.h"

/* Limits of the state: 2^30 u in Q16, and a deviation of 2^26 u in Q6. */
#define P_LIMIT_Q16 0x400000000000
#define VARIANCE_LIMIT_Q6 0x400000000000000

/* Factors, of time and of gain, are Q47: a gain of velocity, up to 2^13 / s, then
 * fits 2^60. */
#define FACTOR_BITS OCEL_SECONDS_BITS

/* The entries of a block, the covariances of (p, v) with (p, v). */
enum { PP = 0, PV, VP, VV, BLOCK };

/* Row and column of a symmetric matrix's entries, and where its diagonal is. */
static const uint8_t first_axis[OCEL_SYM3_COUNT] = {0U, 0U, 0U, 1U, 1U, 2U};
static const uint8_t second_axis[OCEL_SYM3_COUNT] = {0U, 1U, 2U, 1U, 2U, 2U};
static const uint8_t diagonal[3] = {OCEL_XX, OCEL_YY, OCEL_ZZ};

static int64_t square_q6(int32_t v) {
    return (int64_t)v * v * 64;
}

/* The block of two axes when along each the state's `to` (0: position, 1: velocity)
 * gains its own multiple of `from`: first the rows, then the columns. */
static void mix(int64_t block[BLOCK], uint32_t to, uint32_t from, int64_t row_q47,
                int64_t column_q47) {
    for (uint32_t k = 0U; k < 2U; k++) { /* bound: 2, position and velocity */
        ocel_add_product(&block[(2U * to) + k], block[(2U * from) + k], row_q47);
    }
    for (uint32_t k = 0U; k < 4U; k += 2U) { /* bound: 2, position and velocity */
        ocel_add_product(&block[k + to], block[k + from], column_q47);
    }
}

static int64_t limit_variance(int64_t variance, int64_t limit) {
    return (variance < 0) ? 0 : ocel_clamp64(variance, limit);
}

/* Variances are not negative, and no larger than what is known beforehand. */
static void limit_state(ocel_filter_t *filter, int32_t max_speed_u_s) {
    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
        int64_t *const block = filter->cov_q6[diagonal[i]];

        block[PP] = limit_variance(block[PP], VARIANCE_LIMIT_Q6);
        block[VV] = limit_variance(block[VV], square_q6(max_speed_u_s));
        filter->p_u_q16[i] = ocel_clamp64(filter->p_u_q16[i], P_LIMIT_Q16);
        filter->v_u_s_q16[i] = ocel_clamp64(filter->v_u_s_q16[i], (int64_t)max_speed_u_s * 65536);
    }
}

/* Positions are whole numbers, which nothing knows better than to 1 u: so much is added
 * to a variance, and none is 0. */
void ocel_filter_fix(ocel_fix_t *fix, const ocel_estimate_t *measurement) {
    for (uint32_t entry = 0U; entry < (uint32_t)OCEL_SYM3_COUNT; entry++) { /* bound: 6 */
        fix->cov_q6[entry] = ocel_shl64(measurement->cov_root_u2[entry], 6U);
    }
    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
        fix->p_u_q16[i] = (int64_t)measurement->p_root_u[i] * 65536;
        fix->cov_q6[diagonal[i]] += 64;
    }
}

void ocel_filter_start(ocel_filter_t *filter, const ocel_tracker_config_t *config,
                       const ocel_fix_t *fix) {
    const int32_t speed_u_s =
        (int32_t)ocel_udiv64((uint64_t)(uint32_t)config->max_speed_u_s << 16U, config->gate_q16);

    (void)memset(filter, 0, sizeof(*filter));
    (void)memcpy(filter->p_u_q16, fix->p_u_q16, sizeof(filter->p_u_q16));
    for (uint32_t entry = 0U; entry < (uint32_t)OCEL_SYM3_COUNT; entry++) { /* bound: 6 */
        filter->cov_q6[entry][PP] = fix->cov_q6[entry];
        filter->cov_q6[entry][VV] =
            (first_axis[entry] == second_axis[entry]) ? square_q6(speed_u_s) : 0;
    }
}

/* White noise of the acceleration, of density q = wander^2 / s, adds q t to the
 * velocity's variance, q t^2 / 2 to its covariance with the position and q t^3 / 3 to
 * the position's (Bar-Shalom, Li and Kirubarajan, "Estimation with Applications to
 * Tracking and Navigation", 6.2.2).  Here half of q t comes before the step and half
 * after it, which gives the first two, and q t^3 / 2: on the safe side. */
void ocel_filter_advance(ocel_filter_t *filter, const ocel_tracker_config_t *config,
                         uint32_t dt_us) {
    const int64_t t_q47 = ocel_seconds_q47(dt_us);
    const int64_t half_q47 = ocel_asr64(t_q47, 1U);
    const int64_t wander_q6 = square_q6(config->wander_u_s);

    for (uint32_t entry = 0U; entry < (uint32_t)OCEL_SYM3_COUNT; entry++) { /* bound: 6 */
        int64_t *const block = filter->cov_q6[entry];
        const int64_t q = (first_axis[entry] == second_axis[entry]) ? wander_q6 : 0;

        ocel_add_product(&block[VV], q, half_q47);
        mix(block, 0U, 1U, t_q47, t_q47);
        ocel_add_product(&block[VV], q, half_q47);
    }
    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
        const int64_t a_q16 = (int64_t)config->acceleration_root_u_s2[i] * 65536;

        ocel_add_product(&filter->v_u_s_q16[i], a_q16, half_q47);
        ocel_add_product(&filter->p_u_q16[i], filter->v_u_s_q16[i], t_q47);
        ocel_add_product(&filter->v_u_s_q16[i], a_q16, half_q47);
    }
    limit_state(filter, config->max_speed_u_s);
}

/* The variance of a measurement against what was predicted: 64 .. 2^59. */
static int64_t variance_q6(const ocel_filter_t *filter, const ocel_fix_t *fix, uint32_t axis) {
    return filter->cov_q6[diagonal[axis]][PP] + fix->cov_q6[diagonal[axis]];
}

bool ocel_filter_admits(const ocel_filter_t *filter, const ocel_tracker_config_t *config,
                        const ocel_fix_t *fix) {
    bool admits = true;

    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
        const uint64_t sigma_q3 = ocel_isqrt64((uint64_t)variance_q6(filter, fix, i));
        const uint64_t reach_q16 = ((sigma_q3 * config->gate_q16) >> 3U) +
                                   ((uint64_t)(uint32_t)config->gate_floor_u << 16U);

        admits = admits && (ocel_abs64(fix->p_u_q16[i] - filter->p_u_q16[i]) <= reach_q16);
    }
    return admits;
}

/* The block of two axes after a measurement: (I - K H) P (I - K H)' + K R K', for the
 * gains -K.  The velocity goes first, as it gains from the position before it. */
static void correct_block(int64_t block[BLOCK], const int64_t row_q47[2],
                          const int64_t column_q47[2], int64_t noise) {
    mix(block, 1U, 0U, row_q47[1], column_q47[1]);
    mix(block, 0U, 0U, row_q47[0], column_q47[0]);
    for (uint32_t k = 0U; k < (uint32_t)BLOCK; k++) { /* bound: BLOCK */
        ocel_add_product(&block[k], ocel_times(noise, row_q47[k >> 1U], -FACTOR_BITS),
                         column_q47[k & 1U]);
    }
}

/* Kalman's gains of each axis, negated: the covariances of its position and of its
 * velocity with the position, over the variance of the error. */
void ocel_filter_correct(ocel_filter_t *filter, const ocel_tracker_config_t *config,
                         const ocel_fix_t *fix) {
    int64_t gains_q47[3][2];

    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
        const int64_t *const block = filter->cov_q6[diagonal[i]];
        const int64_t error = filter->p_u_q16[i] - fix->p_u_q16[i];
        int64_t inverse_q60;
        int32_t e;

        ocel_recip_q60((uint64_t)variance_q6(filter, fix, i), &inverse_q60, &e);
        e += FACTOR_BITS - 120;
        gains_q47[i][0] = -ocel_times(block[PP], inverse_q60, e);
        gains_q47[i][1] = -ocel_times(block[VP], inverse_q60, e);
        ocel_add_product(&filter->p_u_q16[i], error, gains_q47[i][0]);
        ocel_add_product(&filter->v_u_s_q16[i], error, gains_q47[i][1]);
    }
    for (uint32_t entry = 0U; entry < (uint32_t)OCEL_SYM3_COUNT; entry++) { /* bound: 6 */
        correct_block(filter->cov_q6[entry], gains_q47[first_axis[entry]],
                      gains_q47[second_axis[entry]], fix->cov_q6[entry]);
    }
    limit_state(filter, config->max_speed_u_s);
}
