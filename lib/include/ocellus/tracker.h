/* SPDX-License-Identifier: MIT
 *
 * The tracker: measured positions in, frame by frame, the ball's position and
 * velocity out, each with what is known of it; a ball that is hidden is guessed
 * for a stated time and then lost.
 *
 * All in the frame called root, which must not move.  Constant velocity, one
 * alpha-beta filter an axis, whose gains are Kalman's.
 */
#ifndef OCELLUS_TRACKER_H
#define OCELLUS_TRACKER_H

#include <stdbool.h>
#include <stdint.h>

#include <ocellus/camera.h>
#include <ocellus/space.h>
#include <ocellus/status.h>
#include <ocellus/stereo.h>
#include <ocellus/track.h>
#include <ocellus/types.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The context: caller-owned, without pointers.  Opaque.  A copy of it may be
 * updated without a measurement to learn what it predicts for a later time. */
typedef struct {
    ocel_tracker_config_t config;
    ocel_filter_t filter;
    ocel_fix_t refused; /* the last frame's, when has_refused */
    int64_t time_us;    /* of the last frame */
    int64_t seen_us;
    ocel_track_state_t state;
    bool has_refused;
    bool has_time;
    bool ready;
} ocel_tracker_t;

/* Checks the configuration and readies the context, without a track.
 * OCEL_OK
 * OCEL_OUT_OF_RANGE   a figure outside its range; the tracker is not ready
 * OCEL_NULL_ARGUMENT  a pointer is null */
ocel_status_t ocel_tracker_init(ocel_tracker_t *tracker, const ocel_tracker_config_t *config);

/* Takes one frame.  The status speaks of this frame: it is OCEL_OK only when a
 * measurement of it was taken.  What the track tells beside another status is a
 * guess, and its state says so.
 *   time_us      any, not less than the last frame's; equal times are one moment.
 *   measurement  null: the ball was not seen.  Else ocel_ball_t.best of ocel_stereo_ball,
 *                say: within +-2^30 u, covariances within +-2^52 u^2, variances from 0.
 *   track        out; when LOST all but seen_us is zero.  All zero for the last three
 *                statuses, which leave the tracker as it was.
 * OCEL_OK             taken: it passed the gate, or started a track, or agrees with
 *                     the one that was refused in the frame before, and so restarted it
 * OCEL_PARTIAL        refused: outside the gate; the track is a guess
 * OCEL_NOT_SEEN       no measurement; the track is a guess, or lost
 * OCEL_OUT_OF_RANGE   a measurement outside its ranges
 * OCEL_BAD_ORDER      the time is before the last frame's, or not initialised
 * OCEL_NULL_ARGUMENT  tracker or track is null */
ocel_status_t ocel_tracker_update(ocel_tracker_t *tracker, int64_t time_us,
                                  const ocel_estimate_t *measurement, ocel_track_t *track);

/* Where in an image to look for a tracked ball: what encloses the ball at every
 * place within OCEL_ROI_SIGMAS standard deviations, cut by the image.  Where that
 * reaches beside or behind the camera it is the whole image.
 *   camera    with the image's size stated.
 *   radius_u  of the ball, 1 .. 2^30.
 *   roi       out; zero unless OCEL_OK.
 * OCEL_OK
 * OCEL_NOT_SEEN       the track is lost, or nothing of it lies in the image
 * OCEL_OUT_OF_RANGE   a radius outside its range
 * OCEL_BAD_SIZE       the camera does not state the size of its image
 * OCEL_BAD_ORDER      the camera was not initialised
 * OCEL_NULL_ARGUMENT  a pointer is null */
ocel_status_t ocel_tracker_roi(const ocel_track_t *track, const ocel_pose_t *X_root_eye,
                               const ocel_camera_t *camera, int32_t radius_u, ocel_rect_t *roi);

#define OCEL_ROI_SIGMAS 4

#ifdef __cplusplus
}
#endif

#endif
