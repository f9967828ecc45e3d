// SPDX-License-Identifier: MIT
//
// OpenCV's HOUGH_GRADIENT, threshold by threshold.
#ifndef OCELLUS_SIM_HOUGH_HPP
#define OCELLUS_SIM_HOUGH_HPP

#include <opencv2/core.hpp>
#include <optional>

#include "geometry/ellipse.hpp"

namespace sim {

// More votes than any circle in a frame gets.
constexpr int kVotesLimit = 512;

// What the transform is given: the mask, smoothed, as OpenCV advises.
cv::Mat hough_picture(const cv::Mat &mask);

// The strongest circle for this `param2`, the accumulator's threshold.
std::optional<Ellipse> hough_circle(const cv::Mat &picture, double param2);

// The largest whole threshold for which there is a circle, right or wrong; 0: none.
int most_votes(const cv::Mat &picture);

} // namespace sim

#endif
