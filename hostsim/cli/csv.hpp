// SPDX-License-Identifier: MIT
//
// Points as text: `x,y` a line, in pixels.
#ifndef OCELLUS_CLI_CSV_HPP
#define OCELLUS_CLI_CSV_HPP

#include <string>
#include <vector>

#include <ocellus/types.h>

namespace cli {

// Reads points from `path` (`-`: standard input).  Blank lines, lines that
// start with `#` and one header line `x,y` are skipped; both line ends are
// read.  A number too large for the library is saturated, so that the library
// answers out_of_range, and a note names its place.  InputError for all else.
std::vector<ocel_point_t> read_points(const std::string &path);

} // namespace cli

#endif
