// SPDX-License-Identifier: MIT
//
// ocellus-sim track: the closed loop.
#include <fmt/format.h>
#include <memory>

#include "commands.hpp"
#include "track/track.hpp"
#include "trials/checks.hpp"

namespace sim {

namespace {

struct TrackArguments {
    std::string scenario;
    TrackOptions options;
};

constexpr const char *kFooter =
    R"(Writes to DIR, which is made when it is missing:
  frames.csv    a row for each pair of frames: where the ball is, how much of it
                each eye sees, how far it is off both pictures' middles, the
                library's statuses, what it measured and what it tracks, the
                joints and their speeds. Lengths are in SMU, the iCub simulator's
                measure unit (.194 m), joints in degrees; a field is empty where
                there is no value. hidden: neither eye sees any of the ball;
                counted: not wholly behind a screen, and .5 s or more after it was
                first seen; held: within 20 px (of 320) of both middles.
  summary.json  the figures of the run
  pictures/     annotated stereo frames; the circle is the 20 px
  track.mp4     with --video: all of them, H.264
The same scenario and seed give the same files on the same machine.

Example:
  ocellus-sim track hostsim/scenarios/track_throw.toml --out build/throw --video)";

void track(const TrackArguments &arguments) {
    const TrackScenario scenario = read_track_scenario(arguments.scenario);
    const TrackResult result = run_track(scenario, arguments.options);
    const std::string &out = arguments.options.out;
    const auto frames = static_cast<double>(result.frames.size());
    fmt::print("{}", track_table(result));
    fmt::print("the loop: {:.1f} stereo frames/s on one core; the library takes {:.2f} ms of the "
               "{:.2f} ms of each, {:.1f} %\n",
               frames / result.times.loop, 1e3 * result.times.library / frames,
               1e3 * result.times.loop / frames, 100.0 * result.times.library / result.times.loop);
    fmt::print("{}/frames.csv {}/summary.json {}/pictures/{}\n", out, out, out,
               arguments.options.video ? " " + out + "/track.mp4" : "");
    fail_on_violations(result.summary["checks"]["violations"]);
}

} // namespace

void add_track(CLI::App &app) {
    const auto arguments = std::make_shared<TrackArguments>();
    CLI::App *const command =
        app.add_subcommand("track", "Follow a moving ball with the head, in a closed loop");
    command->footer(kFooter);
    command->add_option("SCENARIO.toml", arguments->scenario, "the scenario")->required();
    command->add_option("--out", arguments->options.out, "the folder for the results")
        ->type_name("DIR")
        ->required();
    command->add_option("--seed", arguments->options.seed, "default 1")->type_name("S");
    command->add_flag("--video", arguments->options.video, "write track.mp4");
    command->callback([arguments] { track(*arguments); });
}

} // namespace sim
