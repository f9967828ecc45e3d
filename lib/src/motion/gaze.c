/* SPDX-License-Identifier: MIT */
#include <ocellus/gaze.h>

#include <stddef.h>
#include <string.h>

#include "../base/int_math.h"
#include "../base/trig.h"
#include "seconds.h"

#define COMMAND_MIN_US 1000U
#define COMMAND_MAX_US 1000000U
#define US_PER_S 1000000U
#define ACCELERATION_MAX_Q24 0x20000000
#define ERROR_MAX_Q32 0x20000000
#define GAIN_MAX_Q16 (64 * 65536)
#define INTEGRAL_MAX_Q16 (256 * 65536)

/* The directions in which the gaze is led: each by a joint of the eyes, and the first
 * two also by one of the neck. */
enum { UP = 0, LEFT, TOGETHER, DIRECTIONS };
static const uint8_t eye_joint[DIRECTIONS] = {OCEL_EYES_TILT, OCEL_EYES_VERSION,
                                              OCEL_EYES_VERGENCE};
static const uint8_t neck_joint[TOGETHER] = {OCEL_NECK_PITCH, OCEL_NECK_YAW};

/* One call. */
typedef struct {
    const int32_t *joints_q32;
    int32_t error_q32[DIRECTIONS]; /* of the view: by how much it is to go there */
    bool known[DIRECTIONS];
    int64_t dt_q47;
} moment_t;

/* ---- Configuration ---- */

static bool is_within(int32_t v, int32_t lo, int32_t hi) {
    return (v >= lo) && (v <= hi);
}

static ocel_status_t check_joint(const ocel_gaze_t *gaze, uint32_t joint) {
    const ocel_gaze_config_t *const config = &gaze->config;
    ocel_status_t status = OCEL_OK;

    if ((config->max_speed_q32[joint] < 0) || (gaze->min_q32[joint] > gaze->max_q32[joint]) ||
        !is_within(config->max_acceleration_q24[joint], 1, ACCELERATION_MAX_Q24)) {
        status = OCEL_OUT_OF_RANGE;
    } else if ((config->sign[joint] != 1) && (config->sign[joint] != -1)) {
        status = OCEL_BAD_OPTION;
    } else {
        status = OCEL_OK;
    }
    return status;
}

static ocel_status_t check_config(const ocel_gaze_t *gaze) {
    const ocel_gaze_config_t *const config = &gaze->config;
    ocel_status_t status = OCEL_OK;

    if ((config->command_us < COMMAND_MIN_US) || (config->command_us > COMMAND_MAX_US) ||
        (config->dead_band_q32 < 0) || (config->integral_band_q32 < 0) ||
        !is_within(config->eye_gain_q16, 0, GAIN_MAX_Q16) ||
        !is_within(config->eye_integral_q16, 0, INTEGRAL_MAX_Q16) ||
        !is_within(config->neck_gain_q16, 0, GAIN_MAX_Q16) || (config->max_vergence_q32 < 0) ||
        (gaze->max_pan_q32 < (config->max_vergence_q32 / 2))) {
        status = OCEL_OUT_OF_RANGE;
    }
    for (uint32_t i = 0U; i < (uint32_t)OCEL_JOINT_COUNT; i++) { /* bound: OCEL_JOINT_COUNT */
        if (status == OCEL_OK) {
            status = check_joint(gaze, i);
        }
    }
    return status;
}

ocel_status_t ocel_gaze_init(ocel_gaze_t *gaze, const ocel_head_model_t *model,
                             const ocel_gaze_config_t *config) {
    ocel_status_t status = OCEL_NULL_ARGUMENT;

    if ((gaze != NULL) && (model != NULL) && (config != NULL)) {
        (void)memset(gaze, 0, sizeof(*gaze));
        gaze->config = *config;
        gaze->max_pan_q32 = model->max_pan_q32;
        (void)memcpy(gaze->min_q32, model->min_q32, sizeof(gaze->min_q32));
        (void)memcpy(gaze->max_q32, model->max_q32, sizeof(gaze->max_q32));
        status = check_config(gaze);
        gaze->ready = status == OCEL_OK;
    }
    return status;
}

ocel_status_t ocel_gaze_error(const int32_t d_cam[3], ocel_gaze_error_t *error) {
    ocel_status_t status = OCEL_NULL_ARGUMENT;

    if (error != NULL) {
        (void)memset(error, 0, sizeof(*error));
    }
    if ((d_cam != NULL) && (error != NULL)) {
        int64_t forward;
        int64_t length;
        uint32_t turn_q32;

        ocel_polar(d_cam[2], d_cam[0], &forward, &turn_q32);
        error->right_q32 = (int32_t)turn_q32;
        ocel_polar(forward, d_cam[1], &length, &turn_q32);
        error->down_q32 = (int32_t)turn_q32;
        error->seen = length != 0;
        status = error->seen ? OCEL_OK : OCEL_OUT_OF_RANGE;
    }
    return status;
}

/* ---- One joint ---- */

