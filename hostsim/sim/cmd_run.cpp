// SPDX-License-Identifier: MIT
//
// ocellus-sim run: one scenario, all its trials.
#include <memory>

#include "commands.hpp"
#include "error.hpp"
#include "trials/scenario_run.hpp"

namespace sim {

namespace {

struct RunArguments {
    std::string scenario;
    std::string out;
    SweepChoice sweep;
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
--record DIR writes there, for a replay on another machine (tests/firmware):
  manifest.txt, frames.rgb565, pairs.csv, answers.csv   each pair of frames that
                the library's eyes were fed, in the camera's lines, the joints,
                and every member of what the library answered; recording.hpp
                tells the layout
The same scenario, seed and number of trials give the same files on the same
machine, whatever --jobs is.

Example:
  ocellus-sim run hostsim/scenarios/c_distance.toml --out build/c --jobs 2)";

void run(const RunArguments &arguments) {
    if (!arguments.sweep.record_dir.empty() && arguments.sweep.jobs != 1) {
        throw cli::InputError("--record: its files take the frames in order; expected --jobs 1");
    }
    fail_on_violations(
        run_scenario(read_scenario(arguments.scenario), arguments.sweep, arguments.out));
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
    add_sweep_options(*command, arguments->sweep);
    command
        ->add_option("--record", arguments->sweep.record_dir,
                     "the folder for a recording of all frames and the library's answers")
        ->type_name("DIR");
    command->callback([arguments] { run(*arguments); });
}

} // namespace sim
