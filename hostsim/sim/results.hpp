// SPDX-License-Identifier: MIT
//
// What a run leaves: trials.csv, a row for each trial and method, and
// summary.json, their statistics.
#ifndef OCELLUS_SIM_RESULTS_HPP
#define OCELLUS_SIM_RESULTS_HPP

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "trial.hpp"

namespace sim {

std::string csv_of(const Scenario &scenario, std::uint64_t seed,
                   const std::vector<TrialRecord> &records);

nlohmann::ordered_json summary_of(const Scenario &scenario, std::uint64_t seed,
                                  const std::vector<TrialRecord> &records);

// Makes the folder that an option names, unless it is there.  cli::InputError when it
// cannot be.
void make_folder(const std::string &path, const char *option = "--out");

// cli::InputError when it cannot be written.
void write_text(const std::string &path, const std::string &text);

} // namespace sim

#endif
