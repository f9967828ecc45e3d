// SPDX-License-Identifier: MIT
//
// A scenario of the closed loop: a ball that moves, what hides it, and how the
// head follows.  One TOML file each.
#ifndef OCELLUS_SIM_TRACK_SCENARIO_HPP
#define OCELLUS_SIM_TRACK_SCENARIO_HPP

#include <vector>

#include "trials/scenario.hpp"

namespace sim {

constexpr double kTrackRate = 30.0; // stereo frames a second

// How the ball starts.  It is held in its place until it is let go.
struct BallStart {
    Vec3 p_world;    // SMU
    Vec3 v_world;    // SMU/s
    double release;  // s
    double mass;     // kg
    double bounce;   // share of its speed that a bounce leaves
    double jitter;   // SMU: its place is so far off along each axis at most, by chance
    double jitter_v; // SMU/s: the same for its velocity
};

// A box that stands in the way of sight, its sides along the world's axes.
struct Screen {
    Vec3 p_world; // its middle, SMU
    Vec3 size;    // SMU
};

// The library's tracker, in SMU and s (ocellus/track.h).
struct TrackerChoice {
    double coast;
    double max_speed;
    double wander;
    double gate;
    double gate_floor;
    bool gravity;
};

// The library's gaze (ocellus/gaze.h), and what it is told: where the track will be.
struct GazeChoice {
    double gain;   // 1/s, of the eyes
    double lead;   // s ahead of the moment of the command
    double follow; // SMU: a track is followed while its deviation is below
    bool floor;    // known: the ball is not expected below it
};

struct TrackScenario : Setting {
    double duration; // s
    double latency;  // s, from a frame's exposure to the command that answers it
    Vec3 looks_at;   // where the head looks at the beginning, SMU
    BallStart ball;
    std::vector<Screen> screens;
    TrackerChoice tracker;
    GazeChoice gaze;
};

// cli::InputError with file, line, column and what was expected.
TrackScenario read_track_scenario(const std::string &path);

} // namespace sim

#endif
