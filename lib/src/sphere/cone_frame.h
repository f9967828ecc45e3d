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

#include "../base/camera_ray.h"
#include "../base/int_math.h"

/* Points to be read, of one kind or the other. */
typedef struct {
    const ocel_camera_t *camera;
    const ocel_point_t *points; /* null: cracks */
    const ocel_crack_t *cracks;
    uint32_t count;   /* 1 .. OCEL_MAX_FIT_POINTS */
    bool plain;       /* no lens to undo, and no point that the camera refuses */
    int32_t f_px_q16; /* the mean of the focal lengths */
} ocel_cone_source_t;

/* Points that stand for all: sample k is point k * count / OCEL_CONE_SAMPLES, so of
 * fewer points some stand twice. */
#define OCEL_CONE_SAMPLES 32U

/* A rotation from the camera's frame to one whose z is the unit vector in its
 * last row. */
typedef struct {
    int32_t r_q30[3][3];
} ocel_cone_frame_t;

/* Where the points are: the middle of them and how far they spread. */
typedef struct {
    int32_t axis_cam_q30[3]; /* towards the samples' mean */
    uint32_t spread_log2;    /* 0 .. 14: in units of h = 2^-this they are within about 1 */
    uint32_t pixel_q25;      /* a pixel there, in units of h */
} ocel_cone_place_t;

/* OCEL_OK; OCEL_OUT_OF_RANGE when the camera refuses the mean; OCEL_DEGENERATE
 * when the samples spread less than a pixel or 2^-14 rad. */
ocel_status_t ocel_cone_place(const ocel_cone_source_t *source, ocel_cone_place_t *place);

/* The frame that looks along a unit vector, z > 0. */
void ocel_cone_frame(const int32_t axis_cam_q30[3], ocel_cone_frame_t *frame);

/* The unit vector in the camera's frame of a direction (x, y, 1) in `frame`, within
 * 80 degrees of its z. */
void ocel_cone_turn(const ocel_cone_frame_t *frame, int32_t x_q28, int32_t y_q28,
                    int32_t axis_cam_q30[3]);

/* Point i, Q16 px. */
static inline void ocel_cone_pixel(const ocel_cone_source_t *source, uint32_t i,
                                   int32_t xy_px_q16[2]) {
    if (source->points != NULL) {
        xy_px_q16[0] = source->points[i].x_px_q16;
        xy_px_q16[1] = source->points[i].y_px_q16;
    } else {
        xy_px_q16[0] = (int32_t)source->cracks[i].x_hpx * 32768;
        xy_px_q16[1] = (int32_t)source->cracks[i].y_hpx * 32768;
    }
}

/* The axis that a crack lies along, from pixel to pixel: 1 x, whose half it is at, 0 y.  Of
 * other points it means nothing. */
static inline uint32_t ocel_cone_along(int32_t x_px_q16) {
    return ((uint32_t)x_px_q16 >> 15U) & 1U;
}

/* Whether the map from pixel to ray is affine on all of the points: the camera has no
 * lens and sees the four corners of their box. */
bool ocel_cone_is_plain(const ocel_cone_source_t *source);

/* From a point to its ray (x, y, 1) in a frame: component k is
 * g[k][0] a + g[k][1] b + g[k][2] in Q58, (a, b) the pixel in Q16 for plain points and
 * the slopes in Q28 otherwise.  Modulo 2^64: terms may be larger than their sum. */
typedef struct {
    uint64_t g[3][3];
} ocel_cone_map_t;

/* The map into the frame that looks along an axis, its x and y scaled by `side` and its z
 * by `depth`, both at most 1. */
void ocel_cone_map(const ocel_cone_source_t *source, const int32_t axis_cam_q30[3],
                   int32_t side_q30, int32_t depth_q30, ocel_cone_map_t *map);

/* What the map takes of point i.  False when the camera refuses the point. */
static inline bool ocel_cone_take(const ocel_cone_source_t *source, uint32_t i, int32_t ab[2]) {
    ocel_cone_pixel(source, i, ab);
    return source->plain || ocel_camera_normalise(source->camera, ab[0], ab[1], ab);
}

/* Component k of a point's ray: below 5.8, for the point is within 80 degrees of the
 * camera's axis, so below 2^60.6. */
static inline int64_t ocel_cone_component_q58(const ocel_cone_map_t *map, uint32_t k, int32_t a,
                                              int32_t b) {
    return ocel_signed64((map->g[k][0] * (uint64_t)(int64_t)a) +
                         (map->g[k][1] * (uint64_t)(int64_t)b) + map->g[k][2]);
}

/* 1 / z^2, what a pixel's angle shrinks by off the camera's axis; Q26, below 2^32.
 * z is a unit vector's, 1/6 at least. */
uint64_t ocel_cone_stretch_q26(int32_t z_q30);

#endif
