/* SPDX-License-Identifier: MIT
 *
 * The tracker beside the same filter in double precision, its gate and its clock,
 * and the region of interest beside projected points.
 */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <ocellus/ocellus.h>

#include "board.h"
#include "motion/seconds.h"
#include "rng.h"
#include "unity.h"

enum { SEED = 20111124, FRAME_US = 33333 };

static rng_t rng;

void setUp(void) {
    rng = rng_seed(SEED);
}

void tearDown(void) {
}

/* Micrometres: 10 m/s, gravity off, half a second. */
static ocel_tracker_config_t usual(void) {
    const ocel_tracker_config_t config = {500000U, 10000000, 3000000, 4U * 65536U, 5000, {0, 0, 0}};
    return config;
}

static ocel_tracker_t tracker_of(const ocel_tracker_config_t *config) {
    ocel_tracker_t tracker;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_tracker_init(&tracker, config));
    return tracker;
}

static ocel_estimate_t at(int32_t x, int32_t y, int32_t z, int32_t sigma_u) {
    const int64_t v = (int64_t)sigma_u * sigma_u;
    const ocel_estimate_t m = {{x, y, z}, {v, 0, 0, v, 0, v}};
    return m;
}

/* ---- The product that everything here is made of ---- */

static int64_t any_wide(void) {
    const int64_t size = (int64_t)(rng_u64(&rng) >> (3U + rng_below(&rng, 61U)));
    return ((rng_u32(&rng) & 1U) != 0U) ? -size : size;
}

static void products_saturate(void) {
    for (int k = 0; k < TEST_TRIALS(200000); k++) {
        const int64_t a = any_wide();
        const int64_t b = any_wide();
        const int32_t e = -rng_between(&rng, 0, 120);
        const int64_t sum = ocel_clamp64(any_wide(), (int64_t)1 << 60);
        const double scale = ldexp(1.0, e);
        const double wanted = (double)a * (double)b * scale;
        const double error = 0.51 + 2.0 * fabs((double)a) * scale + ldexp(fabs(wanted), -48);
        const double got = (double)ocel_times(a, b, e);
        int64_t total = sum;
        if (fabs(wanted) < ldexp(1.0, 60)) {
            TEST_ASSERT_TRUE(fabs(got - wanted) <= error);
        } else {
            TEST_ASSERT_TRUE(fabs(got) >= ldexp(1.0, 60) - error);
            TEST_ASSERT_TRUE((got > 0.0) == (wanted > 0.0));
        }
        TEST_ASSERT_TRUE(fabs(got) <= ldexp(1.0, 60));
        ocel_add_product(&total, a, b);
        TEST_ASSERT_EQUAL_INT64(ocel_clamp64(sum + ocel_times(a, b, -47), (int64_t)1 << 60), total);
    }
    TEST_ASSERT_EQUAL_INT64(0, ocel_times(0, INT64_MAX / 8, 0));
    TEST_ASSERT_EQUAL_INT64((int64_t)1 << 60, ocel_times((int64_t)1 << 60, (int64_t)1 << 60, 0));
    TEST_ASSERT_EQUAL_INT64(-5, ocel_clamp64(-9, 5));
    TEST_ASSERT_EQUAL_INT64(5, ocel_clamp64(9, 5));
    TEST_ASSERT_EQUAL_INT64(-3, ocel_clamp64(-3, 5));
    TEST_ASSERT_DOUBLE_WITHIN(3e-9, 1.0, (double)ocel_seconds_q47(1000000U) / ldexp(1.0, 47));
}

/* ---- The reference: the same filter in double, with 6x6 matrices ---- */

typedef struct {
    double x[6]; /* positions, velocities */
    double p[6][6];
} ref_t;

static const int ENTRY[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};

static double noise(const ocel_estimate_t *m, int i, int j) {
    return (double)m->cov_root_u2[ENTRY[i][j]] + ((i == j) ? 1.0 : 0.0);
}

/* p = a p a' */
static void sandwich(double p[6][6], double a[6][6]) {
    double half[6][6];
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            half[i][j] = 0.0;
            for (int k = 0; k < 6; k++) {
                half[i][j] += a[i][k] * p[k][j];
            }
        }
    }
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            p[i][j] = 0.0;
            for (int k = 0; k < 6; k++) {
                p[i][j] += half[i][k] * a[j][k];
            }
        }
    }
}

static void ref_start(ref_t *ref, const ocel_tracker_config_t *config, const ocel_estimate_t *m) {
    const double speed = config->max_speed_u_s * 65536.0 / config->gate_q16;
    memset(ref, 0, sizeof(*ref));
    for (int i = 0; i < 3; i++) {
        ref->x[i] = m->p_root_u[i];
        ref->p[3 + i][3 + i] = speed * speed;
        for (int j = 0; j < 3; j++) {
            ref->p[i][j] = noise(m, i, j);
        }
    }
}

static void ref_advance(ref_t *ref, const ocel_tracker_config_t *config, double t) {
    const double q = (double)config->wander_u_s * config->wander_u_s;
    double f[6][6] = {{0}};
    for (int i = 0; i < 6; i++) {
        f[i][i] = 1.0;
    }
    for (int i = 0; i < 3; i++) {
        const double a = config->acceleration_root_u_s2[i];
        f[i][3 + i] = t;
        ref->x[i] += ref->x[3 + i] * t + a * t * t / 2.0;
        ref->x[3 + i] += a * t;
    }
    sandwich(ref->p, f);
    for (int i = 0; i < 3; i++) {
        ref->p[i][i] += q * t * t * t / 2.0;
        ref->p[i][3 + i] += q * t * t / 2.0;
        ref->p[3 + i][i] += q * t * t / 2.0;
        ref->p[3 + i][3 + i] += q * t;
    }
}

