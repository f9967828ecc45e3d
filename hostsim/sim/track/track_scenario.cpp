// SPDX-License-Identifier: MIT
#include "track/track_scenario.hpp"

#include "trials/scenario_parts.hpp"

namespace sim {

namespace {

constexpr double kFarthest = 60.0; // SMU: as far as is drawn
constexpr double kFastest = 60.0;  // SMU/s: what the library's tracker takes
constexpr double kLongest = 120.0; // s

Vec3 vector_of(TomlReader &reader, const std::string &key, double low, double high,
               const char *unit) {
    const std::vector<double> values = reader.numbers(key, low, high, unit);
    if (values.size() != 3) {
        reader.reject(key, "expected three numbers: x, y and z");
    }
    return {values[0], values[1], values[2]};
}

void read_run(TomlReader reader, TrackScenario &scenario) {
    reader.expect_only({"duration", "latency", "looks_at"});
    scenario.duration = reader.number("duration", 0.1, kLongest, "s");
    // A command holds for .05 s, and the next comes a frame after the last.
    scenario.latency = reader.number("latency", 0.0, 1.0 / kTrackRate, "s");
    scenario.looks_at = vector_of(reader, "looks_at", -kFarthest, kFarthest, "SMU");
    reader.finish();
}

void read_ball(TomlReader reader, BallStart &ball) {
    reader.expect_only({"place", "velocity", "release", "mass", "bounce", "jitter", "jitter_v"});
    ball.p_world = vector_of(reader, "place", -kFarthest, kFarthest, "SMU");
    ball.v_world = vector_of(reader, "velocity", -kFastest, kFastest, "SMU/s");
    ball.release = reader.number("release", 0.0, kLongest, "s");
    ball.mass = reader.number("mass", 0.001, 100.0, "kg");
    ball.bounce = reader.number("bounce", 0.0, 1.0, "of its speed");
    ball.jitter = reader.number("jitter", 0.0, 10.0, "SMU");
    ball.jitter_v = reader.number("jitter_v", 0.0, 10.0, "SMU/s");
    reader.finish();
}

Screen screen_of(TomlReader reader) {
    reader.expect_only({"place", "size"});
    Screen screen;
    screen.p_world = vector_of(reader, "place", -kFarthest, kFarthest, "SMU");
    screen.size = vector_of(reader, "size", 0.001, kFarthest, "SMU");
    reader.finish();
    return screen;
}

void read_tracker(TomlReader reader, TrackerChoice &tracker) {
    reader.expect_only({"coast", "max_speed", "wander", "gate", "gate_floor", "gravity"});
    tracker.coast = reader.number("coast", 0.001, 4.0, "s");
    tracker.max_speed = reader.number("max_speed", 0.001, kFastest, "SMU/s");
    tracker.wander = reader.number("wander", 0.0, tracker.max_speed, "SMU/s in a second");
    tracker.gate = reader.number("gate", 1.0, 16.0, "standard deviations");
    tracker.gate_floor = reader.number("gate_floor", 0.0, 60.0, "SMU");
    tracker.gravity = reader.choice("gravity", {"known", "none"}) == 0;
    if (tracker.coast * tracker.max_speed > kFarthest) {
        reader.reject("coast", "expected at most 60 SMU at max_speed in that time");
    }
    reader.finish();
}

void read_following(TomlReader reader, GazeChoice &gaze) {
    reader.expect_only({"gain", "lead", "follow", "floor"});
    gaze.gain = reader.number("gain", 0.0, 64.0, "1/s");
    gaze.lead = reader.number("lead", 0.0, 1.0, "s");
    gaze.follow = reader.number("follow", 0.0, kFarthest, "SMU");
    gaze.floor = reader.choice("floor", {"known", "none"}) == 0;
    reader.finish();
}

void read_only_search(TomlReader reader, Setting &setting) {
    reader.expect_only({"colour", "min_area"});
    read_search(reader, setting);
    reader.finish();
}

} // namespace

TrackScenario read_track_scenario(const std::string &path) {
    const toml::table table = parse_scenario_file(path);
    TomlReader reader(table, path, "");
    reader.expect_only({"name", "run", "camera", "target", "scene", "ball", "screen", "tracker",
                        "gaze", "detector"});
    TrackScenario scenario{};
    scenario.name = reader.text("name", "the scenario's name in quotes");
    read_run(reader.table("run"), scenario);
    read_camera(reader.table("camera"), scenario.camera);
    read_target(reader.table("target"), scenario.target);
    if (scenario.latency < scenario.camera.shutter.half_span()) {
        reader.table("run").reject("latency", "expected no less than half of exposure and readout "
                                              "together: the frame is not there before");
    }
    if (scenario.target.shape != Shape::kBall) {
        reader.table("target").reject("shape", "expected ball: a disc has no place to track");
    }
    read_scene(reader.table("scene"), scenario);
    read_ball(reader.table("ball"), scenario.ball);
    for (const TomlReader &screen : reader.tables("screen")) {
        scenario.screens.push_back(screen_of(screen));
    }
    read_tracker(reader.table("tracker"), scenario.tracker);
    read_following(reader.table("gaze"), scenario.gaze);
    read_only_search(reader.table("detector"), scenario);
    reader.finish();
    return scenario;
}

} // namespace sim
