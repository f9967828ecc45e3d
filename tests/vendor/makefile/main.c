/* SPDX-License-Identifier: MIT
 *
 * A firmware in C that compiles lib/sources.txt in its own Makefile.  Lines come one
 * by one, as from a camera, and the table of colours alone tests them.
 */
#include <ocellus/ocellus.h>
#include <stdlib.h>

#include "../frame.h"
#include "port.h"

static ocel_eye_t eye;
static ocel_colour_table_t table;

static void make_table(void) {
    const ocel_colour_range_t orange = {OCEL_SPACE_RGB, {200, 60, 0}, {255, 150, 80}};
    ocel_colour_t colour;
    (void)ocel_colour_compile(&colour, &orange, OCEL_FORMAT_RGB565, &table);
}

static void take_line(uint16_t y) {
    uint32_t row[OCEL_ROW_WORDS];
    const uint8_t *line = (const uint8_t *)&frame_pixels[y * FRAME_WIDTH];
    (void)ocel_colour_table_row(&table, line, 2U * FRAME_WIDTH, FRAME_WIDTH, row);
    (void)ocel_eye_row(&eye, y, row);
}

int main(void) {
    const ocel_eye_config_t config = {.width = FRAME_WIDTH, .height = FRAME_HEIGHT};
    ocel_detection_t ball;

    make_table();
    (void)ocel_eye_init(&eye, &config);
    (void)ocel_eye_begin(&eye);
    for (uint16_t y = 0; y < FRAME_HEIGHT; y++) {
        take_line(y);
    }
    const ocel_status_t status = ocel_eye_end(&eye, &ball);
    ocel_port_write(ocel_status_name(status));
    ocel_port_write("\n");
    return ((status == OCEL_OK) && (abs(ball.ellipse.cx_px_q16 - FRAME_BALL_CX_Q16) < 16384) &&
            (abs(ball.ellipse.cy_px_q16 - FRAME_BALL_CY_Q16) < 16384))
               ? 0
               : 1;
}
