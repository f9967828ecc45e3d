/* SPDX-License-Identifier: MIT
 *
 * Masks to label, and the brute-force twin of the labeller: flood fill, sums by
 * pixel, the outer boundary by walking around the pixels.  It keeps the whole
 * mask and looks at it as often as it likes, which the library may not.
 */
#ifndef SUPPORT_MASKS_H
#define SUPPORT_MASKS_H

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#include <ocellus/config.h>
#include <ocellus/types.h>

#include "rng.h"

enum {
    MASK_MAX_PIXELS = OCEL_MAX_WIDTH * OCEL_MAX_HEIGHT,
    /* Isolated pixels; and twice the lattice's edges. */
    MASK_MAX_BLOBS = (MASK_MAX_PIXELS + 1) / 2,
    MASK_MAX_CRACKS = 2 * MASK_MAX_PIXELS + OCEL_MAX_WIDTH + OCEL_MAX_HEIGHT
};

typedef struct {
    int width;
    int height;
    uint8_t pixel[MASK_MAX_PIXELS]; /* 0 or 1 */
} mask_t;

/* ---- Drawing ---- */

static inline void mask_clear(mask_t *mask, int width, int height) {
    mask->width = width;
    mask->height = height;
    memset(mask->pixel, 0, (size_t)width * (size_t)height);
}

static inline bool mask_get(const mask_t *mask, int x, int y) {
    return (x >= 0) && (y >= 0) && (x < mask->width) && (y < mask->height) &&
           (mask->pixel[y * mask->width + x] != 0U);
}

/* Sets a pixel; outside it does nothing. */
static inline void mask_set(mask_t *mask, int x, int y, bool on) {
    if ((x >= 0) && (y >= 0) && (x < mask->width) && (y < mask->height)) {
        mask->pixel[y * mask->width + x] = on ? 1U : 0U;
    }
}

static inline void mask_box(mask_t *mask, int left, int top, int width, int height, bool on) {
    for (int y = top; y < top + height; y++) {
        for (int x = left; x < left + width; x++) {
            mask_set(mask, x, y, on);
        }
    }
}

static inline void mask_disc(mask_t *mask, double cx, double cy, double radius, bool on) {
    for (int y = 0; y < mask->height; y++) {
        for (int x = 0; x < mask->width; x++) {
            if ((x - cx) * (x - cx) + (y - cy) * (y - cy) <= radius * radius) {
                mask_set(mask, x, y, on);
            }
        }
    }
}

/* Each pixel set with the probability `density`. */
static inline void mask_random(mask_t *mask, int width, int height, double density, rng_t *rng) {
    mask_clear(mask, width, height);
    for (int i = 0; i < width * height; i++) {
        mask->pixel[i] = (rng_unit(rng) < density) ? 1U : 0U;
    }
}

/* Discs set and cleared: large blobs with holes, bays and islands. */
static inline void mask_random_discs(mask_t *mask, int width, int height, int discs, rng_t *rng) {
    mask_clear(mask, width, height);
    for (int i = 0; i < discs; i++) {
        mask_disc(mask, rng_uniform(rng, 0.0, width), rng_uniform(rng, 0.0, height),
                  rng_uniform(rng, 0.5, 0.5 * width), (i % 2) == 0);
    }
}

/* An arm one pixel wide winding inwards, its windings `gap` pixels apart. */
static inline void mask_spiral(mask_t *mask, int width, int height, int gap) {
    int left = 0;
    int top = 0;
    int right = width - 1;
    int bottom = height - 1;

    mask_clear(mask, width, height);
    while ((left <= right) && (top <= bottom)) {
        mask_box(mask, (left >= gap + 1) ? left - gap - 1 : left, top, right - left + 1 + gap, 1,
                 true);
        mask_box(mask, right, top, 1, bottom - top + 1, true);
        mask_box(mask, left, bottom, right - left + 1, 1, true);
        top += gap + 1;
        mask_box(mask, left, top, 1, bottom - top + 1, true);
        left += gap + 1;
        right -= gap + 1;
        bottom -= gap + 1;
    }
}

/* Every second pixel, rows alternating. */
static inline void mask_checkerboard(mask_t *mask, int width, int height) {
    mask_clear(mask, width, height);
    for (int y = 0; y < height; y++) {
        for (int x = y % 2; x < width; x += 2) {
            mask_set(mask, x, y, true);
        }
    }
}

/* Every second column, joined by a bar of one row at `bar`. */
static inline void mask_comb(mask_t *mask, int width, int height, int bar) {
    mask_clear(mask, width, height);
    for (int x = 0; x < width; x += 2) {
        mask_box(mask, x, 0, 1, height, true);
    }
    mask_box(mask, 0, bar, width, 1, true);
}

/* Rectangular rings, one in the other, with `gap` between; U shapes when `open`
 * (the top is missing). */
static inline void mask_rings(mask_t *mask, int width, int height, int gap, bool open) {
    mask_clear(mask, width, height);
    for (int inset = 0; (2 * inset < width) && (2 * inset < height); inset += gap + 1) {
        const int w = width - 2 * inset;
        const int h = height - 2 * inset;
        mask_box(mask, inset, inset, w, h, true);
        mask_box(mask, inset + 1, inset + (open ? 0 : 1), w - 2, h - (open ? 1 : 2), false);
    }
}

