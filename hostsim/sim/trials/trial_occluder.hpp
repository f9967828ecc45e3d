// SPDX-License-Identifier: MIT
//
// How far an occluder must reach to hide a wanted share of the target.
#ifndef OCELLUS_SIM_TRIAL_OCCLUDER_HPP
#define OCELLUS_SIM_TRIAL_OCCLUDER_HPP

#include <functional>

namespace sim {

// The share that is hidden with the occluder at this reach; grows with it.
using HiddenShare = std::function<double(double reach)>;

// Tries reaches between -limit, where nothing is hidden, and limit, where all is,
// by false position with the Illinois rule.  Returns the share that the last one,
// which the occluder is left at, hides: within .0005 of `wanted`, or what the
// target's few pixels allow.
double search_occlusion(double wanted, double limit, const HiddenShare &hidden_at);

} // namespace sim

#endif
