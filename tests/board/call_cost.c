/* SPDX-License-Identifier: MIT
 *
 * What one call costs on this board: every public function, and every stage on
 * the standard frames, by the port's counter.  Prints one CSV line each:
 *
 *   function,input,units,count
 *
 * after a line `unit,<what is counted>`.  An empty call's count is taken off.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <ocellus/ocellus.h>

#include "frames.h"
#include "port.h"

enum { SEED = 7, PIXELS = FRAME_WIDTH * FRAME_HEIGHT, POINTS = 250, ROW_WORDS = 10 };

static uint8_t mask[PIXELS];
static uint8_t bgr[3 * PIXELS];
static uint8_t frame[3 * PIXELS]; /* in the format at hand */
static uint32_t rows[ROW_WORDS * FRAME_HEIGHT];

static ocel_colour_table_t table;
static ocel_colour_t colour;
static ocel_labeller_t labeller;
static ocel_crack_pool_t pool;
static ocel_eye_t eye;
static ocel_teach_t teach;
static ocel_colour_range_t learnt;
static ocel_blob_t largest;
static ocel_detection_t detection;
static ocel_ellipse_t ellipse;
static ocel_camera_t camera;
static ocel_camera_t lens_camera;
static ocel_cone_t cone;
static ocel_cone_t cone_right;
static ocel_sphere_t sphere;
static ocel_pose_t eyes[OCEL_EYE_COUNT];
static ocel_ball_t ball;
static ocel_tracker_t tracker;
static ocel_track_t track;
static ocel_gaze_t gaze;
static ocel_gaze_error_t errors[OCEL_EYE_COUNT];
static int32_t command[OCEL_JOINT_COUNT];
static int32_t vector[3];
static ocel_point_t points[POINTS];
static ocel_crack_t cracks[POINTS];
static const ocel_crack_t *boundary;
static size_t boundary_count;

static const int32_t joints[OCEL_JOINT_COUNT] = {50000000,  -20000000, 90000000,
                                                 -30000000, 40000000,  110000000};
static const ocel_point_t pixel = {101 * 65536 + 777, 77 * 65536 + 333};
static const int32_t point_u[3] = {-40000, 55000, 400000};

static const ocel_colour_range_t range_rgb = {
    OCEL_SPACE_RGB,
    {FRAME_RANGE_R_LO, FRAME_RANGE_G_LO, FRAME_RANGE_B_LO},
    {FRAME_RANGE_R_HI, FRAME_RANGE_G_HI, FRAME_RANGE_B_HI}};
static const ocel_colour_range_t range_hsv = {OCEL_SPACE_HSV, {5, 100, 150}, {45, 255, 255}};

static ocel_port_counter_t counter;
static uint64_t empty_ticks;

static void must(ocel_status_t status, const char *what) {
    if (status != OCEL_OK) {
        printf("call_cost: %s: %s\n", what, ocel_status_name(status));
        exit(1);
    }
}

/* ---- Measuring ---- */

static uint64_t ticks_of(void (*call)(void)) {
    const uint64_t begin = ocel_port_ticks();
    call();
    return ocel_port_ticks() - begin;
}

static void nothing(void) {
}

static void measure(const char *function, const char *input, long units, void (*call)(void)) {
    const uint64_t ticks = ticks_of(call);
    const uint64_t more = (ticks > empty_ticks) ? (ticks - empty_ticks) : 0U;
    printf("%s,%s,%ld,%llu\n", function, input, units,
           (unsigned long long)(more * counter.mul / counter.div));
}

/* ---- Frames ---- */

static void to_format(ocel_format_t format) {
    for (size_t i = 0; i < PIXELS; i++) {
        const uint8_t *p = &bgr[3U * i];
        const unsigned v =
            ((unsigned)(p[2] >> 3) << 11) | ((unsigned)(p[1] >> 2) << 5) | (unsigned)(p[0] >> 3);
        switch (format) {
        case OCEL_FORMAT_RGB565:
            frame[2U * i] = (uint8_t)v;
            frame[2U * i + 1U] = (uint8_t)(v >> 8);
            break;
        case OCEL_FORMAT_YUYV: /* any values will do: the cost is a pixel's */
            frame[2U * i] = p[1];
            frame[2U * i + 1U] = p[((i & 1U) != 0U) ? 2 : 0];
            break;
        case OCEL_FORMAT_GRAY8:
            frame[i] = p[1];
            break;
        default:
            frame[3U * i] = p[(format == OCEL_FORMAT_BGR888) ? 0 : 2];
            frame[3U * i + 1U] = p[1];
            frame[3U * i + 2U] = p[(format == OCEL_FORMAT_BGR888) ? 2 : 0];
            break;
        }
    }
}

