// SPDX-License-Identifier: MIT
#include "camera_lines.hpp"

#include "error.hpp"

namespace cli {

namespace {

struct Rgb {
    std::uint8_t r;
    std::uint8_t g;
    std::uint8_t b;
};

Rgb pixel_of(const std::uint8_t *row, std::size_t x, std::uint32_t channels) {
    if (channels == 1) {
        return {row[x], row[x], row[x]};
    }
    return {row[3 * x], row[3 * x + 1], row[3 * x + 2]};
}

void put_pixel(ocel_format_t format, const Rgb &pixel, std::size_t x, std::uint8_t *line) {
    if (format == OCEL_FORMAT_RGB565) {
        const unsigned word = ((pixel.r & 0xf8U) << 8) | ((pixel.g & 0xfcU) << 3) | (pixel.b >> 3);
        line[2 * x] = static_cast<std::uint8_t>(word & 0xffU);
        line[2 * x + 1] = static_cast<std::uint8_t>(word >> 8);
    } else if (format == OCEL_FORMAT_GRAY8) {
        line[x] = pixel.g; // grey pictures only: line_format refuses the others
    } else {
        const bool red_first = format == OCEL_FORMAT_RGB888;
        line[3 * x] = red_first ? pixel.r : pixel.b;
        line[3 * x + 1] = pixel.g;
        line[3 * x + 2] = red_first ? pixel.b : pixel.r;
    }
}

} // namespace

ocel_format_t line_format(const std::string &name, const Image &image) {
    const bool grey = image.channels == 1;
    if (name == "auto") {
        return grey ? OCEL_FORMAT_GRAY8 : OCEL_FORMAT_RGB888;
    }
    if (name == "gray8" && !grey) {
        throw InputError("--format gray8: the picture is in colour; expected a grey one: leave the "
                         "option out and give --colour gray:v0-v1");
    }
    if (name == "gray8") {
        return OCEL_FORMAT_GRAY8;
    }
    if (name == "rgb565") {
        return OCEL_FORMAT_RGB565;
    }
    if (name == "rgb888") {
        return OCEL_FORMAT_RGB888;
    }
    if (name == "bgr888") {
        return OCEL_FORMAT_BGR888;
    }
    throw InputError("--format " + quoted(name) +
                     ": expected auto, rgb888, bgr888, rgb565 or gray8");
}

CameraLines::CameraLines(const Image &image, ocel_format_t format)
    : image_(image), format_(format),
      line_bytes_(ocel_colour_line_bytes(format, static_cast<std::uint16_t>(image.width))),
      buffer_(line_bytes_) {
}

const std::uint8_t *CameraLines::line(std::size_t y) {
    const std::uint8_t *const row = image_.row(y);
    for (std::size_t x = 0; x < image_.width; ++x) {
        put_pixel(format_, pixel_of(row, x, image_.channels), x, buffer_.data());
    }
    return buffer_.data();
}

} // namespace cli
