/* SPDX-License-Identifier: MIT */
#include "cone_frame.h"

#include "../base/camera_ray.h"
#include "../base/int_math.h"
#include "../base/q60.h"
#include "../base/scale.h"

#define ONE_Q28 0x10000000
#define ONE_Q56 ((int64_t)0x100000000000000)

/* The least spread: 2^-14 rad. */
#define SPREAD_LOG2_MAX 14U

/* The samples' mean, floored, and the mean of |x - mean| + |y - mean|, Q16 px, below
 * 2^33: 1.27 R for a whole circle.  Magnitudes and not squares: one stray point far
 * away must not make the ball small. */
static uint64_t spread_of(const ocel_cone_source_t *source, int32_t mean_px_q16[2]) {
    int64_t sum[2] = {0, 0};
    uint64_t deviation = 0U;

    for (uint32_t pass = 0U; pass < 2U; pass++) {           /* bound: 2 */
        for (uint32_t k = 0U; k < OCEL_CONE_SAMPLES; k++) { /* bound: OCEL_CONE_SAMPLES = 32 */
            int32_t xy_px_q16[2];

            ocel_cone_pixel(source, (k * source->count) / OCEL_CONE_SAMPLES, xy_px_q16);
            sum[0] += (pass == 0U) ? xy_px_q16[0] : 0;
            sum[1] += (pass == 0U) ? xy_px_q16[1] : 0;
            deviation += (pass == 0U) ? 0U
                                      : (ocel_abs64((int64_t)xy_px_q16[0] - mean_px_q16[0]) +
                                         ocel_abs64((int64_t)xy_px_q16[1] - mean_px_q16[1]));
        }
        mean_px_q16[0] = (int32_t)ocel_asr64(sum[0], 5U); /* 32 samples */
        mean_px_q16[1] = (int32_t)ocel_asr64(sum[1], 5U);
    }
    return deviation >> 5U;
}

uint64_t ocel_cone_stretch_q26(int32_t z_q30) {
    const int64_t square_q60 = (int64_t)z_q30 * z_q30;
    int64_t y_q60;
    int32_t e;

    ocel_recip_q60((uint64_t)square_q60, &y_q60, &e); /* e is 0..6 */
    return (uint64_t)ocel_scale_q60(y_q60, e - 34);
}

/* Scales: h, the power of two above the deviation (so a circle's radius is .39 to
 * .79 of it), and a pixel in it.  The deviation times 1/f: 2^33 * 2^26, in Q46. */
static bool scale_place(const ocel_cone_source_t *source, uint64_t deviation,
                        ocel_cone_place_t *place) {
    const int64_t inverse_f_q30 = ocel_asr64(
        source->camera->axis[0].inverse_f_q60 + source->camera->axis[1].inverse_f_q60, 31U);
    const uint32_t log2 = ocel_ceil_log2(deviation * (uint64_t)inverse_f_q30);
    const uint64_t stretch_q26 = ocel_cone_stretch_q26(place->axis_cam_q30[2]);
    uint64_t h_px_q16;

    place->spread_log2 = (log2 >= 46U) ? 0U : (46U - log2);
    h_px_q16 = (((uint64_t)source->f_px_q16 * stretch_q26) >> 26U) >> place->spread_log2;
    place->pixel_q25 = (h_px_q16 == 0U) ? 0U : (uint32_t)ocel_udiv64((uint64_t)1U << 41U, h_px_q16);
    return (place->spread_log2 <= SPREAD_LOG2_MAX) && (h_px_q16 >= 0x10000U);
}

ocel_status_t ocel_cone_place(const ocel_cone_source_t *source, ocel_cone_place_t *place) {
    int32_t mean_px_q16[2];
    int32_t xy_q28[2];
    uint64_t deviation;
    ocel_status_t status = OCEL_OUT_OF_RANGE;

    deviation = spread_of(source, mean_px_q16);
    if (ocel_camera_normalise(source->camera, mean_px_q16[0], mean_px_q16[1], xy_q28)) {
        static const ocel_cone_frame_t camera = {
            {{0x40000000, 0, 0}, {0, 0x40000000, 0}, {0, 0, 0x40000000}}};

        ocel_cone_turn(&camera, xy_q28[0], xy_q28[1], place->axis_cam_q30);
        status = scale_place(source, deviation, place) ? OCEL_OK : OCEL_DEGENERATE;
    }
    return status;
}

static int32_t times_q30(int32_t a_q30, int32_t b_q30) {
    return (int32_t)ocel_shift_round64((int64_t)a_q30 * b_q30, 30U);
}

/* The rotation that takes the axis (a, b, c) to z by the shortest way:
 *   [1 - a a k, -a b k, -a;  -a b k, 1 - b b k, -b;  a, b, c],  k = 1 / (1 + c). */
