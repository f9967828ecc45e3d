/* SPDX-License-Identifier: MIT
 *
 * The pinhole: pixels to rays and back.
 */
#include "camera_ray.h"

#include <stddef.h>
#include <string.h>

#include "int_math.h"
#include "lens.h"
#include "q60.h"
#include "scale.h"

#define FOCAL_MIN_Q16 0x100000         /* 16 px */
#define FOCAL_MAX_Q16 0x40000000       /* 16384 px */
#define COORDINATE_MAX_Q16 0x40000000  /* OCEL_MAX_COORDINATE_PX */
#define COEFFICIENT_MAX_Q24 0x10000000 /* 16 */
#define HALF_PX_Q16 32768

/* A slope whose pixel cannot be within OCEL_MAX_COORDINATE_PX: twice that, as the
 * principal point may lie there too, over the shortest focal length. */
#define SLOPE_MAX_Q40 ((uint64_t)1U << 51U)

static bool is_coordinate(int64_t v_px_q16) {
    return ocel_abs64(v_px_q16) <= (uint64_t)COORDINATE_MAX_Q16;
}

/* |v| <= most, most up to 2^30: what is below -most wraps to beyond the span. */
static bool is_allowed(int32_t v, uint32_t most) {
    return ((uint32_t)v + most) <= (2U * most);
}

/* One axis of the image; false when its intrinsics are out of range, or no
 * coordinate lies both on the side (a pixel covers +-0.5) and within 80 degrees,
 * f tan 80 < 2^33, of the axis.  f / 2^14 is at most 1 in Q60 and its inverse
 * 2^10, so e is 0..10. */
static bool init_axis(ocel_camera_axis_t *axis, int32_t f_px_q16, int32_t c_px_q16,
                      uint16_t side_px) {
    const int64_t reach_px_q16 = ocel_asr64((int64_t)f_px_q16 * OCEL_TAN_80_Q28, 28U);
    const bool stated = side_px != 0U;
    int64_t first = stated ? -HALF_PX_Q16 : -COORDINATE_MAX_Q16;
    int64_t last = stated ? (((int64_t)side_px * 65536) - HALF_PX_Q16) : COORDINATE_MAX_Q16;
    int64_t y_q60;
    int32_t e;

    first = (first < (c_px_q16 - reach_px_q16)) ? (c_px_q16 - reach_px_q16) : first;
    last = (last > (c_px_q16 + reach_px_q16)) ? (c_px_q16 + reach_px_q16) : last;
    axis->f_px_q16 = f_px_q16;
    axis->c_px_q16 = c_px_q16;
    axis->first_px_q16 = (int32_t)first;
    axis->span_px_q16 = (uint32_t)last - (uint32_t)first;
    ocel_recip_q60((uint64_t)f_px_q16 << 30U, &y_q60, &e);
    axis->inverse_f_q60 = ocel_scale_q60(y_q60, e - 14);
    return (first <= last) && (f_px_q16 >= FOCAL_MIN_Q16) && (f_px_q16 <= FOCAL_MAX_Q16) &&
           is_allowed(c_px_q16, COORDINATE_MAX_Q16) &&
           (side_px <= (uint16_t)OCEL_MAX_COORDINATE_PX);
}

/* False when a coefficient is out of range. */
static bool init_lens(ocel_camera_t *camera, const ocel_intrinsics_t *in) {
    const int32_t k_q24[5] = {in->k1_q24, in->k2_q24, in->p1_q24, in->p2_q24, in->k3_q24};
    bool valid = true;

    for (uint32_t i = 0U; i < 5U; i++) { /* bound: 5 */
        valid = valid && is_allowed(k_q24[i], COEFFICIENT_MAX_Q24);
        camera->distorted = camera->distorted || (k_q24[i] != 0);
    }
    if (valid) {
        camera->reach_q56 = camera->distorted ? ocel_lens_reach_q56(in) : OCEL_TAN2_80_Q56;
    }
    return valid;
}

