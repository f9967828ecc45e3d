// SPDX-License-Identifier: MIT
//
// A range of colours as text: `hsv:340-20,90-255,60-255`.
#ifndef OCELLUS_COMMON_COLOUR_SPEC_HPP
#define OCELLUS_COMMON_COLOUR_SPEC_HPP

#include <string>

#include <ocellus/colour.h>

namespace cli {

// The grammar, for --help and messages.
extern const char *const kColourGrammar;

// InputError with the grammar when `spec` does not follow it.
ocel_colour_range_t parse_colour(const std::string &spec);

// The spec that parse_colour reads back to `range`.
std::string format_colour(const ocel_colour_range_t &range);

// `rgb`, `hsv`, `yuv` or `gray`; InputError for any other name.
ocel_space_t parse_space(const std::string &name);

// A rectangle `x,y,w,h` of whole pixels, for --teach.
ocel_rect_t parse_rectangle(const std::string &text);

} // namespace cli

#endif
