/* SPDX-License-Identifier: MIT
 *
 * A ball is a cone of rays: the unit vectors d towards its outline satisfy
 * d . m = 1 with m = axis / cos(half the opening angle).  Three points determine
 * it and any number fit it by linear least squares, with no perspective error;
 * it needs no radius.
 */
#ifndef OCELLUS_CONE_H
#define OCELLUS_CONE_H

#include <stddef.h>
#include <stdint.h>

#include <ocellus/camera.h>
#include <ocellus/space.h>
#include <ocellus/status.h>
#include <ocellus/types.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A fitted cone, in the camera's frame. */
typedef struct {
    int32_t axis_cam_q30[3]; /* unit vector towards the ball's centre */
    uint32_t sin_q30;        /* of half the opening angle: radius / distance of the centre */
    int64_t cov_q60[OCEL_SYM3_COUNT]; /* covariance of the centre over its distance squared */
    uint32_t rms_px_q16;              /* of the inliers' distances from the outline */
    uint32_t arc_coverage_q16; /* fraction of the outline's turn that inliers cover, <= 65536 */
    uint32_t point_count;
    uint32_t inlier_count;
    uint32_t hypothesis_count; /* cones through three points that were voted on, <=
                                  OCEL_CONE_HYPOTHESES; 0 of a cone from an ellipse */
} ocel_cone_t;

/* Fits the cone to boundary points, robustly: OCEL_CONE_HYPOTHESES cones through three
 * of 32 evenly spaced points (a fixed rule, cone_vote.c), the one that most of them
 * consent to, then least squares on all points that are near it.  What hides a part of
 * the ball, or the image's edge, may so take a part of the points.  No random source: the
 * same points in the same order give the same bits.  Any order will do; another order
 * has other samples, and an answer within the noise of the first.
 *   points   count points; not written.
 *   cone     out; written for OCEL_OK and OCEL_PARTIAL, zeroed otherwise.
 * OCEL_OK               vouched for: more than half of the points consent (inlier_count)
 *                       and cover a quarter of the turn; at most 1 in 25 lies outside; they
 *                       do not bend away together; the range's sigma is below 1 % and
 *                       rms below .14 px + .384 px * arc_coverage
 * OCEL_PARTIAL          an estimate that fails one of these; cov is 1 where nothing
 *                       could be solved
 * OCEL_TOO_FEW_POINTS   count < OCEL_MIN_FIT_POINTS
 * OCEL_DEGENERATE       no three samples determine a cone of at most 90 degrees
 *                       (collinear, coincident), or they spread less than a pixel
 * OCEL_OUT_OF_RANGE     a point that ocel_camera_ray refuses
 * OCEL_OVERFLOW         count > OCEL_MAX_FIT_POINTS
 * OCEL_BAD_ORDER        the camera was not initialised
 * OCEL_NULL_ARGUMENT    a pointer is null */
ocel_status_t ocel_cone_fit_points(const ocel_camera_t *camera, const ocel_point_t *points,
                                   size_t count, ocel_cone_t *cone);

/* The same for boundary cracks, of which it is also used between which two pixels each has
 * the outline: half the error of their midpoints on a sharp mask.  Same statuses. */
ocel_status_t ocel_cone_fit_cracks(const ocel_camera_t *camera, const ocel_crack_t *cracks,
                                   size_t count, ocel_cone_t *cone);

/* The cone through a fitted ellipse: for comparing the methods.  rms and arc are
 * the ellipse's, inlier_count its point_count.
 * OCEL_OK, OCEL_DEGENERATE, OCEL_OUT_OF_RANGE, OCEL_BAD_ORDER, OCEL_NULL_ARGUMENT */
ocel_status_t ocel_cone_of_ellipse(const ocel_camera_t *camera, const ocel_ellipse_t *ellipse,
                                   ocel_cone_t *cone);

/* The outline of the ball in the image, lens distortion left out; rms, arc and
 * counts are the cone's.
 * OCEL_OK
 * OCEL_NOT_AN_ELLIPSE  the outline reaches behind the camera
 * OCEL_OUT_OF_RANGE    beyond the range of ocel_ellipse_t
 * OCEL_BAD_ORDER, OCEL_NULL_ARGUMENT */
ocel_status_t ocel_cone_outline(const ocel_camera_t *camera, const ocel_cone_t *cone,
                                ocel_ellipse_t *ellipse);

#ifdef __cplusplus
}
#endif

#endif
