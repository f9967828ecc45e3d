/* SPDX-License-Identifier: MIT
 *
 * Fits and cones of as many points as there may be.
 */
#include <string.h>

#include <ocellus/ocellus.h>

#include "base/int_math.h"
#include "base/trig.h"
#include "worst.h"

enum { ONE_PX = 65536, COUNT = OCEL_MAX_FIT_POINTS };

static ocel_point_t points[COUNT];
static ocel_crack_t cracks[COUNT];
static ocel_camera_t camera;

/* An arc of a circle of radius_px about (160, 120), in px Q16 and in half pixels. */
static void draw(int32_t radius_px, uint64_t arc_q32) {
    for (uint32_t i = 0U; i < (uint32_t)COUNT; i++) {
        int32_t s = 0;
        int32_t c = 0;
        ocel_sincos((uint32_t)((arc_q32 * i) / (uint32_t)COUNT), &s, &c);
        points[i].x_px_q16 =
            (160 * ONE_PX) + (int32_t)(((int64_t)radius_px * ONE_PX * c) / (1 << 30));
        points[i].y_px_q16 =
            (120 * ONE_PX) + (int32_t)(((int64_t)radius_px * ONE_PX * s) / (1 << 30));
        cracks[i].x_hpx = (int16_t)(points[i].x_px_q16 / (ONE_PX / 2));
        cracks[i].y_hpx = (int16_t)(points[i].y_px_q16 / (ONE_PX / 2));
    }
}

/* Half pixels that lie on a circle exactly, over and over: as exact as the points, and
 * too far from each other for the exact sums. */
static void draw_lattice(void) {
    enum { RADIUS = 6 * 1105 }; /* 5 * 13 * 17: many pairs of squares sum to its square */
    uint32_t found = 0U;

    for (int32_t x = RADIUS; x > -(RADIUS / 2); x -= 6) {
        const uint64_t rest = (uint64_t)((RADIUS * RADIUS) - (x * x));
        const uint32_t y = ocel_isqrt64(rest);
        if (((uint64_t)y * y) == rest) {
            cracks[found].x_hpx = (int16_t)(x + 400);
            cracks[found].y_hpx = (int16_t)(y + 400U);
            found++;
        }
    }
    for (uint32_t i = found; i < (uint32_t)COUNT; i++) {
        cracks[i] = cracks[i - found];
    }
}

static void fit(ocel_fit_method_t method, ocel_perturb_t perturb) {
    const ocel_fit_options_t options = {method, perturb, false};
    ocel_ellipse_t ellipse;

    (void)ocel_fit_points(points, COUNT, &options, &ellipse);
    (void)ocel_fit_cracks(cracks, COUNT, &options, &ellipse);
}

static void fit_cones(int32_t k1_q24) {
    const ocel_intrinsics_t lens = {277 * ONE_PX,
                                    277 * ONE_PX,
                                    160 * ONE_PX,
                                    120 * ONE_PX,
                                    k1_q24,
                                    335544,
                                    16777,
                                    -8389,
                                    0,
                                    0,
                                    0};
    ocel_cone_t cone;

    (void)ocel_camera_init(&camera, &lens);
    (void)ocel_cone_fit_points(&camera, points, COUNT, &cone);
    (void)ocel_cone_fit_cracks(&camera, cracks, COUNT, &cone);
}

void worst_fits(void) {
    const uint64_t turn_q32 = UINT64_C(1) << 32U;
    ocel_ellipse_t ellipse;

    /* So exact that it is found unstable and perturbed, and so short that it takes a
     * second opinion. */
    draw(40, turn_q32 / 3U);
    fit(OCEL_FIT_LCSE, OCEL_PERTURB_AUTO);
    /* Large enough that the cracks' exact sums do not do. */
    draw(8000, turn_q32 / 3U);
    draw_lattice();
    fit(OCEL_FIT_LCSE, OCEL_PERTURB_AUTO);
    fit(OCEL_FIT_HYPER, OCEL_PERTURB_AUTO);
    draw(50, turn_q32);
    (void)ocel_fit_boundary(cracks, COUNT, false, &ellipse);
    fit_cones(-1677722);
}