static void ref_correct(ref_t *ref, const ocel_estimate_t *m) {
    double k[6][3] = {{0}};
    double a[6][6] = {{0}};
    for (int i = 0; i < 3; i++) {
        const double s = ref->p[i][i] + noise(m, i, i);
        k[i][i] = ref->p[i][i] / s;
        k[3 + i][i] = ref->p[3 + i][i] / s;
    }
    for (int i = 0; i < 3; i++) {
        const double error = m->p_root_u[i] - ref->x[i];
        ref->x[i] += k[i][i] * error;
        ref->x[3 + i] += k[3 + i][i] * error;
    }
    for (int i = 0; i < 6; i++) {
        a[i][i] = 1.0;
        for (int j = 0; j < 3; j++) {
            a[i][j] -= k[i][j];
        }
    }
    sandwich(ref->p, a);
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            ref->p[i][j] += k[i][i % 3] * noise(m, i % 3, j % 3) * k[j][j % 3];
        }
    }
}

static void check_against(const ref_t *ref, const ocel_track_t *track) {
    for (int i = 0; i < 3; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(0.6, ref->x[i], track->p_root_u[i]);
        TEST_ASSERT_DOUBLE_WITHIN(1.0 + 1e-5 * fabs(ref->x[3 + i]), ref->x[3 + i],
                                  track->v_root_u_s[i]);
        for (int j = 0; j < 3; j++) {
            const double scale = sqrt(ref->p[i][i] * ref->p[j][j]);
            TEST_ASSERT_DOUBLE_WITHIN(1.1 + 1e-6 * scale, ref->p[i][j],
                                      (double)track->cov_root_u2[ENTRY[i][j]]);
        }
    }
}

/* A slanting ellipsoid: thin across the line of sight, long along it. */
static ocel_estimate_t slanting(const double truth[3]) {
    ocel_estimate_t m;
    double d[3];
    const double length = sqrt(truth[0] * truth[0] + truth[1] * truth[1] + truth[2] * truth[2]);
    const double along = rng_gauss(&rng) * 3000.0;
    for (int i = 0; i < 3; i++) {
        d[i] = truth[i] / length;
        m.p_root_u[i] = (int32_t)lround(truth[i] + d[i] * along + rng_gauss(&rng) * 200.0);
    }
    for (int i = 0; i < 3; i++) {
        for (int j = i; j < 3; j++) {
            m.cov_root_u2[ENTRY[i][j]] = (int64_t)llround(
                d[i] * d[j] * (3000.0 * 3000.0 - 200.0 * 200.0) + ((i == j) ? 40000.0 : 0.0));
        }
    }
    return m;
}

static void agrees_with_double_precision(void) {
    for (int run = 0; run < TEST_TRIALS(50); run++) {
        ocel_tracker_config_t config = usual();
        double truth[3] = {500e3, 100e3, -200e3};
        double v[3];
        config.wander_u_s = (int32_t)rng_log_uniform(&rng, 1e4, 1e7);
        config.acceleration_root_u_s2[2] = rng_between(&rng, -9810000, 0);
        ocel_tracker_t tracker = tracker_of(&config);
        ref_t ref;
        ocel_track_t track;
        int64_t time = 1000;
        for (int i = 0; i < 3; i++) {
            v[i] = rng_uniform(&rng, -1e6, 1e6);
        }
        ocel_estimate_t m = slanting(truth);
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_tracker_update(&tracker, time, &m, &track));
        ref_start(&ref, &config, &m);
        check_against(&ref, &track);
        for (int frame = 0; frame < 60; frame++) {
            const int64_t dt = rng_between(&rng, 1000, 50000);
            const bool hidden = rng_below(&rng, 5U) == 0U;
            time += dt;
            for (int i = 0; i < 3; i++) {
                truth[i] += v[i] * (double)dt * 1e-6;
            }
            m = slanting(truth);
            const ocel_status_t status =
                ocel_tracker_update(&tracker, time, hidden ? NULL : &m, &track);
            ref_advance(&ref, &config, (double)dt * 1e-6);
            if (!hidden && (status == OCEL_OK)) {
                ref_correct(&ref, &m);
            }
            TEST_ASSERT_TRUE(hidden ? (status == OCEL_NOT_SEEN)
                                    : ((status == OCEL_OK) || (status == OCEL_PARTIAL)));
            if (status == OCEL_PARTIAL) {
                break; /* the restart has a test of its own */
            }
            check_against(&ref, &track);
        }
    }
}

