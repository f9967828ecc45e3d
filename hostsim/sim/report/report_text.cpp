// SPDX-License-Identifier: MIT
#include "report/report_text.hpp"

#include <cmath>
#include <fmt/format.h>

namespace sim {

namespace {

// Okabe and Ito's colours, which the colour-blind can tell apart, and a marker each.
struct MethodLook {
    const char *name;
    Ink ink;
    const char *about;
};

constexpr MethodLook kLooks[] = {
    {"hough_gradient",
     {"#D55E00", 9},
     "OpenCV's Hough transform for circles, its threshold searched for each frame"},
    {"hough_alt",
     {"#E69F00", 8},
     "OpenCV's second Hough transform (HOUGH_GRADIENT_ALT), the same way"},
    {"b2ac_strict",
     {"#7f7f7f", 2},
     "the textbook's fit: 6×6 eigenproblem in double, on the outermost pixels inside the ball"},
    {"b2ac",
     {"#0072B2", 5},
     "the library's closed form of that fit, in integers, on the midpoints between an inside and "
     "an outside pixel"},
    {"lcse",
     {"#56B4E9", 4},
     "the paper's fit, the library's: b2ac, perturbed only where the solution is unstable"},
    {"edfe", {"#CC79A7", 12}, "Maini's fit: b2ac_strict averaged over 50 noisy copies"},
    {"edfe_200", {"#882255", 13}, "the same over 200 copies"},
    {"hyper", {"#000000", 1}, "the library's bias-corrected ellipse fit"},
    {"sphere",
     {"#009E73", 7, 2.6},
     "the library's robust fit of the cone of rays that touch the ball"}};

const MethodLook *look_of(const std::string &method) {
    for (const MethodLook &look : kLooks) {
        if (method == look.name) {
            return &look;
        }
    }
    return nullptr;
}

} // namespace

std::string plain(double value, int decimals) {
    return std::isfinite(value) ? fmt::format("{:.{}f}", value, decimals) : "–";
}

std::string smu(double value) {
    return plain(value, 4);
}

std::string brief(double value) {
    return std::isfinite(value) ? fmt::format("{:.2g}", value) : "–";
}

std::string percent(double value) {
    return std::isfinite(value) ? fmt::format("{:+.2f} %", value) : "–";
}

Ink ink_of_method(const std::string &method) {
    const MethodLook *const look = look_of(method);
    return look == nullptr ? Ink{"#000000", 3} : look->ink;
}

const char *about_method(const std::string &method) {
    const MethodLook *const look = look_of(method);
    return look == nullptr ? "" : look->about;
}

} // namespace sim
