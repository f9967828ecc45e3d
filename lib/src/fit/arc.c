/* SPDX-License-Identifier: MIT */
#include "arc.h"

#include "../base/int_math.h"
#include "../base/q60.h"
#include "../base/scale.h"
#include "../base/scale_all.h"
#include "../base/terms.h"

/* The map of an offset in half Q16 px to a frame in which the ellipse is a
 * circle of about 2^14. */
typedef struct {
    int32_t g_q29[4]; /* row by row */
    int32_t shift;
} rounding_t;

/* centre sigma * sqrt(n) / rms, Q4, when k of 32 sectors are covered, k = 3..32:
 * the Kanatani-Cramer-Rao bound of the centre, RMS of the vector, for points
 * spread evenly over one arc of a circle (Fisher matrix of the radial residual
 * in 1, cos t, sin t, cos 2t, sin 2t; test_arc.c recomputes it). */
#define SPREAD_FIRST 3U
static const uint32_t spread_q4[30] = {
    222283, 70087, 28577, 13704, 7347, 4272, 2642, 1715, 1157, 806, 577, 422, 314, 238, 184,
    143,    114,   91,    75,    62,   53,   46,   41,   38,   35,  34,  33,  32,  32,  32};

/* sqrt(form) * G^-1 up to scale: with q = (1+v) (X + w/(1+v) Y)^2 +
 * flatness/(1+v) Y^2, the rows are ((1+v) X + w Y) and sqrt(flatness) Y, where
 * X ~ g22 dx and Y ~ g11 dy - g21 dx. */
static rounding_t rounding_of(int64_t *r, int32_t a_px_q16) {
    enum { ROOT = OCEL_F_FREE, MAP };
    static const ocel_term_t terms[] = {
        {OCEL_GOES_ON, OCEL_F_FORM_XX, OCEL_F_G22},
        {OCEL_MINUS | MAP, OCEL_F_W, OCEL_F_G21},
        {MAP + 1, OCEL_F_W, OCEL_F_G11},
        {OCEL_MINUS | (MAP + 2), ROOT, OCEL_F_G21},
        {OCEL_LAST | (MAP + 3), ROOT, OCEL_F_G11},
    };
    rounding_t map;

    r[ROOT] = ocel_sqrt_q60((uint64_t)r[OCEL_F_FLATNESS]);
    ocel_sum_terms(r, terms);
    (void)ocel_normalise(&r[MAP], 4U, 29);
    for (uint32_t i = 0U; i < 4U; i++) { /* bound: 4 */
        map.g_q29[i] = (int32_t)r[MAP + i];
    }
    map.shift = (int32_t)ocel_clz32((uint32_t)a_px_q16) - 46; /* -45..-30 */
    return map;
}

/* A row times an offset, shifted: |g| <= 2^29 and |dx|, |dy| < 2^31 (the distance of
 * two coordinates in half Q16 px), so the sum is within 2^61. */
static int64_t mapped(const int32_t *row_q29, int32_t dx, int32_t dy, int32_t shift) {
    return ocel_scale_q60(((int64_t)row_q29[0] * dx) + ((int64_t)row_q29[1] * dy), shift);
}

/* floor((p - c) / 2), without the 33rd bit that p - c may need. */
static int32_t half_offset(int32_t p, int32_t c) {
    return (ocel_asr32(p, 1U) - ocel_asr32(c, 1U)) - (int32_t)(~(uint32_t)p & (uint32_t)c & 1U);
}

/* One bit for each sector that holds a point. */
static uint32_t sectors_hit(const ocel_source_t *source, const rounding_t *map,
                            const ocel_ellipse_t *ellipse) {
    uint32_t hit = 0U;
    size_t i = 0U;

    /* bound: OCEL_MAX_FIT_POINTS; OCEL_MAX_CRACKS each time in a call of ocel_eye_end or
     * ocel_eye_refit */
    do {
        const ocel_pair_t p = ocel_source_px_q16(source, i);
        const int32_t dx = half_offset((int32_t)p.x, ellipse->cx_px_q16);
        const int32_t dy = half_offset((int32_t)p.y, ellipse->cy_px_q16);

        hit |= 1U << ocel_sector_of(mapped(&map->g_q29[0], dx, dy, map->shift),
                                    mapped(&map->g_q29[2], dx, dy, map->shift));
        i++;
    } while (i < source->count);
    return hit;
}

/* rms * spread / sqrt(count): rms < 2^30, spread < 2^18. */
static uint32_t centre_sigma(uint32_t rms_px_q16, uint32_t count, uint32_t covered) {
    /* An arc short of the turn begins and ends within a sector: one less. */
    const uint32_t sectors = (covered < OCEL_SECTORS) ? (covered - 1U) : covered;
    const uint32_t index = (sectors < SPREAD_FIRST) ? 0U : (sectors - SPREAD_FIRST);
    const uint64_t spread = (uint64_t)rms_px_q16 * spread_q4[index];
    ocel_scaled_t root;
    uint64_t sigma;

    ocel_rsqrt_q60((uint64_t)count << 40U, &root.y_q60, &root.e); /* 2^10 / sqrt(count) */
    sigma = (spread >> 4U) * (uint64_t)ocel_shift_round64(root.y_q60, 46U);
    sigma = (uint64_t)ocel_scale_q60((int64_t)sigma, root.e - 24);
    return (sigma > UINT32_MAX) ? UINT32_MAX : (uint32_t)sigma;
}

uint32_t ocel_arc_sectors(const ocel_source_t *source, int64_t *r_q60,
                          const ocel_ellipse_t *ellipse) {
    const rounding_t map = rounding_of(r_q60, ellipse->a_px_q16);

    return ocel_sectors_covered(sectors_hit(source, &map, ellipse),
                                (2U * OCEL_SECTORS) / (uint32_t)source->count);
}

void ocel_arc_judge(uint32_t sectors, ocel_ellipse_t *ellipse) {
    ellipse->arc_coverage_q16 = sectors * (65536U / OCEL_SECTORS);
    ellipse->centre_sigma_px_q16 = centre_sigma(ellipse->rms_px_q16, ellipse->point_count, sectors);
}
