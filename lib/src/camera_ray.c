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

#define FOCAL_MIN_Q16 0x100000   /* 16 px */
#define FOCAL_MAX_Q16 0x40000000 /* 16384 px */
#define COORDINATE_MAX_Q16 (OCEL_MAX_COORDINATE_PX * 65536)
#define COEFFICIENT_MAX_Q24 0x10000000 /* 16 */

/* A slope whose pixel cannot be within OCEL_MAX_COORDINATE_PX: twice that, as the
 * principal point may lie there too, over the shortest focal length. */
#define SLOPE_MAX_Q40 ((uint64_t)1U << 51U)

static bool is_focal(int32_t f_px_q16) {
    return (f_px_q16 >= FOCAL_MIN_Q16) && (f_px_q16 <= FOCAL_MAX_Q16);
}

static bool is_coordinate(int64_t v_px_q16) {
    return ocel_abs64(v_px_q16) <= (uint64_t)COORDINATE_MAX_Q16;
}

/* Whether the intrinsics are within their ranges; says whether the lens distorts. */
static bool is_valid(const ocel_intrinsics_t *in, bool *distorted) {
    const int32_t k_q24[5] = {in->k1_q24, in->k2_q24, in->p1_q24, in->p2_q24, in->k3_q24};
    bool valid = is_focal(in->fx_px_q16) && is_focal(in->fy_px_q16) &&
                 is_coordinate(in->cx_px_q16) && is_coordinate(in->cy_px_q16) &&
                 (in->width <= (uint16_t)OCEL_MAX_COORDINATE_PX) &&
                 (in->height <= (uint16_t)OCEL_MAX_COORDINATE_PX);

    *distorted = false;
    for (uint32_t i = 0U; i < 5U; i++) { /* bound: 5 */
        valid = valid && (ocel_abs64(k_q24[i]) <= (uint64_t)COEFFICIENT_MAX_Q24);
        *distorted = *distorted || (k_q24[i] != 0);
    }
    return valid;
}

/* 1 / f for f of 16 to 16384 px: f / 2^14 in Q60 is below 1, its inverse 2^10 at
 * most, so e is 0..10. */
static int64_t inverse_q60(int32_t f_px_q16) {
    int64_t y_q60;
    int32_t e;

    ocel_recip_q60((uint64_t)f_px_q16 << 30U, &y_q60, &e);
    return ocel_scale_q60(y_q60, e - 14);
}

ocel_status_t ocel_camera_init(ocel_camera_t *camera, const ocel_intrinsics_t *intrinsics) {
    ocel_status_t status = OCEL_NULL_ARGUMENT;

    if (camera != NULL) {
        (void)memset(camera, 0, sizeof(*camera));
    }
    if ((camera != NULL) && (intrinsics != NULL)) {
        status = OCEL_OUT_OF_RANGE;
        if (is_valid(intrinsics, &camera->distorted)) {
            camera->intrinsics = *intrinsics;
            camera->inverse_fx_q60 = inverse_q60(intrinsics->fx_px_q16);
            camera->inverse_fy_q60 = inverse_q60(intrinsics->fy_px_q16);
            camera->reach_q56 =
                camera->distorted ? ocel_lens_reach_q56(intrinsics) : OCEL_TAN2_80_Q56;
            camera->ready = true;
            status = OCEL_OK;
        }
    }
    return status;
}

/* Within the image's side, a pixel covering +-0.5, or within the range of
 * coordinates when the side is not stated: one comparison for both ends, as what
 * lies below wraps to 2^31 or more. */
static inline bool is_on_side(int32_t v_px_q16, uint16_t side_px) {
    const uint32_t before_q16 = (side_px == 0U) ? (uint32_t)COORDINATE_MAX_Q16 : 0x8000U;
    const uint32_t span_q16 =
        (side_px == 0U) ? (2U * (uint32_t)COORDINATE_MAX_Q16) : ((uint32_t)side_px << 16U);

    return ((uint32_t)v_px_q16 + before_q16) <= span_q16;
}

/* (v - c) / f.  |v - c| < 2^32 in Q16, shifted to Q43 below 2^59; the quotient is
 * below 2^13 in Q43. */
static inline int64_t slope_q28(int32_t v_px_q16, int32_t c_px_q16, int64_t inverse_f_q60) {
    const int64_t offset_px_q43 = ((int64_t)v_px_q16 - c_px_q16) * 0x8000000;

    return ocel_shift_round64(ocel_mul_q60(offset_px_q43, inverse_f_q60), 15U);
}

