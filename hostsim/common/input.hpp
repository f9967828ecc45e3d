// SPDX-License-Identifier: MIT
//
// Reading a file or standard input whole.
#ifndef OCELLUS_COMMON_INPUT_HPP
#define OCELLUS_COMMON_INPUT_HPP

#include <cstdint>
#include <string>
#include <vector>

namespace cli {

// A file's name as messages show it: `-` becomes `<stdin>`.
std::string display_name(const std::string &path);

// Every byte of `path`, or of standard input for `-`.  InputError when it
// cannot be read, is empty, or is larger than any input that this program takes.
std::vector<std::uint8_t> read_bytes(const std::string &path);

} // namespace cli

#endif
