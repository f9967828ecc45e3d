// SPDX-License-Identifier: MIT
//
// The closed loop's parts: what is true of a frame, the signs of its axes, a joint at
// its limit, the video.
#include <filesystem>
#include <opencv2/videoio.hpp>

#include "geometry/frames.hpp"
#include "support/random.hpp"
#include "support/video.hpp"
#include "track/track_loop.hpp"

// Last: its macros have names of the standard library's.
#include <unity.h>

void setUp(void) {
}
void tearDown(void) {
}

namespace {

using namespace sim;

constexpr double kRadius = 0.5;

// ---- What is true ----

Pose camera_at_eyes() {
    Pose pose = camera_in_eye();
    pose.p = eyes_middle();
    return pose;
}

Solid solid(Shape shape, const Vec3 &p_world, const Vec3 &half_size) {
    Solid result;
    result.shape = shape;
    result.X_world_solid.p = p_world;
    result.half_size = half_size;
    return result;
}

Solid board(const Vec3 &p_world, const Vec3 &size) {
    return solid(Shape::kBox, p_world, size * 0.5);
}

Visibility seen(const Vec3 &p_world, const std::vector<Solid> &solids) {
    return visibility_of(p_world, kRadius, solids, camera_at_eyes(),
                         make_intrinsics("icub-2010", 320));
}

void test_a_ball_in_the_open_is_seen_whole(void) {
    const Visibility all = seen(Vec3(6, 0.5, 3), {});
    TEST_ASSERT_EQUAL_DOUBLE(1.0, all.visible);
    TEST_ASSERT_EQUAL_DOUBLE(0.0, all.covered);
    // Behind it, beside the line of sight, and beyond the eyes: none covers.
    std::vector<Solid> aside = {board(Vec3(7, 0, 3.5), Vec3(0.1, 9, 9)),
                                board(Vec3(4, 2, 3.5), Vec3(0.1, 2, 9)),
                                board(Vec3(-1, 0, 3.5), Vec3(0.1, 9, 9)),
                                solid(Shape::kBall, Vec3(4, 1.1, 3.5), Vec3(0.6, 0.6, 0.6)),
                                solid(Shape::kBall, Vec3(8, 0, 3.5), Vec3(1, 1, 1)),
                                solid(Shape::kBall, Vec3(6, 0, 3.5), Vec3(1, 1, 1))};
    aside.back().is_target = true;
    TEST_ASSERT_EQUAL_DOUBLE(1.0, seen(Vec3(6, 0, 3.5), aside).visible);
}

void test_a_board_covers_what_is_behind_it(void) {
    const Vec3 ball(6, 0, 3.5); // straight ahead
    const Visibility half = seen(ball, {board(Vec3(4, 2, 3.5), Vec3(0.1, 4, 9))});
    TEST_ASSERT_DOUBLE_WITHIN(0.001, 0.5, half.visible);
    TEST_ASSERT_DOUBLE_WITHIN(0.001, 0.5, half.covered);
    const Visibility none = seen(ball, {board(Vec3(4, 0, 3.5), Vec3(0.1, 1, 1))});
    TEST_ASSERT_EQUAL_DOUBLE(0.0, none.visible);
    TEST_ASSERT_EQUAL_DOUBLE(1.0, none.covered);
    // Half-way and half as large, a ball covers as much as it hides of itself.
    const Vec3 middle = (ball + eyes_middle()) * 0.5;
    const double radius = kRadius / 2.0;
    TEST_ASSERT_EQUAL_DOUBLE(
        1.0, seen(ball, {solid(Shape::kBall, middle, Vec3(1, 1, 1) * (radius * 1.01))}).covered);
    TEST_ASSERT_DOUBLE_WITHIN(
        0.01, 0.81,
        seen(ball, {solid(Shape::kBall, middle, Vec3(1, 1, 1) * (radius * 0.9))}).covered);
    // A square covers as much when it stands on a corner, and less seen from its edge.
    Solid diamond = board(Vec3(4, 0, 3.5), Vec3(0.01, 0.2, 0.2));
    const double flat = seen(ball, {diamond}).covered;
    diamond.X_world_solid.r = rotation(0, radians(45));
    TEST_ASSERT_DOUBLE_WITHIN(0.01, flat, seen(ball, {diamond}).covered);
    diamond.X_world_solid.r = rotation(2, radians(90));
    TEST_ASSERT_TRUE(seen(ball, {diamond}).covered < 0.3 * flat);
}

// Its edge cuts the ball at 120 px of 257.3 px from the middle.
void test_the_edge_of_the_picture_is_no_board(void) {
    const Visibility cut = seen(Vec3(6, 0, 3.5 - (6 - 0.36) * 120.0 / 257.34), {});
    TEST_ASSERT_DOUBLE_WITHIN(0.06, 0.5, cut.visible);
    TEST_ASSERT_EQUAL_DOUBLE(0.0, cut.covered);
    TEST_ASSERT_EQUAL_DOUBLE(0.0, seen(Vec3(-6, 0, 3.5), {}).visible);
}

TrackFrame judged(TrackJudge &judge, double time, const Vec3 &p_true) {
    const std::vector<Solid> solids = {board(Vec3(4, 3, 3.5), Vec3(0.1, 2, 9))};
    TrackFrame frame{};
    frame.time = time;
    frame.p_true = p_true;
    judge.judge(solids, {camera_at_eyes(), camera_at_eyes()}, frame);
    return frame;
}

void test_frames_count_from_half_a_second_on(void) {
    TrackScenario scenario{};
    scenario.camera.intrinsics = make_intrinsics("icub-2010", 320);
    scenario.target.radius = kRadius;
    TrackJudge judge(scenario);
    const Vec3 ahead(6, 0, 3.5);
    const Vec3 covered(6, 4.5, 3.5);
    TEST_ASSERT_TRUE(judged(judge, 0.0, covered).hidden);
    TEST_ASSERT_FALSE(judged(judge, 1.0, ahead).counted);
    TEST_ASSERT_FALSE(judged(judge, 1.4, ahead).counted);
    TEST_ASSERT_TRUE(judged(judge, 1.5, ahead).counted);
    TEST_ASSERT_FALSE(judged(judge, 1.6, covered).counted);
    // Out of the picture it is hidden, and still counted: it could be held.
    const TrackFrame lost = judged(judge, 1.7, Vec3(6, -6, 3.5));
    TEST_ASSERT_TRUE(lost.hidden && lost.counted);
    TEST_ASSERT_FALSE(lost.held);
    TEST_ASSERT_FALSE(judged(judge, 1.8, Vec3(-6, 0, 3.5)).held);
}

void test_held_is_20_px_in_both_pictures(void) {
    TrackScenario scenario{};
    scenario.camera.intrinsics = make_intrinsics("icub-2010", 320);
    scenario.target.radius = kRadius;
    TrackJudge judge(scenario);
    const double reach = (6 - 0.36) / 257.34; // SMU for a pixel
    TEST_ASSERT_TRUE(judged(judge, 0, Vec3(6, 0, 3.5 + 19.9 * reach)).held);
    TEST_ASSERT_FALSE(judged(judge, 0, Vec3(6, 0, 3.5 + 20.1 * reach)).held);
    TEST_ASSERT_DOUBLE_WITHIN(0.001, 20.1,
                              off_middle(judged(judge, 0, Vec3(6, 20.1 * reach, 3.5))));
    TrackFrame frame{};
    for (const Side farther : {kLeft, kRight}) {
        frame.offset[farther] = cv::Point2d(3, 4);
        frame.offset[1 - farther] = cv::Point2d(0, 1);
        TEST_ASSERT_EQUAL_DOUBLE(5.0, off_middle(frame));
    }
}

// ---- The loop ----

// A ball that is held in its place, small pictures.
TrackScenario still_scenario(const Vec3 &p_world) {
    TrackScenario scenario = read_track_scenario(std::string(OCEL_SCENARIOS) + "/track_throw.toml");
    scenario.camera.intrinsics = make_intrinsics("icub-2010", 160);
    scenario.camera.supersampling = 1;
    scenario.screens.clear();
    scenario.looks_at = Vec3(6, 0, 3.5);
    scenario.tracker.gravity = false;
    scenario.ball.p_world = p_world;
    scenario.ball.jitter = 0.0;
    scenario.ball.release = 100.0;
    return scenario;
}

// What the joints have turned by after half a second.
JointAngles turned_towards(const Vec3 &p_world) {
    const TrackScenario scenario = still_scenario(p_world);
    TrackLoop loop(scenario, 1);
    const TrackFrame first = loop.step();
    TrackFrame last = first;
    for (int i = 0; i < 15; ++i) {
        last = loop.step();
    }
    TEST_ASSERT_EQUAL(OCEL_OK, last.status);
    TEST_ASSERT_TRUE(off_middle(last) < 0.2 * off_middle(first));
    JointAngles turned{};
    for (std::size_t joint = 0; joint < kJointCount; ++joint) {
        turned[joint] = last.angles[joint] - first.angles[joint];
    }
    return turned;
}

void test_each_joint_turns_towards_the_ball(void) {
    const double some = radians(1);
    const JointAngles left = turned_towards(Vec3(6, 1.2, 3.5));
    TEST_ASSERT_TRUE(left[kNeckYaw] > some && left[kLeftPan] > some && left[kRightPan] > some);
    const JointAngles right = turned_towards(Vec3(6, -1.2, 3.5));
    TEST_ASSERT_TRUE(right[kNeckYaw] < -some && right[kLeftPan] < -some &&
                     right[kRightPan] < -some);
    const JointAngles up = turned_towards(Vec3(6, 0, 4.4));
    TEST_ASSERT_TRUE(up[kNeckPitch] > some && up[kEyesTilt] > some);
    const JointAngles down = turned_towards(Vec3(6, 0, 2.6));
    TEST_ASSERT_TRUE(down[kNeckPitch] < -some && down[kEyesTilt] < -some);
    const JointAngles near = turned_towards(Vec3(4, 0, 3.5));
    TEST_ASSERT_TRUE(near[kLeftPan] < -radians(0.5) && near[kRightPan] > radians(0.5));
    const JointAngles far = turned_towards(Vec3(10, 0, 3.5));
    TEST_ASSERT_TRUE(far[kLeftPan] > radians(0.3) && far[kRightPan] < -radians(0.3));
}

// Bullet's limits give way a little: what the library is told does not pass its own.
void test_what_the_library_is_told_is_within_its_limits(void) {
    Random random(5);
    ocel_pose_t X_root_eye[OCEL_EYE_COUNT];
    for (int i = 0; i < 200; ++i) {
        JointAngles angles{};
        for (std::size_t joint = 0; joint < kJointCount; ++joint) {
            const JointLimits limits = joint_limits(static_cast<Joint>(joint));
            angles[joint] = random.uniform(limits.low - 0.1, limits.high + 0.1);
        }
        const LibraryJoints read = library_joints(angles);
        const LibraryJoints told = library_joints_within_limits(angles);
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_head_forward(&ocel_head_paper, told.data(), X_root_eye));
        if (ocel_head_forward(&ocel_head_paper, read.data(), X_root_eye) == OCEL_OK) {
            TEST_ASSERT_TRUE(read == told);
        }
    }
}

