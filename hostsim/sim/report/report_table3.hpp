// SPDX-License-Identifier: MIT
//
// The two halves of Table 3, beside the paper's.
#ifndef OCELLUS_SIM_REPORT_TABLE3_HPP
#define OCELLUS_SIM_REPORT_TABLE3_HPP

#include "report/report_data.hpp"

namespace sim {

struct PublishedThreshold {
    double at;
    double atcds;
};

struct Table3 {
    const char *key;
    const char *what;
    const char *head; // of the column
    const char *axis;
    double x_scale;
    std::vector<PublishedThreshold> published;
    Json rows; // of threshold_rows
};

// By distance and by occlusion.
std::vector<Table3> tables3_of(const Json &thresholds);

// Our votes for one of the paper's, by least squares.
double scale_of(const Table3 &table3);

} // namespace sim

#endif
