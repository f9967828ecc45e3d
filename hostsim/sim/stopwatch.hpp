// SPDX-License-Identifier: MIT
#ifndef OCELLUS_SIM_STOPWATCH_HPP
#define OCELLUS_SIM_STOPWATCH_HPP

#include <ctime>

namespace sim {

// Adds the seconds of the processor, from its making to its end: what other programs
// take of the machine meanwhile does not count.
class Stopwatch {
  public:
    explicit Stopwatch(double &seconds) : seconds_(seconds) {
    }
    ~Stopwatch() {
        seconds_ += static_cast<double>(std::clock() - begin_) / CLOCKS_PER_SEC;
    }
    Stopwatch(const Stopwatch &) = delete;
    Stopwatch &operator=(const Stopwatch &) = delete;

  private:
    double &seconds_;
    std::clock_t begin_ = std::clock();
};

} // namespace sim

#endif
