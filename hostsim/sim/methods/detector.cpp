// SPDX-License-Identifier: MIT
#include "methods/detector.hpp"

#include <stdexcept>
#include <string>

#include "camera_lines.hpp"

namespace sim {

void must(ocel_status_t status, const char *what) {
    if (status != OCEL_OK) {
        throw std::logic_error(std::string(what) + ": the library says " +
                               ocel_status_name(status));
    }
}

Detector::Detector(const Intrinsics &camera, const ocel_colour_range_t &colour,
                   std::uint32_t min_area)
    : intrinsics_(camera), mask_(camera.height, camera.width, CV_8UC1),
      row_(static_cast<std::size_t>(camera.width + 31) / 32) {
    const ocel_intrinsics_t intrinsics = library_intrinsics(camera);
    ocel_eye_config_t config{};
    config.width = intrinsics.width;
    config.height = intrinsics.height;
    config.min_area = min_area;
    must(ocel_camera_init(&camera_, &intrinsics), "ocel_camera_init");
    must(ocel_colour_compile(&colour_, &colour, OCEL_FORMAT_RGB565, &table_),
         "ocel_colour_compile");
    must(ocel_eye_init(eye_.get(), &config), "ocel_eye_init");
}

void Detector::look(const cli::Image &frame) {
    take(frame);
    feed();
    for (int y = 0; y < intrinsics_.height; ++y) {
        put_mask_row(y);
    }
}

void Detector::take(const cli::Image &frame) {
    cli::CameraLines lines(frame, OCEL_FORMAT_RGB565);
    line_bytes_ = lines.line_bytes();
    lines_.clear();
    for (std::size_t y = 0; y < frame.height; ++y) {
        const std::uint8_t *const line = lines.line(y);
        lines_.insert(lines_.end(), line, line + line_bytes_);
    }
}

void Detector::feed() {
    must(ocel_eye_begin(eye_.get()), "ocel_eye_begin");
    for (int y = 0; y < intrinsics_.height; ++y) {
        must(ocel_eye_line(eye_.get(), &colour_, static_cast<std::uint16_t>(y), line(y),
                           line_bytes_),
             "ocel_eye_line");
    }
    (void)ocel_eye_end(eye_.get(), &detection_); // the same as detection_.status
}

void Detector::put_mask_row(int y) {
    const auto width = static_cast<std::uint16_t>(intrinsics_.width);
    must(ocel_colour_row(&colour_, line(y), line_bytes_, width, row_.data()), "ocel_colour_row");
    std::uint8_t *const out = mask_.ptr<std::uint8_t>(y);
    for (unsigned x = 0; x < width; ++x) {
        out[x] = (row_[x / 32] >> (x % 32) & 1U) != 0U ? 255U : 0U;
    }
}

} // namespace sim
