/* SPDX-License-Identifier: MIT
 *
 * Lines of three bytes a pixel, R G B or B G R.
 *
 * Everywhere here: `line` has 3 * pixels bytes, pixels is a multiple of 8, and
 * bit x % 32 of row[x / 32] is pixel x.  The tests set bits in a row of zeros;
 * the decisions clear those of pixels that are not in range.  `red` is where R
 * stands in the pixel, 0 or 2; G stands at 1 and B at 2 - red.
 */
#ifndef OCEL_ROW24_H
#define OCEL_ROW24_H

#include <stdint.h>

/* Passes exactly the pixels with begin[k] <= byte at[k] < end[k] for k 0..2, all
 * 0 <= begin <= end <= 256; quickest where the range of k = 0 is rare. */
void ocel_row24_box(const uint16_t begin[3], const uint16_t end[3], const uint8_t at[3],
                    const uint8_t *line, uint32_t pixels, uint32_t *row);

/* Passes every pixel. */
void ocel_row24_all(uint32_t pixels, uint32_t *row);

/* Passes every pixel whose byte `above` exceeds its byte `below` by at least
 * `lead`, 4..255, and some that miss that by up to 6. */
void ocel_row24_lead(uint32_t above, uint32_t below, uint32_t lead, const uint8_t *line,
                     uint32_t pixels, uint32_t *row);

/* Keeps the pixels whose first `channels` (1: grey, 3) of Y, U and V are within
 * lo .. hi. */
void ocel_row24_decide_yuv(const uint16_t lo[3], const uint16_t hi[3], uint32_t channels,
                           uint32_t red, const uint8_t *line, uint32_t pixels, uint32_t *row);

/* Keeps the pixels that ocel_pixel_in_hsv() says are in range. */
void ocel_row24_decide_hsv(const uint16_t lo[3], const uint16_t hi[3], uint32_t red,
                           const uint8_t *line, uint32_t pixels, uint32_t *row);

#endif
