// SPDX-License-Identifier: MIT
#include "csv.hpp"

#include <cctype>
#include <cstdint>

#include "decimal.hpp"
#include "error.hpp"
#include "input.hpp"

namespace cli {

namespace {

constexpr std::int32_t kMaxCoordinateQ16 = std::int32_t{OCEL_MAX_COORDINATE_PX} * 65536;

// A part of a line and where it starts, counted from 1.
struct Field {
    std::string text;
    std::size_t column = 1;
};

struct Place {
    std::string file;
    std::size_t line = 0;

    std::string at(std::size_t column) const {
        return file + ":" + std::to_string(line) + ":" + std::to_string(column) + ": ";
    }
};

bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\r';
}

Field trimmed(const std::string &text, std::size_t column) {
    std::size_t first = 0;
    std::size_t last = text.size();
    while (first < last && is_space(text[first])) {
        ++first;
    }
    while (last > first && is_space(text[last - 1])) {
        --last;
    }
    return {text.substr(first, last - first), column + first};
}

std::vector<Field> split(const std::string &line) {
    std::vector<Field> fields;
    std::size_t first = 0;
    while (true) {
        const std::size_t comma = line.find(',', first);
        fields.push_back(trimmed(line.substr(first, comma - first), first + 1));
        if (comma == std::string::npos) {
            return fields;
        }
        first = comma + 1;
    }
}

bool is_named(const Field &field, char name) {
    return field.text.size() == 1 &&
           std::tolower(static_cast<unsigned char>(field.text[0])) == name;
}

bool is_header(const std::vector<Field> &fields) {
    return fields.size() == 2 && is_named(fields[0], 'x') && is_named(fields[1], 'y');
}

// The note is written once: a file in other units would fill the screen.
std::int32_t parse_coordinate(const Field &field, const char *axis, const Place &place,
                              bool &noted) {
    std::int32_t value_q16 = 0;
    const DecimalStatus status = parse_q16(field.text, value_q16);
    if (status == DecimalStatus::kNotANumber) {
        throw InputError(place.at(field.column) + "found " +
                         (field.text.empty() ? "nothing" : quoted(field.text)) + " where " + axis +
                         " should be; expected a decimal number of pixels such as 12.5: correct "
                         "the line, or start it with # to skip it");
    }
    if (!noted && (value_q16 > kMaxCoordinateQ16 || value_q16 < -kMaxCoordinateQ16)) {
        note(place.at(field.column) + axis + " = " + field.text +
             " is out of range; expected a value within +-" +
             std::to_string(OCEL_MAX_COORDINATE_PX) + " px: shift or scale the points");
        noted = true;
    }
    return value_q16;
}

ocel_point_t parse_point(const std::vector<Field> &fields, const Place &place, bool &noted) {
    if (fields.size() != 2) {
        const Field &where = fields.size() > 2 ? fields[2] : fields[0];
        throw InputError(
            place.at(where.column) + "found " + std::to_string(fields.size()) +
            (fields.size() == 1 ? " value in " + quoted(where.text) : std::string(" values")) +
            "; expected two, x,y: one point a line, in pixels, with a comma between");
    }
    return {parse_coordinate(fields[0], "x", place, noted),
            parse_coordinate(fields[1], "y", place, noted)};
}

std::string without_byte_order_mark(const std::string &text) {
    return text.compare(0, 3, "\xef\xbb\xbf") == 0 ? text.substr(3) : text;
}

} // namespace

std::vector<ocel_point_t> read_points(const std::string &path) {
    const std::vector<std::uint8_t> bytes = read_bytes(path);
    const std::string text = without_byte_order_mark(std::string(bytes.begin(), bytes.end()));
    Place place{display_name(path), 0};
    std::vector<ocel_point_t> points;
    points.reserve(1); // the library takes no null pointer, even for no points
    bool header_allowed = true;
    bool noted = false;
    for (std::size_t first = 0; first < text.size();) {
        const std::size_t end = std::min(text.find('\n', first), text.size());
        const std::string line = text.substr(first, end - first);
        first = end + 1;
        ++place.line;
        const Field content = trimmed(line, 1);
        if (content.text.empty() || content.text[0] == '#') {
            continue;
        }
        const std::vector<Field> fields = split(line);
        if (!(header_allowed && is_header(fields))) {
            points.push_back(parse_point(fields, place, noted));
        }
        header_allowed = false;
    }
    return points;
}

} // namespace cli
