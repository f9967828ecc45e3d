// SPDX-License-Identifier: MIT
//
// The options of the commands that place a ball in space, and what they make of
// a cone.
#ifndef OCELLUS_CLI_PLACING_HPP
#define OCELLUS_CLI_PLACING_HPP

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>

#include <ocellus/sphere.h>

#include "decimal.hpp"
#include "json_out.hpp"

namespace cli {

struct PlacingArguments {
    std::string camera;
    std::string distortion;
    std::string radius;
};

// Adds --camera, --radius and --distortion.
void add_placing_options(CLI::App &command, PlacingArguments &arguments);

// A camera and a ball of known radius.  The library's unit of length is a power of two
// of the user's, such that the radius has 20 bits: the range then reaches to a thousand
// radii, in steps of a millionth of one.
class Placing {
  public:
    // InputError for what is missing, no number, or out of range.
    explicit Placing(const PlacingArguments &arguments);

    // For images of this size; 0, 0: any.
    ocel_camera_t camera(std::uint32_t width, std::uint32_t height) const;

    // ocel_sphere_of_cone with the ball's radius.
    ocel_status_t place(const ocel_cone_t &cone, ocel_sphere_t &sphere) const;

    // {x, y, z} of the centre, and of its standard deviations, in the user's unit.
    Json centre(const ocel_sphere_t &sphere) const;
    Json sigma(const ocel_sphere_t &sphere) const;

  private:
    ocel_intrinsics_t intrinsics_{};
    Length radius_{};
};

} // namespace cli

#endif