/* The fastest that a joint may go towards a limit which is `room` away, so that it
 * can always brake before it.  Commands come at intervals of at most T, each of which
 * may take a T off the speed v; the way until rest is longest with intervals of T,
 * and then at most (v + a T / 2)^2 / (2 a), equal to it where v is an odd multiple
 * of a T / 2.  A speed for which that is at most the room leaves one for which it is
 * so again after any interval up to T; so does one of at most a T and room / T.  The
 * larger of the two may be had.
 *   room_q32 < 2^32.5, a_q24 <= 2^29, a T <= 2^37, T <= 1 s: 2 a room is below 2^62.5,
 *   the result below 2^36; it is at most 2^4 short. */
static int64_t reach_q32(int64_t room_q32, int64_t a_q24, int64_t change_q32, uint32_t command_us) {
    int64_t reach = 0;

    if (room_q32 > 0) {
        const uint32_t root_q28 = ocel_isqrt64(2U * (uint64_t)a_q24 * (uint64_t)room_q32);
        const int64_t braked = ((int64_t)root_q28 * 16) - (ocel_asr64(change_q32, 1U) + 1);

        reach = (int64_t)ocel_udiv64((uint64_t)room_q32 * US_PER_S, command_us);
        reach = (reach < change_q32) ? reach : change_q32;
        reach = (reach > braked) ? reach : braked;
    }
    return reach;
}

/* By how much the eyes' pan limits a joint: |version| + vergence / 2 is within it.  The
 * vergence that is used leaves the rest to version, and the other way round; beyond
 * that share a joint can only come back, so neither closes in on the other. */
static int64_t pan_limit_q32(const ocel_gaze_t *gaze, const moment_t *moment, uint32_t joint) {
    const int64_t version = (int64_t)ocel_abs64(moment->joints_q32[OCEL_EYES_VERSION]);
    const int64_t vergence = (int64_t)ocel_abs64(moment->joints_q32[OCEL_EYES_VERGENCE]);
    const int64_t most = gaze->config.max_vergence_q32;
    const int64_t pan = gaze->max_pan_q32;
    int64_t limit = INT32_MAX;

    if (joint == (uint32_t)OCEL_EYES_VERSION) {
        limit = pan - ocel_asr64(((vergence > most) ? vergence : most) + 1, 1U);
    } else if (joint == (uint32_t)OCEL_EYES_VERGENCE) {
        limit = 2 * (pan - version);
        limit = (limit < most) ? limit : most;
    } else {
        limit = INT32_MAX;
    }
    return (limit < 0) ? 0 : limit;
}

/* The joint's next velocity: as wanted, as far as acceleration, speed and limits let
 * it.  |wanted| < 2^40. */
static int64_t drive(ocel_gaze_t *gaze, const moment_t *moment, uint32_t joint, int64_t wanted) {
    const ocel_gaze_config_t *const config = &gaze->config;
    const int64_t a_q24 = config->max_acceleration_q24[joint];
    const int64_t change = ocel_times(a_q24 * 256, ocel_seconds_q47(config->command_us), -47);
    const int64_t pan = pan_limit_q32(gaze, moment, joint);
    const int64_t at = moment->joints_q32[joint];
    const int64_t room[2] = {ocel_clamp64(gaze->max_q32[joint], pan) - at,
                             at - ocel_clamp64(gaze->min_q32[joint], pan)};
    int64_t v = gaze->speed_q32[joint];

    v += ocel_clamp64(wanted - v, ocel_times(a_q24 * 256, moment->dt_q47, -47));
    v = ocel_clamp64(v, config->max_speed_q32[joint]);
    for (uint32_t side = 0U; side < 2U; side++) { /* bound: 2 limits, v turned over for one */
        const int64_t reach = reach_q32(room[side], a_q24, change, config->command_us);

        v = -((v < reach) ? v : reach);
    }
    gaze->speed_q32[joint] = (int32_t)v;
    return v;
}

/* ---- All joints ---- */

/* v in the sense that a joint's sign gives it. */
static int64_t turned(int64_t v, int8_t sign) {
    return (sign < 0) ? -v : v;
}

/* value * gain: below 2^37. */
static int64_t times_q16(int32_t value, int32_t gain_q16) {
    return ocel_asr64((int64_t)value * gain_q16, 16U);
}

/* What both eyes tell, or the one that sees.  More than an eighth of a turn counts as
 * that, so that the sums hold. */
static void find_errors(const ocel_gaze_error_t errors[OCEL_EYE_COUNT], moment_t *moment) {
    const bool both = errors[OCEL_LEFT].seen && errors[OCEL_RIGHT].seen;

    (void)memset(moment->error_q32, 0, sizeof(moment->error_q32));
    for (uint32_t eye = 0U; eye < (uint32_t)OCEL_EYE_COUNT; eye++) { /* bound: 2 eyes */
        if (errors[eye].seen) {
            const int32_t right = (int32_t)ocel_clamp64(errors[eye].right_q32, ERROR_MAX_Q32);
            const int32_t down = (int32_t)ocel_clamp64(errors[eye].down_q32, ERROR_MAX_Q32);

            moment->error_q32[UP] -= ocel_asr32(down, both ? 1U : 0U);
            moment->error_q32[LEFT] -= ocel_asr32(right, both ? 1U : 0U);
            if (both) {
                moment->error_q32[TOGETHER] += (eye == (uint32_t)OCEL_LEFT) ? right : -right;
            }
        }
    }
    moment->known[UP] = errors[OCEL_LEFT].seen || errors[OCEL_RIGHT].seen;
    moment->known[LEFT] = moment->known[UP];
    moment->known[TOGETHER] = both;
}

