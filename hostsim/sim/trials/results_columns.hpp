// SPDX-License-Identifier: MIT
//
// The columns of trials.csv: the one list that its header, its writer and its
// reader go by.
#ifndef OCELLUS_SIM_RESULTS_COLUMNS_HPP
#define OCELLUS_SIM_RESULTS_COLUMNS_HPP

#include <string>

#include "trials/trial_record.hpp"

namespace sim {

// A line of the file.
struct CsvRow {
    std::string scenario;
    std::uint64_t seed = 0;
    double true_radius = 0.0;
    TrialRecord trial{};
    MethodRecord method{};
};

// A whole number whose field is empty where it is 0.
struct OrEmpty {
    int &value;
};

// Calls column(name, member) for each column in order.  The first are what other
// people's scripts rely on; ours follow.
template <class Column> void visit_columns(CsvRow &row, Column &&column) {
    TrialRecord &trial = row.trial;
    MethodRecord &method = row.method;
    column("scenario", row.scenario);
    column("point", trial.point);
    column("trial", trial.trial);
    column("seed", row.seed);
    column("method", method.method);
    column("distance", trial.distance);
    column("occlusion", trial.occlusion);
    column("status", method.status);
    column("true_x", trial.p_true[0]);
    column("true_y", trial.p_true[1]);
    column("true_z", trial.p_true[2]);
    column("est_x", method.p_world[0]);
    column("est_y", method.p_world[1]);
    column("est_z", method.p_world[2]);
    column("err", method.error);
    column("true_radius", row.true_radius);
    column("est_radius", method.radius);
    column("radius_err_pct", method.radius_error_pct);
    column("success", method.success);
    column("err_encoder", method.error_encoder);
    column("err_residual", method.error_residual);
    column("err_debiased", method.error_debiased);
    column("radius_true_depth", method.radius_true_depth);
    column("radius_true_depth_err_pct", method.radius_true_depth_error_pct);
    column("centre_err_px", method.centre_error_px);
    column("votes", OrEmpty{method.votes});
    column("frames", trial.frames);
    for (int kind = 0; kind < kCountKinds; ++kind) {
        column(count_name(kind), trial.checks.largest[static_cast<std::size_t>(kind)]);
    }
    column("violations", trial.checks.violations);
}

} // namespace sim

#endif
