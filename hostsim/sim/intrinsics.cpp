// SPDX-License-Identifier: MIT
#include "intrinsics.hpp"

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

std::int32_t q16(double px) {
    return static_cast<std::int32_t>(std::lround(px * 65536.0));
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
    return {camera.fx * p_cam[0] / p_cam[2] + camera.cx,
            camera.fy * p_cam[1] / p_cam[2] + camera.cy};
}

Vec3 pixel_ray(const Intrinsics &camera, const cv::Point2d &pixel) {
    return cv::normalize(
        Vec3((pixel.x - camera.cx) / camera.fx, (pixel.y - camera.cy) / camera.fy, 1.0));
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
    intrinsics.width = static_cast<std::uint16_t>(camera.width);
    intrinsics.height = static_cast<std::uint16_t>(camera.height);
    return intrinsics;
}

} // namespace sim
