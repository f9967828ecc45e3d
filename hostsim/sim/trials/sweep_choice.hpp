// SPDX-License-Identifier: MIT
#ifndef OCELLUS_SIM_SWEEP_CHOICE_HPP
#define OCELLUS_SIM_SWEEP_CHOICE_HPP

#include "support/shard.hpp"
#include "trials/scenario.hpp"

namespace sim {

// How much, from which seed, over how many processes.
struct SweepChoice {
    int trials = 0; // at each point; 0: as the scenario says
    std::uint64_t seed = 1;
    int jobs = 1;
    Shard shard;
    std::string record_dir; // as RunOptions'; only `run` offers it

    int trials_of(const Scenario &scenario) const {
        return trials > 0 ? trials : scenario.trials;
    }
};

} // namespace sim

#endif
