// SPDX-License-Identifier: MIT
//
// report.html: what was asked, what came out, and why.
#ifndef OCELLUS_SIM_REPORT_HPP
#define OCELLUS_SIM_REPORT_HPP

#include <string>

namespace sim {

// What paper puts into its folder, beside a folder for each track_*: the paper's
// scenarios, two variants of c that explain its figures, the threshold table and how
// long things took.
constexpr const char *kSweepNames[] = {"a_cylinder", "b_occlusion", "c_distance", "c_fixated",
                                       "c_stretched"};
constexpr const char *kThresholdFile = "table3.json";
constexpr const char *kClockFile = "clock.json"; // alone differs from run to run

// Makes DIR/report.html from what lies in DIR; tells on stderr what is missing, and so
// does the page.  Returns its path.  cli::InputError when there is nothing to report on,
// a file is damaged or there is no gnuplot.
std::string write_report(const std::string &folder);

} // namespace sim

#endif
