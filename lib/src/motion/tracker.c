/* SPDX-License-Identifier: MIT */
#include <ocellus/tracker.h>

#include <stddef.h>
#include <string.h>

#include "../base/int_math.h"
#include "filter.h"

#define SPEED_MAX_U_S 0x4000000
#define LENGTH_MAX_U 0x4000000
#define ACCELERATION_MAX_U_S2 0x8000000
#define POSITION_MAX_U 0x40000000
#define COVARIANCE_MAX_U2 ((uint64_t)1U << 52U)

#define COAST_MAX_US 4000000U
#define US_PER_S 1000000

static bool is_in_range(int32_t v, int32_t lo, int32_t hi) {
    return (v >= lo) && (v <= hi);
}

static bool is_config_valid(const ocel_tracker_config_t *config) {
    const int64_t reach_u_us = (int64_t)config->max_speed_u_s * (int64_t)config->coast_us;
    bool valid = (config->coast_us > 0U) && (config->coast_us <= COAST_MAX_US) &&
                 is_in_range(config->max_speed_u_s, 1, SPEED_MAX_U_S) &&
                 (reach_u_us <= ((int64_t)LENGTH_MAX_U * US_PER_S)) &&
                 is_in_range(config->wander_u_s, 0, config->max_speed_u_s) &&
                 (config->gate_q16 >= 65536U) && (config->gate_q16 <= (16U * 65536U)) &&
                 is_in_range(config->gate_floor_u, 0, LENGTH_MAX_U);

    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
        valid = valid && is_in_range(config->acceleration_root_u_s2[i], -ACCELERATION_MAX_U_S2,
                                     ACCELERATION_MAX_U_S2);
    }
    return valid;
}

static bool is_measurement_valid(const ocel_estimate_t *measurement) {
    const int64_t *const cov = measurement->cov_root_u2;
    bool valid = (cov[OCEL_XX] >= 0) && (cov[OCEL_YY] >= 0) && (cov[OCEL_ZZ] >= 0);

    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
        valid = valid && is_in_range(measurement->p_root_u[i], -POSITION_MAX_U, POSITION_MAX_U);
    }
    for (uint32_t i = 0U; i < (uint32_t)OCEL_SYM3_COUNT; i++) { /* bound: 6 */
        valid = valid && (ocel_abs64(cov[i]) <= COVARIANCE_MAX_U2);
    }
    return valid;
}

ocel_status_t ocel_tracker_init(ocel_tracker_t *tracker, const ocel_tracker_config_t *config) {
    ocel_status_t status = OCEL_NULL_ARGUMENT;

    if ((tracker != NULL) && (config != NULL)) {
        (void)memset(tracker, 0, sizeof(*tracker));
        tracker->config = *config;
        tracker->seen_us = INT64_MIN;
        tracker->ready = is_config_valid(config);
        status = tracker->ready ? OCEL_OK : OCEL_OUT_OF_RANGE;
    }
    return status;
}

/* to - from, to >= from: any two times. */
static uint64_t time_between(int64_t from_us, int64_t to_us) {
    return (uint64_t)to_us - (uint64_t)from_us;
}

/* Predicts to the time of the frame, or ends a track that coasted for too long.  A
 * track that goes on was seen within the coasting time, which so bounds dt_us. */
static uint32_t go_on(ocel_tracker_t *tracker, int64_t time_us) {
    uint32_t dt_us = 0U;

    if (tracker->state != OCEL_TRACK_LOST) {
        if (time_between(tracker->seen_us, time_us) > tracker->config.coast_us) {
            tracker->state = OCEL_TRACK_LOST;
        } else {
            dt_us = (uint32_t)time_between(tracker->time_us, time_us);
            ocel_filter_advance(&tracker->filter, &tracker->config, dt_us);
        }
    }
    tracker->time_us = time_us;
    tracker->has_time = true;
    return dt_us;
}

/* Whether the measurement agrees with the one that was refused in the frame before;
 * then that one is the track. */
static bool restarts(ocel_tracker_t *tracker, uint32_t dt_us, const ocel_fix_t *fix) {
    ocel_filter_t other;
    bool agrees = tracker->has_refused;

    if (agrees) {
        ocel_filter_start(&other, &tracker->config, &tracker->refused);
        ocel_filter_advance(&other, &tracker->config, dt_us);
        agrees = ocel_filter_admits(&other, &tracker->config, fix);
    }
    if (agrees) {
        tracker->filter = other;
    }
    return agrees;
}

/* Takes or refuses the measurement of a frame. */
static ocel_status_t take_or_refuse(ocel_tracker_t *tracker, uint32_t dt_us,
                                    const ocel_estimate_t *measurement) {
    const ocel_tracker_config_t *const config = &tracker->config;
    bool taken = true;
    ocel_fix_t fix;

    ocel_filter_fix(&fix, measurement);
    if (tracker->state == OCEL_TRACK_LOST) {
        ocel_filter_start(&tracker->filter, config, &fix);
    } else {
        taken = ocel_filter_admits(&tracker->filter, config, &fix);
        if (!taken) {
            taken = restarts(tracker, dt_us, &fix);
        }
        if (taken) {
            ocel_filter_correct(&tracker->filter, config, &fix);
        }
    }
    if (taken) {
        tracker->state = OCEL_TRACK_SEEN;
        tracker->seen_us = tracker->time_us;
    } else {
        tracker->refused = fix;
    }
    return taken ? OCEL_OK : OCEL_PARTIAL;
}

static void report(const ocel_tracker_t *tracker, ocel_track_t *track) {
    const ocel_filter_t *const filter = &tracker->filter;

    track->state = tracker->state;
    track->seen_us = tracker->seen_us;
    if (tracker->state != OCEL_TRACK_LOST) {
        for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
            track->p_root_u[i] = (int32_t)ocel_shift_round64(filter->p_u_q16[i], 16U);
            track->v_root_u_s[i] = (int32_t)ocel_shift_round64(filter->v_u_s_q16[i], 16U);
        }
        for (uint32_t i = 0U; i < (uint32_t)OCEL_SYM3_COUNT; i++) { /* bound: 6 */
            const bool variance =
                (i == (uint32_t)OCEL_XX) || (i == (uint32_t)OCEL_YY) || (i == (uint32_t)OCEL_ZZ);

            /* A variance is rounded up, the others to nearest. */
            track->cov_root_u2[i] = ocel_asr64(filter->cov_q6[i][0] + (variance ? 63 : 32), 6U);
        }
    }
}

ocel_status_t ocel_tracker_update(ocel_tracker_t *tracker, int64_t time_us,
                                  const ocel_estimate_t *measurement, ocel_track_t *track) {
    ocel_status_t status = OCEL_NOT_SEEN;

    if (track != NULL) {
        (void)memset(track, 0, sizeof(*track));
    }
    if ((tracker == NULL) || (track == NULL)) {
        status = OCEL_NULL_ARGUMENT;
    } else if (!tracker->ready || (tracker->has_time && (time_us < tracker->time_us))) {
        status = OCEL_BAD_ORDER;
    } else if ((measurement != NULL) && !is_measurement_valid(measurement)) {
        status = OCEL_OUT_OF_RANGE;
    } else {
        const uint32_t dt_us = go_on(tracker, time_us);

        if (measurement != NULL) {
            status = take_or_refuse(tracker, dt_us, measurement);
        }
        if ((status != OCEL_OK) && (tracker->state == OCEL_TRACK_SEEN)) {
            tracker->state = OCEL_TRACK_GUESSED;
        }
        tracker->has_refused = status == OCEL_PARTIAL;
        report(tracker, track);
    }
    return status;
}
