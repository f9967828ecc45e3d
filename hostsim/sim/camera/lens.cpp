// SPDX-License-Identifier: MIT
#include "camera/lens.hpp"

#include <cmath>
#include <opencv2/core.hpp>

namespace sim {

namespace {

constexpr double kFarthest = 5.671; // tan 80 degrees
constexpr int kSteps = 50;
constexpr double kLeft = 1e-12;

// The radial factor.
double factor(const Lens &lens, double s) {
    return 1.0 + s * (lens.k1 + s * (lens.k2 + s * lens.k3));
}

// Its derivative by s = r^2.
double factor_slope(const Lens &lens, double s) {
    return lens.k1 + s * (2.0 * lens.k2 + s * 3.0 * lens.k3);
}

// How the place moves with the ray; symmetric.
cv::Matx22d jacobian(const Lens &lens, const cv::Point2d &ray) {
    const double s = ray.dot(ray);
    const double slope = 2.0 * factor_slope(lens, s);
    const double even = factor(lens, s) + 2.0 * (lens.p1 * ray.y + lens.p2 * ray.x);
    const double mixed = slope * ray.x * ray.y + 2.0 * (lens.p1 * ray.x + lens.p2 * ray.y);
    return {even + slope * ray.x * ray.x + 4.0 * lens.p2 * ray.x, mixed, mixed,
            even + slope * ray.y * ray.y + 4.0 * lens.p1 * ray.y};
}

// No fold between the axis and the ray: the map's determinant is positive all the
// way.
bool before_fold(const Lens &lens, const cv::Point2d &ray) {
    constexpr int kParts = 16;
    bool before = std::hypot(ray.x, ray.y) <= kFarthest;
    for (int i = 1; before && i <= kParts; ++i) {
        const cv::Point2d part = ray * (static_cast<double>(i) / kParts);
        before = cv::determinant(jacobian(lens, part)) > 0.0 && factor(lens, part.dot(part)) > 0.0;
    }
    return before;
}

} // namespace

cv::Point2d bent(const Lens &lens, const cv::Point2d &ray) {
    const double s = ray.dot(ray);
    const double f = factor(lens, s);
    const double xy = 2.0 * ray.x * ray.y;
    return {ray.x * f + lens.p1 * xy + lens.p2 * (s + 2.0 * ray.x * ray.x),
            ray.y * f + lens.p1 * (s + 2.0 * ray.y * ray.y) + lens.p2 * xy};
}

// Newton's method, at first with the radial factor for a Jacobian: from there no
// lens of practice overshoots.
std::optional<cv::Point2d> unbent(const Lens &lens, const cv::Point2d &place) {
    cv::Point2d ray = place * (1.0 / factor(lens, place.dot(place)));
    for (int i = 0; i < kSteps && std::hypot(ray.x, ray.y) < 2.0 * kFarthest; ++i) {
        const cv::Point2d off = place - bent(lens, ray);
        if (std::hypot(off.x, off.y) < kLeft) {
            return before_fold(lens, ray) ? std::optional(ray) : std::nullopt;
        }
        const cv::Vec2d step = jacobian(lens, ray).inv() * cv::Vec2d(off.x, off.y);
        ray += cv::Point2d(step[0], step[1]);
    }
    return std::nullopt;
}

} // namespace sim
