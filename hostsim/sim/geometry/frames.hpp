// SPDX-License-Identifier: MIT
//
// Where a coordinate changes its frame or its unit: one function for each.
//
// World (the paper's): origin on the floor under the head's pole, x forward,
// y left, z up; lengths in SMU, the iCub simulator's measure unit.  Bullet's
// world is this one.  Eye: at the eye's centre, the same axes when the head
// looks straight ahead.  Camera: x right, y down, z forward, as in the library.
#ifndef OCELLUS_SIM_FRAMES_HPP
#define OCELLUS_SIM_FRAMES_HPP

#include <LinearMath/btTransform.h>
#include <cstdint>

#include <ocellus/space.h>

#include "geometry/geometry.hpp"

namespace sim {

// The library's unit u is a millionth of an SMU, as in its model of the paper's
// head.
constexpr double kUnitsPerSmu = 1000000.0;

// X_eye_cam: from the camera's axes to the eye's.
Pose camera_in_eye();

// World to Bullet and back.
btVector3 bullet_vector(const Vec3 &p_world);
Vec3 world_vector(const btVector3 &p_bullet);
Pose world_pose(const btTransform &transform);

// SMU to the library's units and back.
std::int32_t units(double smu);
double smu_of_units(std::int64_t length_u);
Vec3 smu_of_units(const std::int32_t p_u[3]);

// A pose of the library's: the root of its paper's head is this world.
Pose world_pose(const ocel_pose_t &X_root_B);

// A unit vector of the library's.
Vec3 unit_vector(const std::int32_t d_q30[3]);

// Radians to the library's angles, 2^32 a turn.
std::int32_t turn_q32(double angle);

} // namespace sim

#endif
