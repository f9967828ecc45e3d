// SPDX-License-Identifier: MIT
//
// What tests draw and measure of a drawn ball.
#ifndef OCELLUS_TEST_BALL_PICTURE_HPP
#define OCELLUS_TEST_BALL_PICTURE_HPP

#include "camera/drawing.hpp"
#include "geometry/ellipse.hpp"
#include "image.hpp"

namespace sim {

inline Solid white_ball(const Vec3 &p_world, double radius) {
    Solid ball;
    ball.shape = Shape::kBall;
    ball.X_world_solid.p = p_world;
    ball.half_size = Vec3(radius, radius, radius);
    ball.colour = Vec3(1, 1, 1);
    ball.is_target = true;
    return ball;
}

// The ellipse that has a picture's first and second moments: a uniform ellipse's
// variance along an axis is a quarter of the semi-axis squared.
inline Ellipse ellipse_of_picture(const cli::Image &image) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    for (std::uint32_t row = 0; row < image.height; ++row) {
        for (std::uint32_t column = 0; column < image.width; ++column) {
            const double share = image.row(row)[3 * column] / 255.0;
            n += share;
            x += share * column;
            y += share * row;
            xx += share * column * column;
            xy += share * column * row;
            yy += share * row * row;
        }
    }
    x /= n;
    y /= n;
    const double a = 4 * (xx / n - x * x - 1.0 / 12.0); // less the pixel's own variance
    const double b = 4 * (xy / n - x * y);
    const double c = 4 * (yy / n - y * y - 1.0 / 12.0);
    return {{x, y}, cv::Matx22d(a, b, b, c)};
}

} // namespace sim

#endif
