/* SPDX-License-Identifier: MIT
 *
 * What the tracker takes and gives.
 */
#ifndef OCELLUS_TRACK_H
#define OCELLUS_TRACK_H

#include <stdint.h>

#include <ocellus/space.h>
#include <ocellus/stereo.h>

typedef enum {
    OCEL_TRACK_LOST = 0, /* never seen, or hidden for longer than the coasting time */
    OCEL_TRACK_GUESSED,  /* predicted from earlier frames */
    OCEL_TRACK_SEEN      /* a measurement of this frame was taken */
} ocel_track_state_t;

typedef struct {
    uint32_t coast_us;     /* how long a hidden ball is guessed, 1 .. 4000000 */
    int32_t max_speed_u_s; /* along an axis, 1 .. 2^26, and at most 2^26 u in coast_us */
    int32_t wander_u_s;    /* by how much the velocity changes in a second, standard
                              deviation; in a time t it is sqrt(t) of it; 0 .. max_speed_u_s */
    uint32_t gate_q16;     /* standard deviations, 1 .. 16 */
    int32_t gate_floor_u;  /* what is added to them, 0 .. 2^26 */
    int32_t acceleration_root_u_s2[3]; /* known beforehand: gravity, for a ball in flight;
                                          within +-2^27, 0: none */
} ocel_tracker_config_t;

/* A measurement as the filter takes it.  Opaque. */
typedef struct {
    int64_t p_u_q16[3];
    int64_t cov_q6[OCEL_SYM3_COUNT];
} ocel_fix_t;

/* The filter of three axes.  Opaque. */
typedef struct {
    int64_t p_u_q16[3];
    int64_t v_u_s_q16[3];
    int64_t cov_q6[OCEL_SYM3_COUNT][4]; /* pp, pv, vp, vv of one axis with another */
} ocel_filter_t;

/* What is known of the ball. */
typedef struct {
    ocel_track_state_t state;
    int32_t p_root_u[3];
    int32_t v_root_u_s[3];
    int64_t cov_root_u2[OCEL_SYM3_COUNT]; /* of the position, the diagonal rounded up */
    int64_t seen_us;                      /* when a measurement was last taken; INT64_MIN: never */
} ocel_track_t;

#endif
