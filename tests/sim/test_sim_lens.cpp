// SPDX-License-Identifier: MIT
//
// The lens against OpenCV's, the pictures through it against the lens, and the
// library, told of it, against the truth.
#include <opencv2/calib3d.hpp>
#include <unity.h>

#include "ball_picture.hpp"
#include "camera/renderer.hpp"
#include "geometry/frames.hpp"
#include "methods/detector.hpp"
#include "methods/methods.hpp"
#include "support/random.hpp"
#include "trials/stage.hpp"
#include "world/paper_head.hpp"

void setUp(void) {
}
void tearDown(void) {
}

namespace {

using namespace sim;

// A barrel, a pincushion, and a lens out of its place.
const Lens kLenses[] = {
    {-0.35, 0.12, 0, 0, 0}, {0.25, 0.1, 0, 0, 0.02}, {-0.28, 0.09, 0.004, -0.006, -0.01}};

const Vec3 kPlaces[] = {{1.2, 0, 0},      {1.2, 0.35, 0.25}, {1.2, -0.37, 0.2},
                        {2.0, 0.6, -0.4}, {2.4, -0.9, 0.7},  {2.2, 0.013, -0.77}};

Intrinsics camera_of(const Lens &lens, int width) {
    Intrinsics camera = make_intrinsics("icub-2010", width);
    camera.lens = lens;
    return camera;
}

std::vector<cv::Point2d> projected_by_opencv(const Intrinsics &camera,
                                             const std::vector<cv::Point3d> &points) {
    const Lens &lens = camera.lens;
    std::vector<cv::Point2d> pixels;
    cv::projectPoints(points, cv::Vec3d(), cv::Vec3d(), camera_matrix(camera),
                      std::vector<double>{lens.k1, lens.k2, lens.p1, lens.p2, lens.k3}, pixels);
    return pixels;
}

void test_projection_is_opencvs_and_the_ray_undoes_it(void) {
    Random random(7);
    for (const Lens &lens : kLenses) {
        const Intrinsics camera = camera_of(lens, 640);
        for (int i = 0; i < 200; ++i) {
            const cv::Point2d pixel(random.uniform(0, 639), random.uniform(0, 479));
            const auto ray = pixel_ray(camera, pixel);
            TEST_ASSERT_TRUE(ray.has_value());
            const Vec3 p_cam = *ray * random.uniform(0.5, 9.0);
            const cv::Point2d opencv =
                projected_by_opencv(camera, {cv::Point3d(p_cam[0], p_cam[1], p_cam[2])})[0];
            TEST_ASSERT_DOUBLE_WITHIN(1e-9, 0.0, cv::norm(opencv - project(camera, p_cam)));
            TEST_ASSERT_DOUBLE_WITHIN(1e-8, 0.0, cv::norm(opencv - pixel));
        }
    }
}

// The circle in which rays touch the sphere, by OpenCV into the picture.
Ellipse outline_by_opencv(const Intrinsics &camera, const Vec3 &p_cam, double radius) {
    const double sine = radius / cv::norm(p_cam);
    const Vec3 axis = cv::normalize(p_cam);
    const Vec3 right = cv::normalize(Vec3(0.1, 1, 0).cross(axis));
    const Vec3 down = axis.cross(right);
    std::vector<cv::Point3d> points;
    for (int i = 0; i < 720; ++i) {
        const double turn = 2 * kPi * i / 720;
        const Vec3 p = p_cam - axis * (radius * sine) +
                       (right * std::cos(turn) + down * std::sin(turn)) *
                           (radius * std::sqrt(1 - sine * sine));
        points.emplace_back(p[0], p[1], p[2]);
    }
    return ellipse_of_polygon(projected_by_opencv(camera, points));
}

void test_outline_drawn_is_the_one_projected(void) {
    const Pose X_world_cam = camera_in_eye();
    for (const Lens &lens : kLenses) {
        const Intrinsics camera = camera_of(lens, 160);
        Renderer renderer(camera, 4);
        for (const Vec3 &place : kPlaces) {
            const Vec3 p_cam = inverse(X_world_cam) * place;
            Drawing drawing;
            drawing.solids.push_back(white_ball(place, 0.17));
            const Ellipse drawn = ellipse_of_picture(renderer.picture(drawing, X_world_cam));
            const Ellipse truth = outline_by_opencv(camera, p_cam, 0.17);
            TEST_ASSERT_DOUBLE_WITHIN(0.02, 0.0, cv::norm(truth.centre - drawn.centre));
            TEST_ASSERT_DOUBLE_WITHIN(0.02, axes_of(truth).a, axes_of(drawn).a);
            TEST_ASSERT_DOUBLE_WITHIN(0.02, axes_of(truth).b, axes_of(drawn).b);
            const Ellipse seen = *seen_outline(camera, p_cam, 0.17);
            TEST_ASSERT_DOUBLE_WITHIN(1e-3, 0.0, cv::norm(truth.centre - seen.centre));
        }
    }
}

cli::Image cluttered_picture(const Lens &lens, const char *file) {
    Setting setting{};
    setting.target = {Shape::kDisc, 0.17, 0.05, Vec3(20, 60, 230) * (1 / 255.0)};
    setting.background = Background::kCluttered;
    setting.lighting = Lighting::kHarsh;
    const Pose X_world_cam = Pose{Mat3::eye(), eyes_middle()} * camera_in_eye();
    Random random(3);
    const Drawing drawing = make_drawing(setting, eyes_middle() + Vec3(1.2, 0.1, -0.05), random);
    const cli::Image picture = Renderer(camera_of(lens, 160), 2).picture(drawing, X_world_cam);
    cli::write_png(std::string(OCEL_REPORTS) + "/sim_" + file + ".png", picture);
    return picture;
}

std::size_t different(const cli::Image &a, const cli::Image &b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        count += std::abs(a.pixels[i] - b.pixels[i]) > 2 ? 1U : 0U;
    }
    return count;
}

