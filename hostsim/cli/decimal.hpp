// SPDX-License-Identifier: MIT
//
// Decimal text and Q16 numbers, converted by integer arithmetic only.
#ifndef OCELLUS_CLI_DECIMAL_HPP
#define OCELLUS_CLI_DECIMAL_HPP

#include <cstdint>
#include <string>

namespace cli {

enum class DecimalStatus {
    kOk,
    kNotANumber,
    kTooLarge // a number that int32 Q16 cannot hold; the value is saturated
};

// Parses `[+-]digits[.digits][e[+-]digits]` to Q16, rounded to nearest, ties to
// even, whatever the number of digits.
DecimalStatus parse_q16(const std::string &text, std::int32_t &value_q16);

// A Q16 number, and an angle in turns Q32, in millionths (of a degree), rounded
// to nearest.  Divided by 1e6 the shortest text that reads back is the decimal.
double decimal_of_q16(std::int64_t value_q16);
double degrees_of_turn_q32(std::uint32_t angle_turn_q32);

} // namespace cli

#endif
