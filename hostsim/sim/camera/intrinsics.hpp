// SPDX-License-Identifier: MIT
//
// The simulated cameras' intrinsics: OpenCV's convention, pixel (0,0) has its
// centre at (0,0).
#ifndef OCELLUS_SIM_INTRINSICS_HPP
#define OCELLUS_SIM_INTRINSICS_HPP

#include <opencv2/core/types.hpp>
#include <optional>
#include <string>
#include <vector>

#include <ocellus/camera.h>

#include "camera/lens.hpp"
#include "geometry/ellipse.hpp"
#include "geometry/geometry.hpp"

namespace sim {

struct Intrinsics {
    double fx; // px
    double fy;
    double cx; // principal point, px
    double cy;
    int width; // px
    int height;
    Lens lens{};
};

// The iCub simulator's cameras through the years; until 2010-09 an integer
// division made every pixel 4/3 as high as wide, so that a ball is an ellipse.
//   icub-2010     50 degrees vertical, square pixels
//   icub-2010-06  50 degrees vertical, stretched
//   icub-2009     75 degrees vertical, stretched
std::vector<std::string> preset_names();

// `preset` at `width` x 3/4 `width`, the principal point in the picture's
// middle.  cli::InputError for a name that is none.
Intrinsics make_intrinsics(const std::string &preset, int width);

// Where a point in front of the camera is seen, px.
cv::Point2d project(const Intrinsics &camera, const Vec3 &p_cam);

// The unit vector along which a pixel is seen; nothing when no ray comes there
// through the lens.
std::optional<Vec3> pixel_ray(const Intrinsics &camera, const cv::Point2d &pixel);

// A pixel of the picture's border that has none, if there is one.
std::optional<cv::Point> pixel_without_ray(const Intrinsics &camera);

// The outline of a sphere of `radius` at p_cam.  Through a lens it is no ellipse:
// then the one with its centroid and its second moments, to 1e-4 px.  Nothing when
// the sphere is not all in front.
std::optional<Ellipse> seen_outline(const Intrinsics &camera, const Vec3 &p_cam, double radius);

// K: takes (x/z, y/z, 1), which the lens has bent, to pixels.
Mat3 camera_matrix(const Intrinsics &camera);

ocel_intrinsics_t library_intrinsics(const Intrinsics &camera);

} // namespace sim

#endif
