// SPDX-License-Identifier: MIT
//
// The paper's Fig. 6, redrawn.
#include <cmath>
#include <fmt/format.h>

#include "report/report_claims.hpp"
#include "report/report_curves.hpp"
#include "report/report_sections.hpp"

namespace sim {

namespace {

constexpr const char *kBars = "Points: means of the trials at that place; bars: where the middle "
                              "eight tenths of them lie. Curves at one place are drawn a little "
                              "beside each other.";

constexpr const char *kDistanceLabel = "distance from the middle of the eyes, SMU";
constexpr const char *kErrorLabel = "error of the position, SMU";
constexpr const char *kHiddenLabel = "hidden share of the ball, %";

std::string trials_words(const SweepResult &sweep) {
    return fmt::format("{} trials at each of {} points.", sweep.trials_at_a_point(),
                       sweep.points().size());
}

Plot error_plot(const Measure &measure, const std::string &name, const std::string &about) {
    Plot plot;
    plot.name = name;
    plot.about = about;
    plot.x_label = kDistanceLabel;
    plot.y_label = kErrorLabel;
    plot.log_y = true;
    plot.x_range = x_range_of(measure);
    plot.curves = mean_curves(measure);
    return plot;
}

std::string written_smu(double value) {
    return smu(value);
}

std::string written_percent(double value) {
    return std::isfinite(value) ? fmt::format("{:+.2f}", value) : "–";
}

std::string written_unsigned(double value) {
    return plain(value, 2);
}

// A picture of the run: both eyes, outlines, errors.
std::string sample_picture(const SweepResult &sweep, std::size_t point) {
    return picture_figure(
        fmt::format("{}/pictures/{}_p{:02}.png", sweep.folder(), sweep.name(), point),
        "A trial as the eyes have it, left and right, with three of the outlines drawn: "
        "<code>sphere</code> green, <code>b2ac</code> magenta, <code>hough_gradient</code> "
        "orange; below, what every method makes of it.");
}

std::string cylinder_html(const SweepResult &sweep) {
    const Measure raw{sweep, "err", 1.0};
    const Measure removed{sweep, "err_debiased", 1.0};
    Plot removed_plot = error_plot(removed, "fig6a_removed",
                                   "Error of the disc's position over distance, bias removed");
    removed_plot.levels.push_back({kDebiasedError, fmt::format("asked: {}", kDebiasedError)});
    return paragraph("A disc of negligible thickness, its face to the robot, moves away along x; "
                     "the eyes turn until it is in their middle. " +
                     trials_words(sweep)) +
           sample_picture(sweep, 0) +
           figure(error_plot(raw, "fig6a_raw", "Error of the disc's position over distance, raw"),
                  std::string("<b>Fig. 6(a), raw.</b> The distance of the place that is found from "
                              "the true one. The fits agree with each other and fall with "
                              "distance: what they show is not their error but the bias of a "
                              "slanted disc, r²/d. ") +
                      kBars) +
           measure_table(raw, "mean", "Mean error, SMU, at each distance (SMU)", written_smu) +
           figure(removed_plot,
                  "<b>Fig. 6(a), with r²/d removed.</b> The same places, moved back by the bias "
                  "of a disc that two eyes see at a slant. <code>sphere</code> is no fit for a "
                  "disc and is here for completeness.") +
           measure_table(removed, "mean", "Mean error with r²/d removed, SMU", written_smu);
}

Plot radius_plot(const Measure &measure, const std::string &name, const std::string &about) {
    Plot plot;
    plot.name = name;
    plot.about = about;
    plot.x_label = kHiddenLabel;
    plot.y_label = "error of the radius, %";
    plot.x_range = x_range_of(measure);
    plot.curves = mean_curves(measure);
    return plot;
}

Plot radius_rms_plot(const Measure &measure, const std::string &name, const std::string &about) {
    Plot plot = radius_plot(measure, name, about);
    plot.y_label = "RMS error of the radius, %";
    plot.log_y = true;
    plot.curves.clear();
    for (const char *const method : {"hough_gradient", "hough_alt", "sphere"}) {
        if (measure.sweep.has(method)) {
            plot.curves.push_back(rms_curve(measure, method));
        }
    }
    return plot;
}

std::string line_words(const SweepResult &sweep, const std::string &method) {
    return fmt::format("<code>{}</code> {} for each tenth hidden (r² {})", method,
                       percent(sweep.trend(method, "trend_radius_pct", "b") / 10.0),
                       plain(sweep.trend(method, "trend_radius_pct", "r2"), 3));
}

std::string occlusion_html(const SweepResult &sweep) {
    const Measure with_true{sweep, "radius_true_depth_err_pct", 100.0};
    const Measure with_found{sweep, "radius_err_pct", 100.0};
    Plot plot = radius_plot(with_true, "fig6b_true_depth",
                            "Error of the ball's radius over occlusion, with the true depth");
    for (const char *const method : {"b2ac", "hough_gradient", "sphere"}) {
        plot.curves.push_back(radius_trend_curve(with_true, method));
    }
    return paragraph(fmt::format("A ball at {} SMU is fixated; then a plate with a straight edge "
                                 "is moved before it until a given share is hidden from the left "
                                 "eye. ",
                                 sweep.setting("distance")) +
                     trials_words(sweep)) +
           sample_picture(sweep, sweep.points().size() * 2 / 3) +
           figure(plot, std::string("<b>Fig. 6(b), the outline's radius with the true depth.</b> "
                                    "What the outline alone does. Dashed: straight trend lines; ") +
                            line_words(sweep, "b2ac") + ", " + line_words(sweep, "sphere") + ". " +
                            kBars) +
           measure_table(with_true, "mean",
                         "Mean error of the radius, %, with the true depth, at each occlusion (%)",
                         written_percent) +
           figure(radius_plot(with_found, "fig6b_found_depth",
                              "Error of the ball's radius over occlusion, with the depth found"),
                  "<b>Fig. 6(b), with the depth that the method itself finds</b>, as the paper's "
                  "robot must: the error of the depth comes on top.") +
           folded("The same in numbers",
                  measure_table(with_found, "mean",
                                "Mean error of the radius, %, with the depth found, at each "
                                "occlusion (%)",
                                written_percent)) +
           figure(radius_rms_plot(with_found, "fig6b_rms",
                                  "RMS error of the radius, sphere beside Hough"),
                  "<b>Beside the Hough transform</b>, RMS with the depth found: a mean near "
                  "nothing hides how far Hough's circles scatter. <code>hough_alt</code> ends "
                  "where it finds no circle any more.") +
           folded("RMS in numbers, all methods",
                  measure_table(with_found, "rms",
                                "RMS error of the radius, %, with the depth found",
                                written_unsigned) +
                      measure_table(with_true, "rms",
                                    "RMS error of the radius, %, with the true depth",
                                    written_unsigned));
}

std::string trend_words(const SweepResult &sweep, const std::string &method) {
    return fmt::format("<code>{}</code> {}·exp({} d)", method,
                       brief(std::exp(sweep.trend(method, "trend_log_err", "a"))),
                       plain(sweep.trend(method, "trend_log_err", "b"), 2));
}

std::string squares_table(const SweepResult &sweep) {
    const Measure measure{sweep, "err_sq_pct", 1.0};
    std::vector<std::string> heads = point_heads(measure, "method");
    heads.push_back("all");
    Table table(sweep.name() + " err_sq_pct value",
                "The paper's unit: 100 e², the mean square error in percent of an SMU", heads);
    for (const std::string &method : sweep.methods()) {
        std::vector<std::string> cells{method};
        for (std::size_t i = 0; i < sweep.points().size(); ++i) {
            cells.push_back(brief(sweep.at(method, i, "err_sq_pct")));
        }
        cells.push_back(brief(sweep.all(method, "err_sq_pct")));
        table.add(cells);
    }
    return folded("The paper's unit, 100 e²", table.html());
}

// The encoders' reading, and what the images add to it.
std::string readings_html(const SweepResult &fixated) {
    const Measure exact{fixated, "err", 1.0};
    const Measure residual{fixated, "err_residual", 1.0};
    const Measure encoder{fixated, "err_encoder", 1.0};
    Plot plot = error_plot(exact, "fig6c_readings", "Error by three readings of the same frames");
    const auto renamed = [](Curve curve, const char *title, Ink ink) {
        curve.title = title;
        curve.ink = ink;
        return curve;
    };
    plot.curves = {
        renamed(mean_curve(encoder, "b2ac"), "encoder (eq. 14)", {"#000000", 1}),
        renamed(mean_curve(residual, "b2ac"), "b2ac encoder+residual", {"#56B4E9", 4}),
        renamed(mean_curve(exact, "b2ac"), "b2ac exact", {"#0072B2", 5}),
        renamed(mean_curve(residual, "sphere"), "sphere encoder+residual", {"#CC79A7", 12}),
        renamed(mean_curve(exact, "sphere"), "sphere exact", {"#009E73", 7, 2.6})};
    return heading("Three readings of one pair of frames") +
           paragraph("The same scenario with eyes that turn until the ball is in their middle, as "
                     "the paper's robot does. <b>encoder</b>: eq. 14 and the chain of Table 2, by "
                     "the joints alone. <b>encoder+residual</b>: its exact form, with the angle "
                     "that each image still shows. <b>exact</b>: where the two rays meet "
                     "(<code>sphere</code>: the library's own stereo, which weighs the ball's "
                     "size as well).") +
           figure(plot, "<b>The readings</b> (<code>c_fixated</code>). Once the images' residual "
                        "is used, the encoders are not what limits the result.") +
           folded("The readings in numbers",
                  measure_table(encoder, "mean", "encoder, mean error, SMU", written_smu) +
                      measure_table(residual, "mean", "encoder+residual, mean error, SMU",
                                    written_smu) +
                      measure_table(exact, "mean", "exact, mean error, SMU", written_smu));
}

std::string distance_html(const ReportData &data, const SweepResult &sweep) {
    const Measure measure{sweep, "err", 1.0};
    Plot plot = error_plot(measure, "fig6c_position", "Error of the ball's position over distance");
    for (const char *const method : {"hough_gradient", "b2ac", "sphere"}) {
        plot.curves.push_back(error_trend_curve(measure, method));
    }
    plot.levels.push_back({kSphereError, fmt::format("asked: {}", kSphereError)});
    const SweepResult *const fixated = data.sweep("c_fixated");
    return paragraph("A ball moves away from a head that keeps still. " + trials_words(sweep) +
                     fmt::format(" A choice of ours: the eyes rest on a place {} SMU straight "
                                 "ahead, so that the ball is seen off the middle of both images, "
                                 "where perspective shifts the middle of its outline.",
                                 sweep.setting("focus"))) +
           sample_picture(sweep, 0) +
           figure(plot, std::string("<b>Fig. 6(c).</b> Dashed: exponential trend lines as in the "
                                    "paper, log e = a + b d by least squares over the means; ") +
                            trend_words(sweep, "hough_gradient") + ", " +
                            trend_words(sweep, "b2ac") + ", " + trend_words(sweep, "sphere") +
                            " SMU. " + kBars) +
           measure_table(measure, "mean", "Mean error, SMU, at each distance (SMU)", written_smu) +
           squares_table(sweep) +
           folded("By the encoders and the images' residual",
                  measure_table({sweep, "err_residual", 1.0}, "mean",
                                "encoder+residual, mean error, SMU (the encoders alone say where "
                                "the eyes rest, not where the ball is)",
                                written_smu)) +
           (fixated != nullptr ? readings_html(*fixated) : absent(data, "c_fixated"));
}

} // namespace

Section cylinder_section(const ReportData &data) {
    const SweepResult *const sweep = data.sweep("a_cylinder");
    return {"fig6a", "Fig. 6(a): a disc's position",
            sweep != nullptr ? cylinder_html(*sweep) : absent(data, "a_cylinder")};
}

Section occlusion_section(const ReportData &data) {
    const SweepResult *const sweep = data.sweep("b_occlusion");
    return {"fig6b", "Fig. 6(b): a hidden ball's radius",
            sweep != nullptr ? occlusion_html(*sweep) : absent(data, "b_occlusion")};
}

Section distance_section(const ReportData &data) {
    const SweepResult *const sweep = data.sweep("c_distance");
    return {"fig6c", "Fig. 6(c): a ball's position",
            sweep != nullptr ? distance_html(data, *sweep) : absent(data, "c_distance")};
}

} // namespace sim