ocel_status_t ocel_camera_init(ocel_camera_t *camera, const ocel_intrinsics_t *intrinsics) {
    ocel_status_t status = OCEL_NULL_ARGUMENT;

    if (camera != NULL) {
        (void)memset(camera, 0, sizeof(*camera));
    }
    if ((camera != NULL) && (intrinsics != NULL)) {
        const ocel_intrinsics_t *in = intrinsics;
        const bool x = init_axis(&camera->axis[0], in->fx_px_q16, in->cx_px_q16, in->width);
        const bool y = init_axis(&camera->axis[1], in->fy_px_q16, in->cy_px_q16, in->height);
        const bool lens = init_lens(camera, in);

        camera->intrinsics = *in;
        camera->ready = x && y && lens;
        status = camera->ready ? OCEL_OK : OCEL_OUT_OF_RANGE;
    }
    return status;
}

/* One comparison for both ends: the last is 2^30 at most and coordinates -2^31 at
 * least, so what lies before the first wraps to beyond the span. */
static inline bool is_on(const ocel_camera_axis_t *axis, int32_t v_px_q16) {
    return ((uint32_t)v_px_q16 - (uint32_t)axis->first_px_q16) <= axis->span_px_q16;
}

/* (v - c) / f.  |v - c| < 2^33 in Q16, shifted to Q43 below 2^60. */
static inline int64_t slope_q28(const ocel_camera_axis_t *axis, int64_t v_px_q16) {
    const int64_t offset_px_q43 = (v_px_q16 - axis->c_px_q16) * 0x8000000;

    return ocel_shift_round64(ocel_mul_q60(offset_px_q43, axis->inverse_f_q60), 15U);
}

/* The lens undone, and within its reach.  Slopes are each within 80 degrees here, so
 * their squares are 2^61.1 at most. */
static inline bool finish(const ocel_camera_t *camera, int64_t slopes_q28[2], int32_t xy_q28[2]) {
    bool seen = true;

    if (camera->distorted) {
        seen = ocel_lens_unbend(&camera->intrinsics, slopes_q28);
    }
    seen = seen && (((slopes_q28[0] * slopes_q28[0]) + (slopes_q28[1] * slopes_q28[1])) <=
                    camera->reach_q56);
    if (seen) {
        xy_q28[0] = (int32_t)slopes_q28[0];
        xy_q28[1] = (int32_t)slopes_q28[1];
    }
    return seen;
}

bool ocel_camera_normalise(const ocel_camera_t *camera, int32_t x_px_q16, int32_t y_px_q16,
                           int32_t xy_q28[2]) {
    bool seen = is_on(&camera->axis[0], x_px_q16) && is_on(&camera->axis[1], y_px_q16);

    if (seen) {
        int64_t slopes_q28[2] = {slope_q28(&camera->axis[0], x_px_q16),
                                 slope_q28(&camera->axis[1], y_px_q16)};

        seen = finish(camera, slopes_q28, xy_q28);
    }
    return seen;
}

bool ocel_camera_normalise_beyond(const ocel_camera_t *camera, const int64_t pixel_q16[2],
                                  int32_t xy_q28[2]) {
    int64_t slopes_q28[2];
    bool seen = true;

    for (uint32_t i = 0U; i < 2U; i++) { /* bound: 2 */
        slopes_q28[i] = slope_q28(&camera->axis[i], pixel_q16[i]);
    }
    if (camera->distorted) { /* which takes slopes within 80 degrees only, too */
        seen = ocel_lens_unbend(&camera->intrinsics, slopes_q28);
    }
    seen = seen && ocel_lens_within(slopes_q28, camera->reach_q56);
    if (seen) {
        xy_q28[0] = (int32_t)slopes_q28[0];
        xy_q28[1] = (int32_t)slopes_q28[1];
    }
    return seen;
}

/* The square is 1 to 33.2, in Q56 at least 1/16 of 2^60, so e is 0..3.  Slopes in Q58
 * are below 2^60.6, the products in Q58 too; the root is of the square over 16, so 2^2
 * is left out of e. */
void ocel_camera_unit(const int32_t xy_q28[2], int32_t d_q30[3]) {
    const int64_t p_q28[3] = {xy_q28[0], xy_q28[1], 0x10000000};
    int64_t square_q56 = 0;
    int64_t y_q60;
    int32_t e;

    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 */
        square_q56 += p_q28[i] * p_q28[i];
    }
    ocel_rsqrt_q60((uint64_t)square_q56, &y_q60, &e);
    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 */
        const int64_t product = ocel_mul_q60(ocel_shl64(p_q28[i], 30U), y_q60);

        d_q30[i] = (int32_t)ocel_scale_q60(product, e - 30);
    }
}

