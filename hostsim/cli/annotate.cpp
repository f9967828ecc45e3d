// SPDX-License-Identifier: MIT
//
// Drawing: floating point is fine here, nothing of it is reported.
#include "annotate.hpp"

#include <algorithm>
#include <cmath>

#include <ocellus/label.h>

namespace cli {

namespace {

struct Ink {
    double r;
    double g;
    double b;
};

constexpr Ink kVouched{40, 255, 80};
constexpr Ink kEstimate{255, 60, 255};
constexpr Ink kBox{255, 255, 255};
constexpr Ink kShade{0, 0, 0};
constexpr double kShadeStrength = 0.6;

// The outline's and the cross's half widths, px, and the dark rim around both,
// which keeps them legible on any ground.
constexpr double kOutlineHalf = 1.0;
constexpr double kCrossHalf = 0.75;
constexpr double kCrossArm = 7.0;
constexpr double kRim = 1.0;

double of_q16(std::int64_t value) {
    return static_cast<double>(value) / 65536.0;
}

Image in_colour(const Image &image) {
    if (image.channels == 3) {
        return image;
    }
    Image copy = image;
    copy.channels = 3;
    copy.pixels.resize(copy.row_bytes() * copy.height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        std::fill_n(copy.pixels.begin() + static_cast<std::ptrdiff_t>(3 * i), 3, image.pixels[i]);
    }
    return copy;
}

void blend(Image &image, long x, long y, const Ink &ink, double share) {
    if (share <= 0 || x < 0 || y < 0 || x >= long{image.width} || y >= long{image.height}) {
        return;
    }
    std::uint8_t *const pixel = image.row(static_cast<std::size_t>(y)) + 3 * x;
    const double parts[3] = {ink.r, ink.g, ink.b};
    for (int k = 0; k < 3; ++k) {
        pixel[k] =
            static_cast<std::uint8_t>(std::lround(pixel[k] * (1 - share) + parts[k] * share));
    }
}

// A stroke of half width `half` covers this share of a pixel `distance` away.
double coverage(double distance, double half) {
    return std::clamp(half + 0.5 - distance, 0.0, 1.0);
}

// Where a shape may draw, in whole pixels.
struct Area {
    long left;
    long top;
    long right;
    long bottom;
};

Area area_around(const Image &image, double cx, double cy, double half_width, double half_height) {
    const double margin = 3;
    const auto low = [](double value, double limit) {
        return static_cast<long>(std::clamp(std::floor(value), 0.0, limit));
    };
    const double right = image.width - 1.0;
    const double bottom = image.height - 1.0;
    return {low(cx - half_width - margin, right), low(cy - half_height - margin, bottom),
            low(cx + half_width + margin, right), low(cy + half_height + margin, bottom)};
}

// Draws the shape whose outline is `distance(x, y)` px away: the rim, then ink.
template <typename Distance>
void stroke(Image &image, const Area &area, double half, const Ink &ink, Distance distance) {
    for (long y = area.top; y <= area.bottom; ++y) {
        for (long x = area.left; x <= area.right; ++x) {
            const double away = distance(static_cast<double>(x), static_cast<double>(y));
            blend(image, x, y, kShade, kShadeStrength * coverage(away, half + kRim));
            blend(image, x, y, ink, coverage(away, half));
        }
    }
}

// To first order: |F| / |grad F| with F = sqrt((u/a)^2 + (v/b)^2) - 1.
class EllipseDistance {
  public:
    explicit EllipseDistance(const ocel_ellipse_t &ellipse)
        : cx_(of_q16(ellipse.cx_px_q16)), cy_(of_q16(ellipse.cy_px_q16)),
          a_(std::max(of_q16(ellipse.a_px_q16), 0.5)), b_(std::max(of_q16(ellipse.b_px_q16), 0.5)) {
        const double angle = ellipse.angle_turn_q32 * (2 * 3.14159265358979323846 / 4294967296.0);
        cos_ = std::cos(angle);
        sin_ = std::sin(angle);
    }

    double operator()(double x, double y) const {
        const double u = ((x - cx_) * cos_ + (y - cy_) * sin_) / a_;
        const double v = ((y - cy_) * cos_ - (x - cx_) * sin_) / b_;
        const double radius = std::hypot(u, v);
        const double gradient = std::hypot(u / a_, v / b_);
        return gradient > 0 ? std::fabs(radius - 1) * radius / gradient : b_;
    }

    Area area(const Image &image) const {
        return area_around(image, cx_, cy_, std::hypot(a_ * cos_, b_ * sin_),
                           std::hypot(a_ * sin_, b_ * cos_));
    }

