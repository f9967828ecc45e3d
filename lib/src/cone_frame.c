/* SPDX-License-Identifier: MIT */
#include "cone_frame.h"

#include "camera_ray.h"
#include "int_math.h"
#include "q60.h"
#include "scale.h"

#define ONE_Q28 ((int32_t)1 << 28U)

/* The least spread: 2^-14 rad. */
#define SPREAD_LOG2_MAX 14U

/* Point i, Q16 px. */
static void pixel_of(const ocel_cone_source_t *source, uint32_t i, int32_t xy_px_q16[2]) {
    if (source->points != NULL) {
        xy_px_q16[0] = source->points[i].x_px_q16;
        xy_px_q16[1] = source->points[i].y_px_q16;
    } else {
        xy_px_q16[0] = (int32_t)source->cracks[i].x_hpx * 32768;
        xy_px_q16[1] = (int32_t)source->cracks[i].y_hpx * 32768;
    }
}

/* The points' mean, floored.  Coordinates are made positive by 2^31 for the
 * division: sums are below 2^32 * 2^14. */
static void mean_of(const ocel_cone_source_t *source, int32_t mean_px_q16[2]) {
    int64_t sum[2] = {0, 0};

    for (uint32_t i = 0U; i < source->count; i++) { /* bound: count <= OCEL_MAX_FIT_POINTS */
        int32_t xy_px_q16[2];

        pixel_of(source, i, xy_px_q16);
        sum[0] += xy_px_q16[0];
        sum[1] += xy_px_q16[1];
    }
    for (uint32_t k = 0U; k < 2U; k++) { /* bound: 2 */
        const int64_t shifted = sum[k] + ocel_shl64((int64_t)source->count, 31U);
        const uint64_t mean = ocel_udiv64((uint64_t)shifted, (uint64_t)source->count);

        mean_px_q16[k] = (int32_t)((int64_t)mean - ((int64_t)1 << 31U));
    }
}

/* The mean of |x - mean| + |y - mean|, Q16 px, below 2^33: 1.27 R for a whole
 * circle.  Sums of magnitudes and not of squares: one stray point far away must
 * not make the ball small. */
static uint64_t deviation_q16(const ocel_cone_source_t *source, const int32_t mean_px_q16[2]) {
    uint64_t sum = 0U;

    for (uint32_t i = 0U; i < source->count; i++) { /* bound: count <= OCEL_MAX_FIT_POINTS */
        int32_t xy_px_q16[2];

        pixel_of(source, i, xy_px_q16);
        sum += ocel_abs64((int64_t)xy_px_q16[0] - mean_px_q16[0]) +
               ocel_abs64((int64_t)xy_px_q16[1] - mean_px_q16[1]);
    }
    return ocel_udiv64(sum, (uint64_t)source->count);
}

uint64_t ocel_cone_stretch_q26(int32_t z_q30) {
    int64_t y_q60;
    int32_t e;

    ocel_recip_q60((uint64_t)((int64_t)z_q30 * z_q30), &y_q60, &e); /* e is 0..6 */
    return (uint64_t)ocel_scale_q60(y_q60, e - 34);
}

/* Scales: h, the power of two above the deviation (so a circle's radius is .39 to
 * .79 of it), and a pixel in it.  The deviation times 1/f: 2^33 * 2^26, in Q46. */
static bool scale_place(const ocel_cone_source_t *source, uint64_t deviation,
                        ocel_cone_place_t *place) {
    const int64_t inverse_f_q30 = ocel_asr64(
        source->camera->axis[0].inverse_f_q60 + source->camera->axis[1].inverse_f_q60, 31U);
    const uint32_t log2 = ocel_ceil_log2(deviation * (uint64_t)inverse_f_q30);
    const uint64_t stretch_q26 = ocel_cone_stretch_q26(place->frame.r_q30[2][2]);
    uint64_t h_px_q16;

    place->spread_log2 = (log2 >= 46U) ? 0U : (46U - log2);
    h_px_q16 = (((uint64_t)source->f_px_q16 * stretch_q26) >> 26U) >> place->spread_log2;
    place->pixel_q25 = (h_px_q16 == 0U) ? 0U : (uint32_t)ocel_udiv64((uint64_t)1U << 41U, h_px_q16);
    return (place->spread_log2 <= SPREAD_LOG2_MAX) && (h_px_q16 >= 0x10000U);
}