ocel_status_t ocel_camera_ray(const ocel_camera_t *camera, const ocel_point_t *pixel,
                              int32_t d_cam_q30[3]) {
    ocel_status_t status = OCEL_NULL_ARGUMENT;

    if (d_cam_q30 != NULL) {
        (void)memset(d_cam_q30, 0, 3U * sizeof(d_cam_q30[0]));
    }
    if ((camera != NULL) && (pixel != NULL) && (d_cam_q30 != NULL)) {
        int32_t xy_q28[2];

        if (!camera->ready) {
            status = OCEL_BAD_ORDER;
        } else if (ocel_camera_normalise(camera, pixel->x_px_q16, pixel->y_px_q16, xy_q28)) {
            ocel_camera_unit(xy_q28, d_cam_q30);
            status = OCEL_OK;
        } else {
            status = OCEL_OUT_OF_RANGE;
        }
    }
    return status;
}

/* x/z and y/z; false unless z > 0.  The inverse is y 2^(e - 60) with e 29..60,
 * coordinates in Q29 are within 2^60. */
static bool slopes_of(const int32_t p_u[3], int64_t slopes_q28[2]) {
    int64_t y_q60;
    int32_t e;

    ocel_recip_q60((p_u[2] > 0) ? (uint64_t)p_u[2] : 1U, &y_q60, &e);
    for (uint32_t i = 0U; i < 2U; i++) { /* bound: 2 */
        slopes_q28[i] = ocel_scale_q60(ocel_mul_q60((int64_t)p_u[i] * 0x20000000, y_q60), e - 61);
    }
    return p_u[2] > 0;
}

/* f * slope + c; INT64_MAX for slopes that no coordinate in range has.  f in Q46 is at
 * most 2^60, the slope below 2^51 in Q40, the product below 2^51 in Q26. */
static int64_t place_q16(const ocel_camera_axis_t *axis, int64_t slope_q40) {
    int64_t v_px_q16 = INT64_MAX;

    if (ocel_abs64(slope_q40) < SLOPE_MAX_Q40) {
        const int64_t offset_px_q26 = ocel_mul_q60((int64_t)axis->f_px_q16 * 0x40000000, slope_q40);

        v_px_q16 = ocel_shift_round64(offset_px_q26, 10U) + axis->c_px_q16;
    }
    return v_px_q16;
}

/* The slopes are within reach; |v| is 2^30 at most where it is kept. */
static bool project(const ocel_camera_t *camera, const int64_t slopes_q28[2], ocel_point_t *pixel) {
    int64_t bent_q40[2] = {ocel_shl64(slopes_q28[0], 12U), ocel_shl64(slopes_q28[1], 12U)};
    int64_t x_px_q16;
    int64_t y_px_q16;
    bool placed;

    if (camera->distorted) {
        ocel_lens_bend(&camera->intrinsics, slopes_q28, bent_q40);
    }
    x_px_q16 = place_q16(&camera->axis[0], bent_q40[0]);
    y_px_q16 = place_q16(&camera->axis[1], bent_q40[1]);
    placed = is_coordinate(x_px_q16) && is_coordinate(y_px_q16);
    if (placed) {
        pixel->x_px_q16 = (int32_t)x_px_q16;
        pixel->y_px_q16 = (int32_t)y_px_q16;
    }
    return placed;
}

ocel_status_t ocel_camera_project(const ocel_camera_t *camera, const int32_t p_cam_u[3],
                                  ocel_point_t *pixel) {
    ocel_status_t status = OCEL_NULL_ARGUMENT;

    if (pixel != NULL) {
        (void)memset(pixel, 0, sizeof(*pixel));
    }
    if ((camera != NULL) && (p_cam_u != NULL) && (pixel != NULL)) {
        int64_t slopes_q28[2];

        status = OCEL_OUT_OF_RANGE;
        if (!camera->ready) {
            status = OCEL_BAD_ORDER;
        } else if (slopes_of(p_cam_u, slopes_q28) &&
                   ocel_lens_within(slopes_q28, camera->reach_q56)) {
            status = project(camera, slopes_q28, pixel) ? OCEL_OK : OCEL_OUT_OF_RANGE;
        } else {
            /* Behind the camera, or too far off its axis. */
        }
    }
    return status;
}
