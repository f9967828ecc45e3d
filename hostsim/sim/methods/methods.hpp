// SPDX-License-Identifier: MIT
//
// The methods side by side: each finds the ball's outline in one frame.
#ifndef OCELLUS_SIM_METHODS_HPP
#define OCELLUS_SIM_METHODS_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <ocellus/cone.h>
#include <ocellus/status.h>

#include "geometry/ellipse.hpp"
#include "methods/detector.hpp"

namespace sim {

enum class Method {
    kHoughGradient = 0, // OpenCV's, on the mask, with the highest threshold that finds a circle
    kHoughAlt,          // the same with HOUGH_GRADIENT_ALT
    kB2acStrict,        // the textbook's 6x6 eigenproblem, on the mask's inner boundary pixels
    kB2ac,              // the library's, on crack midpoints, as the four below
    kLcse,
    kEdfe,    // Maini's, 50 resamplings, on the inner boundary pixels
    kEdfe200, // 200 of them
    kHyper,
    kSphere // the library's robust cone of rays
};

constexpr int kMethodCount = 9;

const char *method_name(Method method);

// The method of that name, if there is one.
std::optional<Method> method_of(const std::string &name);

std::vector<std::string> method_names();

// What a method found in a frame.
struct Outline {
    ocel_status_t status = OCEL_NOT_SEEN;
    bool found = false;
    Ellipse ellipse; // the outline; the image of the cone for kSphere
    Vec3 d_cam;      // unit vector towards what the method takes for the ball's centre
    bool has_cone = false;
    ocel_cone_t cone{};
    int votes = 0; // Hough: the threshold that was found (of 100 for kHoughAlt)
};

// `seed` is for the methods that draw by chance.
Outline find_outline(Method method, const Detector &detector, std::uint64_t seed);

// The kinds, one file each.
Outline library_outline(Method method, const Detector &detector);
Outline hough_outline(Method method, const Detector &detector);
Outline textbook_outline(Method method, const Detector &detector, std::uint64_t seed);

// An outline whose centre is taken for the image of the ball's centre.
Outline outline_of(const Ellipse &ellipse, ocel_status_t status, const Intrinsics &camera);

} // namespace sim

#endif
