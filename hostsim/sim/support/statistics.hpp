// SPDX-License-Identifier: MIT
#ifndef OCELLUS_SIM_STATISTICS_HPP
#define OCELLUS_SIM_STATISTICS_HPP

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string>

namespace sim {

// Of the values that exist: those that are numbers.
struct Statistics {
    int count = 0;
    double sum = 0.0;
    double sum_sq = 0.0;
    double largest = 0.0; // of the magnitudes

    void add(double value) {
        if (!std::isnan(value)) {
            ++count;
            sum += value;
            sum_sq += value * value;
            largest = std::max(largest, std::fabs(value));
        }
    }
    double mean() const {
        return sum / count;
    }
    double rms() const {
        return std::sqrt(sum_sq / count);
    }
    double deviation() const {
        const double excess = sum_sq - sum * sum / count;
        return count > 1 ? std::sqrt(std::max(excess, 0.0) / (count - 1)) : 0.0;
    }
};

// A float's worth of digits; the rest is noise in a summary.
inline double rounded(double value) {
    return value == 0.0 ? 0.0 : std::stod(fmt::format("{:.6g}", value));
}

// A field of a CSV file, after its comma; empty when it is not a number.  Ten digits:
// more than any method is good for, few enough for the reader.
inline std::string field(double value) {
    return std::isnan(value) ? "," : fmt::format(",{:.10g}", value);
}

} // namespace sim

#endif
