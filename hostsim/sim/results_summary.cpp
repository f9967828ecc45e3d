// SPDX-License-Identifier: MIT
#include "results.hpp"
#include "statistics.hpp"

namespace sim {

namespace {

using Json = nlohmann::ordered_json;

using Member = double MethodRecord::*;

Json json_of(const Statistics &statistics) {
    return {{"mean", rounded(statistics.mean())},
            {"sd", rounded(statistics.deviation())},
            {"rms", rounded(statistics.rms())},
            {"max", rounded(statistics.largest)}};
}

// One method at one point, or over all of them.
class Group {
  public:
    void add(const MethodRecord &record) {
        ++trials_;
        ok_ += record.status == OCEL_OK ? 1 : 0;
        success_ += record.success ? 1 : 0;
        for (std::size_t i = 0; i < std::size(kMembers); ++i) {
            statistics_[i].add(record.*kMembers[i].member);
        }
        if (record.votes > 0) {
            least_votes_ = least_votes_ == 0 ? record.votes : std::min(least_votes_, record.votes);
        }
    }

    Json json() const {
        Json object{{"trials", trials_}, {"ok", ok_}, {"success", success_}};
        for (std::size_t i = 0; i < std::size(kMembers); ++i) {
            if (statistics_[i].count > 0) {
                object[kMembers[i].name] = json_of(statistics_[i]);
            }
        }
        if (statistics_[0].count > 0) {
            // What the paper's figures seem to show.
            object["err_sq_pct"] = rounded(100.0 * statistics_[0].sum_sq / statistics_[0].count);
        }
        if (least_votes_ > 0) {
            object["least_votes"] = least_votes_;
        }
        return object;
    }

    double mean_error() const {
        return statistics_[0].count > 0 ? statistics_[0].mean() : std::nan("");
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
    int least_votes_ = 0;
    Statistics statistics_[std::size(kMembers)];
};

// The paper's trend line, log(err) = a + b x, by least squares over the points.
Json trend_of(const Scenario &scenario, const std::vector<Group> &points) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double error = points[i].mean_error();
        if (error > 0.0) {
            const double x = scenario.points[i];
            const double y = std::log(error);
            n += 1;
            sx += x;
            sy += y;
            sxx += x * x;
            sxy += x * y;
        }
    }
    const double spread = n * sxx - sx * sx;
    if (!(spread > 0.0)) {
        return nullptr;
    }
    const double b = (n * sxy - sx * sy) / spread;
    return {{"a", rounded((sy - b * sx) / n)}, {"b", rounded(b)}};
}

Json method_json(const Scenario &scenario, std::size_t index,
                 const std::vector<TrialRecord> &records) {
    Group all;
    std::vector<Group> points(scenario.points.size());
    for (const TrialRecord &record : records) {
        all.add(record.methods[index]);
        points[record.point].add(record.methods[index]);
    }
    Json object{{"all", all.json()}, {"trend_log_err", trend_of(scenario, points)}};
    object["points"] = Json::array();
    for (std::size_t i = 0; i < points.size(); ++i) {
        Json point = points[i].json();
        point["at"] = scenario.points[i];
        object["points"].push_back(point);
    }
    return object;
}

} // namespace

Json summary_of(const Scenario &scenario, std::uint64_t seed,
                const std::vector<TrialRecord> &records) {
    Json summary{{"scenario", scenario.name},
                 {"seed", seed},
                 {"trials", records.size()},
                 {"varied", scenario.varied == Varied::kDistance ? "distance" : "occlusion"},
                 {"points", scenario.points}};
    summary["methods"] = Json::object();
    for (std::size_t i = 0; i < scenario.methods.size(); ++i) {
        summary["methods"][method_name(scenario.methods[i])] = method_json(scenario, i, records);
    }
    return summary;
}

} // namespace sim
