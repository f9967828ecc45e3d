// SPDX-License-Identifier: MIT
#include "report/report_curves.hpp"

#include <cmath>
#include <fmt/format.h>

namespace sim {

namespace {

constexpr int kTrendSteps = 40;

Curve trend_curve(const Measure &measure, const std::string &method, const std::string &which,
                  double (*shape)(double)) {
    const double a = measure.sweep.trend(method, which, "a");
    const double b = measure.sweep.trend(method, which, "b");
    Ink ink = ink_of_method(method);
    ink.width = 1.3;
    Curve curve{"", ink, Stroke::kDashed, {}};
    const double from = measure.sweep.points().front();
    const double to = measure.sweep.points().back();
    for (int i = 0; i <= kTrendSteps; ++i) {
        const double x = from + (to - from) * i / kTrendSteps;
        curve.points.push_back({x * measure.x_scale, shape(a + b * x)});
    }
    return curve;
}

double same(double value) {
    return value;
}

double exponential(double value) {
    return std::exp(value);
}

} // namespace

Curve mean_curve(const Measure &measure, const std::string &method) {
    Curve curve{method, ink_of_method(method), Stroke::kMarks, {}};
    for (std::size_t i = 0; i < measure.sweep.points().size(); ++i) {
        const auto value = [&](const char *statistic) {
            return measure.sweep.at(method, i, measure.column, statistic);
        };
        curve.points.push_back({measure.sweep.points()[i] * measure.x_scale, value("mean"),
                                value("p10"), value("p90")});
    }
    return curve;
}

std::vector<Curve> mean_curves(const Measure &measure) {
    std::vector<Curve> curves;
    for (const std::string &method : measure.sweep.methods()) {
        curves.push_back(mean_curve(measure, method));
    }
    return curves;
}

Curve rms_curve(const Measure &measure, const std::string &method) {
    Curve curve{method, ink_of_method(method), Stroke::kMarks, {}};
    for (std::size_t i = 0; i < measure.sweep.points().size(); ++i) {
        const double rms = measure.sweep.at(method, i, measure.column, "rms");
        curve.points.push_back({measure.sweep.points()[i] * measure.x_scale, rms, rms, rms});
    }
    return curve;
}

Curve error_trend_curve(const Measure &measure, const std::string &method) {
    return trend_curve(measure, method, "trend_log_err", exponential);
}

Curve radius_trend_curve(const Measure &measure, const std::string &method) {
    return trend_curve(measure, method, "trend_radius_pct", same);
}

std::vector<std::string> point_heads(const Measure &measure, const std::string &first) {
    std::vector<std::string> heads{first};
    for (const double point : measure.sweep.points()) {
        heads.push_back(fmt::format("{:.4g}", point * measure.x_scale));
    }
    return heads;
}

std::string measure_table(const Measure &measure, const std::string &statistic,
                          const std::string &caption, std::string (*written)(double)) {
    std::vector<std::string> heads = point_heads(measure, "method");
    heads.push_back("all");
    Table table(measure.sweep.name() + " " + measure.column + " " + statistic, caption, heads);
    for (const std::string &method : measure.sweep.methods()) {
        std::vector<std::string> cells{method};
        for (std::size_t i = 0; i < measure.sweep.points().size(); ++i) {
            cells.push_back(written(measure.sweep.at(method, i, measure.column, statistic)));
        }
        cells.push_back(written(measure.sweep.all(method, measure.column, statistic)));
        table.add(cells);
    }
    return table.html();
}

PlotSpan x_range_of(const Measure &measure) {
    const double from = measure.sweep.points().front() * measure.x_scale;
    const double to = measure.sweep.points().back() * measure.x_scale;
    const double margin = std::max(0.03 * (to - from), 0.01);
    return {from - margin, to + margin};
}

} // namespace sim
