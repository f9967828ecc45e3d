/* SPDX-License-Identifier: MIT
 *
 * Calls of fit.h, camera.h and cone.h.
 */
#include "calls.h"

/* ---- Fits ---- */

ocel_crack_t cracks[POINTS];
ocel_point_t points[POINTS];
ocel_ellipse_t ellipse;
static ocel_fit_options_t options;

static void call_fit_boundary(void) {
    must(ocel_fit_boundary(cracks, POINTS, true, &ellipse), "fit");
}

static void call_fit_cracks(void) {
    must(ocel_fit_cracks(cracks, POINTS, &options, &ellipse), "fit");
}

static void call_fit_points(void) {
    must(ocel_fit_points(points, POINTS, &options, &ellipse), "fit");
}

void measure_fits(void) {
    static const char *const names[3] = {"b2ac", "lcse", "hyper"};
    measure("ocel_fit_boundary", "b2ac", POINTS, call_fit_boundary);
    for (int method = 0; method < 3; method++) {
        options.method = (ocel_fit_method_t)method;
        options.perturb = OCEL_PERTURB_ALWAYS;
        options.closed = true;
        measure("ocel_fit_cracks", names[method], POINTS, call_fit_cracks);
        options.closed = false;
        measure("ocel_fit_points", names[method], POINTS, call_fit_points);
    }
}

/* ---- Camera and cone ---- */

ocel_camera_t camera;
ocel_cone_t cone;
ocel_camera_t lens_camera;
static int32_t ray[3];
static const ocel_point_t pixel = {101 * 65536 + 777, 77 * 65536 + 333};
const int32_t point_u[3] = {-40000, 55000, 400000};

void call_camera_init(void) {
    static const ocel_intrinsics_t pinhole = {
        277 * 65536, 277 * 65536, 10452992, 7831552, 0, 0, 0, 0, 0, FRAME_WIDTH, FRAME_HEIGHT};
    must(ocel_camera_init(&camera, &pinhole), "camera");
}

void call_lens_init(void) {
    static const ocel_intrinsics_t lens = {277 * 65536, 277 * 65536, 10452992,    7831552,
                                           -1677722,    335544,      16777,       -8389,
                                           0,           FRAME_WIDTH, FRAME_HEIGHT};
    must(ocel_camera_init(&lens_camera, &lens), "camera");
}

static void call_ray(void) {
    must(ocel_camera_ray(&camera, &pixel, ray), "ray");
}

static void call_lens_ray(void) {
    must(ocel_camera_ray(&lens_camera, &pixel, ray), "ray");
}

static void call_project(void) {
    ocel_point_t seen;
    must(ocel_camera_project(&camera, point_u, &seen), "project");
}

static void call_lens_project(void) {
    ocel_point_t seen;
    must(ocel_camera_project(&lens_camera, point_u, &seen), "project");
}

static void call_cone_cracks(void) {
    must(ocel_cone_fit_cracks(&camera, cracks, POINTS, &cone), "cone");
}

static void call_cone_points(void) {
    must(ocel_cone_fit_points(&camera, points, POINTS, &cone), "cone");
}

static void call_lens_cone(void) {
    ocel_cone_t other;
    (void)ocel_cone_fit_points(&lens_camera, points, POINTS, &other);
}

static void call_cone_of_ellipse(void) {
    ocel_cone_t other;
    must(ocel_cone_of_ellipse(&camera, &ellipse, &other), "cone");
}

static void call_outline(void) {
    ocel_ellipse_t outline;
    must(ocel_cone_outline(&camera, &cone, &outline), "outline");
}

void measure_space(void) {
    measure("ocel_camera_init", "pinhole", 1, call_camera_init);
    measure("ocel_camera_init", "lens", 1, call_lens_init);
    measure("ocel_camera_ray", "pinhole", 1, call_ray);
    measure("ocel_camera_ray", "lens", 1, call_lens_ray);
    measure("ocel_camera_project", "pinhole", 1, call_project);
    measure("ocel_camera_project", "lens", 1, call_lens_project);
    measure("ocel_cone_fit_cracks", "pinhole", POINTS, call_cone_cracks);
    measure("ocel_cone_fit_points", "pinhole", POINTS, call_cone_points);
    measure("ocel_cone_fit_points", "lens", POINTS, call_lens_cone);
    measure("ocel_cone_of_ellipse", "plain", 1, call_cone_of_ellipse);
    measure("ocel_cone_outline", "plain", 1, call_outline);
}
