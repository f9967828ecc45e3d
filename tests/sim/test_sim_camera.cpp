// SPDX-License-Identifier: MIT
//
// What is drawn is what the camera model says, to a fiftieth of a pixel.
#include <algorithm>
#include <unity.h>

#include "ball_picture.hpp"
#include "camera/renderer.hpp"
#include "geometry/frames.hpp"

void setUp(void) {
}
void tearDown(void) {
}

namespace {

using namespace sim;

// Balls all over the picture, as the camera at the world's origin sees them.
const Vec3 kPlaces[] = {{1.2, 0, 0},      {1.2, 0.3, 0.25}, {1.2, -0.37, 0.2},
                        {2.0, 0.6, -0.4}, {3.4, -1.1, 0.9}, {2.2, 0.013, -0.77}};

void test_sphere_outline_is_the_true_ellipse(void) {
    const Pose X_world_cam = camera_in_eye();
    for (const std::string &preset : preset_names()) {
        const Intrinsics camera = make_intrinsics(preset, 320);
        Renderer renderer(camera, 4);
        for (const Vec3 &place : kPlaces) {
            Drawing drawing;
            drawing.solids.push_back(white_ball(place, 0.17));
            const Ellipse seen = ellipse_of_picture(renderer.picture(drawing, X_world_cam));
            const Ellipse truth =
                *outline_of_sphere(camera_matrix(camera), inverse(X_world_cam) * place, 0.17);
            TEST_ASSERT_DOUBLE_WITHIN(0.02, truth.centre.x, seen.centre.x);
            TEST_ASSERT_DOUBLE_WITHIN(0.02, truth.centre.y, seen.centre.y);
            TEST_ASSERT_DOUBLE_WITHIN(0.02, axes_of(truth).a, axes_of(seen).a);
            TEST_ASSERT_DOUBLE_WITHIN(0.02, axes_of(truth).b, axes_of(seen).b);
        }
    }
}

void test_point_is_where_it_is_projected(void) {
    const Pose X_world_cam = camera_in_eye();
    for (const int width : {160, 320, 640}) {
        const Intrinsics camera = make_intrinsics("icub-2010-06", width);
        Renderer renderer(camera, 2);
        for (const Vec3 &place : kPlaces) {
            Drawing drawing;
            drawing.solids.push_back(white_ball(place, 0.02));
            const cv::Point2d seen =
                ellipse_of_picture(renderer.picture(drawing, X_world_cam)).centre;
            const cv::Point2d truth = project(camera, inverse(X_world_cam) * place);
            TEST_ASSERT_DOUBLE_WITHIN(0.1, 0.0, cv::norm(truth - seen));
        }
    }
}

// The table of facts that the library's tests have too: centre, radius, and the
// outline's centre, semi-axes and angle for f = 257.34, c = (160, 120).
void test_outline_of_known_spheres(void) {
    const Mat3 K(257.34, 0, 160, 0, 257.34, 120, 0, 0, 1);
    const Ellipse first = *outline_of_sphere(K, Vec3(0.1, 0, 0.4), 0.0331);
    TEST_ASSERT_DOUBLE_WITHIN(1e-3, 224.7786, first.centre.x);
    TEST_ASSERT_DOUBLE_WITHIN(1e-3, 120.0, first.centre.y);
    TEST_ASSERT_DOUBLE_WITHIN(1e-3, 22.0303, axes_of(first).a);
    TEST_ASSERT_DOUBLE_WITHIN(1e-3, 21.3682, axes_of(first).b);
    const Ellipse second = *outline_of_sphere(K, Vec3(0.1, 0.06, 0.3), 0.0331);
    TEST_ASSERT_DOUBLE_WITHIN(1e-3, 246.8371, second.centre.x);
    TEST_ASSERT_DOUBLE_WITHIN(1e-3, 172.1023, second.centre.y);
    TEST_ASSERT_DOUBLE_WITHIN(1e-3, 30.6749, axes_of(second).a);
    TEST_ASSERT_DOUBLE_WITHIN(1e-3, 28.5676, axes_of(second).b);
    TEST_ASSERT_DOUBLE_WITHIN(1e-3, 30.964, axes_of(second).angle * 180.0 / kPi);
    TEST_ASSERT_FALSE(outline_of_sphere(K, Vec3(0, 0, 0.03), 0.0331).has_value());
}

// A ray through the pixel of a point goes through the point.
void test_ray_undoes_projection(void) {
    const Intrinsics camera = make_intrinsics("icub-2009", 320);
    const Vec3 p_cam(0.3, -0.2, 1.7);
    const Vec3 along = *pixel_ray(camera, project(camera, p_cam));
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 0.0, cv::norm(along - cv::normalize(p_cam)));
}

// A ball's disc has the ball's outline from the front, and less from the side.
void test_disc(void) {
    Renderer renderer(make_intrinsics("icub-2010", 320), 4);
    Drawing drawing;
    drawing.solids.push_back(white_ball(Vec3(2, 0, 0), 0.17));
    drawing.solids[0].shape = Shape::kDisc;
    drawing.solids[0].half_size[0] = 0.0005;
    const EllipseAxes front =
        axes_of(ellipse_of_picture(renderer.picture(drawing, camera_in_eye())));
    TEST_ASSERT_DOUBLE_WITHIN(0.02, 257.3408 * 0.17 / 1.9995, front.a);
    TEST_ASSERT_DOUBLE_WITHIN(0.02, front.a, front.b);
    drawing.solids[0].X_world_solid.r = rotation(2, radians(60));
    const EllipseAxes side =
        axes_of(ellipse_of_picture(renderer.picture(drawing, camera_in_eye())));
    TEST_ASSERT_DOUBLE_WITHIN(0.15, front.a / 2, side.b); // its rim is seen too
}

// What stands before the target takes of its area; what stands behind does not.
void test_target_area(void) {
    Renderer renderer(make_intrinsics("icub-2010", 320), 2);
    Drawing drawing;
    drawing.solids.push_back(white_ball(Vec3(2, 0, 0), 0.17));
    const double whole = renderer.target_area(drawing, camera_in_eye());
    TEST_ASSERT_DOUBLE_WITHIN(5.0, kPi * 21.95 * 21.95, whole);
    Solid plate;
    plate.half_size = Vec3(0.01, 1.0, 1.0);
    plate.X_world_solid.p = Vec3(1.5, 1.0, 0);
    drawing.solids.push_back(plate);
    TEST_ASSERT_DOUBLE_WITHIN(whole * 0.01, whole / 2,
                              renderer.target_area(drawing, camera_in_eye()));
    drawing.solids[1].X_world_solid.p[0] = 3.0;
    TEST_ASSERT_EQUAL_DOUBLE(whole, renderer.target_area(drawing, camera_in_eye()));
}

} // namespace

int main() {
    UNITY_BEGIN();
    RUN_TEST(test_sphere_outline_is_the_true_ellipse);
    RUN_TEST(test_point_is_where_it_is_projected);
    RUN_TEST(test_outline_of_known_spheres);
    RUN_TEST(test_ray_undoes_projection);
    RUN_TEST(test_disc);
    RUN_TEST(test_target_area);
    return UNITY_END();
}
