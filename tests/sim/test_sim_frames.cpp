// SPDX-License-Identifier: MIT
//
// Signs and units where a coordinate changes its frame, and where rays meet.
#include <unity.h>

#include "geometry/frames.hpp"
#include "methods/estimate.hpp"

void setUp(void) {
}
void tearDown(void) {
}

namespace {

using namespace sim;

void assert_near(const Vec3 &expected, const Vec3 &actual, double tolerance) {
    TEST_ASSERT_DOUBLE_WITHIN(tolerance, 0.0, cv::norm(expected - actual));
}

void test_camera_axes_in_the_eye(void) {
    const Pose X_eye_cam = camera_in_eye();
    assert_near(Vec3(1, 0, 0), X_eye_cam * Vec3(0, 0, 1), 0);  // forward
    assert_near(Vec3(0, -1, 0), X_eye_cam * Vec3(1, 0, 0), 0); // right
    assert_near(Vec3(0, 0, -1), X_eye_cam * Vec3(0, 1, 0), 0); // down
}

void test_bullet_has_the_worlds_axes(void) {
    const Vec3 p(1, -2, 3);
    TEST_ASSERT_EQUAL_DOUBLE(-2.0, bullet_vector(p).y());
    assert_near(p, world_vector(bullet_vector(p)), 0);
    const btTransform left(btQuaternion(btVector3(0, 0, 1), kPi / 2), btVector3(5, 6, 7));
    assert_near(Vec3(5, 7, 7), world_pose(left) * Vec3(1, 0, 0), 1e-12);
}

void test_units_of_the_library(void) {
    const std::int32_t p_u[3] = {170000, -1, 0};
    TEST_ASSERT_EQUAL_INT32(170000, units(0.17));
    TEST_ASSERT_EQUAL_DOUBLE(0.17, smu_of_units(170000));
    assert_near(Vec3(0.17, -1e-6, 0), smu_of_units(p_u), 1e-15);
    const std::int32_t d_q30[3] = {0, -1073741824, 0};
    assert_near(Vec3(0, -1, 0), unit_vector(d_q30), 0);
    TEST_ASSERT_EQUAL_INT32(-1073741824, turn_q32(-kPi / 2));
    const ocel_pose_t pose = {{{0, -1073741824, 0}, {1073741824, 0, 0}, {0, 0, 1073741824}},
                              {1000000, 2000000, 3000000}};
    assert_near(Vec3(1, 3, 3), world_pose(pose) * Vec3(1, 0, 0), 1e-9);
}

void test_rotations_are_right_handed(void) {
    assert_near(Vec3(0, 1, 0), rotation(2, kPi / 2) * Vec3(1, 0, 0), 1e-12);
    assert_near(Vec3(0, 0, 1), rotation(0, kPi / 2) * Vec3(0, 1, 0), 1e-12);
    assert_near(Vec3(1, 0, 0), rotation(1, kPi / 2) * Vec3(0, 0, 1), 1e-12);
    const Pose pose{rotation(1, 0.3) * rotation(0, -1.1), Vec3(1, 2, 3)};
    assert_near(Vec3(4, 5, 6), inverse(pose) * (pose * Vec3(4, 5, 6)), 1e-12);
}

// Eyes that look at `p_world`'s azimuth with these pans, and see it where it is.
Estimate seen_exactly(const JointAngles &joints, const Vec3 &p_world) {
    const Intrinsics camera = make_intrinsics("icub-2010", 320);
    const Pose X_world_tilt{rotation(1, -joints[kEyesTilt]), eyes_middle()};
    HeadReading head{joints, {}};
    Outlines outlines;
    for (const Side side : {kLeft, kRight}) {
        const double y = (side == kLeft ? 0.5 : -0.5) * kEyeDistance;
        const double pan = joints[side == kLeft ? kLeftPan : kRightPan];
        head.X_world_cam[side] =
            X_world_tilt * Pose{rotation(2, pan), Vec3(0, y, 0)} * camera_in_eye();
        const cv::Point2d pixel = project(camera, inverse(head.X_world_cam[side]) * p_world);
        outlines[side] = outline_of({pixel, cv::Matx22d(100, 0, 0, 100)}, OCEL_OK, camera);
    }
    return estimate(outlines, head, camera, 0.17);
}

void test_exact_sight_gives_the_exact_place(void) {
    const Vec3 p_world = eyes_middle() + Vec3(2.0, 0.3, -0.2);
    const JointAngles joints = {0, 0, radians(-3), radians(2), radians(11)};
    const Estimate found = seen_exactly(joints, p_world);
    assert_near(p_world, *found.p_world, 1e-9);
    assert_near(p_world, *found.p_residual, 1e-9);
    TEST_ASSERT_DOUBLE_WITHIN(0.002, 10.0 * 2.0 / 257.34, *found.radius);
}

// Eq. 14 is exact straight ahead and too far by 1 / cos(version) elsewhere.
void test_the_papers_distance(void) {
    const double d = 2.0;
    const double inwards = std::atan(kEyeDistance / 2 / d);
    assert_near(eyes_middle() + Vec3(d, 0, 0), paper_target({0, 0, 0, -inwards, inwards}, d),
                1e-12);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, d, paper_distance({0, 0, 0, -inwards, inwards}));
    const double version = radians(20);
    const Vec3 target(d * std::cos(version), d * std::sin(version), 0);
    const double left = std::atan2(target[1] - kEyeDistance / 2, target[0]);
    const double right = std::atan2(target[1] + kEyeDistance / 2, target[0]);
    TEST_ASSERT_DOUBLE_WITHIN(0.002, 1.064, paper_distance({0, 0, 0, left, right}) / d);
}

void test_rays_that_do_not_meet(void) {
    TEST_ASSERT_FALSE(meeting_point({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}).has_value());
    TEST_ASSERT_FALSE(meeting_point({0, 0, 0}, cv::normalize(Vec3(1, -1, 0)), {0, 1, 0},
                                    cv::normalize(Vec3(1, 1, 0)))
                          .has_value());
    assert_near(Vec3(1, 0.5, 0.1),
                *meeting_point({0, 0, 0}, cv::normalize(Vec3(1, 0.5, 0)), {0, 1, 0.2},
                               cv::normalize(Vec3(1, -0.5, 0))),
                1e-9);
}

} // namespace

int main() {
    UNITY_BEGIN();
    RUN_TEST(test_camera_axes_in_the_eye);
    RUN_TEST(test_bullet_has_the_worlds_axes);
    RUN_TEST(test_units_of_the_library);
    RUN_TEST(test_rotations_are_right_handed);
    RUN_TEST(test_exact_sight_gives_the_exact_place);
    RUN_TEST(test_the_papers_distance);
    RUN_TEST(test_rays_that_do_not_meet);
    return UNITY_END();
}
