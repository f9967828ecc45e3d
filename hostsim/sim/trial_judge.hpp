// SPDX-License-Identifier: MIT
//
// What a method found, against the truth.
#ifndef OCELLUS_SIM_TRIAL_JUDGE_HPP
#define OCELLUS_SIM_TRIAL_JUDGE_HPP

#include "estimate.hpp"
#include "scenario.hpp"
#include "trial_record.hpp"

namespace sim {

// The truth at the moment of the frames.
struct Truth {
    Vec3 p_world;    // the target's middle
    double distance; // SMU from the eyes' middle, along x
    HeadReading head;
};

MethodRecord judged(Method method, const Outlines &outlines, const Scenario &scenario,
                    const Truth &truth);

} // namespace sim

#endif
