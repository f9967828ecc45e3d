// SPDX-License-Identifier: MIT
#include "camera/renderer_shapes.hpp"

#include <algorithm>
#include <limits>

#include "support/random.hpp"

namespace sim {

std::vector<float> cube_vertices() {
    constexpr int kCorners[6][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}};
    std::vector<float> vertices;
    for (int axis = 0; axis < 3; ++axis) {
        for (int side = -1; side <= 1; side += 2) {
            for (const auto &corner : kCorners) {
                float vertex[6] = {};
                vertex[axis] = vertex[3 + axis] = static_cast<float>(side);
                // Anticlockwise as seen from outside.
                vertex[(axis + 1) % 3] = static_cast<float>(corner[0] * side);
                vertex[(axis + 2) % 3] = static_cast<float>(corner[1]);
                vertices.insert(vertices.end(), vertex, vertex + 6);
            }
        }
    }
    return vertices;
}

std::vector<std::uint8_t> pattern_texels() {
    std::vector<double> sum(kPatternSize * kPatternSize, 0.0);
    for (int octave = 0; octave < 6; ++octave) {
        const int cells = kPatternSize >> octave;
        Random random(static_cast<std::uint64_t>(octave));
        std::vector<double> value(static_cast<std::size_t>(cells) *
                                  static_cast<std::size_t>(cells));
        for (double &cell : value) {
            cell = random.uniform(-1, 1);
        }
        for (int i = 0; i < kPatternSize * kPatternSize; ++i) {
            const int cell = (i / kPatternSize >> octave) * cells + (i % kPatternSize >> octave);
            sum[static_cast<std::size_t>(i)] +=
                value[static_cast<std::size_t>(cell)] * (octave + 1);
        }
    }
    std::vector<std::uint8_t> texels(sum.size());
    for (std::size_t i = 0; i < sum.size(); ++i) {
        texels[i] = static_cast<std::uint8_t>(std::lround(127.5 + 127.4 * sum[i] / 21.0));
    }
    return texels;
}

std::vector<float> ray_texels(const Intrinsics &grid) {
    std::vector<float> texels;
    texels.reserve(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height) *
                   3);
    for (int row = grid.height - 1; row >= 0; --row) {
        for (int column = 0; column < grid.width; ++column) {
            const auto ray =
                unbent(grid.lens, {(column - grid.cx) / grid.fx, (row - grid.cy) / grid.fy});
            const cv::Point2d place = ray.value_or(cv::Point2d());
            texels.push_back(static_cast<float>(place.x));
            texels.push_back(static_cast<float>(place.y));
            texels.push_back(ray ? 1.0F : 0.0F);
        }
    }
    return texels;
}

RayBounds::RayBounds(const std::vector<float> &rays, int width, int height, int axis) {
    const auto columns = static_cast<std::size_t>(width);
    const auto lines = static_cast<std::size_t>(axis == 0 ? width : height);
    least_.assign(lines, std::numeric_limits<float>::max());
    most_.assign(lines, std::numeric_limits<float>::lowest());
    for (std::size_t i = 0; i < rays.size() / 3; ++i) {
        if (rays[3 * i + 2] != 0.0F) {
            const std::size_t line = axis == 0 ? i % columns : i / columns;
            const float value = rays[3 * i + static_cast<std::size_t>(axis)];
            least_[line] = std::min(least_[line], value);
            most_[line] = std::max(most_[line], value);
        }
    }
}

Span RayBounds::within(double low, double high) const {
    Span span{static_cast<int>(least_.size()), 0};
    for (std::size_t i = 0; i < least_.size(); ++i) {
        if (least_[i] <= high && most_[i] >= low) {
            span.first = std::min(span.first, static_cast<int>(i));
            span.last = static_cast<int>(i) + 1;
        }
    }
    return span;
}

} // namespace sim
