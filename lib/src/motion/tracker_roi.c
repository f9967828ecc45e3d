/* SPDX-License-Identifier: MIT */
#include <ocellus/tracker.h>

#include <stddef.h>
#include <string.h>

#include "../base/int_math.h"

#define RADIUS_MAX_U 0x40000000

/* A cube's corners. */
#define CORNERS 8U

/* The box of what was projected, px Q16, and how many points that were. */
typedef struct {
    int32_t low[2];
    int32_t high[2];
    uint32_t count;
} extent_t;

/* A point of the root frame as an eye sees it, in units of 4 u, so that all that may
 * come of it fits.  The distance's components are below 2^31.6 and a column of the
 * rotation has length 1: the sum is below sqrt(3) 2^61.6, the result below 2^30.4. */
static void to_eye(const ocel_pose_t *X_root_eye, const int32_t p_root_u[3], int32_t p_cam_4u[3]) {
    for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 axes */
        int64_t sum = 0;

        for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
            sum += ((int64_t)p_root_u[i] - X_root_eye->p_u[i]) * X_root_eye->r_q30[i][k];
        }
        p_cam_4u[k] = (int32_t)ocel_shift_round64(sum, 32U);
    }
}

/* OCEL_ROI_SIGMAS deviations of a position, whatever their direction: those of the
 * trace, which is below 3 * 2^53 for what a track tells; at most 2^29. */
static uint32_t spread_u(const ocel_track_t *track) {
    uint64_t trace = 0U;

    trace += (uint64_t)track->cov_root_u2[OCEL_XX];
    trace += (uint64_t)track->cov_root_u2[OCEL_YY];
    trace += (uint64_t)track->cov_root_u2[OCEL_ZZ];
    return (uint32_t)OCEL_ROI_SIGMAS * ocel_isqrt64(trace);
}

static void include(extent_t *extent, const ocel_point_t *pixel) {
    const int32_t at[2] = {pixel->x_px_q16, pixel->y_px_q16};

    for (uint32_t k = 0U; k < 2U; k++) { /* bound: 2, x and y */
        extent->low[k] = (at[k] < extent->low[k]) ? at[k] : extent->low[k];
        extent->high[k] = (at[k] > extent->high[k]) ? at[k] : extent->high[k];
    }
    extent->count++;
}

/* The corners of the cube about p_cam, projected; those that cannot be are not
 * counted.  A convex body in front of a pinhole lies within the hull of its corners'
 * pictures. */
static extent_t project_cube(const ocel_camera_t *camera, const int32_t p_cam_4u[3], int32_t half) {
    extent_t extent = {{INT32_MAX, INT32_MAX}, {INT32_MIN, INT32_MIN}, 0U};

    for (uint32_t corner = 0U; corner < CORNERS; corner++) { /* bound: CORNERS */
        int32_t p_4u[3];
        ocel_point_t pixel;

        for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 axes */
            p_4u[k] = p_cam_4u[k] + ((((corner >> k) & 1U) != 0U) ? half : -half);
        }
        if (ocel_camera_project(camera, p_4u, &pixel) == OCEL_OK) {
            include(&extent, &pixel);
        }
    }
    return extent;
}

/* The pixels from `low` to `high` that are in the image: the first of them, and how
 * many; 0 when none. */
static uint16_t cut(int32_t low, int32_t high, uint16_t side, uint16_t *count) {
    const int32_t first = ocel_asr32(low + 32768, 16U);
    const int32_t last = ocel_asr32(high + 32768, 16U);
    const int32_t from = (first < 0) ? 0 : first;
    const int32_t to = (last < (int32_t)side) ? (last + 1) : (int32_t)side;

    *count = (uint16_t)((to > from) ? (to - from) : 0);
    return (uint16_t)((to > from) ? from : 0);
}

static ocel_status_t find(const ocel_track_t *track, const ocel_pose_t *X_root_eye,
                          const ocel_camera_t *camera, int32_t radius_u, ocel_rect_t *roi) {
    /* 2 more for the roundings to 4 u: below 2^28.6, and with p below 2^31. */
    const uint32_t half = (((uint32_t)radius_u + spread_u(track)) >> 2U) + 2U;
    int32_t p_cam_4u[3];
    extent_t extent;

    to_eye(X_root_eye, track->p_root_u, p_cam_4u);
    extent = project_cube(camera, p_cam_4u, (int32_t)half);
    if (extent.count == CORNERS) {
        roi->left = cut(extent.low[0], extent.high[0], camera->intrinsics.width, &roi->width);
        roi->top = cut(extent.low[1], extent.high[1], camera->intrinsics.height, &roi->height);
    } else if (extent.count > 0U) {
        roi->width = camera->intrinsics.width;
        roi->height = camera->intrinsics.height;
    } else {
        roi->width = 0U;
    }
    if ((roi->width == 0U) || (roi->height == 0U)) {
        (void)memset(roi, 0, sizeof(*roi));
    }
    return (roi->width == 0U) ? OCEL_NOT_SEEN : OCEL_OK;
}

ocel_status_t ocel_tracker_roi(const ocel_track_t *track, const ocel_pose_t *X_root_eye,
                               const ocel_camera_t *camera, int32_t radius_u, ocel_rect_t *roi) {
    ocel_status_t status = OCEL_NULL_ARGUMENT;

    if (roi != NULL) {
        (void)memset(roi, 0, sizeof(*roi));
    }
    if ((track != NULL) && (X_root_eye != NULL) && (camera != NULL) && (roi != NULL)) {
        if (!camera->ready) {
            status = OCEL_BAD_ORDER;
        } else if ((camera->intrinsics.width == 0U) || (camera->intrinsics.height == 0U)) {
            status = OCEL_BAD_SIZE;
        } else if ((radius_u < 1) || (radius_u > RADIUS_MAX_U)) {
            status = OCEL_OUT_OF_RANGE;
        } else if (track->state == OCEL_TRACK_LOST) {
            status = OCEL_NOT_SEEN;
        } else {
            status = find(track, X_root_eye, camera, radius_u, roi);
        }
    }
    return status;
}
