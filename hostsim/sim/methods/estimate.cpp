// SPDX-License-Identifier: MIT
#include "methods/estimate.hpp"

#include <algorithm>

#include <ocellus/stereo.h>

#include "geometry/frames.hpp"
#include "world/library_head.hpp"

namespace sim {

namespace {

// Eyes that look straight ahead say nothing by their joints alone.
constexpr double kLeastHalfVergence = 1e-3; // radians

std::optional<Vec3> encoder_place(const JointAngles &joints) {
    if (half_vergence_of(joints) < kLeastHalfVergence) {
        return std::nullopt;
    }
    return paper_target(joints, paper_distance(joints));
}

// x = b / (tan gr - tan gl), y = b/2 + x tan gl, in the plane of the eyes' pans;
// gl and gr are the pans less what the target is still seen to the right.
std::optional<Vec3> residual_place(const Outlines &outlines, const HeadReading &head) {
    const Vec3 &left = outlines[kLeft].d_cam;
    const Vec3 &right = outlines[kRight].d_cam;
    const double off_left = std::atan2(left[0], left[2]);
    const double tan_left = std::tan(head.joints[kLeftPan] - off_left);
    const double tan_right = std::tan(head.joints[kRightPan] - std::atan2(right[0], right[2]));
    if (tan_right - tan_left < kLeastHalfVergence) {
        return std::nullopt;
    }
    const double x = kEyeDistance / (tan_right - tan_left);
    const double y = kEyeDistance / 2.0 + x * tan_left;
    // Down in the left image, at the depth along its axis.
    const double depth = std::hypot(x, y - kEyeDistance / 2.0) * std::cos(off_left);
    const Vec3 p_eyes(x, y, -depth * left[1] / left[2]);
    // The eyes' middle with the tilt but without the pans.
    JointAngles ahead = head.joints;
    ahead[kLeftPan] = ahead[kRightPan] = 0.0;
    const Vec3 middle = paper_target(ahead, 0.0);
    const Mat3 r = rotation(1, -head.joints[kNeckPitch]) * rotation(2, head.joints[kNeckYaw]) *
                   rotation(1, -head.joints[kEyesTilt]);
    return middle + r * p_eyes;
}

// The library's whole chain: encoders, head, cones, ball.
ocel_status_t library_ball(const Outlines &outlines, const JointAngles &joints, double radius,
                           ocel_ball_t &ball) {
    const LibraryJoints q32 = library_joints(joints);
    ocel_pose_t X_root_eye[OCEL_EYE_COUNT];
    const ocel_status_t status = ocel_head_forward(&ocel_head_paper, q32.data(), X_root_eye);
    if (status != OCEL_OK) {
        return status;
    }
    const auto cone = [](const Outline &outline) {
        return outline.has_cone ? &outline.cone : nullptr;
    };
    return ocel_stereo_ball(cone(outlines[kLeft]), cone(outlines[kRight]), X_root_eye,
                            units(radius), &ball);
}

// Both eyes must have a cone: with one alone nothing of it would be stereo.
void place_sphere(const Outlines &outlines, const HeadReading &head, double radius,
                  Estimate &estimate) {
    ocel_ball_t ball{};
    const ocel_status_t status = library_ball(outlines, head.joints, radius, ball);
    estimate.status = std::max(estimate.status, status);
    if (status == OCEL_OK || status == OCEL_PARTIAL) {
        estimate.p_world = smu_of_units(ball.best.p_root_u);
        if (ball.has_stereo) {
            estimate.radius = smu_of_units(ball.radius_u);
        }
    }
}

void place_by_rays(const Outlines &outlines, const HeadReading &head, const Intrinsics &camera,
                   Estimate &estimate) {
    const Pose &left = head.X_world_cam[kLeft];
    const Pose &right = head.X_world_cam[kRight];
    estimate.p_world = meeting_point(left.p, left.r * outlines[kLeft].d_cam, right.p,
                                     right.r * outlines[kRight].d_cam);
    if (estimate.p_world) {
        const auto seen = [&](Side side) {
            return radius_at(outlines[side], camera,
                             inverse(head.X_world_cam[side]) * *estimate.p_world);
        };
        estimate.radius = (seen(kLeft) + seen(kRight)) / 2.0;
    }
}

} // namespace

std::optional<Vec3> meeting_point(const Vec3 &p_a, const Vec3 &d_a, const Vec3 &p_b,
                                  const Vec3 &d_b) {
    const double cosine = d_a.dot(d_b);
    const double sine_sq = 1.0 - cosine * cosine;
    const Vec3 base = p_b - p_a;
    const double t_a = (base.dot(d_a) - cosine * base.dot(d_b)) / sine_sq;
    const double t_b = (cosine * base.dot(d_a) - base.dot(d_b)) / sine_sq;
    if (!(sine_sq > 1e-9) || t_a <= 0.0 || t_b <= 0.0) {
        return std::nullopt;
    }
    return (p_a + d_a * t_a + p_b + d_b * t_b) * 0.5;
}

double radius_at(const Outline &outline, const Intrinsics &camera, const Vec3 &p_cam) {
    if (outline.has_cone) {
        return cv::norm(p_cam) * outline.cone.sin_q30 / 1073741824.0;
    }
    const EllipseAxes axes = axes_of(outline.ellipse);
    return std::sqrt(axes.a * axes.b / (camera.fx * camera.fy)) * p_cam[2];
}

Estimate estimate(const Outlines &outlines, const HeadReading &head, const Intrinsics &camera,
                  double radius) {
    Estimate result;
    // The worse of both: the statuses stand in order of how little they promise.
    result.status = std::max(outlines[kLeft].status, outlines[kRight].status);
    if (!outlines[kLeft].found || !outlines[kRight].found) {
        return result;
    }
    result.p_encoder = encoder_place(head.joints);
    result.p_residual = residual_place(outlines, head);
    if (outlines[kLeft].has_cone) {
        place_sphere(outlines, head, radius, result);
    } else {
        place_by_rays(outlines, head, camera, result);
    }
    return result;
}

} // namespace sim