static void draw(frame_kind_t kind) {
    frame_draw_bgr(kind, FRAME_WIDTH, FRAME_HEIGHT, SEED, mask, bgr);
    frame_mask_to_bits(mask, FRAME_WIDTH, FRAME_HEIGHT, rows);
}

static size_t line_bytes(void) {
    return ocel_colour_line_bytes(colour.format, FRAME_WIDTH);
}

/* ---- Colour ---- */

static void call_compile_rgb565(void) {
    must(ocel_colour_compile(&colour, &range_rgb, OCEL_FORMAT_RGB565, &table), "compile");
}

static void call_compile_bgr888(void) {
    must(ocel_colour_compile(&colour, &range_rgb, OCEL_FORMAT_BGR888, NULL), "compile");
}

static void call_colour_rows(void) {
    uint32_t row[ROW_WORDS];
    for (size_t y = 0; y < FRAME_HEIGHT; y++) {
        must(ocel_colour_row(&colour, frame + y * line_bytes(), line_bytes(), FRAME_WIDTH, row),
             "row");
    }
}

static void call_table_rows(void) {
    uint32_t row[ROW_WORDS];
    for (size_t y = 0; y < FRAME_HEIGHT; y++) {
        must(ocel_colour_table_row(&table, frame + y * 2U * FRAME_WIDTH, 2U * FRAME_WIDTH,
                                   FRAME_WIDTH, row),
             "row");
    }
}

static void call_teach_line(void) {
    must(ocel_teach_line(&teach, frame, sizeof(frame), 0U, FRAME_WIDTH), "teach");
}

static void call_teach_end(void) {
    must(ocel_teach_end(&teach, &learnt), "teach");
}

static void measure_colour(void) {
    static const char *const names[5] = {"rgb565", "rgb888", "bgr888", "yuyv", "gray8"};
    draw(FRAME_PLAIN);
    measure("ocel_colour_compile", "rgb565", 65536, call_compile_rgb565);
    measure("ocel_colour_compile", "bgr888", 1, call_compile_bgr888);
    for (int format = 0; format < 5; format++) {
        to_format((ocel_format_t)format);
        must(ocel_colour_compile(&colour, &range_rgb, (ocel_format_t)format,
                                 (format == 0) ? &table : NULL),
             "compile");
        measure("ocel_colour_row", names[format], PIXELS, call_colour_rows);
        if (format == 0) {
            measure("ocel_colour_table_row", "rgb565", PIXELS, call_table_rows);
        }
    }
    to_format(OCEL_FORMAT_BGR888);
    must(ocel_colour_compile(&colour, &range_hsv, OCEL_FORMAT_BGR888, NULL), "compile");
    measure("ocel_colour_row", "bgr888 by hsv", PIXELS, call_colour_rows);
    must(ocel_teach_begin(&teach, OCEL_SPACE_HSV, OCEL_FORMAT_BGR888), "teach");
    measure("ocel_teach_line", "bgr888 for hsv", FRAME_WIDTH, call_teach_line);
    measure("ocel_teach_end", "hsv", 1, call_teach_end);
}

/* ---- Labelling and the eye ---- */

static ocel_connectivity_t connectivity;

static void call_label(void) {
    must(ocel_label_begin(&labeller, &pool, FRAME_WIDTH, FRAME_HEIGHT, connectivity), "begin");
    for (size_t y = 0; y < FRAME_HEIGHT; y++) {
        must(ocel_label_row(&labeller, &pool, rows + y * ROW_WORDS, NULL, NULL), "row");
    }
    (void)ocel_label_end(&labeller, &pool, NULL, NULL, &largest);
}

static void call_boundary(void) {
    must(ocel_label_boundary(&labeller, &pool, &boundary, &boundary_count, NULL), "boundary");
}

static void call_centroid(void) {
    ocel_blob_centroid(&largest, &vector[0], &vector[1]);
}

static void call_eye_frame(void) {
    (void)ocel_eye_frame(&eye, &colour, frame, line_bytes(), &detection);
}

/* What a firmware with a const table runs: every line, and the end. */
static void call_eye_rows(void) {
    uint32_t row[ROW_WORDS];
    must(ocel_eye_begin(&eye), "begin");
    for (uint16_t y = 0; y < FRAME_HEIGHT; y++) {
        (void)ocel_colour_table_row(&table, frame + (size_t)y * 2U * FRAME_WIDTH, 2U * FRAME_WIDTH,
                                    FRAME_WIDTH, row);
        must(ocel_eye_row(&eye, y, row), "row");
    }
    (void)ocel_eye_end(&eye, &detection);
}

