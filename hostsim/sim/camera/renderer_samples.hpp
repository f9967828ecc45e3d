// SPDX-License-Identifier: MIT
//
// From samples to pixels.  `supersampling` 1 takes one sample in each pixel's
// middle: the hard edges of the iCub simulator.  2 and 4 average a pixel's area by
// the trapezoid rule, on a grid of samples that has the pixels' corners: so it has
// their middles as well, and a pixel that an edge halves is not always taken for
// one side, which would make every ball .1 px larger.
#ifndef OCELLUS_SIM_RENDERER_SAMPLES_HPP
#define OCELLUS_SIM_RENDERER_SAMPLES_HPP

#include <cstdint>
#include <vector>

#include "camera/intrinsics.hpp"
#include "image.hpp"

namespace sim {

// R, G, B and A of the samples as OpenGL gives them: the bottom row first.
using Samples = std::vector<std::uint8_t>;

// The grid of samples as a camera: its nodes 0, k, 2k ... are the pixels' edges.
Intrinsics sample_grid(const Intrinsics &camera, int k);

// The mean of one or more drawings of a picture.
class SampleSum {
  public:
    SampleSum(const Intrinsics &camera, int supersampling);

    void clear();
    void add(const Samples &samples);

    // R, G, B to the nearest level, the top row first.
    cli::Image picture() const;

    // Of the target in the mean, px.
    double target_area() const {
        return target_area_ / drawings_;
    }
    // Of the samples whose A says that they are the target's, px; counted before
    // averaging, so in steps of 1 / supersampling^2.
    double target_area_of(const Samples &samples) const;

  private:
    void add_row(const std::uint8_t *samples, unsigned row_weight, unsigned *sums) const;

    std::size_t width_;
    std::size_t height_;
    std::size_t k_;
    std::vector<unsigned> sums_; // R, G, B
    unsigned drawings_ = 0;
    double target_area_ = 0.0; // in all of them
};

} // namespace sim

#endif
