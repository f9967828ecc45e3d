/* SPDX-License-Identifier: MIT
 *
 * Lines of three bytes a pixel, R G B or B G R.
 */
#ifndef OCEL_ROW24_H
#define OCEL_ROW24_H

#include <stdint.h>

/* Sets the bits of exactly the pixels whose bytes at[0], at[1] and at[2] are all
 * within the ranges lanes[0..2] (lanes.h); quickest where the first is rare.
 *   line    3 * pixels bytes
 *   pixels  a multiple of 16
 *   row     zeros on entry; bit x % 32 of word x / 32 is pixel x. */
void ocel_row24_box(const uint32_t lanes[][4], const uint8_t at[3], const uint8_t *line,
                    uint32_t pixels, uint32_t *row);

#endif