static void call_eye_end(void) {
    (void)ocel_eye_end(&eye, &detection);
}

static void call_eye_refit(void) {
    const ocel_fit_options_t options = {OCEL_FIT_HYPER, OCEL_PERTURB_AUTO, false};
    must(ocel_eye_refit(&eye, &options, &detection), "refit");
}

static void call_eye_cone(void) {
    (void)ocel_eye_cone(&eye, &camera, &detection, &cone);
}

static void call_sphere(void) {
    must(ocel_sphere_of_cone(&cone, 35000, &sphere), "sphere");
}

static void call_to_sphere(void) {
    call_eye_frame();
    call_eye_cone();
    call_sphere();
}

/* Everything but the end, so that the end can be measured by itself. */
static void prepare_eye_end(void) {
    must(ocel_eye_begin(&eye), "begin");
    for (uint16_t y = 0; y < FRAME_HEIGHT; y++) {
        must(ocel_eye_row(&eye, y, rows + (size_t)y * ROW_WORDS), "row");
    }
}

static void measure_eye(void) {
    const ocel_eye_config_t config = {.width = FRAME_WIDTH, .height = FRAME_HEIGHT};
    must(ocel_eye_init(&eye, &config), "init");
    call_compile_rgb565();
    for (int kind = 0; kind < (int)FRAME_KINDS; kind++) {
        draw((frame_kind_t)kind);
        to_format(OCEL_FORMAT_RGB565);
        connectivity = OCEL_CONNECT_8;
        measure("ocel_label", frame_name((frame_kind_t)kind), PIXELS, call_label);
        if (kind == (int)FRAME_PLAIN) {
            measure("ocel_label_boundary", "plain", 1, call_boundary);
            measure("ocel_blob_centroid", "plain", 1, call_centroid);
        }
        connectivity = OCEL_CONNECT_4;
        if (kind == (int)FRAME_CHECKERBOARD) {
            measure("ocel_label", "checkerboard; 4-connected", PIXELS, call_label);
        }
        measure("ocel_eye_frame", frame_name((frame_kind_t)kind), PIXELS, call_eye_frame);
    }
    draw(FRAME_PLAIN);
    to_format(OCEL_FORMAT_RGB565);
    measure("ocel_eye_row", "plain by a const table; with the end", PIXELS, call_eye_rows);
    prepare_eye_end();
    measure("ocel_eye_end", "plain", 1, call_eye_end);
    measure("ocel_eye_refit", "plain; hyper", 1, call_eye_refit);
    measure("ocel_eye_cone", "plain", 1, call_eye_cone);
    measure("ocel_sphere_of_cone", "plain", 1, call_sphere);
    measure("frame to sphere", "plain rgb565", PIXELS, call_to_sphere);
}

/* ---- Fits ---- */

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

