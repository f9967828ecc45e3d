// SPDX-License-Identifier: MIT
//
// ocellus-sim run: one scenario, all its trials.
#include <chrono>
#include <fmt/format.h>
#include <memory>

#include "commands.hpp"
#include "results.hpp"
#include "runner.hpp"

namespace sim {

namespace {

struct RunArguments {
    std::string scenario;
    std::string out;
    int trials = 0; // 0: as the scenario says
    std::uint64_t seed = 1;
    int jobs = 1;
};

constexpr const char *kFooter =
    R"(Writes to DIR, which is made when it is missing:
  trials.csv    a row for each trial and method. Lengths are in SMU, the iCub
                simulator's measure unit (.194 m); occlusion is the hidden share
                of the target, 0..1; a field is empty where there is no value.
                err: distance of est from true. err_encoder: the paper's eq. 14,
                by the joints alone; err_residual: its exact form, with what the
                images still show off their middle; err_debiased: with a disc's
                r^2/d taken off x. success: both outlines within .25 r and 20 %
                of the truth. votes: the highest Hough threshold that finds one.
  summary.json  means and deviations for each method, in all and at each point
  pictures/     the first trial of each point: both eyes' frames and outlines
The same scenario, seed and number of trials give the same files on the same
machine, whatever --jobs is.

Example:
  ocellus-sim run hostsim/scenarios/c_distance.toml --out build/c --jobs 2)";

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

void run(const RunArguments &arguments) {
    const Scenario scenario = read_scenario(arguments.scenario);
    make_folder(arguments.out + "/pictures");
    RunOptions options;
    options.trials = arguments.trials > 0 ? arguments.trials : scenario.trials;
    options.seed = arguments.seed;
    options.jobs = arguments.jobs;
    options.picture_dir = arguments.out + "/pictures";
    const auto begin = std::chrono::steady_clock::now();
    const std::vector<TrialRecord> records = run_trials(scenario, options);
    const double seconds = seconds_since(begin);
    const nlohmann::ordered_json summary = summary_of(scenario, arguments.seed, records);
    write_text(arguments.out + "/trials.csv", csv_of(scenario, arguments.seed, records));
    write_text(arguments.out + "/summary.json", summary.dump(1) + "\n");
    print_result(summary);
    fmt::print("{} trials, {} stereo frames in {:.1f} s: {}/trials.csv {}/summary.json "
               "{}/pictures/\n",
               records.size(), stereo_frames(records), seconds, arguments.out, arguments.out,
               arguments.out);
}

} // namespace

void add_run(CLI::App &app) {
    const auto arguments = std::make_shared<RunArguments>();
    CLI::App *const command = app.add_subcommand("run", "Run one scenario");
    command->footer(kFooter);
    command->add_option("SCENARIO.toml", arguments->scenario, "the scenario")->required();
    command->add_option("--out", arguments->out, "the folder for the results")
        ->type_name("DIR")
        ->required();
    command
        ->add_option("--trials", arguments->trials,
                     "trials at each point; default: what the scenario says")
        ->type_name("N")
        ->check(CLI::Range(1, 1000000));
    command->add_option("--seed", arguments->seed, "default 1")->type_name("S");
    command->add_option("--jobs", arguments->jobs, "processes, default 1")
        ->type_name("J")
        ->check(CLI::Range(1, 256));
    command->callback([arguments] { run(*arguments); });
}

} // namespace sim