/* The neck's velocity in a direction: what brings the eyes back to their middle. */
static int64_t follow(ocel_gaze_t *gaze, const moment_t *moment, uint32_t k) {
    const ocel_gaze_config_t *const config = &gaze->config;
    const int8_t sign = config->sign[neck_joint[k]];
    int64_t wanted = times_q16(moment->joints_q32[eye_joint[k]], config->neck_gain_q16);

    wanted = turned(turned(wanted, config->sign[eye_joint[k]]), sign);
    return turned(drive(gaze, moment, neck_joint[k], moment->known[k] ? wanted : 0), sign);
}

/* The eyes' velocity in a direction, over what the neck does there already.  The integral
 * takes up what small errors persist, those of a ball that moves evenly; after a large
 * one, or where the velocity cannot be had, it fades: so it neither winds up nor
 * carries the eyes past the ball. */
static void lead(ocel_gaze_t *gaze, const moment_t *moment, uint32_t k, int64_t neck) {
    const ocel_gaze_config_t *const config = &gaze->config;
    const uint32_t joint = eye_joint[k];
    const int64_t seen = moment->error_q32[k];
    const int32_t error = (int32_t)(seen - ocel_clamp64(seen, config->dead_band_q32));
    int64_t integral = moment->known[k] ? gaze->integral_q32[k] : 0;
    const int64_t wanted =
        turned((times_q16(error, config->eye_gain_q16) + integral) - neck, config->sign[joint]);
    const bool had = drive(gaze, moment, joint, wanted) == wanted;

    if (had && (ocel_clamp64(error, config->integral_band_q32) == error)) {
        integral += ocel_times((int64_t)error * config->eye_integral_q16, moment->dt_q47, -63);
    } else {
        integral = ocel_asr64(integral, 1U);
    }
    gaze->integral_q32[k] = (int32_t)ocel_clamp64(integral, config->max_speed_q32[joint]);
}

/* The time since the last call; after more than command_us the joints are at rest. */
static ocel_status_t take_time(ocel_gaze_t *gaze, int64_t time_us, int64_t *dt_q47) {
    ocel_status_t status = OCEL_OK;
    uint64_t dt_us = 0U;

    if (gaze->has_time && (time_us < gaze->time_us)) {
        status = OCEL_BAD_ORDER;
    } else {
        dt_us = gaze->has_time ? ((uint64_t)time_us - (uint64_t)gaze->time_us) : 0U;
        gaze->time_us = time_us;
        gaze->has_time = true;
    }
    if (dt_us > gaze->config.command_us) {
        dt_us = gaze->config.command_us;
        (void)memset(gaze->speed_q32, 0, sizeof(gaze->speed_q32));
        (void)memset(gaze->integral_q32, 0, sizeof(gaze->integral_q32));
    }
    *dt_q47 = ocel_seconds_q47((uint32_t)dt_us);
    return status;
}

static void move(ocel_gaze_t *gaze, const moment_t *moment) {
    const int64_t roll = times_q16(moment->joints_q32[OCEL_NECK_ROLL], gaze->config.neck_gain_q16);

    (void)drive(gaze, moment, OCEL_NECK_ROLL, moment->known[UP] ? -roll : 0);
    for (uint32_t k = 0U; k < (uint32_t)DIRECTIONS; k++) { /* bound: DIRECTIONS */
        lead(gaze, moment, k, (k < (uint32_t)TOGETHER) ? follow(gaze, moment, k) : 0);
    }
}

ocel_status_t ocel_gaze_update(ocel_gaze_t *gaze, int64_t time_us,
                               const ocel_gaze_error_t errors[OCEL_EYE_COUNT],
                               const int32_t joints_q32[OCEL_JOINT_COUNT],
                               int32_t command_q32[OCEL_JOINT_COUNT]) {
    ocel_status_t status = OCEL_NULL_ARGUMENT;
    moment_t moment;

    if (command_q32 != NULL) {
        (void)memset(command_q32, 0, sizeof(gaze->speed_q32));
    }
    if ((gaze != NULL) && (errors != NULL) && (joints_q32 != NULL) && (command_q32 != NULL)) {
        status = OCEL_BAD_ORDER;
        if (gaze->ready) {
            status = take_time(gaze, time_us, &moment.dt_q47);
            moment.joints_q32 = joints_q32;
            find_errors(errors, &moment);
            move(gaze, &moment);
            (void)memcpy(command_q32, gaze->speed_q32, sizeof(gaze->speed_q32));
            if ((status == OCEL_OK) && !moment.known[UP]) {
                status = OCEL_NOT_SEEN;
            }
        }
    }
    return status;
}
