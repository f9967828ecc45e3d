// SPDX-License-Identifier: MIT
//
// OpenCV's Hough transforms for circles, at their best: the accumulator's
// threshold is searched for each frame, where the paper had to fix one for all.
#include <opencv2/imgproc.hpp>

#include "methods.hpp"

namespace sim {

namespace {

constexpr double kBlurSigma = 1.5; // px: OpenCV's advice is to smooth first
constexpr int kMinRadius = 3;      // px

using Circles = std::vector<cv::Vec3f>;

// OpenCV counts votes in whole numbers: param2 is rounded.
Circles circles_with_votes(const cv::Mat &picture, int votes) {
    Circles circles;
    cv::HoughCircles(picture, circles, cv::HOUGH_GRADIENT, 1.0, picture.rows, 100.0, votes,
                     kMinRadius, picture.rows / 2);
    return circles;
}

// param2 of the other transform is how perfect a circle must be, of 1.
Circles circles_with_perfection(const cv::Mat &picture, int percent) {
    Circles circles;
    cv::HoughCircles(picture, circles, cv::HOUGH_GRADIENT_ALT, 1.5, picture.rows, 300.0,
                     percent / 100.0, kMinRadius, picture.rows / 2);
    return circles;
}

struct Found {
    Circles circles; // the strongest first
    int threshold = 0;
};

// The largest number of votes for which there is a circle: bisection, as a
// higher threshold never finds more.
Found most_votes(const cv::Mat &picture) {
    Found best;
    int low = 0; // has a circle, or is 0
    int high = 512;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        Circles circles = circles_with_votes(picture, middle);
        if (circles.empty()) {
            high = middle;
        } else {
            best = {circles, middle};
            low = middle;
        }
    }
    return best;
}

Found most_perfect(const cv::Mat &picture) {
    for (int percent = 95; percent >= 20; percent -= 5) {
        Circles circles = circles_with_perfection(picture, percent);
        if (!circles.empty()) {
            return {circles, percent};
        }
    }
    return {};
}

} // namespace

Outline hough_outline(Method method, const Detector &detector) {
    if (cv::countNonZero(detector.mask()) == 0) {
        return {};
    }
    cv::Mat picture;
    cv::GaussianBlur(detector.mask(), picture, cv::Size(), kBlurSigma);
    const Found found = method == Method::kHoughAlt ? most_perfect(picture) : most_votes(picture);
    if (found.circles.empty()) {
        return {};
    }
    const cv::Vec3d circle = found.circles[0];
    const double area = circle[2] * circle[2];
    Outline outline = outline_of({{circle[0], circle[1]}, cv::Matx22d(area, 0, 0, area)}, OCEL_OK,
                                 detector.intrinsics());
    outline.votes = found.threshold;
    return outline;
}

} // namespace sim
