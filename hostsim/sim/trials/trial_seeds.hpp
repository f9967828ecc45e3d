// SPDX-License-Identifier: MIT
//
// The chance in a trial: drawn from seeds of their own, so that one draw does not
// move another, and of the trial's key alone, so that any process may run it.
#ifndef OCELLUS_SIM_TRIAL_SEEDS_HPP
#define OCELLUS_SIM_TRIAL_SEEDS_HPP

#include "image.hpp"
#include "support/random.hpp"
#include "trials/scenario.hpp"

namespace sim {

// Which trial.  What happens in it depends on these, and the scenario, alone.
struct TrialKey {
    std::size_t point;
    int trial;
    std::uint64_t seed;
};

// What is left to chance.
enum Draw { kPlacement = 1, kClutter, kNoise, kEdge, kResampling };

std::uint64_t seed_of(const Scenario &scenario, const TrialKey &key, std::uint64_t draw);

// Where the target is, in the world.
Vec3 placement(const Scenario &scenario, const TrialKey &key);

// A sensor's noise, standard deviation `sigma` levels.
void add_noise(double sigma, std::uint64_t seed, cli::Image &frame);

} // namespace sim

#endif
