// SPDX-License-Identifier: MIT
//
// A scenario: what is varied, what is in view, who looks.  One TOML file each.
#ifndef OCELLUS_SIM_SCENARIO_HPP
#define OCELLUS_SIM_SCENARIO_HPP

#include <string>
#include <vector>

#include <ocellus/colour.h>

#include "camera/drawing.hpp"
#include "camera/intrinsics.hpp"
#include "camera/shutter.hpp"
#include "methods/methods.hpp"

namespace sim {

enum class Background { kPlain, kTextured, kCluttered };

// still: the eyes look at a place straight ahead.  fixate: they turn until both have the target
// in their middle.
enum class Gaze { kStill, kFixate };

// What the points of the sweep are values of.
enum class Varied { kDistance, kOcclusion };

struct CameraChoice {
    Intrinsics intrinsics;
    int supersampling;
    double noise;      // standard deviation, levels of 255
    Shutter shutter{}; // of what moves while a frame is taken: the closed loop's
};

struct TargetChoice {
    Shape shape;      // kBall or kDisc
    double radius;    // SMU
    double thickness; // SMU; of a disc
    Vec3 colour;      // 0..1
};

// What is in view, who looks, and for what: of every kind of scenario.
struct Setting {
    std::string name;
    std::string text; // the file's, as it stands
    CameraChoice camera;
    TargetChoice target;
    Background background;
    Lighting lighting;
    ocel_colour_range_t colour;
    std::uint32_t min_area; // px
};

struct Scenario : Setting {
    int trials; // at each point
    Varied varied;
    std::vector<double> points;
    double distance;  // SMU from the eyes' middle along x, where it is not varied
    double occlusion; // 0..1, where it is not varied
    double jitter;    // times the distance: the target is so far left or right, up or down
    Gaze gaze;
    double focus;          // SMU ahead of the eyes' middle: where still eyes look
    double gaze_tolerance; // px
    int gaze_frames;       // at most
    std::vector<Method> methods;

    double distance_at(std::size_t point) const {
        return varied == Varied::kDistance ? points[point] : distance;
    }
    double occlusion_at(std::size_t point) const {
        return varied == Varied::kOcclusion ? points[point] : occlusion;
    }
};

// Reads a scenario file.  cli::InputError with file, line, column and what was
// expected, for a key or a value that is wrong.
Scenario read_scenario(const std::string &path);

} // namespace sim

#endif
