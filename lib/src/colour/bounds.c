/* SPDX-License-Identifier: MIT
 *
 * Bounds of colour ranges in other spaces.
 *
 * YUV <-> RGB: both directions are linear but for rounding (and, towards RGB,
 * clipping), so the extremes over a box stand at its corners and each channel's
 * follow from interval arithmetic with the matrix.  SLACK covers the rounding.
 * Towards RGB (row B is the worst): the 8-bit weights of pixel.h differ from the
 * inverse of the 16-bit ones by at most 0.81 * 255/256, and Y, U and V are within
 * a half of what they round, which the matrix makes 0.5 + 1.772 * 0.5: together
 * 2.2 (over all 2^24 colours 2.12).  Towards YUV, on unclipped channels of
 * -227 .. 482 (row Y): at most 1.6 + 0.5 (over all 2^24 triples 0.93).
 *
 * HSV: over the hue circle R - min, in units of chroma / 60, is a trapezium: 60
 * for h within 60 of 0, 0 for h within 60 of 180, linear between; G and B are
 * the same 120 and 240 degrees on.  With min = value - chroma and chroma =
 * s value / 255
 *
 *     channel = value (1 - s/255 (1 - t/60)),        t the trapezium at h,
 *
 * which rises with value and with t and falls with s: so the extremes stand at
 * the ends of the three intervals.  t is linear between multiples of 60 degrees:
 * its extremes over the hues stand at the two ends or the multiples between.
 */
#include "bounds.h"

#include "../base/int_math.h"

#define SLACK 3
#define TURN_DEG 360
#define SECTOR_DEG 60

/* Multiples of 60 in (0, 720), which holds every hue interval, wrapped ones too. */
#define SECTORS_TWO_TURNS 12

static int32_t lesser(int32_t a, int32_t b) {
    return (a < b) ? a : b;
}

static int32_t greater(int32_t a, int32_t b) {
    return (a > b) ? a : b;
}

static uint16_t clip8(int32_t v) {
    return (uint16_t)lesser(greater(v, 0), 255);
}

/* ---- HSV ---- */

/* The trapezium at h degrees from its top, 0 <= h < 1440. */
static int32_t trapezium(int32_t h_deg) {
    int32_t h = h_deg;

    for (uint32_t turn = 0U; turn < 3U; turn++) { /* bound: 3 turns to take off */
        h -= (h >= TURN_DEG) ? TURN_DEG : 0;
    }
    h = lesser(h, TURN_DEG - h); /* the falling half on the rising one */
    return lesser(greater(120 - h, 0), 60);
}

/* value (1 - s/255 (1 - t/60)) = value (255 * 60 - s (60 - t)) / 15300.  The
 * numerator is 0 .. 255 * 15300 < 2^22.  2^32 / 15300 is between the two factors
 * used, so the product is below the quotient or above it, by less than 1. */
#define FACTOR_BELOW 280716U
#define FACTOR_ABOVE 280717U

static uint16_t channel_at(uint32_t value, uint32_t s, int32_t t, uint32_t factor) {
    const int32_t below_top = 60 - t;
    const uint32_t num = value * (15300U - (s * (uint32_t)below_top));

    return (uint16_t)(((uint64_t)num * factor) >> 32U);
}

/* Over the hues lo .. hi, wrapped ones up to 720: at the ends, which k = 0 and
 * the last k stand for, and at the multiples of 60 between. */
void ocel_bounds_hsv_to_rgb(ocel_bounds_t *bounds) {
    const ocel_bounds_t hsv = *bounds;
    const int32_t from = (int32_t)hsv.lo[0];
    const int32_t wrap = (hsv.lo[0] > hsv.hi[0]) ? TURN_DEG : 0;
    const int32_t to = (int32_t)hsv.hi[0] + wrap;

    for (uint32_t c = 0U; c < 3U; c++) { /* bound: 3 channels */
        const int32_t top = TURN_DEG - (120 * (int32_t)c);
        int32_t t_lo = 60;
        int32_t t_hi = 0;

        for (int32_t k = 0; k <= SECTORS_TWO_TURNS; k++) { /* bound: SECTORS_TWO_TURNS */
            const int32_t t = trapezium(top + lesser(greater(k * SECTOR_DEG, from), to));

            t_lo = lesser(t_lo, t);
            t_hi = greater(t_hi, t);
        }
        bounds->lo[c] = channel_at(hsv.lo[2], hsv.hi[1], t_lo, FACTOR_BELOW);
        bounds->hi[c] = channel_at(hsv.hi[2], hsv.lo[1], t_hi, FACTOR_ABOVE);
    }
}

/* ---- YUV ---- */

/* The least of row * x over lo <= x <= hi, towards -infinity.  |row| < 2^18 and
 * |x| < 2^9: sums below 2^29. */
static int32_t least_of(const int32_t row_q16[3], const int32_t lo[3], const int32_t hi[3]) {
    int32_t sum_q16 = 0;

    for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 channels */
        sum_q16 += row_q16[k] * ((row_q16[k] > 0) ? lo[k] : hi[k]);
    }
    return ocel_asr32(sum_q16, 16U);
}

/* Bounds of matrix * x + offset over lo <= x <= hi, SLACK and at most one wider:
 * the greatest is the least of swapped bounds, rounded down, so one is added. */
static void bounds_of_image(ocel_bounds_t *bounds, const int32_t matrix_q16[3][3],
                            const int32_t offset[3], const int32_t lo[3], const int32_t hi[3]) {
    for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 channels */
        bounds->lo[k] = clip8(offset[k] + least_of(matrix_q16[k], lo, hi) - SLACK);
        bounds->hi[k] = clip8(offset[k] + least_of(matrix_q16[k], hi, lo) + 1 + SLACK);
    }
}

static const int32_t chroma_offset[3] = {0, 128, 128};

/* ITU-T T.871: R, G, B from Y, U - 128 and V - 128. */
void ocel_bounds_yuv_to_rgb(ocel_bounds_t *bounds) {
    static const int32_t to_rgb_q16[3][3] = {
        {65536, 0, 91881}, {65536, -22554, -46802}, {65536, 116130, 0}};
    static const int32_t no_offset[3] = {0, 0, 0};
    int32_t lo[3];
    int32_t hi[3];

    for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 channels */
        lo[k] = (int32_t)bounds->lo[k] - chroma_offset[k];
        hi[k] = (int32_t)bounds->hi[k] - chroma_offset[k];
    }
    bounds_of_image(bounds, to_rgb_q16, no_offset, lo, hi);
}

/* The weights of pixel.h in Q16.  What was clipped to 0 or 255 may have been
 * anything beyond: a bound of 0 is taken as -230 and one of 255 as 485, which
 * the unclipped channels of any Y, U, V (-226.8 .. 481.8) do not reach. */
void ocel_bounds_rgb_to_yuv(ocel_bounds_t *bounds) {
    static const int32_t to_yuv_q16[3][3] = {
        {19712, 38400, 7424}, {-11008, -21760, 32768}, {32768, -27392, -5376}};
    int32_t lo[3];
    int32_t hi[3];

    for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 channels */
        lo[k] = (bounds->lo[k] == 0U) ? -230 : (int32_t)bounds->lo[k];
        hi[k] = (bounds->hi[k] == 255U) ? 485 : (int32_t)bounds->hi[k];
    }
    bounds_of_image(bounds, to_yuv_q16, chroma_offset, lo, hi);
}