// The ball is where no head can look: joints go to their limits and stay there.
void test_limits_hold_in_the_loop(void) {
    TrackScenario scenario = still_scenario(Vec3(0.5, 5, 3.5));
    scenario.looks_at = Vec3(1.5, 3, 3.5);
    scenario.ball.p_world = Vec3(-1.2, 3, 3.5);
    TrackLoop loop(scenario, 1);
    TrackFrame frame{};
    for (int i = 0; i < 60; ++i) {
        frame = loop.step();
    }
    TEST_ASSERT_DOUBLE_WITHIN(radians(0.1), joint_limits(kNeckYaw).high, frame.angles[kNeckYaw]);
    for (const Joint pan : {kLeftPan, kRightPan}) {
        TEST_ASSERT_TRUE(frame.angles[pan] < joint_limits(pan).high + radians(0.1));
    }
}

void test_looking_at_a_place(void) {
    const TrackScenario scenario = still_scenario(Vec3(5, 2, 1));
    World world(BallBody{});
    for (const Vec3 &place : {Vec3(5, 2, 1), Vec3(7, -3, 5), Vec3(2, 0, 3)}) {
        world.head().place(looking_at(world.head(), place));
        for (const Side side : {kLeft, kRight}) {
            const Vec3 p_cam = inverse(world.head().X_world_cam(side)) * place;
            TEST_ASSERT_DOUBLE_WITHIN(1e-4, 0.0, std::hypot(p_cam[0], p_cam[1]) / p_cam[2]);
        }
    }
}

