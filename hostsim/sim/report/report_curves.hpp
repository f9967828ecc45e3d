// SPDX-License-Identifier: MIT
//
// A sweep as curves and tables.
#ifndef OCELLUS_SIM_REPORT_CURVES_HPP
#define OCELLUS_SIM_REPORT_CURVES_HPP

#include "report/report_data.hpp"
#include "report/report_text.hpp"

namespace sim {

// One column of a sweep.  Occlusions are drawn and written in percent.
struct Measure {
    const SweepResult &sweep;
    std::string column;
    double x_scale; // 100 where x is a share, else 1
};

// The mean at each point, and where the middle eight tenths of the trials lie.
Curve mean_curve(const Measure &measure, const std::string &method);

// All methods'.
std::vector<Curve> mean_curves(const Measure &measure);

// The RMS at each point.
Curve rms_curve(const Measure &measure, const std::string &method);

// exp(a + b x), the paper's trend line of a method's error.
Curve error_trend_curve(const Measure &measure, const std::string &method);

// a + b x, of the radius's.
Curve radius_trend_curve(const Measure &measure, const std::string &method);

// A row a method, a column a point, and all points together.  Its key is the scenario,
// the column and the statistic.
std::string measure_table(const Measure &measure, const std::string &statistic,
                          const std::string &caption, std::string (*written)(double));

// The points as heads of columns, after `first`.
std::vector<std::string> point_heads(const Measure &measure, const std::string &first);

// From the first to the last point, a little more on both sides.
PlotSpan x_range_of(const Measure &measure);

} // namespace sim

#endif
