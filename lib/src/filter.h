/* SPDX-License-Identifier: MIT
 *
 * The filter behind the tracker: position and velocity along three axes.
 *
 * Each axis has two gains of its own, Kalman's for the variances of that axis.
 * The covariance is Joseph's form, which holds for any gains, over all three
 * axes: so the long, slanting ellipsoid of what an eye measures is kept, without
 * the 3x3 inverse that gains across the axes would want.
 *
 * Overflow, for any input whatever: every product is ocel_times, within +-2^60,
 * and every sum of two terms is clamped to that again.  Figures within the ranges
 * of track.h never meet the clamp: a position's deviation is below 2^26 u as
 * max_speed_u_s * coast_us is, so its variance in Q6 is below 2^58.
 */
#ifndef OCEL_FILTER_H
#define OCEL_FILTER_H

#include <stdbool.h>
#include <stdint.h>

#include <ocellus/track.h>

/* A filter at the measurement, at rest; the gate then holds what is in reach at
 * max_speed_u_s. */
void ocel_filter_start(ocel_filter_t *filter, const ocel_tracker_config_t *config,
                       const ocel_estimate_t *measurement);

/* Predicts; dt_us <= OCEL_SECONDS_MAX_US. */
void ocel_filter_advance(ocel_filter_t *filter, const ocel_tracker_config_t *config,
                         uint32_t dt_us);

/* Whether a measurement lies within the gate, along every axis. */
bool ocel_filter_admits(const ocel_filter_t *filter, const ocel_tracker_config_t *config,
                        const ocel_estimate_t *measurement);

/* Takes a measurement. */
void ocel_filter_correct(ocel_filter_t *filter, const ocel_tracker_config_t *config,
                         const ocel_estimate_t *measurement);

#endif
