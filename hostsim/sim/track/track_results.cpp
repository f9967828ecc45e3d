// SPDX-License-Identifier: MIT
#include "track/track_results.hpp"

#include <limits>

#include "support/statistics.hpp"
#include "track/track_truth.hpp"

namespace sim {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

constexpr const char *kHeader =
    "frame,time_s,true_x,true_y,true_z,visible_left,visible_right,covered_left,covered_right,"
    "hidden,counted,held,off_left_x,off_left_y,off_right_x,off_right_y,off,status_left,"
    "status_right,status_stereo,status,state,meas_x,meas_y,meas_z,meas_err,est_x,est_y,est_z,err,"
    "sigma,neck_pitch,neck_yaw,eyes_tilt,left_pan,right_pan,speed_neck_pitch,speed_neck_yaw,"
    "speed_eyes_tilt,speed_left_pan,speed_right_pan\n";

double error_of(const std::optional<Vec3> &p, const TrackFrame &frame) {
    return p ? cv::norm(*p - frame.p_true) : kNone;
}

std::string place(const Vec3 &p) {
    return field(p[0]) + field(p[1]) + field(p[2]);
}

std::string place_and_error(const std::optional<Vec3> &p, const TrackFrame &frame) {
    return place(p.value_or(Vec3(kNone, kNone, kNone))) + field(error_of(p, frame));
}

std::string both(const double (&values)[kSides]) {
    return field(values[kLeft]) + field(values[kRight]);
}

std::string in_degrees(const JointAngles &angles) {
    std::string fields;
    for (const double angle : angles) {
        fields += field(degrees(angle));
    }
    return fields;
}

std::string row(std::size_t number, const TrackFrame &frame) {
    std::string line = fmt::format("{}", number) + field(frame.time) + place(frame.p_true);
    line += both(frame.visible) + both(frame.covered);
    line += fmt::format(",{:d},{:d},{:d}", frame.hidden, frame.counted, frame.held);
    for (const cv::Point2d &offset : frame.offset) {
        line += field(offset.x) + field(offset.y);
    }
    line += field(off_middle(frame));
    line += fmt::format(",{},{},{},{},{}", ocel_status_name(frame.status_eye[kLeft]),
                        ocel_status_name(frame.status_eye[kRight]),
                        ocel_status_name(frame.status_stereo), ocel_status_name(frame.status),
                        state_name(frame.state));
    line += place_and_error(frame.p_measured, frame) + place_and_error(frame.p_track, frame);
    line += field(frame.p_track ? frame.sigma : kNone);
    return line + in_degrees(frame.angles) + in_degrees(frame.speeds) + "\n";
}

// How many frames are so.
template <typename Is> int count_of(const std::vector<TrackFrame> &frames, Is is) {
    return static_cast<int>(std::count_if(frames.begin(), frames.end(), is));
}

// Of `value` in the frames that are so.
template <typename Is, typename Value>
Statistics statistics_of(const std::vector<TrackFrame> &frames, Is is, Value value) {
    Statistics statistics;
    for (const TrackFrame &frame : frames) {
        if (is(frame)) {
            statistics.add(value(frame));
        }
    }
    return statistics;
}

Json json_of(const Statistics &statistics) {
    Json object{{"frames", statistics.count}};
    if (statistics.count > 0) {
        object["rms"] = rounded(statistics.rms());
        object["max"] = rounded(statistics.largest);
    }
    return object;
}

bool is_ok(const TrackFrame &frame) {
    return frame.status == OCEL_OK;
}

bool is_visible(const TrackFrame &frame) {
    return !frame.hidden;
}

double track_error(const TrackFrame &frame) {
    return error_of(frame.p_track, frame);
}

double measured_error(const TrackFrame &frame) {
    return error_of(frame.p_measured, frame);
}

// From the first frame in which the ball is hidden to the one in which the library
// has it again; one that is not over when the run is has no end.
struct Gap {
    double from;
    std::optional<double> until; // when it can be seen again
    int hidden = 0;
    int waiting = 0;    // frames in view before it is taken again
    bool taken = false; // it has been
};

// Hidden before it was ever seen is no gap.
std::vector<Gap> gaps_of(const std::vector<TrackFrame> &frames) {
    std::vector<Gap> gaps;
    bool seen = false;
    bool in_gap = false;
    for (const TrackFrame &frame : frames) {
        seen = seen || is_visible(frame);
        if (frame.hidden && seen) {
            if (!in_gap || gaps.back().until) {
                gaps.push_back({frame.time, std::nullopt});
            }
            in_gap = true;
            ++gaps.back().hidden;
        } else if (in_gap) {
            Gap &gap = gaps.back();
            gap.until = gap.until.value_or(frame.time);
            ++gap.waiting;
            gap.taken = is_ok(frame);
            in_gap = !gap.taken;
        }
    }
    return gaps;
}

Json json_of(const std::vector<Gap> &gaps) {
    Json list = Json::array();
    for (const Gap &gap : gaps) {
        Json object{{"from_s", rounded(gap.from)}, {"hidden_frames", gap.hidden}};
        if (gap.until) {
            object["until_s"] = rounded(*gap.until);
        }
        if (gap.taken) {
            object["reacquired_frames"] = gap.waiting;
        }
        list.push_back(object);
    }
    return list;
}

Json setting_json(const TrackScenario &scenario, std::uint64_t seed,
                  const std::vector<TrackFrame> &frames) {
    return {{"scenario", scenario.name},
            {"seed", seed},
            {"frames", frames.size()},
            {"seconds", rounded(scenario.duration)},
            {"width", scenario.camera.intrinsics.width},
            {"height", scenario.camera.intrinsics.height},
            {"supersampling", scenario.camera.supersampling}};
}

void add_holding(const TrackScenario &scenario, const std::vector<TrackFrame> &frames,
                 Json &summary) {
    const auto first = std::find_if(frames.begin(), frames.end(), is_visible);
    const auto is_counted = [](const TrackFrame &frame) { return frame.counted; };
    const int counted = count_of(frames, is_counted);
    const int held =
        count_of(frames, [](const TrackFrame &frame) { return frame.counted && frame.held; });
    summary["first_seen_s"] = first == frames.end() ? Json(nullptr) : Json(rounded(first->time));
    summary["hold_px"] = rounded(hold_px(scenario));
    summary["counted_frames"] = counted;
    summary["held_frames"] = held;
    summary["held_share"] = counted > 0 ? rounded(static_cast<double>(held) / counted) : 0.0;
    summary["off_px"] = json_of(statistics_of(frames, is_counted, off_middle));
}

void add_statuses(const std::vector<TrackFrame> &frames, Json &summary) {
    const auto in_state = [&frames](ocel_track_state_t state) {
        return count_of(frames, [state](const TrackFrame &frame) { return frame.state == state; });
    };
    summary["visible_frames"] = count_of(frames, is_visible);
    summary["hidden_frames"] = static_cast<int>(frames.size()) - count_of(frames, is_visible);
    summary["ok_frames"] = count_of(frames, is_ok);
    summary["refused_frames"] =
        count_of(frames, [](const TrackFrame &frame) { return frame.status == OCEL_PARTIAL; });
    summary["guessed_frames"] = in_state(OCEL_TRACK_GUESSED);
    summary["lost_frames"] = in_state(OCEL_TRACK_LOST);
    summary["ok_while_hidden"] =
        count_of(frames, [](const TrackFrame &frame) { return frame.hidden && is_ok(frame); });
}

void add_errors(const std::vector<TrackFrame> &frames, Json &summary) {
    const auto is_guess = [](const TrackFrame &frame) { return frame.state == OCEL_TRACK_GUESSED; };
    summary["err"] = json_of(statistics_of(frames, is_ok, track_error));
    summary["err_visible"] = json_of(statistics_of(frames, is_visible, track_error));
    summary["meas_err"] = json_of(statistics_of(frames, is_visible, measured_error));
    summary["guess_err"] = json_of(statistics_of(frames, is_guess, track_error));
}

void add_verdict(Json &summary) {
    const Json &error = summary["err"];
    summary["asked"] = {
        {"held_share", kHeldShare}, {"err_rms", kTrackErrorRms}, {"ok_while_hidden", 0}};
    summary["met"] = {{"held_share", summary["held_share"] >= kHeldShare},
                      {"err_rms", error.contains("rms") && error["rms"] <= kTrackErrorRms},
                      {"ok_while_hidden", summary["ok_while_hidden"] == 0}};
}

} // namespace

const char *state_name(ocel_track_state_t state) {
    switch (state) {
    case OCEL_TRACK_SEEN:
        return "seen";
    case OCEL_TRACK_GUESSED:
        return "guessed";
    case OCEL_TRACK_LOST:
    default:
        return "lost";
    }
}

double hold_px(const TrackScenario &scenario) {
    return kHoldPx * scenario.camera.intrinsics.width / 320.0;
}

std::string track_csv(const std::vector<TrackFrame> &frames) {
    std::string text = kHeader;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        text += row(i, frames[i]);
    }
    return text;
}

Json track_summary(const TrackScenario &scenario, std::uint64_t seed,
                   const std::vector<TrackFrame> &frames) {
    Json summary = setting_json(scenario, seed, frames);
    add_holding(scenario, frames, summary);
    add_statuses(frames, summary);
    add_errors(frames, summary);
    const std::vector<Gap> gaps = gaps_of(frames);
    summary["gaps"] = json_of(gaps);
    int longest = 0;
    for (const Gap &gap : gaps) {
        longest = std::max(longest, gap.waiting);
    }
    summary["reacquired_frames_max"] = longest;
    add_verdict(summary);
    return summary;
}

} // namespace sim
