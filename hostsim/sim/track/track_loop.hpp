// SPDX-License-Identifier: MIT
//
// The closed loop as it goes: world, cameras and the pilot, frame by frame.
#ifndef OCELLUS_SIM_TRACK_LOOP_HPP
#define OCELLUS_SIM_TRACK_LOOP_HPP

#include "camera/renderer.hpp"
#include "track/track_pilot.hpp"
#include "track/track_truth.hpp"
#include "trials/checks.hpp"
#include "world/world.hpp"

namespace sim {

// The joints with which the head looks at a place: as far as it can with the neck,
// the rest with the eyes, which converge there.
JointAngles looking_at(Head &head, const Vec3 &p_world);

// Where everything that moves is at a step of the physics.
struct Moment {
    Vec3 p_ball;
    std::array<Pose, kSides> X_world_cam;
};

class TrackLoop {
  public:
    TrackLoop(const TrackScenario &scenario, std::uint64_t seed);

    // How many pairs of frames its time has.
    int frame_count() const;

    // The next pair of frames and what follows from it, until the one after.
    TrackFrame step();

    // Of the last step.
    const std::array<cli::Image, kSides> &images() const {
        return images_;
    }
    const Sighting &sighting() const {
        return sighting_;
    }
    const std::array<Pose, kSides> &X_world_cam() const {
        return now_.X_world_cam;
    }

    // Of every frame so far.
    const CheckTally &checks() const {
        return checks_.tally();
    }

    TrackTimes times() const {
        return {loop_seconds_, pilot_.library_seconds()};
    }

  private:
    cli::Image picture(Side side);
    View view_at(Side side, double step) const;
    void expose();
    void check();
    void advance_and_note(int steps);
    std::int64_t time_us() const {
        return step_ * std::int64_t{1000};
    }
    void advance_to(int step);
    void turn(const JointAngles &speeds);
    Moment moment();
    TrackFrame true_frame();
    void react(TrackFrame &frame);

    const TrackScenario &scenario_;
    std::uint64_t seed_;
    Vec3 v_start_;
    World world_;
    Renderer renderer_;
    Pilot pilot_;
    TrackJudge judge_;
    FrameChecks checks_;
    Drawing drawing_;
    std::array<cli::Image, kSides> images_;
    std::array<double, kSides> seen_area_{}; // px, of the ball in images_
    Moment now_;                             // of the frame in hand
    std::vector<Moment> course_; // every step from the first on, for a shutter that takes time
    Sighting sighting_{};
    int frame_ = 0;
    int step_ = 0; // of the physics, 1 ms
    double loop_seconds_ = 0.0;
};

} // namespace sim

#endif
