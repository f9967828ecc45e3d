// SPDX-License-Identifier: MIT
#include "placing.hpp"

#include <cmath>
#include <vector>

#include "error.hpp"

namespace cli {

namespace {

constexpr unsigned kPixelBits = 16;
constexpr unsigned kCoefficientBits = 24;

std::vector<std::string> split(const std::string &text) {
    std::vector<std::string> parts;
    std::size_t first = 0;
    while (true) {
        const std::size_t comma = text.find(',', first);
        parts.push_back(text.substr(first, comma - first));
        if (comma == std::string::npos) {
            return parts;
        }
        first = comma + 1;
    }
}

// An option's value: numbers with commas between.
class Numbers {
  public:
    Numbers(const char *option, const std::string &text, std::size_t least, std::size_t most,
            std::string expected)
        : place_(std::string(option) + " " + quoted(text) + ": "), expected_(std::move(expected)),
          parts_(split(text)) {
        if (parts_.size() < least || parts_.size() > most) {
            throw InputError(place_ + "found " + std::to_string(parts_.size()) +
                             (parts_.size() == 1 ? " value" : " values") + "; expected " +
                             expected_);
        }
    }

    // Number i, within low .. high, which `range` tells.
    std::int32_t get(std::size_t i, unsigned bits, const char *name, double low, double high,
                     const char *range) const {
        std::int32_t value = 0;
        const DecimalStatus status = parse_fixed(parts_[i], bits, value);
        if (status == DecimalStatus::kNotANumber) {
            throw InputError(place_ + "found " +
                             (parts_[i].empty() ? "nothing" : quoted(parts_[i])) + " where " +
                             name + " should be; expected " + expected_);
        }
        const double number = std::ldexp(value, -static_cast<int>(bits));
        if (status == DecimalStatus::kTooLarge || number < low || number > high) {
            throw InputError(place_ + name + " is " + parts_[i] + "; expected " + range);
        }
        return value;
    }

    std::size_t count() const {
        return parts_.size();
    }

  private:
    std::string place_;
    std::string expected_;
    std::vector<std::string> parts_;
};

void parse_camera(const std::string &text, ocel_intrinsics_t &out) {
    const Numbers numbers("--camera", text, 4, 4,
                          "four numbers fx,fy,cx,cy in pixels, such as 257.34,257.34,160,120");
    const auto focal = [&numbers](std::size_t i, const char *name) {
        return numbers.get(i, kPixelBits, name, 16, 16384, "a focal length of 16 to 16384 px");
    };
    const auto centre = [&numbers](std::size_t i, const char *name) {
        return numbers.get(i, kPixelBits, name, -OCEL_MAX_COORDINATE_PX, OCEL_MAX_COORDINATE_PX,
                           "a principal point within +-16384 px");
    };
    out.fx_px_q16 = focal(0, "fx");
    out.fy_px_q16 = focal(1, "fy");
    out.cx_px_q16 = centre(2, "cx");
    out.cy_px_q16 = centre(3, "cy");
}

void parse_distortion(const std::string &text, ocel_intrinsics_t &out) {
    const Numbers numbers("--distortion", text, 4, 5,
                          "four or five numbers k1,k2,p1,p2[,k3], such as -0.3,0.1,0,0");
    const auto coefficient = [&numbers](std::size_t i, const char *name) {
        return numbers.get(i, kCoefficientBits, name, -16, 16, "a coefficient within +-16");
    };
    out.k1_q24 = coefficient(0, "k1");
    out.k2_q24 = coefficient(1, "k2");
    out.p1_q24 = coefficient(2, "p1");
    out.p2_q24 = coefficient(3, "p2");
    out.k3_q24 = numbers.count() > 4 ? coefficient(4, "k3") : 0;
}

Length parse_radius(const std::string &text) {
    const char *const expected = "; expected the ball's radius in any unit of length, 1e-9 to 1e9, "
                                 "such as 35: the answer is in the same unit";
    Length radius;
    switch (parse_length(text, radius)) {
    case DecimalStatus::kNotANumber:
        throw InputError("--radius " + quoted(text) + ": is no number" + expected);
    case DecimalStatus::kTooLarge:
        throw InputError("--radius " + quoted(text) + ": is out of range" + expected);
    case DecimalStatus::kOk:
    default:
        return radius;
    }
}

} // namespace

void add_placing_options(CLI::App &command, PlacingArguments &arguments) {
    command.add_option("--camera", arguments.camera, "focal lengths and principal point, px")
        ->type_name("fx,fy,cx,cy");
    command
        .add_option("--radius", arguments.radius,
                    "the ball's radius, in the unit that the answer shall have")
        ->type_name("R");
    command
        .add_option("--distortion", arguments.distortion,
                    "of the lens, as OpenCV orders it: k1,k2,p1,p2[,k3]; default none")
        ->type_name("k1,k2,p1,p2[,k3]");
}

Placing::Placing(const PlacingArguments &arguments) {
    if (arguments.camera.empty()) {
        throw InputError(
            "the ball's place needs the camera: add --camera fx,fy,cx,cy (focal lengths and "
            "principal point in pixels, such as 257.34,257.34,160,120)");
    }
    if (arguments.radius.empty()) {
        throw InputError("--camera needs the ball's radius: add --radius R (in the unit that the "
                         "answer shall have, such as 35 for millimetres)");
    }
    parse_camera(arguments.camera, intrinsics_);
    if (!arguments.distortion.empty()) {
        parse_distortion(arguments.distortion, intrinsics_);
    }
    radius_ = parse_radius(arguments.radius);
}

ocel_camera_t Placing::camera(std::uint32_t width, std::uint32_t height) const {
    ocel_intrinsics_t intrinsics = intrinsics_;
    intrinsics.width = static_cast<std::uint16_t>(width);
    intrinsics.height = static_cast<std::uint16_t>(height);
    ocel_camera_t camera{};
    if (ocel_camera_init(&camera, &intrinsics) != OCEL_OK) {
        throw InputError("--camera: sees nothing of the " + std::to_string(width) + " x " +
                         std::to_string(height) +
                         " image, all of which is over 80 degrees off its axis; expected cx,cy in "
                         "pixels of that image");
    }
    return camera;
}

ocel_status_t Placing::place(const ocel_cone_t &cone, ocel_sphere_t &sphere) const {
    return ocel_sphere_of_cone(&cone, radius_.count, &sphere);
}

Json Placing::centre(const ocel_sphere_t &sphere) const {
    return Json{{"x", decimal_of_length(sphere.p_cam_u[0], radius_.unit_log2)},
                {"y", decimal_of_length(sphere.p_cam_u[1], radius_.unit_log2)},
                {"z", decimal_of_length(sphere.p_cam_u[2], radius_.unit_log2)}};
}

Json Placing::sigma(const ocel_sphere_t &sphere) const {
    const auto deviation = [this, &sphere](int at) {
        const double root = std::sqrt(static_cast<double>(sphere.cov_cam_u2[at]));
        return decimal_of_length(std::llround(std::ceil(root)), radius_.unit_log2);
    };
    return Json{{"x", deviation(OCEL_XX)}, {"y", deviation(OCEL_YY)}, {"z", deviation(OCEL_ZZ)}};
}

} // namespace cli
