// SPDX-License-Identifier: MIT
#include "report/report_claims.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "report/report_text.hpp"

namespace sim {

namespace {

bool is_hough(const std::string &method) {
    return method.rfind("hough", 0) == 0;
}

Claim error_claim(const SweepResult &sweep, const std::string &what, const std::string &column,
                  const std::vector<std::string> &methods, double limit) {
    Claim claim{what, fmt::format("≤ {} SMU", limit), "", true};
    for (const std::string &method : methods) {
        const double mean = sweep.all(method, column, "mean");
        claim.found +=
            fmt::format("{}<code>{}</code> {}", claim.found.empty() ? "" : ", ", method, smu(mean));
        claim.reached = claim.reached && mean <= limit;
    }
    return claim;
}

// The paper's order: every Hough transform is worse than every fit.
Claim order_claim(const SweepResult &sweep) {
    double best_hough = HUGE_VAL;
    double worst_fit = 0.0;
    for (const std::string &method : sweep.methods()) {
        const double mean = sweep.all(method, "err", "mean");
        if (is_hough(method)) {
            best_hough = std::min(best_hough, mean);
        } else {
            worst_fit = std::max(worst_fit, mean);
        }
    }
    return {"(c) the paper's order: Hough's error is the largest", "above every fit's",
            fmt::format("best Hough {}, worst fit {} SMU", smu(best_hough), smu(worst_fit)),
            best_hough > worst_fit};
}

Claim straight_claim(const SweepResult &sweep) {
    Claim claim{"(b) the fits of the whole boundary lose radius in a straight line",
                fmt::format("about {:.0f} % at 50 % hidden (± {:.0f}), r² ≥ {}", kHalfHiddenPct,
                            kHalfHiddenSlack, kStraightness),
                "", true};
    const std::size_t last = sweep.points().size() - 1;
    for (const char *const method : {"b2ac", "lcse"}) {
        const double half = sweep.at(method, last, "radius_true_depth_err_pct", "mean");
        const double r2 = sweep.trend(method, "trend_radius_pct", "r2");
        claim.found += fmt::format("{}<code>{}</code> {} at {:.0f} %, r² {:.3f}",
                                   claim.found.empty() ? "" : "; ", method, percent(half),
                                   100.0 * sweep.points()[last], r2);
        claim.reached = claim.reached && r2 >= kStraightness &&
                        std::fabs(half - kHalfHiddenPct) <= kHalfHiddenSlack;
    }
    return claim;
}

// The two readings of the radius: with the depth that is found and with the true one.
constexpr const char *kRadiusColumns[] = {"radius_err_pct", "radius_true_depth_err_pct"};

Claim sphere_radius_claim(const SweepResult &sweep) {
    double worst = 0.0;
    bool whole = true;
    for (const char *const column : kRadiusColumns) {
        for (std::size_t i = 0; i < sweep.points().size(); ++i) {
            const double mean = sweep.at("sphere", i, column, "mean");
            whole = whole && std::isfinite(mean);
            worst = std::fabs(mean) > std::fabs(worst) ? mean : worst;
        }
    }
    return {"(b) <code>sphere</code>'s radius at every occlusion, in the mean",
            fmt::format("within ± {} %", kSphereRadiusPct), fmt::format("worst {}", percent(worst)),
            whole && std::fabs(worst) <= kSphereRadiusPct};
}

Claim never_worse_claim(const SweepResult &sweep) {
    double closest = 0.0; // the largest share of a Hough's error
    int compared = 0;
    for (const char *const column : kRadiusColumns) {
        for (const char *const hough : {"hough_gradient", "hough_alt"}) {
            for (std::size_t i = 0; i < sweep.points().size(); ++i) {
                const double theirs = sweep.at(hough, i, column, "rms");
                if (std::isfinite(theirs)) {
                    closest = std::max(closest, sweep.at("sphere", i, column, "rms") / theirs);
                    ++compared;
                }
            }
        }
    }
    return {"(b) <code>sphere</code> against OpenCV's Hough, RMS of the radius's error",
            "never worse, at any point",
            fmt::format("at most {:.2f} of Hough's, of {} comparisons", closest, compared),
            compared > 0 && closest <= 1.0};
}

void add_sweep_claims(const ReportData &data, std::vector<Claim> &claims) {
    if (const SweepResult *const c = data.sweep("c_distance")) {
        claims.push_back(error_claim(*c, "(c) position of the ball, <code>sphere</code>, mean",
                                     "err", {"sphere"}, kSphereError));
        claims.push_back(error_claim(*c, "(c) the same, the paper's fits: near .007", "err",
                                     {"b2ac", "lcse"}, kEllipseError));
        claims.push_back(order_claim(*c));
    }
    if (const SweepResult *const b = data.sweep("b_occlusion")) {
        claims.push_back(straight_claim(*b));
        claims.push_back(sphere_radius_claim(*b));
        claims.push_back(never_worse_claim(*b));
    }
    if (const SweepResult *const a = data.sweep("a_cylinder")) {
        claims.push_back(error_claim(*a, "(a) position of the disc without its bias r²/d, mean",
                                     "err_debiased", {"b2ac", "lcse"}, kDebiasedError));
    }
}

void add_track_claims(const TrackRun &track, std::vector<Claim> &claims) {
    const std::string name = "<code>" + escaped(track.folder) + "</code>: ";
    if (is_asked(track)) {
        claims.push_back(
            {name + fmt::format("held within {:.0f} px of both images' middles",
                                track.figure("hold_px")),
             fmt::format("≥ {:.0f} % of the frames", 100.0 * track.figure("asked", "held_share")),
             fmt::format("{:.1f} % of {:.0f}", 100.0 * track.figure("held_share"),
                         track.figure("counted_frames")),
             holds(track)});
        claims.push_back({name + "error in space while any of it is visible, RMS",
                          fmt::format("≤ {} SMU", track.figure("asked", "err_rms")),
                          smu(track.figure("err_visible", "rms")), places(track)});
    }
    claims.push_back({name + "frames called <code>ok</code> while the ball is hidden", "none",
                      fmt::format("{:.0f} of {:.0f}", track.figure("ok_while_hidden"),
                                  track.figure("hidden_frames")),
                      track.figure("ok_while_hidden") == 0.0});
}

void add_speed_claims(const Json &clock, std::vector<Claim> &claims) {
    const Json tracks = clock.value("tracks", Json::object());
    for (const auto &[name, times] : tracks.items()) {
        const double rate = times.value("frames_per_second", 0.0);
        claims.push_back({"<code>" + escaped(name) + "</code>: speed of the whole loop, one core",
                          fmt::format("≥ {:.0f} stereo frames/s", kFramesPerSecond),
                          fmt::format("{:.1f}; the library's share {:.1f} %", rate,
                                      100.0 * times.value("library_share", 0.0)),
                          rate >= kFramesPerSecond});
    }
}

} // namespace

bool is_asked(const TrackRun &track) {
    return track.folder == "track_throw" || track.folder == "track_bounce";
}

bool holds(const TrackRun &track) {
    return track.figure("held_share") >= track.figure("asked", "held_share");
}

bool places(const TrackRun &track) {
    return track.figure("err_visible", "rms") <= track.figure("asked", "err_rms");
}

std::vector<Claim> claims_of(const ReportData &data) {
    std::vector<Claim> claims;
    add_sweep_claims(data, claims);
    for (const TrackRun &track : data.tracks) {
        add_track_claims(track, claims);
    }
    if (data.clock) {
        add_speed_claims(*data.clock, claims);
    }
    return claims;
}

} // namespace sim
