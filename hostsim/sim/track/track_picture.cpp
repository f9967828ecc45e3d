// SPDX-License-Identifier: MIT
#include "track/track_picture.hpp"

#include <fmt/format.h>

#include "support/canvas.hpp"
#include "track/track_results.hpp"

namespace sim {

namespace {

const cv::Scalar kHoldInk(250, 250, 250);
const cv::Scalar kBoxInk(255, 225, 90);
const cv::Scalar kGuessInk(255, 150, 40);

void draw_outline(const ocel_cone_t &cone, ocel_status_t status, const Intrinsics &intrinsics,
                  cv::Mat &canvas) {
    ocel_camera_t camera{};
    ocel_ellipse_t ellipse{};
    const ocel_intrinsics_t library = library_intrinsics(intrinsics);
    must(ocel_camera_init(&camera, &library), "ocel_camera_init");
    if (cone.sin_q30 != 0 && ocel_cone_outline(&camera, &cone, &ellipse) == OCEL_OK) {
        draw_ellipse(ellipse_of(ellipse), status == OCEL_OK ? kVouchedInk : kDoubtInk, canvas);
    }
}

void draw_track(const TrackFrame &frame, const Pose &X_world_cam, const Intrinsics &camera,
                cv::Mat &canvas) {
    if (frame.p_track) {
        const Vec3 p_cam = inverse(X_world_cam) * *frame.p_track;
        if (p_cam[2] > 0.0) {
            draw_cross(project(camera, p_cam), frame.state == OCEL_TRACK_SEEN ? kWhite : kGuessInk,
                       canvas);
        }
    }
}

cv::Mat eye_canvas(const TrackScenario &scenario, const TrackLoop &loop, const TrackFrame &frame,
                   Side side) {
    const Intrinsics &camera = scenario.camera.intrinsics;
    const Sighting &sighting = loop.sighting();
    cv::Mat canvas = enlarged_frame(loop.images()[side], side == kLeft ? "left" : "right");
    draw_circle({camera.cx, camera.cy}, hold_px(scenario), kHoldInk, canvas);
    if (sighting.expected[side]) {
        const ocel_rect_t &roi = sighting.roi[side];
        draw_box({roi.left - 0.5, roi.top - 0.5, double(roi.width), double(roi.height)}, kBoxInk,
                 canvas);
    }
    draw_outline(sighting.cone[side], sighting.eye[side], camera, canvas);
    draw_track(frame, loop.X_world_cam()[side], camera, canvas);
    return canvas;
}

std::string error_text(const TrackFrame &frame) {
    if (!frame.p_track) {
        return "no estimate";
    }
    return fmt::format("error {:.4f} SMU, stated deviation {:.4f}",
                       cv::norm(*frame.p_track - frame.p_true), frame.sigma);
}

void write_legend(const TrackScenario &scenario, const TrackFrame &frame, int top,
                  cv::Mat &canvas) {
    const auto line = [top](int number) { return cv::Point(8, top + kTextLine * number); };
    const cv::Scalar ink = frame.status == OCEL_OK          ? kVouchedInk
                           : frame.state == OCEL_TRACK_LOST ? kDoubtInk
                                                            : kGuessInk;
    write_line(fmt::format("{}  {:.2f} s   eyes: {}, {}   stereo: {}", scenario.name, frame.time,
                           ocel_status_name(frame.status_eye[kLeft]),
                           ocel_status_name(frame.status_eye[kRight]),
                           ocel_status_name(frame.status_stereo)),
               line(1), kWhite, canvas);
    write_line(fmt::format("track: {}, {}   {}   seen: {:.0f} % and {:.0f} %",
                           ocel_status_name(frame.status), state_name(frame.state),
                           error_text(frame), 100.0 * frame.visible[kLeft],
                           100.0 * frame.visible[kRight]),
               line(2), ink, canvas);
    write_line(fmt::format("joints: pitch {:+.1f}, yaw {:+.1f}, tilt {:+.1f}, pans {:+.1f} {:+.1f} "
                           "degrees   off the middle: {:.1f} px",
                           degrees(frame.angles[kNeckPitch]), degrees(frame.angles[kNeckYaw]),
                           degrees(frame.angles[kEyesTilt]), degrees(frame.angles[kLeftPan]),
                           degrees(frame.angles[kRightPan]), off_middle(frame)),
               line(3), kWhite, canvas);
}

} // namespace

cli::Image annotated_pair(const TrackScenario &scenario, const TrackLoop &loop,
                          const TrackFrame &frame) {
    const cv::Mat left = eye_canvas(scenario, loop, frame, kLeft);
    const cv::Mat right = eye_canvas(scenario, loop, frame, kRight);
    cv::Mat canvas = side_by_side(left, right, 4);
    write_legend(scenario, frame, left.rows, canvas);
    return image_of(canvas);
}

} // namespace sim
