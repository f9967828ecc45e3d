// SPDX-License-Identifier: MIT
#include "image.hpp"

#include <cstring>

#include <ocellus/config.h>

#include "error.hpp"
#include "input.hpp"

namespace cli {

namespace {

struct Signature {
    const char *bytes;
    std::size_t length;
    const char *name;
};

// Formats that are often handed over by mistake, so that the message can name them.
constexpr Signature kUnread[] = {{"\xff\xd8\xff", 3, "a JPEG picture"},
                                 {"GIF8", 4, "a GIF picture"},
                                 {"BM", 2, "a BMP picture"},
                                 {"RIFF", 4, "a WebP picture or a video"},
                                 {"II*\0", 4, "a TIFF picture"},
                                 {"MM\0*", 4, "a TIFF picture"},
                                 {"P7", 2, "a PAM picture"},
                                 {"Pf", 2, "a PFM picture"},
                                 {"PF", 2, "a PFM picture"}};

bool starts_with(const std::vector<std::uint8_t> &bytes, const char *start, std::size_t length) {
    return bytes.size() >= length && std::memcmp(bytes.data(), start, length) == 0;
}

bool is_pnm(const std::vector<std::uint8_t> &bytes) {
    return bytes.size() >= 2 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '6';
}

[[noreturn]] void reject_format(const std::vector<std::uint8_t> &bytes, const std::string &name) {
    std::string found =
        "a file that starts with " +
        quoted(std::string(bytes.begin(), bytes.begin() + static_cast<long>(std::min<std::size_t>(
                                                              bytes.size(), 8))));
    for (const Signature &signature : kUnread) {
        if (starts_with(bytes, signature.bytes, signature.length)) {
            found = signature.name;
        }
    }
    throw InputError(name + ":1: found " + found +
                     "; expected a PNG, PGM or PPM picture: convert it to PNG first");
}

} // namespace

Image read_image(const std::string &path, Purpose purpose) {
    const std::string name = display_name(path);
    const std::vector<std::uint8_t> bytes = read_bytes(path);
    if (starts_with(bytes, "\x89PNG\r\n\x1a\n", 8)) {
        return decode_png(bytes, name, purpose);
    }
    if (is_pnm(bytes)) {
        return decode_pnm(bytes, name, purpose);
    }
    reject_format(bytes, name);
}

void check_image_size(const std::string &name, std::uint64_t width, std::uint64_t height) {
    const std::string size = std::to_string(width) + " x " + std::to_string(height);
    if (width == 0 || height == 0) {
        throw InputError(name + ": a picture of " + size + " pixels; expected at least one pixel");
    }
    if (width > OCEL_MAX_WIDTH || height > OCEL_MAX_HEIGHT) {
        throw InputError(name + ": a picture of " + size +
                         " pixels is too large; expected at most " +
                         std::to_string(OCEL_MAX_WIDTH) + " x " + std::to_string(OCEL_MAX_HEIGHT) +
                         ": scale it down or cut a part out");
    }
}

} // namespace cli
