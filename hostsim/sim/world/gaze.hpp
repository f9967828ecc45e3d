// SPDX-License-Identifier: MIT
//
// Turning the eyes until both have the target in their middle.
#ifndef OCELLUS_SIM_GAZE_HPP
#define OCELLUS_SIM_GAZE_HPP

#include <array>
#include <optional>

#include "camera/intrinsics.hpp"
#include "world/world.hpp"

namespace sim {

constexpr int kFrameSteps = 33; // of kStep: 30 frames a second

// Where each eye sees the target, px; nothing when it does not.
using Seen = std::array<std::optional<cv::Point2d>, kSides>;

// How far off the middle the farther one is, px.
double off_middle(const Seen &seen, const Intrinsics &camera);

// Turns tilt and pans by what the images show, for one frame's time.
void follow(const Seen &seen, const Intrinsics &camera, World &world);

} // namespace sim

#endif
