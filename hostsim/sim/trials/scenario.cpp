// SPDX-License-Identifier: MIT
#include "trials/scenario.hpp"

#include <fmt/format.h>
#include <fstream>

#include "colour_spec.hpp"
#include "error.hpp"
#include "input.hpp"
#include "trials/scenario_parts.hpp"

namespace sim {

namespace {

constexpr double kFarthest = 20.0; // SMU: what a scenario may ask for

constexpr double kLongestShutter = 0.033; // s: of a camera that takes 30 frames a second

void read_sweep(TomlReader reader, Scenario &scenario) {
    reader.expect_only({"trials", "varied", "points", "distance", "occlusion", "jitter"});
    scenario.trials = reader.integer("trials", 1, 1000000, "trials at each point");
    scenario.varied = static_cast<Varied>(reader.choice("varied", {"distance", "occlusion"}));
    const bool distances = scenario.varied == Varied::kDistance;
    scenario.points = reader.numbers("points", distances ? 0.3 : 0.0, distances ? kFarthest : 0.95,
                                     distances ? "SMU" : "of the target's area");
    scenario.distance = distances ? 0.0 : reader.number("distance", 0.3, kFarthest, "SMU");
    scenario.occlusion =
        distances ? reader.number("occlusion", 0.0, 0.95, "of the target's area") : 0.0;
    scenario.jitter = reader.number("jitter", 0.0, 1.0, "times the distance");
    reader.finish();
}

Vec3 colour_of(TomlReader &reader, const char *key) {
    const std::vector<double> values = reader.numbers(key, 0.0, 255.0, "");
    if (values.size() != 3) {
        reader.reject(key, "expected three numbers: red, green and blue, 0 .. 255");
    }
    return Vec3(values[0], values[1], values[2]) * (1.0 / 255.0);
}

// Nothing moves while these frames are taken: a shutter would change none of them.
void reject_shutter(const TomlReader &camera) {
    for (const char *const key : {"exposure", "readout"}) {
        if (camera.has(key)) {
            camera.reject(key, "has no effect where nothing moves while a frame is taken; expected "
                               "it to be left out here: it is for scenarios of `track`");
        }
    }
}

void read_gaze(TomlReader reader, Scenario &scenario) {
    reader.expect_only({"mode", "focus", "tolerance", "frames"});
    scenario.gaze = static_cast<Gaze>(reader.choice("mode", {"still", "fixate"}));
    if (scenario.gaze == Gaze::kStill) {
        scenario.focus = reader.number("focus", 0.3, 1000.0, "SMU");
    } else {
        scenario.gaze_tolerance = reader.number("tolerance", 0.01, 100.0, "px");
        scenario.gaze_frames = reader.integer("frames", 1, 1000, "frames");
    }
    reader.finish();
}

void read_detector(TomlReader reader, Scenario &scenario) {
    reader.expect_only({"colour", "min_area", "methods"});
    read_search(reader, scenario);
    for (const int method : reader.choices("methods", method_names())) {
        scenario.methods.push_back(static_cast<Method>(method));
    }
    if (scenario.methods.size() > kMethodCount) {
        reader.reject("methods", "found one twice; expected each method once");
    }
    reader.finish();
}

} // namespace

// OpenCV's five, in its order, the library's range.
void read_lens(TomlReader &reader, Intrinsics &camera) {
    const std::vector<double> k = reader.numbers("distortion", -16.0, 16.0, "");
    if (k.size() != 5) {
        reader.reject("distortion", "expected five numbers: k1, k2, p1, p2 and k3");
    }
    camera.lens = {k[0], k[1], k[2], k[3], k[4]};
    if (const auto dark = pixel_without_ray(camera)) {
        reader.reject(
            "distortion",
            fmt::format("leaves pixel ({}, {}) without a ray: the lens folds before it, or "
                        "it is over 80 degrees off the axis; expected less of it",
                        dark->x, dark->y));
    }
}

void read_shutter(TomlReader &reader, Shutter &shutter) {
    if (reader.has("exposure")) {
        shutter.exposure = reader.number("exposure", 0.0, kLongestShutter, "s");
        shutter.subframes = reader.integer("subframes", 1, 64, "drawings");
    }
    if (reader.has("readout")) {
        shutter.readout = reader.number("readout", 0.0, kLongestShutter, "s");
    }
}

void read_camera(TomlReader reader, CameraChoice &camera) {
    reader.expect_only({"preset", "size", "supersampling", "noise", "distortion", "exposure",
                        "subframes", "readout"});
    constexpr int kWidths[] = {160, 320, 640};
    constexpr int kSupersamplings[] = {1, 2, 4};
    const std::vector<std::string> presets = preset_names();
    const int preset = reader.choice("preset", presets);
    const int size = reader.choice("size", {"160x120", "320x240", "640x480"});
    const int quality = reader.choice("supersampling", {"1x1", "2x2", "4x4"});
    camera.intrinsics = make_intrinsics(presets[static_cast<std::size_t>(preset)], kWidths[size]);
    camera.supersampling = kSupersamplings[quality];
    camera.noise = reader.number("noise", 0.0, 64.0, "levels of 255");
    if (reader.has("distortion")) {
        read_lens(reader, camera.intrinsics);
    }
    read_shutter(reader, camera.shutter);
    reader.finish();
}

void read_target(TomlReader reader, TargetChoice &target) {
    reader.expect_only({"shape", "radius", "thickness", "colour"});
    target.shape = reader.choice("shape", {"ball", "disc"}) == 0 ? Shape::kBall : Shape::kDisc;
    target.radius = reader.number("radius", 0.01, 2.0, "SMU");
    target.thickness =
        target.shape == Shape::kDisc ? reader.number("thickness", 0.0001, 1.0, "SMU") : 0.0;
    target.colour = colour_of(reader, "colour");
    reader.finish();
}

void read_scene(TomlReader reader, Setting &setting) {
    reader.expect_only({"background", "lighting"});
    setting.background =
        static_cast<Background>(reader.choice("background", {"plain", "textured", "cluttered"}));
    setting.lighting = static_cast<Lighting>(reader.choice("lighting", {"flat", "soft", "harsh"}));
    reader.finish();
}

void read_search(TomlReader &reader, Setting &setting) {
    const std::string colour = reader.text("colour", cli::kColourGrammar);
    try {
        setting.colour = cli::parse_colour(colour);
    } catch (const cli::InputError &mistake) {
        reader.reject("colour", mistake.what());
    }
    setting.min_area = static_cast<std::uint32_t>(reader.integer("min_area", 1, 1000000, "px"));
}

toml::table parse_scenario_file(const std::string &path) {
    std::ifstream file(path);
    if (!file) {
        throw cli::InputError(path + ": cannot be read; expected a scenario file such as "
                                     "hostsim/scenarios/c_distance.toml");
    }
    try {
        return toml::parse(file, path);
    } catch (const toml::parse_error &mistake) {
        const toml::source_position place = mistake.source().begin;
        throw cli::InputError(path + ":" + std::to_string(place.line) + ":" +
                              std::to_string(place.column) +
                              ": is no TOML: " + std::string(mistake.description()));
    }
}

namespace {

std::string file_text(const std::string &path) {
    const std::vector<std::uint8_t> bytes = cli::read_bytes(path);
    return {bytes.begin(), bytes.end()};
}

} // namespace

Scenario read_scenario(const std::string &path) {
    const toml::table table = parse_scenario_file(path);
    TomlReader reader(table, path, "");
    reader.expect_only({"name", "sweep", "camera", "target", "scene", "gaze", "detector"});
    Scenario scenario{};
    scenario.name = reader.text("name", "the scenario's name in quotes");
    scenario.text = file_text(path);
    read_sweep(reader.table("sweep"), scenario);
    read_camera(reader.table("camera"), scenario.camera);
    reject_shutter(reader.table("camera"));
    read_target(reader.table("target"), scenario.target);
    read_scene(reader.table("scene"), scenario);
    read_gaze(reader.table("gaze"), scenario);
    read_detector(reader.table("detector"), scenario);
    reader.finish();
    return scenario;
}

} // namespace sim
