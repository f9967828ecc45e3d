// SPDX-License-Identifier: MIT
//
// A pair of frames of the closed loop, for people.
#ifndef OCELLUS_SIM_TRACK_PICTURE_HPP
#define OCELLUS_SIM_TRACK_PICTURE_HPP

#include "track/track_loop.hpp"

namespace sim {

// Both eyes, enlarged: the circle within which the ball is held, the ball's outline
// as the library has it (green: vouched for, magenta: an estimate), where the track
// had said that it would be (the box) and is (a cross: white seen, orange guessed).
// Below: status, errors, joints.
cli::Image annotated_pair(const TrackScenario &scenario, const TrackLoop &loop,
                          const TrackFrame &frame);

} // namespace sim

#endif
