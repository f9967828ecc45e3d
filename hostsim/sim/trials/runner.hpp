// SPDX-License-Identifier: MIT
//
// All trials of a scenario, over several processes.
#ifndef OCELLUS_SIM_RUNNER_HPP
#define OCELLUS_SIM_RUNNER_HPP

#include <string>
#include <vector>

#include "support/shard.hpp"
#include "trials/trial.hpp"

namespace sim {

struct RunOptions {
    int trials = 0; // at each point
    std::uint64_t seed = 1;
    int jobs = 1; // processes
    Shard shard;
    std::string picture_dir; // the first trial of each point is drawn here; "": none is
    std::string record_dir;  // all frames go here, and jobs is 1; "": none do
};

// Sorted by point and trial; the same whatever `jobs` is.  std::runtime_error when
// a process fails, which has then said why on stderr.
std::vector<TrialRecord> run_trials(const Scenario &scenario, const RunOptions &options);

} // namespace sim

#endif
