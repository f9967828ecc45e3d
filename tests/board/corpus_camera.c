/* SPDX-License-Identifier: MIT
 *
 * Rays through pixels and back, with and without a lens.
 */
#include <string.h>

#include "corpus.h"
#include "rng.h"

enum { ONE_PX = 65536 };

static void look_around(hash_t *h, const ocel_intrinsics_t *intrinsics, rng_t *rng) {
    ocel_camera_t camera;
    memset(&camera, 0, sizeof(camera));
    hash_enum(h, ocel_camera_init(&camera, intrinsics));
    for (uint32_t i = 0U; i < 200U; i++) {
        const int32_t reach = ((i % 10U) == 0U) ? INT32_MAX : (400 * ONE_PX);
        ocel_point_t pixel; /* drawn in this order whatever the compiler */
        pixel.x_px_q16 = rng_between(rng, -(reach / 8), reach);
        pixel.y_px_q16 = rng_between(rng, -(reach / 8), reach);
        int32_t ray[3] = {0, 0, 0};
        ocel_point_t back = {0, 0};
        hash_enum(h, ocel_camera_ray(&camera, &pixel, ray));
        hash_i32s(h, ray, 3U);
        ray[0] += rng_between(rng, -1000, 1000);
        hash_enum(h, ocel_camera_project(&camera, ray, &back));
        hash_i32(h, back.x_px_q16);
        hash_i32(h, back.y_px_q16);
        for (uint32_t k = 0U; k < 3U; k++) {
            ray[k] /= 1 << rng_below(rng, 30U);
        }
        hash_enum(h, ocel_camera_project(&camera, ray, &back));
        hash_i32(h, back.x_px_q16);
        hash_i32(h, back.y_px_q16);
    }
}

void corpus_camera(hash_t *h) {
    static const ocel_intrinsics_t cameras[] = {
        {277 * ONE_PX, 277 * ONE_PX, 10452992, 7831552, 0, 0, 0, 0, 0, 320, 240},
        {300 * ONE_PX, 310 * ONE_PX, 160 * ONE_PX, 120 * ONE_PX, -5033165, 1677722, 16777, -8389,
         -335544, 0, 0},
        {16 * ONE_PX, 16384 * ONE_PX, -5 * ONE_PX, 0, 1 << 28, -(1 << 28), 1 << 28, -(1 << 28), 0,
         320, 240},
        {0, 277 * ONE_PX, 0, 0, 0, 0, 0, 0, 0, 320, 240},
    };
    rng_t rng = rng_seed(20110309U);
    for (size_t i = 0U; i < sizeof(cameras) / sizeof(cameras[0]); i++) {
        look_around(h, &cameras[i], &rng);
    }
}
