// SPDX-License-Identifier: MIT
//
// How far a long run is, on stderr: a bar on a terminal, else a line each 10 %.
#ifndef OCELLUS_SIM_PROGRESS_HPP
#define OCELLUS_SIM_PROGRESS_HPP

#include <string>

namespace sim {

class Progress {
  public:
    // `unit`: what is counted, in the plural.
    Progress(const std::string &what, std::size_t total, const std::string &unit = "trials");
    void advance();

  private:
    void draw_bar() const;
    void print_line() const;

    std::string what_;
    std::size_t total_;
    std::string unit_;
    std::size_t done_ = 0;
    bool terminal_;
};

} // namespace sim

#endif
