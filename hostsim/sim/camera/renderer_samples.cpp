// SPDX-License-Identifier: MIT
#include "camera/renderer_samples.hpp"

#include <algorithm>

namespace sim {

namespace {

// By the trapezoid rule the samples on a pixel's border count half.
constexpr unsigned weight(std::size_t sample, std::size_t k) {
    return k == 1 || sample == 0 || sample == k ? 1U : 2U;
}

// A line of samples to a line of pixels.  k is known to the compiler: this is a
// tenth of what a picture costs.
template <std::size_t k>
void add_samples(const std::uint8_t *samples, unsigned row_weight, std::size_t width,
                 unsigned *sums) {
    for (std::size_t x = 0; x < width; ++x, samples += 4 * k, sums += 3) {
        for (std::size_t sample = 0; sample <= (k == 1 ? 0 : k); ++sample) {
            const unsigned share = row_weight * weight(sample, k);
            sums[0] += share * samples[4 * sample];
            sums[1] += share * samples[4 * sample + 1];
            sums[2] += share * samples[4 * sample + 2];
        }
    }
}

} // namespace

Intrinsics sample_grid(const Intrinsics &camera, int k) {
    if (k == 1) {
        return camera;
    }
    return {camera.fx * k,
            camera.fy * k,
            (camera.cx + 0.5) * k,
            (camera.cy + 0.5) * k,
            camera.width * k + 1,
            camera.height * k + 1,
            camera.lens};
}

SampleSum::SampleSum(const Intrinsics &camera, int supersampling)
    : width_(static_cast<std::size_t>(camera.width)),
      height_(static_cast<std::size_t>(camera.height)), k_(static_cast<std::size_t>(supersampling)),
      sums_(width_ * height_ * 3) {
}

void SampleSum::clear() {
    std::fill(sums_.begin(), sums_.end(), 0U);
    drawings_ = 0;
    target_area_ = 0.0;
}

void SampleSum::add(const Samples &samples) {
    const std::size_t rows = height_ * k_ + (k_ == 1 ? 0 : 1);
    const std::size_t row_bytes = samples.size() / rows;
    for (std::size_t y = 0; y < height_; ++y) {
        for (std::size_t sample = 0; sample <= (k_ == 1 ? 0 : k_); ++sample) {
            const std::size_t row = rows - 1 - (y * k_ + sample);
            add_row(&samples[row * row_bytes], weight(sample, k_), &sums_[y * width_ * 3]);
        }
    }
    target_area_ += target_area_of(samples);
    ++drawings_;
}

void SampleSum::add_row(const std::uint8_t *samples, unsigned row_weight, unsigned *sums) const {
    switch (k_) {
    case 4:
        add_samples<4>(samples, row_weight, width_, sums);
        break;
    case 2:
        add_samples<2>(samples, row_weight, width_, sums);
        break;
    default:
        add_samples<1>(samples, row_weight, width_, sums);
        break;
    }
}

cli::Image SampleSum::picture() const {
    const auto total = static_cast<unsigned>(k_ == 1 ? 1 : 4 * k_ * k_) * drawings_;
    cli::Image image;
    image.width = static_cast<std::uint32_t>(width_);
    image.height = static_cast<std::uint32_t>(height_);
    image.channels = 3;
    image.pixels.resize(sums_.size());
    std::transform(sums_.begin(), sums_.end(), image.pixels.begin(), [total](unsigned sum) {
        return static_cast<std::uint8_t>((sum + total / 2) / total);
    });
    return image;
}

double SampleSum::target_area_of(const Samples &samples) const {
    std::size_t count = 0;
    for (std::size_t i = 3; i < samples.size(); i += 4) {
        count += samples[i] > 127 ? 1U : 0U;
    }
    return static_cast<double>(count) / static_cast<double>(k_ * k_);
}

} // namespace sim
