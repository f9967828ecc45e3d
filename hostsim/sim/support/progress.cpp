// SPDX-License-Identifier: MIT
#include "support/progress.hpp"

#include <cstdio>
#include <unistd.h>

namespace sim {

namespace {

constexpr std::size_t kBarLength = 40;

} // namespace

Progress::Progress(const std::string &what, std::size_t total, const std::string &unit)
    : what_(what), total_(total), unit_(unit), terminal_(::isatty(STDERR_FILENO) == 1) {
}

void Progress::advance() {
    ++done_;
    if (terminal_) {
        draw_bar();
    } else if (done_ * 10 / total_ != (done_ - 1) * 10 / total_) {
        print_line();
    }
}

void Progress::draw_bar() const {
    const std::size_t full = done_ * kBarLength / total_;
    const std::string bar = std::string(full, '#') + std::string(kBarLength - full, '.');
    std::fprintf(stderr, "\r%s [%s] %zu/%zu%s", what_.c_str(), bar.c_str(), done_, total_,
                 done_ == total_ ? "\n" : "");
}

void Progress::print_line() const {
    std::fprintf(stderr, "%s: %zu %% (%zu of %zu %s)\n", what_.c_str(), done_ * 100 / total_, done_,
                 total_, unit_.c_str());
}

} // namespace sim
