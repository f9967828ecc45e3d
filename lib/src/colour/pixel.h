/* SPDX-License-Identifier: MIT
 *
 * One pixel: what its colour is in each space, and whether it is in a range.
 * The definitions; the line tests of colour.c are fast ways to the same answers.
 */
#ifndef OCEL_PIXEL_H
#define OCEL_PIXEL_H

#include <stdbool.h>
#include <stdint.h>

/* Three channels, each 0..255: R, G, B or Y, U, V as the function says. */
typedef struct {
    uint32_t c[3];
} ocel_pixel_t;

/* RGB565 to 8 bits a channel by repeating the upper bits: 0 gives 0, the
 * largest 255.  p <= 65535. */
ocel_pixel_t ocel_pixel_from_rgb565(uint32_t p);

/* Y, U and V of pixel x of a YUYV line. */
static inline ocel_pixel_t ocel_pixel_of_yuyv(const uint8_t *line, uint32_t x) {
    const uint8_t *const pair = &line[4U * (x >> 1U)];
    const ocel_pixel_t yuv = {{pair[2U * (x & 1U)], pair[1], pair[3]}};

    return yuv;
}

/* Y, U and V from R, G and B: full-range BT.601 (JFIF) in 1/256, with the weights
 * 77 150 29, -43 -85 128 and 128 -107 -21.  These sum to 256, 0 and 0, so a grey
 * pixel is (its grey, 128, 128) exactly.  To the nearest integer: Y with halves
 * upwards; U and V with halves downwards, as libjpeg does, so that pure blue and
 * pure red have 255 and not 256. */
ocel_pixel_t ocel_pixel_to_yuv(const ocel_pixel_t *rgb);

/* Its inverse, with 16 fraction bits, to the nearest integer, halves upwards,
 * clipped to 0..255. */
ocel_pixel_t ocel_pixel_from_yuv(const ocel_pixel_t *yuv);

/* HSV as fractions of integers, so that nothing is rounded: v = value,
 * s = 255 * chroma / value, h = hue / chroma in degrees, 0 <= h < 360.  Without
 * colour (R = G = B) h is 0, and the denominators are made 1 where they would
 * be 0, so they may be multiplied with. */
typedef struct {
    uint32_t value;      /* 0..255: the largest channel */
    uint32_t chroma;     /* 0..255: the largest less the smallest */
    uint32_t hue;        /* 0..360 * 255: h * chroma */
    uint32_t hue_unit;   /* 1..255: chroma, or 1 when that is 0 */
    uint32_t value_unit; /* 1..255: value, or 1 when that is 0 */
} ocel_pixel_hsv_t;

ocel_pixel_hsv_t ocel_pixel_to_hsv(const ocel_pixel_t *rgb);

/* lo[k] <= channel k <= hi[k] for R, G, B. */
bool ocel_pixel_in_rgb(const uint16_t lo[3], const uint16_t hi[3], const ocel_pixel_t *rgb);

/* The same for Y, U, V; grey, which is Y, with U and V left open. */
bool ocel_pixel_in_yuv(const uint16_t lo[3], const uint16_t hi[3], const ocel_pixel_t *rgb);

/* The same in HSV, exactly: lo and hi as in ocel_colour_range_t, hue may wrap. */
bool ocel_pixel_in_hsv(const uint16_t lo[3], const uint16_t hi[3], const ocel_pixel_t *rgb);

#endif
