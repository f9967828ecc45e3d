// SPDX-License-Identifier: MIT
//
// Checks on the way, of every frame: the library's operation counts against the
// bounds that its headers state, and its status against the truth.
#ifndef OCELLUS_SIM_CHECKS_HPP
#define OCELLUS_SIM_CHECKS_HPP

#include <array>
#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "methods/detector.hpp"

namespace sim {

// What is counted in a frame.
enum Count {
    kRuns = 0,   // of pixels, in all rows
    kLabels,     // in use at once
    kUnions,     // of labels that met
    kComponents, // that ended
    kCracks,     // in the boundary pool at once
    kPoints,     // of the boundary that were fitted
    kHypotheses, // cones through three points that were voted on
    kCountKinds
};

const char *count_name(int kind);

using Counts = std::array<std::uint32_t, kCountKinds>;

// What config.h and labeller.h state of frames of this size: a limit of the build
// counts as if it were the frame's, for no limit changes a result.
Counts count_bounds(const Intrinsics &camera);

// What one eye made of one frame, and what there was to see.
struct FrameSight {
    Counts counts;
    ocel_status_t status;      // of the ellipse
    ocel_status_t status_cone; // and of the cone
    double target_area;        // px; 0: the target is not in view
};

FrameSight sight_of(const ocel_detection_t &detection, const ocel_cone_t &cone,
                    ocel_status_t status_cone, double target_area);

// The same, of a detector whose cone nobody has asked for.
FrameSight sight_of(const Detector &detector, double target_area);

// What has been checked.  Plain numbers, so that they can go through a pipe.
struct CheckTally {
    Counts largest; // of any frame
    std::uint32_t frames;
    std::uint32_t violations;

    void add(const CheckTally &other);
};

// {frames, violations, counts: {runs: {largest, bound}, ...}}.
nlohmann::ordered_json checks_json(const CheckTally &tally, const Counts &bounds);

// std::runtime_error when there were any, to be called when all is written.
void fail_on_violations(std::uint32_t violations);

// Where violations are told: a line on stderr.
void tell_violation(const std::string &message);

class FrameChecks {
  public:
    explicit FrameChecks(const Counts &bounds,
                         std::function<void(const std::string &)> tell = tell_violation);

    // `where`: scenario, point, trial, frame and eye.
    void check(const std::string &where, const FrameSight &sight);

    const CheckTally &tally() const {
        return tally_;
    }

  private:
    void violation(const std::string &where, const std::string &what);

    Counts bounds_;
    std::function<void(const std::string &)> tell_;
    CheckTally tally_{};
};

} // namespace sim

#endif
