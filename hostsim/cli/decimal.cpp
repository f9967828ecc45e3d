// SPDX-License-Identifier: MIT
#include "decimal.hpp"

#include <algorithm>
#include <limits>

namespace cli {

namespace {

// |value| = 0.d1 d2 d3 ... x 10^point, d1 != 0; no digits for zero.
struct Decimal {
    bool negative = false;
    std::string digits;
    long point = 0;
};

// Larger exponents are out of range, or zero, all the same.
constexpr long kExponentMax = 100000;

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

// Takes an optional sign at `at`; true for a minus.
bool take_sign(const std::string &text, std::size_t &at) {
    const bool signed_text = at < text.size() && (text[at] == '+' || text[at] == '-');
    const bool negative = signed_text && text[at] == '-';
    at += signed_text ? 1U : 0U;
    return negative;
}

// Appends the digits at `at`; returns how many.
std::size_t take_digits(const std::string &text, std::size_t &at, std::string &digits) {
    const std::size_t first = at;
    while (at < text.size() && is_digit(text[at])) {
        digits += text[at];
        ++at;
    }
    return at - first;
}

// Takes an optional exponent; false when it has no digits.
bool take_exponent(const std::string &text, std::size_t &at, long &exponent) {
    if (at >= text.size() || (text[at] != 'e' && text[at] != 'E')) {
        return true;
    }
    ++at;
    const bool negative = take_sign(text, at);
    std::string digits;
    if (take_digits(text, at, digits) == 0) {
        return false;
    }
    for (const char c : digits) {
        exponent = std::min(10 * exponent + (c - '0'), kExponentMax);
    }
    exponent = negative ? -exponent : exponent;
    return true;
}

bool parse_decimal(const std::string &text, Decimal &out) {
    std::size_t at = 0;
    out.negative = take_sign(text, at);
    std::size_t count = take_digits(text, at, out.digits);
    out.point = static_cast<long>(count);
    if (at < text.size() && text[at] == '.') {
        ++at;
        count += take_digits(text, at, out.digits);
    }
    long exponent = 0;
    if (count == 0 || !take_exponent(text, at, exponent) || at != text.size()) {
        return false;
    }
    const std::size_t zeros = std::min(out.digits.find_first_not_of('0'), out.digits.size());
    out.digits.erase(0, zeros);
    out.point += exponent - static_cast<long>(zeros);
    return true;
}

// Doubles the decimal fraction 0.d1 d2 ...; returns the carry, 0 or 1.
int double_fraction(std::string &digits) {
    int carry = 0;
    for (std::size_t i = digits.size(); i-- > 0;) {
        const int doubled = 2 * (digits[i] - '0') + carry;
        digits[i] = static_cast<char>('0' + doubled % 10);
        carry = doubled / 10;
    }
    return carry;
}

// 0.d1 d2 ... times 65536, to nearest, ties to even.
std::int64_t fraction_q16(std::string digits) {
    std::int64_t bits = 0;
    for (int i = 0; i < 16; ++i) {
        bits = 2 * bits + double_fraction(digits);
    }
    const bool half_or_more = double_fraction(digits) == 1;
    const bool exactly_half = digits.find_first_not_of('0') == std::string::npos;
    return bits + ((half_or_more && (!exactly_half || (bits & 1) == 1)) ? 1 : 0);
}

// The magnitude in Q16; -1 when it is 10^5 or more.
std::int64_t magnitude_q16(const Decimal &decimal) {
    if (decimal.digits.empty() || decimal.point < -10) {
        return 0;
    }
    if (decimal.point > 5) {
        return -1;
    }
    std::string fraction = decimal.digits;
    std::int64_t whole = 0;
    for (long i = 0; i < decimal.point; ++i) {
        whole = 10 * whole + (fraction.empty() ? 0 : fraction[0] - '0');
        fraction.erase(0, 1);
    }
    fraction.insert(0, static_cast<std::size_t>(std::max(0L, -decimal.point)), '0');
    return (whole << 16) + fraction_q16(fraction);
}

} // namespace

DecimalStatus parse_q16(const std::string &text, std::int32_t &value_q16) {
    constexpr std::int64_t kMax = std::numeric_limits<std::int32_t>::max();
    Decimal decimal;
    value_q16 = 0;
    if (!parse_decimal(text, decimal)) {
        return DecimalStatus::kNotANumber;
    }
    const std::int64_t exact = magnitude_q16(decimal);
    const bool too_large = exact < 0 || exact > kMax;
    const std::int64_t magnitude = too_large ? kMax : exact;
    value_q16 = static_cast<std::int32_t>(decimal.negative ? -magnitude : magnitude);
    return too_large ? DecimalStatus::kTooLarge : DecimalStatus::kOk;
}

double decimal_of_q16(std::int64_t value_q16) {
    const std::int64_t magnitude = value_q16 < 0 ? -value_q16 : value_q16;
    const std::int64_t micro = (magnitude * 1000000 + 32768) / 65536;
    return static_cast<double>(value_q16 < 0 ? -micro : micro) / 1e6;
}

double degrees_of_turn_q32(std::uint32_t angle_turn_q32) {
    constexpr std::uint64_t kHalfTurnMicro = 180000000U;
    const std::uint64_t scaled = std::uint64_t{angle_turn_q32} * (2U * kHalfTurnMicro);
    const std::uint64_t micro = (scaled + (std::uint64_t{1} << 31)) >> 32;
    return static_cast<double>(micro % kHalfTurnMicro) / 1e6; // 179.9999999 is 0
}

} // namespace cli
