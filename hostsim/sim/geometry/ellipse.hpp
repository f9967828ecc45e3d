// SPDX-License-Identifier: MIT
//
// Ellipses in double, for the truth and for the yardsticks.
#ifndef OCELLUS_SIM_ELLIPSE_HPP
#define OCELLUS_SIM_ELLIPSE_HPP

#include <opencv2/core/types.hpp>
#include <optional>
#include <vector>

#include <ocellus/types.h>

#include "geometry/geometry.hpp"

namespace sim {

// (x - centre)' shape^-1 (x - centre) = 1: the eigenvalues of shape are the
// squares of the semi-axes.  It can be averaged, as axes and angle cannot.
struct Ellipse {
    cv::Point2d centre; // px
    cv::Matx22d shape;  // px^2
};

// Semi-axes a >= b, px; angle of the major axis from +x towards +y, radians, [0, pi).
struct EllipseAxes {
    double a;
    double b;
    double angle;
};

EllipseAxes axes_of(const Ellipse &ellipse);

// From A x^2 + B xy + C y^2 + D x + E y + F = 0 as the symmetric matrix of
// (x, y, 1); nothing when it is no real ellipse.
std::optional<Ellipse> ellipse_of_conic(const Mat3 &conic);

// A sphere of `radius` at p_cam, as a camera with the matrix K sees it: in
// normalised rays M = C C' - (|C|^2 - R^2) I.  Nothing when it is not all in
// front.
std::optional<Ellipse> outline_of_sphere(const Mat3 &camera_matrix, const Vec3 &p_cam,
                                         double radius);

// The one with the centroid and the second moments of the polygon's area: a uniform
// ellipse's variance along an axis is a quarter of the semi-axis squared.
Ellipse ellipse_of_polygon(const std::vector<cv::Point2d> &points);

// The library's.
Ellipse ellipse_of(const ocel_ellipse_t &ellipse);

} // namespace sim

#endif
