/* SPDX-License-Identifier: MIT
 *
 * Fits of points and of cracks: exact ellipses, noise, arcs, few points, and what
 * is no ellipse or hardly one.
 */
#include <string.h>

#include "base/trig.h"
#include "corpus.h"
#include "rng.h"

enum { MAX_POINTS = 300, ONE_PX = 65536 };

static ocel_point_t points[MAX_POINTS];
static ocel_crack_t cracks[MAX_POINTS];

typedef struct {
    int32_t cx_px;
    int32_t cy_px;
    int32_t a_px;
    int32_t b_px;
    uint32_t turn_q32; /* tilt */
    uint32_t arc_q32;  /* how much of the turn, 0: all */
    int32_t noise_q16; /* uniform, +- */
} shape_t;

static int32_t product(int32_t a, int32_t b_q30) {
    return (int32_t)(((int64_t)a * b_q30) / (1 << 30));
}

/* Points on an ellipse's arc, in Q16, and the same on the grid of half pixels. */
static void draw(const shape_t *shape, uint32_t count, rng_t *rng) {
    const uint64_t arc = (shape->arc_q32 == 0U) ? (UINT64_C(1) << 32U) : shape->arc_q32;
    int32_t tilt_sin = 0;
    int32_t tilt_cos = 0;
    ocel_sincos(shape->turn_q32, &tilt_sin, &tilt_cos);
    for (uint32_t i = 0U; i < count; i++) {
        int32_t s = 0;
        int32_t c = 0;
        ocel_sincos((uint32_t)((arc * i) / count), &s, &c);
        const int32_t u = product(shape->a_px * ONE_PX, c);
        const int32_t v = product(shape->b_px * ONE_PX, s);
        const int32_t n = shape->noise_q16;
        const int32_t x = product(u, tilt_cos) - product(v, tilt_sin) + rng_between(rng, -n, n);
        const int32_t y = product(u, tilt_sin) + product(v, tilt_cos) + rng_between(rng, -n, n);
        points[i].x_px_q16 = shape->cx_px * ONE_PX + x;
        points[i].y_px_q16 = shape->cy_px * ONE_PX + y;
        cracks[i].x_hpx = (int16_t)(points[i].x_px_q16 / (ONE_PX / 2));
        cracks[i].y_hpx = (int16_t)(points[i].y_px_q16 / (ONE_PX / 2));
    }
}

static void fit_all(hash_t *h, size_t count) {
    for (int32_t o = 0; o < 9; o++) {
        const ocel_fit_options_t options = {(ocel_fit_method_t)(o % 3), (ocel_perturb_t)(o / 3),
                                            (o % 2) != 0};
        ocel_ellipse_t ellipse;
        memset(&ellipse, 0, sizeof(ellipse));
        hash_enum(h, ocel_fit_points(points, count, &options, &ellipse));
        hash_ellipse(h, &ellipse);
        hash_enum(h, ocel_fit_cracks(cracks, count, &options, &ellipse));
        hash_ellipse(h, &ellipse);
        hash_enum(h, ocel_fit_boundary(cracks, count, (o % 2) != 0, &ellipse));
        hash_ellipse(h, &ellipse);
    }
}

static void shapes(hash_t *h, rng_t *rng) {
    static const shape_t shape[] = {
        {160, 120, 40, 40, 0U, 0U, 0},
        {100, 90, 80, 30, 0x20000000U, 0U, 0},
        {100, 90, 80, 30, 0x20000000U, 0U, 20000},
        {160, 120, 40, 40, 0U, 0x80000000U, 0},
        {160, 120, 40, 40, 0x12345678U, 0x60000000U, 20000},
        {160, 120, 40, 38, 0x52345678U, 0x30000000U, 6000},
        {160, 120, 40, 40, 0x92345678U, 0x08000000U, 100},
        {16000, -16000, 300, 200, 0x42345678U, 0U, 1000},
        {0, 0, 16000, 15000, 0x12340000U, 0U, 0},
        {200, 200, 150, 1, 0x32345678U, 0U, 5000},
        {50, 50, 3, 2, 0U, 0U, 30000},
    };
    for (size_t i = 0U; i < sizeof(shape) / sizeof(shape[0]); i++) {
        draw(&shape[i], 250U, rng);
        fit_all(h, 250U);
        draw(&shape[i], 12U, rng);
        fit_all(h, 12U);
    }
}

/* Random small sets: hostile grids, coordinates at and beyond the limits. */
static void wild(hash_t *h, rng_t *rng) {
    static const int32_t reach[6] = {1, 4, 4 * ONE_PX, 400 * ONE_PX, 1 << 30, INT32_MAX};
    for (uint32_t i = 0U; i < 60U; i++) {
        const uint32_t count = 5U + rng_below(rng, 8U);
        const int32_t most = reach[i % 6U];
        for (uint32_t k = 0U; k < count; k++) {
            points[k].x_px_q16 = rng_between(rng, -most, most);
            points[k].y_px_q16 = rng_between(rng, -most, most);
            cracks[k].x_hpx = (int16_t)(most % 8191 + rng_between(rng, -9, 9));
            cracks[k].y_hpx = (int16_t)rng_between(rng, -most % 32768, most % 32768);
        }
        fit_all(h, count);
    }
}

/* Points that are no ellipse: a line, one place, two parallel lines, a hyperbola
 * of whole numbers, a parabola; and too few, none, no memory. */
static void degenerate(hash_t *h) {
    for (int32_t kind = 0; kind < 5; kind++) {
        for (int32_t i = 0; i < 40; i++) {
            static const int32_t slope[5] = {1, 0, 0, 0, 0};
            const int32_t x = (kind == 1) ? 7 : 2 * i;
            int32_t y = slope[kind] * i + 9;
            if (kind == 2) {
                y = 9 + 8 * (i % 2);
            } else if (kind == 3) {
                y = 800 / (i + 2);
            } else if (kind == 4) {
                y = (i - 20) * (i - 20);
            }
            points[i].x_px_q16 = x * (ONE_PX / 2);
            points[i].y_px_q16 = y * (ONE_PX / 2);
            cracks[i].x_hpx = (int16_t)x;
            cracks[i].y_hpx = (int16_t)y;
        }
        fit_all(h, 40U);
    }
    ocel_ellipse_t ellipse;
    fit_all(h, 4U);
    hash_enum(h, ocel_fit_points(NULL, 40U, NULL, &ellipse));
    hash_enum(h, ocel_fit_points(points, 40U, NULL, NULL));
    hash_enum(h, ocel_fit_points(points, OCEL_MAX_FIT_POINTS + 1U, NULL, &ellipse));
    hash_enum(h, ocel_fit_points(points, 40U, NULL, &ellipse));
    hash_ellipse(h, &ellipse);
}

void corpus_fit(hash_t *h) {
    rng_t rng = rng_seed(20110308U);
    shapes(h, &rng);
    wild(h, &rng);
    degenerate(h);
}
