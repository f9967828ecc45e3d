// SPDX-License-Identifier: MIT
//
// A picture of what was found.
#ifndef OCELLUS_CLI_ANNOTATE_HPP
#define OCELLUS_CLI_ANNOTATE_HPP

#include <string>

#include <ocellus/eye.h>

#include "image.hpp"

namespace cli {

// What else is to be seen.
struct Overlay {
    std::string label;                   // digits and `/`, below the blob's box
    const ocel_camera_t *lens = nullptr; // through which the ellipse is seen; null: as it is
};

// A copy of `image` in colour, of the same size, with the blob's box (thin),
// the ellipse's outline and a cross at its centre, or at the blob's centroid
// when there is no ellipse.  Green: vouched for; magenta: an estimate.
Image annotated(const Image &image, const ocel_detection_t &detection, const Overlay &overlay);

} // namespace cli

#endif
