/* SPDX-License-Identifier: MIT */
#include "ray_pair.h"

#include "../base/int_math.h"
#include "../base/q60.h"
#include "../base/scale.h"

#define ONE_Q30 ((int32_t)0x40000000)

#define LEAST_SQUARE_Q60 ((int64_t)OCEL_LEAST_SINE_Q30 * OCEL_LEAST_SINE_Q30)

bool ocel_line_of(const int32_t p_u[3], const int32_t d_q30[3], ocel_line_t *line) {
    const uint64_t slack_q60 = (uint64_t)1U << 44U;
    uint64_t excess_q60 = slack_q60 - (uint64_t)OCEL_Q60_ONE;
    bool within = true;

    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
        const int64_t square_q60 = (int64_t)d_q30[i] * d_q30[i];

        excess_q60 += (uint64_t)square_q60;
        within = within && (p_u[i] >= -OCEL_MAX_STEREO_U) && (p_u[i] <= OCEL_MAX_STEREO_U);
        line->p_q30[i] = ocel_widen_q30(p_u[i]);
        line->d_q60[i] = ocel_widen_q30(d_q30[i]);
    }
    return within && (excess_q60 <= (2U * slack_q60));
}

/* How far along one ray the other is closest: (w x d of the other) . normal / sine. */
static ocel_status_t reach(const int64_t w_q30[3], const ocel_line_t *other,
                           const ocel_crossing_t *c, int64_t *t_q30) {
    ocel_status_t status = OCEL_OUT_OF_RANGE;
    int64_t moment_q30[3];
    int64_t half_q30; /* t / 2^(e - 1) */

    ocel_cross_q60(w_q30, other->d_q60, moment_q30);
    half_q30 = ocel_mul_q60(ocel_dot_q60(moment_q30, c->normal_q60), c->y_q60);
    if (half_q30 < ocel_scale_q60(1, 59 - c->e)) {
        *t_q30 = ocel_scale_q60(half_q30, c->e - 1);
        status = (*t_q30 < ONE_Q30) ? OCEL_DEGENERATE : OCEL_OK;
    }
    return status;
}

ocel_status_t ocel_line_cross(const ocel_line_t *left, const ocel_line_t *right,
                              ocel_crossing_t *c) {
    ocel_status_t status = OCEL_DEGENERATE;
    int64_t w_q30[3];
    int64_t square_q60;

    ocel_cross_q60(left->d_q60, right->d_q60, c->half_q60);
    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
        c->half_q60[i] = ocel_asr64(c->half_q60[i], 1U);
        w_q30[i] = right->p_q30[i] - left->p_q30[i];
    }
    square_q60 = ocel_dot_q60(c->half_q60, c->half_q60);
    if (square_q60 >= (LEAST_SQUARE_Q60 / 4)) {
        ocel_rsqrt_q60((uint64_t)square_q60, &c->y_q60, &c->e);
        for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
            c->normal_q60[i] = 2 * ocel_mul_q60(ocel_scale_q60(c->half_q60[i], c->e - 1), c->y_q60);
        }
        c->gap_q30 = ocel_dot_q60(w_q30, c->normal_q60);
        status = reach(w_q30, right, c, &c->t_q30[OCEL_LEFT]);
        if (status == OCEL_OK) {
            status = reach(w_q30, left, c, &c->t_q30[OCEL_RIGHT]);
        }
    }
    return status;
}

uint32_t ocel_line_between(const ocel_line_t *left, const ocel_line_t *right,
                           const ocel_crossing_t *c, int32_t p_u[3]) {
    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
        const int64_t twice_q30 = left->p_q30[i] + ocel_mul_q60(c->t_q30[0], left->d_q60[i]) +
                                  right->p_q30[i] + ocel_mul_q60(c->t_q30[1], right->d_q60[i]);

        p_u[i] = (int32_t)ocel_shift_round64(twice_q30, 31U);
    }
    return (uint32_t)((ocel_abs64(c->gap_q30) + ((uint64_t)1U << 29U)) >> 30U);
}
