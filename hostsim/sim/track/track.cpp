// SPDX-License-Identifier: MIT
#include "track/track.hpp"

#include <fmt/format.h>
#include <optional>

#include "support/progress.hpp"
#include "support/video.hpp"
#include "track/track_picture.hpp"
#include "track/track_results.hpp"
#include "trials/results.hpp"

namespace sim {

namespace {

constexpr std::size_t kPictures = 12; // spread evenly over the run

// Whether the frame is drawn to a file: now and then, and when the ball comes or goes.
bool is_shown(const std::vector<TrackFrame> &frames, std::size_t total) {
    const std::size_t last = frames.size() - 1;
    const bool turn =
        last > 0 && (frames[last].status == OCEL_OK) != (frames[last - 1].status == OCEL_OK);
    return last % std::max<std::size_t>(total / kPictures, 1) == 0 || turn;
}

struct Line {
    std::string what;
    std::string found;
    std::string asked; // empty: nothing is
    bool met;
};

std::string text_of(const Line &line) {
    const char *const verdict = line.asked.empty() ? "" : line.met ? "met" : "NOT MET";
    return fmt::format("{:<52} {:>8}  {:<8} {}\n", line.what, line.found, line.asked, verdict);
}

std::string rms_text(const nlohmann::ordered_json &error) {
    return error.contains("rms") ? fmt::format("{:.4f}", error["rms"].get<double>()) : "none";
}

} // namespace

TrackResult run_track(const TrackScenario &scenario, const TrackOptions &options) {
    make_folder(options.out + "/pictures");
    TrackLoop loop(scenario, options.seed);
    const auto total = static_cast<std::size_t>(loop.frame_count());
    Progress progress(scenario.name, total, "frames");
    std::optional<Video> video;
    if (options.video) {
        video.emplace(options.out + "/track.mp4", kTrackRate);
    }
    TrackResult result;
    while (result.frames.size() < total) {
        result.frames.push_back(loop.step());
        const bool shown = is_shown(result.frames, total);
        if (shown || video) {
            const cli::Image picture = annotated_pair(scenario, loop, result.frames.back());
            if (shown) {
                cli::write_png(fmt::format("{}/pictures/frame_{:04}.png", options.out,
                                           result.frames.size() - 1),
                               picture);
            }
            if (video) {
                video->add(picture);
            }
        }
        progress.advance();
    }
    result.summary = track_summary(scenario, options.seed, result.frames);
    result.summary["checks"] = checks_json(loop.checks(), count_bounds(scenario.camera.intrinsics));
    result.times = loop.times();
    write_text(options.out + "/frames.csv", track_csv(result.frames));
    write_text(options.out + "/summary.json", result.summary.dump(1) + "\n");
    return result;
}

std::string track_table(const TrackResult &result) {
    const nlohmann::ordered_json &summary = result.summary;
    const nlohmann::ordered_json &met = summary["met"];
    const auto number = [&summary](const char *key) { return summary[key].get<double>(); };
    const Line lines[] = {
        {fmt::format("held within {:g} px of both middles, of {} frames", number("hold_px"),
                     number("counted_frames")),
         fmt::format("{:.1f} %", 100.0 * number("held_share")),
         fmt::format(">= {:g} %", 100.0 * kHeldShare), met["held_share"]},
        {fmt::format("error RMS of {} ok frames, SMU", number("ok_frames")),
         rms_text(summary["err"]), fmt::format("<= {:g}", kTrackErrorRms), met["err_rms"]},
        {fmt::format("the same, of all {} visible ones, guesses too", number("visible_frames")),
         rms_text(summary["err_visible"]), "", true},
        {fmt::format("ok while hidden, of {} frames", number("hidden_frames")),
         fmt::format("{}", number("ok_while_hidden")), "0", met["ok_while_hidden"]},
        {"frames until it is taken again, at most",
         fmt::format("{}", number("reacquired_frames_max")), "", true}};
    std::string table =
        fmt::format("{:<52} {:>8}  asked\n", summary["scenario"].get<std::string>(), "found");
    for (const Line &line : lines) {
        table += text_of(line);
    }
    return table;
}

} // namespace sim
