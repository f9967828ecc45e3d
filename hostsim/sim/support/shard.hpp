// SPDX-License-Identifier: MIT
//
// A part of a run's trials, for sweeps beyond one machine, and the parts put
// together again.  A trial depends on the scenario, its place and the seed alone, so
// any scheduler will do.
#ifndef OCELLUS_SIM_SHARD_HPP
#define OCELLUS_SIM_SHARD_HPP

#include <cstdint>
#include <string>
#include <vector>

namespace sim {

// Number `index` of `count`, from 1: every count-th trial, so that each shard has a
// share of every point.
struct Shard {
    int index = 1;
    int count = 1;

    std::size_t items_of(std::size_t total) const;
    // The place among all of the shard's item.
    std::size_t place_of(std::size_t item) const;
};

// `k/n`.  cli::InputError for anything else.
Shard parse_shard(const std::string &text);

// What run.json says of a run; beside it stands scenario.toml, as it was.
struct RunManifest {
    std::string version;
    std::string scenario;
    std::uint64_t seed;
    int trials; // at each point
    Shard shard;
};

void write_manifest(const std::string &folder, const RunManifest &manifest,
                    const std::string &scenario_text);

// Puts the folders of all shards of a run together in `out`: trials.csv and
// summary.json are, byte for byte, those of the run in one piece.  Folders of `paper`
// are merged run by run, and what is in one of them only is copied.  cli::InputError
// when they are not the shards of one run, or a trial is missing or there twice.
void merge_folders(const std::vector<std::string> &folders, const std::string &out);

} // namespace sim

#endif
