// SPDX-License-Identifier: MIT
//
// The robot's side of the closed loop: all that the library does, and nothing that
// knows the truth.
#ifndef OCELLUS_SIM_TRACK_PILOT_HPP
#define OCELLUS_SIM_TRACK_PILOT_HPP

#include <array>
#include <memory>

#include <ocellus/gaze.h>
#include <ocellus/tracker.h>

#include "methods/detector.hpp"
#include "track/track_scenario.hpp"
#include "world/library_head.hpp"

namespace sim {

// What the library made of one pair of frames.
struct Sighting {
    ocel_rect_t roi[kSides];   // where the ball was expected before the frames were looked at
    bool expected[kSides];     // there is one
    ocel_status_t eye[kSides]; // of the cones
    ocel_cone_t cone[kSides];
    ocel_status_t stereo; // not_seen when neither cone is vouched for
    ocel_ball_t ball;
    ocel_status_t status; // of the tracker
    ocel_track_t track;
};

class Pilot {
  public:
    explicit Pilot(const TrackScenario &scenario);

    // Takes the frames of one exposure and the joints as they then were.
    Sighting look(const std::array<cli::Image, kSides> &frames, const JointAngles &angles,
                  std::int64_t time_us);

    // The motors' speeds from now on, the joints being where they are.
    JointAngles command(const JointAngles &angles, std::int64_t time_us);

    // What an eye made of the last frame.
    const ocel_detection_t &detection(Side side) const {
        return detectors_[side]->detection();
    }

    // s that the library itself has taken.
    double library_seconds() const {
        return library_seconds_;
    }

  private:
    void expect(std::int64_t time_us, Sighting &sighting) const;
    void place(Sighting &sighting) const;
    bool is_followed(const ocel_track_t &track) const;

    const TrackScenario &scenario_;
    std::array<std::unique_ptr<Detector>, kSides> detectors_;
    ocel_pose_t X_root_eye_[OCEL_EYE_COUNT] = {};
    ocel_tracker_t tracker_{};
    ocel_gaze_t gaze_{};
    double library_seconds_ = 0.0;
};

} // namespace sim

#endif
