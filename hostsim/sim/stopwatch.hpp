// SPDX-License-Identifier: MIT
#ifndef OCELLUS_SIM_STOPWATCH_HPP
#define OCELLUS_SIM_STOPWATCH_HPP

#include <chrono>

namespace sim {

// Adds the seconds from its making to its end.
class Stopwatch {
  public:
    explicit Stopwatch(double &seconds) : seconds_(seconds) {
    }
    ~Stopwatch() {
        seconds_ += std::chrono::duration<double>(Clock::now() - begin_).count();
    }
    Stopwatch(const Stopwatch &) = delete;
    Stopwatch &operator=(const Stopwatch &) = delete;

  private:
    using Clock = std::chrono::steady_clock;
    double &seconds_;
    Clock::time_point begin_ = Clock::now();
};

} // namespace sim

#endif
