// SPDX-License-Identifier: MIT
//
// One trial: a placement by chance, a fresh world, the gaze, one pair of frames,
// and every method on these.
#ifndef OCELLUS_SIM_TRIAL_HPP
#define OCELLUS_SIM_TRIAL_HPP

#include <array>
#include <memory>
#include <string>

#include "camera/renderer.hpp"
#include "methods/estimate.hpp"
#include "trials/recording.hpp"
#include "trials/scenario.hpp"
#include "trials/stage.hpp"
#include "trials/trial_judge.hpp"
#include "trials/trial_record.hpp"
#include "trials/trial_seeds.hpp"

namespace sim {

// The pictures of a trial, for people.
struct TrialPictures {
    std::array<cli::Image, kSides> frames;
    std::vector<Outlines> outlines; // one a method
    Truth truth;                    // at the moment of the frames
};

// What is made once in a process: the cameras and the detectors.
class Studio {
  public:
    // recording: null when none is wanted.
    Studio(const Scenario &scenario, Recording *recording);

    // pictures: null when they are not wanted.
    TrialRecord run(const TrialKey &key, TrialPictures *pictures);

  private:
    const Scenario &scenario_;
    Renderer renderer_;
    Recording *recording_;
    std::array<std::unique_ptr<Detector>, kSides> detectors_;
};

} // namespace sim

#endif
