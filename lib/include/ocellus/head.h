/* SPDX-License-Identifier: MIT
 *
 * The head: a Denavit-Hartenberg chain from the robot's root over the neck to the
 * two eyes.  The chain is data, so a head of one's own is one more constant.
 */
#ifndef OCELLUS_HEAD_H
#define OCELLUS_HEAD_H

#include <stdint.h>

#include <ocellus/space.h>
#include <ocellus/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Eyes, as the arrays of two count them. */
enum { OCEL_LEFT = 0, OCEL_RIGHT, OCEL_EYE_COUNT };

/* The joints, as a robot's encoders give them; a model says which way each turns.
 * Version is the eyes' common pan, vergence the full angle between them (the
 * paper's EVG is half of it). */
typedef enum {
    OCEL_NECK_PITCH = 0,
    OCEL_NECK_ROLL,
    OCEL_NECK_YAW,
    OCEL_EYES_TILT,
    OCEL_EYES_VERSION,
    OCEL_EYES_VERGENCE,
    OCEL_JOINT_COUNT /* as a link's joint: the link does not move */
} ocel_joint_t;

enum { OCEL_MAX_HEAD_LINKS = 8 };

/* One link of standard Denavit-Hartenberg: Rz(theta) Tz(d) Tx(a) Rx(alpha), with
 *   theta = offset + sign joint + side vergence_sign vergence / 2,
 * side -1 for the left eye, +1 for the right one, 0 for their middle. */
typedef struct {
    int32_t a_u;
    int32_t d_u;
    int32_t d_side_u; /* side times this is added to d: half the baseline, where the eyes part */
    int32_t alpha_q32;
    int32_t offset_q32;
    uint8_t joint; /* an ocel_joint_t */
    int8_t sign;
    int8_t vergence_sign; /* not 0 where the eyes pan */
} ocel_head_link_t;

/* A head.  The last link ends in the camera's frame (x right, y down, z forward).
 * The links' lengths and the base's position come to less than 2^30 u together; the least
 * vergence is 0 or more. */
typedef struct {
    ocel_pose_t X_root_base;
    ocel_head_link_t links[OCEL_MAX_HEAD_LINKS];
    uint32_t link_count;
    int32_t min_q32[OCEL_JOINT_COUNT];
    int32_t max_q32[OCEL_JOINT_COUNT];
    int32_t max_pan_q32; /* of each eye: |version| + vergence / 2 is at most this, >= 0 */
} ocel_head_model_t;

/* The paper's head (its Tables 1 and 2): u is a millionth of its SMU; root x forward,
 * y left, z up, on the floor.  Signs: pitch and tilt + up, yaw and version + left; no
 * roll.  The paper gives no limits; these are the iCub's. */
extern const ocel_head_model_t ocel_head_paper;

/* The iCub's head, versions 1 and 2: u is a micrometre; root x back, y right, z up, at
 * the waist, the torso's joints at 0.  Signs: pitch and tilt + up, roll + the right ear
 * down, yaw + left, version + RIGHT. */
extern const ocel_head_model_t ocel_head_icub_v1;
extern const ocel_head_model_t ocel_head_icub_v2;

/* Where both eyes' cameras are.
 *   joints_q32  signed fractions of a turn, in the order of ocel_joint_t
 *   X_root_eye  out: left, right; zero unless OCEL_OK.  The rotation is orthonormal to
 *               2^-26, the position within half a u and 2^-26 of the arm's length, each axis.
 * OCEL_OK
 * OCEL_OUT_OF_RANGE   a joint beyond its limits, an eye's pan beyond its limit
 * OCEL_BAD_OPTION     a model of more than OCEL_MAX_HEAD_LINKS links
 * OCEL_NULL_ARGUMENT  a pointer is null */
ocel_status_t ocel_head_forward(const ocel_head_model_t *model,
                                const int32_t joints_q32[OCEL_JOINT_COUNT],
                                ocel_pose_t X_root_eye[OCEL_EYE_COUNT]);

/* The same for the middle of the eyes, a camera half-way that looks along the
 * version: the frame of ocel_stereo_encoders' answers.  Same statuses. */
ocel_status_t ocel_head_middle(const ocel_head_model_t *model,
                               const int32_t joints_q32[OCEL_JOINT_COUNT],
                               ocel_pose_t *X_root_middle);

/* A point that an eye, or their middle, sees, in the root's frame.  With the middle
 * and (0, 0, d0) it is the paper's target, T05 [0 0 0 1] (eqs. 15, 16).
 *   p_root_u  out; zero unless OCEL_OK.
 * OCEL_OK
 * OCEL_OUT_OF_RANGE   over 2^30 u away on an axis
 * OCEL_NULL_ARGUMENT  a pointer is null */
ocel_status_t ocel_head_place(const ocel_pose_t *X_root_eye, const int32_t p_eye_u[3],
                              int32_t p_root_u[3]);

/* From the iCub's root axes (x back, y right, z up) to those of the head frame (x
 * forward, y left, z up), or back: half a turn about z is its own inverse.  For points
 * and directions.
 * OCEL_OK
 * OCEL_OUT_OF_RANGE   INT32_MIN, which has no negative; v_head is zero
 * OCEL_NULL_ARGUMENT  a pointer is null */
ocel_status_t ocel_head_of_icub(const int32_t v_icub[3], int32_t v_head[3]);

#ifdef __cplusplus
}
#endif

#endif
