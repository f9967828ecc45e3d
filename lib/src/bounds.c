/* SPDX-License-Identifier: MIT
 *
 * Bounds of colour ranges in other spaces.
 *
 * YUV <-> RGB: both directions are linear but for rounding (and, towards RGB,
 * clipping), so the extremes over a box stand at its corners and each channel's
 * follow from interval arithmetic with the matrix.  SLACK covers the rounding:
 * the 8-bit weights of pixel.h differ from the true inverse of the 16-bit ones
 * by at most 0.81 * 255/256 (row B), Y, U and V are within a half of what they
 * round, which the matrix makes at most 0.5 + 1.772 * 0.5, and the result is
 * rounded once: 2.7 in all, and less for the other rows.  Back, on unclipped
 * channels of -227..482, it is 1.6 + 0.5 (row Y).
 *
 * HSV: over the hue circle R - min, in units of chroma / 60, is a trapezium: 60
 * for h within 60 of 0, 0 for h within 60 of 180, linear between; G and B are
 * the same 120 and 240 degrees on.  With min = value - chroma and chroma =
 * s value / 255
 *
 *     channel = value (1 - s/255 (1 - t/60)),        t the trapezium at h,
 *
 * which rises with value and with t and falls with s: so the extremes stand at
 * the ends of the three intervals.  And a difference of two channels is
 * chroma (t1 - t2) / 60, where chroma >= s_lo value_lo / 255.  t and t1 - t2
 * are linear between multiples of 60 degrees: their extremes over the hues
 * stand at the two ends and the multiples of 60 between.
 */
#include "bounds.h"

#include <stdbool.h>

#include "int_math.h"
#include "pixel.h"

#define SLACK 3
#define TURN_DEG 360
#define SECTOR_DEG 60

/* Multiples of 60 in [0, 720), which holds every hue interval, wrapped ones too. */
#define SECTORS_TWO_TURNS 12

static int32_t lesser(int32_t a, int32_t b) {
    return (a < b) ? a : b;
}

static int32_t greater(int32_t a, int32_t b) {
    return (a > b) ? a : b;
}

static int32_t clip8(int32_t v) {
    return lesser(greater(v, 0), 255);
}

/* The least of row . x over lo <= x <= hi; the greatest is less the least of
 * the negated row. |row| < 2^18 and |x| < 2^9: below 2^29. */
static int32_t least_of(const int32_t row[3], const int32_t lo[3], const int32_t hi[3]) {
    int32_t sum = 0;

    for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 channels */
        sum += row[k] * ((row[k] > 0) ? lo[k] : hi[k]);
    }
    return sum;
}

static int32_t greatest_of(const int32_t row[3], const int32_t lo[3], const int32_t hi[3]) {
    return least_of(row, hi, lo);
}

/* The best of the ordered pairs of channels. */
static void consider_lead(ocel_lead_t *best, uint32_t above, uint32_t below, int32_t least) {
    if (least > best->least) {
        best->above = above;
        best->below = below;
        best->least = least;
    }
}

static const ocel_lead_t no_lead = {0U, 1U, 0};

static int32_t floor_ratio(int32_t num, int32_t den) {
    return (int32_t)ocel_udiv64((uint64_t)num, (uint64_t)den);
}

/* grey = (w . rgb + 128) >> 8 within lo .. hi means 256 lo - 128 <= w . rgb <=
 * 256 hi + 127.  A channel is least when the other two, of weight 256 - w
 * together, are 255, and greatest when they are 0. */
ocel_bounds_t ocel_bounds_of_gray(uint32_t lo, uint32_t hi) {
    static const int32_t weight_q8[3][3] = OCEL_YUV_Q8;
    ocel_bounds_t rgb;

    for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 channels */
        const int32_t w = weight_q8[0][k];
        const int32_t least = (256 * (int32_t)lo) - 128 - ((256 - w) * 255);
        const int32_t greatest = (256 * (int32_t)hi) + 127;

        rgb.lo[k] = clip8(floor_ratio(greater(least, 0) + (w - 1), w));
        rgb.hi[k] = clip8(floor_ratio(greatest, w));
    }
    return rgb;
}

/* Extremes over an interval of hues of the trapezia and of their differences. */
typedef struct {
    int32_t lo[3];
    int32_t hi[3];
    int32_t least[3][3]; /* of t[above] - t[below] */
} hue_extremes_t;

/* The trapezium t of channel k at h degrees, 0 <= h <= 720 + 240. */
static int32_t trapezium(uint32_t k, int32_t h_deg) {
    int32_t h = h_deg + (TURN_DEG - (120 * (int32_t)k)); /* red's at this hue: 120 .. 1320 */

    for (uint32_t turn = 0U; turn < 3U; turn++) { /* bound: 3 turns of at most 3.7 */
        h -= (h >= TURN_DEG) ? TURN_DEG : 0;
    }
    /* Now 0 <= h < 360; fold the falling half on the rising one. */
    h = (h > 180) ? (TURN_DEG - h) : h;
    return lesser(greater(120 - h, 0), 60);
}

static void include_hue(hue_extremes_t *extremes, int32_t h_deg) {
    int32_t t[3];

    for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 channels */
        t[k] = trapezium(k, h_deg);
        extremes->lo[k] = lesser(extremes->lo[k], t[k]);
        extremes->hi[k] = greater(extremes->hi[k], t[k]);
    }
    for (uint32_t a = 0U; a < 3U; a++) {     /* bound: 3 channels */
        for (uint32_t b = 0U; b < 3U; b++) { /* bound: 3 channels */
            extremes->least[a][b] = lesser(extremes->least[a][b], t[a] - t[b]);
        }
    }
}

