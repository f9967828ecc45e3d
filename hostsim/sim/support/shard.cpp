// SPDX-License-Identifier: MIT
#include "support/shard.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <set>

#include "error.hpp"
#include "input.hpp"
#include "trials/results.hpp"

namespace sim {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char *kManifest = "run.json";
constexpr const char *kScenario = "scenario.toml";

std::string text_of(const std::string &path) {
    const std::vector<std::uint8_t> bytes = cli::read_bytes(path);
    return {bytes.begin(), bytes.end()};
}

RunManifest read_manifest(const std::string &folder) {
    const std::string path = folder + "/" + kManifest;
    try {
        const Json json = Json::parse(text_of(path));
        return {json.at("version"),
                json.at("scenario"),
                json.at("seed"),
                json.at("trials"),
                {json.at("shard"), json.at("shards")}};
    } catch (const Json::exception &mistake) {
        throw cli::InputError(path + ": is not what ocellus-sim run writes: " + mistake.what());
    }
}

// One shard's folder, read.
struct ShardRun {
    std::string folder;
    RunManifest manifest;
    std::string scenario_text;
    std::vector<TrialRecord> records;
};

ShardRun read_shard(const std::string &folder) {
    const std::string csv = folder + "/trials.csv";
    return {folder, read_manifest(folder), text_of(folder + "/" + kScenario),
            records_of_csv(text_of(csv), csv)};
}

template <class Value>
void require_same(const ShardRun &first, const ShardRun &other, const char *what, const Value &a,
                  const Value &b) {
    if (a != b) {
        throw cli::InputError(fmt::format("{}: its {} is {}, but that of {} is {}; expected the "
                                          "shards of one run",
                                          other.folder, what, b, first.folder, a));
    }
}

void require_one_run(const ShardRun &first, const ShardRun &other) {
    const RunManifest &a = first.manifest;
    const RunManifest &b = other.manifest;
    require_same(first, other, "version", a.version, b.version);
    require_same(first, other, "scenario", a.scenario, b.scenario);
    require_same(first, other, "seed", a.seed, b.seed);
    require_same(first, other, "number of trials", a.trials, b.trials);
    require_same(first, other, "number of shards", a.shard.count, b.shard.count);
    if (first.scenario_text != other.scenario_text) {
        throw cli::InputError(fmt::format("{0}/{2} is not that of {1}; expected the shards of one "
                                          "run",
                                          other.folder, first.folder, kScenario));
    }
}

std::string name_of(std::size_t place, int trials) {
    const auto per_point = static_cast<std::size_t>(trials);
    return fmt::format("point {}, trial {}", place / per_point, place % per_point);
}

// All trials, each once and with every method, in order.
std::vector<TrialRecord> all_trials(const std::vector<ShardRun> &runs, const Scenario &scenario) {
    const int trials = runs.front().manifest.trials;
    const std::size_t total = scenario.points.size() * static_cast<std::size_t>(trials);
    std::vector<TrialRecord> all(total);
    std::vector<const ShardRun *> owners(total, nullptr);
    for (const ShardRun &run : runs) {
        for (const TrialRecord &record : run.records) {
            const std::size_t place = record.point * static_cast<std::size_t>(trials) +
                                      static_cast<std::size_t>(record.trial);
            if (record.trial < 0 || record.trial >= trials || place >= total ||
                record.method_count != static_cast<int>(scenario.methods.size())) {
                throw cli::InputError(
                    fmt::format("{}/trials.csv: point {}, trial {} is not whole, or "
                                "none of this run's; expected the file as it was "
                                "written",
                                run.folder, record.point, record.trial));
            }
            if (owners[place] != nullptr) {
                throw cli::InputError(fmt::format("{}: {} is in {} too; expected each shard once",
                                                  run.folder, name_of(place, trials),
                                                  owners[place]->folder));
            }
            owners[place] = &run;
            all[place] = record;
        }
    }
    const auto missing = std::find(owners.begin(), owners.end(), nullptr);
    if (missing != owners.end()) {
        const auto place = static_cast<std::size_t>(missing - owners.begin());
        const int count = runs.front().manifest.shard.count;
        throw cli::InputError(fmt::format("{} is missing; expected all shards, and it is of {}/{}",
                                          name_of(place, trials),
                                          place % static_cast<std::size_t>(count) + 1, count));
    }
    return all;
}

void copy_new(const fs::path &from, const fs::path &to) {
    if (!fs::exists(to)) {
        fs::copy(from, to, fs::copy_options::recursive);
    }
}

void merge_run(const std::vector<std::string> &folders, const std::string &out) {
    std::vector<ShardRun> runs;
    for (const std::string &folder : folders) {
        runs.push_back(read_shard(folder));
        require_one_run(runs.front(), runs.back());
    }
    const Scenario scenario = read_scenario(folders.front() + "/" + kScenario);
    const std::vector<TrialRecord> records = all_trials(runs, scenario);
    make_folder(out + "/pictures");
    RunManifest manifest = runs.front().manifest;
    manifest.shard = {};
    write_results(scenario, manifest.seed, records, out);
    write_manifest(out, manifest, runs.front().scenario_text);
    for (const std::string &folder : folders) {
        for (const auto &picture : fs::directory_iterator(folder + "/pictures")) {
            copy_new(picture.path(), fs::path(out) / "pictures" / picture.path().filename());
        }
    }
}

bool is_run(const fs::path &folder) {
    return fs::exists(folder / kManifest);
}

// The names of all that stands in the folders.
std::set<std::string> entries_of(const std::vector<std::string> &folders) {
    std::set<std::string> names;
    for (const std::string &folder : folders) {
        if (!fs::is_directory(folder)) {
            throw cli::InputError(folder + ": is no folder; expected one that ocellus-sim run or "
                                           "paper has written");
        }
        for (const auto &entry : fs::directory_iterator(folder)) {
            names.insert(entry.path().filename().string());
        }
    }
    return names;
}

// A folder of `paper`: its runs, and what only one of the shards has made.
void merge_collection(const std::vector<std::string> &folders, const std::string &out) {
    bool found = false;
    for (const std::string &name : entries_of(folders)) {
        std::vector<std::string> parts;
        for (const std::string &folder : folders) {
            if (fs::exists(fs::path(folder) / name)) {
                parts.push_back((fs::path(folder) / name).string());
            }
        }
        if (is_run(parts.front())) {
            merge_run(parts, out + "/" + name);
            found = true;
        } else {
            make_folder(out);
            copy_new(parts.front(), fs::path(out) / name);
        }
    }
    if (!found) {
        throw cli::InputError(folders.front() + ": holds no run.json, nor does a folder in it; "
                                                "expected what ocellus-sim run or paper has "
                                                "written");
    }
}

} // namespace

