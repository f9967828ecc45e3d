/* SPDX-License-Identifier: MIT
 *
 * The sums of a component, run by run.
 *
 * Ranges: columns and rows below 4096, so a run's sums are below 2^12 (area),
 * 2^24 (x, y), 2^36 (xx, xy, yy) and a frame's below 2^24, 2^36, 2^48; with
 * 32-bit moments (320x240 at most) the largest of a frame is 2.61e9 < 2^32.
 */
#ifndef OCEL_COMPONENT_H
#define OCEL_COMPONENT_H

#include <stdbool.h>
#include <stdint.h>

#include <ocellus/labeller.h>

/* The inverse of 3 modulo the moments' word: it divides multiples of 3. */
#define OCEL_INVERSE_OF_3 ((ocel_moment_t)(((UINT64_MAX / 3U) * 2U) + 1U))

/* Adds a run [start, end) of row y, start < end, to the sums.
 *
 * With n pixels and s = first + last, sum x = n s / 2 (n and s are never both
 * odd) and sum x^2 = n (3 s^2 + n^2 - 1) / 12, both exact.  The latter product
 * is below 2^12 * (3 * 2^26 + 2^24) < 2^40, with 32-bit moments at most
 * 320 * (3 * 638^2 + 320^2) < 4.3e8; its 12th part is had without a division:
 * 4 by a shift, 3 by its inverse modulo the word, exact as nothing remains.
 * A run of one pixel, which is what noise consists of, needs none of this. */
static inline void ocel_component_add(ocel_component_t *component, uint32_t start, uint32_t end,
                                      uint32_t y) {
    const ocel_moment_t row = y;
    const uint32_t n = end - start;
    ocel_moment_t sum_x = start;
    ocel_moment_t sum_xx = sum_x * sum_x;
    ocel_moment_t sum_y = row;
    ocel_moment_t sum_yy = row * row;

    if (n != 1U) {
        const ocel_moment_t s = ((ocel_moment_t)start + end) - 1U;
        const ocel_moment_t pixels = n;

        sum_x = (pixels * s) >> 1U;
        sum_xx = ((pixels * (((3U * s * s) + (pixels * pixels)) - 1U)) >> 2U) * OCEL_INVERSE_OF_3;
        sum_y = pixels * row;
        sum_yy *= pixels;
    }
    component->area += n;
    component->sum_xx += sum_xx;
    if (component->left > start) {
        component->left = (uint16_t)start;
    }
    component->sum_x += sum_x;
    component->sum_xy += sum_x * row;
    if (component->end < end) {
        component->end = (uint16_t)end;
    }
    component->sum_y += sum_y;
    component->sum_yy += sum_yy;
}

/* Makes the component of one run, as above. */
static inline void ocel_component_start(ocel_component_t *component, uint32_t start, uint32_t end,
                                        uint32_t y) {
    component->area = 0U;
    component->sum_x = 0U;
    component->left = (uint16_t)start;
    component->sum_xx = 0U;
    component->sum_y = 0U;
    component->end = (uint16_t)end;
    component->sum_xy = 0U;
    component->first = (y << 16U) | start;
    component->sum_yy = 0U;
    ocel_component_add(component, start, end, y);
}

/* Adds all of `part` to `whole`. */
void ocel_component_merge(ocel_component_t *whole, const ocel_component_t *part);

/* True when a ranks before b: more pixels, or as many and an earlier first one. */
static inline bool ocel_component_beats(const ocel_component_t *a, const ocel_component_t *b) {
    bool beats = a->area > b->area;

    if (a->area == b->area) {
        beats = a->first < b->first;
    }
    return beats;
}

/* The component as a blob; its last row is `bottom`. */
void ocel_component_blob(const ocel_component_t *component, uint32_t bottom, uint32_t width,
                         uint32_t height, ocel_blob_t *blob);

#endif
