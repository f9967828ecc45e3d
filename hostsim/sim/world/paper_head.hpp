// SPDX-License-Identifier: MIT
//
// The paper's head on paper: its lengths, and its chain in double.
#ifndef OCELLUS_SIM_PAPER_HEAD_HPP
#define OCELLUS_SIM_PAPER_HEAD_HPP

#include <array>

#include "geometry/geometry.hpp"

namespace sim {

// Table 1, SMU.
constexpr double kEyeDistance = 0.35;                 // EYD, from eye to eye
constexpr double kEyeForward = 0.36;                  // EXO, from the neck's pitch axis
constexpr double kEyeHeight = 3.50;                   // EZO, above the floor
constexpr double kNeckHeight = 3.01;                  // HZO, above the floor
constexpr double kEyeRise = kEyeHeight - kNeckHeight; // from the neck to the eyes

// The five joints.  Pitch and tilt are positive up, yaw and the pans left.
enum Joint { kNeckPitch = 0, kNeckYaw, kEyesTilt, kLeftPan, kRightPan, kJointCount };

using JointAngles = std::array<double, kJointCount>; // radians

enum Side { kLeft = 0, kRight, kSides };

// The mean pan of both eyes, and the paper's EVG: how far each eye turns inwards
// from it.
double version_of(const JointAngles &joints);
double half_vergence_of(const JointAngles &joints);

// Table 2: the target d0 in front of the middle of the eyes, along the version.
Vec3 paper_target(const JointAngles &joints, double d0);

// Eq. 14: how far the eyes' lines of sight say the target is; not finite when
// they do not meet.
double paper_distance(const JointAngles &joints);

// The eyes' middle when the joints are 0: distances are measured from there.
inline Vec3 eyes_middle() {
    return {kEyeForward, 0.0, kEyeHeight};
}

} // namespace sim

#endif
