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

/* Runs [start, end) of one row: sums of end^k - start^k, k = 1, 2, 3.  The runs
 * do not overlap, so the sums are at most width^3: 2^36, and with 32-bit moments
 * 2^25. */
typedef struct {
    uint32_t first;
    ocel_moment_t second;
    ocel_moment_t third;
} ocel_row_sums_t;

static inline void ocel_row_sums_add(ocel_row_sums_t *sums, uint32_t start, uint32_t end) {
    const ocel_moment_t s = start;
    const ocel_moment_t e = end;

    sums->first += end - start;
    sums->second += (e * e) - (s * s);
    sums->third += (e * e * e) - (s * s * s);
}

/* Takes the pixel x out. */
static inline void ocel_row_sums_drop(ocel_row_sums_t *sums, uint32_t x) {
    const ocel_moment_t next = x + 1U;
    const ocel_moment_t twice = next + x; /* (x + 1)^2 - x^2 */

    sums->first--;
    sums->second -= twice;
    sums->third -= (twice * next) + ((ocel_moment_t)x * x);
}

/* Adds a row. */
static inline void ocel_rows_add(ocel_rows_t *rows, uint32_t y) {
    const ocel_moment_t row = y;

    rows->count++;
    rows->sum_y += row;
    rows->sum_yy += row * row;
}

/* Adds runs of row y, in the columns from left to end - 1, to a component.
 *
 * The sum of x below t is t (t - 1) / 2 and that of x^2 is t (t - 1) (2 t - 1) / 6,
 * so a row's are (second - first) / 2 and (2 third - 3 second + first) / 6, both
 * exact: 2 by a shift, 3 by its inverse modulo the word, exact as nothing
 * remains. */
void ocel_component_add(ocel_component_t *component, const ocel_row_sums_t *sums, uint32_t left,
                        uint32_t end, uint32_t y);

/* Adds the run [start, end) in several rows to a component that has it in the row above
 * them. */
void ocel_component_repeat(ocel_component_t *component, uint32_t start, uint32_t end,
                           const ocel_rows_t *rows);

/* Makes the component of one run of row y. */
void ocel_component_start(ocel_component_t *component, uint32_t start, uint32_t end, uint32_t y);

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