std::size_t Shard::items_of(std::size_t total) const {
    const auto n = static_cast<std::size_t>(count);
    return (total + n - static_cast<std::size_t>(index)) / n;
}

std::size_t Shard::place_of(std::size_t item) const {
    return item * static_cast<std::size_t>(count) + static_cast<std::size_t>(index) - 1;
}

Shard parse_shard(const std::string &text) {
    Shard shard;
    int used = 0;
    const int read = std::sscanf(text.c_str(), "%d/%d%n", &shard.index, &shard.count, &used);
    if (read != 2 || static_cast<std::size_t>(used) != text.size() || shard.index < 1 ||
        shard.index > shard.count) {
        throw cli::InputError("--shard " + cli::quoted(text) +
                              ": expected k/n, the k-th of n shards, such as 1/4 .. 4/4");
    }
    return shard;
}

void write_manifest(const std::string &folder, const RunManifest &manifest,
                    const std::string &scenario_text) {
    const Json json{{"version", manifest.version},   {"scenario", manifest.scenario},
                    {"seed", manifest.seed},         {"trials", manifest.trials},
                    {"shard", manifest.shard.index}, {"shards", manifest.shard.count}};
    write_text(folder + "/" + kManifest, json.dump(1) + "\n");
    write_text(folder + "/" + kScenario, scenario_text);
}

void merge_folders(const std::vector<std::string> &folders, const std::string &out) {
    if (is_run(folders.front())) {
        merge_run(folders, out);
    } else {
        merge_collection(folders, out);
    }
}

} // namespace sim
