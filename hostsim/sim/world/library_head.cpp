// SPDX-License-Identifier: MIT
#include "world/library_head.hpp"

#include <algorithm>

#include "geometry/frames.hpp"

namespace sim {

LibraryJoints library_joints(const JointAngles &angles) {
    LibraryJoints q32{};
    q32[OCEL_NECK_PITCH] = turn_q32(angles[kNeckPitch]);
    q32[OCEL_NECK_YAW] = turn_q32(angles[kNeckYaw]);
    q32[OCEL_EYES_TILT] = turn_q32(angles[kEyesTilt]);
    q32[OCEL_EYES_VERSION] = turn_q32(version_of(angles));
    q32[OCEL_EYES_VERGENCE] = turn_q32(2.0 * half_vergence_of(angles));
    return q32;
}

LibraryJoints library_joints_within_limits(const JointAngles &angles) {
    const ocel_head_model_t &model = ocel_head_paper;
    LibraryJoints q32 = library_joints(angles);
    for (std::size_t joint = 0; joint < q32.size(); ++joint) {
        q32[joint] = std::clamp(q32[joint], model.min_q32[joint], model.max_q32[joint]);
    }
    const std::int32_t room = model.max_pan_q32 - q32[OCEL_EYES_VERGENCE] / 2;
    q32[OCEL_EYES_VERSION] = std::clamp(q32[OCEL_EYES_VERSION], -room, room);
    return q32;
}

JointAngles motor_speeds(const LibraryJoints &command_q32) {
    const auto speed = [&command_q32](int joint) {
        return command_q32[static_cast<std::size_t>(joint)] * (2.0 * kPi / 4294967296.0);
    };
    JointAngles speeds{};
    speeds[kNeckPitch] = speed(OCEL_NECK_PITCH);
    speeds[kNeckYaw] = speed(OCEL_NECK_YAW);
    speeds[kEyesTilt] = speed(OCEL_EYES_TILT);
    speeds[kLeftPan] = speed(OCEL_EYES_VERSION) - speed(OCEL_EYES_VERGENCE) / 2.0;
    speeds[kRightPan] = speed(OCEL_EYES_VERSION) + speed(OCEL_EYES_VERGENCE) / 2.0;
    return speeds;
}

} // namespace sim
