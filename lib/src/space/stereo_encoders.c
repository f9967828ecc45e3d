/* SPDX-License-Identifier: MIT */
#include <ocellus/stereo.h>

#include <stddef.h>
#include <string.h>

#include "../base/int_math.h"
#include "../base/q60.h"
#include "../base/scale.h"
#include "../base/trig.h"
#include "pose.h"
#include "ray_pair.h"

#define ONE_Q30 ((int32_t)0x40000000)

/* A point before the eyes' middle as fractions of half the baseline b, (b/2) over / under,
 * |over| <= 2.
 *
 * Paper (eq. 14, with 1/tan for tan^-1): forward = (b/2) cos(EVG) / sin(EVG).
 * Exact: with the lines of sight at gl = version - EVG - residual_l and gr = version +
 * EVG - residual_r to the left, x = b / (tan gr - tan gl) ahead of the eyes' plane and
 * y = b/2 + x tan gl to the left.  With sum = gl + gr and apart = gr - gl that is
 *   x = (b/2) (cos sum + cos apart) / sin apart,   y = (b/2) sin sum / sin apart,
 * which needs no tangent, and seen from the version's direction v:
 *   forward = (b/2) (cos(sum - v) + cos apart cos v) / sin apart
 *   right   = (b/2) (cos apart sin v - sin(sum - v)) / sin apart. */
typedef struct {
    int64_t forward_q60;
    int64_t right_q60;
    int32_t under_q30;
} fractions_t;

static void fractions(ocel_encoders_t variant, uint32_t version_q32, int32_t vergence_q32,
                      const int32_t *residual_q32, fractions_t *f) {
    int32_t sin_v_q30;
    int32_t cos_v_q30;
    int32_t cos_q30;

    ocel_sincos(version_q32, &sin_v_q30, &cos_v_q30);
    if (variant == OCEL_ENCODERS_EXACT) {
        const uint32_t left_q32 = (uint32_t)residual_q32[OCEL_LEFT];
        const uint32_t right_q32 = (uint32_t)residual_q32[OCEL_RIGHT];
        int32_t sin_off_q30;
        int32_t cos_off_q30;

        ocel_sincos(((uint32_t)vergence_q32 + left_q32) - right_q32, &f->under_q30, &cos_q30);
        ocel_sincos((version_q32 - left_q32) - right_q32, &sin_off_q30, &cos_off_q30);
        f->forward_q60 = ((int64_t)cos_q30 * cos_v_q30) + ocel_widen_q30(cos_off_q30);
        f->right_q60 = ((int64_t)cos_q30 * sin_v_q30) - ocel_widen_q30(sin_off_q30);
    } else {
        const int32_t factor_q30 = (variant == OCEL_ENCODERS_COSINE) ? cos_v_q30 : ONE_Q30;

        ocel_sincos((uint32_t)ocel_asr32(vergence_q32, 1U), &f->under_q30, &cos_q30);
        f->forward_q60 = (int64_t)cos_q30 * factor_q30;
        f->right_q60 = 0;
    }
}

/* The fractions times half the baseline.  1 / under is y 2^e, e at most 12; over / 2 in Q60
 * is at most 2^60, the baseline in Q30 2^58: the result is below 2^41 u. */
static ocel_status_t place_fractions(const fractions_t *f, int32_t baseline_u,
                                     int32_t p_middle_u[3]) {
    const int64_t over_q60[2] = {f->right_q60, f->forward_q60};
    ocel_status_t status = OCEL_DEGENERATE;

    if ((f->under_q30 >= OCEL_LEAST_SINE_Q30) && (f->forward_q60 > 0)) {
        int64_t p_u[2];
        int64_t y_q60;
        int32_t e;

        ocel_recip_q60((uint64_t)ocel_widen_q30(f->under_q30), &y_q60, &e);
        for (uint32_t i = 0U; i < 2U; i++) { /* bound: 2, right and forward */
            const int64_t half_q60 = ocel_mul_q60(ocel_asr64(over_q60[i], 1U), y_q60);

            p_u[i] = ocel_scale_q60(ocel_mul_q60(ocel_widen_q30(baseline_u), half_q60), e - 30);
        }
        status = OCEL_OUT_OF_RANGE;
        if ((ocel_abs64(p_u[0]) | (uint64_t)p_u[1]) < OCEL_MAX_POSITION_U) {
            p_middle_u[0] = (int32_t)p_u[0];
            p_middle_u[2] = (int32_t)p_u[1];
            status = OCEL_OK;
        }
    }
    return status;
}

ocel_status_t ocel_stereo_encoders(ocel_encoders_t variant, int32_t baseline_u, int32_t version_q32,
                                   int32_t vergence_q32, const int32_t residual_q32[OCEL_EYE_COUNT],
                                   int32_t p_middle_u[3]) {
    ocel_status_t status = OCEL_NULL_ARGUMENT;

    if (p_middle_u != NULL) {
        (void)memset(p_middle_u, 0, 3U * sizeof(p_middle_u[0]));
    }
    if ((residual_q32 != NULL) && (p_middle_u != NULL)) {
        /* A quarter turn more is below half a turn for what is within a quarter. */
        const uint32_t quarter = 0x40000000U;
        const uint32_t turns = ((uint32_t)version_q32 + quarter) |
                               ((uint32_t)vergence_q32 + quarter) |
                               ((uint32_t)residual_q32[OCEL_LEFT] + quarter) |
                               ((uint32_t)residual_q32[OCEL_RIGHT] + quarter);

        if ((uint32_t)variant > (uint32_t)OCEL_ENCODERS_EXACT) {
            status = OCEL_BAD_OPTION;
        } else if ((turns >= (2U * quarter)) || (baseline_u < 1) ||
                   (baseline_u > OCEL_MAX_STEREO_U)) {
            status = OCEL_OUT_OF_RANGE;
        } else {
            fractions_t f;

            fractions(variant, (uint32_t)version_q32, vergence_q32, residual_q32, &f);
            status = place_fractions(&f, baseline_u, p_middle_u);
        }
    }
    return status;
}