  private:
    double cx_;
    double cy_;
    double a_;
    double b_;
    double cos_ = 1;
    double sin_ = 0;
};

void draw_cross(Image &image, double cx, double cy, const Ink &ink) {
    stroke(image, area_around(image, cx, cy, kCrossArm, kCrossArm), kCrossHalf, ink,
           [cx, cy](double x, double y) {
               const double dx = std::fabs(x - cx);
               const double dy = std::fabs(y - cy);
               const double along = std::max(std::max(dx, dy) - kCrossArm, 0.0);
               return std::hypot(std::min(dx, dy), along);
           });
}

// One pixel around the box, half transparent, so that what is below shows.
void draw_box(Image &image, const ocel_rect_t &box) {
    const long left = long{box.left} - 1;
    const long top = long{box.top} - 1;
    const long right = long{box.left} + box.width;
    const long bottom = long{box.top} + box.height;
    for (long x = left; x <= right; ++x) {
        blend(image, x, top, kBox, 0.6);
        blend(image, x, bottom, kBox, 0.6);
    }
    for (long y = top + 1; y < bottom; ++y) {
        blend(image, left, y, kBox, 0.6);
        blend(image, right, y, kBox, 0.6);
    }
}

// A pixel as a camera without the lens would see it; false where it sees nothing.
bool straightened(const ocel_camera_t &lens, double &x, double &y) {
    const ocel_point_t pixel = {static_cast<std::int32_t>(std::lround(x * 65536)),
                                static_cast<std::int32_t>(std::lround(y * 65536))};
    const ocel_intrinsics_t &in = lens.intrinsics;
    std::int32_t d[3] = {};
    if (ocel_camera_ray(&lens, &pixel, d) != OCEL_OK) {
        return false;
    }
    x = of_q16(in.cx_px_q16) + of_q16(in.fx_px_q16) * d[0] / d[2];
    y = of_q16(in.cy_px_q16) + of_q16(in.fy_px_q16) * d[1] / d[2];
    return true;
}

// The ellipse's outline and the place of its centre, seen through the lens if there is
// one.
void draw_ellipse(Image &image, const ocel_ellipse_t &ellipse, const ocel_camera_t *lens,
                  const Ink &ink) {
    const EllipseDistance distance(ellipse);
    if (lens == nullptr) {
        stroke(image, distance.area(image), kOutlineHalf, ink, distance);
        draw_cross(image, of_q16(ellipse.cx_px_q16), of_q16(ellipse.cy_px_q16), ink);
        return;
    }
    const Area everywhere = area_around(image, 0, 0, image.width, image.height);
    stroke(image, everywhere, kOutlineHalf, ink, [&distance, lens](double x, double y) {
        return straightened(*lens, x, y) ? distance(x, y) : HUGE_VAL;
    });
    const ocel_intrinsics_t &in = lens->intrinsics;
    const double dx = of_q16(ellipse.cx_px_q16 - std::int64_t{in.cx_px_q16}) / of_q16(in.fx_px_q16);
    const double dy = of_q16(ellipse.cy_px_q16 - std::int64_t{in.cy_px_q16}) / of_q16(in.fy_px_q16);
    constexpr double kFar = 1e8;
    const std::int32_t centre[3] = {static_cast<std::int32_t>(dx * kFar),
                                    static_cast<std::int32_t>(dy * kFar),
                                    static_cast<std::int32_t>(kFar)};
    ocel_point_t pixel{};
    if (ocel_camera_project(lens, centre, &pixel) == OCEL_OK) {
        draw_cross(image, of_q16(pixel.x_px_q16), of_q16(pixel.y_px_q16), ink);
    }
}

// Digits of 3 x 5 dots, from the upper left, one bit a dot; the last is `/`.
constexpr unsigned kGlyphs[11] = {0x7B6F, 0x2C97, 0x73E7, 0x73CF, 0x5BC9, 0x79CF,
                                  0x79EF, 0x7249, 0x7BEF, 0x7BCF, 0x12A4};
constexpr long kDot = 2; // px
constexpr long kGlyphWidth = 4 * kDot;
constexpr long kLabelHeight = 7 * kDot;

// White on a dark ground, its upper left corner there or as near as the image has room.
void draw_label(Image &image, const std::string &text, long left, long top) {
    const long width = static_cast<long>(text.size()) * kGlyphWidth + kDot;
    const long x0 = std::max(std::min(left, long{image.width} - width), 0L);
    const long y0 = std::max(std::min(top, long{image.height} - kLabelHeight), 0L);
    for (long y = 0; y < kLabelHeight; ++y) {
        for (long x = 0; x < width; ++x) {
            const long column = x / kDot - 1;
            const long row = y / kDot - 1;
            const bool inside = column >= 0 && column % 4 < 3 && row >= 0 && row < 5;
            const char c = inside ? text[static_cast<std::size_t>(column / 4)] : '0';
            const unsigned glyph = kGlyphs[c == '/' ? 10 : c - '0'];
            const bool ink = inside && ((glyph >> (14 - 3 * row - column % 4)) & 1U) != 0U;
            blend(image, x0 + x, y0 + y, ink ? kBox : kShade, ink ? 1.0 : kShadeStrength);
        }
    }
}

} // namespace

Image annotated(const Image &image, const ocel_detection_t &detection, const Overlay &overlay) {
    Image copy = in_colour(image);
    if (detection.status == OCEL_NOT_SEEN) {
        return copy;
    }
    const Ink &ink = detection.status == OCEL_OK ? kVouched : kEstimate;
    const ocel_rect_t &box = detection.blob.box;
    draw_box(copy, box);
    if (detection.has_ellipse) {
        draw_ellipse(copy, detection.ellipse, overlay.lens, ink);
    } else {
        std::int32_t cx_px_q16 = 0;
        std::int32_t cy_px_q16 = 0;
        ocel_blob_centroid(&detection.blob, &cx_px_q16, &cy_px_q16);
        draw_cross(copy, of_q16(cx_px_q16), of_q16(cy_px_q16), ink);
    }
    if (!overlay.label.empty()) {
        draw_label(copy, overlay.label, long{box.left}, long{box.top} + box.height + 2);
    }
    return copy;
}

} // namespace cli
