/* SPDX-License-Identifier: MIT
 *
 * Every stage of the library once, on a stated input, each in a function of its
 * own whose name tools/cycles.py looks for in callgrind's output.
 *
 *   stage_cost [REPEATS]
 *
 * prints one CSV line a stage: name, input, units (pixels, points or 1), and
 * nanoseconds a call by the machine's clock, the fastest of REPEATS (default 1).
 */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <ocellus/ocellus.h>

#include "base/camera_ray.h"
#include "base/int_math.h"
#include "base/trig.h"
#include "frames.h"

enum {
    SEED = 7,
    PIXELS = FRAME_WIDTH * FRAME_HEIGHT,
    ARC_POINTS = 250,
    CONE_CRACKS = 340,
    ROW_WORDS = 10
};

static uint8_t mask[PIXELS];
static uint8_t bgr[3 * PIXELS];
static uint8_t rgb[3 * PIXELS];
static uint8_t rgb565[2 * PIXELS];
static uint8_t yuyv[2 * PIXELS];
static uint8_t gray[PIXELS];
static uint32_t rows_plain[ROW_WORDS * FRAME_HEIGHT];
static uint32_t rows_salt[ROW_WORDS * FRAME_HEIGHT];
static uint32_t rows_checkerboard[ROW_WORDS * FRAME_HEIGHT];
static uint32_t row_out[ROW_WORDS];

static ocel_colour_table_t table;
static ocel_colour_t colour;
static ocel_labeller_t labeller;
static ocel_crack_pool_t pool;
static ocel_eye_t eye;
static ocel_teach_t teach;
static ocel_blob_t largest;
static ocel_detection_t detection;
static const ocel_crack_t *cracks;
static size_t crack_count;
static ocel_point_t points[ARC_POINTS];
static ocel_crack_t arc_cracks[ARC_POINTS];
static ocel_ellipse_t ellipse;
static ocel_crack_t cone_cracks[CONE_CRACKS];
static ocel_camera_t camera;
static ocel_cone_t cone;
static ocel_sphere_t sphere;

static const ocel_colour_range_t range_rgb = {
    OCEL_SPACE_RGB,
    {FRAME_RANGE_R_LO, FRAME_RANGE_G_LO, FRAME_RANGE_B_LO},
    {FRAME_RANGE_R_HI, FRAME_RANGE_G_HI, FRAME_RANGE_B_HI}};
static const ocel_colour_range_t range_hsv = {OCEL_SPACE_HSV, {5, 100, 150}, {45, 255, 255}};
static const ocel_colour_range_t range_gray = {OCEL_SPACE_GRAY, {100, 0, 0}, {200, 0, 0}};

static void must(ocel_status_t status, const char *what) {
    if (status != OCEL_OK) {
        (void)fprintf(stderr, "stage_cost: %s: %s\n", what, ocel_status_name(status));
        exit(1);
    }
}

/* ---- What is measured ---- */

static void colour_frame(const uint8_t *frame, size_t line_bytes) {
    for (size_t y = 0; y < FRAME_HEIGHT; y++) {
        must(ocel_colour_row(&colour, frame + y * line_bytes, line_bytes, FRAME_WIDTH, row_out),
             "colour row");
    }
}

static void label_frame(const uint32_t *rows, ocel_connectivity_t connectivity) {
    must(ocel_label_begin(&labeller, &pool, FRAME_WIDTH, FRAME_HEIGHT, connectivity), "begin");
    for (size_t y = 0; y < FRAME_HEIGHT; y++) {
        must(ocel_label_row(&labeller, &pool, rows + y * ROW_WORDS, NULL, NULL), "label row");
    }
    must(ocel_label_end(&labeller, &pool, NULL, NULL, &largest), "label end");
}

static void fit_points(ocel_fit_method_t method) {
    const ocel_fit_options_t options = {method, OCEL_PERTURB_AUTO, false};
    (void)ocel_fit_points(points, ARC_POINTS, &options, &ellipse);
}

static void fit_cracks(ocel_fit_method_t method, ocel_perturb_t perturb) {
    const ocel_fit_options_t options = {method, perturb, true};
    (void)ocel_fit_cracks(arc_cracks, ARC_POINTS, &options, &ellipse);
}

