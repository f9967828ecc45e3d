// SPDX-License-Identifier: MIT
//
// What a run of the closed loop leaves: frames.csv and summary.json (track.hpp tells
// what stands in them).
#ifndef OCELLUS_SIM_TRACK_RESULTS_HPP
#define OCELLUS_SIM_TRACK_RESULTS_HPP

#include "track/track.hpp"

namespace sim {

const char *state_name(ocel_track_state_t state);

// kHoldPx in pictures of the scenario's width.
double hold_px(const TrackScenario &scenario);

std::string track_csv(const std::vector<TrackFrame> &frames);

nlohmann::ordered_json track_summary(const TrackScenario &scenario, std::uint64_t seed,
                                     const std::vector<TrackFrame> &frames);

} // namespace sim

#endif