/* A row as the library reads it.  Bits past the width are `beyond`. */
static inline void mask_row(const mask_t *mask, int y, bool beyond, uint32_t *row) {
    const int words = (mask->width + 31) / 32;

    for (int i = 0; i < words; i++) {
        row[i] = 0U;
    }
    for (int x = 0; x < 32 * words; x++) {
        if ((x < mask->width) ? mask_get(mask, x, y) : beyond) {
            row[x / 32] |= (uint32_t)1U << (x % 32);
        }
    }
}

static inline uint32_t mask_runs(const mask_t *mask) {
    uint32_t runs = 0U;

    for (int y = 0; y < mask->height; y++) {
        for (int x = 0; x < mask->width; x++) {
            runs += (mask_get(mask, x, y) && !mask_get(mask, x - 1, y)) ? 1U : 0U;
        }
    }
    return runs;
}

/* ---- The twin's components ---- */

typedef struct {
    int32_t label[MASK_MAX_PIXELS]; /* -1, or the component's index */
    ocel_blob_t blob[MASK_MAX_BLOBS];
    int count; /* in raster order of the first pixels */
    int best;  /* index of the largest, the earlier of equals; -1 */
} twin_t;

/* Fills the component of the pixel (x, y), which is its first. */
static inline void twin_fill(twin_t *twin, const mask_t *mask, int connectivity, int first) {
    static int32_t stack[MASK_MAX_PIXELS];
    ocel_blob_t blob = {{0U, 0U, 0U, 0U}, 0U, false, 0U, 0U, 0U, 0U, 0U, 0U};
    int depth = 0;
    int left = mask->width;
    int right = 0;
    int bottom = 0;

    stack[depth++] = first;
    twin->label[first] = twin->count;
    while (depth > 0) {
        const int at = stack[--depth];
        const int x = at % mask->width;
        const int y = at / mask->width;

        blob.area++;
        blob.sum_x += (uint64_t)x;
        blob.sum_y += (uint64_t)y;
        blob.sum_xx += (uint64_t)(x * x);
        blob.sum_xy += (uint64_t)(x * y);
        blob.sum_yy += (uint64_t)(y * y);
        left = (x < left) ? x : left;
        right = (x > right) ? x : right;
        bottom = (y > bottom) ? y : bottom;
        for (int dy = -1; dy <= 1; dy++) {
            for (int dx = -1; dx <= 1; dx++) {
                const int to = (y + dy) * mask->width + x + dx;
                if (((connectivity == 8) || (dx == 0) || (dy == 0)) &&
                    mask_get(mask, x + dx, y + dy) && (twin->label[to] < 0)) {
                    twin->label[to] = twin->count;
                    stack[depth++] = to;
                }
            }
        }
    }
    blob.first_x = (uint16_t)(first % mask->width);
    blob.box.top = (uint16_t)(first / mask->width);
    blob.box.left = (uint16_t)left;
    blob.box.width = (uint16_t)(right - left + 1);
    blob.box.height = (uint16_t)(bottom - blob.box.top + 1);
    blob.touches_edge = (left == 0) || (blob.box.top == 0U) || (right == mask->width - 1) ||
                        (bottom == mask->height - 1);
    twin->blob[twin->count] = blob;
    if ((twin->best < 0) || (blob.area > twin->blob[twin->best].area)) {
        twin->best = twin->count;
    }
    twin->count++;
}

static inline void twin_label(twin_t *twin, const mask_t *mask, int connectivity) {
    const int pixels = mask->width * mask->height;

    twin->count = 0;
    twin->best = -1;
    for (int i = 0; i < pixels; i++) {
        twin->label[i] = -1;
    }
    for (int i = 0; i < pixels; i++) {
        if ((mask->pixel[i] != 0U) && (twin->label[i] < 0)) {
            twin_fill(twin, mask, connectivity, i);
        }
    }
}

static inline bool twin_in(const twin_t *twin, const mask_t *mask, int component, int x, int y) {
    return (x >= 0) && (y >= 0) && (x < mask->width) && (y < mask->height) &&
           (twin->label[y * mask->width + x] == component);
}

/* ---- The twin's boundary ---- */

/* Walks around a component from its lowest row's last run, up that run's left
 * edge, the component on the right hand; gives all cracks in order and how many
 * of them are vertical.  At a corner where four pixels meet and two that face each
 * other are of the component, the walk goes over to the other one when it is
 * 8-connected (left) and stays with this one when it is 4-connected (right). */
