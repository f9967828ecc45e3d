// SPDX-License-Identifier: MIT
#include "track/track_pilot.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/frames.hpp"
#include "support/stopwatch.hpp"
#include "world/world.hpp"

namespace sim {

namespace {

ocel_tracker_config_t tracker_config(const TrackerChoice &choice) {
    ocel_tracker_config_t config{};
    config.coast_us = static_cast<std::uint32_t>(std::lround(choice.coast * 1e6));
    config.max_speed_u_s = units(choice.max_speed);
    config.wander_u_s = units(choice.wander);
    config.gate_q16 = static_cast<std::uint32_t>(std::lround(choice.gate * 65536.0));
    config.gate_floor_u = units(choice.gate_floor);
    config.acceleration_root_u_s2[2] = choice.gravity ? units(-kGravity) : 0;
    return config;
}

// Without the integral, which would lead the ball by as much as the track is asked for
// ahead: that takes up an even motion already.
ocel_gaze_config_t gaze_config(const GazeChoice &choice) {
    ocel_gaze_config_t config = ocel_gaze_paper;
    config.eye_gain_q16 = static_cast<std::int32_t>(std::lround(choice.gain * 65536.0));
    config.eye_integral_q16 = 0;
    return config;
}

// The direction in which an eye would see a place of the root's frame.
ocel_gaze_error_t error_of(const ocel_pose_t &X_root_eye, const std::int32_t p_root_u[3]) {
    const Vec3 p_cam = inverse(world_pose(X_root_eye)) * smu_of_units(p_root_u);
    const std::int32_t d_cam[3] = {units(p_cam[0]), units(p_cam[1]), units(p_cam[2])};
    ocel_gaze_error_t error{};
    (void)ocel_gaze_error(d_cam, &error); // without a direction: not seen
    return error;
}

} // namespace

Pilot::Pilot(const TrackScenario &scenario) : scenario_(scenario) {
    for (auto &detector : detectors_) {
        detector = std::make_unique<Detector>(scenario.camera.intrinsics, scenario.colour,
                                              scenario.min_area);
    }
    const ocel_tracker_config_t tracker = tracker_config(scenario.tracker);
    const ocel_gaze_config_t gaze = gaze_config(scenario.gaze);
    must(ocel_tracker_init(&tracker_, &tracker), "ocel_tracker_init");
    must(ocel_gaze_init(&gaze_, &ocel_head_paper, &gaze), "ocel_gaze_init");
}

Sighting Pilot::look(const std::array<cli::Image, kSides> &frames, const JointAngles &angles,
                     std::int64_t time_us) {
    const LibraryJoints joints = library_joints_within_limits(angles);
    for (const Side side : {kLeft, kRight}) {
        detectors_[side]->take(frames[side]);
    }
    const Stopwatch stopwatch(library_seconds_);
    Sighting sighting{};
    must(ocel_head_forward(&ocel_head_paper, joints.data(), X_root_eye_), "ocel_head_forward");
    expect(time_us, sighting);
    for (const Side side : {kLeft, kRight}) {
        const Detector &detector = *detectors_[side];
        detectors_[side]->feed();
        sighting.eye[side] = ocel_eye_cone(&detector.eye(), &detector.camera(),
                                           &detector.detection(), &sighting.cone[side]);
    }
    place(sighting);
    const bool vouched = sighting.stereo == OCEL_OK;
    sighting.status = ocel_tracker_update(&tracker_, time_us,
                                          vouched ? &sighting.ball.best : nullptr, &sighting.track);
    return sighting;
}

// Where the track says that the ball will be in the images.
void Pilot::expect(std::int64_t time_us, Sighting &sighting) const {
    ocel_tracker_t later = tracker_;
    ocel_track_t track{};
    (void)ocel_tracker_update(&later, time_us, nullptr, &track);
    for (const Side side : {kLeft, kRight}) {
        sighting.expected[side] =
            ocel_tracker_roi(&track, &X_root_eye_[side], &detectors_[side]->camera(),
                             units(scenario_.target.radius), &sighting.roi[side]) == OCEL_OK;
    }
}

// By the cones that are vouched for, and no others.
void Pilot::place(Sighting &sighting) const {
    const auto cone = [&sighting](Side side) {
        return sighting.eye[side] == OCEL_OK ? &sighting.cone[side] : nullptr;
    };
    sighting.stereo = ocel_stereo_ball(cone(kLeft), cone(kRight), X_root_eye_,
                                       units(scenario_.target.radius), &sighting.ball);
}

bool Pilot::is_followed(const ocel_track_t &track) const {
    const auto &cov = track.cov_root_u2;
    const double variance = static_cast<double>(cov[OCEL_XX] + cov[OCEL_YY] + cov[OCEL_ZZ]);
    return track.state != OCEL_TRACK_LOST &&
           std::sqrt(variance) < scenario_.gaze.follow * kUnitsPerSmu;
}

JointAngles Pilot::command(const JointAngles &angles, std::int64_t time_us) {
    const LibraryJoints joints = library_joints_within_limits(angles);
    const Stopwatch stopwatch(library_seconds_);
    const auto lead_us = static_cast<std::int64_t>(std::lround(scenario_.gaze.lead * 1e6));
    ocel_tracker_t later = tracker_;
    ocel_track_t track{};
    ocel_pose_t X_root_eye[OCEL_EYE_COUNT];
    ocel_gaze_error_t errors[OCEL_EYE_COUNT] = {};
    LibraryJoints command{};
    (void)ocel_tracker_update(&later, time_us + lead_us, nullptr, &track);
    if (scenario_.gaze.floor) {
        track.p_root_u[2] = std::max(track.p_root_u[2], units(scenario_.target.radius));
    }
    must(ocel_head_forward(&ocel_head_paper, joints.data(), X_root_eye), "ocel_head_forward");
    for (const Side side : {kLeft, kRight}) {
        if (is_followed(track)) {
            errors[side] = error_of(X_root_eye[side], track.p_root_u);
        }
    }
    (void)ocel_gaze_update(&gaze_, time_us, errors, joints.data(), command.data());
    return motor_speeds(command);
}

} // namespace sim
