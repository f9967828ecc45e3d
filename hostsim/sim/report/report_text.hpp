// SPDX-License-Identifier: MIT
//
// How the report writes its figures, and how it draws its methods.
#ifndef OCELLUS_SIM_REPORT_TEXT_HPP
#define OCELLUS_SIM_REPORT_TEXT_HPP

#include <string>

#include "report/plot.hpp"
#include "report/report_page.hpp"

namespace sim {

// What does not exist is a dash.
std::string smu(double value);     // 4 decimals
std::string percent(double value); // signed, 2 decimals, with its sign
std::string brief(double value);   // 2 digits that count
std::string plain(double value, int decimals);

Ink ink_of_method(const std::string &method);

// What a method is, in a line.
const char *about_method(const std::string &method);

} // namespace sim

#endif
