// SPDX-License-Identifier: MIT
#include "support/canvas.hpp"

#include <opencv2/imgproc.hpp>

namespace sim {

namespace {

constexpr double kTextSize = 0.42;

// Sub-pixel drawing: OpenCV takes whole numbers of 1/16 px.
constexpr int kShift = 4;

cv::Point fixed(const cv::Point2d &p) {
    return {cvRound(p.x * (1 << kShift)), cvRound(p.y * (1 << kShift))};
}

// A pixel's centre in the enlarged picture.
cv::Point2d enlarged(const cv::Point2d &p) {
    return {(p.x + 0.5) * kZoom - 0.5, (p.y + 0.5) * kZoom - 0.5};
}

} // namespace

cv::Mat enlarged_frame(const cli::Image &frame, const char *name) {
    cli::Image copy = frame; // OpenCV takes no constant data
    const cv::Mat small(static_cast<int>(copy.height), static_cast<int>(copy.width), CV_8UC3,
                        copy.pixels.data());
    cv::Mat canvas;
    cv::resize(small, canvas, cv::Size(), kZoom, kZoom, cv::INTER_NEAREST);
    write_line(name, {8, 16}, kDark, canvas);
    return canvas;
}

void draw_ellipse(const Ellipse &ellipse, const cv::Scalar &ink, cv::Mat &canvas) {
    const EllipseAxes axes = axes_of(ellipse);
    cv::ellipse(canvas, fixed(enlarged(ellipse.centre)), fixed({axes.a * kZoom, axes.b * kZoom}),
                axes.angle * 180.0 / kPi, 0, 360, ink, 1, cv::LINE_AA, kShift);
    draw_cross(ellipse.centre, ink, canvas);
}

void draw_circle(const cv::Point2d &centre, double radius, const cv::Scalar &ink, cv::Mat &canvas) {
    cv::circle(canvas, fixed(enlarged(centre)), cvRound(radius * kZoom * (1 << kShift)), ink, 1,
               cv::LINE_AA, kShift);
}

void draw_cross(const cv::Point2d &centre, const cv::Scalar &ink, cv::Mat &canvas) {
    const cv::Point2d middle = enlarged(centre);
    for (const cv::Point2d &arm : {cv::Point2d(5, 0), cv::Point2d(0, 5)}) {
        cv::line(canvas, fixed(middle - arm), fixed(middle + arm), ink, 1, cv::LINE_AA, kShift);
    }
}

void draw_box(const cv::Rect2d &box, const cv::Scalar &ink, cv::Mat &canvas) {
    cv::rectangle(canvas, enlarged(box.tl()), enlarged(box.br()), ink, 1);
}

void write_line(const std::string &text, const cv::Point &place, const cv::Scalar &ink,
                cv::Mat &canvas) {
    cv::putText(canvas, text, place, cv::FONT_HERSHEY_SIMPLEX, kTextSize, ink, 1, cv::LINE_AA);
}

cv::Mat side_by_side(const cv::Mat &left, const cv::Mat &right, int lines) {
    cv::Mat pair;
    cv::hconcat(left, right, pair);
    cv::Mat canvas(pair.rows + kTextLine * lines, pair.cols, CV_8UC3, kLegendGround);
    pair.copyTo(canvas.rowRange(0, pair.rows));
    return canvas;
}

cli::Image image_of(const cv::Mat &canvas) {
    cli::Image image;
    image.width = static_cast<std::uint32_t>(canvas.cols);
    image.height = static_cast<std::uint32_t>(canvas.rows);
    image.channels = 3;
    image.pixels.assign(canvas.datastart, canvas.dataend);
    return image;
}

} // namespace sim
