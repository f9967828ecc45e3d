/* SPDX-License-Identifier: MIT
 *
 * Boundary points as rays, in a frame that looks where they are.
 */
#ifndef OCELLUS_CONE_FRAME_H
#define OCELLUS_CONE_FRAME_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <ocellus/camera.h>
#include <ocellus/status.h>
#include <ocellus/types.h>

/* Points to be read, of one kind or the other. */
typedef struct {
    const ocel_camera_t *camera;
    const ocel_point_t *points; /* null: cracks */
    const ocel_crack_t *cracks;
    uint32_t count;   /* 1 .. OCEL_MAX_FIT_POINTS */
    int32_t f_px_q16; /* the mean of the focal lengths */
} ocel_cone_source_t;

/* A rotation from the camera's frame to one whose z is the unit vector in its
 * last row. */
typedef struct {
    int32_t r_q30[3][3];
} ocel_cone_frame_t;

/* Where the points are: the middle of them and how far they spread. */
typedef struct {
    ocel_cone_frame_t frame; /* looks at their mean */
    uint32_t spread_log2;    /* 0 .. 14: in units of h = 2^-this they are within about 1 */
    uint32_t pixel_q25;      /* a pixel there, in units of h */
} ocel_cone_place_t;

/* OCEL_OK; OCEL_OUT_OF_RANGE when the camera refuses the mean; OCEL_DEGENERATE
 * when the points spread less than a pixel or 2^-14 rad. */
ocel_status_t ocel_cone_place(const ocel_cone_source_t *source, ocel_cone_place_t *place);

/* The frame that looks along a unit vector, z > 0. */
void ocel_cone_frame(const int32_t axis_cam_q30[3], ocel_cone_frame_t *frame);

/* The unit vector in the camera's frame of a direction (x, y, 1) in `frame`, within
 * 80 degrees of its z. */
void ocel_cone_turn(const ocel_cone_frame_t *frame, int32_t x_q28, int32_t y_q28,
                    int32_t axis_cam_q30[3]);

/* The ray (x, y, 1) of point i, in the camera's frame and rotated; every number is
 * within 5.8.  False when the camera refuses the point. */
bool ocel_cone_ray(const ocel_cone_source_t *source, const ocel_cone_frame_t *frame, uint32_t i,
                   int32_t p_cam_q28[3], int32_t p_q28[3]);

/* 1 / z^2, what a pixel's angle shrinks by off the camera's axis; Q26, below 2^32.
 * z is a unit vector's, 1/6 at least. */
uint64_t ocel_cone_stretch_q26(int32_t z_q30);

#endif
