// SPDX-License-Identifier: MIT
//
// What a method found, against the truth.
#ifndef OCELLUS_SIM_TRIAL_JUDGE_HPP
#define OCELLUS_SIM_TRIAL_JUDGE_HPP

#include "methods/estimate.hpp"
#include "trials/scenario.hpp"
#include "trials/trial_record.hpp"

namespace sim {

// The truth at the moment of the frames.
struct Truth {
    Vec3 p_world;    // the target's middle
    double distance; // SMU from the eyes' middle, along x
    HeadReading head;
};

// The target's outline as an eye sees it, which for a disc is taken to be its ball's;
// nothing when it is not all in front.
std::optional<Ellipse> true_outline(const Scenario &scenario, const Truth &truth, Side side);

// Centre within .25 r of the truth's, radius within 20 %.
bool is_success(const Ellipse &found, const Ellipse &truth);

// Of the circle of the same area, px.
double mean_radius(const Ellipse &ellipse);

MethodRecord judged(Method method, const Outlines &outlines, const Scenario &scenario,
                    const Truth &truth);

} // namespace sim

#endif
