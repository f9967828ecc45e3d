// SPDX-License-Identifier: MIT
#include "error.hpp"

#include <cstdio>

namespace cli {

namespace {

constexpr std::size_t kQuotedBytesMax = 40;

std::string printable(unsigned char byte) {
    if (byte >= 0x20U && byte < 0x7fU) {
        return std::string(1, static_cast<char>(byte));
    }
    char escaped[8];
    std::snprintf(escaped, sizeof escaped, "\\x%02x", static_cast<unsigned>(byte));
    return escaped;
}

} // namespace

void note(const std::string &text) {
    std::fprintf(stderr, "ocellus: note: %s\n", text.c_str());
}

std::string quoted(const std::string &text) {
    std::string out = "'";
    for (std::size_t i = 0; i < text.size() && i < kQuotedBytesMax; ++i) {
        out += printable(static_cast<unsigned char>(text[i]));
    }
    out += text.size() > kQuotedBytesMax ? "...'" : "'";
    return out;
}

} // namespace cli
