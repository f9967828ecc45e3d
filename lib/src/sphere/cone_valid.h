/* SPDX-License-Identifier: MIT
 *
 * What every function asks of a cone that it is given.
 */
#ifndef OCELLUS_CONE_VALID_H
#define OCELLUS_CONE_VALID_H

#include <stdbool.h>
#include <stdint.h>

#include <ocellus/cone.h>

#include "../base/int_math.h"

#define OCEL_ONE_Q30 0x40000000U

/* True when it has an angle, and an axis whose components can be a unit vector's. */
static inline bool ocel_cone_is_valid(const ocel_cone_t *cone) {
    bool valid = (cone->sin_q30 >= 1U) && (cone->sin_q30 <= OCEL_ONE_Q30);

    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 */
        valid = valid && (ocel_abs64(cone->axis_cam_q30[i]) <= OCEL_ONE_Q30);
    }
    return valid;
}

#endif
