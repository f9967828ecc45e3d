// SPDX-License-Identifier: MIT
#include "track/track_truth.hpp"

#include <algorithm>
#include <limits>

namespace sim {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr int kGrid = 40; // rays across the disc: each stands for 1/1257 of it

// Whether the segment meets the cube of half size 1: between the last of its entries
// into the three slabs and the first of its exits.
bool crosses_cube(const Vec3 &a, const Vec3 &b) {
    double enter = 0.0;
    double leave = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double way = b[axis] - a[axis];
        if (way == 0.0) {
            if (std::fabs(a[axis]) > 1.0) {
                return false;
            }
        } else {
            const double middle = -a[axis] / way;
            const double half = 1.0 / std::fabs(way);
            enter = std::max(enter, middle - half);
            leave = std::min(leave, middle + half);
        }
    }
    return enter < leave;
}

// The same for the ball of radius 1: by its point that is nearest to the centre.
bool crosses_ball(const Vec3 &a, const Vec3 &b) {
    const Vec3 way = b - a;
    const double share = std::clamp(-a.dot(way) / way.dot(way), 0.0, 1.0);
    return cv::norm(a + way * share) < 1.0;
}

// The segment from a to b in a solid's own measure.
bool crosses(const Solid &solid, const Vec3 &a, const Vec3 &b) {
    const Pose X_solid_world = inverse(solid.X_world_solid);
    Vec3 from = X_solid_world * a;
    Vec3 to = X_solid_world * b;
    for (int axis = 0; axis < 3; ++axis) {
        from[axis] /= solid.half_size[axis];
        to[axis] /= solid.half_size[axis];
    }
    return solid.shape == Shape::kBall ? crosses_ball(from, to) : crosses_cube(from, to);
}

bool is_covered(const std::vector<Solid> &solids, const Vec3 &p_eye, const Vec3 &point) {
    return std::any_of(solids.begin(), solids.end(), [&](const Solid &solid) {
        return !solid.is_target && crosses(solid, p_eye, point);
    });
}

bool in_picture(const Intrinsics &camera, const Vec3 &p_cam) {
    if (p_cam[2] <= 0.0) {
        return false;
    }
    const cv::Point2d pixel = project(camera, p_cam);
    return pixel.x > -0.5 && pixel.x < camera.width - 0.5 && pixel.y > -0.5 &&
           pixel.y < camera.height - 0.5;
}

} // namespace

// The ball's disc is the circle in which the cone of rays touches it: radius R cos(a)
// about a point R sin(a) nearer than the centre, sin(a) = R / distance.
Visibility visibility_of(const Vec3 &p_world, double radius, const std::vector<Solid> &solids,
                         const Pose &X_world_cam, const Intrinsics &camera) {
    const Vec3 p_cam = inverse(X_world_cam) * p_world;
    const double sine = radius / cv::norm(p_cam);
    const Vec3 axis = cv::normalize(p_cam);
    const Vec3 middle = p_cam - axis * (radius * sine);
    const double reach = radius * std::sqrt(1.0 - sine * sine);
    const Vec3 across = cv::normalize(axis.cross(Vec3(0.3, 1.0, 0.1)));
    const Vec3 along = axis.cross(across);
    int total = 0;
    int visible = 0;
    int covered = 0;
    for (int i = 0; i < kGrid * kGrid; ++i) {
        const double u = (2 * (i % kGrid) + 1) / static_cast<double>(kGrid) - 1.0;
        const double v = (2 * (i / kGrid) + 1) / static_cast<double>(kGrid) - 1.0;
        if (u * u + v * v > 1.0) {
            continue;
        }
        const Vec3 point = middle + (across * u + along * v) * reach;
        const bool behind = is_covered(solids, X_world_cam.p, X_world_cam * point);
        ++total;
        covered += behind ? 1 : 0;
        visible += !behind && in_picture(camera, point) ? 1 : 0;
    }
    return {static_cast<double>(visible) / total, static_cast<double>(covered) / total};
}

void TrackJudge::judge(const std::vector<Solid> &solids,
                       const std::array<Pose, kSides> &X_world_cam, TrackFrame &frame) {
    const Intrinsics &camera = scenario_.camera.intrinsics;
    bool wholly_covered = true;
    frame.hidden = true;
    for (const Side side : {kLeft, kRight}) {
        const Visibility seen =
            visibility_of(frame.p_true, scenario_.target.radius, solids, X_world_cam[side], camera);
        const Vec3 p_cam = inverse(X_world_cam[side]) * frame.p_true;
        frame.visible[side] = seen.visible;
        frame.covered[side] = seen.covered;
        frame.offset[side] = p_cam[2] > 0.0
                                 ? project(camera, p_cam) - cv::Point2d(camera.cx, camera.cy)
                                 : cv::Point2d(kNone, kNone);
        frame.hidden = frame.hidden && seen.visible == 0.0;
        wholly_covered = wholly_covered && seen.covered == 1.0;
    }
    if (first_visible_ < 0.0 && !frame.hidden) {
        first_visible_ = frame.time;
    }
    frame.counted =
        !wholly_covered && first_visible_ >= 0.0 && frame.time >= first_visible_ + kSettle;
    frame.held = off_middle(frame) <= kHoldPx * camera.width / 320.0; // not so where there is none
}

double off_middle(const TrackFrame &frame) {
    const double left = std::hypot(frame.offset[kLeft].x, frame.offset[kLeft].y);
    const double right = std::hypot(frame.offset[kRight].x, frame.offset[kRight].y);
    return left > right ? left : std::isnan(left) ? left : right;
}

} // namespace sim
