// SPDX-License-Identifier: MIT
//
// A recording: what the library's eyes were fed, and what it answered on this
// machine, for a replay on another one (tests/firmware).
//
//   manifest.txt   name and numbers, a line each: version, width, height (px),
//                  colour (space, lows, highs of ocel_colour_range_t), min_area (px),
//                  radius_u, intrinsics (in the order of ocel_intrinsics_t, without
//                  width and height)
//   frames.rgb565  the lines as the camera gives them: for each pair the left
//                  frame, then the right one
//   pairs.csv      a row a pair: point, trial, frame, and the joints, turns Q32,
//                  in the order of ocel_joint_t
//   answers.csv    a row a pair: point, trial, frame, and every member of the
//                  answers (answers.h), as the whole numbers that they are
#ifndef OCELLUS_SIM_RECORDING_HPP
#define OCELLUS_SIM_RECORDING_HPP

#include <array>
#include <fstream>
#include <memory>
#include <string>

#include "methods/detector.hpp"
#include "trials/trial_seeds.hpp"
#include "world/paper_head.hpp"

namespace sim {

// A pair of frames that both detectors have looked at.
struct SeenPair {
    const TrialKey &key;
    int frame; // of the trial, from 0
    const std::array<cli::Image, kSides> &frames;
    const std::array<std::unique_ptr<Detector>, kSides> &detectors;
    JointAngles angles;
};

class Recording {
  public:
    // Begins the files in a folder, which must be there.  cli::InputError when one cannot
    // be written, now or later.
    Recording(const std::string &folder, const Setting &setting);

    void add(const SeenPair &pair);

  private:
    void write_manifest(const Setting &setting);
    void write_frame(const cli::Image &frame);

    std::string folder_;
    std::int32_t radius_u_;
    std::ofstream frames_;
    std::ofstream pairs_;
    std::ofstream answers_;
    bool titled_ = false; // answers.csv
};

} // namespace sim

#endif
