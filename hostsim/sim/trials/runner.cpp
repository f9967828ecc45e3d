// SPDX-License-Identifier: MIT
#include "trials/runner.hpp"

#include <fmt/format.h>
#include <memory>

#include "support/processes.hpp"
#include "trials/picture.hpp"

namespace sim {

namespace {

TrialKey key_of(std::size_t index, const RunOptions &options) {
    const auto trials = static_cast<std::size_t>(options.trials);
    return {index / trials, static_cast<int>(index % trials), options.seed};
}

std::size_t total_trials(const Scenario &scenario, const RunOptions &options) {
    return scenario.points.size() * static_cast<std::size_t>(options.trials);
}

TrialRecord run_one(const Scenario &scenario, const RunOptions &options, const TrialKey &key,
                    Studio &studio) {
    if (options.picture_dir.empty() || key.trial != 0) {
        return studio.run(key, nullptr);
    }
    TrialPictures pictures;
    const TrialRecord record = studio.run(key, &pictures);
    cli::write_png(fmt::format("{}/{}_p{:02}.png", options.picture_dir, scenario.name, key.point),
                   annotated_pair(scenario, record, pictures));
    return record;
}

// What a process keeps from trial to trial.
struct Workshop {
    Workshop(const Scenario &scenario, const RunOptions &options)
        : recording(options.record_dir.empty()
                        ? nullptr
                        : std::make_unique<Recording>(options.record_dir, scenario)),
          studio(scenario, recording.get()) {
    }

    std::unique_ptr<Recording> recording;
    Studio studio;
};

} // namespace

std::vector<TrialRecord> run_trials(const Scenario &scenario, const RunOptions &options) {
    const Batch batch{scenario.name, options.shard.items_of(total_trials(scenario, options)),
                      "trials", options.jobs};
    return results_of<TrialRecord>(batch, [&]() -> std::function<TrialRecord(std::size_t)> {
        const auto workshop = std::make_shared<Workshop>(scenario, options);
        return [&, workshop](std::size_t index) {
            return run_one(scenario, options, key_of(options.shard.place_of(index), options),
                           workshop->studio);
        };
    });
}

} // namespace sim