static void measure_colour_rgb565(void) {
    colour_frame(rgb565, 2U * FRAME_WIDTH);
}

static void measure_colour_rgb888(void) {
    colour_frame(rgb, 3U * FRAME_WIDTH);
}

static void measure_colour_bgr888(void) {
    colour_frame(bgr, 3U * FRAME_WIDTH);
}

static void measure_colour_bgr888_hsv(void) {
    colour_frame(bgr, 3U * FRAME_WIDTH);
}

static void measure_colour_yuyv(void) {
    colour_frame(yuyv, 2U * FRAME_WIDTH);
}

static void measure_colour_gray8(void) {
    colour_frame(gray, FRAME_WIDTH);
}

static void measure_colour_compile_rgb565(void) {
    must(ocel_colour_compile(&colour, &range_hsv, OCEL_FORMAT_RGB565, &table), "compile");
}

static void measure_teach(void) {
    ocel_colour_range_t learnt;
    must(ocel_teach_begin(&teach, OCEL_SPACE_HSV, OCEL_FORMAT_BGR888), "teach begin");
    for (size_t y = 100; y < 132; y++) {
        must(ocel_teach_line(&teach, bgr + y * 3U * FRAME_WIDTH, 3U * FRAME_WIDTH, 160U, 32U),
             "teach line");
    }
    must(ocel_teach_end(&teach, &learnt), "teach end");
}

static void measure_label_plain(void) {
    label_frame(rows_plain, OCEL_CONNECT_8);
}

static void measure_label_salt(void) {
    label_frame(rows_salt, OCEL_CONNECT_8);
}

static void measure_label_checkerboard_8(void) {
    label_frame(rows_checkerboard, OCEL_CONNECT_8);
}

static void measure_label_checkerboard_4(void) {
    label_frame(rows_checkerboard, OCEL_CONNECT_4);
}

static void measure_boundary(void) {
    must(ocel_label_boundary(&labeller, &pool, &cracks, &crack_count, NULL), "boundary");
}

static void measure_fit_boundary(void) {
    (void)ocel_fit_boundary(arc_cracks, ARC_POINTS, true, &ellipse);
}

static void measure_fit_cracks_b2ac(void) {
    fit_cracks(OCEL_FIT_B2AC, OCEL_PERTURB_AUTO);
}

static void measure_fit_cracks_lcse(void) {
    fit_cracks(OCEL_FIT_LCSE, OCEL_PERTURB_ALWAYS);
}

static void measure_fit_cracks_hyper(void) {
    fit_cracks(OCEL_FIT_HYPER, OCEL_PERTURB_AUTO);
}

static void measure_fit_points_b2ac(void) {
    fit_points(OCEL_FIT_B2AC);
}

static void measure_fit_points_hyper(void) {
    fit_points(OCEL_FIT_HYPER);
}

static void camera_rays(void) {
    int32_t xy_q28[2];
    for (size_t i = 0; i < CONE_CRACKS; i++) {
        if (!ocel_camera_normalise(&camera, cone_cracks[i].x_hpx * 32768,
                                   cone_cracks[i].y_hpx * 32768, xy_q28)) {
            must(OCEL_OUT_OF_RANGE, "camera ray");
        }
    }
}

static void measure_camera_rays(void) {
    camera_rays();
}

static void measure_camera_rays_lens(void) {
    camera_rays();
}

static void measure_cone_cracks(void) {
    must(ocel_cone_fit_cracks(&camera, cone_cracks, CONE_CRACKS, &cone), "cone");
}

static void measure_cone_outline(void) {
    must(ocel_cone_outline(&camera, &cone, &ellipse), "outline");
}

static void measure_cone_of_ellipse(void) {
    must(ocel_cone_of_ellipse(&camera, &ellipse, &cone), "cone of ellipse");
}

static void measure_sphere(void) {
    must(ocel_sphere_of_cone(&cone, 35000, &sphere), "sphere");
}

static void measure_eye_frame(void) {
    must(ocel_eye_frame(&eye, &colour, bgr, 3U * FRAME_WIDTH, &detection), "eye");
}

/* ---- What they need first ---- */

static void compile_for(const ocel_colour_range_t *range, ocel_format_t format) {
    must(
        ocel_colour_compile(&colour, range, format, (format == OCEL_FORMAT_RGB565) ? &table : NULL),
        "compile");
}

