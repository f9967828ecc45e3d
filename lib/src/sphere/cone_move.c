/* SPDX-License-Identifier: MIT */
#include "cone_move.h"

#include <stdbool.h>
#include <stddef.h>

#include "../base/int_math.h"
#include "../base/q60.h"
#include "../base/sym3.h"

/* rate / v, v in Q60. */
static void divide(ocel_scaled_t *rate, uint64_t v_q60) {
    int64_t y_q60;
    int32_t e;

    ocel_recip_q60(v_q60, &y_q60, &e);
    rate->y_q60 = ocel_mul_q60(rate->y_q60, y_q60);
    rate->e += e;
}

static int64_t within(int64_t v, int64_t most) {
    return (v > most) ? most : ((v < -most) ? -most : v);
}

/* x / R within 1/2, R at least 1 px. */
static int64_t over_radius(int32_t x_px_q24, int32_t r_px_q16) {
    const int64_t half_q24 = (int64_t)r_px_q16 * 128;
    ocel_scaled_t part = {within(x_px_q24, half_q24) * 0x100000, 36 - 20 - 14};

    divide(&part, (uint64_t)r_px_q16 << 30U);
    return ocel_scale_q60(part.y_q60, part.e);
}

int64_t ocel_cone_move(const ocel_cone_frame_t *frame, int64_t tan_q60,
                       const ocel_cone_step_t *step, int32_t r_px_q16, int32_t axis_cam_q30[3]) {
    ocel_scaled_t gain = {tan_q60, 0};
    int64_t gain_q60;
    int32_t turn_q28[2];

    divide(&gain, (uint64_t)OCEL_Q60_ONE + (uint64_t)ocel_mul_q60(tan_q60, tan_q60));
    gain_q60 = ocel_scale_q60(gain.y_q60, gain.e);
    for (uint32_t k = 0U; k < 2U; k++) { /* bound: 2 */
        turn_q28[k] = (int32_t)ocel_shift_round64(
            ocel_mul_q60(over_radius(step->x_px_q24[k], r_px_q16), gain_q60), 32U);
    }
    ocel_cone_turn(frame, turn_q28[0], turn_q28[1], axis_cam_q30);
    return tan_q60 + ocel_mul_q60(tan_q60, over_radius(step->x_px_q24[2], r_px_q16));
}

/* v * 2^e into a number below 1; false when it is none. */
static bool take_below_one(int64_t v_q60, int32_t e, int64_t *below_q60) {
    const bool below = (int32_t)ocel_clz64(ocel_abs64(v_q60)) >= (e + 4);

    *below_q60 = (below && (e >= -62)) ? ocel_scale_q60(v_q60, e) : 0;
    return below;
}

/* cov = frame' local frame, local in Q60 and below 1; each sum of products with a
 * rotation's row or column is below 2. */
static void rotate_covariance(const ocel_cone_frame_t *frame,
                              const int64_t local_q60[OCEL_SYM3_COUNT],
                              int64_t cov_q60[OCEL_SYM3_COUNT]) {
    uint32_t at = 0U;

    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 */
        int64_t row_q60[3] = {0, 0, 0};

        for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 */
            const int64_t r_q60 = (int64_t)frame->r_q30[k][i] * 0x40000000;

            for (uint32_t j = 0U; j < 3U; j++) { /* bound: 3 */
                row_q60[j] += ocel_mul_q60(local_q60[ocel_sym3_at[k][j]], r_q60);
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

/* The variance of weight 1 times what makes it the centre's: twice the misfit over (sectors
 * - 3), over the determinant, R^2 and (1 + t^2)^2.  Twice: sectors are few, and neighbours err
 * alike.  1 / (n 2^-15) and 1 / (R 2^-14), twice, are what is divided. */
static ocel_scaled_t variance_of(const ocel_cone_step_t *step, int32_t r_px_q16, int64_t open_q60) {
    const uint32_t shift = ocel_clz64(step->misfit_q56 | 1U) - 3U; /* misfit <= 2^60 */
    const uint64_t freedom = (step->sectors > 3U) ? ((uint64_t)step->sectors - 3U) : 1U;
    ocel_scaled_t rate = {ocel_signed64((step->misfit_q56 | 1U) << shift),
                          (4 + 1 - (int32_t)shift) - (15 + 28)};

    rate.y_q60 = ocel_mul_q60(rate.y_q60, step->inverse.rate.y_q60);
    rate.e += step->inverse.rate.e;
    divide(&rate, freedom << 45U);
    for (uint32_t i = 0U; i < 2U; i++) { /* bound: 2 */
        divide(&rate, (uint64_t)r_px_q16 << 30U);
        divide(&rate, (uint64_t)open_q60);
    }
    return rate;
}

/* With q = (x, y, radius) / R the axis turns by q t / (1 + t^2) and the distance changes by
 * -q / (1 + t^2) of itself. */
int64_t ocel_cone_spread(const ocel_cone_frame_t *frame, int64_t tan_q60, ocel_cone_step_t *step,
                         int32_t r_px_q16, int64_t cov_q60[OCEL_SYM3_COUNT]) {
    bool known = step != NULL;

    if (known) {
        const ocel_scaled_t variance =
            variance_of(step, r_px_q16, OCEL_Q60_ONE + ocel_mul_q60(tan_q60, tan_q60));
        int64_t *local_q60 = step->inverse.adjoint_q60;

        for (uint32_t i = 0U; i < 3U; i++) {    /* bound: 3 */
            for (uint32_t k = i; k < 3U; k++) { /* bound: 3 */
                int64_t *entry = &local_q60[ocel_sym3_at[i][k]];

                *entry = ocel_mul_q60(*entry, variance.y_q60);
                *entry = (i < 2U) ? ocel_mul_q60(*entry, tan_q60) : *entry;
                *entry = (k < 2U) ? ocel_mul_q60(*entry, tan_q60) : ((i < 2U) ? -*entry : *entry);
                known = take_below_one(*entry, variance.e, entry) && known;
            }
        }
    }
    if (known) {
        rotate_covariance(frame, step->inverse.adjoint_q60, cov_q60);
    } else {
        cov_q60[OCEL_XX] = OCEL_Q60_ONE;
        cov_q60[OCEL_YY] = OCEL_Q60_ONE;
        cov_q60[OCEL_ZZ] = OCEL_Q60_ONE;
    }
    return known ? step->inverse.adjoint_q60[OCEL_ZZ] : OCEL_Q60_ONE;
}
