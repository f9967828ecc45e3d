// SPDX-License-Identifier: MIT
#include "scene.hpp"

#include <algorithm>
#include <cmath>

namespace cli {

namespace {

struct Colour {
    double r;
    double g;
    double b;
};

// A hash of a lattice point, 0 .. 1 (the finaliser of splitmix64).
double lattice(std::int64_t x, std::int64_t y, std::uint64_t seed) {
    std::uint64_t z = seed + 0x9e3779b97f4a7c15U * static_cast<std::uint64_t>(x * 65537 + y);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return static_cast<double>((z ^ (z >> 31)) >> 11) / 9007199254740992.0;
}

// Value noise: a smooth interpolation of the lattice.
double smooth_noise(double x, double y, std::uint64_t seed) {
    const double x0 = std::floor(x);
    const double y0 = std::floor(y);
    const auto ease = [](double t) { return t * t * (3 - 2 * t); };
    const double u = ease(x - x0);
    const double v = ease(y - y0);
    const auto ix = static_cast<std::int64_t>(x0);
    const auto iy = static_cast<std::int64_t>(y0);
    const double top = lattice(ix, iy, seed) * (1 - u) + lattice(ix + 1, iy, seed) * u;
    const double bottom = lattice(ix, iy + 1, seed) * (1 - u) + lattice(ix + 1, iy + 1, seed) * u;
    return top * (1 - v) + bottom * v;
}

// A grey-blue wall above a green floor of boards, each with a grain.
Colour ground_at(double x, double y, double height, std::uint64_t seed) {
    const double horizon = 0.62 * height;
    if (y < horizon) {
        const double grain = smooth_noise(x / 23, y / 17, seed) + smooth_noise(x / 5, y / 4, seed);
        const double light = 0.75 + 0.20 * grain;
        return {104 * light, 118 * light, 128 * light};
    }
    const double depth = 12 / (y - horizon + 8);
    const double board = std::floor((x - 160) * depth / 14);
    const double grain = smooth_noise(x * depth / 3, y / 2, seed + 7);
    const double light = 0.55 + 0.25 * grain + 0.15 * lattice(static_cast<int>(board), 0, seed);
    return {70 * light, 120 * light, 84 * light};
}

// Lambert with ambient light and a highlight, lit from the upper left.
Colour ball_at(double x, double y, const Ball &ball) {
    const double nx = (x - ball.cx) / ball.radius;
    const double ny = (y - ball.cy) / ball.radius;
    const double nz = std::sqrt(std::max(0.0, 1 - nx * nx - ny * ny));
    const double facing = std::max(0.0, -0.44 * nx - 0.54 * ny + 0.72 * nz);
    const double light = 0.50 + 0.50 * facing;
    const double shine = 90 * std::pow(facing, 40);
    return {248 * light + shine, 128 * light + shine, 24 * light + shine};
}

std::uint8_t level(double value, double noise) {
    return static_cast<std::uint8_t>(std::clamp(std::lround(value + noise), 0L, 255L));
}

} // namespace

Image render_scene(std::uint32_t width, std::uint32_t height, const Ball &ball,
                   std::uint64_t seed) {
    Image image{width, height, 3, {}};
    image.pixels.resize(image.row_bytes() * height);
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            const double away = std::hypot(x - ball.cx, y - ball.cy);
            const double share = std::clamp(ball.radius - away + 0.5, 0.0, 1.0);
            const Colour far = ground_at(x, y, height, seed);
            const Colour near = ball_at(x, y, ball);
            std::uint8_t *const pixel = image.row(y) + 3 * std::size_t{x};
            const double noise = 6 * lattice(x, y, seed + 99) - 3;
            pixel[0] = level(far.r + share * (near.r - far.r), noise);
            pixel[1] = level(far.g + share * (near.g - far.g), noise);
            pixel[2] = level(far.b + share * (near.b - far.b), noise);
        }
    }
    return image;
}

} // namespace cli
