// SPDX-License-Identifier: MIT
#include "track/track_loop.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "geometry/frames.hpp"
#include "support/stopwatch.hpp"
#include "trials/stage.hpp"
#include "trials/trial_seeds.hpp"

namespace sim {

namespace {

constexpr int kStepsPerSecond = 1000;
static_assert(kStep * kStepsPerSecond == 1.0);

const Vec3 kScreenColour(0.30, 0.30, 0.30); // a grey, as all that is not the ball

// The step of the physics in which frame `frame` is exposed: 30 frames a second in
// whole steps.
int exposure_step(int frame) {
    return frame * kStepsPerSecond / static_cast<int>(kTrackRate);
}

int whole_steps(double seconds) {
    return static_cast<int>(std::lround(seconds * kStepsPerSecond));
}

std::uint64_t seed_of(const TrackScenario &scenario, std::uint64_t seed, std::uint64_t draw) {
    return mixed_seed(mixed_seed(text_seed(scenario.name), seed), draw);
}

Vec3 jittered(const Vec3 &v, double reach, Random &random) {
    Vec3 result = v;
    for (int axis = 0; axis < 3; ++axis) {
        result[axis] += random.uniform(-reach, reach);
    }
    return result;
}

BallBody ball_body(const TrackScenario &scenario, std::uint64_t seed) {
    Random random(seed_of(scenario, seed, kPlacement));
    BallBody ball;
    ball.radius = scenario.target.radius;
    ball.mass = scenario.ball.mass;
    ball.bounce = scenario.ball.bounce;
    ball.p_world = jittered(scenario.ball.p_world, scenario.ball.jitter, random);
    return ball;
}

Solid screen_solid(const Screen &screen) {
    Solid solid;
    solid.X_world_solid.p = screen.p_world;
    solid.half_size = screen.size * 0.5;
    solid.colour = kScreenColour;
    return solid;
}

void turn_joint(JointAngles &angles, Joint joint, double by) {
    const JointLimits limits = joint_limits(joint);
    double &angle = angles[static_cast<std::size_t>(joint)];
    angle = std::clamp(angle + by, limits.low, limits.high);
}

double deviation(const ocel_track_t &track) {
    const auto &cov = track.cov_root_u2;
    return std::sqrt(static_cast<double>(cov[OCEL_XX] + cov[OCEL_YY] + cov[OCEL_ZZ])) /
           kUnitsPerSmu;
}

void take_down(const Sighting &sighting, TrackFrame &frame) {
    std::copy(sighting.eye, sighting.eye + kSides, frame.status_eye);
    frame.status_stereo = sighting.stereo;
    frame.status = sighting.status;
    frame.state = sighting.track.state;
    if (sighting.stereo == OCEL_OK) {
        frame.p_measured = smu_of_units(sighting.ball.best.p_root_u);
    }
    if (sighting.track.state != OCEL_TRACK_LOST) {
        frame.p_track = smu_of_units(sighting.track.p_root_u);
        frame.sigma = deviation(sighting.track);
    }
}

} // namespace

JointAngles looking_at(Head &head, const Vec3 &p_world) {
    constexpr int kRounds = 20; // half of them with the neck; each leaves a small part
    JointAngles angles{};
    for (int round = 0; round < kRounds; ++round) {
        head.place(angles);
        const Vec3 left = inverse(head.X_world_eye(kLeft)) * p_world;
        const Vec3 right = inverse(head.X_world_eye(kRight)) * p_world;
        const Vec3 middle = (left + right) * 0.5;
        const double up = std::atan2(middle[2], std::hypot(middle[0], middle[1]));
        if (round < kRounds / 2) {
            turn_joint(angles, kNeckPitch, up);
            turn_joint(angles, kNeckYaw, std::atan2(middle[1], middle[0]));
        } else {
            turn_joint(angles, kEyesTilt, up);
            turn_joint(angles, kLeftPan, std::atan2(left[1], left[0]));
            turn_joint(angles, kRightPan, std::atan2(right[1], right[0]));
        }
    }
    return angles;
}

TrackLoop::TrackLoop(const TrackScenario &scenario, std::uint64_t seed)
    : scenario_(scenario), seed_(seed), world_(ball_body(scenario, seed)),
      renderer_(scenario.camera.intrinsics, scenario.camera.supersampling, scenario.camera.shutter),
      pilot_(scenario), judge_(scenario), checks_(count_bounds(scenario.camera.intrinsics)) {
    Random push(seed_of(scenario, seed, kEdge));
    Random clutter(seed_of(scenario, seed, kClutter));
    v_start_ = jittered(scenario.ball.v_world, scenario.ball.jitter_v, push);
    drawing_ = make_drawing(scenario, world_.ball_place(), clutter);
    for (const Screen &screen : scenario.screens) {
        drawing_.solids.push_back(screen_solid(screen));
    }
    world_.hold_ball();
    world_.head().place(looking_at(world_.head(), scenario.looks_at));
    course_.push_back(moment());
}

int TrackLoop::frame_count() const {
    return static_cast<int>(std::lround(scenario_.duration * kTrackRate));
}

TrackFrame TrackLoop::step() {
    TrackFrame frame = true_frame();
    react(frame);
    check();
    take_down(sighting_, frame);
    ++frame_;
    return frame;
}

Moment TrackLoop::moment() {
    Head &head = world_.head();
    return {world_.ball_place(), {head.X_world_cam(kLeft), head.X_world_cam(kRight)}};
}

TrackFrame TrackLoop::true_frame() {
    TrackFrame frame{};
    now_ = moment();
    frame.time = step_ * kStep;
    frame.p_true = now_.p_ball;
    frame.angles = world_.head().angles();
    judge_.judge(drawing_.solids, now_.X_world_cam, frame);
    return frame;
}

// The loop itself: what a robot and its world would do.  A shutter that takes time is
// open for as long after the frame's moment as before it.
void TrackLoop::react(TrackFrame &frame) {
    const Stopwatch stopwatch(loop_seconds_);
    const std::int64_t exposed_us = time_us();
    const int command = step_ + whole_steps(scenario_.latency);
    advance_to(step_ + static_cast<int>(std::ceil(renderer_.shutter().half_span() / kStep)));
    expose();
    sighting_ = pilot_.look(images_, frame.angles, exposed_us);
    advance_to(command);
    frame.speeds = pilot_.command(world_.head().angles(), time_us());
    turn(frame.speeds);
    advance_to(exposure_step(frame_ + 1));
}

// The ball is let go in the step of its release.
void TrackLoop::advance_to(int step) {
    const int release = whole_steps(scenario_.ball.release);
    if (step_ <= release && release < step) {
        advance_and_note(release - step_);
        world_.release_ball(v_start_);
    }
    advance_and_note(step - step_);
}

void TrackLoop::advance_and_note(int steps) {
    step_ += steps;
    if (renderer_.shutter().instant()) {
        world_.advance(steps);
        return;
    }
    for (int i = 0; i < steps; ++i) {
        world_.advance(1);
        course_.push_back(moment());
    }
}

// Between two steps what moves is taken to do so evenly: in 1 ms a rotation is so
// small that its matrix may be.
View TrackLoop::view_at(Side side, double step) const {
    const double last = static_cast<double>(course_.size() - 1);
    const double at = std::clamp(step, 0.0, last);
    const auto index = std::min(static_cast<std::size_t>(at), course_.size() - 2);
    const double share = at - static_cast<double>(index);
    const Moment &a = course_[index];
    const Moment &b = course_[index + 1];
    const Pose &X_a = a.X_world_cam[side];
    const Pose &X_b = b.X_world_cam[side];
    View view{drawing_, {X_a.r + (X_b.r - X_a.r) * share, X_a.p + (X_b.p - X_a.p) * share}};
    view.drawing.solids.front().X_world_solid.p = a.p_ball + (b.p_ball - a.p_ball) * share;
    return view;
}

cli::Image TrackLoop::picture(Side side) {
    if (renderer_.shutter().instant()) {
        drawing_.solids.front().X_world_solid.p = now_.p_ball;
        return renderer_.picture(drawing_, now_.X_world_cam[side]);
    }
    const double step = exposure_step(frame_);
    return renderer_.picture([&](double t) { return view_at(side, step + t / kStep); });
}

void TrackLoop::expose() {
    for (const Side side : {kLeft, kRight}) {
        const auto draw = mixed_seed(kNoise, static_cast<unsigned>(frame_ * kSides + side));
        images_[side] = picture(side);
        seen_area_[side] = renderer_.seen_area();
        add_noise(scenario_.camera.noise, seed_of(scenario_, seed_, draw), images_[side]);
    }
}

void TrackLoop::check() {
    for (const Side side : {kLeft, kRight}) {
        checks_.check(fmt::format("{}, frame {}, {} eye", scenario_.name, frame_,
                                  side == kLeft ? "left" : "right"),
                      sight_of(pilot_.detection(side), sighting_.cone[side], sighting_.eye[side],
                               seen_area_[side]));
    }
}

void TrackLoop::turn(const JointAngles &speeds) {
    for (int joint = 0; joint < kJointCount; ++joint) {
        world_.head().set_speed(static_cast<Joint>(joint), speeds[static_cast<std::size_t>(joint)]);
    }
}

} // namespace sim