/* Without noise a straight line is followed to the unit. */
static void follows_a_straight_line(void) {
    const ocel_tracker_config_t config = usual();
    ocel_tracker_t tracker = tracker_of(&config);
    ocel_track_t track;
    for (int frame = 0; frame < 30; frame++) {
        const ocel_estimate_t m = at(400000 + 3000 * frame, -2000 * frame, 100000, 100);
        TEST_ASSERT_EQUAL(OCEL_OK,
                          ocel_tracker_update(&tracker, (int64_t)frame * 20000, &m, &track));
        TEST_ASSERT_EQUAL(OCEL_TRACK_SEEN, track.state);
        TEST_ASSERT_EQUAL_INT64((int64_t)frame * 20000, track.seen_us);
    }
    TEST_ASSERT_INT32_WITHIN(2, 400000 + 3000 * 29, track.p_root_u[0]);
    TEST_ASSERT_INT32_WITHIN(300, 150000, track.v_root_u_s[0]);
    TEST_ASSERT_INT32_WITHIN(300, -100000, track.v_root_u_s[1]);
    TEST_ASSERT_INT32_WITHIN(1, 0, track.v_root_u_s[2]);
    /* A copy tells what it will be; the tracker stays. */
    const ocel_tracker_t before = tracker;
    ocel_tracker_t later = tracker;
    TEST_ASSERT_EQUAL(OCEL_NOT_SEEN,
                      ocel_tracker_update(&later, 29 * 20000 + 100000, NULL, &track));
    TEST_ASSERT_INT32_WITHIN(60, 400000 + 3000 * 34, track.p_root_u[0]);
    TEST_ASSERT_EQUAL_MEMORY(&before, &tracker, sizeof(tracker));
}

static void hidden_is_guessed_then_lost(void) {
    const ocel_tracker_config_t config = usual();
    ocel_tracker_t tracker = tracker_of(&config);
    ocel_track_t track;
    ocel_estimate_t m = at(400000, 0, 0, 100);
    int64_t time = 0;
    TEST_ASSERT_EQUAL(OCEL_NOT_SEEN, ocel_tracker_update(&tracker, -5, NULL, &track));
    TEST_ASSERT_EQUAL(OCEL_TRACK_LOST, track.state);
    TEST_ASSERT_EQUAL_INT64(INT64_MIN, track.seen_us);
    for (int frame = 0; frame < 10; frame++) {
        time = (int64_t)frame * 20000;
        m.p_root_u[1] = 4000 * frame;
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_tracker_update(&tracker, time, &m, &track));
    }
    int64_t last = track.cov_root_u2[OCEL_YY];
    for (int frame = 1; frame <= 25; frame++) {
        TEST_ASSERT_EQUAL(OCEL_NOT_SEEN,
                          ocel_tracker_update(&tracker, time + 20000 * frame, NULL, &track));
        TEST_ASSERT_EQUAL(OCEL_TRACK_GUESSED, track.state);
        TEST_ASSERT_EQUAL_INT64(time, track.seen_us);
        TEST_ASSERT_INT32_WITHIN(50 + 50 * frame, 36000 + 4000 * frame, track.p_root_u[1]);
        TEST_ASSERT_TRUE(track.cov_root_u2[OCEL_YY] > last);
        last = track.cov_root_u2[OCEL_YY];
    }
    TEST_ASSERT_EQUAL(OCEL_NOT_SEEN, ocel_tracker_update(&tracker, time + 500001, NULL, &track));
    const ocel_track_t lost = {OCEL_TRACK_LOST, {0}, {0}, {0}, time};
    TEST_ASSERT_EQUAL_INT(0, track.p_root_u[0]);
    TEST_ASSERT_EQUAL_MEMORY(&lost, &track, sizeof(lost));
    /* Seen again, anywhere: at once. */
    m.p_root_u[0] = -90000000;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_tracker_update(&tracker, time + 520000, &m, &track));
    TEST_ASSERT_EQUAL(OCEL_TRACK_SEEN, track.state);
    TEST_ASSERT_EQUAL_INT32(-90000000, track.p_root_u[0]);
    TEST_ASSERT_EQUAL_INT32(0, track.v_root_u_s[0]);
}

static ocel_tracker_t resting(const ocel_tracker_config_t *config, int64_t *time) {
    ocel_tracker_t tracker = tracker_of(config);
    ocel_track_t track;
    const ocel_estimate_t m = at(500000, 0, 0, 100);
    *time = 0;
    for (int frame = 0; frame < 20; frame++) {
        *time += FRAME_US;
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_tracker_update(&tracker, *time, &m, &track));
    }
    return tracker;
}

static void an_outlier_is_refused(void) {
    const ocel_tracker_config_t config = usual();
    int64_t time;
    ocel_tracker_t tracker = resting(&config, &time);
    ocel_track_t track;
    ocel_estimate_t m = at(500000, 300000, 0, 100);
    time += FRAME_US;
    TEST_ASSERT_EQUAL(OCEL_PARTIAL, ocel_tracker_update(&tracker, time, &m, &track));
    TEST_ASSERT_EQUAL(OCEL_TRACK_GUESSED, track.state);
    TEST_ASSERT_EQUAL_INT64(time - FRAME_US, track.seen_us);
    TEST_ASSERT_INT32_WITHIN(100, 0, track.p_root_u[1]);
    /* Another elsewhere does not agree with it, the ball itself is taken. */
    time += FRAME_US;
    m.p_root_u[1] = -400000;
    TEST_ASSERT_EQUAL(OCEL_PARTIAL, ocel_tracker_update(&tracker, time, &m, &track));
    time += FRAME_US;
    m.p_root_u[1] = 0;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_tracker_update(&tracker, time, &m, &track));
    /* Two that agree, but not in consecutive frames. */
    m.p_root_u[1] = 300000;
    time += FRAME_US;
    TEST_ASSERT_EQUAL(OCEL_PARTIAL, ocel_tracker_update(&tracker, time, &m, &track));
    time += FRAME_US;
    TEST_ASSERT_EQUAL(OCEL_NOT_SEEN, ocel_tracker_update(&tracker, time, NULL, &track));
    time += 1000;
    TEST_ASSERT_EQUAL(OCEL_PARTIAL, ocel_tracker_update(&tracker, time, &m, &track));
}

