/* SPDX-License-Identifier: MIT
 *
 * Cones and spheres: of points on outlines, of boundaries that the eye found, of
 * ellipses, and of points that are no outline.
 */
#include <string.h>

#include "base/trig.h"
#include "corpus.h"
#include "rng.h"
#include "scene.h"

enum { ONE_PX = 65536, MAX_POINTS = 240, WIDTH = 320, HEIGHT = 240, ROW_WORDS = WIDTH / 32 };

static const ocel_intrinsics_t lenses[2] = {
    {277 * ONE_PX, 277 * ONE_PX, 10452992, 7831552, 0, 0, 0, 0, 0, WIDTH, HEIGHT},
    {300 * ONE_PX, 310 * ONE_PX, 160 * ONE_PX, 120 * ONE_PX, -1677722, 335544, 16777, -8389, 0, 0,
     0},
};

static ocel_camera_t camera;
static ocel_point_t points[MAX_POINTS];
static ocel_crack_t cracks[MAX_POINTS];
static ocel_eye_t eye;

static void hash_cone(hash_t *h, const ocel_cone_t *cone) {
    hash_i32s(h, cone->axis_cam_q30, 3U);
    hash_u32(h, cone->sin_q30);
    hash_i64s(h, cone->cov_q60, OCEL_SYM3_COUNT);
    hash_u32(h, cone->rms_px_q16);
    hash_u32(h, cone->arc_coverage_q16);
    hash_u32(h, cone->point_count);
    hash_u32(h, cone->inlier_count);
}

static void hash_sphere(hash_t *h, const ocel_sphere_t *sphere) {
    hash_i32s(h, sphere->p_cam_u, 3U);
    hash_i32(h, sphere->radius_u);
    hash_u32(h, sphere->range_u);
    hash_i64s(h, sphere->cov_cam_u2, OCEL_SYM3_COUNT);
}

/* What follows from a cone. */
static void place(hash_t *h, const ocel_cone_t *cone) {
    static const int32_t radii[4] = {35000, 1, 0, INT32_MAX};
    ocel_ellipse_t ellipse;
    memset(&ellipse, 0, sizeof(ellipse));
    hash_cone(h, cone);
    hash_enum(h, ocel_cone_outline(&camera, cone, &ellipse));
    hash_ellipse(h, &ellipse);
    for (uint32_t i = 0U; i < 4U; i++) {
        ocel_sphere_t sphere;
        memset(&sphere, 0, sizeof(sphere));
        hash_enum(h, ocel_sphere_of_cone(cone, radii[i], &sphere));
        hash_sphere(h, &sphere);
    }
}

static void fit(hash_t *h, size_t count) {
    ocel_ellipse_t ellipse;
    ocel_cone_t cone;
    memset(&cone, 0, sizeof(cone));
    memset(&ellipse, 0, sizeof(ellipse));
    hash_enum(h, ocel_cone_fit_points(&camera, points, count, &cone));
    place(h, &cone);
    hash_enum(h, ocel_cone_fit_cracks(&camera, cracks, count, &cone));
    place(h, &cone);
    (void)ocel_fit_points(points, count, NULL, &ellipse);
    hash_enum(h, ocel_cone_of_ellipse(&camera, &ellipse, &cone));
    place(h, &cone);
}

/* A circle of the image, `arc` of its turn, `noise` and every `wild`th point anywhere. */
static void draw(rng_t *rng, uint32_t count, uint64_t arc, int32_t noise_q16, uint32_t wild) {
    const int32_t radius = rng_between(rng, 5 * ONE_PX, 100 * ONE_PX);
    const int32_t cx = rng_between(rng, 20 * ONE_PX, 300 * ONE_PX);
    const int32_t cy = rng_between(rng, 20 * ONE_PX, 220 * ONE_PX);
    for (uint32_t i = 0U; i < count; i++) {
        int32_t s = 0;
        int32_t c = 0;
        ocel_sincos((uint32_t)((arc * i) / count), &s, &c);
        int32_t x = cx + (int32_t)(((int64_t)radius * c) / (1 << 30));
        int32_t y = cy + (int32_t)(((int64_t)radius * s) / (1 << 30));
        x += rng_between(rng, -noise_q16, noise_q16);
        y += rng_between(rng, -noise_q16, noise_q16);
        if ((wild != 0U) && ((i % wild) == 0U)) {
            x = rng_between(rng, 0, 319 * ONE_PX);
            y = rng_between(rng, 0, 239 * ONE_PX);
        }
        points[i].x_px_q16 = x;
        points[i].y_px_q16 = y;
        cracks[i].x_hpx = (int16_t)(x / (ONE_PX / 2));
        cracks[i].y_hpx = (int16_t)(y / (ONE_PX / 2));
    }
}

static void outlines(hash_t *h, rng_t *rng) {
    const uint64_t turn = UINT64_C(1) << 32U;
    for (uint32_t i = 0U; i < 8U; i++) {
        draw(rng, MAX_POINTS, turn, 0, 0U);
        fit(h, MAX_POINTS);
        draw(rng, 60U, turn - (turn >> (1U + i % 4U)), 20000, 5U);
        fit(h, 60U);
        draw(rng, 5U + i, turn, 1000 * (int32_t)i, 0U);
        fit(h, 5U + i);
        draw(rng, 100U, 1U + (turn >> (4U * i)), 30000, 2U);
        fit(h, 100U);
    }
    fit(h, 4U);
    fit(h, 0U);
    memset(points, 0, sizeof(points));
    memset(cracks, 0, sizeof(cracks));
    fit(h, 50U);
}

/* Boundaries as the eye finds them. */
static void frames(hash_t *h) {
    for (int32_t kind = 0; kind < (int32_t)SCENE_KINDS; kind++) {
        const scene_t scene = {(scene_kind_t)kind, WIDTH, HEIGHT, 2010U};
        ocel_eye_config_t config;
        ocel_detection_t detection;
        ocel_cone_t cone;
        memset(&config, 0, sizeof(config));
        memset(&detection, 0, sizeof(detection));
        memset(&cone, 0, sizeof(cone));
        config.width = WIDTH;
        config.height = HEIGHT;
        hash_enum(h, ocel_eye_init(&eye, &config));
        hash_enum(h, ocel_eye_begin(&eye));
        for (int32_t y = 0; y < HEIGHT; y++) {
            uint32_t row[ROW_WORDS];
            scene_row(&scene, y, row);
            hash_enum(h, ocel_eye_row(&eye, (uint16_t)y, row));
        }
        hash_enum(h, ocel_eye_end(&eye, &detection));
        hash_enum(h, ocel_eye_cone(&eye, &camera, &detection, &cone));
        place(h, &cone);
    }
}

void corpus_cone(hash_t *h) {
    rng_t rng = rng_seed(20100606U);
    for (uint32_t i = 0U; i < 2U; i++) {
        hash_enum(h, ocel_camera_init(&camera, &lenses[i]));
        outlines(h, &rng);
        frames(h);
    }
}
