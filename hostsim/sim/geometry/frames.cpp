// SPDX-License-Identifier: MIT
#include "geometry/frames.hpp"

namespace sim {

namespace {

constexpr double kQ30 = 1073741824.0;

} // namespace

Pose camera_in_eye() {
    // The columns are the camera's axes in the eye: right is -y, down is -z,
    // forward is x.
    return {Mat3(0, 0, 1, -1, 0, 0, 0, -1, 0), Vec3()};
}

btVector3 bullet_vector(const Vec3 &p_world) {
    return {p_world[0], p_world[1], p_world[2]};
}

Vec3 world_vector(const btVector3 &p_bullet) {
    return {p_bullet.x(), p_bullet.y(), p_bullet.z()};
}

Pose world_pose(const btTransform &transform) {
    Pose pose;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            pose.r(row, column) = transform.getBasis()[row][column];
        }
    }
    pose.p = world_vector(transform.getOrigin());
    return pose;
}

std::int32_t units(double smu) {
    return static_cast<std::int32_t>(std::lround(smu * kUnitsPerSmu));
}

double smu_of_units(std::int64_t length_u) {
    return static_cast<double>(length_u) / kUnitsPerSmu;
}

Vec3 smu_of_units(const std::int32_t p_u[3]) {
    return Vec3(p_u[0], p_u[1], p_u[2]) * (1.0 / kUnitsPerSmu);
}

Vec3 unit_vector(const std::int32_t d_q30[3]) {
    return Vec3(d_q30[0], d_q30[1], d_q30[2]) * (1.0 / kQ30);
}

Pose world_pose(const ocel_pose_t &X_root_B) {
    Pose pose;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            pose.r(row, column) = X_root_B.r_q30[row][column] / kQ30;
        }
    }
    pose.p = smu_of_units(X_root_B.p_u);
    return pose;
}

std::int32_t turn_q32(double angle) {
    return static_cast<std::int32_t>(std::lround(angle / (2.0 * kPi) * 4294967296.0));
}

} // namespace sim
