/* SPDX-License-Identifier: MIT
 *
 * Lines of two bytes a pixel, RGB565 and YUYV, and of one, GRAY8.
 *
 * Everywhere here: pixels is a multiple of 8, `line` has as many bytes as they
 * take, and bit x % 32 of row[x / 32] is pixel x.  The tests set bits in a row
 * of zeros; the decision clears those of pixels that are not in range.
 */
#ifndef OCEL_ROW16_H
#define OCEL_ROW16_H

#include <stdbool.h>
#include <stdint.h>

/* Passes the pixels p whose bit p % 32 of table[p / 32] is set. */
void ocel_row16_table(const uint32_t table[2048], const uint8_t *line, uint32_t pixels,
                      uint32_t *row);

/* Passes exactly the pixels with begin[k] <= Y, U, V < end[k] for k = 0, 1, 2,
 * all 0 <= begin <= end <= 256. */
void ocel_row16_yuyv(const uint16_t begin[3], const uint16_t end[3], const uint8_t *line,
                     uint32_t pixels, uint32_t *row);

/* Keeps the pixels whose R, G, B (ocel_pixel_from_yuv) are in range: in HSV when
 * `hsv` is set, else each within lo .. hi. */
void ocel_row16_decide_yuyv(const uint16_t lo[3], const uint16_t hi[3], bool hsv,
                            const uint8_t *line, uint32_t pixels, uint32_t *row);

/* Passes exactly the pixels with begin <= grey < end. */
void ocel_row8_gray(uint32_t begin, uint32_t end, const uint8_t *line, uint32_t pixels,
                    uint32_t *row);

#endif
