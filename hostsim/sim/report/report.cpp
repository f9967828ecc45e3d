// SPDX-License-Identifier: MIT
#include "report/report.hpp"

#include <fmt/format.h>

#include "error.hpp"
#include "report/report_sections.hpp"
#include "trials/results.hpp"

namespace sim {

namespace {

constexpr const char *kTitle = "Ocellus in the simulator: a paper's experiments rerun, explained, "
                               "beaten";

std::string lead() {
    return paragraph("In 2011 Greggio and others let a simulated iCub look for a ball and compared "
                     "fits of ellipses with the Hough transform (<i>Real-time ellipse fitting, 3D "
                     "spherical object localization, and tracking for the iCub simulator</i>, "
                     "ICINCO 2011). This page reruns their experiments, beside a library that does "
                     "the same in integers for a microcontroller, and against the truth.");
}

} // namespace

std::string write_report(const std::string &folder) {
    require_gnuplot();
    const ReportData data = read_report_data(folder);
    for (const std::string &line : data.missing) {
        cli::note(line);
    }
    const std::string path = folder + "/report.html";
    write_text(path, page(kTitle, lead(),
                          {summary_section(data), setting_section(data), cylinder_section(data),
                           occlusion_section(data), distance_section(data), threshold_section(data),
                           failure_section(data), why_section(data), tracking_section(data),
                           files_section(data)}));
    return path;
}

} // namespace sim
