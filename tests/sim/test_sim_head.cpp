// SPDX-License-Identifier: MIT
//
// Bullet's head: its kinematics against the paper's table and the library's, its
// signs, motors and limits; and that a fresh world repeats itself.
#include <unity.h>

#include <ocellus/head.h>

#include "geometry/frames.hpp"
#include "support/random.hpp"
#include "world/world.hpp"

void setUp(void) {
}
void tearDown(void) {
}

namespace {

using namespace sim;

BallBody held_ball() {
    BallBody ball;
    ball.mass = 0.0;
    ball.p_world = Vec3(2, 0, 1);
    return ball;
}

JointAngles random_angles(Random &random) {
    JointAngles angles{};
    for (int joint = 0; joint < kJointCount; ++joint) {
        const JointLimits limits = joint_limits(static_cast<Joint>(joint));
        angles[static_cast<std::size_t>(joint)] = random.uniform(limits.low, limits.high);
    }
    return angles;
}

Vec3 forward(const Pose &X_world_eye) {
    return X_world_eye.r * Vec3(1, 0, 0);
}

// With both pans the same the eyes' middle looks along the version.
void test_kinematics_are_the_papers(void) {
    World world(held_ball());
    Random random(11);
    for (int i = 0; i < 200; ++i) {
        JointAngles angles = random_angles(random);
        angles[kRightPan] = angles[kLeftPan];
        world.head().place(angles);
        const Pose left = world.head().X_world_eye(kLeft);
        const Pose right = world.head().X_world_eye(kRight);
        const Vec3 target = (left.p + right.p) * 0.5 + forward(left) * 2.5;
        TEST_ASSERT_DOUBLE_WITHIN(1e-12, 0.0, cv::norm(target - paper_target(angles, 2.5)));
        TEST_ASSERT_DOUBLE_WITHIN(1e-12, kEyeDistance, cv::norm(left.p - right.p));
    }
}

void test_kinematics_are_the_librarys(void) {
    World world(held_ball());
    Random random(12);
    for (int i = 0; i < 200; ++i) {
        JointAngles angles = random_angles(random);
        angles[kRightPan] = random.uniform(angles[kLeftPan], radians(50));
        world.head().place(angles);
        std::int32_t q32[OCEL_JOINT_COUNT] = {};
        q32[OCEL_NECK_PITCH] = turn_q32(angles[kNeckPitch]);
        q32[OCEL_NECK_YAW] = turn_q32(angles[kNeckYaw]);
        q32[OCEL_EYES_TILT] = turn_q32(angles[kEyesTilt]);
        q32[OCEL_EYES_VERSION] = turn_q32(version_of(angles));
        q32[OCEL_EYES_VERGENCE] = turn_q32(2 * half_vergence_of(angles));
        ocel_pose_t X_root_eye[OCEL_EYE_COUNT];
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_head_forward(&ocel_head_paper, q32, X_root_eye));
        for (const Side side : {kLeft, kRight}) {
            const Pose expected = world.head().X_world_cam(side);
            const Pose actual = world_pose(X_root_eye[side]);
            TEST_ASSERT_DOUBLE_WITHIN(2e-6, 0.0, cv::norm(expected.p - actual.p));
            TEST_ASSERT_DOUBLE_WITHIN(1e-7, 0.0, cv::norm(expected.r - actual.r));
        }
    }
}

void test_signs(void) {
    World world(held_ball());
    Head &head = world.head();
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 0.0,
                              cv::norm(head.X_world_eye(kLeft).p - Vec3(0.36, 0.175, 3.5)));
    head.place({0.3, 0, 0, 0, 0});
    TEST_ASSERT_TRUE(forward(head.X_world_eye(kLeft))[2] > 0.2); // pitch: up
    head.place({0, 0.3, 0, 0, 0});
    TEST_ASSERT_TRUE(forward(head.X_world_eye(kLeft))[1] > 0.2); // yaw: left
    head.place({0, 0, 0.2, 0, 0});
    TEST_ASSERT_TRUE(forward(head.X_world_eye(kRight))[2] > 0.1); // tilt: up
    head.place({0, 0, 0, 0.3, -0.2});
    TEST_ASSERT_TRUE(forward(head.X_world_eye(kLeft))[1] > 0.2); // pan: left
    TEST_ASSERT_TRUE(forward(head.X_world_eye(kRight))[1] < -0.1);
}

void test_motors_keep_their_speed(void) {
    World world(held_ball());
    for (int joint = 0; joint < kJointCount; ++joint) {
        world.head().set_speed(static_cast<Joint>(joint), 0.1 * (joint + 1));
    }
    world.advance(500);
    const JointAngles angles = world.head().angles();
    for (int joint = 0; joint < kJointCount; ++joint) {
        const double limit = joint_limits(static_cast<Joint>(joint)).high;
        const double expected = std::min(0.05 * (joint + 1), limit);
        TEST_ASSERT_DOUBLE_WITHIN(0.002, expected, angles[static_cast<std::size_t>(joint)]);
    }
}

void test_limits_hold(void) {
    World world(held_ball());
    world.head().set_speed(kLeftPan, 2.0);
    world.head().set_speed(kNeckPitch, -2.0);
    world.advance(2000);
    const JointAngles angles = world.head().angles();
    TEST_ASSERT_DOUBLE_WITHIN(radians(3), radians(50), angles[kLeftPan]);
    TEST_ASSERT_DOUBLE_WITHIN(radians(3), radians(-40), angles[kNeckPitch]);
}

void test_a_ball_falls_and_bounces(void) {
    BallBody ball;
    ball.p_world = Vec3(2, 0, 1.17);
    World world(ball);
    world.advance(100);
    TEST_ASSERT_DOUBLE_WITHIN(0.005, 1.17 - kGravity * 0.01 / 2, world.ball_place()[2]);
    const int to_floor = static_cast<int>(std::sqrt(2 / kGravity) / kStep); // from 1 SMU up
    world.advance(to_floor - 100);
    TEST_ASSERT_DOUBLE_WITHIN(0.03, 0.17, world.ball_place()[2]);
    world.advance(to_floor * 8 / 10); // the top of the next arc: .8^2 as high
    TEST_ASSERT_DOUBLE_WITHIN(0.05, 0.17 + 0.64, world.ball_place()[2]);
}

void test_fresh_worlds_are_the_same(void) {
    JointAngles angles[2];
    Vec3 places[2];
    for (int run = 0; run < 2; ++run) {
        BallBody ball;
        ball.p_world = Vec3(1, 0.2, 2);
        World world(ball);
        world.head().set_speed(kNeckYaw, 0.7);
        world.head().set_speed(kLeftPan, -0.3);
        world.advance(400);
        angles[run] = world.head().angles();
        places[run] = world.ball_place();
    }
    TEST_ASSERT_TRUE(angles[0] == angles[1]);
    TEST_ASSERT_TRUE(places[0] == places[1]);
}

} // namespace

int main() {
    UNITY_BEGIN();
    RUN_TEST(test_kinematics_are_the_papers);
    RUN_TEST(test_kinematics_are_the_librarys);
    RUN_TEST(test_signs);
    RUN_TEST(test_motors_keep_their_speed);
    RUN_TEST(test_limits_hold);
    RUN_TEST(test_a_ball_falls_and_bounces);
    RUN_TEST(test_fresh_worlds_are_the_same);
    return UNITY_END();
}
