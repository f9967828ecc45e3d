// SPDX-License-Identifier: MIT
//
// What the report is made of: the files that run, track and paper leave in a folder.
#ifndef OCELLUS_SIM_REPORT_DATA_HPP
#define OCELLUS_SIM_REPORT_DATA_HPP

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace sim {

using Json = nlohmann::ordered_json;

// A sweep's summary.json.  What it has no value for is not a number.
class SweepResult {
  public:
    SweepResult(std::string folder, Json summary);

    const std::string &folder() const {
        return folder_;
    }
    std::string name() const;
    std::vector<std::string> methods() const;
    bool has(const std::string &method) const;
    const std::vector<double> &points() const {
        return points_;
    }
    int trials_at_a_point() const;

    // A value of one method at one point; `statistic` is mean, sd, rms, max, p10 or p90.
    double at(const std::string &method, std::size_t point, const std::string &column,
              const std::string &statistic) const;
    // Over all points.
    double all(const std::string &method, const std::string &column,
               const std::string &statistic) const;
    // Those that are one number: trials, ok, success, ok_but_wrong, err_sq_pct, least_votes.
    double at(const std::string &method, std::size_t point, const std::string &column) const;
    double all(const std::string &method, const std::string &column) const;

    // a, b or r2 of trend_log_err or trend_radius_pct.
    double trend(const std::string &method, const std::string &which,
                 const std::string &coefficient) const;
    double setting(const std::string &key) const;

  private:
    [[noreturn]] void reject(const std::string &why) const;
    const Json &method_json(const std::string &method) const;

    std::string folder_;
    Json summary_;
    std::vector<double> points_;
};

// A run of the closed loop.
struct TrackRun {
    std::string folder; // below the report's
    Json summary;
    std::map<std::string, std::vector<std::string>> columns; // of frames.csv
    bool has_video;

    std::string name() const;
    std::size_t frames() const;
    // Of column `key` in frame i; not a number where the field is empty.
    double number(const std::string &key, std::size_t i) const;
    // Of summary.json; not a number where there is none.
    double figure(const std::string &key) const;
    double figure(const std::string &key, const std::string &part) const;
};

struct ReportData {
    std::string folder;
    std::map<std::string, SweepResult> sweeps; // by name
    std::optional<Json> thresholds;            // table3.json
    std::vector<TrackRun> tracks;
    std::optional<Json> clock;        // clock.json
    std::vector<std::string> missing; // a line each: which file, what makes it

    const SweepResult *sweep(const std::string &name) const {
        const auto found = sweeps.find(name);
        return found == sweeps.end() ? nullptr : &found->second;
    }
};

// cli::InputError when there is nothing to report on, or a file is not what it should be.
ReportData read_report_data(const std::string &folder);

} // namespace sim

#endif
