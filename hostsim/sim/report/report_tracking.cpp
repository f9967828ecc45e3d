// SPDX-License-Identifier: MIT
//
// The closed loop over time.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>

#include "report/report_claims.hpp"
#include "report/report_sections.hpp"

namespace sim {

namespace {

namespace fs = std::filesystem;

Curve curve_over_time(const TrackRun &track, const std::string &title, const Ink &ink,
                      Stroke stroke, const std::string &key) {
    Curve curve{title, ink, stroke, {}};
    for (std::size_t i = 0; i < track.frames(); ++i) {
        const double y = track.number(key, i);
        curve.points.push_back({track.number("time_s", i), y, y, y});
    }
    return curve;
}

// How far the ball is off one picture's middle.
Curve offset_curve(const TrackRun &track, const std::string &side, const Ink &ink, Stroke stroke) {
    Curve curve{side + " eye", ink, stroke, {}};
    for (std::size_t i = 0; i < track.frames(); ++i) {
        const double off = std::hypot(track.number("off_" + side + "_x", i),
                                      track.number("off_" + side + "_y", i));
        curve.points.push_back({track.number("time_s", i), off, off, off});
    }
    return curve;
}

// While neither eye sees any of the ball; each frame stands for the time to the next.
std::vector<PlotSpan> hidden_spans(const TrackRun &track) {
    std::vector<PlotSpan> spans;
    bool inside = false;
    for (std::size_t i = 0; i < track.frames(); ++i) {
        const double time = track.number("time_s", i);
        const bool hidden = track.number("hidden", i) != 0.0;
        if (hidden && !inside) {
            spans.push_back({time, time});
        }
        if (hidden || inside) {
            spans.back().to = time;
        }
        inside = hidden;
    }
    return spans;
}

Plot time_plot(const TrackRun &track, const std::string &what) {
    Plot plot;
    plot.name = track.folder + "_" + what;
    plot.x_label = "time, s";
    plot.x_range = PlotSpan{0.0, track.number("time_s", track.frames() - 1)};
    plot.shaded = hidden_spans(track);
    plot.shaded_words = "hidden";
    return plot;
}

Plot offset_plot(const TrackRun &track) {
    Plot plot = time_plot(track, "offset");
    plot.about = "Distance of the ball from both images' middles over time";
    plot.y_label = "off the image's middle, px";
    plot.curves = {offset_curve(track, "left", {"#0072B2", 7, 3.0}, Stroke::kSolid),
                   offset_curve(track, "right", {"#E69F00", 7, 1.6}, Stroke::kDashed)};
    const double hold = track.figure("hold_px");
    plot.levels.push_back({hold, fmt::format("asked: {:.0f} px", hold)});
    double largest = 2.0 * hold;
    for (const Curve &curve : plot.curves) {
        for (const PlotPoint &point : curve.points) {
            largest = std::max(largest, std::isfinite(point.y) ? point.y : 0.0);
        }
    }
    plot.y_range = PlotSpan{0.0, std::min(1.05 * largest, track.figure("width") / 2.0)};
    return plot;
}

Plot error_plot(const TrackRun &track) {
    Plot plot = time_plot(track, "error");
    plot.about = "Error of the ball's place in space over time";
    plot.y_label = "error in space, SMU";
    plot.log_y = true;
    plot.curves = {
        curve_over_time(track, "measured", {"#D55E00", 7}, Stroke::kDots, "meas_err"),
        curve_over_time(track, "tracked", {"#009E73", 7, 2.2}, Stroke::kSolid, "err"),
        curve_over_time(track, "its stated sigma", {"#7f7f7f", 7, 1.3}, Stroke::kDashed, "sigma")};
    const double asked = track.figure("asked", "err_rms");
    plot.levels.push_back({asked, fmt::format("asked (RMS): {}", asked)});
    return plot;
}

// From the run's middle: the ball is most likely in view and the head on the move.
std::string thumbnail(const ReportData &data, const TrackRun &track) {
    std::vector<std::string> pictures;
    const fs::path folder = fs::path(data.folder) / track.folder / "pictures";
    if (fs::is_directory(folder)) {
        for (const fs::directory_entry &entry : fs::directory_iterator(folder)) {
            pictures.push_back(entry.path().string());
        }
    }
    if (pictures.empty()) {
        return "";
    }
    std::sort(pictures.begin(), pictures.end());
    const std::string video =
        track.has_video
            ? fmt::format(" <a href=\"{0}/track.mp4\">The whole run as a video</a>.", track.folder)
            : "";
    return picture_figure(pictures[pictures.size() / 2],
                          "What the eyes have, left and right; the circle round the middle is the "
                          "bound that is asked." +
                              video);
}

std::string track_html(const ReportData &data, const TrackRun &track) {
    return heading("<code>" + escaped(track.folder) + "</code>") + thumbnail(data, track) +
           figure(
               offset_plot(track),
               fmt::format("<b>Where the ball is in the images</b> (the truth). Held within {:.0f} "
                           "px of both middles in {:.1f} % of the {:.0f} frames that count: from "
                           "half a second after it is first seen, not wholly covered.",
                           track.figure("hold_px"), 100.0 * track.figure("held_share"),
                           track.figure("counted_frames"))) +
           figure(error_plot(track),
                  fmt::format(
                      "<b>Where the library says it is, against the truth.</b> Points: each pair "
                      "of frames by itself; line: the tracker, which goes on through what is "
                      "hidden and says so. RMS of the frames it calls <code>ok</code> {} SMU, of "
                      "all in which any of the ball is visible {} SMU.",
                      smu(track.figure("err", "rms")), smu(track.figure("err_visible", "rms"))));
}

std::string overview_table(const std::vector<TrackRun> &tracks) {
    Table table("tracking", "The closed loop; coloured where a figure is asked for",
                {"run", "seconds", "frames", "held, %", "RMS, any of it visible, SMU",
                 "RMS of ok frames, SMU", "hidden frames", "ok while hidden",
                 "frames until it is had again"});
    for (const TrackRun &track : tracks) {
        const auto verdict = [&](bool reached) { return reached ? "good" : "bad"; };
        table.add({escaped(track.folder), plain(track.figure("seconds"), 1),
                   plain(track.figure("frames"), 0), plain(100.0 * track.figure("held_share"), 1),
                   smu(track.figure("err_visible", "rms")), smu(track.figure("err", "rms")),
                   plain(track.figure("hidden_frames"), 0),
                   plain(track.figure("ok_while_hidden"), 0),
                   plain(track.figure("reacquired_frames_max"), 0)},
                  {"", "", "", is_asked(track) ? verdict(holds(track)) : "",
                   is_asked(track) ? verdict(places(track)) : "", "", "",
                   verdict(track.figure("ok_while_hidden") == 0.0)});
    }
    return table.html();
}

} // namespace

Section tracking_section(const ReportData &data) {
    std::string html = paragraph(
        "The loop closed: both cameras' lines go through the library's eye, cone, stereo, head and "
        "tracker to its gaze, whose velocities turn the Bullet head while the ball rolls, flies, "
        "bounces and hides. Grey: neither eye sees any of it.");
    if (data.tracks.empty()) {
        html += absent(data, "track_");
    } else {
        html += overview_table(data.tracks);
        for (const TrackRun &track : data.tracks) {
            html += track_html(data, track);
        }
    }
    return {"tracking", "Tracking", html};
}

} // namespace sim
