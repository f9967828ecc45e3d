// SPDX-License-Identifier: MIT
#include "trials/threshold.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <memory>

#include "methods/detector.hpp"
#include "methods/hough.hpp"
#include "support/processes.hpp"
#include "support/statistics.hpp"
#include "trials/trial.hpp"

namespace sim {

namespace {

using Json = nlohmann::ordered_json;

bool works(const ThresholdTrial &trial, int votes) {
    return std::all_of(trial.begin(), trial.end(), [votes](const ThresholdPicture &picture) {
        return threshold_works(picture, votes);
    });
}

// One trial's own largest threshold; none above most_votes finds anything.
int largest_of(const ThresholdTrial &trial) {
    int votes = kVotesLimit;
    for (const ThresholdPicture &picture : trial) {
        votes = std::min(votes, most_votes(picture.picture));
    }
    while (votes > 0 && !works(trial, votes)) {
        --votes;
    }
    return votes;
}

// What a process finds of a point.
struct Row {
    int votes;
    int votes_most;
    int pictures;
    int rounded_alike;
    double radius_px;
};

bool same_circle(const std::optional<Ellipse> &a, const std::optional<Ellipse> &b) {
    return a && b ? a->centre == b->centre && a->shape == b->shape : !a && !b;
}

// Whether param2 is rounded: the picture's own highest threshold, a little more and a
// little less.
bool is_rounded(const ThresholdPicture &picture) {
    const int votes = most_votes(picture.picture);
    const auto circle = hough_circle(picture.picture, votes);
    return same_circle(circle, hough_circle(picture.picture, votes + 0.4)) &&
           same_circle(circle, hough_circle(picture.picture, votes - 0.4));
}

// Draws the trials of a scenario again and keeps what the transform is given.
class ThresholdStudio {
  public:
    ThresholdStudio(const Scenario &scenario, const SweepChoice &choice)
        : scenario_(scenario), choice_(choice), studio_(scenario_, nullptr),
          detector_(scenario.camera.intrinsics, scenario.colour, scenario.min_area) {
    }

    Row row(std::size_t point) {
        std::vector<ThresholdTrial> trials;
        for (int trial = 0; trial < choice_.trials_of(scenario_); ++trial) {
            trials.push_back(pictures_of({point, trial, choice_.seed}));
        }
        Row row{largest_working(trials, 1.0), largest_working(trials, kMostShare), 0, 0, 0.0};
        for (const ThresholdTrial &trial : trials) {
            for (const ThresholdPicture &picture : trial) {
                ++row.pictures;
                row.rounded_alike += is_rounded(picture) ? 1 : 0;
                row.radius_px += mean_radius(picture.truth);
            }
        }
        row.radius_px /= row.pictures;
        return row;
    }

  private:
    ThresholdTrial pictures_of(const TrialKey &key) {
        TrialPictures pictures;
        (void)studio_.run(key, &pictures);
        ThresholdTrial trial;
        for (const Side side : {kLeft, kRight}) {
            detector_.look(pictures.frames[side]);
            const auto truth = true_outline(scenario_, pictures.truth, side);
            if (truth) {
                trial.push_back({hough_picture(detector_.mask()), *truth});
            }
        }
        return trial;
    }

    Scenario scenario_;
    const SweepChoice choice_;
    Studio studio_;
    Detector detector_;
};

Json json_of(const Row &row, double at, int trials) {
    const double circumference = 2.0 * kPi * row.radius_px;
    return {{"at", at},
            {"trials", trials},
            {"radius_px", rounded(row.radius_px)},
            {"votes", row.votes},
            {"votes_of_circumference", rounded(row.votes / circumference)},
            {"votes_most", row.votes_most},
            {"pictures", row.pictures},
            {"rounded_alike", row.rounded_alike}};
}

} // namespace

bool threshold_works(const ThresholdPicture &picture, int votes) {
    const auto circle = hough_circle(picture.picture, votes);
    return circle && is_success(*circle, picture.truth);
}

int largest_working(const std::vector<ThresholdTrial> &trials, double share) {
    std::vector<int> largest;
    for (const ThresholdTrial &trial : trials) {
        largest.push_back(largest_of(trial));
    }
    std::sort(largest.begin(), largest.end(), std::greater<>());
    const auto needed =
        static_cast<std::size_t>(std::ceil(share * static_cast<double>(trials.size()) - 1e-9));
    // More than this and fewer trials than are needed have their own largest that high.
    int votes = largest[needed - 1];
    const auto enough = [&](int candidate) {
        return static_cast<std::size_t>(
                   std::count_if(trials.begin(), trials.end(), [&](const ThresholdTrial &trial) {
                       return works(trial, candidate);
                   })) >= needed;
    };
    while (votes > 0 && !enough(votes)) {
        --votes;
    }
    return votes;
}

Json threshold_rows(const Scenario &scenario, const SweepChoice &choice) {
    Scenario unmeasured = scenario;
    unmeasured.methods.clear();
    const Batch batch{scenario.name + " thresholds", scenario.points.size(), "points", choice.jobs};
    const auto found = results_of<Row>(batch, [&]() -> std::function<Row(std::size_t)> {
        const auto studio = std::make_shared<ThresholdStudio>(unmeasured, choice);
        return [studio](std::size_t point) { return studio->row(point); };
    });
    Json rows = Json::array();
    for (std::size_t i = 0; i < found.size(); ++i) {
        rows.push_back(json_of(found[i], scenario.points[i], choice.trials_of(scenario)));
    }
    return rows;
}

} // namespace sim
