/* SPDX-License-Identifier: MIT
 *
 * Two eyes: where their rays meet, what the head's encoders alone say of it (the
 * paper's way), and the ball, its range measured twice.
 */
#ifndef OCELLUS_STEREO_H
#define OCELLUS_STEREO_H

#include <stdbool.h>
#include <stdint.h>

#include <ocellus/cone.h>
#include <ocellus/head.h>
#include <ocellus/space.h>
#include <ocellus/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How far stereo reaches, and how far on each axis the eyes may be from their frame's
 * origin: 268 m in micrometres. */
#define OCEL_MAX_STEREO_U 0x10000000 /* 2^28 */

/* Where two rays come closest to each other. */
typedef struct {
    int32_t p_u[3];      /* half-way between them */
    uint32_t gap_u;      /* from ray to ray */
    uint32_t range_u[2]; /* from each ray's beginning */
} ocel_midpoint_t;

/* The point half-way between two rays at their closest, in their frame.  Error: half a u,
 * and 2^-28 of the range for each unit of range / baseline (the directions' own LSB).
 *   midpoint  out; zero unless OCEL_OK.
 * OCEL_OK
 * OCEL_DEGENERATE     the rays are parallel to 2^-12 (.014 degrees), or come closest behind
 *                     the beginning of one or within 1 u of it
 * OCEL_OUT_OF_RANGE   a direction that is no unit vector (to 2^-17), a beginning beyond
 *                     OCEL_MAX_STEREO_U, a point beyond OCEL_MAX_STEREO_U
 * OCEL_NULL_ARGUMENT  a pointer is null */
ocel_status_t ocel_stereo_midpoint(const ocel_ray_t *ray_left, const ocel_ray_t *ray_right,
                                   ocel_midpoint_t *midpoint);

typedef enum {
    OCEL_ENCODERS_PAPER = 0, /* eq. 14: d0 = baseline / (2 tan EVG), EVG = vergence / 2; too far
                                by 1 / cos(version): 1.5 % at 10 degrees, 6.4 at 20, 15 at 30 */
    OCEL_ENCODERS_COSINE,    /* times cos(version) */
    OCEL_ENCODERS_EXACT      /* the two lines of sight intersected, each turned by what the
                                image still shows off its middle */
} ocel_encoders_t;

/* The fixation point from the eyes' joints.
 *   baseline_u   between the eyes, 1 .. OCEL_MAX_STEREO_U
 *   version_q32  + to the LEFT (of an iCub: the joint's negative), within a quarter turn
 *   vergence_q32 the full angle, within a quarter turn
 *   residual_q32 left, right: how far to the right of its eye's axis the target is seen,
 *                within a quarter turn each; the first two variants take no notice
 *   p_middle_u   out: in the frame of ocel_head_middle, the encoders' plane, so y is 0;
 *                zero unless OCEL_OK.  Relative error 2^-29 / sin(vergence).
 * OCEL_OK
 * OCEL_DEGENERATE     lines of sight parallel to 2^-12, or diverging, or meeting behind
 * OCEL_OUT_OF_RANGE   an argument beyond its range, a point over 2^30 u away
 * OCEL_BAD_OPTION     a variant outside its values
 * OCEL_NULL_ARGUMENT  a pointer is null */
ocel_status_t ocel_stereo_encoders(ocel_encoders_t variant, int32_t baseline_u, int32_t version_q32,
                                   int32_t vergence_q32, const int32_t residual_q32[OCEL_EYE_COUNT],
                                   int32_t p_middle_u[3]);

/* A position and how far to trust it. */
typedef struct {
    int32_t p_root_u[3];
    int64_t cov_root_u2[OCEL_SYM3_COUNT]; /* rounded up on the diagonal */
} ocel_estimate_t;

/* The ranges disagree from so many standard deviations of their difference on ... */
#define OCEL_DISAGREE_SIGMAS 5U
/* ... with this share of the range added, which is what a head's calibration may be
 * off: 1/32.  The rays may miss each other by this share alone. */
#define OCEL_DISAGREE_SHIFT 5U

/* A ball as two eyes see it. */
typedef struct {
    ocel_estimate_t best;
    ocel_estimate_t stereo;    /* from the directions alone; zero unless has_stereo */
    ocel_estimate_t by_radius; /* from one eye's cone, the surer one's; zero unless has_radius */
    uint32_t gap_u;            /* between the rays; 0 unless has_stereo */
    uint32_t radius_u;         /* measured: stereo's ranges, the cones' angles; same */
    bool has_stereo;
    bool has_radius; /* a radius was given */
    bool disagree;   /* fault: see OCEL_PARTIAL */
} ocel_ball_t;

/* Places the ball in the root's frame.
 *   cone_left, cone_right  null for an eye that does not see it
 *   X_root_eye             left, right, as ocel_head_forward gives them
 *   radius_u               of the ball; 0: not known
 *   result                 out; zero unless OCEL_OK or OCEL_PARTIAL.
 * OCEL_OK             both eyes and, if a radius is given, both ranges agree; or a radius and
 *                     one eye, or two whose directions leave over a quarter of the range
 *                     open (has_stereo is false then, and `best` is by_radius)
 * OCEL_PARTIAL        both eyes see something, but it is not vouched for that it is one ball
 *                     of this radius (disagree): the rays miss each other, or do not meet in
 *                     front, and `best` is by_radius where there is a radius; or the rays
 *                     meet where the radius denies it, and `best` is stereo
 * OCEL_NOT_SEEN       both cones are null
 * OCEL_DEGENERATE     no radius, and no stereo
 * OCEL_OUT_OF_RANGE   radius_u < 0, an axis or an eye's position that ocel_stereo_midpoint
 *                     refuses, what ocel_sphere_of_cone refuses, a cone with a deviation of
 *                     over half its range
 * OCEL_NULL_ARGUMENT  X_root_eye or result is null */
ocel_status_t ocel_stereo_ball(const ocel_cone_t *cone_left, const ocel_cone_t *cone_right,
                               const ocel_pose_t X_root_eye[OCEL_EYE_COUNT], int32_t radius_u,
                               ocel_ball_t *result);

#ifdef __cplusplus
}
#endif

#endif
