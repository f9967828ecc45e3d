// SPDX-License-Identifier: MIT
//
// What is so in truth: how much of the ball an eye can see, by rays, so that it
// costs no drawing and says the same at every size of picture; and whether the head
// holds it.
#ifndef OCELLUS_SIM_TRACK_TRUTH_HPP
#define OCELLUS_SIM_TRACK_TRUTH_HPP

#include <array>
#include <vector>

#include "track/track.hpp"

namespace sim {

// Shares of the ball's disc as the eye sees it, 0 .. 1.
struct Visibility {
    double visible; // in the picture, and nothing before it
    double covered; // something is before it, in the picture or not
};

// `solids`: what stands in the world; the target among them is passed over.
Visibility visibility_of(const Vec3 &p_world, double radius, const std::vector<Solid> &solids,
                         const Pose &X_world_cam, const Intrinsics &camera);

class TrackJudge {
  public:
    explicit TrackJudge(const TrackScenario &scenario) : scenario_(scenario) {
    }

    // From time, p_true and where the cameras are: all that is true in the frame.  The
    // frames come in their order.
    void judge(const std::vector<Solid> &solids, const std::array<Pose, kSides> &X_world_cam,
               TrackFrame &frame);

  private:
    const TrackScenario &scenario_;
    double first_visible_ = -1.0; // s; negative: not yet
};

// How far off the middle the farther eye has it, px.
double off_middle(const TrackFrame &frame);

} // namespace sim

#endif
