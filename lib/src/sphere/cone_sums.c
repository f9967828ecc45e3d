/* SPDX-License-Identifier: MIT */
#include "cone_sums.h"

#include <string.h>

#include "../base/int_math.h"
#include "../base/q60.h"

/* An inlier is within GATE_SIGMAS of the samples' scatter, but at least .6 px (the
 * midpoint of a crack of a sharp mask is within .5), at most 1.5 px, and at most a
 * quarter of the radius. */
#define GATE_SIGMAS 3U
#define GATE_MIN_PX_Q16 39322U
#define GATE_MAX_PX_Q16 98304U

/* A point is outside from .4 px beyond the gate on: the guess itself is off by .2 px and
 * more on an arc's far side. */
#define OUTSIDE_PX_Q16 26214

/* |X| and |Y| of points that are looked at. */
#define SIDE_Q24 ((uint64_t)1U << 28U)

/* A distance that is none of an inlier's. */
#define FAR INT32_MAX

#define HALF_Q28 ((uint64_t)1U << 27U)

/* The map to the unit circle: the frame's rows x and y over t z0, in units of 2^side_e,
 * and z over z0. */
typedef struct {
    ocel_cone_map_t scaled;
    uint32_t side_down; /* a component to Q24 */
    int32_t r_px_q16;   /* of the outline, up to 2^30 */
    int32_t gate_px_q16;
} map_t;

static uint32_t gate_of(uint32_t rms_px_q16, uint32_t r_px_q16) {
    uint32_t gate = GATE_SIGMAS * rms_px_q16;

    gate = (gate < GATE_MIN_PX_Q16) ? GATE_MIN_PX_Q16 : gate;
    gate = (gate > GATE_MAX_PX_Q16) ? GATE_MAX_PX_Q16 : gate;
    return (gate > (r_px_q16 / 4U)) ? (r_px_q16 / 4U) : gate;
}

/* tan is 2^-22 to 1, so e is 0 to 22; f tan is below 2^30 in Q16, 1 / z^2 below 2^32 in
 * Q26. */
static void map_of(const ocel_cone_source_t *source, const ocel_cone_guess_t *guess, map_t *map) {
    const int32_t z_q30 = guess->axis_cam_q30[2];
    const int64_t tan_px_q16 = ocel_asr64(source->f_px_q16 * ocel_asr64(guess->tan_q46, 16U), 30U);
    const uint64_t r_px_q16 = ((uint64_t)tan_px_q16 * ocel_cone_stretch_q26(z_q30)) >> 26U;
    int64_t y_q60;
    int32_t e;

    ocel_recip_q60((uint64_t)guess->tan_q46 << 14U, &y_q60, &e);
    y_q60 = ocel_mul_q60(y_q60, (int64_t)z_q30 * 0x40000000);
    map->side_down = 34U - (uint32_t)e;
    ocel_cone_map(source, guess->axis_cam_q30, ocel_asr64(y_q60, 30U), z_q30, &map->scaled);
    map->r_px_q16 = (int32_t)((r_px_q16 > 0x40000000U) ? 0x40000000U : r_px_q16);
    map->gate_px_q16 = (int32_t)gate_of(guess->rms_px_q16, (uint32_t)map->r_px_q16);
}

/* A point's distance in px from the circle; a within 1/2, so the distance is below R. */
static inline int32_t distance_px_q16(const map_t *map, int64_t a_q28) {
    const int64_t a_px_q16 = ocel_asr64(a_q28 * map->r_px_q16, 28U);

    return (int32_t)(a_px_q16 - ocel_asr64(a_px_q16 * a_q28, 29U));
}

/* v within -half .. half - 1, half a power of two: one comparison. */
static inline bool is_between(int64_t v, uint64_t half) {
    return ((uint64_t)v + half) < (2U * half);
}

static inline bool is_inlier(const map_t *map, int32_t d_px_q16) {
    return ((uint32_t)d_px_q16 + (uint32_t)map->gate_px_q16) <= (2U * (uint32_t)map->gate_px_q16);
}

/* Adds a point.  One whose X or Y is over 16 is only outside.  Z is below 5.8, so the
 * squares fit Q48; an a beyond 1/2 is no inlier's, as a gate is at most R / 4. */
static inline void sum_point(const map_t *map, const int32_t ab[2], ocel_cone_sums_t *sums) {
    const ocel_cone_map_t *scaled = &map->scaled;
    const int64_t x_q24 = ocel_asr64(ocel_cone_component_q58(scaled, 0U, ab), map->side_down);
    const int64_t y_q24 = ocel_asr64(ocel_cone_component_q58(scaled, 1U, ab), map->side_down);
    const int64_t z_q24 = ocel_asr64(ocel_cone_component_q58(scaled, 2U, ab), 34U);

    /* Both below 2^29 when their bits together are. */
    if ((((uint64_t)x_q24 + SIDE_Q24) | ((uint64_t)y_q24 + SIDE_Q24)) < (2U * SIDE_Q24)) {
        const uint32_t sector = ocel_sector_of(x_q24, y_q24);
        const int64_t a_q28 = ocel_asr64((x_q24 * x_q24) + (y_q24 * y_q24) - (z_q24 * z_q24), 21U);
        const int32_t d_px_q16 = is_between(a_q28, HALF_Q28) ? distance_px_q16(map, a_q28) : FAR;

        if (is_inlier(map, d_px_q16)) {
            sums->inliers[sector]++;
            sums->d_px_q16[sector] += d_px_q16;
            sums->squares_q32 += (int64_t)d_px_q16 * d_px_q16;
        } else {
            sums->others[sector]++;
            sums->outside +=
                ((a_q28 > 0) && (d_px_q16 > (map->gate_px_q16 + OUTSIDE_PX_Q16))) ? 1U : 0U;
        }
    } else {
        sums->outside++;
    }
}

bool ocel_cone_sum(const ocel_cone_source_t *source, const ocel_cone_guess_t *guess,
                   ocel_cone_sums_t *sums) {
    map_t map;
    bool seen = true;

    map_of(source, guess, &map);
    (void)memset(sums, 0, sizeof(*sums));
    sums->r_px_q16 = map.r_px_q16;
    /* bound: OCEL_MAX_FIT_POINTS; OCEL_MAX_CRACKS each time in a call of ocel_eye_cone */
    for (uint32_t i = 0U; seen && (i < source->count); i++) {
        int32_t ab[2];

        seen = ocel_cone_take(source, i, ab);
        if (seen) {
            sum_point(&map, ab, sums);
        }
    }
    for (uint32_t k = 0U; k < OCEL_SECTORS; k++) { /* bound: OCEL_SECTORS = 32 */
        sums->inlier_count += sums->inliers[k];
    }
    return seen;
}
