// SPDX-License-Identifier: MIT
//
// The threshold table's search against a twin that tries every threshold.
#include <opencv2/imgproc.hpp>

#include "methods/hough.hpp"
#include "support/random.hpp"
#include "trials/threshold.hpp"

#include <unity.h> // last: it defines isinf and isnan as macros

void setUp(void) {
}

void tearDown(void) {
}

namespace {

constexpr int kWidth = 96;
constexpr int kHeight = 72;
constexpr int kTwinLimit = 160; // more votes than a circle of these sizes has pixels

// A disc, a share of it cut off, among specks; and now and then another, larger disc,
// so that the strongest circle is the wrong one.
sim::ThresholdPicture make_picture(sim::Random &random, bool decoy) {
    const double radius = random.uniform(7.0, 12.0);
    const cv::Point2d centre(random.uniform(18.0, 40.0), random.uniform(25.0, 45.0));
    const double cut = random.uniform(-0.2, 1.0) * radius;
    cv::Mat mask(kHeight, kWidth, CV_8UC1, cv::Scalar(0));
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const cv::Point2d off = cv::Point2d(x, y) - centre;
            const bool inside = cv::norm(off) < radius && off.x < cut;
            const bool speck = random.uniform() < 0.004;
            mask.at<std::uint8_t>(y, x) = inside != speck ? 255 : 0;
        }
    }
    if (decoy) {
        cv::circle(mask, {72, 36}, 16, cv::Scalar(255), cv::FILLED);
    }
    const double area = radius * radius;
    return {sim::hough_picture(mask), {centre, cv::Matx22d(area, 0, 0, area)}};
}

std::vector<sim::ThresholdTrial> make_trials(sim::Random &random, int count, double decoys) {
    std::vector<sim::ThresholdTrial> trials;
    for (int i = 0; i < count; ++i) {
        const bool decoy = random.uniform() < decoys;
        sim::ThresholdTrial trial{make_picture(random, decoy)};
        trial.push_back(make_picture(random, false));
        trials.push_back(trial);
    }
    return trials;
}

bool works_in_all_pictures(const sim::ThresholdTrial &trial, int votes) {
    bool works = true;
    for (const sim::ThresholdPicture &picture : trial) {
        std::vector<cv::Vec3f> circles;
        cv::HoughCircles(picture.picture, circles, cv::HOUGH_GRADIENT, 1.0, kHeight, 100.0, votes,
                         3, kHeight / 2);
        bool found = false;
        if (!circles.empty()) {
            const double radius = std::sqrt(picture.truth.shape(0, 0));
            const cv::Point2d off =
                cv::Point2d(circles[0][0], circles[0][1]) - picture.truth.centre;
            found =
                cv::norm(off) <= radius / 4.0 && std::fabs(circles[0][2] - radius) <= radius / 5.0;
        }
        works = works && found;
    }
    return works;
}

int twin(const std::vector<sim::ThresholdTrial> &trials, double share) {
    int best = 0;
    for (int votes = 1; votes <= kTwinLimit; ++votes) {
        int working = 0;
        for (const sim::ThresholdTrial &trial : trials) {
            working += works_in_all_pictures(trial, votes) ? 1 : 0;
        }
        if (working >= share * static_cast<double>(trials.size()) - 1e-9) {
            best = votes;
        }
    }
    return best;
}

void test_search_equals_the_twin(void) {
    sim::Random random(20110727);
    int positive = 0;
    for (const double decoys : {0.0, 0.3}) {
        for (int set = 0; set < 4; ++set) {
            const auto trials = make_trials(random, 5, decoys);
            for (const double share : {1.0, 0.8, 0.5}) {
                const int expected = twin(trials, share);
                TEST_ASSERT_EQUAL_INT(expected, sim::largest_working(trials, share));
                positive += expected > 0 ? 1 : 0;
            }
        }
    }
    TEST_ASSERT_GREATER_THAN_INT(12, positive); // else it would compare zeros
}

void test_a_larger_share_is_no_higher(void) {
    sim::Random random(7);
    const auto trials = make_trials(random, 6, 0.0);
    TEST_ASSERT_LESS_OR_EQUAL_INT(sim::largest_working(trials, 0.5),
                                  sim::largest_working(trials, 1.0));
}

void test_nothing_to_find(void) {
    const cv::Mat empty(kHeight, kWidth, CV_8UC1, cv::Scalar(0));
    const sim::Ellipse truth{{40, 40}, cv::Matx22d(100, 0, 0, 100)};
    TEST_ASSERT_EQUAL_INT(0, sim::largest_working({{{empty, truth}}}, 1.0));
}

} // namespace

int main(void) {
    UNITY_BEGIN();
    RUN_TEST(test_search_equals_the_twin);
    RUN_TEST(test_a_larger_share_is_no_higher);
    RUN_TEST(test_nothing_to_find);
    return UNITY_END();
}
