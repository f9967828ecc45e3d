// SPDX-License-Identifier: MIT
#include "trials/trial_occluder.hpp"

#include <cmath>

namespace sim {

namespace {

// How near the occlusion comes to what is wanted, and in how many drawings.
constexpr double kTolerance = 0.0005;
constexpr int kTries = 16;

// The two reaches between which the wanted one lies, and what each hides in
// excess of it.
class Bracket {
  public:
    Bracket(double wanted, double limit)
        : low_(-limit), high_(limit), below_(-wanted), above_(1.0 - wanted) {
    }

    double next() const {
        return low_ - below_ * (high_ - low_) / (above_ - below_);
    }

    // The Illinois rule: an end that stays for a second time counts half.
    void narrow(double reach, double excess) {
        if (excess < 0.0) {
            low_ = reach;
            below_ = excess;
            above_ /= last_ == -1 ? 2.0 : 1.0;
            last_ = -1;
        } else {
            high_ = reach;
            above_ = excess;
            below_ /= last_ == 1 ? 2.0 : 1.0;
            last_ = 1;
        }
    }

  private:
    double low_;
    double high_;
    double below_;
    double above_;
    int last_ = 0; // which end moved last
};

} // namespace

double search_occlusion(double wanted, double limit, const HiddenShare &hidden_at) {
    Bracket bracket(wanted, limit);
    double excess = -wanted;
    for (int i = 0; i < kTries && std::fabs(excess) > kTolerance; ++i) {
        const double reach = bracket.next();
        excess = hidden_at(reach) - wanted;
        bracket.narrow(reach, excess);
    }
    return wanted + excess;
}

} // namespace sim
