/* SPDX-License-Identifier: MIT
 *
 * Calls of label.h and eye.h, the sphere of a cone, and the stages that a firmware
 * runs them as.
 */
#include "calls.h"

enum { HALF = FRAME_HEIGHT / 2 };

static ocel_labeller_t labeller;
static ocel_crack_pool_t pool;
static ocel_blob_t largest;
static ocel_label_stats_t stats;
static int32_t centroid[2];
static const ocel_crack_t *boundary;
static size_t boundary_count;
static ocel_connectivity_t connectivity;

/* ---- Labelling ---- */

static void call_label_begin(void) {
    must(ocel_label_begin(&labeller, &pool, FRAME_WIDTH, FRAME_HEIGHT, connectivity), "begin");
}

/* Rows up to y_end, which is not labelled. */
static void label_rows(size_t y_end) {
    for (size_t y = 0; y < y_end; y++) {
        must(ocel_label_row(&labeller, &pool, rows + y * ROW_WORDS, NULL, NULL), "row");
    }
}

static void call_label_row(void) {
    must(ocel_label_row(&labeller, &pool, rows + (size_t)HALF * ROW_WORDS, NULL, NULL), "row");
}

static void call_label_end(void) {
    (void)ocel_label_end(&labeller, &pool, NULL, NULL, &largest);
}

static void call_label(void) {
    call_label_begin();
    label_rows(FRAME_HEIGHT);
    call_label_end();
}

static void call_boundary(void) {
    must(ocel_label_boundary(&labeller, &pool, &boundary, &boundary_count, NULL), "boundary");
}

static void call_stats(void) {
    stats = ocel_label_stats(&labeller);
}

static void call_centroid(void) {
    ocel_blob_centroid(&largest, &centroid[0], &centroid[1]);
}

/* A row after half a frame, and the end after all of it. */
static void measure_label_calls(frame_kind_t kind) {
    call_label_begin();
    label_rows(HALF);
    measure("ocel_label_row", frame_name(kind), FRAME_WIDTH, call_label_row);
    call_label_begin();
    label_rows(FRAME_HEIGHT);
    measure("ocel_label_end", frame_name(kind), 1, call_label_end);
}

/* What every fit is measured on: cracks of the plain frame's boundary, evenly taken. */
static void keep_points(void) {
    for (size_t i = 0; i < POINTS; i++) {
        cracks[i] = boundary[(i * boundary_count) / POINTS];
        points[i].x_px_q16 = cracks[i].x_hpx * 32768;
        points[i].y_px_q16 = cracks[i].y_hpx * 32768;
    }
}

void measure_label(void) {
    connectivity = OCEL_CONNECT_8;
    measure("ocel_label_begin", "", 1, call_label_begin);
    for (int kind = 0; kind < (int)FRAME_KINDS; kind++) {
        const char *const name = frame_name((frame_kind_t)kind);
        draw((frame_kind_t)kind);
        connectivity = OCEL_CONNECT_8;
        measure_label_calls((frame_kind_t)kind);
        measure("label a frame", name, PIXELS, call_label);
        if (kind == (int)FRAME_PLAIN) {
            measure("ocel_label_boundary", name, 1, call_boundary);
            measure("ocel_label_stats", "", 1, call_stats);
            measure("ocel_blob_centroid", name, 1, call_centroid);
            keep_points();
        }
        if (kind == (int)FRAME_CHECKERBOARD) {
            connectivity = OCEL_CONNECT_4;
            measure("label a frame", "checkerboard; 4-connected", PIXELS, call_label);
        }
    }
}

/* ---- The eye ---- */

static ocel_eye_t eye;
static ocel_detection_t detection;
static ocel_sphere_t sphere;
static uint16_t next_y;

static const uint8_t *line_at(uint16_t y) {
    return frame + (size_t)y * 2U * FRAME_WIDTH;
}

static void call_eye_init(void) {
    static const ocel_eye_config_t config = {.width = FRAME_WIDTH, .height = FRAME_HEIGHT};
    must(ocel_eye_init(&eye, &config), "init");
}

