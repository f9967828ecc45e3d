/* SPDX-License-Identifier: MIT */
#include "cone_circle.h"

#include "../base/int_math.h"
#include "../base/q60.h"

/* An inlier is within GATE_SIGMAS of the samples' scatter, but at least .65 px, at most
 * 1.5 px, and at most a quarter of the radius.  Of a crack it is one of its ends, for which
 * the gate is CRACK_PX less: what a midpoint deviates by more than its crack is long, across
 * the outline, is what the guess may be off by. */
#define GATE_SIGMAS 3U
#define GATE_MIN_PX_Q16 42598U
#define GATE_MAX_PX_Q16 98304U
#define CRACK_PX_Q16 16384U

static uint32_t gate_of(uint32_t rms_px_q15, uint32_t r_px_q16, bool cracks) {
    uint32_t gate = 2U * GATE_SIGMAS * rms_px_q15;

    gate = (gate < GATE_MIN_PX_Q16) ? GATE_MIN_PX_Q16 : gate;
    gate = (gate > GATE_MAX_PX_Q16) ? GATE_MAX_PX_Q16 : gate;
    gate -= cracks ? CRACK_PX_Q16 : 0U;
    return (gate > (r_px_q16 / 4U)) ? (r_px_q16 / 4U) : gate;
}

/* tan is 2^-22 to 1, so e is 0 to 22; f tan is below 2^30 in Q16, 1 / z^2 below 2^32 in
 * Q26. */
void ocel_cone_circle(const ocel_cone_source_t *source, const ocel_cone_guess_t *guess,
                      ocel_cone_circle_t *circle) {
    const int32_t z_q30 = guess->axis_cam_q30[2];
    const int64_t tan_px_q16 = ocel_asr64(source->f_px_q16 * ocel_asr64(guess->tan_q46, 16U), 30U);
    const uint64_t r_px_q16 = ((uint64_t)tan_px_q16 * ocel_cone_stretch_q26(z_q30)) >> 26U;
    int64_t y_q60;
    int32_t e;

    ocel_recip_q60((uint64_t)guess->tan_q46 << 14U, &y_q60, &e);
    y_q60 = ocel_mul_q60(y_q60, (int64_t)z_q30 * 0x40000000);
    circle->side_down = 34U - (uint32_t)e;
    ocel_cone_map(source, guess->axis_cam_q30, (int32_t)ocel_asr64(y_q60, 30U), z_q30,
                  &circle->scaled);
    circle->r_px_q16 = (int32_t)((r_px_q16 > 0x40000000U) ? 0x40000000U : r_px_q16);
    circle->gate_px_q16 =
        (int32_t)gate_of(guess->rms_px_q15, (uint32_t)circle->r_px_q16, source->points == NULL);
    for (uint32_t k = 0U; k < 2U; k++) { /* bound: 2 */
        const int64_t inverse_f_q30 = ocel_asr64(source->camera->axis[1U - k].inverse_f_q60, 30U);

        circle->half_px_q16[k] = (source->points != NULL)
                                     ? 0
                                     : (int32_t)ocel_asr64(source->f_px_q16 * inverse_f_q30, 31U);
    }
}