void ocel_cone_frame(const int32_t axis_cam_q30[3], ocel_cone_frame_t *frame) {
    const uint64_t below_q60 = ((uint64_t)axis_cam_q30[2] + 0x40000000U) << 30U;
    int64_t y_q60;
    int32_t k_q30;
    int32_t e;

    ocel_recip_q60(below_q60, &y_q60, &e); /* 1 + c is 1 to 2: e is -1 or 0 */
    k_q30 = (int32_t)ocel_scale_q60(y_q60, e - 30);
    for (uint32_t i = 0U; i < 2U; i++) {     /* bound: 2 */
        for (uint32_t j = 0U; j < 2U; j++) { /* bound: 2 */
            const int32_t product_q30 = times_q30(axis_cam_q30[i], axis_cam_q30[j]);

            frame->r_q30[i][j] = ((i == j) ? 0x40000000 : 0) - times_q30(product_q30, k_q30);
        }
        frame->r_q30[i][2] = -axis_cam_q30[i];
        frame->r_q30[2][i] = axis_cam_q30[i];
    }
    frame->r_q30[2][2] = axis_cam_q30[2];
}

/* (x, y, 1) normalised and rotated back.  x^2 + y^2 <= tan^2(80 degrees), so the
 * square is below 33.2 in Q56 and its inverse root y 2^e / 4; the terms are below
 * 5.8 in Q58, their sums with y alike. */
void ocel_cone_turn(const ocel_cone_frame_t *frame, int32_t x_q28, int32_t y_q28,
                    int32_t axis_cam_q30[3]) {
    const int32_t p_q28[3] = {x_q28, y_q28, ONE_Q28};
    const int64_t square_q56 = ((int64_t)x_q28 * x_q28) + ((int64_t)y_q28 * y_q28) + ONE_Q56;
    int64_t y_q60;
    int32_t e;

    ocel_rsqrt_q60((uint64_t)square_q56, &y_q60, &e);
    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 */
        int64_t sum_q58 = 0;

        for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 */
            sum_q58 += ocel_mul_q60((int64_t)frame->r_q30[k][i] * p_q28[k], y_q60);
        }
        axis_cam_q30[i] = (int32_t)ocel_scale_q60(sum_q58, e - 30);
    }
}

/* A coordinate enters the box's side: low, high. */
static inline void widen(int32_t side[2], int32_t v) {
    side[0] = (v < side[0]) ? v : side[0];
    side[1] = (v > side[1]) ? v : side[1];
}

/* The points' box, Q16 px; cracks are compared as they are, for speed. */
static void box_of(const ocel_cone_source_t *source, int32_t x_px_q16[2], int32_t y_px_q16[2]) {
    int32_t x[2] = {INT32_MAX, INT32_MIN};
    int32_t y[2] = {INT32_MAX, INT32_MIN};
    const int32_t unit_q16 = (source->points != NULL) ? 1 : 32768;

    if (source->points != NULL) {
        /* bound: OCEL_MAX_FIT_POINTS; OCEL_MAX_CRACKS each time in a call of ocel_eye_cone */
        for (uint32_t i = 0U; i < source->count; i++) {
            widen(x, source->points[i].x_px_q16);
            widen(y, source->points[i].y_px_q16);
        }
    } else {
        /* bound: OCEL_MAX_FIT_POINTS; OCEL_MAX_CRACKS each time in a call of ocel_eye_cone */
        for (uint32_t i = 0U; i < source->count; i++) {
            widen(x, source->cracks[i].x_hpx);
            widen(y, source->cracks[i].y_hpx);
        }
    }
    for (uint32_t k = 0U; k < 2U; k++) { /* bound: 2 */
        x_px_q16[k] = x[k] * unit_q16;
        y_px_q16[k] = y[k] * unit_q16;
    }
}

bool ocel_cone_is_plain(const ocel_cone_source_t *source) {
    bool plain = !source->camera->distorted;
    int32_t x_px_q16[2];
    int32_t y_px_q16[2];

    box_of(source, x_px_q16, y_px_q16);
    for (uint32_t k = 0U; k < 4U; k++) { /* bound: 4 */
        int32_t xy_q28[2];

        plain = plain &&
                ocel_camera_normalise(source->camera, x_px_q16[k & 1U], y_px_q16[k >> 1U], xy_q28);
    }
    return plain;
}

/* A row's entry times 1 / f <= 1/16, Q42, times a pixel in Q16 is in Q58; a pixel is
 * within 2^14, so what the product's floor loses is below 2^-28. */
void ocel_cone_map(const ocel_cone_source_t *source, const int32_t axis_cam_q30[3],
                   int32_t side_q30, int32_t depth_q30, ocel_cone_map_t *map) {
    ocel_cone_frame_t frame;

    ocel_cone_frame(axis_cam_q30, &frame);
    for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 */
        const int32_t rate_q30 = (k < 2U) ? side_q30 : depth_q30;

        map->g[k][2] = (uint64_t)ocel_shift_round64((int64_t)frame.r_q30[k][2] * rate_q30, 2U);
        for (uint32_t j = 0U; j < 2U; j++) { /* bound: 2 */
            const ocel_camera_axis_t *axis = &source->camera->axis[j];
            const int64_t g_q60 = (int64_t)frame.r_q30[k][j] * rate_q30;

            if (source->plain) {
                const int64_t inverse_f_q42 = ocel_shift_round64(axis->inverse_f_q60, 18U);

                map->g[k][j] = (uint64_t)ocel_mul_q60(g_q60, inverse_f_q42);
                map->g[k][2] -= map->g[k][j] * (uint64_t)(int64_t)axis->c_px_q16;
            } else {
                map->g[k][j] = (uint64_t)ocel_shift_round64(g_q60, 30U);
            }
        }
    }
}
