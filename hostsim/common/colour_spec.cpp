// SPDX-License-Identifier: MIT
#include "colour_spec.hpp"

#include <vector>

#include "error.hpp"

namespace cli {

const char *const kColourGrammar = "rgb:r0-r1,g0-g1,b0-b1 | hsv:h0-h1,s0-s1,v0-v1 | "
                                   "yuv:y0-y1,u0-u1,v0-v1 | gray:v0-v1, whole numbers 0..255, "
                                   "h in degrees 0..360 and may wrap (hsv:340-20,90-255,60-255)";

namespace {

struct Space {
    const char *name;
    ocel_space_t space;
    std::size_t channels;
    const char *channel[3];
};

constexpr Space kSpaces[] = {{"rgb", OCEL_SPACE_RGB, 3, {"r", "g", "b"}},
                             {"hsv", OCEL_SPACE_HSV, 3, {"h", "s", "v"}},
                             {"yuv", OCEL_SPACE_YUV, 3, {"y", "u", "v"}},
                             {"gray", OCEL_SPACE_GRAY, 1, {"v", "", ""}}};

const Space &space_of(ocel_space_t space) {
    for (const Space &candidate : kSpaces) {
        if (candidate.space == space) {
            return candidate;
        }
    }
    throw InputError("an unknown colour space");
}

const Space *find_space(const std::string &name) {
    for (const Space &candidate : kSpaces) {
        if (name == candidate.name) {
            return &candidate;
        }
    }
    return nullptr;
}

[[noreturn]] void reject(const std::string &spec, const std::string &found) {
    throw InputError("--colour " + quoted(spec) + ": " + found + "; expected " + kColourGrammar);
}

std::vector<std::string> split(const std::string &text, char separator) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == separator) {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    return parts;
}

// A whole number of one to five digits; -1 for anything else.
int parse_whole(const std::string &text) {
    const bool digits_only = text.find_first_not_of("0123456789") == std::string::npos;
    return (text.empty() || text.size() > 5 || !digits_only) ? -1 : std::stoi(text);
}

std::uint16_t parse_bound(const std::string &spec, const std::string &text, const Space &space,
                          std::size_t channel) {
    const int limit = (space.space == OCEL_SPACE_HSV && channel == 0) ? 360 : 255;
    const int value = parse_whole(text);
    if (value < 0 || value > limit) {
        reject(spec, std::string("found ") + quoted(text) + " as a bound of " +
                         space.channel[channel] + ", which is a whole number 0.." +
                         std::to_string(limit));
    }
    return static_cast<std::uint16_t>(value);
}

void parse_channel(const std::string &spec, const std::string &text, const Space &space,
                   std::size_t channel, ocel_colour_range_t &range) {
    const std::vector<std::string> bounds = split(text, '-');
    if (bounds.size() != 2) {
        reject(spec, std::string("found ") + quoted(text) + " as the range of " +
                         space.channel[channel] + ", which is low-high");
    }
    range.lo[channel] = parse_bound(spec, bounds[0], space, channel);
    range.hi[channel] = parse_bound(spec, bounds[1], space, channel);
    const bool may_wrap = space.space == OCEL_SPACE_HSV && channel == 0;
    if (!may_wrap && range.lo[channel] > range.hi[channel]) {
        reject(spec, std::string("the range of ") + space.channel[channel] + " is empty: " +
                         bounds[0] + " is above " + bounds[1] + " (only hue wraps)");
    }
}

} // namespace

ocel_colour_range_t parse_colour(const std::string &spec) {
    const std::size_t colon = spec.find(':');
    const Space *const space = find_space(spec.substr(0, colon));
    if (colon == std::string::npos || space == nullptr) {
        reject(spec, "no colour space that is known before the colon");
    }
    const std::vector<std::string> channels = split(spec.substr(colon + 1), ',');
    if (channels.size() != space->channels) {
        reject(spec, "found " + std::to_string(channels.size()) + " ranges, " + space->name +
                         " has " + std::to_string(space->channels));
    }
    ocel_colour_range_t range{};
    range.space = space->space;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        parse_channel(spec, channels[i], *space, i, range);
    }
    return range;
}

std::string format_colour(const ocel_colour_range_t &range) {
    const Space &space = space_of(range.space);
    std::string spec = std::string(space.name) + ":";
    for (std::size_t i = 0; i < space.channels; ++i) {
        spec +=
            (i > 0 ? "," : "") + std::to_string(range.lo[i]) + "-" + std::to_string(range.hi[i]);
    }
    return spec;
}

ocel_space_t parse_space(const std::string &name) {
    const Space *const space = find_space(name);
    if (space == nullptr) {
        throw InputError("--teach-space " + quoted(name) + ": expected rgb, hsv, yuv or gray");
    }
    return space->space;
}

ocel_rect_t parse_rectangle(const std::string &text) {
    const std::vector<std::string> parts = split(text, ',');
    int value[4] = {-1, -1, -1, -1};
    bool valid = parts.size() == 4;
    for (std::size_t i = 0; valid && i < 4; ++i) {
        value[i] = parse_whole(parts[i]);
        valid = value[i] >= (i < 2 ? 0 : 1) && value[i] <= OCEL_MAX_WIDTH;
    }
    if (!valid) {
        throw InputError("--teach " + quoted(text) +
                         ": expected x,y,w,h: the rectangle's left and top pixel, its width and "
                         "its height, whole numbers, such as 120,80,16,16");
    }
    return {static_cast<std::uint16_t>(value[0]), static_cast<std::uint16_t>(value[1]),
            static_cast<std::uint16_t>(value[2]), static_cast<std::uint16_t>(value[3])};
}

} // namespace cli