/* Two refused measurements that agree are the ball; at its new speed. */
static void two_that_agree_restart(void) {
    const ocel_tracker_config_t config = usual();
    int64_t time;
    ocel_tracker_t tracker = resting(&config, &time);
    ocel_track_t track;
    ocel_estimate_t m = at(500000, 300000, 0, 100);
    time += FRAME_US;
    TEST_ASSERT_EQUAL(OCEL_PARTIAL, ocel_tracker_update(&tracker, time, &m, &track));
    time += FRAME_US;
    m.p_root_u[1] += 100000;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_tracker_update(&tracker, time, &m, &track));
    TEST_ASSERT_EQUAL(OCEL_TRACK_SEEN, track.state);
    TEST_ASSERT_INT32_WITHIN(20, 400000, track.p_root_u[1]);
    TEST_ASSERT_INT32_WITHIN(6000, 3000000, track.v_root_u_s[1]);
    time += FRAME_US;
    TEST_ASSERT_EQUAL(OCEL_NOT_SEEN, ocel_tracker_update(&tracker, time, NULL, &track));
    TEST_ASSERT_INT32_WITHIN(300, 500000, track.p_root_u[1]);
}

/* The gate of a new track is what is in reach at the highest speed. */
static void gate_of_a_new_track_is_the_reach(void) {
    ocel_tracker_config_t config = usual();
    config.wander_u_s = 0;
    config.gate_floor_u = 0;
    for (int way = -1; way <= 1; way += 2) {
        ocel_tracker_t tracker = tracker_of(&config);
        ocel_track_t track;
        ocel_estimate_t m = at(0, 0, 0, 0);
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_tracker_update(&tracker, 0, &m, &track));
        m.p_root_u[2] = way * 1001000;
        TEST_ASSERT_EQUAL(OCEL_PARTIAL, ocel_tracker_update(&tracker, 100000, &m, &track));
        tracker = tracker_of(&config);
        m.p_root_u[2] = 0;
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_tracker_update(&tracker, 0, &m, &track));
        m.p_root_u[2] = way * 999000;
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_tracker_update(&tracker, 100000, &m, &track));
        TEST_ASSERT_INT32_WITHIN(1000, way * 9990000, track.v_root_u_s[2]);
    }
}

/* The floor of the gate lets through what the sigmas alone would not. */
static void the_gate_has_a_floor(void) {
    ocel_tracker_config_t config = usual();
    config.wander_u_s = 0;
    ocel_track_t track;
    for (int32_t k = 0; k < 2; k++) {
        config.gate_floor_u = k * 20000;
        int64_t time;
        ocel_tracker_t tracker = resting(&config, &time);
        const ocel_estimate_t m = at(500000, 15000, 0, 100);
        TEST_ASSERT_EQUAL((k == 0) ? OCEL_PARTIAL : OCEL_OK,
                          ocel_tracker_update(&tracker, time + FRAME_US, &m, &track));
    }
}

static void velocity_is_clamped(void) {
    ocel_tracker_config_t config = usual();
    config.gate_floor_u = 67108864;
    config.max_speed_u_s = 1000000;
    config.wander_u_s = 1000000;
    ocel_tracker_t tracker = tracker_of(&config);
    ocel_track_t track;
    for (int frame = 0; frame < 5; frame++) {
        const ocel_estimate_t m = at(frame * 10000000, -frame * 10000000, 0, 100);
        TEST_ASSERT_EQUAL(OCEL_OK,
                          ocel_tracker_update(&tracker, (int64_t)frame * 100000, &m, &track));
    }
    TEST_ASSERT_EQUAL_INT32(1000000, track.v_root_u_s[0]);
    TEST_ASSERT_EQUAL_INT32(-1000000, track.v_root_u_s[1]);
}

/* A known gravity makes a parabola of the guess. */
static void known_acceleration_bends_the_guess(void) {
    ocel_tracker_config_t config = usual();
    config.acceleration_root_u_s2[2] = -9810000;
    ocel_tracker_t tracker = tracker_of(&config);
    ocel_track_t track;
    int64_t time = 0;
    double z = 0.0;
    for (int frame = 0; frame < 45; frame++) {
        const double t = frame / 60.0;
        z = 2e6 * t - 9.81e6 * t * t / 2.0;
        const ocel_estimate_t m = at(700000, 0, (int32_t)lround(z), 200);
        time = llround(t * 1e6);
        (void)ocel_tracker_update(&tracker, time, (frame < 27) ? &m : NULL, &track);
    }
    TEST_ASSERT_EQUAL(OCEL_TRACK_GUESSED, track.state);
    TEST_ASSERT_DOUBLE_WITHIN(3000.0, z, track.p_root_u[2]);
}

/* The covariance of a guess hardly depends on the frames in between. */
static void frames_without_the_ball_add_nothing(void) {
    ocel_tracker_config_t config = usual();
    config.acceleration_root_u_s2[0] = 1000000;
    int64_t time;
    ocel_tracker_t once = resting(&config, &time);
    ocel_tracker_t often = once;
    ocel_track_t one;
    ocel_track_t many;
    (void)ocel_tracker_update(&once, time + 300000, NULL, &one);
    for (int k = 1; k <= 300; k++) {
        (void)ocel_tracker_update(&often, time + 1000 * k, NULL, &many);
    }
    for (int i = 0; i < 3; i++) {
        TEST_ASSERT_INT32_WITHIN(2, one.p_root_u[i], many.p_root_u[i]);
        TEST_ASSERT_INT32_WITHIN(2, one.v_root_u_s[i], many.v_root_u_s[i]);
        /* q t^3 / 3 becomes q t^3 / 2 in a single step. */
        TEST_ASSERT_TRUE(many.cov_root_u2[ENTRY[i][i]] <= one.cov_root_u2[ENTRY[i][i]]);
        TEST_ASSERT_TRUE(2 * one.cov_root_u2[ENTRY[i][i]] <= 3 * many.cov_root_u2[ENTRY[i][i]] + 3);
    }
}