static void call_eye_begin(void) {
    must(ocel_eye_begin(&eye), "begin");
}

static void call_eye_row(void) {
    must(ocel_eye_row(&eye, next_y, rows + (size_t)next_y * ROW_WORDS), "row");
}

static void call_eye_line(void) {
    must(ocel_eye_line(&eye, &colour, next_y, line_at(next_y), (size_t)2U * FRAME_WIDTH), "line");
}

static void eye_rows_to(uint16_t y_end) {
    call_eye_begin();
    for (next_y = 0; next_y < y_end; next_y++) {
        call_eye_row();
    }
}

static void call_eye_end(void) {
    (void)ocel_eye_end(&eye, &detection);
}

static void call_eye_boundary(void) {
    boundary = ocel_eye_boundary(&eye, &boundary_count);
}

static void call_eye_refit(void) {
    static const ocel_fit_options_t options = {OCEL_FIT_HYPER, OCEL_PERTURB_AUTO, false};
    must(ocel_eye_refit(&eye, &options, &detection), "refit");
}

static void call_eye_cone(void) {
    (void)ocel_eye_cone(&eye, &camera, &detection, &cone);
}

static void call_eye_lens(void) {
    ocel_cone_t other;
    (void)ocel_eye_cone(&eye, &lens_camera, &detection, &other);
}

static void call_sphere(void) {
    must(ocel_sphere_of_cone(&cone, 35000, &sphere), "sphere");
}

static void call_eye_frame(void) {
    (void)ocel_eye_frame(&eye, &colour, frame, (size_t)2U * FRAME_WIDTH, &detection);
}

/* ---- Stages ---- */

/* What a firmware with a const table runs: every line, and the end. */
static void call_by_table(void) {
    uint32_t row[ROW_WORDS];
    call_eye_begin();
    for (uint16_t y = 0; y < FRAME_HEIGHT; y++) {
        (void)ocel_colour_table_row(&table, line_at(y), (size_t)2U * FRAME_WIDTH, FRAME_WIDTH, row);
        must(ocel_eye_row(&eye, y, row), "row");
    }
    call_eye_end();
}

static void call_to_sphere(void) {
    call_eye_frame();
    call_eye_cone();
    call_sphere();
}

static void measure_eye_calls(frame_kind_t kind) {
    eye_rows_to(HALF);
    measure("ocel_eye_row", frame_name(kind), FRAME_WIDTH, call_eye_row);
    next_y++;
    measure("ocel_eye_line", frame_name(kind), FRAME_WIDTH, call_eye_line);
    eye_rows_to(FRAME_HEIGHT);
    measure("ocel_eye_end", frame_name(kind), 1, call_eye_end);
    measure("ocel_eye_frame", frame_name(kind), PIXELS, call_eye_frame);
}

void measure_eye(void) {
    measure("ocel_eye_init", "", 1, call_eye_init);
    measure("ocel_eye_begin", "", 1, call_eye_begin);
    call_compile_rgb565();
    call_camera_init(); /* ocel_eye_cone takes them */
    call_lens_init();
    for (int kind = (int)FRAME_KINDS - 1; kind >= 0; kind--) { /* the plain one last */
        draw((frame_kind_t)kind);
        to_format(OCEL_FORMAT_RGB565);
        measure_eye_calls((frame_kind_t)kind);
    }
    measure("ocel_eye_boundary", "plain", 1, call_eye_boundary);
    measure("ocel_eye_refit", "plain; hyper", 1, call_eye_refit);
    measure("ocel_eye_cone", "plain", 1, call_eye_cone);
    measure("ocel_eye_cone", "plain; lens", 1, call_eye_lens);
    measure("ocel_sphere_of_cone", "plain", 1, call_sphere);
    measure("frame to ellipse by a const table", "plain", PIXELS, call_by_table);
    measure("frame to sphere", "plain", PIXELS, call_to_sphere);
}