static void measure_fits(void) {
    static const char *const names[3] = {"b2ac", "lcse", "hyper"};
    draw(FRAME_PLAIN);
    connectivity = OCEL_CONNECT_8;
    call_label();
    call_boundary();
    for (size_t i = 0; i < POINTS; i++) {
        cracks[i] = boundary[(i * boundary_count) / POINTS];
        points[i].x_px_q16 = cracks[i].x_hpx * 32768;
        points[i].y_px_q16 = cracks[i].y_hpx * 32768;
    }
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

/* ---- Space ---- */

static void call_camera_init(void) {
    static const ocel_intrinsics_t pinhole = {
        277 * 65536, 277 * 65536, 10452992, 7831552, 0, 0, 0, 0, 0, FRAME_WIDTH, FRAME_HEIGHT};
    must(ocel_camera_init(&camera, &pinhole), "camera");
}

static void call_lens_init(void) {
    static const ocel_intrinsics_t lens = {277 * 65536, 277 * 65536, 10452992,    7831552,
                                           -1677722,    335544,      16777,       -8389,
                                           0,           FRAME_WIDTH, FRAME_HEIGHT};
    must(ocel_camera_init(&lens_camera, &lens), "camera");
}

static void call_ray(void) {
    must(ocel_camera_ray(&camera, &pixel, vector), "ray");
}

static void call_lens_ray(void) {
    must(ocel_camera_ray(&lens_camera, &pixel, vector), "ray");
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

static void measure_space(void) {
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

/* ---- The head ---- */

static void call_forward(void) {
    must(ocel_head_forward(&ocel_head_icub_v2, joints, eyes), "forward");
}

static void call_middle(void) {
    ocel_pose_t middle;
    must(ocel_head_middle(&ocel_head_icub_v2, joints, &middle), "middle");
}

static void call_place(void) {
    must(ocel_head_place(&eyes[OCEL_LEFT], point_u, vector), "place");
}

/* Two rays that meet in point_u, 68000 u apart where they begin. */
static ocel_ray_t ray_left;
static ocel_ray_t ray_right;

static void look_at_point(ocel_ray_t *ray, int32_t begin_x) {
    const int32_t p[3] = {point_u[0] - begin_x, point_u[1], point_u[2]};
    ocel_point_t seen;
    must(ocel_camera_project(&camera, p, &seen), "project");
    must(ocel_camera_ray(&camera, &seen, ray->d_q30), "ray");
    ray->p_u[0] = begin_x;
}

static void call_midpoint(void) {
    ocel_midpoint_t middle;
    must(ocel_stereo_midpoint(&ray_left, &ray_right, &middle), "midpoint");
}

static void call_encoders(void) {
    static const int32_t residual[OCEL_EYE_COUNT] = {1000000, -2000000};
    must(ocel_stereo_encoders(OCEL_ENCODERS_EXACT, 68000, 40000000, 110000000, residual, vector),
         "encoders");
}

static void call_ball(void) {
    (void)ocel_stereo_ball(&cone, &cone_right, eyes, 35000, &ball);
}

static const ocel_tracker_config_t tracker_config = {500000U,     2000000, 300000,
                                                     4U * 65536U, 20000,   {0, 0, 0}};
static int64_t now_us;

static void call_tracker_init(void) {
    must(ocel_tracker_init(&tracker, &tracker_config), "tracker");
}

static void call_update(void) {
    const ocel_estimate_t seen = {{100000 + (int32_t)(now_us / 10), 200000, 300000},
                                  {250000, 1000, 1000, 250000, 1000, 250000}};
    now_us += 33333;
    must(ocel_tracker_update(&tracker, now_us, &seen, &track), "update");
}

static void call_update_unseen(void) {
    now_us += 33333;
    (void)ocel_tracker_update(&tracker, now_us, NULL, &track);
}

static void call_roi(void) {
    ocel_rect_t roi;
    (void)ocel_tracker_roi(&track, &eyes[OCEL_LEFT], &camera, 35000, &roi);
}

static void call_gaze_init(void) {
    must(ocel_gaze_init(&gaze, &ocel_head_icub_v2, &ocel_gaze_icub), "gaze");
}

static void call_gaze_error(void) {
    must(ocel_gaze_error(point_u, &errors[OCEL_LEFT]), "error");
}

static void call_gaze_update(void) {
    now_us += 33333;
    must(ocel_gaze_update(&gaze, now_us, errors, joints, command), "gaze");
}

static void measure_head(void) {
    /* The same ball for both eyes, which converge on it. */
    cone_right = cone;
    look_at_point(&ray_left, 0);
    look_at_point(&ray_right, 68000);
    measure("ocel_head_forward", "icub v2", 1, call_forward);
    measure("ocel_head_middle", "icub v2", 1, call_middle);
    measure("ocel_head_place", "a point", 1, call_place);
    measure("ocel_stereo_midpoint", "two rays", 1, call_midpoint);
    measure("ocel_stereo_encoders", "exact", 1, call_encoders);
    measure("ocel_stereo_ball", "two cones", 1, call_ball);
    measure("ocel_tracker_init", "", 1, call_tracker_init);
    call_update();
    call_update();
    measure("ocel_tracker_update", "seen", 1, call_update);
    measure("ocel_tracker_update", "not seen", 1, call_update_unseen);
    measure("ocel_tracker_roi", "", 1, call_roi);
    measure("ocel_gaze_init", "icub v2", 1, call_gaze_init);
    measure("ocel_gaze_error", "a direction", 1, call_gaze_error);
    errors[OCEL_RIGHT] = errors[OCEL_LEFT];
    call_gaze_update();
    measure("ocel_gaze_update", "both eyes see", 1, call_gaze_update);
}

int main(void) {
    counter = ocel_port_start();
    (void)ticks_of(nothing);
    empty_ticks = ticks_of(nothing);
    printf("unit,%s\n", counter.unit);
    call_camera_init(); /* ocel_eye_cone takes it */
    measure_colour();
    measure_eye();
    measure_fits();
    measure_space();
    measure_head();
    return 0;
}