/* ---- The clock ---- */

static void time_goes_forward_only(void) {
    const ocel_tracker_config_t config = usual();
    int64_t time;
    ocel_tracker_t tracker = resting(&config, &time);
    ocel_track_t track;
    ocel_track_t zero;
    const ocel_estimate_t m = at(500000, 0, 0, 100);
    memset(&zero, 0, sizeof(zero));
    const ocel_tracker_t before = tracker;
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_tracker_update(&tracker, time - 1, &m, &track));
    TEST_ASSERT_EQUAL_MEMORY(&zero, &track, sizeof(zero));
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_tracker_update(&tracker, INT64_MIN, NULL, &track));
    TEST_ASSERT_EQUAL_MEMORY(&before, &tracker, sizeof(tracker));
    /* Twice in one moment: a second opinion, which the covariance shows. */
    const int64_t variance = before.filter.cov_q6[OCEL_XX][0];
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_tracker_update(&tracker, time, &m, &track));
    TEST_ASSERT_TRUE(track.cov_root_u2[OCEL_XX] * 64 < variance);
    TEST_ASSERT_INT32_WITHIN(1, 500000, track.p_root_u[0]);
    TEST_ASSERT_INT32_WITHIN(10, 0, track.v_root_u_s[0]);
    TEST_ASSERT_EQUAL(OCEL_NOT_SEEN, ocel_tracker_update(&tracker, time, NULL, &track));
    TEST_ASSERT_EQUAL(OCEL_TRACK_GUESSED, track.state);
}

static void a_gap_of_hours_ends_the_track(void) {
    static const int64_t GAPS[] = {500001, 3600000000LL, 86400000000LL * 365, INT64_MAX / 2};
    const ocel_tracker_config_t config = usual();
    ocel_track_t track;
    for (size_t k = 0; k < sizeof(GAPS) / sizeof(GAPS[0]); k++) {
        int64_t time;
        ocel_tracker_t tracker = resting(&config, &time);
        ocel_tracker_t other = tracker;
        const ocel_estimate_t m = at(-500000, 1, 2, 100);
        TEST_ASSERT_EQUAL(OCEL_NOT_SEEN,
                          ocel_tracker_update(&tracker, time + GAPS[k], NULL, &track));
        TEST_ASSERT_EQUAL(OCEL_TRACK_LOST, track.state);
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_tracker_update(&other, time + GAPS[k], &m, &track));
        TEST_ASSERT_EQUAL_INT32(-500000, track.p_root_u[0]);
        TEST_ASSERT_EQUAL_INT32(0, track.v_root_u_s[0]);
    }
    ocel_tracker_t tracker = tracker_of(&config);
    const ocel_estimate_t m = at(1, 2, 3, 1);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_tracker_update(&tracker, INT64_MIN, &m, &track));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_tracker_update(&tracker, INT64_MAX, &m, &track));
    TEST_ASSERT_EQUAL_INT64(INT64_MAX, track.seen_us);
}

/* A jump just within the coasting time keeps the track. */
static void the_coasting_time_counts_from_the_last_measurement(void) {
    const ocel_tracker_config_t config = usual();
    int64_t time;
    ocel_tracker_t tracker = resting(&config, &time);
    ocel_track_t track;
    const ocel_estimate_t away = at(5000000, 0, 0, 100);
    TEST_ASSERT_EQUAL(OCEL_NOT_SEEN, ocel_tracker_update(&tracker, time + 500000, NULL, &track));
    TEST_ASSERT_EQUAL(OCEL_TRACK_GUESSED, track.state);
    TEST_ASSERT_EQUAL(OCEL_PARTIAL, ocel_tracker_update(&tracker, time + 500000, &away, &track));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_tracker_update(&tracker, time + 500001, &away, &track));
    TEST_ASSERT_EQUAL_INT32(5000000, track.p_root_u[0]);
}

/* ---- Hostile ---- */

static void bad_configurations_are_refused(void) {
    ocel_tracker_t tracker;
    ocel_track_t track;
    for (int k = 0; k < 15; k++) {
        ocel_tracker_config_t c = usual();
        switch (k) {
        case 0:
            c.coast_us = 0U;
            break;
        case 1:
            c.coast_us = 4000001U;
            break;
        case 2:
            c.max_speed_u_s = 0;
            c.wander_u_s = 0;
            break;
        case 3:
            c.max_speed_u_s = -5;
            break;
        case 4:
            c.max_speed_u_s = 67108865;
            break;
        case 5:
            c.wander_u_s = -1;
            break;
        case 6:
            c.wander_u_s = c.max_speed_u_s + 1;
            break;
        case 7:
            c.gate_q16 = 65535U;
            break;
        case 8:
            c.gate_q16 = 16U * 65536U + 1U;
            break;
        case 9:
            c.gate_floor_u = -1;
            break;
        case 10:
            c.gate_floor_u = 67108865;
            break;
        case 11:
            c.acceleration_root_u_s2[0] = 134217729;
            break;
        case 12:
            c.acceleration_root_u_s2[2] = INT32_MIN;
            break;
        case 13:
            c.coast_us = 4000000U;
            c.max_speed_u_s = 16777217;
            break;
        default:
            c.coast_us = 4294967295U;
            break;
        }
        TEST_ASSERT_EQUAL(OCEL_OUT_OF_RANGE, ocel_tracker_init(&tracker, &c));
        TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_tracker_update(&tracker, 0, NULL, &track));
    }
    const ocel_tracker_config_t most = {4000000U, 16777216, 16777216,
                                        1048576U, 67108864, {134217728, -134217728, 0}};
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_tracker_init(&tracker, &most));
    const ocel_tracker_config_t fast = {1000000U, 67108864, 0, 65536U, 0, {0, 0, 0}};
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_tracker_init(&tracker, &fast));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_tracker_init(NULL, &most));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_tracker_init(&tracker, NULL));
    memset(&tracker, 0, sizeof(tracker));
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_tracker_update(&tracker, 0, NULL, &track));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_tracker_update(NULL, 0, NULL, &track));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_tracker_update(&tracker, 0, NULL, NULL));
}

