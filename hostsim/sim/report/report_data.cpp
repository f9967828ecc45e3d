// SPDX-License-Identifier: MIT
#include "report/report_data.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>

#include "error.hpp"
#include "report/report.hpp"

namespace sim {

namespace {

namespace fs = std::filesystem;

const double kNotANumber = std::nan("");

double number_or_none(const Json &object, const std::string &key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_number() ? found->get<double>() : kNotANumber;
}

double statistic_of(const Json &group, const std::string &column, const std::string &statistic) {
    const auto found = group.find(column);
    return found != group.end() && found->is_object() ? number_or_none(*found, statistic)
                                                      : kNotANumber;
}

Json read_json(const fs::path &path) {
    std::ifstream file(path);
    try {
        return Json::parse(file);
    } catch (const Json::exception &mistake) {
        throw cli::InputError(path.string() + ": is no JSON (" + mistake.what() +
                              "); run again what made it, or remove it");
    }
}

std::vector<std::string> split(const std::string &line) {
    std::vector<std::string> fields;
    std::size_t begin = 0;
    for (std::size_t end = 0; end != std::string::npos; begin = end + 1) {
        end = line.find(',', begin);
        fields.push_back(line.substr(begin, end - begin));
    }
    return fields;
}

std::map<std::string, std::vector<std::string>> read_columns(const fs::path &path) {
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    const std::vector<std::string> names = split(line);
    std::map<std::string, std::vector<std::string>> columns;
    for (int number = 2; std::getline(file, line); ++number) {
        const std::vector<std::string> fields = split(line);
        if (fields.size() != names.size()) {
            throw cli::InputError(fmt::format("{}:{}: has {} fields; expected {} as in the head",
                                              path.string(), number, fields.size(), names.size()));
        }
        for (std::size_t i = 0; i < names.size(); ++i) {
            columns[names[i]].push_back(fields[i]);
        }
    }
    if (columns.empty()) {
        throw cli::InputError(path.string() + ": has no frame; run ocellus-sim track again");
    }
    return columns;
}

void read_sweeps(ReportData &data) {
    for (const char *const name : kSweepNames) {
        const fs::path path = fs::path(data.folder) / name / "summary.json";
        if (fs::exists(path)) {
            data.sweeps.emplace(name, SweepResult(path.parent_path().string(), read_json(path)));
        } else {
            data.missing.push_back(fmt::format("{0}: is missing; ocellus-sim run "
                                               "hostsim/scenarios/{1}.toml --out {2} makes it",
                                               path.string(), name, path.parent_path().string()));
        }
    }
}

void read_tracks(ReportData &data) {
    std::vector<fs::path> folders;
    for (const fs::directory_entry &entry : fs::directory_iterator(data.folder)) {
        if (entry.path().filename().string().rfind("track_", 0) == 0 &&
            fs::exists(entry.path() / "summary.json") && fs::exists(entry.path() / "frames.csv")) {
            folders.push_back(entry.path());
        }
    }
    std::sort(folders.begin(), folders.end());
    for (const fs::path &folder : folders) {
        data.tracks.push_back({folder.filename().string(), read_json(folder / "summary.json"),
                               read_columns(folder / "frames.csv"),
                               fs::exists(folder / "track.mp4")});
    }
    if (data.tracks.empty()) {
        data.missing.push_back(data.folder +
                               "/track_*/: there is none; ocellus-sim track "
                               "hostsim/scenarios/track_throw.toml --out " +
                               data.folder + "/track_throw makes one");
    }
}

std::optional<Json> read_optional(ReportData &data, const char *name, const char *maker) {
    const fs::path path = fs::path(data.folder) / name;
    if (fs::exists(path)) {
        return read_json(path);
    }
    data.missing.push_back(fmt::format("{}: is missing; {} makes it", path.string(), maker));
    return std::nullopt;
}

} // namespace

SweepResult::SweepResult(std::string folder, Json summary)
    : folder_(std::move(folder)), summary_(std::move(summary)) {
    try {
        points_ = summary_.at("points").get<std::vector<double>>();
        (void)summary_.at("scenario").get<std::string>();
        (void)summary_.at("setting").at("radius").get<double>();
        for (const std::string &method : methods()) {
            (void)method_json(method).at("all").at("trials").get<int>();
            (void)method_json(method).at("points").at(points_.size() - 1).at("at").get<double>();
        }
    } catch (const Json::exception &mistake) {
        reject(mistake.what());
    }
    if (methods().empty()) {
        reject("it has no methods");
    }
}

void SweepResult::reject(const std::string &why) const {
    throw cli::InputError(folder_ + "/summary.json: is not what ocellus-sim run writes (" + why +
                          "); run the scenario again");
}

std::string SweepResult::name() const {
    return summary_.at("scenario");
}

std::vector<std::string> SweepResult::methods() const {
    std::vector<std::string> names;
    for (const auto &[name, method] : summary_.at("methods").items()) {
        names.push_back(name);
    }
    return names;
}

bool SweepResult::has(const std::string &method) const {
    return summary_.at("methods").contains(method);
}

const Json &SweepResult::method_json(const std::string &method) const {
    static const Json kNothing{{"all", Json::object()}, {"points", Json::array()}};
    const Json &all = summary_.at("methods");
    return all.contains(method) ? all.at(method) : kNothing;
}

int SweepResult::trials_at_a_point() const {
    return static_cast<int>(at(methods().front(), 0, "trials"));
}

double SweepResult::at(const std::string &method, std::size_t point, const std::string &column,
                       const std::string &statistic) const {
    const Json &points = method_json(method).at("points");
    return point < points.size() ? statistic_of(points.at(point), column, statistic) : kNotANumber;
}

double SweepResult::all(const std::string &method, const std::string &column,
                        const std::string &statistic) const {
    return statistic_of(method_json(method).at("all"), column, statistic);
}

double SweepResult::at(const std::string &method, std::size_t point,
                       const std::string &column) const {
    const Json &points = method_json(method).at("points");
    return point < points.size() ? number_or_none(points.at(point), column) : kNotANumber;
}

double SweepResult::all(const std::string &method, const std::string &column) const {
    return number_or_none(method_json(method).at("all"), column);
}

double SweepResult::trend(const std::string &method, const std::string &which,
                          const std::string &coefficient) const {
    return statistic_of(method_json(method), which, coefficient);
}

double SweepResult::setting(const std::string &key) const {
    return number_or_none(summary_.at("setting"), key);
}

std::string TrackRun::name() const {
    return folder;
}

std::size_t TrackRun::frames() const {
    return columns.empty() ? 0 : columns.begin()->second.size();
}

double TrackRun::number(const std::string &key, std::size_t i) const {
    const auto column = columns.find(key);
    if (column == columns.end()) {
        throw cli::InputError(folder + "/frames.csv: has no column " + key +
                              "; run ocellus-sim track again");
    }
    const std::string &field = column->second[i];
    char *end = nullptr;
    const double value = field.empty() ? kNotANumber : std::strtod(field.c_str(), &end);
    if (!field.empty() && *end != '\0') {
        throw cli::InputError(fmt::format("{}/frames.csv:{}: {} is {}; expected a number", folder,
                                          i + 2, key, cli::quoted(field)));
    }
    return value;
}

double TrackRun::figure(const std::string &key) const {
    return number_or_none(summary, key);
}

double TrackRun::figure(const std::string &key, const std::string &part) const {
    return statistic_of(summary, key, part);
}

ReportData read_report_data(const std::string &folder) {
    if (!fs::is_directory(folder)) {
        throw cli::InputError(folder + ": is no folder; expected one that ocellus-sim paper --out "
                                       "has filled");
    }
    ReportData data;
    data.folder = folder;
    read_sweeps(data);
    data.thresholds = read_optional(data, kThresholdFile, "ocellus-sim paper");
    read_tracks(data);
    data.clock = read_optional(data, kClockFile, "ocellus-sim paper");
    if (data.sweeps.empty() && data.tracks.empty()) {
        throw cli::InputError(folder +
                              ": holds no results (a_cylinder/summary.json and the like); "
                              "ocellus-sim paper --out " +
                              folder + " makes them");
    }
    return data;
}

} // namespace sim
