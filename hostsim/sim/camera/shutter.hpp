// SPDX-License-Identifier: MIT
//
// When a picture's lines take in light, and what there is to see meanwhile.
//
// Time t, s, is 0 at the frame's own moment: the middle of the exposure of the
// picture's middle.  Line y of `height` is exposed around (y + .5) / height - .5
// times the readout, so light comes in from -half_span() to +half_span().
#ifndef OCELLUS_SIM_SHUTTER_HPP
#define OCELLUS_SIM_SHUTTER_HPP

#include <functional>

#include "camera/drawing.hpp"

namespace sim {

// All at once, unless told otherwise.
struct Shutter {
    double exposure = 0.0; // s: how long each line takes in light
    int subframes = 1;     // drawings, evenly over the exposure, whose mean is the picture
    double readout = 0.0;  // s from the first line's exposure to that of the one after the last

    bool instant() const {
        return exposure == 0.0 && readout == 0.0;
    }
    double half_span() const {
        return (exposure + readout) / 2.0;
    }
};

// What a camera has before it.
struct View {
    Drawing drawing;
    Pose X_world_cam;
};

// The view at a time, at least from -half_span() to +half_span().
using Motion = std::function<View(double t)>;

} // namespace sim

#endif