static inline int twin_boundary(const twin_t *twin, const mask_t *mask, int connectivity,
                                int component, ocel_crack_t *crack, int *vertical) {
    /* Headings up, right, down, left: the step to the next corner. */
    static const int step_x[4] = {0, 1, 0, -1};
    static const int step_y[4] = {-1, 0, 1, 0};
    /* The pixels ahead of a corner, by heading, as offsets to the corner. */
    static const int ahead_left_x[4] = {-1, 0, 0, -1};
    static const int ahead_left_y[4] = {-1, -1, 0, 0};
    const ocel_blob_t *blob = &twin->blob[component];
    const int bottom = blob->box.top + blob->box.height - 1;
    int start_x = blob->box.left + blob->box.width - 1;
    int x;
    int y;
    int heading = 0;
    int count = 0;

    while (!twin_in(twin, mask, component, start_x, bottom)) {
        start_x--;
    }
    while (twin_in(twin, mask, component, start_x - 1, bottom)) {
        start_x--;
    }
    *vertical = 0;
    x = start_x; /* the corner at the pixel's lower left */
    y = bottom + 1;
    do {
        const int right_heading = (heading + 1) % 4;
        bool left;
        bool right;

        /* Twice the midpoint of the edge, corners being at half pixels. */
        crack[count].x_hpx = (int16_t)(2 * x - 1 + step_x[heading]);
        crack[count].y_hpx = (int16_t)(2 * y - 1 + step_y[heading]);
        count++;
        *vertical += (step_y[heading] != 0) ? 1 : 0;
        x += step_x[heading];
        y += step_y[heading];
        left = twin_in(twin, mask, component, x + ahead_left_x[heading], y + ahead_left_y[heading]);
        right = twin_in(twin, mask, component, x + ahead_left_x[right_heading],
                        y + ahead_left_y[right_heading]);
        if (left && (right || (connectivity == 8))) {
            heading = (heading + 3) % 4;
        } else if (!right) {
            heading = right_heading;
        }
    } while ((x != start_x) || (y != bottom + 1) || (heading != 0));
    return count;
}

/* The outer cracks of a component by definition: the pixel beyond belongs to the
 * outside, which is what can be reached from beyond the image without entering
 * the component, 4-connected for an 8-connected component and the other way
 * round.  Counts them, and says whether those of `crack`, `count` of them, are
 * exactly these. */
static inline bool twin_is_outer(const twin_t *twin, const mask_t *mask, int connectivity,
                                 int component, const ocel_crack_t *crack, int count) {
    enum { MARGIN_PIXELS = (OCEL_MAX_WIDTH + 2) * (OCEL_MAX_HEIGHT + 2) };
    static uint8_t outside[MARGIN_PIXELS];
    static uint8_t given[MARGIN_PIXELS]; /* bits: left, top, right, bottom */
    static int32_t stack[MARGIN_PIXELS];
    static const int dx[4] = {-1, 0, 1, 0};
    static const int dy[4] = {0, -1, 0, 1};
    const int width = mask->width + 2;
    const int height = mask->height + 2;
    int depth = 0;
    int expected = 0;
    bool good = true;

    memset(outside, 0, (size_t)width * (size_t)height);
    memset(given, 0, (size_t)width * (size_t)height);
    outside[0] = 1U;
    stack[depth++] = 0;
    while (depth > 0) {
        const int at = stack[--depth];
        for (int ny = at / width - 1; ny <= at / width + 1; ny++) {
            for (int nx = at % width - 1; nx <= at % width + 1; nx++) {
                const bool straight = (nx == at % width) || (ny == at / width);
                if ((straight || (connectivity == 4)) && (nx >= 0) && (ny >= 0) && (nx < width) &&
                    (ny < height) && (outside[ny * width + nx] == 0U) &&
                    !twin_in(twin, mask, component, nx - 1, ny - 1)) {
                    outside[ny * width + nx] = 1U;
                    stack[depth++] = ny * width + nx;
                }
            }
        }
    }
    for (int i = 0; (i < count) && good; i++) {
        /* The two pixels at the crack; the one inside and the side it is at. */
        const bool upright = (crack[i].x_hpx & 1) != 0;
        const int x = (crack[i].x_hpx + (upright ? 1 : 0)) / 2;
        const int y = (crack[i].y_hpx + (upright ? 0 : 1)) / 2;
        const int before_x = upright ? x - 1 : x;
        const int before_y = upright ? y : y - 1;
        const bool after = twin_in(twin, mask, component, x, y);
        const int at = after ? ((y + 1) * width + x + 1) : ((before_y + 1) * width + before_x + 1);
        const uint8_t side = (uint8_t)((upright ? 1U : 2U) << (after ? 0U : 2U));

        good = ((crack[i].x_hpx + crack[i].y_hpx) % 2 != 0) &&
               (after != twin_in(twin, mask, component, before_x, before_y)) &&
               ((given[at] & side) == 0U);
        given[at] |= side;
    }
    for (int y = 0; y < mask->height; y++) {
        for (int x = 0; x < mask->width; x++) {
            for (int side = 0; (side < 4) && twin_in(twin, mask, component, x, y); side++) {
                const int beyond = (y + 1 + dy[side]) * width + x + 1 + dx[side];
                const bool is_outer = outside[beyond] != 0U;
                const bool is_given = (given[(y + 1) * width + x + 1] & (1U << side)) != 0U;
                expected += is_outer ? 1 : 0;
                good = good && (is_outer == is_given);
            }
        }
    }
    return good && (expected == count);
}

#endif
