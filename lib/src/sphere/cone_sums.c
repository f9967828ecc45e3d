/* SPDX-License-Identifier: MIT */
#include "cone_sums.h"

#include <string.h>

#include "../base/int_math.h"
#include "cone_circle.h"

/* Half a crack across the outline at most: what pixels a third longer than wide make. */
#define HALF_MAX_PX_Q16 ((int64_t)42598)

/* A point is outside from .4 px beyond the gate on: the guess itself is off by .2 px and
 * more on an arc's far side. */
#define OUTSIDE_PX_Q16 26214

/* From 2 px beyond the gate on a point is not near: what hides a ball leaves its outline
 * within a sector, and is seen to where it does. */
#define NEAR_PX_Q16 131072

/* |X| and |Y| of points that are looked at. */
#define SIDE_Q24 ((uint64_t)1U << 28U)

/* A distance that is none of an inlier's. */
#define FAR INT32_MAX

#define HALF_Q28 ((uint64_t)1U << 27U)

/* A point's distance in px from the circle; a within 1/2, so the distance is below R. */
static inline int32_t distance_px_q16(const ocel_cone_circle_t *circle, int_fast32_t a_q28) {
    const int_fast32_t a_px_q16 = (int_fast32_t)ocel_asr64((int64_t)a_q28 * circle->r_px_q16, 28U);

    return (int32_t)(a_px_q16 - (int_fast32_t)ocel_asr64((int64_t)a_px_q16 * a_q28, 29U));
}

/* v within -half .. half - 1, half a power of two: one comparison. */
static inline bool is_between(int64_t v, uint64_t half) {
    return ((uint64_t)v + half) < (2U * half);
}

static inline bool is_near(int32_t d_px_q16, int32_t gate_px_q16) {
    return ((uint32_t)d_px_q16 + (uint32_t)gate_px_q16) <= (2U * (uint32_t)gate_px_q16);
}

/* Half of a crack across the outline: by its direction's component `side` along the crack,
 * below 16, and half_px_q16, below 2^25. */
static inline int32_t half_across(int_fast32_t side_q24, int32_t half_px_q16) {
    const int_fast32_t size_q24 = (int_fast32_t)ocel_abs64(side_q24);
    const int64_t half = ocel_asr64((int64_t)size_q24 * half_px_q16, 24U);

    return (int32_t)((half > HALF_MAX_PX_Q16) ? HALF_MAX_PX_Q16 : half);
}

static inline void add_inlier(int32_t d_px_q16, int32_t half_px_q16, uint32_t sector,
                              ocel_cone_sums_t *sums) {
    const int16_t low_q13 = (int16_t)ocel_asr32(d_px_q16 - half_px_q16, 3U);
    const int16_t high_q13 = (int16_t)ocel_asr32(d_px_q16 + half_px_q16, 3U);

    sums->inliers[sector]++;
    sums->d_px_q16[sector] += d_px_q16;
    sums->squares_q32 += (int64_t)d_px_q16 * d_px_q16;
    if (low_q13 > sums->low_px_q13[sector]) {
        sums->low_px_q13[sector] = low_q13;
    }
    if (high_q13 < sums->high_px_q13[sector]) {
        sums->high_px_q13[sector] = high_q13;
    }
}

/* Adds a point, or a crack along y (0) or x (1).  One whose X or Y is over 16 is only
 * outside.  Z is below 5.8, so the squares fit Q48; an a beyond 1/2 is no inlier's, as a
 * gate is at most R / 4. */
