// SPDX-License-Identifier: MIT
//
// What stands in the world of a scenario, as solids to draw.
#ifndef OCELLUS_SIM_STAGE_HPP
#define OCELLUS_SIM_STAGE_HPP

#include "support/random.hpp"
#include "trials/scenario.hpp"

namespace sim {

// The floor, the background and the target at p_world; what clutters the
// background is drawn from `random`.
Drawing make_drawing(const Setting &setting, const Vec3 &p_world, Random &random);

// A plate in front of the target, across the line of sight.  Its straight edge
// turns by `angle` about the line; `reach`, SMU, is how far it goes past the line
// from `p_eye` to the target, where it would hide half.
struct Occluder {
    Vec3 p_eye;
    Vec3 p_target;
    double target_radius;
    double angle;
};

Solid make_occluder(const Occluder &occluder, double reach);

} // namespace sim

#endif
