/* SPDX-License-Identifier: MIT
 *
 * A pixel to the slopes of its ray: what a fit of many points needs of the
 * camera, without the root that makes the ray a unit vector.
 */
#ifndef OCELLUS_CAMERA_RAY_H
#define OCELLUS_CAMERA_RAY_H

#include <stdbool.h>
#include <stdint.h>

#include <ocellus/camera.h>

/* x/z and y/z of the ray through a pixel, distortion removed.  The camera is
 * ready; any coordinates.  The error is below 0.51 LSB without distortion; with it
 * the lens puts the ray within 1/64 px of the pixel.  The squares sum to
 * tan^2(80 degrees) < 32.2 at most, so 1 + x^2 + y^2 fits Q56.
 * False, and xy_q28 untouched, where ocel_camera_ray is OCEL_OUT_OF_RANGE. */
bool ocel_camera_normalise(const ocel_camera_t *camera, int32_t x_px_q16, int32_t y_px_q16,
                           int32_t xy_q28[2]);

/* The same whether or not the image holds the pixel; coordinates within 2^32. */
bool ocel_camera_normalise_beyond(const ocel_camera_t *camera, const int64_t pixel_q16[2],
                                  int32_t xy_q28[2]);

/* (x, y, 1) / sqrt(x^2 + y^2 + 1), of slopes within 80 degrees; error below 1 LSB. */
void ocel_camera_unit(const int32_t xy_q28[2], int32_t d_q30[3]);

#endif
