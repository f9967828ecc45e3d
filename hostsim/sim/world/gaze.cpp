// SPDX-License-Identifier: MIT
#include "world/gaze.hpp"

#include <algorithm>

namespace sim {

namespace {

// Of the angle to go in one frame.  The motors reach their speed at once, so 1
// would do; less does not overshoot when they do not.
constexpr double kGain = 0.9;

} // namespace

double off_middle(const Seen &seen, const Intrinsics &camera) {
    double farthest = 0.0;
    for (const std::optional<cv::Point2d> &place : seen) {
        if (place) {
            farthest = std::max(farthest, std::hypot(place->x - camera.cx, place->y - camera.cy));
        }
    }
    return farthest;
}

void follow(const Seen &seen, const Intrinsics &camera, World &world) {
    constexpr double kRate = kGain / (kFrameSteps * kStep); // rad/s for a radian
    constexpr Joint kPans[kSides] = {kLeftPan, kRightPan};
    double down = 0.0;
    int eyes = 0;
    for (int side = 0; side < kSides; ++side) {
        const std::optional<cv::Point2d> &place = seen[static_cast<std::size_t>(side)];
        double right = 0.0;
        if (place) {
            right = std::atan((place->x - camera.cx) / camera.fx);
            down += std::atan((place->y - camera.cy) / camera.fy);
            ++eyes;
        }
        world.head().set_speed(kPans[side], -kRate * right);
    }
    world.head().set_speed(kEyesTilt, eyes > 0 ? -kRate * down / eyes : 0.0);
    world.advance(kFrameSteps);
}

} // namespace sim
