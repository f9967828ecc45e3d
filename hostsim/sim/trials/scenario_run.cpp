// SPDX-License-Identifier: MIT
#include "trials/scenario_run.hpp"

#include <chrono>
#include <fmt/format.h>

#include <ocellus/version.h>

#include "trials/runner.hpp"

namespace sim {

namespace {

// For people: how the methods did, and how fast it went.
void print_result(const nlohmann::ordered_json &summary) {
    fmt::print("{:<15} {:>6} {:>6} {:>8} {:>10} {:>10} {:>11}\n", "method", "trials", "ok",
               "success", "err mean", "err max", "radius mean");
    for (const auto &[name, method] : summary["methods"].items()) {
        const auto &all = method["all"];
        fmt::print("{:<15} {:>6} {:>6} {:>8}", name, all["trials"].get<int>(), all["ok"].get<int>(),
                   all["success"].get<int>());
        if (all.contains("err")) {
            fmt::print(" {:>10.5f} {:>10.5f}", all["err"]["mean"].get<double>(),
                       all["err"]["max"].get<double>());
        }
        if (all.contains("radius_err_pct")) {
            fmt::print(" {:>+9.2f} %", all["radius_err_pct"]["mean"].get<double>());
        }
        fmt::print("\n");
    }
}

double seconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

int stereo_frames(const std::vector<TrialRecord> &records) {
    int frames = 0;
    for (const TrialRecord &record : records) {
        frames += record.frames;
    }
    return frames;
}

RunOptions options_of(const Scenario &scenario, const SweepChoice &choice, const std::string &out) {
    RunOptions options;
    options.trials = choice.trials_of(scenario);
    options.seed = choice.seed;
    options.jobs = choice.jobs;
    options.shard = choice.shard;
    options.picture_dir = out + "/pictures";
    options.record_dir = choice.record_dir;
    return options;
}

} // namespace

std::uint32_t run_scenario(const Scenario &scenario, const SweepChoice &choice,
                           const std::string &out) {
    make_folder(out + "/pictures");
    if (!choice.record_dir.empty()) {
        make_folder(choice.record_dir, "--record");
    }
    const auto begin = std::chrono::steady_clock::now();
    const std::vector<TrialRecord> records =
        run_trials(scenario, options_of(scenario, choice, out));
    const double seconds = seconds_since(begin);
    const nlohmann::ordered_json summary = write_results(scenario, choice.seed, records, out);
    write_manifest(
        out,
        {OCEL_VERSION_STRING, scenario.name, choice.seed, choice.trials_of(scenario), choice.shard},
        scenario.text);
    print_result(summary);
    fmt::print("{} trials, {} stereo frames in {:.1f} s: {}/trials.csv {}/summary.json "
               "{}/pictures/\n",
               records.size(), stereo_frames(records), seconds, out, out, out);
    return summary["checks"]["violations"];
}

void add_sweep_options(CLI::App &command, SweepChoice &choice) {
    command
        .add_option("--trials", choice.trials,
                    "trials at each point; default: what the scenario says")
        ->type_name("N")
        ->check(CLI::Range(1, 1000000));
    command.add_option("--seed", choice.seed, "default 1")->type_name("S");
    command
        .add_option_function<std::string>(
            "--shard", [&choice](const std::string &text) { choice.shard = parse_shard(text); },
            "every n-th trial from the k-th on; ocellus-sim merge puts all n together")
        ->type_name("k/n");
    command.add_option("--jobs", choice.jobs, "processes, default 1")
        ->type_name("J")
        ->check(CLI::Range(1, 256));
}

} // namespace sim