static void prepare_rgb565(void) {
    compile_for(&range_rgb, OCEL_FORMAT_RGB565);
}

static void prepare_rgb888(void) {
    compile_for(&range_rgb, OCEL_FORMAT_RGB888);
}

static void prepare_bgr888(void) {
    compile_for(&range_rgb, OCEL_FORMAT_BGR888);
}

static void prepare_bgr888_hsv(void) {
    compile_for(&range_hsv, OCEL_FORMAT_BGR888);
}

static void prepare_yuyv(void) {
    compile_for(&range_rgb, OCEL_FORMAT_YUYV);
}

static void prepare_gray8(void) {
    compile_for(&range_gray, OCEL_FORMAT_GRAY8);
}

static void prepare_boundary(void) {
    label_frame(rows_plain, OCEL_CONNECT_8);
}

/* The points of every fit: 250 cracks, evenly taken from the ball's boundary. */
static void prepare_fit(void) {
    prepare_boundary();
    measure_boundary();
    for (size_t i = 0; i < ARC_POINTS; i++) {
        arc_cracks[i] = cracks[(i * crack_count) / ARC_POINTS];
        points[i].x_px_q16 = arc_cracks[i].x_hpx * 32768;
        points[i].y_px_q16 = arc_cracks[i].y_hpx * 32768;
    }
}

/* A camera before the ball, with or without a lens, and 340 cracks. */
static void prepare_camera(int32_t k1_q24) {
    const ocel_intrinsics_t in = {.fx_px_q16 = 277 * 65536,
                                  .fy_px_q16 = 277 * 65536,
                                  .cx_px_q16 = 160 * 65536,
                                  .cy_px_q16 = 120 * 65536,
                                  .k1_q24 = k1_q24,
                                  .width = FRAME_WIDTH,
                                  .height = FRAME_HEIGHT};
    must(ocel_camera_init(&camera, &in), "camera init");
    prepare_boundary();
    measure_boundary();
    for (size_t i = 0; i < CONE_CRACKS; i++) {
        cone_cracks[i] = cracks[(i * crack_count) / CONE_CRACKS];
    }
}

static void prepare_pinhole(void) {
    prepare_camera(0);
}

static void prepare_lens(void) {
    prepare_camera(-0x400000); /* -1/4 */
}

static void prepare_cone(void) {
    prepare_pinhole();
    measure_cone_cracks();
}

static void prepare_outline(void) {
    prepare_cone();
    measure_cone_outline();
}

static void prepare_eye(void) {
    const ocel_eye_config_t config = {.width = FRAME_WIDTH, .height = FRAME_HEIGHT};
    must(ocel_eye_init(&eye, &config), "eye init");
    prepare_bgr888();
}

static void prepare_nothing(void) {
}

typedef struct {
    const char *name;
    const char *input;
    long units;
    void (*prepare)(void);
    void (*measure)(void);
} stage_t;

