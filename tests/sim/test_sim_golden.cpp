// SPDX-License-Identifier: MIT
//
// Small frames against those in tests/golden/sim, which this renderer made and
// people looked at.  Another machine's instruction set may round a level here and
// there; what is drawn is left in the build's reports for comparison.
#include <cstdlib>
#include <string>
#include <unity.h>

#include "camera/renderer.hpp"
#include "geometry/frames.hpp"
#include "trials/stage.hpp"
#include "world/paper_head.hpp"

void setUp(void) {
}
void tearDown(void) {
}

namespace {

using namespace sim;

constexpr int kLevels = 2;              // a difference that is no difference
constexpr double kShareAllowed = 0.002; // of the samples may differ by more

Scenario scenario_of(const char *preset, Shape shape, Background background, Lighting lighting) {
    Scenario scenario{};
    scenario.camera = {make_intrinsics(preset, 160), 2, 0.0};
    scenario.target = {shape, 0.17, 0.05, Vec3(20, 60, 230) * (1 / 255.0)};
    scenario.background = background;
    scenario.lighting = lighting;
    return scenario;
}

cli::Image picture_of(const Scenario &scenario, bool hidden) {
    const Vec3 place = eyes_middle() + Vec3(1.2, 0.1, -0.05);
    const Pose X_world_cam = Pose{Mat3::eye(), eyes_middle()} * camera_in_eye();
    Random random(3);
    Drawing drawing = make_drawing(scenario, place, random);
    if (hidden) {
        drawing.solids.push_back(make_occluder({X_world_cam.p, place, 0.17, 0.6}, -0.05));
    }
    return Renderer(scenario.camera.intrinsics, scenario.camera.supersampling)
        .picture(drawing, X_world_cam);
}

void assert_golden(const char *name, const cli::Image &actual) {
    cli::write_png(std::string(OCEL_REPORTS) + "/sim_" + name + ".png", actual);
    const cli::Image expected =
        cli::read_image(std::string(OCEL_GOLDEN_DIR) + "/" + name + ".png", cli::Purpose::kPicture);
    TEST_ASSERT_EQUAL_UINT32(expected.width, actual.width);
    TEST_ASSERT_EQUAL_UINT32(expected.height, actual.height);
    TEST_ASSERT_EQUAL_UINT32(expected.pixels.size(), actual.pixels.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < actual.pixels.size(); ++i) {
        different += std::abs(actual.pixels[i] - expected.pixels[i]) > kLevels ? 1U : 0U;
    }
    TEST_ASSERT_TRUE_MESSAGE(different <= kShareAllowed * actual.pixels.size(), name);
}

void test_plain_ball(void) {
    assert_golden("plain_ball", picture_of(scenario_of("icub-2010", Shape::kBall,
                                                       Background::kPlain, Lighting::kFlat),
                                           false));
}

void test_cluttered_harsh_hidden(void) {
    assert_golden(
        "cluttered_harsh",
        picture_of(scenario_of("icub-2010", Shape::kBall, Background::kCluttered, Lighting::kHarsh),
                   true));
}

void test_textured_soft_disc_stretched(void) {
    assert_golden(
        "textured_soft_disc",
        picture_of(scenario_of("icub-2009", Shape::kDisc, Background::kTextured, Lighting::kSoft),
                   false));
}

void test_barrel(void) {
    Scenario scenario =
        scenario_of("icub-2010", Shape::kDisc, Background::kCluttered, Lighting::kHarsh);
    scenario.camera.intrinsics.lens = {-0.35, 0.12, 0.004, -0.006, 0.0};
    assert_golden("barrel", picture_of(scenario, false));
}

} // namespace

int main() {
    UNITY_BEGIN();
    RUN_TEST(test_plain_ball);
    RUN_TEST(test_cluttered_harsh_hidden);
    RUN_TEST(test_textured_soft_disc_stretched);
    RUN_TEST(test_barrel);
    return UNITY_END();
}
