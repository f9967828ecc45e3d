// SPDX-License-Identifier: MIT
#include "decimal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cli {

namespace {

// |value| = 0.d1 d2 d3 ... x 10^point, d1 != 0; no digits for zero.
struct Decimal {
    bool negative = false;
    std::string digits;
    long point = 0;
};

// Lengths: 10^-9 to 10^9 of whatever unit, rounded to 20 bits.
constexpr long kLengthDigits = 9;
constexpr unsigned kLengthBits = 20;
__extension__ using Wide = unsigned __int128;

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

// 0.d1 d2 ... times 2^count, to nearest, ties to even.
std::int64_t fraction_of(std::string digits, unsigned count) {
    std::int64_t bits = 0;
    for (unsigned i = 0; i < count; ++i) {
        bits = 2 * bits + double_fraction(digits);
    }
    const bool half_or_more = double_fraction(digits) == 1;
    const bool exactly_half = digits.find_first_not_of('0') == std::string::npos;
    return bits + ((half_or_more && (!exactly_half || (bits & 1) == 1)) ? 1 : 0);
}

// The magnitude with `bits` fraction bits; -1 when it is 10^5 or more.
std::int64_t magnitude(const Decimal &decimal, unsigned bits) {
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
    return (whole << bits) + fraction_of(fraction, bits);
}

} // namespace

DecimalStatus parse_fixed(const std::string &text, unsigned fraction_bits, std::int32_t &value) {
    constexpr std::int64_t kMax = std::numeric_limits<std::int32_t>::max();
    Decimal decimal;
    value = 0;
    if (!parse_decimal(text, decimal)) {
        return DecimalStatus::kNotANumber;
    }
    const std::int64_t exact = magnitude(decimal, fraction_bits);
    const bool too_large = exact < 0 || exact > kMax;
    const std::int64_t size = too_large ? kMax : exact;
    value = static_cast<std::int32_t>(decimal.negative ? -size : size);
    return too_large ? DecimalStatus::kTooLarge : DecimalStatus::kOk;
}

DecimalStatus parse_q16(const std::string &text, std::int32_t &value_q16) {
    return parse_fixed(text, 16, value_q16);
}

DecimalStatus parse_length(const std::string &text, Length &length) {
    Decimal decimal;
    length = {};
    if (!parse_decimal(text, decimal)) {
        return DecimalStatus::kNotANumber;
    }
    if (decimal.negative || decimal.digits.empty() || decimal.point < -kLengthDigits + 1 ||
        decimal.point > kLengthDigits + 1) {
        return DecimalStatus::kTooLarge;
    }
    // 0.d1 .. d17 as a fraction num / 10^17, then its power of ten, 10^-9 to 10^9.
    Wide num = 0;
    Wide den = 1;
    for (std::size_t i = 0; i < 17; ++i) {
        num = 10 * num + static_cast<Wide>(i < decimal.digits.size() ? decimal.digits[i] - '0' : 0);
        den *= 10;
    }
    for (long i = 0; i < decimal.point; ++i) {
        num *= 10;
    }
    for (long i = decimal.point; i < 0; ++i) {
        den *= 10;
    }
    // num / den into [2^19, 2^20): both stay below 2^127.
    while (num < (den << (kLengthBits - 1))) {
        num *= 2;
        --length.unit_log2;
    }
    while (num >= (den << kLengthBits)) {
        den *= 2;
        ++length.unit_log2;
    }
    length.count = static_cast<std::int32_t>((2 * num + den) / (2 * den));
    return DecimalStatus::kOk;
}

double decimal_of_length(std::int64_t count, int unit_log2) {
    // A unit of 2^-k has digits down to 10^-ceil(k log10(2)).
    const int digits = unit_log2 < 0 ? static_cast<int>(std::ceil(-unit_log2 * 0.30103)) : 0;
    const double scale = std::pow(10.0, digits);
    return std::round(std::ldexp(static_cast<double>(count), unit_log2) * scale) / scale;
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
