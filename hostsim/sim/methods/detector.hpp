// SPDX-License-Identifier: MIT
//
// One camera's frame as the methods get it: the library is fed line by line in
// RGB565, and its colour test makes the mask that the other methods start from.
#ifndef OCELLUS_SIM_DETECTOR_HPP
#define OCELLUS_SIM_DETECTOR_HPP

#include <memory>
#include <opencv2/core.hpp>
#include <vector>

#include <ocellus/camera.h>
#include <ocellus/eye.h>

#include "camera/intrinsics.hpp"
#include "image.hpp"

namespace sim {

// For calls that are right by construction, so that a refusal is a mistake of ours:
// std::logic_error unless OCEL_OK.
void must(ocel_status_t status, const char *what);

class Detector {
  public:
    Detector(const Intrinsics &camera, const ocel_colour_range_t &colour, std::uint32_t min_area);

    // Takes a frame of the camera's size; what the others say is of the last one.
    void look(const cli::Image &frame);

    // Its two halves, for who measures the library's time: what the camera does, its
    // lines in RGB565, and what the library does with them.  No mask is made.
    void take(const cli::Image &frame);
    void feed();

    const Intrinsics &intrinsics() const {
        return intrinsics_;
    }
    const ocel_camera_t &camera() const {
        return camera_;
    }
    const ocel_eye_t &eye() const {
        return *eye_;
    }
    const ocel_detection_t &detection() const {
        return detection_;
    }
    // 255 where the colour is in range, else 0.
    const cv::Mat &mask() const {
        return mask_;
    }

  private:
    const std::uint8_t *line(int y) const {
        return lines_.data() + static_cast<std::size_t>(y) * line_bytes_;
    }
    void put_mask_row(int y);

    Intrinsics intrinsics_;
    ocel_camera_t camera_{};
    ocel_colour_t colour_{};
    ocel_colour_table_t table_{};
    std::unique_ptr<ocel_eye_t> eye_ = std::make_unique<ocel_eye_t>();
    ocel_detection_t detection_{};
    std::size_t line_bytes_ = 0;
    std::vector<std::uint8_t> lines_;
    cv::Mat mask_;
    std::vector<std::uint32_t> row_;
};

} // namespace sim

#endif
