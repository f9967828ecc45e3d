// SPDX-License-Identifier: MIT
//
// What goes wrong with a user's input.  The text of an error stands alone: it
// names the file and the place, what was found, what was expected and the fix.
#ifndef OCELLUS_COMMON_ERROR_HPP
#define OCELLUS_COMMON_ERROR_HPP

#include <stdexcept>
#include <string>

namespace cli {

// Exit codes, part of the command line's contract.
enum ExitCode : int {
    kExitOk = 0,     // status ok
    kExitAnswer = 1, // a well-formed answer with another status
    kExitInput = 2   // usage or unreadable input
};

// Usage or unreadable input: ends the program with kExitInput.
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// A line on stderr that does not stop the program.
void note(const std::string &text);

// `text` in quotes for a message: at most 40 bytes, unprintable ones escaped.
std::string quoted(const std::string &text);

} // namespace cli

#endif
