// SPDX-License-Identifier: MIT
#ifndef OCELLUS_SIM_TEMPORARY_FILE_HPP
#define OCELLUS_SIM_TEMPORARY_FILE_HPP

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <unistd.h>

namespace sim {

// A file with that text, for as long as this lives.
class TemporaryFile {
  public:
    explicit TemporaryFile(const std::string &text)
        : path_((std::filesystem::temp_directory_path() / "ocellus-XXXXXX").string()) {
        const int file = ::mkstemp(path_.data());
        const bool written = file >= 0 && ::write(file, text.data(), text.size()) ==
                                              static_cast<ssize_t>(text.size());
        if (file >= 0) {
            ::close(file);
        }
        if (!written) {
            throw std::runtime_error(path_ + ": cannot be written; is there room in it?");
        }
    }
    ~TemporaryFile() {
        (void)std::remove(path_.c_str());
    }
    TemporaryFile(const TemporaryFile &) = delete;
    TemporaryFile &operator=(const TemporaryFile &) = delete;

    const std::string &path() const {
        return path_;
    }

  private:
    std::string path_;
};

} // namespace sim

#endif
