// SPDX-License-Identifier: MIT
//
// A picture as a camera would deliver it: line by line, in a pixel format.
#ifndef OCELLUS_COMMON_CAMERA_LINES_HPP
#define OCELLUS_COMMON_CAMERA_LINES_HPP

#include <cstdint>
#include <string>
#include <vector>

#include <ocellus/colour.h>

#include "image.hpp"

namespace cli {

// `auto` (rgb888 for colour, gray8 for grey pictures), `rgb888`, `bgr888`,
// `rgb565` or `gray8`; InputError for another name, and for gray8 of a picture
// in colour.
ocel_format_t line_format(const std::string &name, const Image &image);

// The lines of one picture.  `image` must outlive it.
class CameraLines {
  public:
    CameraLines(const Image &image, ocel_format_t format);

    ocel_format_t format() const {
        return format_;
    }
    std::size_t line_bytes() const {
        return line_bytes_;
    }
    // Line y; valid until the next call.
    const std::uint8_t *line(std::size_t y);

  private:
    const Image &image_;
    ocel_format_t format_;
    std::size_t line_bytes_;
    std::vector<std::uint8_t> buffer_;
};

} // namespace cli

#endif
