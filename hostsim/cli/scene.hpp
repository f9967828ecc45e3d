// SPDX-License-Identifier: MIT
//
// A rendered frame whose truth is known: a shaded ball before a textured
// ground.  A picture generator for demo and bench; floating point is fine here.
#ifndef OCELLUS_CLI_SCENE_HPP
#define OCELLUS_CLI_SCENE_HPP

#include <cstdint>

#include "image.hpp"

namespace cli {

// The ball's outline is a circle, antialiased by its coverage of each pixel.
struct Ball {
    double cx;
    double cy;
    double radius;
};

// The colours that hold the ball and nothing of the ground.
constexpr const char *kBallColour = "hsv:5-45,125-255,40-255";

// The same arguments give the same picture.
Image render_scene(std::uint32_t width, std::uint32_t height, const Ball &ball, std::uint64_t seed);

} // namespace cli

#endif
