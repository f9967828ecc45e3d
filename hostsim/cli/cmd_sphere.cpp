// SPDX-License-Identifier: MIT
//
// ocellus sphere: a ball in space from points of its outline.
#include <memory>

#include <ocellus/cone.h>

#include "commands.hpp"
#include "csv.hpp"
#include "decimal.hpp"
#include "json_out.hpp"
#include "placing.hpp"

namespace cli {

namespace {

struct SphereArguments {
    PlacingArguments placing;
    std::string path;
};

constexpr const char *kFooter =
    R"(Fits the cone of rays that touch the ball to points of its outline, in any order,
without those that lie on what hides it, and places the ball by its radius.
POINTS.csv: as `ocellus fit --help` tells; - is stdin. Pixels more than 80 degrees
off the camera's axis are out of range.

Output: status, x, y, z, inliers, n, rms_px, arc_coverage, sigma:{x,y,z}
x right, y down, z forward of the camera, and sigma, their standard deviations, in
the radius' unit; inliers of the n points lie on the outline, rms_px is their distance
from it, arc_coverage (0..1) how much of its turn they cover. A centre is there for ok,
and for partial: an estimate from too short an arc or too few points.

Examples:
  ocellus sphere --camera 257.34,257.34,160,120 --radius 33.1 outline.csv
  ocellus sphere --camera 536,536,342,235 --distortion -0.265,-0.047,0.002,0,0.25 \
      --radius 0.035 outline.csv)";

int run_sphere(const SphereArguments &arguments) {
    const Placing placing(arguments.placing);
    const ocel_camera_t camera = placing.camera(0, 0);
    const std::vector<ocel_point_t> points = read_points(arguments.path);
    ocel_cone_t cone{};
    ocel_sphere_t sphere{};
    ocel_status_t status = ocel_cone_fit_points(&camera, points.data(), points.size(), &cone);
    const bool fitted = status == OCEL_OK || status == OCEL_PARTIAL;
    const ocel_status_t placed = fitted ? placing.place(cone, sphere) : status;
    status = placed == OCEL_OK ? status : placed;
    const int exit_code = exit_code_of(status);
    Json object{{"status", ocel_status_name(status)}};
    if (placed == OCEL_OK) {
        object.update(placing.centre(sphere));
        object["inliers"] = cone.inlier_count;
    }
    object["n"] = points.size();
    if (placed == OCEL_OK) {
        object["rms_px"] = decimal_of_q16(cone.rms_px_q16);
        object["arc_coverage"] = decimal_of_q16(cone.arc_coverage_q16);
        object["sigma"] = placing.sigma(sphere);
    }
    print_line(object);
    return exit_code;
}

} // namespace

void add_sphere(CLI::App &app, int &exit_code) {
    const auto arguments = std::make_shared<SphereArguments>();
    CLI::App *const command =
        app.add_subcommand("sphere", "Place a ball in space from points of its outline");
    command->footer(kFooter);
    add_placing_options(*command, arguments->placing);
    command->add_option("POINTS.csv", arguments->path, "the points; - is stdin")
        ->type_name("")
        ->required();
    command->callback([arguments, &exit_code] { exit_code = run_sphere(*arguments); });
}

} // namespace cli
