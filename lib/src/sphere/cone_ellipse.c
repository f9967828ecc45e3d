/* SPDX-License-Identifier: MIT
 *
 * The cone of an ellipse: the one whose outline has its centre and its area.
 *
 * In the plane z = 1 the outline of a cone has its centre at e = (X, Y) Z / w and the
 * semi-axes b = s / sqrt(w) and a = s sqrt(1 - s^2) / w (cone_outline.c).  With
 * q = 1 + b^2 that is solved by
 *   (X, Y, Z) along (e, q),   s^2 = b^2 q / (q^2 + e^2),   a b = b^2 sqrt(1 + e^2 / q),
 * so the centre and a b, which every affine map of the plane scales alike, determine the
 * cone: no axes need be mapped, and of an ellipse that is no outline, the angle and the
 * ratio of the axes are not believed.
 */
#include <ocellus/cone.h>

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

#include "../base/camera_ray.h"
#include "../base/int_math.h"
#include "../base/q60.h"
#include "../base/scale.h"
#include "../base/trig.h"

/* b^2 from a b: the iteration's slope is below .01 for balls under 10 degrees and
 * below .35 for all within 80 degrees. */
#define AREA_TRIPS 20U

/* A radius of 2^-20, below which rounding counts, and what the products hold. */
#define AREA_MIN_Q56 ((int64_t)0x10000)
#define AREA_MAX_Q56 ((int64_t)0x1FFFFFFFFFFFFFFF) /* 32 */

#define ONE_Q56 ((int64_t)0x100000000000000)

/* Centre and a b in the plane z = 1. */
typedef struct {
    int32_t e_q28[2];
    int64_t area_q56;
} flat_t;

/* The four ends of the axes through the camera: exact for a pinhole, and with a lens
 * what is odd about the centre cancels.  Sums of four slopes are within 2^32.6; half
 * the axes' doubles, within 5.7, make products within 2^61.1. */
static bool flatten(const ocel_camera_t *camera, const ocel_ellipse_t *ellipse, flat_t *flat) {
    const int32_t centre_q16[2] = {ellipse->cx_px_q16, ellipse->cy_px_q16};
    int32_t ends_q28[4][2] = {{0, 0}, {0, 0}, {0, 0}, {0, 0}};
    int32_t unit_q30[2];
    int32_t half_q28[2][2];
    bool seen = true;

    ocel_sincos(ellipse->angle_turn_q32, &unit_q30[1], &unit_q30[0]);
    for (uint32_t i = 0U; i < 4U; i++) { /* bound: 4 */
        const bool minor = (i & 1U) != 0U;
        const int32_t size = minor ? ellipse->b_px_q16 : ellipse->a_px_q16;
        const int32_t length_q16 = ((i & 2U) != 0U) ? -size : size;
        const int32_t along_q30[2] = {minor ? -unit_q30[1] : unit_q30[0],
                                      minor ? unit_q30[0] : unit_q30[1]};
        int64_t end_q16[2];

        for (uint32_t k = 0U; k < 2U; k++) { /* bound: 2 */
            end_q16[k] =
                centre_q16[k] + ocel_shift_round64((int64_t)length_q16 * along_q30[k], 30U);
        }

        seen = seen && ocel_camera_normalise_beyond(camera, end_q16, ends_q28[i]);
    }
    for (uint32_t k = 0U; k < 2U; k++) { /* bound: 2 */
        flat->e_q28[k] = (int32_t)ocel_shift_round64(
            (int64_t)ends_q28[0][k] + ends_q28[1][k] + ends_q28[2][k] + ends_q28[3][k], 2U);
        half_q28[0][k] = (int32_t)ocel_asr64((int64_t)ends_q28[0][k] - ends_q28[2][k], 1U);
        half_q28[1][k] = (int32_t)ocel_asr64((int64_t)ends_q28[1][k] - ends_q28[3][k], 1U);
    }
    flat->area_q56 =
        ((int64_t)half_q28[0][0] * half_q28[1][1]) - ((int64_t)half_q28[0][1] * half_q28[1][0]);
    return seen;
}

/* q = 1 + b^2 by b^2 = a b sqrt(q / (q + e^2)).  a b and e^2 are within 32.2, q within
 * 33.2: over 16, in Q60, the root's argument is below 2^62 and the other's at least
 * 1/16, so e is -1..2. */
static int64_t solve_q56(int64_t area_q56, int64_t square_q56) {
    int64_t q_q56 = ONE_Q56;

    for (uint32_t i = 0U; i < AREA_TRIPS; i++) { /* bound: AREA_TRIPS = 20 */
        int64_t y_q60;
        int32_t e;
        int64_t ratio_q60;

        ocel_rsqrt_q60((uint64_t)q_q56 + (uint64_t)square_q56, &y_q60, &e);
        ratio_q60 = ocel_scale_q60(ocel_mul_q60(ocel_sqrt_q60((uint64_t)q_q56), y_q60), e);
        q_q56 = ONE_Q56 + ocel_mul_q60(area_q56, ratio_q60);
    }
    return q_q56;
}

