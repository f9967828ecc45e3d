// SPDX-License-Identifier: MIT
//
// The lens distortion of Brown and Conrady as OpenCV orders and defines it, in
// double: with r^2 = x^2 + y^2 of the ray (x, y, 1),
//   x' = x (1 + k1 r^2 + k2 r^4 + k3 r^6) + 2 p1 x y + p2 (r^2 + 2 x^2)
//   y' = y (1 + k1 r^2 + k2 r^4 + k3 r^6) + p1 (r^2 + 2 y^2) + 2 p2 x y
#ifndef OCELLUS_SIM_LENS_HPP
#define OCELLUS_SIM_LENS_HPP

#include <opencv2/core/types.hpp>
#include <optional>

namespace sim {

// All 0: a pinhole.
struct Lens {
    double k1 = 0.0;
    double k2 = 0.0;
    double p1 = 0.0;
    double p2 = 0.0;
    double k3 = 0.0;

    bool bends() const {
        return k1 != 0.0 || k2 != 0.0 || p1 != 0.0 || p2 != 0.0 || k3 != 0.0;
    }
};

// Where the lens puts the ray (x, y, 1).
cv::Point2d bent(const Lens &lens, const cv::Point2d &ray);

// The ray that the lens puts there, to 1e-12; nothing when there is none on this
// side of the lens's fold, or within 80 degrees of the axis.
std::optional<cv::Point2d> unbent(const Lens &lens, const cv::Point2d &place);

} // namespace sim

#endif
