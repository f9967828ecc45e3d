// SPDX-License-Identifier: MIT
#include "track.hpp"

#include <fmt/format.h>
#include <optional>

#include "progress.hpp"
#include "results.hpp"
#include "track_picture.hpp"
#include "track_results.hpp"
#include "video.hpp"

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

std::string verdict_line(const char *what, const std::string &found, const std::string &asked,
                         bool met) {
    return fmt::format("{:<44} {:>9}  {:<9} {}\n", what, found, asked, met ? "met" : "NOT MET");
}

std::string number_text(const nlohmann::ordered_json &object, const char *key) {
    return object.contains(key) ? fmt::format("{:.4f}", object[key].get<double>()) : "none";
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
    result.times = loop.times();
    write_text(options.out + "/frames.csv", track_csv(result.frames));
    write_text(options.out + "/summary.json", result.summary.dump(1) + "\n");
    return result;
}

std::string track_table(const TrackResult &result) {
    const nlohmann::ordered_json &summary = result.summary;
    const nlohmann::ordered_json &met = summary["met"];
    return fmt::format("{:<44} {:>9}  {:<9}\n", summary["scenario"].get<std::string>(), "found",
                       "asked") +
           verdict_line(fmt::format("held within {} px of both middles, of {} frames",
                                    summary["hold_px"].get<double>(),
                                    summary["counted_frames"].get<int>())
                            .c_str(),
                        fmt::format("{:.1f} %", 100.0 * summary["held_share"].get<double>()),
                        fmt::format(">= {:.0f} %", 100.0 * kHeldShare), met["held_share"]) +
           verdict_line("error RMS while visible, SMU", number_text(summary["err_visible"], "rms"),
                        fmt::format("<= {}", kTrackErrorRms), met["err_rms"]) +
           verdict_line(
               fmt::format("ok while hidden, of {} frames", summary["hidden_frames"].get<int>())
                   .c_str(),
               fmt::format("{}", summary["ok_while_hidden"].get<int>()), "0",
               met["ok_while_hidden"]);
}

} // namespace sim