// ---- The video ----

cli::Image grey(std::uint8_t level) {
    cli::Image image;
    image.width = 96;
    image.height = 64;
    image.channels = 3;
    image.pixels.assign(image.row_bytes() * image.height, level);
    return image;
}

void test_a_video_can_be_read(void) {
    const std::string path = OCEL_REPORTS "/test_sim_track.mp4";
    {
        Video video(path, 30.0);
        for (int i = 0; i < 12; ++i) {
            video.add(grey(static_cast<std::uint8_t>(20 * i)));
        }
    }
    cv::VideoCapture capture(path);
    TEST_ASSERT_TRUE(capture.isOpened());
    TEST_ASSERT_EQUAL(30, static_cast<int>(capture.get(cv::CAP_PROP_FPS)));
    cv::Mat frame;
    int frames = 0;
    while (capture.read(frame)) {
        TEST_ASSERT_EQUAL(96, frame.cols);
        TEST_ASSERT_EQUAL(64, frame.rows);
        TEST_ASSERT_DOUBLE_WITHIN(6.0, 20.0 * frames, cv::mean(frame)[0]);
        ++frames;
    }
    TEST_ASSERT_EQUAL(12, frames);
    std::filesystem::remove(path);
}

void test_a_video_that_cannot_be_written(void) {
    Video video("/dev/null/x.mp4", 30.0);
    bool refused = false;
    try {
        video.add(grey(0));
    } catch (const std::runtime_error &mistake) {
        refused = std::string(mistake.what()).find("/dev/null/x.mp4") != std::string::npos;
    }
    TEST_ASSERT_TRUE(refused);
}

} // namespace

int main() {
    UNITY_BEGIN();
    RUN_TEST(test_a_ball_in_the_open_is_seen_whole);
    RUN_TEST(test_a_board_covers_what_is_behind_it);
    RUN_TEST(test_the_edge_of_the_picture_is_no_board);
    RUN_TEST(test_frames_count_from_half_a_second_on);
    RUN_TEST(test_held_is_20_px_in_both_pictures);
    RUN_TEST(test_each_joint_turns_towards_the_ball);
    RUN_TEST(test_what_the_library_is_told_is_within_its_limits);
    RUN_TEST(test_limits_hold_in_the_loop);
    RUN_TEST(test_looking_at_a_place);
    RUN_TEST(test_a_video_can_be_read);
    RUN_TEST(test_a_video_that_cannot_be_written);
    return UNITY_END();
}
