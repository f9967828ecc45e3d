// SPDX-License-Identifier: MIT
//
// One trial: a placement by chance, a fresh world, the gaze, one pair of frames,
// and every method on these.
#ifndef OCELLUS_SIM_TRIAL_HPP
#define OCELLUS_SIM_TRIAL_HPP

#include <array>
#include <memory>
#include <string>

#include "estimate.hpp"
#include "renderer.hpp"
#include "scenario.hpp"
#include "stage.hpp"

namespace sim {

// Which one.  What happens in it depends on these, and the scenario, alone.
struct TrialKey {
    std::size_t point;
    int trial;
    std::uint64_t seed;
};

// What one method made of it.  Plain numbers, so that a record can go through a
// pipe; what does not exist is not a number.
struct MethodRecord {
    Method method;
    ocel_status_t status;
    bool success; // both outlines: centre within .25 r, radius within 20 % of the truth
    double p_world[3];
    double error; // SMU, all three
    double error_encoder;
    double error_residual;
    double error_debiased; // a disc's: with its r^2/d taken off x
    double radius;
    double radius_error_pct;
    double radius_true_depth; // the outline's with the true depth: without stereo's error
    double radius_true_depth_error_pct;
    double centre_error_px; // of the outline, the worse eye
    int votes;              // Hough: the lower threshold of both eyes
};

struct TrialRecord {
    std::uint32_t point;
    std::int32_t trial;
    double distance;
    double occlusion; // as it came out, in the left eye
    double p_true[3];
    std::int32_t frames; // pairs drawn until the measured one, inclusive
    std::int32_t method_count;
    MethodRecord methods[kMethodCount];
};

// The pictures of a trial, for people.
struct TrialPictures {
    std::array<cli::Image, kSides> frames;
    std::vector<Outlines> outlines; // one a method
};

// What is made once in a process: the cameras and the detectors.
class Studio {
  public:
    explicit Studio(const Scenario &scenario);

    // pictures: null when they are not wanted.
    TrialRecord run(const TrialKey &key, TrialPictures *pictures);

  private:
    const Scenario &scenario_;
    Renderer renderer_;
    std::array<std::unique_ptr<Detector>, kSides> detectors_;
};

} // namespace sim

#endif
