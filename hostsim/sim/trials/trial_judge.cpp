// SPDX-License-Identifier: MIT
#include "trials/trial_judge.hpp"

#include <algorithm>

namespace sim {

namespace {

double norm_or_none(const std::optional<Vec3> &p, const Vec3 &p_true) {
    return p ? cv::norm(*p - p_true) : kNone;
}

void judge_place(const Estimate &found, const Scenario &scenario, const Truth &truth,
                 MethodRecord &record) {
    const Vec3 p = found.p_world.value_or(Vec3(kNone, kNone, kNone));
    std::copy(p.val, p.val + 3, record.p_world);
    record.error = norm_or_none(found.p_world, truth.p_world);
    record.error_encoder = scenario.gaze == Gaze::kFixate
                               ? norm_or_none(found.p_encoder, truth.p_world)
                               : kNone; // eq. 14 is of eyes that look at it
    record.error_residual = norm_or_none(found.p_residual, truth.p_world);
    record.error_debiased = kNone;
    if (scenario.target.shape == Shape::kDisc) {
        const double radius = scenario.target.radius;
        const double bias = radius * radius / truth.distance;
        record.error_debiased = cv::norm(p - Vec3(bias, 0, 0) - truth.p_world);
    }
}

Vec3 target_in_eye(const Truth &truth, Side side) {
    return inverse(truth.head.X_world_cam[side]) * truth.p_world;
}

// One eye's against the true outline.  False when one of them does not exist.
bool judge_outline(const Outline &outline, const Scenario &scenario, const Truth &truth, Side side,
                   MethodRecord &record) {
    const auto expected = true_outline(scenario, truth, side);
    if (!outline.found || !expected) {
        return false;
    }
    const double off = cv::norm(outline.ellipse.centre - expected->centre);
    record.centre_error_px = std::max(record.centre_error_px, off);
    record.success = record.success && is_success(outline.ellipse, *expected);
    record.radius_true_depth +=
        radius_at(outline, scenario.camera.intrinsics, target_in_eye(truth, side)) / kSides;
    return true;
}

void judge_outlines(const Outlines &outlines, const Scenario &scenario, const Truth &truth,
                    MethodRecord &record) {
    bool both = true;
    record.success = true;
    for (const Side side : {kLeft, kRight}) {
        both = judge_outline(outlines[side], scenario, truth, side, record) && both;
    }
    if (!both) {
        record.success = false;
        record.radius_true_depth = record.centre_error_px = kNone;
    }
}

} // namespace

std::optional<Ellipse> true_outline(const Scenario &scenario, const Truth &truth, Side side) {
    return seen_outline(scenario.camera.intrinsics, target_in_eye(truth, side),
                        scenario.target.radius);
}

double mean_radius(const Ellipse &ellipse) {
    const EllipseAxes axes = axes_of(ellipse);
    return std::sqrt(axes.a * axes.b);
}

bool is_success(const Ellipse &found, const Ellipse &truth) {
    const double true_px = mean_radius(truth);
    return cv::norm(found.centre - truth.centre) <= 0.25 * true_px &&
           std::fabs(mean_radius(found) - true_px) <= 0.2 * true_px;
}

MethodRecord judged(Method method, const Outlines &outlines, const Scenario &scenario,
                    const Truth &truth) {
    const double radius = scenario.target.radius;
    const Estimate found = estimate(outlines, truth.head, scenario.camera.intrinsics, radius);
    MethodRecord record{};
    record.method = method;
    record.status = found.status;
    record.votes = std::min(outlines[kLeft].votes, outlines[kRight].votes);
    judge_place(found, scenario, truth, record);
    judge_outlines(outlines, scenario, truth, record);
    record.radius = found.radius.value_or(kNone);
    record.radius_error_pct = 100.0 * (record.radius / radius - 1.0);
    record.radius_true_depth_error_pct = 100.0 * (record.radius_true_depth / radius - 1.0);
    return record;
}

} // namespace sim
