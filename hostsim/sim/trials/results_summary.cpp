// SPDX-License-Identifier: MIT
#include "support/statistics.hpp"
#include "trials/results.hpp"

namespace sim {

namespace {

using Json = nlohmann::ordered_json;

using Member = double MethodRecord::*;

// Statistics, and between which values the middle eight tenths lie.
class Samples {
  public:
    void add(double value) {
        statistics_.add(value);
        if (!std::isnan(value)) {
            values_.push_back(value);
        }
    }
    bool empty() const {
        return values_.empty();
    }
    double mean() const {
        return empty() ? std::nan("") : statistics_.mean();
    }
    double mean_sq() const {
        return statistics_.sum_sq / statistics_.count;
    }

    Json json() const {
        std::vector<double> sorted = values_;
        std::sort(sorted.begin(), sorted.end());
        return {{"mean", rounded(statistics_.mean())},   {"sd", rounded(statistics_.deviation())},
                {"rms", rounded(statistics_.rms())},     {"max", rounded(statistics_.largest)},
                {"p10", rounded(quantile(sorted, 0.1))}, {"p90", rounded(quantile(sorted, 0.9))}};
    }

  private:
    // Between the two samples that it falls between, in proportion.
    static double quantile(const std::vector<double> &sorted, double share) {
        const double place = share * static_cast<double>(sorted.size() - 1);
        const auto below = static_cast<std::size_t>(place);
        const std::size_t above = std::min(below + 1, sorted.size() - 1);
        return sorted[below] +
               (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
    }

    Statistics statistics_;
    std::vector<double> values_;
};

// One method at one point, or over all of them.
class Group {
  public:
    void add(const TrialRecord &trial, const MethodRecord &record) {
        ++trials_;
        ok_ += record.status == OCEL_OK ? 1 : 0;
        success_ += record.success ? 1 : 0;
        ok_but_wrong_ += record.status == OCEL_OK && !record.success ? 1 : 0;
        for (std::size_t i = 0; i < std::size(kMembers); ++i) {
            samples_[i].add(record.*kMembers[i].member);
        }
        error_x_.add(record.p_world[0] - trial.p_true[0]);
        if (record.votes > 0) {
            least_votes_ = least_votes_ == 0 ? record.votes : std::min(least_votes_, record.votes);
        }
    }

    Json json() const {
        Json object{{"trials", trials_},
                    {"ok", ok_},
                    {"success", success_},
                    {"ok_but_wrong", ok_but_wrong_}};
        for (std::size_t i = 0; i < std::size(kMembers); ++i) {
            if (!samples_[i].empty()) {
                object[kMembers[i].name] = samples_[i].json();
            }
        }
        if (!error_x_.empty()) {
            object["err_x"] = error_x_.json();
            // What the paper's figures seem to show.
            object["err_sq_pct"] = rounded(100.0 * samples_[0].mean_sq());
        }
        if (least_votes_ > 0) {
            object["least_votes"] = least_votes_;
        }
        return object;
    }

    double mean_of(Member member) const {
        for (std::size_t i = 0; i < std::size(kMembers); ++i) {
            if (kMembers[i].member == member) {
                return samples_[i].mean();
            }
        }
        return std::nan("");
    }

  private:
    struct Named {
        const char *name;
        Member member;
    };
    static constexpr Named kMembers[] = {
        {"err", &MethodRecord::error},
        {"err_encoder", &MethodRecord::error_encoder},
        {"err_residual", &MethodRecord::error_residual},
        {"err_debiased", &MethodRecord::error_debiased},
        {"radius_err_pct", &MethodRecord::radius_error_pct},
        {"radius_true_depth_err_pct", &MethodRecord::radius_true_depth_error_pct},
        {"centre_err_px", &MethodRecord::centre_error_px}};

