/* SPDX-License-Identifier: MIT
 *
 * The outline of a ball in the image.
 *
 * At distance 1 along the axis (X, Y, Z) a ball has the radius s = sin.  With
 * w = Z^2 - s^2 its outline in the plane z = 1 is the ellipse about (X, Y) Z / w with
 * the shape matrix (s / w)^2 (w I + (X, Y)(X, Y)'): semi-axes s sqrt(1 - s^2) / w along
 * (X, Y) and s / sqrt(w) across.  In pixels that is F (...) F with F = diag(fx, fy), whose
 * eigenvectors and eigenvalues are angle and squared semi-axes.
 */
#include <ocellus/cone.h>

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

#include "../base/int_math.h"
#include "../base/q60.h"
#include "../base/scale.h"
#include "../base/trig.h"
#include "cone_valid.h"

/* Z^2 - sin^2 of a cone that reaches, or all but reaches, 90 degrees off the axis. */
#define AHEAD_MIN_Q60 ((int64_t)0x40000000)

#define AXIS_MAX_Q16 ((int64_t)0x40000000) /* 16384 px */

/* What the functions below share: w, its inverse (e is 0..30) and the sine. */
typedef struct {
    int64_t w_q60;
    int64_t sin_q60;
    ocel_scaled_t inverse;
} cut_t;

/* value / w in Q16 px, the value in 2^14 px and within 2: below 2^61. */
static int64_t over_w_q16(const cut_t *cut, int64_t value_q60) {
    return ocel_scale_q60(ocel_mul_q60(value_q60, cut->inverse.y_q60), cut->inverse.e - 30);
}

/* Semi-axes and angle.  With F in 2^14 px every element below is within 2, the larger
 * eigenvalue within 3.5 (of a unit vector: 1 and 1).  The smaller one's error, 2^-52 of
 * the larger, matters only at axis ratios that are out of range. */
static bool outline_axes(const ocel_camera_t *camera, const int32_t axis_q30[3], const cut_t *cut,
                         ocel_ellipse_t *ellipse) {
    int64_t fv_q60[2];
    int64_t m_q60[2];
    int64_t sum;
    int64_t difference;
    int64_t larger; /* eigenvalue */
    int64_t smaller;
    int64_t a_px_q16;
    int64_t b_px_q16;
    uint32_t turn_q32;

    for (uint32_t i = 0U; i < 2U; i++) { /* bound: 2 */
        const int64_t f_q60 = (int64_t)camera->axis[i].f_px_q16 * (int64_t)OCEL_ONE_Q30;

        fv_q60[i] = (int64_t)camera->axis[i].f_px_q16 * axis_q30[i];
        m_q60[i] = ocel_mul_q60(ocel_mul_q60(f_q60, f_q60), cut->w_q60) +
                   ocel_mul_q60(fv_q60[i], fv_q60[i]);
    }
    ocel_polar(ocel_asr64(m_q60[0] - m_q60[1], 1U), ocel_mul_q60(fv_q60[0], fv_q60[1]), &difference,
               &turn_q32);
    sum = ocel_asr64(m_q60[0] + m_q60[1], 1U);
    difference = (difference < sum) ? difference : sum;
    larger = sum + difference;
    smaller = sum - difference;
    a_px_q16 = over_w_q16(cut, ocel_mul_q60(cut->sin_q60, ocel_sqrt_q60((uint64_t)larger)));
    b_px_q16 = over_w_q16(cut, ocel_mul_q60(cut->sin_q60, ocel_sqrt_q60((uint64_t)smaller)));
    ellipse->angle_turn_q32 = turn_q32 >> 1U;
    ellipse->a_px_q16 = (int32_t)a_px_q16;
    ellipse->b_px_q16 = (int32_t)b_px_q16;
    return (a_px_q16 <= AXIS_MAX_Q16) && (b_px_q16 > 0);
}

/* c + f X Z / w. */
static bool outline_centre(const ocel_camera_t *camera, const int32_t axis_q30[3], const cut_t *cut,
                           ocel_ellipse_t *ellipse) {
    int64_t c_px_q16[2];
    bool fits = true;

    for (uint32_t i = 0U; i < 2U; i++) { /* bound: 2 */
        const int64_t f_q60 = (int64_t)camera->axis[i].f_px_q16 * (int64_t)OCEL_ONE_Q30;
        const int64_t xz_q60 = (int64_t)axis_q30[i] * axis_q30[2];

        c_px_q16[i] = over_w_q16(cut, ocel_mul_q60(f_q60, xz_q60)) + camera->axis[i].c_px_q16;
        fits = fits && (ocel_abs64(c_px_q16[i]) <= (uint64_t)INT32_MAX);
    }
    ellipse->cx_px_q16 = (int32_t)c_px_q16[0];
    ellipse->cy_px_q16 = (int32_t)c_px_q16[1];
    return fits;
}

static ocel_status_t outline(const ocel_camera_t *camera, const ocel_cone_t *cone,
                             ocel_ellipse_t *ellipse) {
    const int32_t z_q30 = cone->axis_cam_q30[2];
    const int32_t sin_q30 = (int32_t)cone->sin_q30;
    ocel_status_t status = OCEL_NOT_AN_ELLIPSE;
    cut_t cut;

    cut.w_q60 = ((int64_t)z_q30 * z_q30) - ((int64_t)sin_q30 * sin_q30);
    cut.sin_q60 = sin_q30 * (int64_t)OCEL_ONE_Q30;
    if ((z_q30 > 0) && (cut.w_q60 >= AHEAD_MIN_Q60)) {
        ocel_recip_q60((uint64_t)cut.w_q60, &cut.inverse.y_q60, &cut.inverse.e);
        status = OCEL_OUT_OF_RANGE;
        if (outline_centre(camera, cone->axis_cam_q30, &cut, ellipse)) {
            status = outline_axes(camera, cone->axis_cam_q30, &cut, ellipse) ? OCEL_OK : status;
        }
    }
    return status;
}

ocel_status_t ocel_cone_outline(const ocel_camera_t *camera, const ocel_cone_t *cone,
                                ocel_ellipse_t *ellipse) {
    ocel_status_t status = OCEL_NULL_ARGUMENT;

    if (ellipse != NULL) {
        (void)memset(ellipse, 0, sizeof(*ellipse));
    }
    if ((camera != NULL) && (cone != NULL) && (ellipse != NULL)) {
        if (!camera->ready) {
            status = OCEL_BAD_ORDER;
        } else if (!ocel_cone_is_valid(cone)) {
            status = OCEL_OUT_OF_RANGE;
        } else {
            status = outline(camera, cone, ellipse);
        }
        if (status == OCEL_OK) {
            ellipse->rms_px_q16 = cone->rms_px_q16;
            ellipse->arc_coverage_q16 = cone->arc_coverage_q16;
            ellipse->point_count = cone->inlier_count;
        } else {
            (void)memset(ellipse, 0, sizeof(*ellipse));
        }
    }
    return status;
}
