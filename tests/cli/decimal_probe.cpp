// SPDX-License-Identifier: MIT
//
// Prints what the command line makes of each decimal on standard input: Q16 and
// its decimal text, `large` when it was saturated, `word` when it is no number.
//
//   decimal_probe length
//
// prints the units of each length, the logarithm of the unit, and 1000 times the
// length as it is printed.
#include <cstdio>
#include <iostream>
#include <string>

#include "decimal.hpp"

namespace {

void probe_q16(const std::string &text) {
    std::int32_t value_q16 = 0;
    const cli::DecimalStatus status = cli::parse_q16(text, value_q16);
    if (status == cli::DecimalStatus::kNotANumber) {
        std::puts("word");
    } else {
        std::printf("%d %.6f%s\n", value_q16, cli::decimal_of_q16(value_q16),
                    status == cli::DecimalStatus::kTooLarge ? " large" : "");
    }
}

void probe_length(const std::string &text) {
    cli::Length length;
    switch (cli::parse_length(text, length)) {
    case cli::DecimalStatus::kNotANumber:
        std::puts("word");
        break;
    case cli::DecimalStatus::kTooLarge:
        std::puts("large");
        break;
    case cli::DecimalStatus::kOk:
    default:
        std::printf("%d %d %.17g\n", length.count, length.unit_log2,
                    cli::decimal_of_length(std::int64_t{1000} * length.count, length.unit_log2));
        break;
    }
}

} // namespace

int main(int argc, char **argv) {
    const bool length = argc > 1 && std::string(argv[1]) == "length";
    std::string text;
    while (std::getline(std::cin, text)) {
        if (length) {
            probe_length(text);
        } else {
            probe_q16(text);
        }
    }
    return 0;
}
