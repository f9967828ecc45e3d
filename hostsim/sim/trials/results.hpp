// SPDX-License-Identifier: MIT
//
// What a run leaves: trials.csv, a row for each trial and method, and
// summary.json, their statistics.
#ifndef OCELLUS_SIM_RESULTS_HPP
#define OCELLUS_SIM_RESULTS_HPP

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "trials/trial.hpp"

namespace sim {

std::string csv_of(const Scenario &scenario, std::uint64_t seed,
                   const std::vector<TrialRecord> &records);

// Its records, from what csv_of wrote; `name` is for messages.  Numbers have the ten
// digits that they were written with, and so has what is made of them: csv_of gives
// the same text again.  cli::InputError when it is anything else.
std::vector<TrialRecord> records_of_csv(const std::string &text, const std::string &name);

// A function of trials.csv: `records` are those of records_of_csv.
nlohmann::ordered_json summary_of(const Scenario &scenario, std::uint64_t seed,
                                  const std::vector<TrialRecord> &records);

// Writes trials.csv and summary.json to the folder `out`; returns the summary.
nlohmann::ordered_json write_results(const Scenario &scenario, std::uint64_t seed,
                                     const std::vector<TrialRecord> &records,
                                     const std::string &out);

// Makes the folder that an option names, unless it is there.  cli::InputError when it
// cannot be.
void make_folder(const std::string &path, const char *option = "--out");

// cli::InputError when it cannot be written.
void write_text(const std::string &path, const std::string &text);

} // namespace sim

#endif
