// SPDX-License-Identifier: MIT
//
// A scenario from its file to its folder of results: what `run` and `paper` share.
#ifndef OCELLUS_SIM_SCENARIO_RUN_HPP
#define OCELLUS_SIM_SCENARIO_RUN_HPP

#include <CLI/CLI.hpp>
#include <string>

#include "trials/results.hpp"
#include "trials/sweep_choice.hpp"

namespace sim {

// --trials, --seed and --jobs.
void add_sweep_options(CLI::App &command, SweepChoice &choice);

// Runs all trials, writes trials.csv, summary.json and pictures/ to `out`, and prints
// how the methods did.  Returns how many checks on the way failed, for
// fail_on_violations().
std::uint32_t run_scenario(const Scenario &scenario, const SweepChoice &choice,
                           const std::string &out);

} // namespace sim

#endif
