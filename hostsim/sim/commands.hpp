// SPDX-License-Identifier: MIT
//
// The sub-commands.  Each adds itself to the parser.
#ifndef OCELLUS_SIM_COMMANDS_HPP
#define OCELLUS_SIM_COMMANDS_HPP

#include <CLI/CLI.hpp>

namespace sim {

void add_merge(CLI::App &app);
void add_paper(CLI::App &app);
void add_report(CLI::App &app);
void add_run(CLI::App &app);
void add_track(CLI::App &app);

} // namespace sim

#endif