bool ocel_camera_normalise(const ocel_camera_t *camera, int32_t x_px_q16, int32_t y_px_q16,
                           int32_t xy_q28[2]) {
    const ocel_intrinsics_t *in = &camera->intrinsics;
    int64_t slopes_q28[2];
    bool seen;

    slopes_q28[0] = slope_q28(x_px_q16, in->cx_px_q16, camera->inverse_fx_q60);
    slopes_q28[1] = slope_q28(y_px_q16, in->cy_px_q16, camera->inverse_fy_q60);
    seen = is_on_side(x_px_q16, in->width) && is_on_side(y_px_q16, in->height);
    if (seen && camera->distorted) {
        seen = ocel_lens_unbend(in, slopes_q28);
    }
    seen = seen && ocel_lens_within(slopes_q28, camera->reach_q56);
    if (seen) {
        xy_q28[0] = (int32_t)slopes_q28[0];
        xy_q28[1] = (int32_t)slopes_q28[1];
    }
    return seen;
}

/* (x, y, 1) / sqrt(x^2 + y^2 + 1).  The square is 1 to 33.2, in Q56 at least 1/16 of
 * 2^60: e is 0..2.  Slopes in Q58 are below 2^60.6; the product is at most 1 in Q58
 * over 4 2^e. */
static void unit_ray(const int32_t xy_q28[2], int32_t d_q30[3]) {
    const int64_t p_q28[3] = {xy_q28[0], xy_q28[1], 0x10000000};
    const int64_t square_q56 =
        (p_q28[0] * p_q28[0]) + (p_q28[1] * p_q28[1]) + (p_q28[2] * p_q28[2]);
    int64_t y_q60;
    int32_t e;

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
        } else if (!ocel_camera_normalise(camera, pixel->x_px_q16, pixel->y_px_q16, xy_q28)) {
            status = OCEL_OUT_OF_RANGE;
        } else {
            unit_ray(xy_q28, d_cam_q30);
            status = OCEL_OK;
        }
    }
    return status;
}

/* x/z and y/z, z > 0.  The inverse is y 2^(e - 60) with e 29..60, coordinates in Q29
 * are within 2^60, and those over 6 z are none within 80 degrees. */
static bool slopes_of(const int32_t p_u[3], int64_t slopes_q28[2]) {
    int64_t y_q60;
    int32_t e;
    bool ahead = p_u[2] > 0;

    ocel_recip_q60((uint64_t)(ahead ? p_u[2] : 1), &y_q60, &e);
    for (uint32_t i = 0U; i < 2U; i++) { /* bound: 2 */
        ahead = ahead && (ocel_abs64(p_u[i]) <= (6U * (uint64_t)p_u[2]));
        slopes_q28[i] = ocel_scale_q60(ocel_mul_q60((int64_t)p_u[i] * 0x20000000, y_q60), e - 61);
    }
    return ahead;
}

/* f * slope + c; INT64_MAX for slopes that no coordinate in range has.  f in Q46 is at
 * most 2^60, the slope below 2^51 in Q40, the product below 2^51 in Q26. */
static int64_t place_q16(int64_t slope_q40, int32_t f_px_q16, int32_t c_px_q16) {
    int64_t v_px_q16 = INT64_MAX;

    if (ocel_abs64(slope_q40) < SLOPE_MAX_Q40) {
        const int64_t offset_px_q26 = ocel_mul_q60((int64_t)f_px_q16 * 0x40000000, slope_q40);

        v_px_q16 = ocel_shift_round64(offset_px_q26, 10U) + c_px_q16;
    }
    return v_px_q16;
}

/* The slopes are within reach. */
static bool project(const ocel_camera_t *camera, const int64_t slopes_q28[2], ocel_point_t *pixel) {
    const ocel_intrinsics_t *in = &camera->intrinsics;
    int64_t bent_q40[2] = {ocel_shl64(slopes_q28[0], 12U), ocel_shl64(slopes_q28[1], 12U)};
    int64_t x_px_q16;
    int64_t y_px_q16;
    bool placed;

    if (camera->distorted) {
        ocel_lens_bend(in, slopes_q28, bent_q40);
    }
    x_px_q16 = place_q16(bent_q40[0], in->fx_px_q16, in->cx_px_q16);
    y_px_q16 = place_q16(bent_q40[1], in->fy_px_q16, in->cy_px_q16);
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