/* The axis along (e / q, 1), and s^2 = (b^2 / q) cos^2 of its angle. */
static void cone_over(const flat_t *flat, ocel_cone_t *cone) {
    const int64_t square_q56 =
        ((int64_t)flat->e_q28[0] * flat->e_q28[0]) + ((int64_t)flat->e_q28[1] * flat->e_q28[1]);
    const int64_t q_q56 = solve_q56(flat->area_q56, square_q56);
    int32_t xy_q28[2];
    int32_t z_q30;
    int64_t part_q60;
    int64_t y_q60;
    int32_t e;

    ocel_recip_q60((uint64_t)q_q56, &y_q60, &e); /* 16 / q: e is -1..4 */
    for (uint32_t k = 0U; k < 2U; k++) {         /* bound: 2 */
        xy_q28[k] = (int32_t)ocel_scale_q60(
            ocel_mul_q60((int64_t)flat->e_q28[k] * 0x4000000, y_q60), e - 30);
    }
    ocel_camera_unit(xy_q28, cone->axis_cam_q30);
    z_q30 = cone->axis_cam_q30[2];
    part_q60 = ocel_scale_q60(ocel_mul_q60(q_q56 - ONE_Q56, y_q60), e);
    cone->sin_q30 = (uint32_t)ocel_shift_round64(
        ocel_sqrt_q60((uint64_t)ocel_mul_q60(part_q60, (int64_t)z_q30 * z_q30)), 30U);
}

/* sigma^2 / (a b), the variance of the centre by the squared radius, is taken for that
 * of the range, which on a short arc it is; across the axis it is sin^2 of it, half for
 * each direction.  At most 1: sigma^2 < a b <= 2^60. */
static void spread(const ocel_ellipse_t *ellipse, ocel_cone_t *cone) {
    const uint64_t square_q32 =
        (uint64_t)ellipse->centre_sigma_px_q16 * ellipse->centre_sigma_px_q16;
    const uint64_t area_q32 = (uint64_t)ellipse->a_px_q16 * (uint64_t)ellipse->b_px_q16;
    int64_t range_q60 = OCEL_Q60_ONE;
    int64_t across_q60;
    uint32_t at = 0U;

    if (square_q32 < area_q32) {
        int64_t y_q60;
        int32_t e;

        ocel_recip_q60(area_q32, &y_q60, &e);
        range_q60 = ocel_scale_q60(ocel_mul_q60((int64_t)square_q32, y_q60), e);
    }
    across_q60 =
        ocel_asr64(ocel_mul_q60(range_q60, (int64_t)cone->sin_q30 * (int64_t)cone->sin_q30), 1U);
    for (uint32_t i = 0U; i < 3U; i++) {    /* bound: 3 */
        for (uint32_t j = i; j < 3U; j++) { /* bound: 3 */
            const int64_t product_q60 = (int64_t)cone->axis_cam_q30[i] * cone->axis_cam_q30[j];

            cone->cov_q60[at] =
                ocel_mul_q60(range_q60 - across_q60, product_q60) + ((i == j) ? across_q60 : 0);
            at++;
        }
    }
}

ocel_status_t ocel_cone_of_ellipse(const ocel_camera_t *camera, const ocel_ellipse_t *ellipse,
                                   ocel_cone_t *cone) {
    ocel_status_t status = OCEL_NULL_ARGUMENT;

    if (cone != NULL) {
        (void)memset(cone, 0, sizeof(*cone));
    }
    if ((camera != NULL) && (ellipse != NULL) && (cone != NULL)) {
        flat_t flat;

        if (!camera->ready) {
            status = OCEL_BAD_ORDER;
        } else if ((ellipse->a_px_q16 <= 0) || (ellipse->b_px_q16 <= 0)) {
            status = OCEL_DEGENERATE;
        } else if (!flatten(camera, ellipse, &flat)) {
            status = OCEL_OUT_OF_RANGE;
        } else if ((flat.area_q56 < AREA_MIN_Q56) || (flat.area_q56 > AREA_MAX_Q56)) {
            status = (flat.area_q56 < AREA_MIN_Q56) ? OCEL_DEGENERATE : OCEL_OUT_OF_RANGE;
        } else {
            cone_over(&flat, cone);
            spread(ellipse, cone);
            cone->rms_px_q16 = ellipse->rms_px_q16;
            cone->arc_coverage_q16 = ellipse->arc_coverage_q16;
            cone->point_count = ellipse->point_count;
            cone->inlier_count = ellipse->point_count;
            status = OCEL_OK;
        }
    }
    return status;
}