    int trials_ = 0;
    int ok_ = 0;
    int success_ = 0;
    int ok_but_wrong_ = 0;
    int least_votes_ = 0;
    Samples samples_[std::size(kMembers)];
    Samples error_x_;
};

// y = a + b x by least squares, and the share r2 of y's variance that it explains;
// points that have no y are left out.  Null when there are too few.
Json line_through(const std::vector<double> &x, const std::vector<double> &y) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (std::isfinite(y[i])) {
            n += 1;
            sx += x[i];
            sy += y[i];
            sxx += x[i] * x[i];
            sxy += x[i] * y[i];
            syy += y[i] * y[i];
        }
    }
    const double spread = n * sxx - sx * sx;
    const double spread_y = n * syy - sy * sy;
    if (!(spread > 0.0) || !(spread_y > 0.0)) {
        return nullptr;
    }
    const double covariance = n * sxy - sx * sy;
    const double b = covariance / spread;
    return {{"a", rounded((sy - b * sx) / n)},
            {"b", rounded(b)},
            {"r2", rounded(covariance * b / spread_y)}};
}

// The paper's trend lines: exponential in the position's error, log(err) = a + b x ...
Json error_trend(const Scenario &scenario, const std::vector<Group> &points) {
    std::vector<double> logs;
    for (const Group &point : points) {
        logs.push_back(std::log(point.mean_of(&MethodRecord::error)));
    }
    return line_through(scenario.points, logs);
}

// ... and straight in the radius's.
Json radius_trend(const Scenario &scenario, const std::vector<Group> &points) {
    std::vector<double> means;
    for (const Group &point : points) {
        means.push_back(point.mean_of(&MethodRecord::radius_true_depth_error_pct));
    }
    return line_through(scenario.points, means);
}

Json method_json(const Scenario &scenario, std::size_t index,
                 const std::vector<TrialRecord> &records) {
    Group all;
    std::vector<Group> points(scenario.points.size());
    for (const TrialRecord &record : records) {
        all.add(record, record.methods[index]);
        points[record.point].add(record, record.methods[index]);
    }
    Json object{{"all", all.json()},
                {"trend_log_err", error_trend(scenario, points)},
                {"trend_radius_pct", radius_trend(scenario, points)}};
    object["points"] = Json::array();
    for (std::size_t i = 0; i < points.size(); ++i) {
        Json point = points[i].json();
        point["at"] = scenario.points[i];
        object["points"].push_back(point);
    }
    return object;
}

CheckTally tally_of(const std::vector<TrialRecord> &records) {
    CheckTally tally{};
    for (const TrialRecord &record : records) {
        tally.add(record.checks);
    }
    return tally;
}

// What a reader of the figures must know of how they were made.
Json setting_json(const Scenario &scenario) {
    const Intrinsics &camera = scenario.camera.intrinsics;
    return {{"target", scenario.target.shape == Shape::kBall ? "ball" : "disc"},
            {"radius", scenario.target.radius},
            {"jitter", scenario.jitter},
            {"fixated", scenario.gaze == Gaze::kFixate},
            {"focus", scenario.gaze == Gaze::kStill ? Json(scenario.focus) : Json(nullptr)},
            {"tolerance",
             scenario.gaze == Gaze::kFixate ? Json(scenario.gaze_tolerance) : Json(nullptr)},
            {"distance",
             scenario.varied == Varied::kDistance ? Json(nullptr) : Json(scenario.distance)},
            {"fx", rounded(camera.fx)},
            {"fy", rounded(camera.fy)},
            {"width", camera.width},
            {"height", camera.height},
            {"supersampling", scenario.camera.supersampling}};
}

} // namespace

Json summary_of(const Scenario &scenario, std::uint64_t seed,
                const std::vector<TrialRecord> &records) {
    Json summary{
        {"scenario", scenario.name},
        {"seed", seed},
        {"trials", records.size()},
        {"varied", scenario.varied == Varied::kDistance ? "distance" : "occlusion"},
        {"points", scenario.points},
        {"setting", setting_json(scenario)},
        {"checks", checks_json(tally_of(records), count_bounds(scenario.camera.intrinsics))}};
    summary["methods"] = Json::object();
    for (std::size_t i = 0; i < scenario.methods.size(); ++i) {
        summary["methods"][method_name(scenario.methods[i])] = method_json(scenario, i, records);
    }
    return summary;
}

} // namespace sim
