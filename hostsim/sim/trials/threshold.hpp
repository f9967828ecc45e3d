// SPDX-License-Identifier: MIT
//
// The paper's Table 3: the highest threshold of OpenCV's Hough transform with which it
// still finds the ball, over distance and over occlusion.
#ifndef OCELLUS_SIM_THRESHOLD_HPP
#define OCELLUS_SIM_THRESHOLD_HPP

#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <vector>

#include "geometry/ellipse.hpp"
#include "trials/sweep_choice.hpp"

namespace sim {

// A picture for the transform and what is to be found in it.
struct ThresholdPicture {
    cv::Mat picture; // of hough_picture
    Ellipse truth;
};

// Both eyes' pictures: the threshold works in a trial when it does in both.
using ThresholdTrial = std::vector<ThresholdPicture>;

// Whether the strongest circle is the ball.
bool threshold_works(const ThresholdPicture &picture, int votes);

// The largest whole threshold that works in at least `share` (0..1] of the trials; 0:
// there is none.  A threshold that works may have one below it that does not: none
// between the answer and the limit is passed over.
int largest_working(const std::vector<ThresholdTrial> &trials, double share);

constexpr double kMostShare = 0.9;

// A row for each of the scenario's points: at, trials, radius_px (mean), votes (which
// work in all trials), votes_of_circumference (votes / 2 pi r), votes_most (which work in
// kMostShare of the trials), pictures, and rounded_alike: in how many of these thresholds
// .4 above and below a whole one give the same circle as it.
nlohmann::ordered_json threshold_rows(const Scenario &scenario, const SweepChoice &choice);

} // namespace sim

#endif
