/* SPDX-License-Identifier: MIT */
#include "cone_samples.h"

#include "../base/int_math.h"
#include "../base/q60.h"
#include "../base/scale.h"

#define ONE_Q30 0x40000000

#define SIDE_MAX_Q13 24575U
#define E_MAX_Q13 32767

/* |side| <= SIDE_MAX_Q13, by one comparison. */
static bool is_side_within(int32_t side_q13) {
    return ((uint32_t)side_q13 + SIDE_MAX_Q13) <= (2U * SIDE_MAX_Q13);
}

/* Of a sample that lies too far out to be a number: outside of every cone. */
static void put_sample(ocel_cone_samples_t *samples, uint32_t i, int32_t u_q13, int32_t v_q13,
                       int32_t e_q13) {
    const bool near = is_side_within(u_q13) && is_side_within(v_q13) && (e_q13 < E_MAX_Q13);

    samples->u_q13[i] = near ? (int16_t)u_q13 : (int16_t)0;
    samples->v_q13[i] = near ? (int16_t)v_q13 : (int16_t)0;
    samples->e_q25[i] = (near ? e_q13 : E_MAX_Q13) * 4096;
}

/* A unit vector's component in units of 2^-spread_log2.  n = 1 / |ray| is at most 1, so
 * the product is within 2^60.6; in Q26 the result is 2^40 at most.  Beyond 2^30 (16) it
 * is cut off, which put_sample then sees. */
static int32_t component_q26(int32_t p_q28, int32_t n_q30, uint32_t spread_log2) {
    const int64_t u_q26 = ocel_shift_round64((int64_t)p_q28 * n_q30, 32U - spread_log2);
    const int64_t most = 0x40000000;

    return (int32_t)((u_q26 > most) ? most : ((u_q26 < -most) ? -most : u_q26));
}

/* e = (u^2 + v^2) / (1 + w), exact for narrow cones where 1 - w is not.  1 + w is
 * 1/16 at least (160 degrees apart), its inverse y 2^(up - 3); the 1 tells a
 * compiler that it is not 0. */
static int32_t depth_q13(int32_t u_q26, int32_t v_q26, int32_t w_q26) {
    const uint64_t square_q52 = (uint64_t)(((int64_t)u_q26 * u_q26) + ((int64_t)v_q26 * v_q26));
    const uint32_t square_q22 = (uint32_t)(square_q52 >> 30U); /* <= 2^31 */
    const uint64_t below_q60 = (uint64_t)((int64_t)w_q26 + 0x4000000) << 34U;
    const uint32_t up = ocel_clz64(below_q60 | 1U); /* 2 .. 7 */
    const uint32_t y_q31 = ocel_recip32((uint32_t)((below_q60 << up) >> 32U));

    return (int32_t)ocel_shift_round64((int64_t)((uint64_t)square_q22 * y_q31),
                                       43U - up); /* below 2^27 */
}

/* Makes p, a ray in Q28, a unit vector in Q26, x and y in units of h. */
static void scale_ray(int32_t p[3], uint32_t spread_log2) {
    int64_t square_q56 = 0;
    int64_t y_q60;
    int32_t n_q30;
    int32_t e;

    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 */
        square_q56 += (int64_t)p[i] * p[i];
    }
    ocel_rsqrt_q60((uint64_t)square_q56, &y_q60, &e);
    n_q30 = (int32_t)ocel_asr64(y_q60, 32U - (uint32_t)e);
    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 */
        p[i] = component_q26(p[i], n_q30, (i < 2U) ? spread_log2 : 0U);
    }
}

bool ocel_cone_sample(const ocel_cone_source_t *source, const ocel_cone_place_t *place,
                      ocel_cone_samples_t *samples) {
    ocel_cone_map_t map;
    bool seen = true;

    ocel_cone_map(source, place->axis_cam_q30, ONE_Q30, ONE_Q30, &map);
    for (uint32_t k = 0U; seen && (k < OCEL_CONE_SAMPLES); k++) { /* bound: 32 samples */
        int32_t p[3];

        seen = ocel_cone_take(source, (k * source->count) / OCEL_CONE_SAMPLES, p);
        if (seen) {
            const int32_t a = p[0];
            const int32_t b = p[1];

            for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 */
                p[i] = (int32_t)ocel_shift_round64(ocel_cone_component_q58(&map, i, a, b), 30U);
            }
            scale_ray(p, place->spread_log2);
            put_sample(samples, k, ocel_asr32(p[0] + 4096, 13U), ocel_asr32(p[1] + 4096, 13U),
                       depth_q13(p[0], p[1], p[2]));
        }
    }
    return seen;
}
