/* SPDX-License-Identifier: MIT
 *
 * A firmware in C that takes lib/ with add_subdirectory: a frame in flash, the
 * ball's place as the exit code (0: found where it is).
 */
#include <ocellus/ocellus.h>
#include <stdlib.h>

#include "../frame.h"
#include "port.h"

static ocel_eye_t eye;
static ocel_colour_table_t table;

static bool near(int32_t a, int32_t b) {
    return abs(a - b) < 16384; /* a quarter of a pixel */
}

int main(void) {
    const ocel_colour_range_t orange = {OCEL_SPACE_RGB, {200, 60, 0}, {255, 150, 80}};
    const ocel_eye_config_t config = {.width = FRAME_WIDTH, .height = FRAME_HEIGHT};
    ocel_colour_t colour;
    ocel_detection_t ball;

    if ((ocel_colour_compile(&colour, &orange, OCEL_FORMAT_RGB565, &table) != OCEL_OK) ||
        (ocel_eye_init(&eye, &config) != OCEL_OK)) {
        return 2;
    }
    const ocel_status_t status =
        ocel_eye_frame(&eye, &colour, (const uint8_t *)frame_pixels, 2U * FRAME_WIDTH, &ball);
    ocel_port_write(ocel_status_name(status));
    ocel_port_write("\n");
    return ((status == OCEL_OK) && near(ball.ellipse.cx_px_q16, FRAME_BALL_CX_Q16) &&
            near(ball.ellipse.cy_px_q16, FRAME_BALL_CY_Q16) &&
            near(ball.ellipse.a_px_q16, FRAME_BALL_RADIUS_Q16))
               ? 0
               : 1;
}
