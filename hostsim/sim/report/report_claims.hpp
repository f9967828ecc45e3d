// SPDX-License-Identifier: MIT
//
// What is asked of the simulation, and whether a run's data show it.
#ifndef OCELLUS_SIM_REPORT_CLAIMS_HPP
#define OCELLUS_SIM_REPORT_CLAIMS_HPP

#include "report/report_data.hpp"

namespace sim {

// Limits of what is asked; lengths in SMU.
constexpr double kSphereError = 0.003;    // c, sphere, mean
constexpr double kEllipseError = 0.007;   // c, b2ac and lcse, mean: "near .007"
constexpr double kHalfHiddenPct = -29.0;  // b, b2ac and lcse at 50 %, true depth
constexpr double kHalfHiddenSlack = 2.0;  // our reading of "about"
constexpr double kStraightness = 0.97;    // our reading of "linear": least r2
constexpr double kSphereRadiusPct = 0.5;  // b, sphere: means at every point
constexpr double kDebiasedError = 0.004;  // a, b2ac and lcse, mean after removal
constexpr double kFramesPerSecond = 25.0; // the whole loop on one core

// Whether the figures of a run of the closed loop are asked for, and reached: held in
// both images' middles, and placed in space, in all frames in which any of it is visible.
bool is_asked(const TrackRun &track);
bool holds(const TrackRun &track);
bool places(const TrackRun &track);

struct Claim {
    std::string what;
    std::string asked;
    std::string found;
    bool reached;
};

// Those that the data can decide.
std::vector<Claim> claims_of(const ReportData &data);

} // namespace sim

#endif