static inline void sum_point(const ocel_cone_circle_t *circle, int32_t a, int32_t b, uint32_t along,
                             ocel_cone_sums_t *sums) {
    const ocel_cone_map_t *scaled = &circle->scaled;
    const int64_t x_q24 = ocel_asr64(ocel_cone_component_q58(scaled, 0U, a, b), circle->side_down);
    const int64_t y_q24 = ocel_asr64(ocel_cone_component_q58(scaled, 1U, a, b), circle->side_down);
    const int_fast32_t z_q24 =
        (int_fast32_t)ocel_asr64(ocel_cone_component_q58(scaled, 2U, a, b), 34U);

    /* Both below 2^29 when their bits together are. */
    if ((((uint64_t)x_q24 + SIDE_Q24) | ((uint64_t)y_q24 + SIDE_Q24)) < (2U * SIDE_Q24)) {
        const int_fast32_t x = (int_fast32_t)x_q24;
        const int_fast32_t y = (int_fast32_t)y_q24;
        const uint32_t sector = ocel_sector_of(x, y);
        const int64_t a_q28 =
            ocel_asr64(((int64_t)x * x) + ((int64_t)y * y) - ((int64_t)z_q24 * z_q24), 21U);
        const int32_t d_px_q16 =
            is_between(a_q28, HALF_Q28) ? distance_px_q16(circle, (int_fast32_t)a_q28) : FAR;
        const int32_t half_px_q16 = half_across((along != 0U) ? x : y, circle->half_px_q16[along]);
        const int32_t gate_px_q16 = circle->gate_px_q16 + half_px_q16;

        if (is_near(d_px_q16, gate_px_q16)) {
            add_inlier(d_px_q16, half_px_q16, sector, sums);
        } else {
            const bool beyond = (a_q28 > 0) && (d_px_q16 > (gate_px_q16 + OUTSIDE_PX_Q16));

            if (sums->others[sector] < UINT8_MAX) {
                sums->others[sector]++;
            }
            if (is_near(d_px_q16, gate_px_q16 + NEAR_PX_Q16)) {
                sums->mixed |= (uint32_t)1U << sector;
            }
            if (beyond) {
                sums->outside++;
            }
        }
    } else {
        sums->outside++;
    }
}

/* Adds points first .. end - 1; of one whose lens is undone, `bent` is its slopes.  A
 * function of its own, so that its frame is not on the stack with the lens's. */
static void sum_span(const ocel_cone_circle_t *circle, const ocel_cone_source_t *source,
                     uint32_t first, uint32_t end, const int32_t *bent, ocel_cone_sums_t *sums) {
    /* bound: OCEL_MAX_FIT_POINTS; OCEL_MAX_FIT_POINTS in a call of ocel_cone_sum;
     * OCEL_MAX_CRACKS in a call of ocel_eye_cone */
    for (uint32_t i = first; i < end; i++) {
        int32_t xy_px_q16[2];

        ocel_cone_pixel(source, i, xy_px_q16);
        sum_point(circle, (bent != NULL) ? bent[0] : xy_px_q16[0],
                  (bent != NULL) ? bent[1] : xy_px_q16[1], ocel_cone_along(xy_px_q16[0]), sums);
    }
}

static void clear(const ocel_cone_source_t *source, const ocel_cone_circle_t *circle,
                  ocel_cone_sums_t *sums) {
    (void)memset(sums, 0, sizeof(*sums));
    sums->r_px_q16 = circle->r_px_q16;
    sums->cracks = source->points == NULL;
    for (uint32_t k = 0U; k < OCEL_SECTORS; k++) { /* bound: OCEL_SECTORS = 32 */
        sums->low_px_q13[k] = INT16_MIN;
        sums->high_px_q13[k] = INT16_MAX;
    }
}

bool ocel_cone_sum(const ocel_cone_source_t *source, const ocel_cone_guess_t *guess,
                   ocel_cone_sums_t *sums) {
    ocel_cone_circle_t circle;
    bool seen = true;

    ocel_cone_circle(source, guess, &circle);
    clear(source, &circle, sums);
    if (source->plain) {
        sum_span(&circle, source, 0U, source->count, NULL, sums);
    } else {
        /* bound: OCEL_MAX_FIT_POINTS; OCEL_MAX_CRACKS each time in a call of ocel_eye_cone */
        for (uint32_t i = 0U; seen && (i < source->count); i++) {
            int32_t ab[2];

            seen = ocel_cone_take(source, i, ab);
            if (seen) {
                sum_span(&circle, source, i, i + 1U, ab, sums);
            }
        }
    }
    for (uint32_t k = 0U; k < OCEL_SECTORS; k++) { /* bound: OCEL_SECTORS = 32 */
        sums->inlier_count += sums->inliers[k];
    }
    return seen;
}
