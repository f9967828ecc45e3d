// SPDX-License-Identifier: MIT
//
// ocellus-sim merge: the shards of a run, put together.
#include <fmt/format.h>
#include <memory>

#include "commands.hpp"
#include "support/shard.hpp"

namespace sim {

namespace {

constexpr const char *kFooter =
    R"(Each DIR is what `run --shard k/n` or `paper --shard k/n` has written, all n of
them with the same scenario, seed, number of trials and version; a trial that is
missing or there twice is an error. trials.csv and summary.json are then, byte for
byte, those of the run in one piece. After the shards of `paper`:
ocellus-sim report DIR.

Example:
  ocellus-sim run hostsim/scenarios/c_distance.toml --out s1 --shard 1/2
  ocellus-sim run hostsim/scenarios/c_distance.toml --out s2 --shard 2/2
  ocellus-sim merge --out c s1 s2)";

struct MergeArguments {
    std::string out;
    std::vector<std::string> folders;
};

} // namespace

void add_merge(CLI::App &app) {
    const auto arguments = std::make_shared<MergeArguments>();
    CLI::App *const command = app.add_subcommand("merge", "Put the shards of a run together");
    command->footer(kFooter);
    command->add_option("--out", arguments->out, "the folder for the whole")
        ->type_name("DIR")
        ->required();
    command->add_option("DIR", arguments->folders, "the folders of the shards")->required();
    command->callback([arguments] {
        merge_folders(arguments->folders, arguments->out);
        fmt::print("{} shards: {}\n", arguments->folders.size(), arguments->out);
    });
}

} // namespace sim
