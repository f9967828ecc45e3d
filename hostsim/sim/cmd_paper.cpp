// SPDX-License-Identifier: MIT
//
// ocellus-sim paper: all of the paper's experiments and the report on them.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <memory>

#include "commands.hpp"
#include "error.hpp"
#include "report/plot.hpp"
#include "report/report.hpp"
#include "track/track.hpp"
#include "trials/scenario_run.hpp"
#include "trials/threshold.hpp"

namespace sim {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct PaperArguments {
    std::string out;
    std::string scenarios = OCEL_SIM_SCENARIOS;
    SweepChoice sweep;
    bool video = false;
};

constexpr const char *kFooter =
    R"(Runs the paper's scenarios a, b and c, and c twice more: with eyes that fixate,
and through the stretched camera that the iCub simulator had until 2010; then the
table of Hough thresholds (the paper's Table 3) and the closed loop on every
track_*.toml. Writes to DIR, which is made when it is missing:
  report.html   the paper's Fig. 6 and Table 3 redrawn, failure rates, what the
                figures show and why, and tracking; needs no other file
  a_cylinder/, b_occlusion/, c_distance/, c_fixated/, c_stretched/
                as `ocellus-sim run` leaves them
  table3.json   the largest threshold that works, for each point of b and c
  track_*/      as `ocellus-sim track` leaves them
  clock.json    how long it took; the only file that is not the same twice
With 30 trials, as the scenarios say, it takes a few minutes on two cores. The
plots need gnuplot (Debian: gnuplot-nox).

Example:
  ocellus-sim paper --out build/paper --trials 30 --jobs 2)";

std::vector<fs::path> track_files(const fs::path &folder) {
    std::vector<fs::path> files;
    for (const fs::directory_entry &entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (name.rfind("track_", 0) == 0 && entry.path().extension() == ".toml") {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

// All of them are read before the first runs, so that a mistake in the last one costs
// no time.
struct Plan {
    std::vector<Scenario> sweeps;
    std::vector<TrackScenario> tracks;
};

Plan read_plan(const fs::path &folder) {
    if (!fs::is_directory(folder)) {
        throw cli::InputError("--scenarios " + folder.string() +
                              ": is no folder; expected the one with c_distance.toml in it, "
                              "hostsim/scenarios");
    }
    Plan plan;
    for (const char *const name : kSweepNames) {
        plan.sweeps.push_back(read_scenario((folder / name).string() + ".toml"));
    }
    for (const fs::path &file : track_files(folder)) {
        plan.tracks.push_back(read_track_scenario(file.string()));
    }
    return plan;
}

const Scenario &sweep_of(const Plan &plan, const std::string &name) {
    return *std::find_if(plan.sweeps.begin(), plan.sweeps.end(),
                         [&](const Scenario &scenario) { return scenario.name == name; });
}

// Table 3: over c's distances and b's occlusions.
void run_thresholds(const Plan &plan, const PaperArguments &arguments) {
    const Json table{{"seed", arguments.sweep.seed},
                     {"distance", threshold_rows(sweep_of(plan, "c_distance"), arguments.sweep)},
                     {"occlusion", threshold_rows(sweep_of(plan, "b_occlusion"), arguments.sweep)}};
    write_text(arguments.out + "/" + kThresholdFile, table.dump(1) + "\n");
}

Json run_tracks(const Plan &plan, const PaperArguments &arguments, std::uint32_t &violations) {
    Json clock = Json::object();
    for (const TrackScenario &scenario : plan.tracks) {
        const TrackResult result = run_track(
            scenario, {arguments.sweep.seed, arguments.out + "/" + scenario.name, arguments.video});
        fmt::print("{}", track_table(result));
        violations += result.summary["checks"]["violations"].get<std::uint32_t>();
        clock[scenario.name] = {
            {"frames_per_second", static_cast<double>(result.frames.size()) / result.times.loop},
            {"library_share", result.times.library / result.times.loop}};
    }
    return clock;
}

void run_paper(const PaperArguments &arguments) {
    require_gnuplot();
    const Plan plan = read_plan(arguments.scenarios);
    make_folder(arguments.out);
    const auto begin = std::chrono::steady_clock::now();
    std::uint32_t violations = 0;
    for (const Scenario &scenario : plan.sweeps) {
        fmt::print("\n{}\n", scenario.name);
        violations += run_scenario(scenario, arguments.sweep, arguments.out + "/" + scenario.name);
    }
    if (arguments.sweep.shard.index > 1) { // the first shard does what is not of trials
        fail_on_violations(violations);
        return;
    }
    run_thresholds(plan, arguments);
    Json clock{{"tracks", run_tracks(plan, arguments, violations)}};
    clock["seconds"] =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    write_text(arguments.out + "/" + kClockFile, clock.dump(1) + "\n");
    if (arguments.sweep.shard.count > 1) {
        fmt::print("\nof {} shards the first; ocellus-sim merge, then ocellus-sim report\n",
                   arguments.sweep.shard.count);
    } else {
        fmt::print("\nreport: {}\n", write_report(arguments.out));
    }
    fail_on_violations(violations);
}

} // namespace

void add_paper(CLI::App &app) {
    const auto arguments = std::make_shared<PaperArguments>();
    CLI::App *const command =
        app.add_subcommand("paper", "Run all of the paper's experiments and report on them");
    command->footer(kFooter);
    command->add_option("--out", arguments->out, "the folder for the results")
        ->type_name("DIR")
        ->required();
    add_sweep_options(*command, arguments->sweep);
    command
        ->add_option("--scenarios", arguments->scenarios,
                     "the folder of the scenarios; default: the sources' own")
        ->type_name("DIR");
    command->add_flag("--video", arguments->video, "write the closed loop's videos too");
    command->callback([arguments] { run_paper(*arguments); });
}

} // namespace sim
