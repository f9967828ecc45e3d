// SPDX-License-Identifier: MIT
//
// The closed loop: both cameras' lines through the library's eye, cone, stereo,
// head and tracker to its gaze, which turns the Bullet head; and what came of it
// against the truth.
#ifndef OCELLUS_SIM_TRACK_HPP
#define OCELLUS_SIM_TRACK_HPP

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include <ocellus/track.h>

#include "track/track_scenario.hpp"
#include "world/paper_head.hpp"

namespace sim {

// What is asked of a run, from kSettle seconds after the ball is first seen.
constexpr double kSettle = 0.5;         // s
constexpr double kHoldPx = 20.0;        // of a picture 320 px wide
constexpr double kHeldShare = 0.95;     // of the frames in which it is visible, at least
constexpr double kTrackErrorRms = 0.02; // SMU, in frames with status ok, at most

// One pair of frames.  What does not exist is not a number.
struct TrackFrame {
    double time;                // s, of the exposure
    Vec3 p_true;                // world, SMU
    double visible[kSides];     // share of the ball's outline that is in the picture, unhidden
    double covered[kSides];     // share of it that something hides
    bool hidden;                // neither eye sees any of it
    bool counted;               // not wholly covered, and kSettle after it was first seen
    bool held;                  // within kHoldPx of the middle of both pictures
    cv::Point2d offset[kSides]; // px: where its centre is in truth, off the picture's middle
    ocel_status_t status_eye[kSides]; // of ocel_eye_cone
    ocel_status_t status_stereo;      // of ocel_stereo_ball; not_seen without a cone
    ocel_status_t status;             // of ocel_tracker_update
    ocel_track_state_t state;
    std::optional<Vec3> p_measured; // by stereo alone, when vouched for
    std::optional<Vec3> p_track;    // of the tracker: seen or guessed
    double sigma;                   // SMU, of p_track, as the tracker states it
    JointAngles angles;             // radians, at the exposure
    JointAngles speeds;             // radians/s, commanded before it
};

struct TrackOptions {
    std::uint64_t seed = 1;
    std::string out; // folder, made when missing
    bool video = false;
};

// What the processor's clock said; not part of any file.
struct TrackTimes {
    double loop = 0.0;    // s, without what only serves files and truth
    double library = 0.0; // s of it in the library
};

struct TrackResult {
    std::vector<TrackFrame> frames;
    nlohmann::ordered_json summary; // as in summary.json
    TrackTimes times;
};

// Runs the scenario and writes frames.csv, summary.json, pictures/frame_NNNN.png
// and, if asked for, track.mp4.  Shows its progress on stderr.  The same scenario and
// seed give the same files.
//
// frames.csv, a row a pair of frames: frame, time_s, true_{x,y,z}, visible_{left,right},
// covered_{left,right}, hidden, counted, held, off_{left,right}_{x,y} (px), off (px, the
// larger distance), status_{left,right,stereo}, status, state (seen | guessed | lost),
// meas_{x,y,z}, meas_err, est_{x,y,z}, err, sigma (SMU), the joints neck_pitch, neck_yaw,
// eyes_tilt, left_pan, right_pan (degrees) and speed_ of each (degrees/s).
//
// summary.json: scenario, seed, frames, seconds, width, height, supersampling,
// first_seen_s, counted_frames, held_frames, held_share, hold_px, off_px {rms, max} (of
// counted frames), visible_frames, ok_frames, refused_frames, guessed_frames, lost_frames,
// hidden_frames, ok_while_hidden, err {frames, rms, max} (of the track in ok frames),
// err_visible (in all visible ones, guesses included), meas_err, guess_err (the same),
// gaps [{from_s, to_s, hidden_frames, reacquired_frames}], reacquired_frames_max,
// asked {held_share, err_rms, ok_while_hidden} and met (the same keys, true or false).
TrackResult run_track(const TrackScenario &scenario, const TrackOptions &options);

// The figures against what is asked, for a terminal: a few lines.
std::string track_table(const TrackResult &result);

} // namespace sim

#endif