// By rays with a lens that bends by nothing, by triangles without one: floor, wall,
// boxes, balls, disc, textures and highlights are where they were.
void test_rays_draw_what_triangles_draw(void) {
    const cli::Image straight = cluttered_picture({}, "cluttered_pinhole");
    const cli::Image cast = cluttered_picture({1e-12, 0, 0, 0, 0}, "cluttered_rays");
    TEST_ASSERT_LESS_THAN_size_t(straight.pixels.size() / 250, different(straight, cast));
    const cli::Image bent = cluttered_picture(kLenses[0], "cluttered_barrel");
    TEST_ASSERT_GREATER_THAN_size_t(straight.pixels.size() / 20, different(straight, bent));
}

ocel_colour_range_t white() {
    ocel_colour_range_t range{};
    range.space = OCEL_SPACE_GRAY;
    range.lo[0] = 128;
    range.hi[0] = 255;
    return range;
}

// Told of the lens, it gives the ball back; not told, it does not.
void test_library_undoes_the_lens(void) {
    const Pose X_world_cam = camera_in_eye();
    double worst_untold = 0.0;
    for (const Lens &lens : kLenses) {
        const Intrinsics camera = camera_of(lens, 320);
        Renderer renderer(camera, 2);
        Detector told(camera, white(), 16);
        Detector untold(camera_of({}, 320), white(), 16);
        for (const Vec3 &place : kPlaces) {
            const Vec3 p_cam = inverse(X_world_cam) * place;
            Drawing drawing;
            drawing.solids.push_back(white_ball(place, 0.17));
            const cli::Image picture = renderer.picture(drawing, X_world_cam);
            told.look(picture);
            untold.look(picture);
            const Outline outline = find_outline(Method::kSphere, told, 1);
            TEST_ASSERT_EQUAL(OCEL_OK, outline.status);
            TEST_ASSERT_DOUBLE_WITHIN(4e-4, 0.0, cv::norm(outline.d_cam - cv::normalize(p_cam)));
            TEST_ASSERT_DOUBLE_WITHIN(0.01 * 0.17, 0.17,
                                      cv::norm(p_cam) * outline.cone.sin_q30 / 1073741824.0);
            TEST_ASSERT_DOUBLE_WITHIN(
                0.15, 0.0,
                cv::norm(outline.ellipse.centre - seen_outline(camera, p_cam, 0.17)->centre));
            const Outline blind = find_outline(Method::kSphere, untold, 1);
            worst_untold = std::max(worst_untold, cv::norm(blind.d_cam - cv::normalize(p_cam)));
        }
    }
    TEST_ASSERT_TRUE(worst_untold > 0.01);
}

// Rays that no lens bends so far, and those beyond its fold, have no way back.
void test_a_fold_has_no_ray(void) {
    const Lens folding{-1.0, 0, 0, 0, 0}; // at r = .577, where r' = .385
    TEST_ASSERT_FALSE(unbent(folding, {0.39, 0}).has_value());
    TEST_ASSERT_TRUE(unbent(folding, {0.38, 0}).has_value());
    TEST_ASSERT_FALSE(pixel_without_ray(camera_of(kLenses[0], 320)).has_value());
    TEST_ASSERT_TRUE(pixel_without_ray(camera_of(folding, 320)).has_value());
}

} // namespace

int main() {
    UNITY_BEGIN();
    RUN_TEST(test_projection_is_opencvs_and_the_ray_undoes_it);
    RUN_TEST(test_outline_drawn_is_the_one_projected);
    RUN_TEST(test_rays_draw_what_triangles_draw);
    RUN_TEST(test_library_undoes_the_lens);
    RUN_TEST(test_a_fold_has_no_ray);
    return UNITY_END();
}
