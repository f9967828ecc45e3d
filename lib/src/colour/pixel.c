/* SPDX-License-Identifier: MIT
 *
 * Colour spaces, one pixel at a time.
 */
#include "pixel.h"

#include "../base/int_math.h"

/* The inverse of BT.601 in Q16 (ITU-T T.871, section 7): 1.402, 0.344136,
 * 0.714136 and 1.772. */
#define V_TO_R_Q16 91881
#define U_TO_G_Q16 22554
#define V_TO_G_Q16 46802
#define U_TO_B_Q16 116130

static uint32_t widen5(uint32_t v) {
    return (v << 3U) | (v >> 2U);
}

static uint32_t widen6(uint32_t v) {
    return (v << 2U) | (v >> 4U);
}

ocel_pixel_t ocel_pixel_from_rgb565(uint32_t p) {
    const ocel_pixel_t rgb = {
        {widen5((p >> 11U) & 0x1FU), widen6((p >> 5U) & 0x3FU), widen5(p & 0x1FU)}};

    return rgb;
}

/* |weight| sums are at most 256, so |sum| <= 256 * 255 and the rounded sum is
 * 0..65535: for U and V 32895 -+ 128 * 255, for Y at most 256 * 255 + 128. */
static uint32_t weighted(uint32_t row, const ocel_pixel_t *rgb) {
    static const int32_t weight_q8[3][3] = {{77, 150, 29}, {-43, -85, 128}, {128, -107, -21}};
    static const int32_t round_q8[3] = {128, 32768 + 127, 32768 + 127};
    const int32_t *const weight = weight_q8[row];
    const int32_t sum_q8 = (weight[0] * (int32_t)rgb->c[0]) + (weight[1] * (int32_t)rgb->c[1]) +
                           (weight[2] * (int32_t)rgb->c[2]) + round_q8[row];

    return (uint32_t)sum_q8 >> 8U;
}

ocel_pixel_t ocel_pixel_to_yuv(const ocel_pixel_t *rgb) {
    const ocel_pixel_t yuv = {{weighted(0U, rgb), weighted(1U, rgb), weighted(2U, rgb)}};

    return yuv;
}

/* Rounded down; |v| <= 2^16 * 482 < 2^25. */
static uint32_t clip_q16(int32_t v_q16) {
    const int32_t v = ocel_asr32(v_q16, 16U);
    const int32_t above = (v > 0) ? v : 0;

    return (above < 255) ? (uint32_t)above : 255U;
}

/* |y| < 2^24 and |coefficient * 128| < 2^24: sums below 2^26. */
ocel_pixel_t ocel_pixel_from_yuv(const ocel_pixel_t *yuv) {
    const int32_t y_q16 = ((int32_t)yuv->c[0] * 65536) + 32768; /* the half that rounds */
    const int32_t u = (int32_t)yuv->c[1] - 128;
    const int32_t v = (int32_t)yuv->c[2] - 128;
    const ocel_pixel_t rgb = {{clip_q16(y_q16 + (V_TO_R_Q16 * v)),
                               clip_q16(y_q16 - (U_TO_G_Q16 * u) - (V_TO_G_Q16 * v)),
                               clip_q16(y_q16 + (U_TO_B_Q16 * u))}};

    return rgb;
}

/* The usual hexagon: 60 degrees a sector, measured from the largest channel
 * (R 0, G 120, B 240 degrees) by the difference of the other two; |difference|
 * <= chroma.  Where two channels are the largest both sectors give the same
 * hue, so the order of the questions does not matter. */
static inline uint32_t hue_times_chroma(const ocel_pixel_t *rgb, uint32_t value, uint32_t chroma) {
    const uint32_t r = rgb->c[0];
    const uint32_t g = rgb->c[1];
    const uint32_t b = rgb->c[2];
    uint32_t hue = 0U;

    if ((r == value) && (g >= b)) {
        hue = 60U * (g - b);
    } else if (r == value) {
        hue = (360U * chroma) - (60U * (b - g));
    } else if (g == value) {
        hue = ((120U * chroma) + (60U * b)) - (60U * r);
    } else {
        hue = ((240U * chroma) + (60U * r)) - (60U * g);
    }
    return hue;
}

static inline ocel_pixel_hsv_t to_hsv(const ocel_pixel_t *rgb) {
    const uint32_t r = rgb->c[0];
    const uint32_t g = rgb->c[1];
    const uint32_t b = rgb->c[2];
    const uint32_t rg_max = (r > g) ? r : g;
    const uint32_t rg_min = (r > g) ? g : r;
    ocel_pixel_hsv_t hsv;

    hsv.value = (rg_max > b) ? rg_max : b;
    hsv.chroma = hsv.value - ((rg_min > b) ? b : rg_min);
    hsv.hue = hue_times_chroma(rgb, hsv.value, hsv.chroma);
    hsv.hue_unit = (hsv.chroma > 0U) ? hsv.chroma : 1U;
    hsv.value_unit = (hsv.value > 0U) ? hsv.value : 1U;
    return hsv;
}

ocel_pixel_hsv_t ocel_pixel_to_hsv(const ocel_pixel_t *rgb) {
    return to_hsv(rgb);
}

bool ocel_pixel_in_rgb(const uint16_t lo[3], const uint16_t hi[3], const ocel_pixel_t *rgb) {
    bool in = true;

    for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 channels */
        in = in && (rgb->c[k] >= lo[k]) && (rgb->c[k] <= hi[k]);
    }
    return in;
}

bool ocel_pixel_in_yuv(const uint16_t lo[3], const uint16_t hi[3], const ocel_pixel_t *rgb) {
    bool in = true;

    for (uint32_t k = 0U; (k < 3U) && in; k++) { /* bound: 3 channels */
        const uint32_t v = weighted(k, rgb);

        in = (v >= lo[k]) && (v <= hi[k]);
    }
    return in;
}

/* Every product is at most 360 * 255. */
static bool hue_in(uint32_t lo_deg, uint32_t hi_deg, const ocel_pixel_hsv_t *hsv) {
    const bool from_lo = hsv->hue >= (lo_deg * hsv->hue_unit);
    const bool to_hi = hsv->hue <= (hi_deg * hsv->hue_unit);

    return (lo_deg <= hi_deg) ? (from_lo && to_hi) : (from_lo || to_hi);
}

/* s >= lo exactly when 255 * chroma >= lo * value: at most 255 * 255.  Black
 * has chroma 0 and unit 1, so its s is 0. */
bool ocel_pixel_in_hsv(const uint16_t lo[3], const uint16_t hi[3], const ocel_pixel_t *rgb) {
    const ocel_pixel_hsv_t hsv = to_hsv(rgb);
    const uint32_t s_times_value = 255U * hsv.chroma;

    return (hsv.value >= lo[2]) && (hsv.value <= hi[2]) &&
           (s_times_value >= ((uint32_t)lo[1] * hsv.value_unit)) &&
           (s_times_value <= ((uint32_t)hi[1] * hsv.value_unit)) && hue_in(lo[0], hi[0], &hsv);
}
