// SPDX-License-Identifier: MIT
//
// Seeded numbers that are the same everywhere: splitmix64 (Steele, Lea, Flood
// 2014), and normal numbers by Box and Muller.
#ifndef OCELLUS_SIM_RANDOM_HPP
#define OCELLUS_SIM_RANDOM_HPP

#include <cmath>
#include <cstdint>
#include <string>

#include "geometry/geometry.hpp"

namespace sim {

class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {
    }

    std::uint64_t bits() {
        state_ += 0x9e3779b97f4a7c15U;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
        return z ^ (z >> 31);
    }
    // [0, 1).
    double uniform() {
        return static_cast<double>(bits() >> 11) * 0x1p-53;
    }
    double uniform(double low, double high) {
        return low + (high - low) * uniform();
    }
    // Mean 0, standard deviation 1.
    double normal() {
        const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
        return radius * std::cos(2.0 * kPi * uniform());
    }

  private:
    std::uint64_t state_;
};

// A seed of its own for each thing that is drawn by chance.
inline std::uint64_t mixed_seed(std::uint64_t seed, std::uint64_t number) {
    return Random(seed ^ Random(number).bits()).bits();
}

// FNV-1a, 64 bits.
inline std::uint64_t text_seed(const std::string &text) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char c : text) {
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    }
    return hash;
}

} // namespace sim

#endif
