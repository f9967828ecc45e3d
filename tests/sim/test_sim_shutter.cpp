// SPDX-License-Identifier: MIT
//
// What moves while a picture is taken: an edge is as wide as it goes during the
// exposure, and leans by what it goes during the readout.
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

constexpr double kDepth = 2.0;
constexpr double kSpeed = 1200.0; // px/s to the right

// A white upright bar 100 px wide about column 160, that moves across the picture.
Motion moving_bar(const Intrinsics &camera) {
    const double smu_of_px = kDepth / camera.fx;
    return [=](double t) {
        View view;
        view.X_world_cam = camera_in_eye();
        Solid bar;
        bar.half_size = Vec3(0.001, 50 * smu_of_px, 20);
        // Right is -y; the picture's middle is column 159.5.
        bar.X_world_solid.p = Vec3(kDepth + 0.001, -(0.5 + kSpeed * t) * smu_of_px, 0);
        bar.colour = Vec3(1, 1, 1);
        view.drawing.solids.push_back(bar);
        return view;
    };
}

double share(const cli::Image &image, std::uint32_t x, std::uint32_t y) {
    return image.row(y)[3 * x] / 255.0;
}

// Where the bar's left edge is in a row: what is missing of white up to the middle.
double left_edge(const cli::Image &image, std::uint32_t y) {
    double x = 160.5;
    for (std::uint32_t column = 0; column <= 160; ++column) {
        x -= share(image, column, y);
    }
    return x;
}

// The width of a ramp from black to white: it is half white in the mean, and
// 1 - |2 share - 1| sums to half of the width.
double edge_width(const cli::Image &image, std::uint32_t y) {
    double sum = 0.0;
    for (std::uint32_t column = 0; column <= 160; ++column) {
        sum += 1.0 - std::abs(2.0 * share(image, column, y) - 1.0);
    }
    return 2.0 * sum;
}

void test_instant_shutter_is_a_still(void) {
    const Intrinsics camera = make_intrinsics("icub-2010", 320);
    Renderer renderer(camera, 2);
    const Motion motion = moving_bar(camera);
    const cli::Image moving = renderer.picture(motion);
    const View now = motion(0.0);
    const cli::Image still = renderer.picture(now.drawing, now.X_world_cam);
    TEST_ASSERT_EQUAL_UINT8_ARRAY(still.pixels.data(), moving.pixels.data(), still.pixels.size());
    TEST_ASSERT_DOUBLE_WITHIN(0.26, 110.0, left_edge(still, 120));
}

void test_exposure_widens_an_edge_by_what_it_goes(void) {
    const Intrinsics camera = make_intrinsics("icub-2010", 320);
    const Shutter shutter{0.02, 32, 0.0};
    const cli::Image picture = Renderer(camera, 2, shutter).picture(moving_bar(camera));
    for (const std::uint32_t y : {0U, 120U, 239U}) {
        TEST_ASSERT_DOUBLE_WITHIN(0.5, kSpeed * shutter.exposure, edge_width(picture, y));
        TEST_ASSERT_DOUBLE_WITHIN(0.26, 110.0, left_edge(picture, y)); // about its own moment
    }
    // Evenly white along the way.
    for (int x = 99; x < 121; ++x) {
        const double expected = (x - 98.0) / 24.0;
        TEST_ASSERT_DOUBLE_WITHIN(0.04, expected, share(picture, static_cast<unsigned>(x), 60));
    }
}

void test_readout_shears_by_what_it_goes(void) {
    const Intrinsics camera = make_intrinsics("icub-2010", 320);
    for (const int supersampling : {1, 2}) {
        const Shutter shutter{0.0, 1, 0.025};
        Renderer renderer(camera, supersampling, shutter);
        const cli::Image picture = renderer.picture(moving_bar(camera));
        const double tolerance = supersampling == 1 ? 0.51 : 0.26; // half a sample
        for (std::uint32_t y = 0; y < 240; ++y) {
            const double t = ((y + 0.5) / 240 - 0.5) * shutter.readout;
            TEST_ASSERT_DOUBLE_WITHIN(tolerance, 110.0 + kSpeed * t, left_edge(picture, y));
        }
        const double shear = left_edge(picture, 239) - left_edge(picture, 0);
        TEST_ASSERT_DOUBLE_WITHIN(1.0, kSpeed * shutter.readout * 239 / 240, shear);
    }
}

// Both, by a camera that turns instead of a bar that moves, and through a lens.
void test_turning_camera(void) {
    constexpr double kTurn = 3.0; // radians/s to the left: the bar goes right
    Intrinsics camera = make_intrinsics("icub-2010", 160);
    camera.lens = {-0.2, 0.05, 0, 0, 0};
    const Shutter shutter{0.01, 16, 0.02};
    const Vec3 place(kDepth, 0.2, 0.3);
    const Motion motion = [&](double t) {
        View view;
        view.X_world_cam = Pose{rotation(2, kTurn * t), Vec3()} * camera_in_eye();
        view.drawing.solids.push_back(white_ball(place, 0.1));
        return view;
    };
    Renderer renderer(camera, 4, shutter);
    const cv::Point2d seen = ellipse_of_picture(renderer.picture(motion)).centre;
    // Where it is in the row in which it is, at that row's time.
    cv::Point2d expected(80, 60);
    for (int i = 0; i < 20; ++i) {
        const double t = ((expected.y + 0.5) / camera.height - 0.5) * shutter.readout;
        expected = project(camera, inverse(motion(t).X_world_cam) * place);
    }
    TEST_ASSERT_DOUBLE_WITHIN(0.1, expected.x, seen.x);
    TEST_ASSERT_DOUBLE_WITHIN(0.1, expected.y, seen.y);
    const cv::Point2d still = project(camera, inverse(camera_in_eye()) * place);
    TEST_ASSERT_TRUE(std::abs(expected.x - still.x) > 1.0);
    TEST_ASSERT_TRUE(renderer.seen_area() > 100.0);
}

} // namespace

int main() {
    UNITY_BEGIN();
    RUN_TEST(test_instant_shutter_is_a_still);
    RUN_TEST(test_exposure_widens_an_edge_by_what_it_goes);
    RUN_TEST(test_readout_shears_by_what_it_goes);
    RUN_TEST(test_turning_camera);
    return UNITY_END();
}
