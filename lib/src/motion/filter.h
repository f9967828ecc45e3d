/* SPDX-License-Identifier: MIT
 *
 * The filter behind the tracker: position and velocity along three axes.
 *
 * Each axis has two gains of its own, Kalman's for the variances of that axis.
 * The covariance is Joseph's form, which holds for any gains, over all three
 * axes: so the long, slanting ellipsoid of what an eye measures is kept, without
 * the 3x3 inverse that gains across the axes would want.
 *
 * Overflow, for any input whatever: every product is ocel_times and every sum
 * ocel_add_product, within +-2^60.  Figures within the ranges of track.h never meet
 * that limit: a position's deviation is below 2^26 u as max_speed_u_s * coast_us is, so
 * its variance in Q6 is below 2^58.
 */
#ifndef OCEL_FILTER_H
#define OCEL_FILTER_H

#include <stdbool.h>
#include <stdint.h>

#include <ocellus/track.h>

/* A measurement within the ranges of tracker.h, made ready. */
void ocel_filter_fix(ocel_fix_t *fix, const ocel_estimate_t *measurement);

/* A filter at the measurement, at rest; the gate then holds what is in reach at
 * max_speed_u_s. */
void ocel_filter_start(ocel_filter_t *filter, const ocel_tracker_config_t *config,
                       const ocel_fix_t *fix);

/* Predicts; dt_us <= 4000000. */
void ocel_filter_advance(ocel_filter_t *filter, const ocel_tracker_config_t *config,
                         uint32_t dt_us);

/* Whether a measurement lies within the gate, along every axis. */
bool ocel_filter_admits(const ocel_filter_t *filter, const ocel_tracker_config_t *config,
                        const ocel_fix_t *fix);

/* Takes a measurement. */
void ocel_filter_correct(ocel_filter_t *filter, const ocel_tracker_config_t *config,
                         const ocel_fix_t *fix);

#endif
