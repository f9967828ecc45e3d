// SPDX-License-Identifier: MIT
#include "picture.hpp"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

namespace sim {

namespace {

constexpr int kZoom = 2;
constexpr int kLine = 18; // px, of the legend
constexpr double kTextSize = 0.42;

struct Drawn {
    Method method;
    cv::Scalar ink;
};

// The first drawn lie below.
const Drawn kDrawn[] = {{Method::kHoughGradient, {255, 160, 0}},
                        {Method::kB2ac, {255, 70, 220}},
                        {Method::kSphere, {60, 255, 80}}};

const cv::Scalar kWhite(235, 235, 235);

// Sub-pixel drawing: OpenCV takes whole numbers of 1/16 px.
constexpr int kShift = 4;

cv::Point fixed(const cv::Point2d &p) {
    return {cvRound(p.x * (1 << kShift)), cvRound(p.y * (1 << kShift))};
}

// A pixel's centre in the enlarged picture.
cv::Point2d enlarged(const cv::Point2d &p) {
    return {(p.x + 0.5) * kZoom - 0.5, (p.y + 0.5) * kZoom - 0.5};
}

void draw_outline(const Outline &outline, const cv::Scalar &ink, cv::Mat &canvas) {
    const EllipseAxes axes = axes_of(outline.ellipse);
    const cv::Point2d centre = enlarged(outline.ellipse.centre);
    cv::ellipse(canvas, fixed(centre), fixed({axes.a * kZoom, axes.b * kZoom}),
                axes.angle * 180.0 / kPi, 0, 360, ink, 1, cv::LINE_AA, kShift);
    for (const cv::Point2d &arm : {cv::Point2d(5, 0), cv::Point2d(0, 5)}) {
        cv::line(canvas, fixed(centre - arm), fixed(centre + arm), ink, 1, cv::LINE_AA, kShift);
    }
}

void write(const std::string &text, const cv::Point &place, const cv::Scalar &ink,
           cv::Mat &canvas) {
    cv::putText(canvas, text, place, cv::FONT_HERSHEY_SIMPLEX, kTextSize, ink, 1, cv::LINE_AA);
}

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
    write(method_name(record.method), place, ink, canvas);
    write(ocel_status_name(record.status), place + cv::Point(120, 0), ink, canvas);
    write(errors_of(record), place + cv::Point(200, 0), ink, canvas);
}

void draw_legend(const Scenario &scenario, const TrialRecord &record, int top, cv::Mat &canvas) {
    write(fmt::format("{}: distance {:.2f} SMU, {:.1f} % hidden, trial {}", scenario.name,
                      record.distance, 100.0 * record.occlusion, record.trial),
          {8, top + kLine}, kWhite, canvas);
    for (int i = 0; i < record.method_count; ++i) {
        const cv::Point place(8 + i % 2 * (canvas.cols / 2), top + kLine * (2 + i / 2));
        draw_method(record.methods[i], place, canvas);
    }
}

cv::Mat eye_canvas(const Scenario &scenario, const TrialPictures &pictures, Side side) {
    cli::Image frame = pictures.frames[side];
    const cv::Mat small(static_cast<int>(frame.height), static_cast<int>(frame.width), CV_8UC3,
                        frame.pixels.data());
    cv::Mat canvas;
    cv::resize(small, canvas, cv::Size(), kZoom, kZoom, cv::INTER_NEAREST);
    for (const Drawn &drawn : kDrawn) {
        for (std::size_t i = 0; i < scenario.methods.size(); ++i) {
            const Outline &outline = pictures.outlines[i][side];
            if (scenario.methods[i] == drawn.method && outline.found) {
                draw_outline(outline, drawn.ink, canvas);
            }
        }
    }
    write(side == kLeft ? "left" : "right", {8, 16}, {20, 20, 20}, canvas);
    return canvas;
}

} // namespace

cli::Image annotated_pair(const Scenario &scenario, const TrialRecord &record,
                          const TrialPictures &pictures) {
    cv::Mat pair;
    cv::hconcat(eye_canvas(scenario, pictures, kLeft), eye_canvas(scenario, pictures, kRight),
                pair);
    const int legend = kLine * (2 + (record.method_count + 1) / 2);
    cv::Mat canvas(pair.rows + legend, pair.cols, CV_8UC3, cv::Scalar(35, 35, 35));
    pair.copyTo(canvas.rowRange(0, pair.rows));
    draw_legend(scenario, record, pair.rows, canvas);
    cli::Image image;
    image.width = static_cast<std::uint32_t>(canvas.cols);
    image.height = static_cast<std::uint32_t>(canvas.rows);
    image.channels = 3;
    image.pixels.assign(canvas.datastart, canvas.dataend);
    return image;
}

} // namespace sim
