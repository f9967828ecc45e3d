// SPDX-License-Identifier: MIT
#include "geometry/ellipse.hpp"

namespace sim {

EllipseAxes axes_of(const Ellipse &ellipse) {
    const double p = ellipse.shape(0, 0);
    const double q = ellipse.shape(0, 1);
    const double r = ellipse.shape(1, 1);
    const double mean = (p + r) / 2.0;
    const double spread = std::hypot((p - r) / 2.0, q);
    double angle = std::atan2(2.0 * q, p - r) / 2.0;
    if (angle < 0.0) {
        angle += kPi;
    }
    return {std::sqrt(mean + spread), std::sqrt(std::max(mean - spread, 0.0)), angle};
}

std::optional<Ellipse> ellipse_of_conic(const Mat3 &conic) {
    const cv::Matx22d quadratic(conic(0, 0), conic(0, 1), conic(1, 0), conic(1, 1));
    const double determinant = cv::determinant(quadratic);
    if (!(determinant > 0.0)) {
        return std::nullopt;
    }
    const cv::Matx22d inverse = quadratic.inv();
    const cv::Vec2d centre = -(inverse * cv::Vec2d(conic(0, 2), conic(1, 2)));
    const double rest = conic(0, 2) * centre[0] + conic(1, 2) * centre[1] + conic(2, 2);
    const cv::Matx22d shape = inverse * -rest;
    if (!(shape(0, 0) > 0.0) || !(shape(1, 1) > 0.0)) {
        return std::nullopt;
    }
    return Ellipse{{centre[0], centre[1]}, shape};
}

std::optional<Ellipse> outline_of_sphere(const Mat3 &camera_matrix, const Vec3 &p_cam,
                                         double radius) {
    if (p_cam[2] <= radius) {
        return std::nullopt;
    }
    const double tangent_sq = p_cam.dot(p_cam) - radius * radius;
    const Mat3 cone = p_cam * p_cam.t() - Mat3::eye() * tangent_sq;
    const Mat3 to_ray = camera_matrix.inv();
    return ellipse_of_conic(to_ray.t() * cone * to_ray);
}

// Green's theorem, about the first point so that no digits are lost.
Ellipse ellipse_of_polygon(const std::vector<cv::Point2d> &points) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const cv::Point2d a = points[i] - points[0];
        const cv::Point2d b = points[(i + 1) % points.size()] - points[0];
        const double twice = a.cross(b);
        n += twice / 2.0;
        x += twice * (a.x + b.x) / 6.0;
        y += twice * (a.y + b.y) / 6.0;
        xx += twice * (a.x * a.x + a.x * b.x + b.x * b.x) / 12.0;
        xy += twice * (2.0 * a.x * a.y + a.x * b.y + b.x * a.y + 2.0 * b.x * b.y) / 24.0;
        yy += twice * (a.y * a.y + a.y * b.y + b.y * b.y) / 12.0;
    }
    x /= n;
    y /= n;
    const cv::Matx22d variance(xx / n - x * x, xy / n - x * y, xy / n - x * y, yy / n - y * y);
    return {points[0] + cv::Point2d(x, y), variance * 4.0};
}

Ellipse ellipse_of(const ocel_ellipse_t &ellipse) {
    const double angle = ellipse.angle_turn_q32 * (2.0 * kPi / 4294967296.0);
    const double a = ellipse.a_px_q16 / 65536.0;
    const double b = ellipse.b_px_q16 / 65536.0;
    const cv::Matx22d turn(std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle));
    return {{ellipse.cx_px_q16 / 65536.0, ellipse.cy_px_q16 / 65536.0},
            turn * cv::Matx22d(a * a, 0, 0, b * b) * turn.t()};
}

} // namespace sim
