// SPDX-License-Identifier: MIT
//
// What one trial gives.  Plain numbers, so that a record can go through a pipe;
// what does not exist is not a number.
#ifndef OCELLUS_SIM_TRIAL_RECORD_HPP
#define OCELLUS_SIM_TRIAL_RECORD_HPP

#include <cstdint>
#include <limits>

#include "methods/methods.hpp"
#include "trials/checks.hpp"

namespace sim {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// What one method made of it.
struct MethodRecord {
    Method method;
    ocel_status_t status;
    bool success; // both outlines: centre within .25 r, radius within 20 % of the truth
    double p_world[3];
    double error; // SMU, all three
    double error_encoder;
    double error_residual;
    double error_debiased; // a disc's: with its r^2/d taken off x
    double radius;
    double radius_error_pct;
    double radius_true_depth; // the outline's with the true depth: without stereo's error
    double radius_true_depth_error_pct;
    double centre_error_px; // of the outline, the worse eye
    int votes;              // Hough: the lower threshold of both eyes
};

struct TrialRecord {
    std::uint32_t point;
    std::int32_t trial;
    double distance;
    double occlusion; // as it came out, in the left eye
    double p_true[3];
    std::int32_t frames; // pairs drawn until the measured one, inclusive
    CheckTally checks;   // of all of them, both eyes
    std::int32_t method_count;
    MethodRecord methods[kMethodCount];
};

} // namespace sim

#endif
