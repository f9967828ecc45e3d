/* SPDX-License-Identifier: MIT */
#include "cone_plane.h"

#include "../base/int_math.h"

/* A and B are within 3. */
#define SLOPE_MAX_Q28 ((uint64_t)12287U << 16U)

/* T between 1/16 and 3. */
#define T2_MIN_Q48 ((int64_t)0x10000000000)
#define T2_MAX_Q48 ((int64_t)0x9000000000000)

/* With slopes within 3 C is within 23. */
bool ocel_cone_plane(const int64_t abc[3], const ocel_cone_place_t *place,
                     ocel_cone_plane_t *plane) {
    bool valid = (ocel_abs64(abc[0]) <= SLOPE_MAX_Q28) && (ocel_abs64(abc[1]) <= SLOPE_MAX_Q28);

    if (valid) {
        const uint32_t h2_log2 = 2U * place->spread_log2; /* 28 at most */
        const int32_t a_q28 = (int32_t)abc[0];
        const int32_t b_q28 = (int32_t)abc[1];
        const int32_t c_q25 = (int32_t)abc[2];
        const int_fast32_t a_q24 = ocel_asr32(a_q28, 4U);
        const int_fast32_t b_q24 = ocel_asr32(b_q28, 4U);
        const int_fast32_t c_q24 = ocel_asr32(c_q25, 1U);
        const int64_t t2_q48 = ((int64_t)a_q24 * a_q24) + ((int64_t)b_q24 * b_q24) +
                               ((int64_t)c_q25 * 0x1000000) -
                               ocel_asr64((int64_t)c_q24 * c_q24, h2_log2);

        valid = (ocel_asr32(c_q25, h2_log2) < 0x1000000) && (t2_q48 >= T2_MIN_Q48) &&
                (t2_q48 <= T2_MAX_Q48);
        if (valid) {
            plane->a_q28 = a_q28;
            plane->b_q28 = b_q28;
            plane->c_q25 = c_q25;
            plane->a_q12 = (int16_t)ocel_asr32(a_q28, 16U);
            plane->b_q12 = (int16_t)ocel_asr32(b_q28, 16U);
            plane->t2_q48 = t2_q48;
        }
    }
    return valid;
}

/* With T^2 = m 4^e, m in [1, 4), T is the line (m + 2) / 3 raised by half its sag.  T^2 is
 * T2_MIN_Q48 at least; the 1 tells a compiler that it is not 0. */
static uint32_t rough_size_q12(const ocel_cone_plane_t *plane) {
    const uint32_t t2 = (uint32_t)ocel_asr64(plane->t2_q48, 24U);
    const uint32_t e = (31U - ocel_clz32(t2 | 1U)) / 2U; /* 8 .. 13 */

    return (((t2 >> e) + ((uint32_t)2U << e)) * 22459U) >> 16U;
}

int32_t ocel_cone_gate_q25(const ocel_cone_plane_t *plane, const ocel_cone_place_t *place,
                           uint32_t px_q16) {
    const uint64_t r_q25 =
        ((((uint64_t)rough_size_q12(plane) * place->pixel_q25) >> 12U) * px_q16) >> 16U;

    return (int32_t)r_q25;
}