static void bad_measurements_are_refused(void) {
    const ocel_tracker_config_t config = usual();
    int64_t time;
    ocel_tracker_t tracker = resting(&config, &time);
    const ocel_tracker_t before = tracker;
    ocel_track_t track;
    ocel_track_t zero;
    memset(&zero, 0, sizeof(zero));
    for (int k = 0; k < 8; k++) {
        ocel_estimate_t m = at(500000, 0, 0, 100);
        switch (k) {
        case 0:
            m.p_root_u[0] = 1073741825;
            break;
        case 1:
            m.p_root_u[2] = INT32_MIN;
            break;
        case 2:
            m.cov_root_u2[OCEL_XX] = -1;
            break;
        case 7:
            m.cov_root_u2[OCEL_YY] = -1;
            break;
        case 3:
            m.cov_root_u2[OCEL_ZZ] = INT64_MIN;
            break;
        case 4:
            m.cov_root_u2[OCEL_YY] = ((int64_t)1 << 52) + 1;
            break;
        case 5:
            m.cov_root_u2[OCEL_XY] = INT64_MIN;
            break;
        default:
            m.cov_root_u2[OCEL_YZ] = INT64_MAX;
            break;
        }
        TEST_ASSERT_EQUAL(OCEL_OUT_OF_RANGE, ocel_tracker_update(&tracker, time + 1, &m, &track));
        TEST_ASSERT_EQUAL_MEMORY(&zero, &track, sizeof(zero));
        TEST_ASSERT_EQUAL_MEMORY(&before, &tracker, sizeof(tracker));
    }
}

static int32_t any32(int32_t most) {
    const double v = rng_log_uniform(&rng, 0.5, (double)most + 0.4);
    return ((rng_u32(&rng) & 1U) != 0U) ? -(int32_t)v : (int32_t)v;
}

static int64_t any_cov(void) {
    return (int64_t)rng_log_uniform(&rng, 0.5, 4503599627370496.0);
}

/* Whatever comes in, what comes out is within its ranges and OK means a measurement. */
static void anything_leaves_the_state_sane(void) {
    for (int run = 0; run < TEST_TRIALS(400); run++) {
        ocel_tracker_config_t config = {
            (uint32_t)rng_log_uniform(&rng, 1.0, 4e6), 1, 0, 65536U, 0, {0}};
        config.max_speed_u_s = (int32_t)rng_log_uniform(&rng, 1.0, 16777216.0);
        config.wander_u_s = (int32_t)rng_below(&rng, (uint32_t)config.max_speed_u_s + 1U);
        config.gate_q16 = 65536U + rng_below(&rng, 15U * 65536U);
        config.gate_floor_u = rng_between(&rng, 0, 67108864);
        for (int i = 0; i < 3; i++) {
            config.acceleration_root_u_s2[i] = any32(134217728);
        }
        ocel_tracker_t tracker = tracker_of(&config);
        int64_t time = (int64_t)rng_u64(&rng);
        for (int frame = 0; frame < 60; frame++) {
            ocel_track_t track;
            ocel_estimate_t m;
            const bool seen = rng_below(&rng, 4U) != 0U;
            const int64_t step = (int64_t)rng_log_uniform(&rng, 0.5, 1e6);
            for (int i = 0; i < 3; i++) {
                m.p_root_u[i] = any32(1073741824);
            }
            for (int i = 0; i < 6; i++) {
                m.cov_root_u2[i] = any_cov();
            }
            if ((rng_u32(&rng) & 1U) != 0U) {
                m.cov_root_u2[OCEL_XY] = -any_cov(); /* no covariance at all, mostly */
            }
            time = (time < INT64_MAX - step) ? (time + step) : INT64_MAX;
            const ocel_status_t status =
                ocel_tracker_update(&tracker, time, seen ? &m : NULL, &track);
            TEST_ASSERT_TRUE(seen ? ((status == OCEL_OK) || (status == OCEL_PARTIAL))
                                  : (status == OCEL_NOT_SEEN));
            TEST_ASSERT_EQUAL(status == OCEL_OK, track.state == OCEL_TRACK_SEEN);
            for (int i = 0; i < 3; i++) {
                TEST_ASSERT_TRUE(abs(track.p_root_u[i]) <= 1073741824);
                TEST_ASSERT_TRUE(abs(track.v_root_u_s[i]) <= config.max_speed_u_s);
                TEST_ASSERT_TRUE(track.cov_root_u2[ENTRY[i][i]] >= 0);
            }
        }
    }
}

