// SPDX-License-Identifier: MIT
//
// A stereo pair with what the methods found drawn into it.
#ifndef OCELLUS_SIM_PICTURE_HPP
#define OCELLUS_SIM_PICTURE_HPP

#include "trials/scenario.hpp"
#include "trials/trial.hpp"

namespace sim {

// Left and right eye side by side, at twice their size, with the outlines and
// centres of the sphere, of b2ac and of Hough's circle, and a legend that gives
// each method's error.
cli::Image annotated_pair(const Scenario &scenario, const TrialRecord &record,
                          const TrialPictures &pictures);

} // namespace sim

#endif
