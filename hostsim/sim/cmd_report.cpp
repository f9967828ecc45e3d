// SPDX-License-Identifier: MIT
//
// ocellus-sim report: the page, from what lies in a folder.
#include <fmt/format.h>
#include <memory>

#include "commands.hpp"
#include "report/report.hpp"

namespace sim {

namespace {

constexpr const char *kFooter =
    R"(DIR is one that `ocellus-sim paper --out DIR` has filled, or of the same make:
a_cylinder/, b_occlusion/, c_distance/, c_fixated/, c_stretched/ as `run` leaves
them, table3.json, and track_*/ as `track` leaves them. What is missing is told
on stderr and in the page, with the command that makes it. The page needs no
other file; it links to those beside it.

Example:
  ocellus-sim report build/paper)";

} // namespace

void add_report(CLI::App &app) {
    const auto folder = std::make_shared<std::string>();
    CLI::App *const command =
        app.add_subcommand("report", "Make report.html from a folder of results");
    command->footer(kFooter);
    command->add_option("DIR", *folder, "the folder of results")->required();
    command->callback([folder] { fmt::print("{}\n", write_report(*folder)); });
}

} // namespace sim
