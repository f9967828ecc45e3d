/* SPDX-License-Identifier: MIT
 *
 * What one call takes on this board: every public function and every stage, on
 * stated inputs.  Built as call_cost the calls are counted, built with CALLS_STACK as
 * call_stack each runs on a painted stack; the calls are the same.
 */
#ifndef BOARD_CALLS_H
#define BOARD_CALLS_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <ocellus/ocellus.h>

#include "frames.h"

enum { SEED = 7, PIXELS = FRAME_WIDTH * FRAME_HEIGHT, POINTS = 250, ROW_WORDS = 10 };

/* Runs call() and prints a line of it; `units` is what its cost may be divided by.  A
 * call makes its one call of the library (or those of its stage) and nothing else. */
#define measure(function, input, units, call)                                                      \
    measure_call((function), (input), (units), (call), #call)
void measure_call(const char *function, const char *input, long units, void (*call)(void),
                  const char *name);

/* Ends the program unless the status is OCEL_OK. */
void must(ocel_status_t status, const char *what);

/* ---- The frame in hand, drawn by draw() ---- */

extern uint8_t frame[3 * PIXELS]; /* in the format of the last to_format() */
extern uint32_t rows[ROW_WORDS * FRAME_HEIGHT];
extern const ocel_colour_range_t range_rgb;

void draw(frame_kind_t kind);
void to_format(ocel_format_t format);

/* ---- What one group leaves for the next ---- */

extern ocel_colour_table_t table; /* of range_rgb, by call_compile_rgb565() */
extern ocel_colour_t colour;
extern ocel_camera_t camera;        /* by call_camera_init() */
extern ocel_camera_t lens_camera;   /* by call_lens_init() */
extern ocel_crack_t cracks[POINTS]; /* of the plain frame's boundary */
extern ocel_point_t points[POINTS]; /* the same */
extern ocel_ellipse_t ellipse;
extern ocel_cone_t cone;
extern const int32_t point_u[3]; /* a point in front of the camera */

void call_compile_rgb565(void);
void call_camera_init(void);
void call_lens_init(void);

/* ---- The groups, in this order ---- */

void measure_small(void);
void measure_colour(void);
void measure_label(void);
void measure_eye(void);
void measure_fits(void);
void measure_space(void);
void measure_head(void);

#endif
