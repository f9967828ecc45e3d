// SPDX-License-Identifier: MIT
//
// The head's joints in the library's terms: its model of the paper's head has the
// eyes' version and vergence where Bullet's has two pans.
#ifndef OCELLUS_SIM_LIBRARY_HEAD_HPP
#define OCELLUS_SIM_LIBRARY_HEAD_HPP

#include <ocellus/head.h>

#include "world/paper_head.hpp"

namespace sim {

using LibraryJoints = std::array<std::int32_t, OCEL_JOINT_COUNT>; // turns, Q32

// What the encoders read.
LibraryJoints library_joints(const JointAngles &angles);

// The same, no further than the model's limits: Bullet's give way a little, and the
// library takes no angle beyond its own.
LibraryJoints library_joints_within_limits(const JointAngles &angles);

// A command of the gaze's, turns/s, as the motors' speeds.
JointAngles motor_speeds(const LibraryJoints &command_q32);

} // namespace sim

#endif