/* At the ends of all ranges: neither place nor variance grows beyond what it may be. */
static void the_state_has_limits(void) {
    const ocel_tracker_config_t config = {4000000U, 16777216, 16777216,
                                          1048576U, 67108864, {134217728, 0, -134217728}};
    ocel_tracker_t tracker = tracker_of(&config);
    ocel_track_t track;
    const int64_t most = (int64_t)1 << 52;
    const ocel_estimate_t wide = {{1073741824, 0, -1073741824}, {most, 0, 0, most, 0, most}};
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_tracker_update(&tracker, 0, &wide, &track));
    for (int frame = 1; frame <= 4; frame++) {
        TEST_ASSERT_EQUAL(OCEL_NOT_SEEN,
                          ocel_tracker_update(&tracker, frame * 1000000LL, NULL, &track));
        TEST_ASSERT_EQUAL(OCEL_TRACK_GUESSED, track.state);
        for (int i = 0; i < 3; i++) {
            TEST_ASSERT_EQUAL_INT64(most, track.cov_root_u2[ENTRY[i][i]]);
            TEST_ASSERT_TRUE(tracker.filter.cov_q6[ENTRY[i][i]][3] <= 16777216LL * 16777216LL * 64);
        }
        TEST_ASSERT_EQUAL_INT32(1073741824, track.p_root_u[0]);
        TEST_ASSERT_EQUAL_INT32(-1073741824, track.p_root_u[2]);
        TEST_ASSERT_EQUAL_INT32(16777216, track.v_root_u_s[0]);
    }
}

/* ---- The region of interest ---- */

static ocel_camera_t camera_of(uint16_t width, uint16_t height) {
    ocel_intrinsics_t k = {277 * 65536, 277 * 65536, 160 * 65536, 120 * 65536, 0, 0, 0, 0, 0, 0, 0};
    ocel_camera_t camera;
    k.width = width;
    k.height = height;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_camera_init(&camera, &k));
    return camera;
}

/* Looks along the root's z, turned by an angle about y, from a place. */
static ocel_pose_t pose_of(double angle, int32_t x, int32_t y, int32_t z) {
    const int32_t c = (int32_t)lround(cos(angle) * 1073741824.0);
    const int32_t s = (int32_t)lround(sin(angle) * 1073741824.0);
    const ocel_pose_t pose = {{{c, 0, s}, {0, 1073741824, 0}, {-s, 0, c}}, {x, y, z}};
    return pose;
}

static ocel_track_t track_at(int32_t x, int32_t y, int32_t z, int32_t sigma) {
    const int64_t v = (int64_t)sigma * sigma;
    const ocel_track_t track = {OCEL_TRACK_GUESSED, {x, y, z}, {0, 0, 0}, {v, 0, 0, v, 0, v}, 0};
    return track;
}

/* Every point of every ball within 4 sigma is inside, and not by too much. */
static void the_region_holds_the_ball(void) {
    const ocel_camera_t camera = camera_of(320, 240);
    int compared = 0;
    for (int run = 0; run < TEST_TRIALS_AT_LEAST(40, 3000); run++) {
        const double angle = rng_uniform(&rng, -3.1, 3.1);
        const ocel_pose_t pose = pose_of(angle, any32(1000000), any32(1000000), any32(1000000));
        const double p[3] = {rng_uniform(&rng, -3e5, 3e5), rng_uniform(&rng, -2e5, 2e5),
                             rng_uniform(&rng, 2e5, 8e5)};
        const int32_t sigma = (int32_t)rng_log_uniform(&rng, 1.0, 12000.0);
        ocel_rect_t roi;
        ocel_track_t track =
            track_at((int32_t)lround(cos(angle) * p[0] + sin(angle) * p[2]) + pose.p_u[0],
                     (int32_t)lround(p[1]) + pose.p_u[1],
                     (int32_t)lround(-sin(angle) * p[0] + cos(angle) * p[2]) + pose.p_u[2], sigma);
        const ocel_status_t status = ocel_tracker_roi(&track, &pose, &camera, 35000, &roi);
        double low[2] = {1e9, 1e9};
        double high[2] = {-1e9, -1e9};
        for (int k = 0; k < 2000; k++) {
            double d[3];
            double length = 0.0;
            for (int i = 0; i < 3; i++) {
                d[i] = rng_gauss(&rng);
                length += d[i] * d[i];
            }
            for (int i = 0; i < 3; i++) {
                d[i] = p[i] + d[i] / sqrt(length) * (35000.0 + 4.0 * sigma);
            }
            const double at_px[2] = {277.0 * d[0] / d[2] + 160.0, 277.0 * d[1] / d[2] + 120.0};
            for (int i = 0; i < 2; i++) {
                low[i] = fmin(low[i], at_px[i]);
                high[i] = fmax(high[i], at_px[i]);
            }
        }
        const double left = fmax(0.0, floor(low[0] + 0.5));
        const double top = fmax(0.0, floor(low[1] + 0.5));
        const double right = fmin(319.0, floor(high[0] + 0.5));
        const double bottom = fmin(239.0, floor(high[1] + 0.5));
        if ((left > right) || (top > bottom)) {
            continue; /* outside, or by a hair */
        }
        compared++;
        TEST_ASSERT_EQUAL(OCEL_OK, status);
        TEST_ASSERT_TRUE((roi.left <= left) && (roi.top <= top));
        TEST_ASSERT_TRUE((roi.left + roi.width - 1 >= right) &&
                         (roi.top + roi.height - 1 >= bottom));
        TEST_ASSERT_TRUE((roi.left + roi.width <= 320) && (roi.top + roi.height <= 240));
        /* 4 sqrt(3) sigma about, and the cube's near face instead of the ball. */
        const double size = 35000.0 + 4.0 * 1.7321 * sigma;
        const double zoom = 277.0 / (p[2] - size);
        const double slack = zoom * size * (1.0 + fabs(p[0]) / p[2]) * 2.0 + 3.0;
        TEST_ASSERT_TRUE(roi.width <= slack);
        TEST_ASSERT_TRUE(roi.height <= zoom * size * (1.0 + fabs(p[1]) / p[2]) * 2.0 + 3.0);
    }
    TEST_ASSERT_TRUE(compared >= TEST_TRIALS(1000));
}

