// SPDX-License-Identifier: MIT
//
// PBM, PGM and PPM (P1 .. P6), plain and binary, comments allowed.
#include <algorithm>

#include "error.hpp"
#include "image.hpp"

namespace cli {

namespace {

// Walks through a file and knows the line it is on.
class Reader {
  public:
    Reader(const std::vector<std::uint8_t> &bytes, std::string name)
        : bytes_(bytes), name_(std::move(name)) {
    }

    [[noreturn]] void fail(const std::string &text) const {
        throw InputError(name_ + ":" + std::to_string(line_) + ": " + text);
    }

    bool at_end() const {
        return position_ >= bytes_.size();
    }
    std::size_t left() const {
        return bytes_.size() - position_;
    }
    const std::uint8_t *here() const {
        return bytes_.data() + position_;
    }
    void advance(std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            line_ += bytes_[position_ + i] == '\n' ? 1U : 0U;
        }
        position_ += count;
    }

    // White space, and comments to the end of the line.
    void skip_space() {
        while (!at_end() && (is_space(*here()) || *here() == '#')) {
            const bool comment = *here() == '#';
            while (comment && !at_end() && *here() != '\n') {
                advance(1);
            }
            advance(at_end() ? 0 : 1);
        }
    }

    // The next word up to white space; empty at the end.
    std::string next_word() {
        skip_space();
        std::string word;
        while (!at_end() && !is_space(*here()) && *here() != '#') {
            word += static_cast<char>(*here());
            advance(1);
        }
        return word;
    }

    // A whole number of at most six digits.
    std::uint32_t next_number(const char *what) {
        const std::string word = next_word();
        if (word.empty()) {
            fail(std::string("the file ends where ") + what + " should be: it is truncated");
        }
        if (word.size() > 6 || word.find_first_not_of("0123456789") != std::string::npos) {
            fail("found " + quoted(word) + " where " + what +
                 " should be; expected a whole number");
        }
        return static_cast<std::uint32_t>(std::stoul(word));
    }

    // One digit of a plain PBM, which needs no space between two.
    std::uint32_t next_bit() {
        skip_space();
        if (at_end()) {
            fail("the file ends where a pixel should be: it is truncated");
        }
        const std::uint8_t digit = *here();
        if (digit != '0' && digit != '1') {
            fail("found " + quoted(std::string(1, static_cast<char>(digit))) +
                 " where a pixel should be; expected 0 or 1");
        }
        advance(1);
        return digit - static_cast<std::uint32_t>('0');
    }

  private:
    static bool is_space(std::uint8_t c) {
        return c == ' ' || (c >= '\t' && c <= '\r');
    }

    const std::vector<std::uint8_t> &bytes_;
    std::string name_;
    std::size_t position_ = 0;
    std::size_t line_ = 1;
};

struct Header {
    int kind = 0; // the digit after P
    std::uint32_t maximum = 1;

    bool is_bitmap() const {
        return kind == 1 || kind == 4;
    }
    bool is_plain() const {
        return kind <= 3;
    }
    std::size_t sample_bytes() const {
        return maximum > 255U ? 2U : 1U;
    }
};

// In a bitmap 1 is ink: dark in a picture, an object in a mask.
std::uint8_t byte_of_bit(std::uint32_t bit, Purpose purpose) {
    return (bit != 0U) == (purpose == Purpose::kMask) ? 255U : 0U;
}

Header read_header(Reader &reader, const std::string &name, Image &image) {
    Header header;
    header.kind = reader.here()[1] - '0';
    reader.advance(2);
    image.width = reader.next_number("the width");
    image.height = reader.next_number("the height");
    check_image_size(name, image.width, image.height);
    if (!header.is_bitmap()) {
        header.maximum = reader.next_number("the largest sample value");
    }
    if (header.maximum == 0U || header.maximum > 65535U) {
        reader.fail("found " + std::to_string(header.maximum) +
                    " as the largest sample value; expected 1..65535 (usually 255)");
    }
    image.channels = (header.kind == 3 || header.kind == 6) ? 3U : 1U;
    image.pixels.resize(image.row_bytes() * image.height);
    return header;
}

std::uint8_t checked_byte(const Reader &reader, std::uint32_t sample, const Header &header,
                          Purpose purpose) {
    if (sample > header.maximum) {
        reader.fail("found the sample " + std::to_string(sample) + "; expected at most " +
                    std::to_string(header.maximum) + ", as the header says");
    }
    return byte_of_sample(sample, header.maximum, purpose);
}

void read_plain(Reader &reader, const Header &header, Purpose purpose, Image &image) {
    for (std::uint8_t &pixel : image.pixels) {
        pixel = header.is_bitmap()
                    ? byte_of_bit(reader.next_bit(), purpose)
                    : checked_byte(reader, reader.next_number("a sample"), header, purpose);
    }
}

// Takes the one white space between header and pixels, and checks their size.
const std::uint8_t *start_binary(Reader &reader, std::size_t bytes) {
    reader.advance(reader.at_end() ? 0 : 1);
    if (reader.left() < bytes) {
        reader.fail("a truncated picture: found " + std::to_string(reader.left()) +
                    " bytes of pixels after the header; expected " + std::to_string(bytes) +
                    ": copy or write the file again");
    }
    return reader.here();
}

void read_bits(Reader &reader, Purpose purpose, Image &image) {
    const std::size_t row_bytes = (std::size_t{image.width} + 7U) / 8U;
    const std::uint8_t *const bits = start_binary(reader, row_bytes * image.height);
    for (std::size_t y = 0; y < image.height; ++y) {
        for (std::size_t x = 0; x < image.width; ++x) {
            const std::uint32_t byte = bits[y * row_bytes + x / 8U];
            image.row(y)[x] = byte_of_bit((byte >> (7U - x % 8U)) & 1U, purpose);
        }
    }
    reader.advance(row_bytes * image.height);
}

void read_samples(Reader &reader, const Header &header, Purpose purpose, Image &image) {
    const std::size_t size = header.sample_bytes();
    const std::size_t count = image.pixels.size();
    const std::uint8_t *const source = start_binary(reader, count * size);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t sample =
            size == 2 ? (std::uint32_t{source[2 * i]} << 8) | source[2 * i + 1] : source[i];
        image.pixels[i] = checked_byte(reader, sample, header, purpose);
    }
    reader.advance(count * size);
}

} // namespace

Image decode_pnm(const std::vector<std::uint8_t> &bytes, const std::string &name, Purpose purpose) {
    Reader reader(bytes, name);
    Image image;
    const Header header = read_header(reader, name, image);
    if (header.is_plain()) {
        read_plain(reader, header, purpose, image);
    } else if (header.is_bitmap()) {
        read_bits(reader, purpose, image);
    } else {
        read_samples(reader, header, purpose, image);
    }
    reader.skip_space();
    if (!reader.at_end()) {
        note(name + ": " + std::to_string(reader.left()) +
             " bytes after the first picture are not read");
    }
    return image;
}

} // namespace cli
