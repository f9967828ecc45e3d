// SPDX-License-Identifier: MIT
//
// Two of the paper's yardsticks in double: B2AC as its authors print it, and
// Maini's EDFE, which fits M noisy copies of the points and takes the mean.
// Both start from the mask's inner boundary pixels, as OpenCV's contours and
// the paper have them.
#include <opencv2/imgproc.hpp>

#include "methods/methods.hpp"
#include "support/random.hpp"

namespace sim {

namespace {

using Points = std::vector<cv::Point2d>;
using Vec6 = cv::Vec<double, 6>;
using Mat6 = cv::Matx<double, 6, 6>;

// Of the points mapped to the square +-1.  Maini states no figure; this is the
// amplitude that the paper perturbs with.
constexpr double kResamplingSigma = 0.001;

// The largest outer contour's pixels.
Points inner_boundary(const cv::Mat &mask) {
    std::vector<std::vector<cv::Point>> contours;
    cv::findContours(mask, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    double most = -1.0;
    Points boundary;
    for (const auto &contour : contours) {
        const double area = cv::contourArea(contour);
        if (area > most) {
            most = area;
            boundary.assign(contour.begin(), contour.end());
        }
    }
    return boundary;
}

// Eqs. 9 and 10: the points' box becomes the square +-1.
struct Square {
    cv::Point2d middle;
    cv::Point2d half;
};

Square square_around(const Points &points) {
    cv::Point2d low = points[0];
    cv::Point2d high = points[0];
    for (const cv::Point2d &p : points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    return {(low + high) / 2.0, (high - low) / 2.0};
}

Points mapped(const Points &points, const Square &square) {
    Points out;
    for (const cv::Point2d &p : points) {
        out.emplace_back((p.x - square.middle.x) / square.half.x,
                         (p.y - square.middle.y) / square.half.y);
    }
    return out;
}

Ellipse mapped_back(const Ellipse &ellipse, const Square &square) {
    const cv::Matx22d scale(square.half.x, 0, 0, square.half.y);
    return {{ellipse.centre.x * square.half.x + square.middle.x,
             ellipse.centre.y * square.half.y + square.middle.y},
            scale * ellipse.shape * scale};
}

// S = D'D of eq. 7.
Mat6 scatter(const Points &points) {
    Mat6 sum = Mat6::zeros();
    for (const cv::Point2d &p : points) {
        const Vec6 row(p.x * p.x, p.x * p.y, p.y * p.y, p.x, p.y, 1.0);
        sum += row * row.t();
    }
    return sum;
}

Mat6 constraint() {
    Mat6 c = Mat6::zeros();
    c(0, 2) = c(2, 0) = 2.0;
    c(1, 1) = -1.0;
    return c;
}

// "The one positive eigenvalue" of S^-1 C.  Three of the six are zero but for
// rounding; on points exactly on an ellipse S has no inverse, and there is no
// answer.
std::optional<Ellipse> strict_fit(const Points &points) {
    Mat6 system;
    if (cv::solve(scatter(points), constraint(), system, cv::DECOMP_LU) == 0.0) {
        return std::nullopt;
    }
    cv::Mat values;
    cv::Mat vectors;
    cv::eigenNonSymmetric(cv::Mat(system), values, vectors);
    double largest = 0.0;
    for (int i = 0; i < 6; ++i) {
        largest = std::max(largest, std::fabs(values.at<double>(i)));
    }
    int chosen = -1;
    int positive = 0;
    for (int i = 0; i < 6; ++i) {
        if (values.at<double>(i) > 1e-12 * largest) {
            chosen = i;
            ++positive;
        }
    }
    if (positive != 1) {
        return std::nullopt;
    }
    const double *const a = vectors.ptr<double>(chosen);
    return ellipse_of_conic(
        {a[0], a[1] / 2, a[3] / 2, a[1] / 2, a[2], a[4] / 2, a[3] / 2, a[4] / 2, a[5]});
}

std::optional<Ellipse> resampled_fit(const Points &points, int resamplings, std::uint64_t seed) {
    Random random(seed);
    Ellipse sum{{0, 0}, cv::Matx22d::zeros()};
    int fits = 0;
    for (int i = 0; i < resamplings; ++i) {
        Points noisy = points;
        for (cv::Point2d &p : noisy) {
            p.x += kResamplingSigma * random.normal();
            p.y += kResamplingSigma * random.normal();
        }
        const std::optional<Ellipse> fit = strict_fit(noisy);
        if (fit) {
            sum.centre += fit->centre;
            sum.shape += fit->shape;
            ++fits;
        }
    }
    if (fits == 0) {
        return std::nullopt;
    }
    return Ellipse{sum.centre / fits, sum.shape * (1.0 / fits)};
}

Outline failed(ocel_status_t status) {
    Outline outline;
    outline.status = status;
    return outline;
}

} // namespace

Outline textbook_outline(Method method, const Detector &detector, std::uint64_t seed) {
    const Points points = inner_boundary(detector.mask());
    if (points.size() < OCEL_MIN_FIT_POINTS) {
        return failed(points.empty() ? OCEL_NOT_SEEN : OCEL_TOO_FEW_POINTS);
    }
    const Square square = square_around(points);
    if (square.half.x == 0.0 || square.half.y == 0.0) {
        return failed(OCEL_DEGENERATE);
    }
    const Points even = mapped(points, square);
    const int resamplings = method == Method::kEdfe ? 50 : 200;
    const std::optional<Ellipse> fit =
        method == Method::kB2acStrict ? strict_fit(even) : resampled_fit(even, resamplings, seed);
    return fit ? outline_of(mapped_back(*fit, square), OCEL_OK, detector.intrinsics())
               : failed(OCEL_DEGENERATE);
}

} // namespace sim