static void what_is_not_in_view_has_no_region(void) {
    const ocel_camera_t camera = camera_of(320, 240);
    const ocel_camera_t unsized = camera_of(0, 0);
    const ocel_pose_t pose = pose_of(0.0, 0, 0, 0);
    ocel_camera_t unready;
    ocel_track_t track = track_at(0, 0, 500000, 100);
    ocel_rect_t roi;
    const ocel_rect_t none = {0, 0, 0, 0};
    memset(&unready, 0, sizeof(unready));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_tracker_roi(&track, &pose, &camera, 35000, &roi));
    TEST_ASSERT_EQUAL(OCEL_BAD_SIZE, ocel_tracker_roi(&track, &pose, &unsized, 35000, &roi));
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_tracker_roi(&track, &pose, &unready, 35000, &roi));
    TEST_ASSERT_EQUAL(OCEL_OUT_OF_RANGE, ocel_tracker_roi(&track, &pose, &camera, 0, &roi));
    TEST_ASSERT_EQUAL(OCEL_OUT_OF_RANGE, ocel_tracker_roi(&track, &pose, &camera, INT32_MIN, &roi));
    TEST_ASSERT_EQUAL(OCEL_OUT_OF_RANGE, ocel_tracker_roi(&track, &pose, &camera, INT32_MAX, &roi));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_tracker_roi(NULL, &pose, &camera, 35000, &roi));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_tracker_roi(&track, NULL, &camera, 35000, &roi));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_tracker_roi(&track, &pose, NULL, 35000, &roi));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_tracker_roi(&track, &pose, &camera, 35000, NULL));
    static const int32_t OUTSIDE[][3] = {{0, 0, -500000},
                                         {900000, 0, 500000},
                                         {0, -900000, 500000},
                                         {-900000, 0, 500000},
                                         {0, 900000, 500000},
                                         {900000, 0, 0},
                                         {1073741824, 1073741824, -1073741824}};
    for (size_t k = 0; k < sizeof(OUTSIDE) / sizeof(OUTSIDE[0]); k++) {
        track = track_at(OUTSIDE[k][0], OUTSIDE[k][1], OUTSIDE[k][2], 100);
        roi.width = 7U;
        TEST_ASSERT_EQUAL(OCEL_NOT_SEEN, ocel_tracker_roi(&track, &pose, &camera, 35000, &roi));
        TEST_ASSERT_EQUAL_MEMORY(&none, &roi, sizeof(roi));
    }
    track = track_at(0, 0, 500000, 100);
    track.state = OCEL_TRACK_LOST;
    TEST_ASSERT_EQUAL(OCEL_NOT_SEEN, ocel_tracker_roi(&track, &pose, &camera, 35000, &roi));
    /* So uncertain that it may be beside the camera: everywhere. */
    track = track_at(0, 0, 500000, 200000);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_tracker_roi(&track, &pose, &camera, 35000, &roi));
    const ocel_rect_t all = {0, 0, 320, 240};
    TEST_ASSERT_EQUAL_MEMORY(&all, &roi, sizeof(roi));
    /* The extremes of all ranges: no more than that it comes back. */
    const ocel_pose_t far = pose_of(0.7, INT32_MIN, INT32_MAX, INT32_MIN);
    track = track_at(1073741824, -1073741824, 1073741824, 67108864);
    (void)ocel_tracker_roi(&track, &far, &camera, 1073741824, &roi);
}

int main(void) {
    printf("seed %d\n", SEED);
    UNITY_BEGIN();
    RUN_TEST(products_saturate);
    RUN_TEST(agrees_with_double_precision);
    RUN_TEST(follows_a_straight_line);
    RUN_TEST(hidden_is_guessed_then_lost);
    RUN_TEST(an_outlier_is_refused);
    RUN_TEST(two_that_agree_restart);
    RUN_TEST(gate_of_a_new_track_is_the_reach);
    RUN_TEST(the_gate_has_a_floor);
    RUN_TEST(velocity_is_clamped);
    RUN_TEST(known_acceleration_bends_the_guess);
    RUN_TEST(frames_without_the_ball_add_nothing);
    RUN_TEST(time_goes_forward_only);
    RUN_TEST(a_gap_of_hours_ends_the_track);
    RUN_TEST(the_coasting_time_counts_from_the_last_measurement);
    RUN_TEST(bad_configurations_are_refused);
    RUN_TEST(bad_measurements_are_refused);
    RUN_TEST(anything_leaves_the_state_sane);
    RUN_TEST(the_state_has_limits);
    RUN_TEST(the_region_holds_the_ball);
    RUN_TEST(what_is_not_in_view_has_no_region);
    return UNITY_END();
}
