// SPDX-License-Identifier: MIT
//
// What there is to draw: solids in the world, and the light on them.
#ifndef OCELLUS_SIM_DRAWING_HPP
#define OCELLUS_SIM_DRAWING_HPP

#include <vector>

#include "geometry/geometry.hpp"

namespace sim {

// Each fills its box: half sizes along its own axes.  A ball has three equal
// ones; a disc's axis is x.
enum class Shape { kBox, kBall, kDisc };

// flat: the colours as they are.  soft: .6 ambient, the rest from above left of
// the head.  harsh: .15 ambient, and a highlight.
enum class Lighting { kFlat, kSoft, kHarsh };

struct Solid {
    Shape shape = Shape::kBox;
    Pose X_world_solid;
    Vec3 half_size; // SMU
    Vec3 colour;    // red, green, blue, 0..1
    bool textured = false;
    bool is_target = false; // what the detectors look for
};

struct Drawing {
    std::vector<Solid> solids;
    Vec3 clear_colour;
    Lighting lighting = Lighting::kFlat;
};

} // namespace sim

#endif
