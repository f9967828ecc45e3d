// SPDX-License-Identifier: MIT
#include "methods/methods.hpp"

namespace sim {

namespace {

constexpr const char *kNames[kMethodCount] = {"hough_gradient", "hough_alt", "b2ac_strict",
                                              "b2ac",           "lcse",      "edfe",
                                              "edfe_200",       "hyper",     "sphere"};

} // namespace

const char *method_name(Method method) {
    return kNames[static_cast<int>(method)];
}

std::optional<Method> method_of(const std::string &name) {
    for (int i = 0; i < kMethodCount; ++i) {
        if (name == kNames[i]) {
            return static_cast<Method>(i);
        }
    }
    return std::nullopt;
}

std::vector<std::string> method_names() {
    return {std::begin(kNames), std::end(kNames)};
}

Outline outline_of(const Ellipse &ellipse, ocel_status_t status, const Intrinsics &camera) {
    Outline outline;
    outline.status = status;
    const auto ray = pixel_ray(camera, ellipse.centre);
    if (!ray) { // far outside the picture, where the lens shows nothing
        outline.status = OCEL_OUT_OF_RANGE;
        return outline;
    }
    outline.found = true;
    outline.ellipse = ellipse;
    outline.d_cam = *ray;
    return outline;
}

Outline find_outline(Method method, const Detector &detector, std::uint64_t seed) {
    switch (method) {
    case Method::kHoughGradient:
    case Method::kHoughAlt:
        return hough_outline(method, detector);
    case Method::kB2acStrict:
    case Method::kEdfe:
    case Method::kEdfe200:
        return textbook_outline(method, detector, seed);
    case Method::kB2ac:
    case Method::kLcse:
    case Method::kHyper:
    case Method::kSphere:
    default:
        return library_outline(method, detector);
    }
}

} // namespace sim
