// SPDX-License-Identifier: MIT
#include "world/paper_head.hpp"

namespace sim {

namespace {

// One row of Table 2: Rz(theta) Tz(d) Tx(a) Rx(alpha).
Pose link(double a, double alpha, double d, double theta) {
    const Pose turned{rotation(2, theta), Vec3(0, 0, d)};
    return turned * Pose{rotation(0, alpha), Vec3(a, 0, 0)};
}

} // namespace

double version_of(const JointAngles &joints) {
    return (joints[kLeftPan] + joints[kRightPan]) / 2.0;
}

double half_vergence_of(const JointAngles &joints) {
    return (joints[kRightPan] - joints[kLeftPan]) / 2.0;
}

Vec3 paper_target(const JointAngles &joints, double d0) {
    const Pose X_0_5 = link(0, kPi / 2, kNeckHeight, 0) * link(0, -kPi / 2, 0, joints[kNeckPitch]) *
                       link(kEyeForward, kPi / 2, kEyeRise, joints[kNeckYaw]) *
                       link(0, -kPi / 2, 0, joints[kEyesTilt]) * link(d0, 0, 0, version_of(joints));
    return X_0_5.p;
}

double paper_distance(const JointAngles &joints) {
    return kEyeDistance / (2.0 * std::tan(half_vergence_of(joints)));
}

} // namespace sim
