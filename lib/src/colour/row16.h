/* SPDX-License-Identifier: MIT
 *
 * Lines of two bytes a pixel, RGB565 and YUYV, and of one, GRAY8.
 *
 * Everywhere here: pixels is a multiple of 8, `line` has as many bytes as they
 * take, and row is zeros on entry; bit x % 32 of row[x / 32] is pixel x.
 */
#ifndef OCEL_ROW16_H
#define OCEL_ROW16_H

#include <stdint.h>

/* A table of RGB565 colours: see ocel_colour_table_t. */
typedef struct {
    const uint32_t *word;
    uint32_t least;
    uint32_t headroom;
} ocel_row16_table_t;

/* Sets the bits of the pixels p whose bit p % 32 of word[p / 32] is set; pixels is a
 * multiple of 16. */
void ocel_row16_table(const ocel_row16_table_t *table, const uint8_t *line, uint32_t pixels,
                      uint32_t *row);

/* Sets the bits of exactly the pixels whose Y is in the range lanes[0], and whose
 * U and V are in those of bytes 0 and 1 and of bytes 2 and 3 of lanes[1]. */
void ocel_row16_yuyv(const uint32_t lanes[][4], const uint8_t *line, uint32_t pixels,
                     uint32_t *row);

/* Sets the bits of exactly the pixels in the range lanes. */
void ocel_row8_gray(const uint32_t lanes[4], const uint8_t *line, uint32_t pixels, uint32_t *row);

#endif
