// SPDX-License-Identifier: MIT
//
// A picture of what was found.
#ifndef OCELLUS_CLI_ANNOTATE_HPP
#define OCELLUS_CLI_ANNOTATE_HPP

#include <ocellus/eye.h>

#include "image.hpp"

namespace cli {

// A copy of `image` in colour, of the same size, with the blob's box (thin),
// the ellipse's outline and a cross at its centre, or at the blob's centroid
// when there is no ellipse.  Green: vouched for; magenta: an estimate.
Image annotated(const Image &image, const ocel_detection_t &detection);

} // namespace cli

#endif
