// SPDX-License-Identifier: MIT
#ifndef OCELLUS_SIM_STOPWATCH_HPP
#define OCELLUS_SIM_STOPWATCH_HPP

#include <ctime>

namespace sim {

// Adds the seconds that this thread has of a core, from its making to its end: what
// other programs, and a video's encoder, take of the machine meanwhile does not count.
class Stopwatch {
  public:
    explicit Stopwatch(double &seconds) : seconds_(seconds) {
    }
    ~Stopwatch() {
        seconds_ += now() - begin_;
    }
    Stopwatch(const Stopwatch &) = delete;
    Stopwatch &operator=(const Stopwatch &) = delete;

  private:
    static double now() {
        timespec time{};
        ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    }
    double &seconds_;
    double begin_ = now();
};

} // namespace sim

#endif
