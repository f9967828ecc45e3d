// SPDX-License-Identifier: MIT
//
// OpenCV's Hough transforms for circles, at their best: the accumulator's
// threshold is searched for each frame, where the paper had to fix one for all.
#include <opencv2/imgproc.hpp>

#include "methods/hough.hpp"
#include "methods/methods.hpp"

namespace sim {

namespace {

constexpr double kBlurSigma = 1.5; // px: OpenCV's advice is to smooth first
constexpr int kMinRadius = 3;      // px

using Circles = std::vector<cv::Vec3f>;

std::optional<Ellipse> strongest(const Circles &circles) {
    if (circles.empty()) {
        return std::nullopt;
    }
    const cv::Vec3d circle = circles[0];
    const double radius_sq = circle[2] * circle[2];
    return Ellipse{{circle[0], circle[1]}, cv::Matx22d(radius_sq, 0, 0, radius_sq)};
}

// param2 of the other transform is how perfect a circle must be, of 1.
std::optional<Ellipse> circle_with_perfection(const cv::Mat &picture, int percent) {
    Circles circles;
    cv::HoughCircles(picture, circles, cv::HOUGH_GRADIENT_ALT, 1.5, picture.rows, 300.0,
                     percent / 100.0, kMinRadius, picture.rows / 2);
    return strongest(circles);
}

struct Found {
    std::optional<Ellipse> circle;
    int threshold = 0;
};

Found most_voted(const cv::Mat &picture) {
    const int votes = most_votes(picture);
    return votes > 0 ? Found{hough_circle(picture, votes), votes} : Found{};
}

Found most_perfect(const cv::Mat &picture) {
    for (int percent = 95; percent >= 20; percent -= 5) {
        const auto circle = circle_with_perfection(picture, percent);
        if (circle) {
            return {circle, percent};
        }
    }
    return {};
}

} // namespace

cv::Mat hough_picture(const cv::Mat &mask) {
    cv::Mat picture;
    cv::GaussianBlur(mask, picture, cv::Size(), kBlurSigma);
    return picture;
}

std::optional<Ellipse> hough_circle(const cv::Mat &picture, double param2) {
    Circles circles;
    cv::HoughCircles(picture, circles, cv::HOUGH_GRADIENT, 1.0, picture.rows, 100.0, param2,
                     kMinRadius, picture.rows / 2);
    return strongest(circles);
}

// Bisection, as a higher threshold never finds more.
int most_votes(const cv::Mat &picture) {
    int low = 0; // has a circle, or is 0
    int high = kVotesLimit;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        (hough_circle(picture, middle) ? low : high) = middle;
    }
    return low;
}

Outline hough_outline(Method method, const Detector &detector) {
    if (cv::countNonZero(detector.mask()) == 0) {
        return {};
    }
    const cv::Mat picture = hough_picture(detector.mask());
    const Found found = method == Method::kHoughAlt ? most_perfect(picture) : most_voted(picture);
    if (!found.circle) {
        return {};
    }
    Outline outline = outline_of(*found.circle, OCEL_OK, detector.intrinsics());
    outline.votes = found.threshold;
    return outline;
}

} // namespace sim
