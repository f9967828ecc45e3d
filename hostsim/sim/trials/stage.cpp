// SPDX-License-Identifier: MIT
#include "trials/stage.hpp"

#include "world/paper_head.hpp"

namespace sim {

namespace {

constexpr double kFloorHalf = 200.0; // SMU: beyond what is drawn, so the horizon is level
constexpr double kWallPlace = 9.0;   // SMU along x
constexpr double kPlateHalf = 0.6;   // hides any target to its full width
constexpr double kPlateGap = 0.03;   // SMU between it and the target: both eyes see much the same
constexpr int kDistractors = 8;

// Greys: they carry no hue, so that the edge of the mask lies where a pixel is
// half target, before any of them.
const Vec3 kSky(0.62, 0.62, 0.62);
const Vec3 kFloor(0.45, 0.45, 0.45);
const Vec3 kPlate(0.30, 0.30, 0.30);

// None is near the target's blue.
const Vec3 kDistractorColours[] = {{0.80, 0.15, 0.10}, {0.15, 0.55, 0.15}, {0.85, 0.70, 0.10},
                                   {0.80, 0.45, 0.10}, {0.55, 0.35, 0.20}, {0.90, 0.90, 0.90}};

Solid box(const Vec3 &p_world, const Vec3 &half_size, const Vec3 &colour) {
    Solid solid;
    solid.X_world_solid.p = p_world;
    solid.half_size = half_size;
    solid.colour = colour;
    return solid;
}

Solid make_target(const TargetChoice &target, const Vec3 &p_world) {
    const bool disc = target.shape == Shape::kDisc;
    Solid solid = box(p_world, Vec3(target.radius, target.radius, target.radius), target.colour);
    solid.shape = target.shape;
    if (disc) {
        solid.half_size[0] = target.thickness / 2.0;
    }
    solid.is_target = true;
    return solid;
}

// A box or a ball of any of the colours, well behind what the eyes look for.
// One draw a statement: compilers differ in the order of a call's arguments.
Solid make_distractor(Random &random) {
    const double size = random.uniform(0.15, 0.6);
    const double x = random.uniform(5.5, 8.0);
    const double y = random.uniform(-4.0, 4.0);
    const double z = random.uniform(1.0, 5.0);
    const auto colour = static_cast<std::size_t>(random.bits() % std::size(kDistractorColours));
    const bool round = random.uniform() < 0.5;
    const double turn = random.uniform(0.0, kPi);
    const double roll = random.uniform();
    Solid solid = box(Vec3(x, y, z), Vec3(size, size, size), kDistractorColours[colour]);
    solid.shape = round ? Shape::kBall : Shape::kBox;
    solid.X_world_solid.r = rotation(2, turn) * rotation(0, roll);
    return solid;
}

void add_background(const Setting &setting, Random &random, Drawing &drawing) {
    const bool textured = setting.background != Background::kPlain;
    drawing.solids.push_back(box(Vec3(0, 0, -0.5), Vec3(kFloorHalf, kFloorHalf, 0.5), kFloor));
    drawing.solids.back().textured = textured;
    if (textured) {
        drawing.solids.push_back(box(Vec3(kWallPlace + 0.5, 0, 5), Vec3(0.5, 20, 8), kSky));
        drawing.solids.back().textured = true;
    }
    if (setting.background == Background::kCluttered) {
        for (int i = 0; i < kDistractors; ++i) {
            drawing.solids.push_back(make_distractor(random));
        }
    }
}

} // namespace

Drawing make_drawing(const Setting &setting, const Vec3 &p_world, Random &random) {
    Drawing drawing;
    drawing.clear_colour = kSky;
    drawing.lighting = setting.lighting;
    drawing.solids.push_back(make_target(setting.target, p_world));
    add_background(setting, random, drawing);
    return drawing;
}

Solid make_occluder(const Occluder &occluder, double reach) {
    const Vec3 sight = cv::normalize(occluder.p_target - occluder.p_eye);
    const double back = occluder.target_radius + kPlateGap;
    const Mat3 turn = rotation(0, occluder.angle);
    const double half_depth = 0.005;
    // Its +y edge is the one that hides; the plate is upright to x.
    const Vec3 edge = occluder.p_target - sight * (back / sight[0]);
    Solid solid = box(edge + turn * Vec3(0, reach - kPlateHalf, 0),
                      Vec3(half_depth, kPlateHalf, kPlateHalf), kPlate);
    solid.X_world_solid.r = turn;
    return solid;
}

} // namespace sim
