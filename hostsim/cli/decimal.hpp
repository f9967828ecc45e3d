// SPDX-License-Identifier: MIT
//
// Decimal text and fixed-point numbers; text is converted by integer arithmetic
// only.
#ifndef OCELLUS_CLI_DECIMAL_HPP
#define OCELLUS_CLI_DECIMAL_HPP

#include <cstdint>
#include <string>

namespace cli {

enum class DecimalStatus {
    kOk,
    kNotANumber,
    kTooLarge // a number out of range; a fixed-point value is saturated
};

// A length: count units of 2^unit_log2 of the user's unit, count within 2^19 .. 2^20.
struct Length {
    std::int32_t count = 0;
    int unit_log2 = 0;
};

// Parses `[+-]digits[.digits][e[+-]digits]` to Q16, rounded to nearest, ties to
// even, whatever the number of digits.
DecimalStatus parse_q16(const std::string &text, std::int32_t &value_q16);

// The same with 1 to 30 fraction bits.
DecimalStatus parse_fixed(const std::string &text, unsigned fraction_bits, std::int32_t &value);

// A positive length of 10^-9 to 10^9, to nearest; kTooLarge beyond, and for 0 and
// less.
DecimalStatus parse_length(const std::string &text, Length &length);

// `count` units of 2^unit_log2 in the user's unit, to as many decimals as that has.
double decimal_of_length(std::int64_t count, int unit_log2);

// A Q16 number, and an angle in turns Q32, in millionths (of a degree), rounded
// to nearest.  Divided by 1e6 the shortest text that reads back is the decimal.
double decimal_of_q16(std::int64_t value_q16);
double degrees_of_turn_q32(std::uint32_t angle_turn_q32);

} // namespace cli

#endif
