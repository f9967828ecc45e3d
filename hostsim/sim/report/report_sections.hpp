// SPDX-License-Identifier: MIT
//
// The report's sections.  Every figure in their words is taken from the data.
#ifndef OCELLUS_SIM_REPORT_SECTIONS_HPP
#define OCELLUS_SIM_REPORT_SECTIONS_HPP

#include "report/report_data.hpp"
#include "report/report_text.hpp"

namespace sim {

Section summary_section(const ReportData &data);
Section setting_section(const ReportData &data);
Section cylinder_section(const ReportData &data);  // Fig. 6(a)
Section occlusion_section(const ReportData &data); // Fig. 6(b)
Section distance_section(const ReportData &data);  // Fig. 6(c)
Section threshold_section(const ReportData &data); // Table 3
Section failure_section(const ReportData &data);
Section why_section(const ReportData &data);
Section tracking_section(const ReportData &data);
Section files_section(const ReportData &data);

// In place of what a file is missing for.
std::string absent(const ReportData &data, const std::string &name);

} // namespace sim

#endif
