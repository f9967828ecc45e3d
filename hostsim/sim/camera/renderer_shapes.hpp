// SPDX-License-Identifier: MIT
//
// What the renderer hands to OpenGL once: the cube that every solid is drawn as,
// the pattern of what is textured, and the rays of a camera with a lens.
#ifndef OCELLUS_SIM_RENDERER_SHAPES_HPP
#define OCELLUS_SIM_RENDERER_SHAPES_HPP

#include <cstdint>
#include <vector>

#include "camera/intrinsics.hpp"

namespace sim {

constexpr int kPatternSize = 256; // texels a side

// Six faces of two triangles; each vertex a corner and its face's normal.
std::vector<float> cube_vertices();

// Grey noise of mean .5 in squares of 1, 2, 4 ... 32 texels, the larger the
// stronger.
std::vector<std::uint8_t> pattern_texels();

// The ray (x, y, 1) in the camera of each sample, the bottom row first; (0, 0, 0)
// where the lens shows nothing.
std::vector<float> ray_texels(const Intrinsics &grid);

// Of the samples' columns or rows [first, last).
struct Span {
    int first;
    int last;
};

// Which samples look between two tangents: by their ranges in each column, or row.
class RayBounds {
  public:
    // `axis` 0: of x in each column; 1: of y in each row, counted as in the texels.
    RayBounds(const std::vector<float> &rays, int width, int height, int axis);
    Span within(double low, double high) const;

  private:
    std::vector<float> least_;
    std::vector<float> most_;
};

} // namespace sim

#endif
