// SPDX-License-Identifier: MIT
#include "trials/trial_seeds.hpp"

#include <algorithm>

#include "world/paper_head.hpp"

namespace sim {

std::uint64_t seed_of(const Scenario &scenario, const TrialKey &key, std::uint64_t draw) {
    std::uint64_t seed = mixed_seed(text_seed(scenario.name), key.seed);
    seed = mixed_seed(seed, key.point);
    seed = mixed_seed(seed, static_cast<std::uint64_t>(key.trial));
    return mixed_seed(seed, draw);
}

Vec3 placement(const Scenario &scenario, const TrialKey &key) {
    Random random(seed_of(scenario, key, kPlacement));
    const double distance = scenario.distance_at(key.point);
    const double reach = scenario.jitter * distance;
    const double left = random.uniform(-reach, reach);
    const double up = random.uniform(-reach, reach);
    return eyes_middle() + Vec3(distance, left, up);
}

void add_noise(double sigma, std::uint64_t seed, cli::Image &frame) {
    if (sigma > 0.0) {
        Random random(seed);
        for (std::uint8_t &level : frame.pixels) {
            const double noisy = level + sigma * random.normal();
            level = static_cast<std::uint8_t>(std::lround(std::min(std::max(noisy, 0.0), 255.0)));
        }
    }
}

} // namespace sim