ocel_status_t ocel_cone_place(const ocel_cone_source_t *source, ocel_cone_place_t *place) {
    int32_t mean_px_q16[2];
    int32_t xy_q28[2];
    ocel_status_t status = OCEL_OUT_OF_RANGE;

    mean_of(source, mean_px_q16);
    if (ocel_camera_normalise(source->camera, mean_px_q16[0], mean_px_q16[1], xy_q28)) {
        static const ocel_cone_frame_t camera = {
            {{0x40000000, 0, 0}, {0, 0x40000000, 0}, {0, 0, 0x40000000}}};
        int32_t axis_cam_q30[3];

        ocel_cone_turn(&camera, xy_q28[0], xy_q28[1], axis_cam_q30);
        ocel_cone_frame(axis_cam_q30, &place->frame);
        status = scale_place(source, deviation_q16(source, mean_px_q16), place) ? OCEL_OK
                                                                                : OCEL_DEGENERATE;
    }
    return status;
}

/* The rotation that takes the axis (a, b, c) to z by the shortest way:
 *   [1 - a a k, -a b k, -a;  -a b k, 1 - b b k, -b;  a, b, c],  k = 1 / (1 + c). */
void ocel_cone_frame(const int32_t axis_cam_q30[3], ocel_cone_frame_t *frame) {
    const uint64_t below_q60 = ((uint64_t)axis_cam_q30[2] + 0x40000000U) << 30U;
    int64_t y_q60;
    int64_t k_q30;
    int32_t e;

    ocel_recip_q60(below_q60, &y_q60, &e); /* 1 + c is 1 to 2: e is -1 or 0 */
    k_q30 = ocel_scale_q60(y_q60, e - 30);
    for (uint32_t i = 0U; i < 2U; i++) {     /* bound: 2 */
        for (uint32_t j = 0U; j < 2U; j++) { /* bound: 2 */
            const int64_t product_q30 =
                ocel_shift_round64((int64_t)axis_cam_q30[i] * axis_cam_q30[j], 30U);

            frame->r_q30[i][j] =
                ((i == j) ? 0x40000000 : 0) - (int32_t)ocel_shift_round64(product_q30 * k_q30, 30U);
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
    const int64_t square_q56 =
        ((int64_t)x_q28 * x_q28) + ((int64_t)y_q28 * y_q28) + ((int64_t)1 << 56U);
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

/* A sum of three products is a rotated vector's number: below 5.8 in Q58, 2^60.6. */
bool ocel_cone_ray(const ocel_cone_source_t *source, const ocel_cone_frame_t *frame, uint32_t i,
                   int32_t p_cam_q28[3], int32_t p_q28[3]) {
    int32_t xy_px_q16[2];
    bool seen;

    pixel_of(source, i, xy_px_q16);
    p_cam_q28[2] = ONE_Q28;
    seen = ocel_camera_normalise(source->camera, xy_px_q16[0], xy_px_q16[1], p_cam_q28);
    if (seen) {
        for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 */
            const int32_t *r_q30 = frame->r_q30[k];
            const int64_t sum_q58 = ((int64_t)r_q30[0] * p_cam_q28[0]) +
                                    ((int64_t)r_q30[1] * p_cam_q28[1]) +
                                    ((int64_t)r_q30[2] * ONE_Q28);

            p_q28[k] = (int32_t)ocel_shift_round64(sum_q58, 30U);
        }
    }
    return seen;
}
