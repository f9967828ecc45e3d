// SPDX-License-Identifier: MIT
//
// A scenario from its file to its folder of results: what `run` and `paper` share.
#ifndef OCELLUS_SIM_SCENARIO_RUN_HPP
#define OCELLUS_SIM_SCENARIO_RUN_HPP

#include <CLI/CLI.hpp>
#include <string>

#include "results.hpp"

namespace sim {

// How much, from which seed, over how many processes.
struct SweepChoice {
    int trials = 0; // at each point; 0: as the scenario says
    std::uint64_t seed = 1;
    int jobs = 1;
    std::string record_dir; // as RunOptions'; only `run` offers it

    int trials_of(const Scenario &scenario) const {
        return trials > 0 ? trials : scenario.trials;
    }
};

// --trials, --seed and --jobs.
void add_sweep_options(CLI::App &command, SweepChoice &choice);

// Runs all trials, writes trials.csv, summary.json and pictures/ to `out`, and prints
// how the methods did.
void run_scenario(const Scenario &scenario, const SweepChoice &choice, const std::string &out);

} // namespace sim

#endif