static const stage_t stages[] = {
    {"colour_rgb565", "frame, px", PIXELS, prepare_rgb565, measure_colour_rgb565},
    {"colour_rgb888", "frame, px", PIXELS, prepare_rgb888, measure_colour_rgb888},
    {"colour_bgr888", "frame, px", PIXELS, prepare_bgr888, measure_colour_bgr888},
    {"colour_bgr888_hsv", "frame, px", PIXELS, prepare_bgr888_hsv, measure_colour_bgr888_hsv},
    {"colour_yuyv", "frame, px", PIXELS, prepare_yuyv, measure_colour_yuyv},
    {"colour_gray8", "frame, px", PIXELS, prepare_gray8, measure_colour_gray8},
    {"colour_compile_rgb565", "table, colours", 65536, prepare_nothing,
     measure_colour_compile_rgb565},
    {"teach", "32x32 px of BGR888, HSV", 1024, prepare_nothing, measure_teach},
    {"label_plain", "frame with one ball, px", PIXELS, prepare_nothing, measure_label_plain},
    {"label_salt", "frame with 5 % salt, px", PIXELS, prepare_nothing, measure_label_salt},
    {"label_checkerboard_8", "checkerboard, 8-connected, px", PIXELS, prepare_nothing,
     measure_label_checkerboard_8},
    {"label_checkerboard_4", "checkerboard, 4-connected, px", PIXELS, prepare_nothing,
     measure_label_checkerboard_4},
    {"boundary", "disc of radius 40 px", 1, prepare_boundary, measure_boundary},
    {"fit_boundary", "cracks, closed: what the eye runs", ARC_POINTS, prepare_fit,
     measure_fit_boundary},
    {"fit_cracks_b2ac", "cracks, closed", ARC_POINTS, prepare_fit, measure_fit_cracks_b2ac},
    {"fit_cracks_lcse", "cracks, closed, always perturbed", ARC_POINTS, prepare_fit,
     measure_fit_cracks_lcse},
    {"fit_cracks_hyper", "cracks, closed", ARC_POINTS, prepare_fit, measure_fit_cracks_hyper},
    {"fit_points_b2ac", "points, the arc measured", ARC_POINTS, prepare_fit,
     measure_fit_points_b2ac},
    {"fit_points_hyper", "points, the arc measured", ARC_POINTS, prepare_fit,
     measure_fit_points_hyper},
    {"camera_rays", "cracks, a pinhole", CONE_CRACKS, prepare_pinhole, measure_camera_rays},
    {"camera_rays_lens", "cracks, a lens undone", CONE_CRACKS, prepare_lens,
     measure_camera_rays_lens},
    {"cone_cracks", "cracks, robust", CONE_CRACKS, prepare_pinhole, measure_cone_cracks},
    {"cone_outline", "one cone", 1, prepare_cone, measure_cone_outline},
    {"cone_of_ellipse", "one ellipse", 1, prepare_outline, measure_cone_of_ellipse},
    {"sphere", "one cone", 1, prepare_cone, measure_sphere},
    {"eye_frame", "frame with one ball, BGR888, px", PIXELS, prepare_eye, measure_eye_frame},
};

static void draw_frames(void) {
    frame_mask(FRAME_SALT, FRAME_WIDTH, FRAME_HEIGHT, SEED, mask);
    frame_mask_to_bits(mask, FRAME_WIDTH, FRAME_HEIGHT, rows_salt);
    frame_mask(FRAME_CHECKERBOARD, FRAME_WIDTH, FRAME_HEIGHT, SEED, mask);
    frame_mask_to_bits(mask, FRAME_WIDTH, FRAME_HEIGHT, rows_checkerboard);
    frame_draw_bgr(FRAME_PLAIN, FRAME_WIDTH, FRAME_HEIGHT, SEED, mask, bgr);
    frame_mask_to_bits(mask, FRAME_WIDTH, FRAME_HEIGHT, rows_plain);
    frame_bgr_to_rgb565(bgr, PIXELS, rgb565);
    for (size_t i = 0; i < PIXELS; i++) {
        rgb[3U * i] = bgr[3U * i + 2U];
        rgb[3U * i + 1U] = bgr[3U * i + 1U];
        rgb[3U * i + 2U] = bgr[3U * i];
        gray[i] = bgr[3U * i + 1U];
        /* Any values will do: what a pixel costs is what counts here. */
        yuyv[2U * i] = bgr[3U * i + 1U];
        yuyv[2U * i + 1U] = ((i & 1U) != 0U) ? bgr[3U * i + 2U] : bgr[3U * i];
    }
}

static double call_ns(void (*measure)(void)) {
    struct timespec begin;
    struct timespec end;
    (void)timespec_get(&begin, TIME_UTC);
    measure();
    (void)timespec_get(&end, TIME_UTC);
    return 1e9 * (double)(end.tv_sec - begin.tv_sec) + (double)(end.tv_nsec - begin.tv_nsec);
}

int main(int argc, char **argv) {
    const long repeats = (argc > 1) ? strtol(argv[1], NULL, 10) : 1L;
    draw_frames();
    for (size_t s = 0; s < sizeof(stages) / sizeof(stages[0]); s++) {
        const stage_t *stage = &stages[s];
        double fastest = 0.0;
        for (long i = 0; i < repeats; i++) {
            stage->prepare();
            const double ns = call_ns(stage->measure);
            fastest = ((i == 0) || (ns < fastest)) ? ns : fastest;
        }
        (void)printf("%s;%s;%ld;%.0f\n", stage->name, stage->input, stage->units, fastest);
    }
    return 0;
}
