// SPDX-License-Identifier: MIT
//
// A firmware in C++: one translation unit that includes the header and looks for
// the ball in space, beside the library's files compiled as C.
#include <ocellus/ocellus.h>

#include "../frame.h"

extern "C" {
#include "port.h"
}

namespace {

class Finder {
  public:
    bool begin() {
        const ocel_colour_range_t orange = {OCEL_SPACE_RGB, {200, 60, 0}, {255, 150, 80}};
        ocel_eye_config_t config{};
        ocel_intrinsics_t lens{};
        config.width = FRAME_WIDTH;
        config.height = FRAME_HEIGHT;
        lens.fx_px_q16 = lens.fy_px_q16 = 60 * 65536;
        lens.cx_px_q16 = FRAME_WIDTH * 32768;
        lens.cy_px_q16 = FRAME_HEIGHT * 32768;
        return ocel_colour_compile(&colour_, &orange, OCEL_FORMAT_RGB565, &table_) == OCEL_OK &&
               ocel_eye_init(&eye_, &config) == OCEL_OK &&
               ocel_camera_init(&camera_, &lens) == OCEL_OK;
    }

    ocel_status_t look(const uint16_t *pixels, ocel_sphere_t &ball) {
        ocel_detection_t seen;
        ocel_cone_t cone;
        ocel_status_t status = ocel_eye_frame(
            &eye_, &colour_, reinterpret_cast<const uint8_t *>(pixels), 2U * FRAME_WIDTH, &seen);
        if (status == OCEL_OK) {
            status = ocel_eye_cone(&eye_, &camera_, &seen, &cone);
        }
        return status == OCEL_OK ? ocel_sphere_of_cone(&cone, 35000, &ball) : status;
    }

  private:
    ocel_eye_t eye_;
    ocel_colour_table_t table_;
    ocel_colour_t colour_;
    ocel_camera_t camera_;
};

Finder finder;

} // namespace

int main() {
    ocel_sphere_t ball{};
    const ocel_status_t status = finder.begin() ? finder.look(frame_pixels, ball) : OCEL_BAD_OPTION;
    ocel_port_write(ocel_status_name(status));
    ocel_port_write("\n");
    // 35 mm at 10.5 px of 60: about 200 mm away.
    return status == OCEL_OK && ball.p_cam_u[2] > 190000 && ball.p_cam_u[2] < 215000 ? 0 : 1;
}
