// SPDX-License-Identifier: MIT
//
// Each method on one rendered ball, clear and half hidden, and on none.
#include <unity.h>

#include "camera/renderer.hpp"
#include "geometry/frames.hpp"
#include "methods/methods.hpp"
#include "support/random.hpp"

void setUp(void) {
}
void tearDown(void) {
}

namespace {

using namespace sim;

const Vec3 kPlace(1.2, 0.11, -0.07);
constexpr double kRadius = 0.17;

Drawing ball_before_grey() {
    Drawing drawing;
    drawing.clear_colour = Vec3(0.5, 0.5, 0.5);
    Solid ball;
    ball.shape = Shape::kBall;
    ball.X_world_solid.p = kPlace;
    ball.half_size = Vec3(kRadius, kRadius, kRadius);
    ball.colour = Vec3(20, 60, 230) * (1 / 255.0);
    drawing.solids.push_back(ball);
    return drawing;
}

Detector detector_of(const Intrinsics &camera) {
    ocel_colour_range_t range{};
    range.space = OCEL_SPACE_YUV;
    range.lo[1] = 174;
    range.hi[0] = range.hi[1] = range.hi[2] = 255;
    return {camera, range, 16};
}

double mean_radius(const Ellipse &ellipse) {
    return std::sqrt(axes_of(ellipse).a * axes_of(ellipse).b);
}

// What each is worth on a clear ball: the inner boundary makes a radius smaller
// by .45 px, Hough's circle has whole pixels.
struct Expected {
    Method method;
    double centre_px;
    double radius_px;
    double radius_bias_px;
};

const Expected kExpected[] = {
    {Method::kHoughGradient, 1.5, 2.0, 0.0}, {Method::kHoughAlt, 1.5, 2.0, 0.0},
    {Method::kB2acStrict, 0.15, 0.1, -0.45}, {Method::kB2ac, 0.15, 0.1, 0.0},
    {Method::kLcse, 0.15, 0.1, 0.0},         {Method::kEdfe, 0.15, 0.1, -0.45},
    {Method::kEdfe200, 0.15, 0.1, -0.45},    {Method::kHyper, 0.15, 0.1, 0.0},
    {Method::kSphere, 0.15, 0.1, 0.0}};

void test_clear_ball(void) {
    const Intrinsics camera = make_intrinsics("icub-2010", 320);
    const Vec3 p_cam = inverse(camera_in_eye()) * kPlace;
    const Ellipse truth = *outline_of_sphere(camera_matrix(camera), p_cam, kRadius);
    Detector detector = detector_of(camera);
    detector.look(Renderer(camera, 2).picture(ball_before_grey(), camera_in_eye()));
    for (const Expected &expected : kExpected) {
        const char *const name = method_name(expected.method);
        const Outline outline = find_outline(expected.method, detector, 5);
        TEST_ASSERT_TRUE_MESSAGE(outline.found, name);
        TEST_ASSERT_EQUAL_MESSAGE(OCEL_OK, outline.status, name);
        TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(expected.centre_px, 0.0,
                                          cv::norm(outline.ellipse.centre - truth.centre), name);
        TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(expected.radius_px,
                                          mean_radius(truth) + expected.radius_bias_px,
                                          mean_radius(outline.ellipse), name);
        TEST_ASSERT_TRUE_MESSAGE(outline.d_cam.dot(cv::normalize(p_cam)) > 0.9999, name);
    }
    // The cone's axis, unlike the ellipse's centre, is the ball's direction.
    const Outline cone = find_outline(Method::kSphere, detector, 5);
    TEST_ASSERT_DOUBLE_WITHIN(0.15 / 257, 0.0, cv::norm(cone.d_cam - cv::normalize(p_cam)));
}

void test_no_ball(void) {
    const Intrinsics camera = make_intrinsics("icub-2010", 160);
    Drawing empty;
    empty.clear_colour = Vec3(0.5, 0.5, 0.5);
    Detector detector = detector_of(camera);
    detector.look(Renderer(camera, 1).picture(empty, camera_in_eye()));
    for (int i = 0; i < kMethodCount; ++i) {
        const Outline outline = find_outline(static_cast<Method>(i), detector, 5);
        TEST_ASSERT_FALSE(outline.found);
        TEST_ASSERT_EQUAL(OCEL_NOT_SEEN, outline.status);
    }
}

// Half of it hidden: the sphere's fit keeps the radius, b2ac swallows the edge.
void test_hidden_half(void) {
    const Intrinsics camera = make_intrinsics("icub-2010", 320);
    const Ellipse truth =
        *outline_of_sphere(camera_matrix(camera), inverse(camera_in_eye()) * kPlace, kRadius);
    Drawing drawing = ball_before_grey();
    Solid plate;
    plate.half_size = Vec3(0.01, 1, 1);
    plate.X_world_solid.p = Vec3(1.0, kPlace[1] / 1.2 + 1, 0);
    plate.colour = Vec3(0.3, 0.3, 0.3);
    drawing.solids.push_back(plate);
    Detector detector = detector_of(camera);
    detector.look(Renderer(camera, 2).picture(drawing, camera_in_eye()));
    const Outline sphere = find_outline(Method::kSphere, detector, 5);
    const Outline b2ac = find_outline(Method::kB2ac, detector, 5);
    TEST_ASSERT_DOUBLE_WITHIN(0.01, 1.0, mean_radius(sphere.ellipse) / mean_radius(truth));
    TEST_ASSERT_DOUBLE_WITHIN(0.06, 0.72, mean_radius(b2ac.ellipse) / mean_radius(truth));
}

void test_names(void) {
    for (int i = 0; i < kMethodCount; ++i) {
        const auto method = static_cast<Method>(i);
        TEST_ASSERT_TRUE(method_of(method_name(method)) == method);
    }
    TEST_ASSERT_FALSE(method_of("best").has_value());
}

} // namespace

int main() {
    UNITY_BEGIN();
    RUN_TEST(test_clear_ball);
    RUN_TEST(test_no_ball);
    RUN_TEST(test_hidden_half);
    RUN_TEST(test_names);
    return UNITY_END();
}
