/* SPDX-License-Identifier: MIT
 *
 * Calls of colour.h and teach.h, and of those that are hardly more than a look.
 */
#include "calls.h"

ocel_colour_table_t table;
ocel_colour_t colour;
static ocel_teach_t teach;
static ocel_colour_range_t learnt;
static size_t bytes;
static const char *name;

static const ocel_colour_range_t range_hsv = {OCEL_SPACE_HSV, {5, 100, 150}, {45, 255, 255}};

/* ---- Small ---- */

static void call_status_name(void) {
    name = ocel_status_name(OCEL_TOO_FEW_POINTS);
}

static void call_line_bytes(void) {
    bytes = ocel_colour_line_bytes(OCEL_FORMAT_RGB565, FRAME_WIDTH);
}

void measure_small(void) {
    measure("ocel_status_name", "", 1, call_status_name);
    measure("ocel_colour_line_bytes", "rgb565", 1, call_line_bytes);
}

static size_t line_bytes(void) {
    return ocel_colour_line_bytes(colour.format, FRAME_WIDTH);
}

/* ---- Colour ---- */

void call_compile_rgb565(void) {
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

static void call_teach_begin(void) {
    must(ocel_teach_begin(&teach, OCEL_SPACE_HSV, OCEL_FORMAT_BGR888), "teach");
}

static void call_teach_line(void) {
    must(ocel_teach_line(&teach, frame, sizeof(frame), 0U, FRAME_WIDTH), "teach");
}

static void call_teach_end(void) {
    must(ocel_teach_end(&teach, &learnt), "teach");
}

void measure_colour(void) {
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
    measure("ocel_teach_begin", "hsv", 1, call_teach_begin);
    measure("ocel_teach_line", "bgr888 for hsv", FRAME_WIDTH, call_teach_line);
    measure("ocel_teach_end", "hsv", 1, call_teach_end);
}
