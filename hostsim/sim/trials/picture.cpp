// SPDX-License-Identifier: MIT
#include "trials/picture.hpp"

#include <fmt/format.h>

#include "support/canvas.hpp"

namespace sim {

namespace {

struct Drawn {
    Method method;
    cv::Scalar ink;
};

// The first drawn lie below.
const Drawn kDrawn[] = {{Method::kHoughGradient, {255, 160, 0}},
                        {Method::kB2ac, kDoubtInk},
                        {Method::kSphere, kVouchedInk}};

const cv::Scalar *ink_of(Method method) {
    for (const Drawn &drawn : kDrawn) {
        if (drawn.method == method) {
            return &drawn.ink;
        }
    }
    return nullptr;
}

std::string errors_of(const MethodRecord &record) {
    if (std::isnan(record.error)) {
        return "";
    }
    return fmt::format("error {:.4f} SMU, radius {:+.2f} %", record.error, record.radius_error_pct);
}

void draw_method(const MethodRecord &record, const cv::Point &place, cv::Mat &canvas) {
    const cv::Scalar *const drawn = ink_of(record.method);
    const cv::Scalar ink = drawn == nullptr ? kWhite : *drawn;
    write_line(method_name(record.method), place, ink, canvas);
    write_line(ocel_status_name(record.status), place + cv::Point(120, 0), ink, canvas);
    write_line(errors_of(record), place + cv::Point(200, 0), ink, canvas);
}

void draw_legend(const Scenario &scenario, const TrialRecord &record, int top, cv::Mat &canvas) {
    write_line(fmt::format("{}: distance {:.2f} SMU, {:.1f} % hidden, trial {}", scenario.name,
                           record.distance, 100.0 * record.occlusion, record.trial),
               {8, top + kTextLine}, kWhite, canvas);
    for (int i = 0; i < record.method_count; ++i) {
        const cv::Point place(8 + i % 2 * (canvas.cols / 2), top + kTextLine * (2 + i / 2));
        draw_method(record.methods[i], place, canvas);
    }
}

cv::Mat eye_canvas(const Scenario &scenario, const TrialPictures &pictures, Side side) {
    cv::Mat canvas = enlarged_frame(pictures.frames[side], side == kLeft ? "left" : "right");
    for (const Drawn &drawn : kDrawn) {
        for (std::size_t i = 0; i < scenario.methods.size(); ++i) {
            const Outline &outline = pictures.outlines[i][side];
            if (scenario.methods[i] == drawn.method && outline.found) {
                draw_ellipse(outline.ellipse, drawn.ink, canvas);
            }
        }
    }
    return canvas;
}

} // namespace

cli::Image annotated_pair(const Scenario &scenario, const TrialRecord &record,
                          const TrialPictures &pictures) {
    const cv::Mat left = eye_canvas(scenario, pictures, kLeft);
    const cv::Mat right = eye_canvas(scenario, pictures, kRight);
    cv::Mat canvas = side_by_side(left, right, 2 + (record.method_count + 1) / 2);
    draw_legend(scenario, record, left.rows, canvas);
    return image_of(canvas);
}

} // namespace sim
