// SPDX-License-Identifier: MIT
//
// PNG through libpng.  Colours are taken as they are stored: no gamma, no
// profile, as other vision programs read them.
#include <algorithm>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <png.h>

#include "error.hpp"
#include "image.hpp"

namespace cli {

namespace {

// Everything a decoder needs, in one place that longjmp leaves alone.
struct Decoder {
    const std::vector<std::uint8_t> &bytes;
    std::size_t position = 0;
    char message[128] = "";
    png_structp png = nullptr;
    png_infop info = nullptr;
    png_uint_32 width = 0;
    png_uint_32 height = 0;
    int depth = 0;
    int colour_type = 0;
    bool has_alpha = false;            // a channel, or transparent palette entries
    std::vector<std::uint8_t> samples; // rows as libpng delivers them
    std::vector<png_bytep> rows;

    explicit Decoder(const std::vector<std::uint8_t> &file) : bytes(file) {
    }
    Decoder(const Decoder &) = delete;
    Decoder &operator=(const Decoder &) = delete;
    ~Decoder() {
        png_destroy_read_struct(&png, &info, nullptr);
    }
};

void on_error(png_structp png, png_const_charp message) {
    auto *const decoder = static_cast<Decoder *>(png_get_error_ptr(png));
    std::snprintf(decoder->message, sizeof decoder->message, "%s", message);
    png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {
}

void read_from_memory(png_structp png, png_bytep target, std::size_t length) {
    auto *const decoder = static_cast<Decoder *>(png_get_io_ptr(png));
    if (decoder->bytes.size() - decoder->position < length) {
        png_error(png, "the file ends too early");
    }
    std::memcpy(target, decoder->bytes.data() + decoder->position, length);
    decoder->position += length;
}

// The two steps below hold no object with a destructor across setjmp.
bool read_header(Decoder &decoder) {
    if (setjmp(png_jmpbuf(decoder.png)) != 0) {
        return false;
    }
    png_set_read_fn(decoder.png, &decoder, read_from_memory);
    png_read_info(decoder.png, decoder.info);
    decoder.width = png_get_image_width(decoder.png, decoder.info);
    decoder.height = png_get_image_height(decoder.png, decoder.info);
    decoder.depth = png_get_bit_depth(decoder.png, decoder.info);
    decoder.colour_type = png_get_color_type(decoder.png, decoder.info);
    decoder.has_alpha = (decoder.colour_type & PNG_COLOR_MASK_ALPHA) != 0 ||
                        png_get_valid(decoder.png, decoder.info, PNG_INFO_tRNS) != 0;
    return true;
}

bool read_pixels(Decoder &decoder) {
    if (setjmp(png_jmpbuf(decoder.png)) != 0) {
        return false;
    }
    png_read_image(decoder.png, decoder.rows.data());
    png_read_end(decoder.png, nullptr);
    return true;
}

bool prepare(Decoder &decoder) {
    if (setjmp(png_jmpbuf(decoder.png)) != 0) {
        return false;
    }
    png_set_palette_to_rgb(decoder.png);
    if (decoder.colour_type == PNG_COLOR_TYPE_GRAY && decoder.depth < 8) {
        png_set_expand_gray_1_2_4_to_8(decoder.png);
    }
    png_set_strip_alpha(decoder.png);
    (void)png_set_interlace_handling(decoder.png);
    png_read_update_info(decoder.png, decoder.info);
    return true;
}

[[noreturn]] void reject(const Decoder &decoder, const std::string &name) {
    throw InputError(name + ": a damaged or truncated PNG: " + decoder.message + " (after " +
                     std::to_string(decoder.position) + " of " +
                     std::to_string(decoder.bytes.size()) +
                     " bytes); expected a whole PNG picture: copy or write it again");
}

Image image_of(const Decoder &decoder, Purpose purpose) {
    Image image;
    image.width = decoder.width;
    image.height = decoder.height;
    image.channels = (decoder.colour_type & PNG_COLOR_MASK_COLOR) != 0 ? 3 : 1;
    const std::size_t count = image.row_bytes() * image.height;
    image.pixels.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t sample =
            decoder.depth == 16
                ? (std::uint32_t{decoder.samples[2 * i]} << 8) | decoder.samples[2 * i + 1]
                : decoder.samples[i];
        image.pixels[i] = byte_of_sample(sample, decoder.depth == 16 ? 65535U : 255U, purpose);
    }
    return image;
}

} // namespace

Image decode_png(const std::vector<std::uint8_t> &bytes, const std::string &name, Purpose purpose) {
    Decoder decoder(bytes);
    decoder.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &decoder, on_error, on_warning);
    decoder.info = decoder.png != nullptr ? png_create_info_struct(decoder.png) : nullptr;
    if (decoder.info == nullptr) {
        throw InputError(name + ": libpng could not start: out of memory");
    }
    if (!read_header(decoder)) {
        reject(decoder, name);
    }
    check_image_size(name, decoder.width, decoder.height);
    if (decoder.has_alpha) {
        note(name + ": transparency is dropped, colours are taken as if opaque");
    }
    if (!prepare(decoder)) {
        reject(decoder, name);
    }
    const std::size_t row_bytes = png_get_rowbytes(decoder.png, decoder.info);
    decoder.samples.resize(row_bytes * decoder.height);
    for (std::size_t y = 0; y < decoder.height; ++y) {
        decoder.rows.push_back(decoder.samples.data() + y * row_bytes);
    }
    if (!read_pixels(decoder)) {
        reject(decoder, name);
    }
    return image_of(decoder, purpose);
}

void write_png(const std::string &path, const Image &image) {
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    header.width = image.width;
    header.height = image.height;
    header.format = image.channels == 3 ? PNG_FORMAT_RGB : PNG_FORMAT_GRAY;
    if (png_image_write_to_file(&header, path.c_str(), 0, image.pixels.data(), 0, nullptr) == 0) {
        throw InputError(path + ": cannot be written: " + header.message +
                         "; expected a file name in a folder that exists and is writable");
    }
}

} // namespace cli