/* lo_deg <= hi_deg, both 0..720. */
static hue_extremes_t hue_extremes(int32_t lo_deg, int32_t hi_deg) {
    hue_extremes_t extremes = {{60, 60, 60}, {0, 0, 0}, {{60, 60, 60}, {60, 60, 60}, {60, 60, 60}}};

    include_hue(&extremes, lo_deg);
    include_hue(&extremes, hi_deg);
    for (int32_t k = 1; k < SECTORS_TWO_TURNS; k++) { /* bound: SECTORS_TWO_TURNS */
        if ((lo_deg < (k * SECTOR_DEG)) && ((k * SECTOR_DEG) < hi_deg)) {
            include_hue(&extremes, k * SECTOR_DEG);
        }
    }
    return extremes;
}

/* value (1 - s/255 (1 - t/60)) = value (255 * 60 - s (60 - t)) / (255 * 60),
 * the numerator in 0 .. 255 * 15300 < 2^22; rounded up by the caller's `up`. */
static int32_t channel_at(int32_t value, int32_t s, int32_t t, int32_t up) {
    return floor_ratio((value * (15300 - (s * (60 - t)))) + up, 15300);
}

ocel_bounds_t ocel_bounds_of_hsv(const uint16_t lo[3], const uint16_t hi[3], ocel_lead_t *lead) {
    const int32_t wrap = (lo[0] > hi[0]) ? TURN_DEG : 0;
    const hue_extremes_t hue = hue_extremes((int32_t)lo[0], (int32_t)hi[0] + wrap);
    const int32_t chroma = floor_ratio(((int32_t)lo[1] * (int32_t)lo[2]) + 254, 255);
    ocel_bounds_t rgb;

    *lead = no_lead;
    for (uint32_t a = 0U; a < 3U; a++) { /* bound: 3 channels */
        rgb.lo[a] = channel_at((int32_t)lo[2], (int32_t)hi[1], hue.lo[a], 15299);
        rgb.hi[a] = channel_at((int32_t)hi[2], (int32_t)lo[1], hue.hi[a], 0);
        for (uint32_t b = 0U; b < 3U; b++) { /* bound: 3 channels */
            const int32_t t = greater(hue.least[a][b], 0);

            consider_lead(lead, a, b, floor_ratio((chroma * t) + 59, 60));
        }
    }
    return rgb;
}

/* The inverse of pixel.h's matrix, ITU-T T.871, in Q16: R, G, B from Y, U - 128
 * and V - 128. */
static const int32_t rgb_row_q16[3][3] = {
    {65536, 0, 91881}, {65536, -22554, -46802}, {65536, 116130, 0}};

ocel_bounds_t ocel_bounds_of_yuv(const uint16_t lo[3], const uint16_t hi[3], ocel_lead_t *lead) {
    const int32_t from[3] = {(int32_t)lo[0], (int32_t)lo[1] - 128, (int32_t)lo[2] - 128};
    const int32_t to[3] = {(int32_t)hi[0], (int32_t)hi[1] - 128, (int32_t)hi[2] - 128};
    ocel_bounds_t rgb;

    *lead = no_lead;
    for (uint32_t a = 0U; a < 3U; a++) { /* bound: 3 channels */
        const int32_t *const row = rgb_row_q16[a];

        rgb.lo[a] = clip8(ocel_asr32(least_of(row, from, to), 16U) - SLACK);
        rgb.hi[a] = clip8(ocel_asr32(greatest_of(row, from, to), 16U) + 1 + SLACK);
        for (uint32_t b = 0U; b < 3U; b++) { /* bound: 3 channels */
            const int32_t *const other = rgb_row_q16[b];
            const int32_t difference[3] = {row[0] - other[0], row[1] - other[1], row[2] - other[2]};

            const int32_t least = ocel_asr32(least_of(difference, from, to), 16U) - (2 * SLACK);

            consider_lead(lead, a, b, lesser(least, 255));
        }
    }
    return rgb;
}

/* What was clipped to 0 or 255 may have been anything beyond: a bound of 0 is
 * taken as -230 and one of 255 as 485, which the unclipped channels of any
 * Y, U, V (-226.8 .. 481.8) do not reach. */
ocel_bounds_t ocel_bounds_to_yuv(const ocel_bounds_t *rgb) {
    static const int32_t weight_q8[3][3] = OCEL_YUV_Q8;
    static const int32_t centre[3] = {0, 128, 128};
    int32_t from[3];
    int32_t to[3];
    ocel_bounds_t yuv;

    for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 channels */
        from[k] = (rgb->lo[k] <= 0) ? -230 : rgb->lo[k];
        to[k] = (rgb->hi[k] >= 255) ? 485 : rgb->hi[k];
    }
    for (uint32_t k = 0U; k < 3U; k++) { /* bound: 3 channels */
        const int32_t *const row = weight_q8[k];

        yuv.lo[k] = clip8(centre[k] + ocel_asr32(least_of(row, from, to), 8U) - SLACK);
        yuv.hi[k] = clip8(centre[k] + ocel_asr32(greatest_of(row, from, to), 8U) + 1 + SLACK);
    }
    return yuv;
}
