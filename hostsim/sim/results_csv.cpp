// SPDX-License-Identifier: MIT
#include <filesystem>
#include <fstream>

#include "error.hpp"
#include "results.hpp"
#include "statistics.hpp"

namespace sim {

namespace {

// The first are what other people's scripts rely on; ours follow.
constexpr const char *kHeader =
    "scenario,point,trial,seed,method,distance,occlusion,status,true_x,true_y,true_z,est_x,est_y,"
    "est_z,err,true_radius,est_radius,radius_err_pct,success,err_encoder,err_residual,err_debiased,"
    "radius_true_depth,radius_true_depth_err_pct,centre_err_px,votes,frames\n";

std::string place(const double p[3]) {
    return field(p[0]) + field(p[1]) + field(p[2]);
}

std::string row(const Scenario &scenario, std::uint64_t seed, const TrialRecord &trial,
                const MethodRecord &method) {
    std::string line = fmt::format("{},{},{},{},{}", scenario.name, trial.point, trial.trial, seed,
                                   method_name(method.method));
    line += field(trial.distance) + field(trial.occlusion);
    line += fmt::format(",{}", ocel_status_name(method.status));
    line += place(trial.p_true) + place(method.p_world) + field(method.error);
    line += field(scenario.target.radius) + field(method.radius) + field(method.radius_error_pct);
    line += fmt::format(",{}", method.success ? 1 : 0);
    line +=
        field(method.error_encoder) + field(method.error_residual) + field(method.error_debiased);
    line += field(method.radius_true_depth) + field(method.radius_true_depth_error_pct) +
            field(method.centre_error_px);
    line += method.votes > 0 ? fmt::format(",{}", method.votes) : ",";
    return line + fmt::format(",{}\n", trial.frames);
}

} // namespace

std::string csv_of(const Scenario &scenario, std::uint64_t seed,
                   const std::vector<TrialRecord> &records) {
    std::string text = kHeader;
    for (const TrialRecord &trial : records) {
        for (int i = 0; i < trial.method_count; ++i) {
            text += row(scenario, seed, trial, trial.methods[i]);
        }
    }
    return text;
}

void make_folder(const std::string &path, const char *option) {
    std::error_code mistake;
    std::filesystem::create_directories(path, mistake);
    if (!std::filesystem::is_directory(path)) {
        throw cli::InputError(std::string(option) + " " + path +
                              ": cannot be made; expected a folder's name");
    }
}

void write_text(const std::string &path, const std::string &text) {
    std::ofstream file(path, std::ios::binary);
    file << text;
    file.close();
    if (!file) {
        throw cli::InputError(path + ": cannot be written; expected a folder with room in it");
    }
}

} // namespace sim
