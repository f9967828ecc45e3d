// SPDX-License-Identifier: MIT
//
// The sub-commands.  Each adds itself to the parser and leaves its exit code in
// `exit_code` when it has run.
#ifndef OCELLUS_CLI_COMMANDS_HPP
#define OCELLUS_CLI_COMMANDS_HPP

#include <CLI/CLI.hpp>
#include <string>

#include <ocellus/types.h>

namespace cli {

void add_fit(CLI::App &app, int &exit_code);
void add_label(CLI::App &app, int &exit_code);
void add_detect(CLI::App &app, int &exit_code);
void add_sphere(CLI::App &app, int &exit_code);
void add_bench(CLI::App &app, int &exit_code);

// `b2ac`, `lcse` or `hyper`; InputError for another name, with the names expected.
ocel_fit_method_t parse_method(const std::string &name,
                               const char *expected = "b2ac, lcse or hyper");

// `auto`, `always` or `never`; InputError for another name.
ocel_perturb_t parse_perturb(const std::string &name);

// `8` or `4`; InputError for anything else.
int parse_connectivity(const std::string &text);

} // namespace cli

#endif
