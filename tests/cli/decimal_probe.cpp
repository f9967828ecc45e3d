// SPDX-License-Identifier: MIT
//
// Prints what the command line makes of each decimal on standard input: Q16 and
// its decimal text, `large` when it was saturated, `word` when it is no number.
#include <cstdio>
#include <iostream>
#include <string>

#include "decimal.hpp"

int main() {
    std::string text;
    while (std::getline(std::cin, text)) {
        std::int32_t value_q16 = 0;
        const cli::DecimalStatus status = cli::parse_q16(text, value_q16);
        if (status == cli::DecimalStatus::kNotANumber) {
            std::puts("word");
        } else {
            std::printf("%d %.6f%s\n", value_q16, cli::decimal_of_q16(value_q16),
                        status == cli::DecimalStatus::kTooLarge ? " large" : "");
        }
    }
    return 0;
}
