// SPDX-License-Identifier: MIT
//
// A frame within its bounds is counted and nothing is told; each seeded violation is.
#include <nlohmann/json.hpp> // before Unity's math.h, which has isnan for a macro

#include <unity.h>
#include <vector>

#include "support/random.hpp"
#include "trials/checks.hpp"

void setUp(void) {
}
void tearDown(void) {
}

namespace {

using namespace sim;

constexpr int kWidth = 160;
constexpr int kHeight = 120;

// A detector that has looked at a white disc, or at salt that is white.
std::unique_ptr<Detector> looking_at(bool salt) {
    ocel_colour_range_t range{};
    range.space = OCEL_SPACE_GRAY;
    range.lo[0] = 128;
    range.hi[0] = 255;
    auto detector = std::make_unique<Detector>(make_intrinsics("icub-2010", kWidth), range, 16);
    cli::Image frame{kWidth, kHeight, 3, std::vector<std::uint8_t>(kWidth * kHeight * 3)};
    Random random(5);
    for (int i = 0; i < kWidth * kHeight; ++i) {
        const double x = i % kWidth - 70;
        const double y = i / kWidth - 50;
        const bool white = salt ? random.uniform() < 0.3 : x * x + y * y < 400;
        for (int channel = 0; white && channel < 3; ++channel) {
            frame.pixels[static_cast<std::size_t>(3 * i + channel)] = 255;
        }
    }
    detector->look(frame);
    return detector;
}

Counts bounds() {
    return count_bounds(make_intrinsics("icub-2010", kWidth));
}

// What is told of one frame.
std::vector<std::string> told(const FrameSight &sight, const Counts &limits) {
    std::vector<std::string> lines;
    FrameChecks checks(limits, [&lines](const std::string &line) { lines.push_back(line); });
    checks.check("here", sight);
    TEST_ASSERT_EQUAL_UINT32(lines.size(), checks.tally().violations);
    TEST_ASSERT_EQUAL_UINT32(1, checks.tally().frames);
    return lines;
}

void assert_told(const std::string &expected, const std::vector<std::string> &lines) {
    TEST_ASSERT_EQUAL_size_t(1, lines.size());
    TEST_ASSERT_EQUAL_STRING(expected.c_str(), lines[0].c_str());
}

void test_good_frames_are_counted(void) {
    const FrameSight disc = sight_of(*looking_at(false), 1256.0);
    const FrameSight salt = sight_of(*looking_at(true), 5760.0);
    TEST_ASSERT_EQUAL(OCEL_OK, disc.status);
    TEST_ASSERT_EQUAL(OCEL_OK, disc.status_cone);
    TEST_ASSERT_EQUAL_UINT32(39, disc.counts[kRuns]); // rows of the disc
    TEST_ASSERT_EQUAL_UINT32(1, disc.counts[kComponents]);
    TEST_ASSERT_EQUAL_UINT32(78, disc.counts[kCracks]);
    TEST_ASSERT_EQUAL_UINT32(156, disc.counts[kPoints]);
    TEST_ASSERT_EQUAL_UINT32(OCEL_CONE_HYPOTHESES, disc.counts[kHypotheses]);
    TEST_ASSERT_GREATER_THAN_UINT32(2000, salt.counts[kRuns]);
    TEST_ASSERT_GREATER_THAN_UINT32(200, salt.counts[kUnions]);
    for (const FrameSight &sight : {disc, salt}) {
        TEST_ASSERT_EQUAL_size_t(0, told(sight, bounds()).size());
    }
}

void test_each_bound_is_held(void) {
    const FrameSight sight = sight_of(*looking_at(true), 5760.0);
    for (int kind = 0; kind < kCountKinds; ++kind) {
        const auto i = static_cast<std::size_t>(kind);
        if (sight.counts[i] > 0) {
            Counts wrong = bounds();
            wrong[i] = sight.counts[i] - 1;
            assert_told("here: " + std::to_string(sight.counts[i]) + " " + count_name(kind) +
                            ", over the library's bound of " + std::to_string(wrong[i]),
                        told(sight, wrong));
        }
    }
    FrameSight more = sight;
    more.counts[kUnions] = more.counts[kRuns] + 1;
    TEST_ASSERT_EQUAL_size_t(1, told(more, bounds()).size());
}

void test_ok_without_a_target(void) {
    const char *const message = "here: status ok, but the target is not in view";
    FrameSight sight = sight_of(*looking_at(false), 0.0);
    assert_told(message, told(sight, bounds()));
    sight.status = OCEL_PARTIAL;
    assert_told(message, told(sight, bounds()));
    sight.status_cone = OCEL_PARTIAL;
    TEST_ASSERT_EQUAL_size_t(0, told(sight, bounds()).size());
}

void test_tallies_add_up(void) {
    FrameChecks checks(bounds());
    checks.check("here", sight_of(*looking_at(false), 1256.0));
    CheckTally sum = checks.tally();
    sum.add({{{7, 9, 0, 0, 500, 0, 0}}, 3, 2});
    TEST_ASSERT_EQUAL_UINT32(39, sum.largest[kRuns]);
    TEST_ASSERT_EQUAL_UINT32(9, sum.largest[kLabels]);
    TEST_ASSERT_EQUAL_UINT32(500, sum.largest[kCracks]);
    TEST_ASSERT_EQUAL_UINT32(4, sum.frames);
    const nlohmann::ordered_json json = checks_json(sum, bounds());
    TEST_ASSERT_EQUAL_INT(2, json["violations"].get<int>());
    TEST_ASSERT_EQUAL_INT(80 * 120, json["counts"]["runs"]["bound"].get<int>());
}

} // namespace

int main() {
    UNITY_BEGIN();
    RUN_TEST(test_good_frames_are_counted);
    RUN_TEST(test_each_bound_is_held);
    RUN_TEST(test_ok_without_a_target);
    RUN_TEST(test_tallies_add_up);
    return UNITY_END();
}
