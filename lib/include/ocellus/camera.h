/* SPDX-License-Identifier: MIT
 *
 * The camera: from pixels to rays and back.
 */
#ifndef OCELLUS_CAMERA_H
#define OCELLUS_CAMERA_H

#include <stdbool.h>
#include <stdint.h>

#include <ocellus/status.h>
#include <ocellus/types.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A pinhole with the lens distortion of Brown and Conrady, as OpenCV orders and
 * defines it: with r^2 = x^2 + y^2 of the undistorted ray (x, y, 1),
 *   x' = x (1 + k1 r^2 + k2 r^4 + k3 r^6) + 2 p1 x y + p2 (r^2 + 2 x^2)
 *   y' = y (1 + k1 r^2 + k2 r^4 + k3 r^6) + p1 (r^2 + 2 y^2) + 2 p2 x y
 * and the pixel is (fx x' + cx, fy y' + cy). */
typedef struct {
    int32_t fx_px_q16; /* focal lengths, 16 .. 16384 px */
    int32_t fy_px_q16;
    int32_t cx_px_q16; /* principal point, within +-OCEL_MAX_COORDINATE_PX */
    int32_t cy_px_q16;
    int32_t k1_q24; /* distortion, each within +-16; all 0: none, and nothing is spent on it */
    int32_t k2_q24;
    int32_t p1_q24;
    int32_t p2_q24;
    int32_t k3_q24;
    uint16_t width; /* of the image, px, <= 16384; 0: not stated, and then not checked */
    uint16_t height;
} ocel_intrinsics_t;

/* What is derived from the intrinsics for one axis of the image. */
typedef struct {
    int32_t f_px_q16;
    int32_t c_px_q16;
    int32_t first_px_q16; /* coordinates that may have a ray: first .. first + span */
    uint32_t span_px_q16;
    int64_t inverse_f_q60; /* px^-1 */
} ocel_camera_axis_t;

/* The intrinsics and what is derived from them once.  Opaque; may be copied. */
typedef struct {
    ocel_intrinsics_t intrinsics;
    ocel_camera_axis_t axis[2]; /* x, y */
    int64_t reach_q56; /* squared tangent off the axis up to which the lens can be undone */
    bool distorted;
    bool ready;
} ocel_camera_t;

/* Checks the intrinsics and derives what the others need.
 * OCEL_OK
 * OCEL_OUT_OF_RANGE   a focal length of 0 or outside its range, a principal point, a
 *                     coefficient or a side outside its range, or no pixel of the image
 *                     within 80 degrees of the axis; the camera is not ready
 * OCEL_NULL_ARGUMENT  a pointer is null */
ocel_status_t ocel_camera_init(ocel_camera_t *camera, const ocel_intrinsics_t *intrinsics);

/* The unit vector along which the camera sees a pixel, distortion removed in
 * OCEL_UNDISTORT_STEPS steps.
 *   d_cam_q30  out, three numbers; zero unless OCEL_OK.
 * OCEL_OUT_OF_RANGE   the pixel is outside the image, if its size is stated
 *                     (pixels cover +-0.5), or over OCEL_MAX_COORDINATE_PX away, or over
 *                     80 degrees off the axis, or the lens cannot be inverted there to
 *                     1/64 px: beyond its fold, say
 * OCEL_BAD_ORDER      the camera was not initialised
 * OCEL_NULL_ARGUMENT  a pointer is null */
ocel_status_t ocel_camera_ray(const ocel_camera_t *camera, const ocel_point_t *pixel,
                              int32_t d_cam_q30[3]);

/* Where a point in front of the camera is seen, distortion applied.
 *   pixel  out; zero unless OCEL_OK.  It may lie outside the image.
 * OCEL_OUT_OF_RANGE   behind the camera, over 80 degrees off the axis, beyond the fold of
 *                     the lens, or over OCEL_MAX_COORDINATE_PX away in the image
 * OCEL_BAD_ORDER, OCEL_NULL_ARGUMENT  as above */
ocel_status_t ocel_camera_project(const ocel_camera_t *camera, const int32_t p_cam_u[3],
                                  ocel_point_t *pixel);

#ifdef __cplusplus
}
#endif

#endif
