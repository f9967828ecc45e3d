/* SPDX-License-Identifier: MIT
 *
 * A program on the host that found the library with find_package, and so what it
 * was installed with.
 */
#include <ocellus/ocellus.h>
#include <stdio.h>

#include "../frame.h"

int main(void) {
    static ocel_eye_t eye;
    static ocel_colour_table_t table;
    const ocel_colour_range_t orange = {OCEL_SPACE_RGB, {200, 60, 0}, {255, 150, 80}};
    const ocel_eye_config_t config = {.width = FRAME_WIDTH, .height = FRAME_HEIGHT};
    ocel_colour_t colour;
    ocel_detection_t ball;

    (void)ocel_colour_compile(&colour, &orange, OCEL_FORMAT_RGB565, &table);
    (void)ocel_eye_init(&eye, &config);
    const ocel_status_t status =
        ocel_eye_frame(&eye, &colour, (const uint8_t *)frame_pixels, 2U * FRAME_WIDTH, &ball);
    printf("%s at %.2f %.2f\n", ocel_status_name(status), ball.ellipse.cx_px_q16 / 65536.0,
           ball.ellipse.cy_px_q16 / 65536.0);
    return (status == OCEL_OK) ? 0 : 1;
}
