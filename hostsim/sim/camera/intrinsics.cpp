// SPDX-License-Identifier: MIT
#include "camera/intrinsics.hpp"

#include "error.hpp"

namespace sim {

namespace {

// Focal lengths for a picture of 320 x 240.
struct Preset {
    const char *name;
    double fx;
    double fy;
};

// 120 px / tan(half the vertical angle) is 257.341 and 156.387; the stretched
// cameras have fx = 4/3 fy.
constexpr Preset kPresets[] = {{"icub-2010", 257.3408304, 257.3408304},
                               {"icub-2010-06", 343.1211072, 257.3408304},
                               {"icub-2009", 208.5160597, 156.3870447}};

constexpr int kOutlinePoints = 512;

std::int32_t q16(double px) {
    return static_cast<std::int32_t>(std::lround(px * 65536.0));
}

std::int32_t q24(double coefficient) {
    return static_cast<std::int32_t>(std::lround(coefficient * 16777216.0));
}

// Points where rays touch the sphere: a circle across the line to its centre.
std::vector<cv::Point2d> outline_points(const Intrinsics &camera, const Vec3 &p_cam,
                                        double radius) {
    const double range_sq = p_cam.dot(p_cam);
    const Vec3 middle = p_cam * (1.0 - radius * radius / range_sq);
    const double reach = radius * std::sqrt(1.0 - radius * radius / range_sq);
    const Vec3 right = cv::normalize(Vec3(p_cam[2], 0.0, -p_cam[0]));
    const Vec3 down = cv::normalize(p_cam.cross(right));
    std::vector<cv::Point2d> points;
    for (int i = 0; i < kOutlinePoints; ++i) {
        const double turn = 2.0 * kPi * i / kOutlinePoints;
        const Vec3 off = (right * std::cos(turn) + down * std::sin(turn)) * reach;
        points.push_back(project(camera, middle + off));
    }
    return points;
}

} // namespace

std::vector<std::string> preset_names() {
    std::vector<std::string> names;
    for (const Preset &preset : kPresets) {
        names.emplace_back(preset.name);
    }
    return names;
}

Intrinsics make_intrinsics(const std::string &preset, int width) {
    const int height = width * 3 / 4;
    const double scale = width / 320.0;
    for (const Preset &candidate : kPresets) {
        if (preset == candidate.name) {
            return {candidate.fx * scale,
                    candidate.fy * scale,
                    (width - 1) / 2.0,
                    (height - 1) / 2.0,
                    width,
                    height};
        }
    }
    throw cli::InputError("no camera preset " + cli::quoted(preset));
}

cv::Point2d project(const Intrinsics &camera, const Vec3 &p_cam) {
    const cv::Point2d place = bent(camera.lens, {p_cam[0] / p_cam[2], p_cam[1] / p_cam[2]});
    return {camera.fx * place.x + camera.cx, camera.fy * place.y + camera.cy};
}

std::optional<Vec3> pixel_ray(const Intrinsics &camera, const cv::Point2d &pixel) {
    const auto ray =
        unbent(camera.lens, {(pixel.x - camera.cx) / camera.fx, (pixel.y - camera.cy) / camera.fy});
    return ray ? std::optional(cv::normalize(Vec3(ray->x, ray->y, 1.0))) : std::nullopt;
}

std::optional<cv::Point> pixel_without_ray(const Intrinsics &camera) {
    for (int y = 0; y < camera.height; ++y) {
        const bool whole = y == 0 || y == camera.height - 1;
        for (int x = 0; x < camera.width; x += whole ? 1 : camera.width - 1) {
            if (!pixel_ray(camera, cv::Point2d(x, y))) {
                return cv::Point(x, y);
            }
        }
    }
    return std::nullopt;
}

std::optional<Ellipse> seen_outline(const Intrinsics &camera, const Vec3 &p_cam, double radius) {
    const auto straight = outline_of_sphere(camera_matrix(camera), p_cam, radius);
    if (!camera.lens.bends() || !straight) {
        return straight;
    }
    return ellipse_of_polygon(outline_points(camera, p_cam, radius));
}

Mat3 camera_matrix(const Intrinsics &camera) {
    return {camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1};
}

ocel_intrinsics_t library_intrinsics(const Intrinsics &camera) {
    ocel_intrinsics_t intrinsics{};
    intrinsics.fx_px_q16 = q16(camera.fx);
    intrinsics.fy_px_q16 = q16(camera.fy);
    intrinsics.cx_px_q16 = q16(camera.cx);
    intrinsics.cy_px_q16 = q16(camera.cy);
    intrinsics.k1_q24 = q24(camera.lens.k1);
    intrinsics.k2_q24 = q24(camera.lens.k2);
    intrinsics.p1_q24 = q24(camera.lens.p1);
    intrinsics.p2_q24 = q24(camera.lens.p2);
    intrinsics.k3_q24 = q24(camera.lens.k3);
    intrinsics.width = static_cast<std::uint16_t>(camera.width);
    intrinsics.height = static_cast<std::uint16_t>(camera.height);
    return intrinsics;
}

} // namespace sim
