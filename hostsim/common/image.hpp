// SPDX-License-Identifier: MIT
//
// A picture in memory, and reading and writing one.
#ifndef OCELLUS_COMMON_IMAGE_HPP
#define OCELLUS_COMMON_IMAGE_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace cli {

// Rows top to bottom without padding; 1 channel is grey, 3 are R, G, B.
struct Image {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t channels = 1;
    std::vector<std::uint8_t> pixels;

    std::size_t row_bytes() const {
        return std::size_t{width} * channels;
    }
    const std::uint8_t *row(std::size_t y) const {
        return pixels.data() + y * row_bytes();
    }
    std::uint8_t *row(std::size_t y) {
        return pixels.data() + y * row_bytes();
    }
};

// What the samples mean: brightness scaled to 0..255, or a mask, in which each
// sample becomes 255 when it is not zero (no small 16-bit value is lost).
enum class Purpose { kPicture, kMask };

// One sample of 0..`maximum` as a byte for that purpose.
inline std::uint8_t byte_of_sample(std::uint32_t sample, std::uint32_t maximum, Purpose purpose) {
    if (purpose == Purpose::kMask) {
        return sample != 0U ? 255U : 0U;
    }
    return static_cast<std::uint8_t>((sample * 255U + maximum / 2U) / maximum);
}

// Reads PNG, PBM, PGM or PPM from `path` (`-`: standard input).  Palettes are
// expanded, 16 bits reduced to 8, alpha dropped with a note.  InputError for
// anything else, damage, or a side over the library's limit.
Image read_image(const std::string &path, Purpose purpose);

// InputError when a side is 0 or over the library's limit.
void check_image_size(const std::string &name, std::uint64_t width, std::uint64_t height);

// Writes an 8-bit PNG.  InputError when it cannot be written.
void write_png(const std::string &path, const Image &image);

// The readers of one format each: `bytes` is the whole file, `name` is for
// messages.
Image decode_png(const std::vector<std::uint8_t> &bytes, const std::string &name, Purpose purpose);
Image decode_pnm(const std::vector<std::uint8_t> &bytes, const std::string &name, Purpose purpose);

} // namespace cli

#endif
