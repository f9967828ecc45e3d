// SPDX-License-Identifier: MIT
//
// Vectors and rigid transforms, in double.  X_A_B is the pose of B in A: it
// takes coordinates in B to coordinates in A, as in the library.
#ifndef OCELLUS_SIM_GEOMETRY_HPP
#define OCELLUS_SIM_GEOMETRY_HPP

#include <cmath>
#include <opencv2/core.hpp>

namespace sim {

constexpr double kPi = 3.14159265358979323846;

using Vec3 = cv::Vec3d;
using Mat3 = cv::Matx33d;

constexpr double radians(double degrees) {
    return degrees * (kPi / 180.0);
}

constexpr double degrees(double radians) {
    return radians * (180.0 / kPi);
}

// p_A = r p_B + p.
struct Pose {
    Mat3 r = Mat3::eye();
    Vec3 p;
};

inline Vec3 operator*(const Pose &X_A_B, const Vec3 &p_B) {
    return X_A_B.r * p_B + X_A_B.p;
}

inline Pose operator*(const Pose &X_A_B, const Pose &X_B_C) {
    return {X_A_B.r * X_B_C.r, X_A_B * X_B_C.p};
}

inline Pose inverse(const Pose &X_A_B) {
    const Mat3 r = X_A_B.r.t();
    return {r, -(r * X_A_B.p)};
}

// By `angle` radians about x, y or z (0, 1, 2), right-handed.
inline Mat3 rotation(int axis, double angle) {
    const int j = (axis + 1) % 3;
    const int k = (axis + 2) % 3;
    Mat3 r = Mat3::eye();
    r(j, j) = r(k, k) = std::cos(angle);
    r(k, j) = std::sin(angle);
    r(j, k) = -r(k, j);
    return r;
}

} // namespace sim

#endif
