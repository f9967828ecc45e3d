// SPDX-License-Identifier: MIT
//
// ocellus fit: an ellipse through points.
#include <memory>

#include <ocellus/fit.h>

#include "commands.hpp"
#include "csv.hpp"
#include "decimal.hpp"
#include "error.hpp"
#include "json_out.hpp"

namespace cli {

namespace {

struct FitArguments {
    std::string method = "b2ac";
    std::string perturb = "auto";
    std::string path;
};

constexpr const char *kFooter =
    R"(POINTS.csv: one point a line, x,y in pixels, decimals with a point. Blank lines,
lines that start with # and one header line x,y are skipped. - is stdin.
Coordinates are rounded to 1/65536 px and must lie within +-16384 px.

Methods:
  b2ac   direct least squares with 4ac - b^2 = 1 (Fitzgibbon), closed form
  lcse   the same, on points that are perturbed when the fit is unstable
  hyper  bias-corrected: for short arcs and noisy points

Output: status, method, cx, cy, a, b, angle_deg, rms_px, n, perturbed
An ellipse is there for ok, and for partial: an arc too short for its noise;
partial adds centre_sigma_px, how far the centre may be off.

Examples:
  ocellus fit points.csv
  ocellus fit --method lcse --perturb always points.csv
  printf '0,5\n5,0\n0,-5\n-5,0\n4,3\n3,-4\n' | ocellus fit -)";

Json json_of_fit(ocel_status_t status, const ocel_fit_options_t &options,
                 const ocel_ellipse_t &ellipse, std::size_t count) {
    const bool has_ellipse = status == OCEL_OK || status == OCEL_PARTIAL;
    Json object{{"status", ocel_status_name(status)}, {"method", method_name(options.method)}};
    if (has_ellipse) {
        add_ellipse(object, ellipse);
        add_quality(object, status, ellipse);
    }
    object["n"] = count;
    if (has_ellipse) {
        object["perturbed"] = ellipse.perturbed;
    }
    return object;
}

int run_fit(const FitArguments &arguments) {
    ocel_fit_options_t options{};
    options.method = parse_method(arguments.method);
    options.perturb = parse_perturb(arguments.perturb);
    const std::vector<ocel_point_t> points = read_points(arguments.path);
    ocel_ellipse_t ellipse{};
    const ocel_status_t status = ocel_fit_points(points.data(), points.size(), &options, &ellipse);
    const int exit_code = exit_code_of(status);
    print_line(json_of_fit(status, options, ellipse, points.size()));
    return exit_code;
}

} // namespace

ocel_fit_method_t parse_method(const std::string &name, const char *expected) {
    for (const ocel_fit_method_t method : {OCEL_FIT_B2AC, OCEL_FIT_LCSE, OCEL_FIT_HYPER}) {
        if (name == method_name(method)) {
            return method;
        }
    }
    if (name == "sphere") {
        throw InputError("--method sphere: fits a ball and no ellipse; expected b2ac, lcse or "
                         "hyper, or the command ocellus sphere");
    }
    throw InputError("--method " + quoted(name) + ": expected " + expected);
}

ocel_perturb_t parse_perturb(const std::string &name) {
    if (name == "auto") {
        return OCEL_PERTURB_AUTO;
    }
    if (name == "always") {
        return OCEL_PERTURB_ALWAYS;
    }
    if (name == "never") {
        return OCEL_PERTURB_NEVER;
    }
    throw InputError("--perturb " + quoted(name) + ": expected auto, always or never");
}

void add_fit(CLI::App &app, int &exit_code) {
    const auto arguments = std::make_shared<FitArguments>();
    CLI::App *const command = app.add_subcommand("fit", "Fit an ellipse to points");
    command->footer(kFooter);
    command->add_option("--method", arguments->method, "b2ac (default), lcse or hyper")
        ->type_name("NAME");
    command
        ->add_option("--perturb", arguments->perturb,
                     "when lcse perturbs the points: auto (default), always or never")
        ->type_name("WHEN");
    command->add_option("POINTS.csv", arguments->path, "the points; - is stdin")
        ->type_name("")
        ->required();
    command->callback([arguments, &exit_code] { exit_code = run_fit(*arguments); });
}

} // namespace cli
