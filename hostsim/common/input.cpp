// SPDX-License-Identifier: MIT
#include "input.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <sys/stat.h>

#include "error.hpp"

namespace cli {

namespace {

// The largest sensible input, a 4096 x 4096 plain-text PPM, is about 200 MB.
constexpr std::size_t kInputBytesMax = std::size_t{256} << 20;
constexpr std::size_t kChunkBytes = std::size_t{1} << 16;

struct FileCloser {
    void operator()(std::FILE *file) const {
        if (file != stdin) {
            std::fclose(file);
        }
    }
};
using File = std::unique_ptr<std::FILE, FileCloser>;

File open_file(const std::string &path) {
    if (path == "-") {
        return File(stdin);
    }
    struct stat info;
    if (stat(path.c_str(), &info) == 0 && S_ISDIR(info.st_mode)) {
        throw InputError(path + ": is a directory; expected a file: name one inside it");
    }
    File file(std::fopen(path.c_str(), "rb"));
    if (!file) {
        throw InputError(path + ": cannot be opened: " + std::strerror(errno) +
                         "; expected a readable file: check the name and its permissions");
    }
    return file;
}

} // namespace

std::string display_name(const std::string &path) {
    return path == "-" ? "<stdin>" : path;
}

std::vector<std::uint8_t> read_bytes(const std::string &path) {
    const File file = open_file(path);
    std::vector<std::uint8_t> bytes;
    std::uint8_t chunk[kChunkBytes];
    std::size_t got = 0;
    while ((got = std::fread(chunk, 1, sizeof chunk, file.get())) > 0) {
        bytes.insert(bytes.end(), chunk, chunk + got);
        if (bytes.size() > kInputBytesMax) {
            throw InputError(display_name(path) + ": larger than 256 MiB; expected one picture of "
                                                  "at most 4096 x 4096 or one list of points");
        }
    }
    if (std::ferror(file.get()) != 0) {
        throw InputError(display_name(path) + ": cannot be read: " + std::strerror(errno));
    }
    if (bytes.empty()) {
        throw InputError(display_name(path) + ": is empty; expected " +
                         (path == "-" ? "the data on standard input" : "a file with data in it"));
    }
    return bytes;
}

} // namespace cli
