/* SPDX-License-Identifier: MIT
 *
 * Gaze: from where the two eyes see the ball to velocities of the head's joints that
 * bring it to the middle of both images and keep it there (paper, 5.2).
 *
 * The eyes lead: tilt, version and vergence answer to the images' errors.  The neck
 * follows: it turns so as to bring tilt and version back to 0, and the eyes turn
 * against it by as much.  A neck with roll is brought to roll 0.
 *
 * A command stands until the next one, but not longer than command_us: then the
 * caller's drive must stop by itself.  Under that condition
 *   - no joint ever passes a limit, of its own or of the eyes' pan, nor exceeds its
 *     speed, whatever comes in: a joint is let go only as fast as it can brake;
 *   - no velocity changes faster than its acceleration, if the joints have moved as
 *     they were told (to 2^-27 turn/s): where they have not, the limit comes first;
 *   - a joint beyond a limit gets no command further out.
 */
#ifndef OCELLUS_GAZE_H
#define OCELLUS_GAZE_H

#include <stdbool.h>
#include <stdint.h>

#include <ocellus/head.h>
#include <ocellus/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Where an eye sees the ball, off its optical axis. */
typedef struct {
    bool seen;
    int32_t right_q32; /* turns */
    int32_t down_q32;
} ocel_gaze_error_t;

typedef struct {
    /* +1 where the joint's positive sense turns the view up (pitch, tilt) or left (yaw,
     * version) or the eyes together (vergence), -1 where it does the opposite. */
    int8_t sign[OCEL_JOINT_COUNT];
    uint32_t command_us;                            /* 1000 .. 1000000 */
    int32_t max_speed_q32[OCEL_JOINT_COUNT];        /* turn/s, >= 0 */
    int32_t max_acceleration_q24[OCEL_JOINT_COUNT]; /* turn/s^2, 1 .. 2^29 (32 turn/s^2) */
    int32_t max_vergence_q32;  /* used of the model's; what it leaves of the pan is version's */
    int32_t dead_band_q32;     /* errors below it are none; >= 0 */
    int32_t eye_gain_q16;      /* of the error, 1/s: 0 .. 64 */
    int32_t eye_integral_q16;  /* of its integral, 1/s^2: 0 .. 256 */
    int32_t integral_band_q32; /* larger errors are not integrated; >= 0 */
    int32_t neck_gain_q16;     /* of the eyes' deviation, 1/s: 0 .. 64 */
} ocel_gaze_config_t;

/* For frames of 25 to 60 Hz, one frame late.  They differ in the sign of version only:
 * the paper's turns the eyes left, the iCub's right. */
extern const ocel_gaze_config_t ocel_gaze_paper;
extern const ocel_gaze_config_t ocel_gaze_icub;

/* The context: caller-owned, without pointers.  Opaque. */
typedef struct {
    ocel_gaze_config_t config;
    int32_t min_q32[OCEL_JOINT_COUNT];
    int32_t max_q32[OCEL_JOINT_COUNT];
    int32_t max_pan_q32;
    int32_t speed_q32[OCEL_JOINT_COUNT]; /* the last command */
    int32_t integral_q32[3];             /* up, left, together; turn/s */
    int64_t time_us;
    bool has_time;
    bool ready;
} ocel_gaze_t;

/* Checks the configuration and readies the context, at rest.
 *   model  for its joints' limits only.
 * OCEL_OK
 * OCEL_OUT_OF_RANGE   a figure outside its range, a limit below its opposite, or a
 *                     max_vergence_q32 over twice the pan's limit; the gaze is not ready
 * OCEL_BAD_OPTION     a sign other than +1 and -1
 * OCEL_NULL_ARGUMENT  a pointer is null */
ocel_status_t ocel_gaze_init(ocel_gaze_t *gaze, const ocel_head_model_t *model,
                             const ocel_gaze_config_t *config);

/* The error of a ball in a direction, of any length: a cone's axis, a sphere's centre,
 * or a guess of the tracker's in the camera's frame.
 *   error  out; seen, unless the direction is (0, 0, 0).
 * OCEL_OK
 * OCEL_OUT_OF_RANGE   no direction
 * OCEL_NULL_ARGUMENT  a pointer is null */
ocel_status_t ocel_gaze_error(const int32_t d_cam[3], ocel_gaze_error_t *error);

/* The velocities from now on.  Seen by one eye, tilt and version follow that eye and
 * vergence comes to rest; seen by none, all come to rest.
 *   time_us      any, not less than the last call's.  The first call commands rest, one
 *                after more than command_us starts from rest.
 *   joints_q32   where the joints are, in the order of ocel_joint_t.  Any value.
 *   command_q32  out, turn/s; zero if a pointer is null or the gaze not initialised.
 * OCEL_OK             at least one eye sees the ball
 * OCEL_NOT_SEEN       none does
 * OCEL_BAD_ORDER      the time is before the last call's: the command is the last one
 *                     again, or less where a limit wants it; or not initialised
 * OCEL_NULL_ARGUMENT  a pointer is null */
ocel_status_t ocel_gaze_update(ocel_gaze_t *gaze, int64_t time_us,
                               const ocel_gaze_error_t errors[OCEL_EYE_COUNT],
                               const int32_t joints_q32[OCEL_JOINT_COUNT],
                               int32_t command_q32[OCEL_JOINT_COUNT]);

#ifdef __cplusplus
}
#endif

#endif
