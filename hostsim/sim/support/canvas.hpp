// SPDX-License-Identifier: MIT
//
// Drawing on frames for people to look at: enlarged, so that fine lines fit between
// the pixels.
#ifndef OCELLUS_SIM_CANVAS_HPP
#define OCELLUS_SIM_CANVAS_HPP

#include <opencv2/core.hpp>
#include <string>

#include "geometry/ellipse.hpp"
#include "image.hpp"

namespace sim {

constexpr int kZoom = 2;
constexpr int kTextLine = 18; // px, of a legend

// Red, green, blue.
const cv::Scalar kWhite(235, 235, 235);
const cv::Scalar kDark(20, 20, 20);
const cv::Scalar kLegendGround(35, 35, 35);
const cv::Scalar kVouchedInk(60, 255, 80);
const cv::Scalar kDoubtInk(255, 70, 220);

// A frame, kZoom times as large, and its side's name on it.
cv::Mat enlarged_frame(const cli::Image &frame, const char *name);

// Places are pixels of the frame, lengths too.
void draw_ellipse(const Ellipse &ellipse, const cv::Scalar &ink, cv::Mat &canvas);
void draw_circle(const cv::Point2d &centre, double radius, const cv::Scalar &ink, cv::Mat &canvas);
void draw_cross(const cv::Point2d &centre, const cv::Scalar &ink, cv::Mat &canvas);
void draw_box(const cv::Rect2d &box, const cv::Scalar &ink, cv::Mat &canvas);

// A line of text; `place` is its lower left corner on the canvas.
void write_line(const std::string &text, const cv::Point &place, const cv::Scalar &ink,
                cv::Mat &canvas);

// Both eyes side by side, with room for `lines` of text below.
cv::Mat side_by_side(const cv::Mat &left, const cv::Mat &right, int lines);

cli::Image image_of(const cv::Mat &canvas);

} // namespace sim

#endif
