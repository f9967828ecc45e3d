// SPDX-License-Identifier: MIT
#include "trials/checks.hpp"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace sim {

const char *count_name(int kind) {
    constexpr const char *kNames[kCountKinds] = {"runs",   "labels", "unions",    "components",
                                                 "cracks", "points", "hypotheses"};
    return kNames[kind];
}

Counts count_bounds(const Intrinsics &camera) {
    const auto row_runs = static_cast<std::uint32_t>((camera.width + 1) / 2); // OCEL_MAX_RUNS
    Counts bounds{};
    bounds[kRuns] = row_runs * static_cast<std::uint32_t>(camera.height);
    bounds[kLabels] = row_runs; // OCEL_MAX_LABELS
    bounds[kUnions] = bounds[kRuns];
    bounds[kComponents] = bounds[kRuns];
    bounds[kCracks] = OCEL_MAX_CRACKS;
    bounds[kPoints] = std::min(OCEL_MAX_FIT_POINTS, OCEL_MAX_CRACKS);
    bounds[kHypotheses] = OCEL_CONE_HYPOTHESES;
    return bounds;
}

FrameSight sight_of(const ocel_detection_t &detection, const ocel_cone_t &cone,
                    ocel_status_t status_cone, double target_area) {
    const ocel_label_stats_t &stats = detection.stats;
    FrameSight sight{{}, detection.status, status_cone, target_area};
    sight.counts[kRuns] = stats.runs;
    sight.counts[kLabels] = stats.labels_max;
    sight.counts[kUnions] = stats.unions;
    sight.counts[kComponents] = stats.components;
    sight.counts[kCracks] = stats.cracks_max;
    sight.counts[kPoints] = detection.boundary_count;
    sight.counts[kHypotheses] = cone.hypothesis_count;
    return sight;
}

FrameSight sight_of(const Detector &detector, double target_area) {
    ocel_cone_t cone{};
    const ocel_status_t status =
        ocel_eye_cone(&detector.eye(), &detector.camera(), &detector.detection(), &cone);
    return sight_of(detector.detection(), cone, status, target_area);
}

void CheckTally::add(const CheckTally &other) {
    for (int kind = 0; kind < kCountKinds; ++kind) {
        const auto i = static_cast<std::size_t>(kind);
        largest[i] = std::max(largest[i], other.largest[i]);
    }
    frames += other.frames;
    violations += other.violations;
}

nlohmann::ordered_json checks_json(const CheckTally &tally, const Counts &bounds) {
    nlohmann::ordered_json counts;
    for (int kind = 0; kind < kCountKinds; ++kind) {
        const auto i = static_cast<std::size_t>(kind);
        counts[count_name(kind)] = {{"largest", tally.largest[i]}, {"bound", bounds[i]}};
    }
    return {{"frames", tally.frames}, {"violations", tally.violations}, {"counts", counts}};
}

void fail_on_violations(std::uint32_t violations) {
    if (violations > 0) {
        throw std::runtime_error(fmt::format("{} of the library's bounds or statuses did not hold; "
                                             "the lines above say where",
                                             violations));
    }
}

void tell_violation(const std::string &message) {
    std::fprintf(stderr, "ocellus-sim: error: %s\n", message.c_str());
}

FrameChecks::FrameChecks(const Counts &bounds, std::function<void(const std::string &)> tell)
    : bounds_(bounds), tell_(std::move(tell)) {
}

void FrameChecks::violation(const std::string &where, const std::string &what) {
    ++tally_.violations;
    tell_(where + ": " + what);
}

void FrameChecks::check(const std::string &where, const FrameSight &sight) {
    for (int kind = 0; kind < kCountKinds; ++kind) {
        const auto i = static_cast<std::size_t>(kind);
        if (sight.counts[i] > bounds_[i]) {
            violation(where, fmt::format("{} {}, over the library's bound of {}", sight.counts[i],
                                         count_name(kind), bounds_[i]));
        }
    }
    if (sight.counts[kUnions] > sight.counts[kRuns]) { // labeller.h: each ends a first run's label
        violation(where, fmt::format("{} unions, more than the {} runs", sight.counts[kUnions],
                                     sight.counts[kRuns]));
    }
    if (sight.target_area == 0.0 && (sight.status == OCEL_OK || sight.status_cone == OCEL_OK)) {
        violation(where, "status ok, but the target is not in view");
    }
    tally_.add({sight.counts, 1, 0});
}

} // namespace sim
