/* SPDX-License-Identifier: MIT */
#include "cone_vote.h"

#include <stdbool.h>

#include <ocellus/config.h>

#include "../base/int_math.h"
#include "../base/q60.h"
#include "../base/scale.h"
#include "../base/sym3.h"
#include "cone_plane.h"

#define SAMPLES OCEL_CONE_SAMPLES

/* Rounds of least squares on the samples and, Q16 px, how far from the outline a
 * sample may be to take part: first what three noisy points may miss by, last what
 * the edge of a pixel does. */
#define ROUNDS 3U
static const uint32_t gate_px_q16[ROUNDS] = {98304U, 65536U, 52429U};

/* A hypothesis is voted on by samples within .75 px of it. */
#define VOTE_PX_Q16 49152U

/* Twice the area of a hypothesis's triangle, in h^2: 2^-10 at least. */
#define AREA_MIN_Q26 65536U

static int64_t cross(int32_t u1, int32_t v1, int32_t u2, int32_t v2) {
    return ((int64_t)u1 * v2) - ((int64_t)u2 * v1);
}

/* The plane through three samples, by Cramer's rule.  Differences are below 2^17,
 * determinants below 2^34.3 in Q26; a quotient is taken from 32 bits of them, and is below
 * 2^30.4. */
static bool plane_through(const ocel_cone_samples_t *s, uint32_t i, uint32_t j, uint32_t k,
                          const ocel_cone_place_t *place, ocel_cone_plane_t *plane) {
    const int32_t u1 = s->u_q13[j] - s->u_q13[i];
    const int32_t v1 = s->v_q13[j] - s->v_q13[i];
    const int32_t e1 = ocel_asr32(s->e_q25[j] - s->e_q25[i], 12U);
    const int32_t u2 = s->u_q13[k] - s->u_q13[i];
    const int32_t v2 = s->v_q13[k] - s->v_q13[i];
    const int32_t e2 = ocel_asr32(s->e_q25[k] - s->e_q25[i], 12U);
    const int64_t area_q26 = cross(u1, v1, u2, v2);
    bool valid = ocel_abs64(area_q26) >= AREA_MIN_Q26;

    if (valid) {
        const int64_t sign = ocel_sign64(area_q26);
        const uint32_t up = ocel_clz64(ocel_abs64(area_q26)); /* 29 .. 47 */
        const int64_t y_q31 = ocel_recip32((uint32_t)((ocel_abs64(area_q26) << up) >> 32U));
        int64_t abc[3] = {cross(e1, v1, e2, v2), cross(u1, e1, u2, e2), s->e_q25[i]};

        for (uint32_t side = 0U; side < 2U; side++) { /* bound: 2 slopes */
            const int64_t quotient = ocel_asr64(ocel_asr64(abc[side], 5U) * y_q31, 77U - up);
            const int32_t slope_q12 = (int32_t)((quotient ^ sign) - sign);

            abc[side] = (int64_t)slope_q12 * 65536;
            abc[2] -= (int64_t)slope_q12 * ((side == 0U) ? s->u_q13[i] : s->v_q13[i]);
        }
        valid = ocel_cone_plane(abc, place, plane);
    }
    return valid;
}

/* T of a plane.  T^2 <= 9: over 16 it is a number of Q60, and so is T / 4. */
static int64_t size_q58(const ocel_cone_plane_t *plane) {
    return ocel_sqrt_q60((uint64_t)plane->t2_q48 << 8U);
}

/* A sample's residual, positive inside: |A u|, |B v| <= 9, |C| <= 22, e <= 4. */
static int32_t residual_q25(const ocel_cone_plane_t *plane, const ocel_cone_samples_t *s,
                            uint32_t i) {
    return ((plane->a_q12 * s->u_q13[i]) + (plane->b_q12 * s->v_q13[i])) +
           (plane->c_q25 - s->e_q25[i]);
}

/* Of the samples, those on the outline less those outside it: a ball that is only hidden has
 * nothing outside. */
static int32_t votes_for(const ocel_cone_samples_t *s, const ocel_cone_plane_t *plane,
                         int32_t gate_q25) {
    int32_t outside = 0;
    int32_t inside = 0;

    for (uint32_t i = 0U; i < SAMPLES; i++) { /* bound: SAMPLES = 32 */
        const int32_t r_q25 = residual_q25(plane, s, i);

        outside += (r_q25 < -gate_q25) ? 1 : 0;
        inside += (r_q25 > gate_q25) ? 1 : 0;
    }
    return (int32_t)SAMPLES - (2 * outside) - inside;
}

/* The hypothesis with the most votes, the first of equals.  Hypothesis k goes through the
 * samples k, k + step and k + other step, the steps changing with k.  Of points in order along the
 * boundary the triples span an eighth to two thirds of it; of points in any order any
 * three are as good.  Returns how many of them are cones: none, and there is no best. */
static uint32_t elect(const ocel_cone_samples_t *samples, const ocel_cone_place_t *place,
                      ocel_cone_plane_t *best) {
    static const uint8_t steps[8][2] = {{7U, 13U},  {5U, 12U}, {8U, 16U}, {4U, 8U},
                                        {11U, 21U}, {5U, 15U}, {3U, 10U}, {6U, 19U}};
    int32_t most = INT32_MIN;
    uint32_t count = 0U;

    for (uint32_t k = 0U; k < (uint32_t)OCEL_CONE_HYPOTHESES; k++) { /* bound: 32 */
        const uint8_t *step = steps[k % 8U];
        ocel_cone_plane_t plane;

        if (plane_through(samples, k % SAMPLES, (k + step[0]) % SAMPLES, (k + step[1]) % SAMPLES,
                          place, &plane)) {
            const int32_t votes =
                votes_for(samples, &plane, ocel_cone_gate_q25(&plane, place, VOTE_PX_Q16));

            count++;
            if (votes > most) {
                most = votes;
                *best = plane;
            }
        }
    }
    return count;
}

/* The normal equations of the plane's correction, in 2^-10: |u|, |v| <= 3, so that
 * 32 squares are below 288 / 1024. */
typedef struct {
    int64_t m_q60[OCEL_SYM3_COUNT];
    int64_t b_q60[3];
    int64_t squares_q50;
    uint32_t count;
} plane_normal_t;

/* Sums of u and v are below 2^20, of their products over 2^6 below 2^29, of products
 * with a residual, itself below 2^28, below 2^48. */
static void sum_samples(const ocel_cone_samples_t *s, const ocel_cone_plane_t *plane,
                        int32_t gate_q25, plane_normal_t *normal) {
    int32_t m[OCEL_SYM3_COUNT] = {0, 0, 0, 0, 0, 0};
    int64_t b[3] = {0, 0, 0};

    normal->squares_q50 = 0;
    for (uint32_t i = 0U; i < SAMPLES; i++) { /* bound: SAMPLES = 32 */
        const int32_t r_q25 = residual_q25(plane, s, i);

        if ((r_q25 >= -gate_q25) && (r_q25 <= gate_q25)) {
            const int32_t u = s->u_q13[i];
            const int32_t v = s->v_q13[i];

            m[OCEL_XX] += ocel_asr32(u * u, 6U);
            m[OCEL_XY] += ocel_asr32(u * v, 6U);
            m[OCEL_XZ] += u;
            m[OCEL_YY] += ocel_asr32(v * v, 6U);
            m[OCEL_YZ] += v;
            m[OCEL_ZZ] += 1;
            b[0] -= (int64_t)u * r_q25;
            b[1] -= (int64_t)v * r_q25;
            b[2] -= r_q25;
            normal->squares_q50 += (int64_t)r_q25 * r_q25;
        }
    }
    normal->count = (uint32_t)m[OCEL_ZZ];
    for (uint32_t k = 0U; k < (uint32_t)OCEL_SYM3_COUNT; k++) { /* bound: 6 */
        static const uint8_t up[OCEL_SYM3_COUNT] = {30U, 30U, 37U, 30U, 37U, 50U};

        normal->m_q60[k] = ocel_shl64((int64_t)m[k], up[k]);
    }
    normal->b_q60[0] = ocel_shl64(b[0], 12U);
    normal->b_q60[1] = ocel_shl64(b[1], 12U);
    normal->b_q60[2] = ocel_shl64(b[2], 25U);
}

/* Least squares on the samples near the plane, ROUNDS times; what cannot be solved
 * leaves the plane as it is.  Returns the samples' scatter about the last plane but
 * one, px. */
static uint16_t settle(const ocel_cone_samples_t *s, const ocel_cone_place_t *place,
                       ocel_cone_plane_t *plane) {
    uint64_t squares_q50 = 0U; /* of the last round that could be solved; its count, its gate */
    uint64_t count = 1U;
    uint64_t gate_q25 = 1U;
    uint32_t gate_px = 0U;

    for (uint32_t round = 0U; round < ROUNDS; round++) { /* bound: ROUNDS = 3 */
        const int32_t r_q25 = ocel_cone_gate_q25(plane, place, gate_px_q16[round]);
        plane_normal_t normal;
        ocel_sym3_inverse_t inverse;
        int64_t x_q60[3];

        sum_samples(s, plane, r_q25, &normal);
        if ((normal.count > 3U) && ocel_sym3_invert(normal.m_q60, &inverse) &&
            ocel_sym3_apply(&inverse, normal.b_q60, x_q60)) {
            squares_q50 = (uint64_t)normal.squares_q50;
            count = (uint64_t)normal.count;
            gate_q25 = (uint64_t)r_q25;
            gate_px = gate_px_q16[round];
            x_q60[0] = ((int64_t)plane->a_q12 * 65536) + ocel_shift_round64(x_q60[0], 32U);
            x_q60[1] = ((int64_t)plane->b_q12 * 65536) + ocel_shift_round64(x_q60[1], 32U);
            x_q60[2] = plane->c_q25 + ocel_shift_round64(x_q60[2], 35U);
            (void)ocel_cone_plane(x_q60, place, plane);
        }
    }
    squares_q50 = ocel_udiv64(squares_q50, count);
    return (uint16_t)ocel_udiv64(
        (uint64_t)ocel_asr64(ocel_sqrt_q60(squares_q50 << 4U), 32U) * gate_px, 2U * gate_q25);
}

/* The cone of a plane; false when its axis is over 80 degrees from the frame's or
 * the camera's, or it opens by more than 90 degrees.  1 - h^2 C is 1/2 to 23; T / 4 over
 * it, with h, is tan / 4. */
static bool cone_of(const ocel_cone_plane_t *plane, const ocel_cone_place_t *place,
                    ocel_cone_guess_t *guess) {
    const int64_t below_q55 =
        (int64_t)0x80000000000000 -
        ocel_scale_q60((int64_t)plane->c_q25, 30 - (2 * (int32_t)place->spread_log2));
    ocel_cone_frame_t frame;
    ocel_scaled_t rate;

    ocel_cone_frame(place->axis_cam_q30, &frame);
    ocel_recip_q60((uint64_t)below_q55, &rate.y_q60, &rate.e);
    guess->tan_q46 = ocel_scale_q60(ocel_mul_q60(size_q58(plane), rate.y_q60),
                                    rate.e - 5 - 12 - (int32_t)place->spread_log2);
    ocel_cone_turn(&frame, (int32_t)ocel_asr64(plane->a_q28, place->spread_log2),
                   (int32_t)ocel_asr64(plane->b_q28, place->spread_log2), guess->axis_cam_q30);
    return (guess->tan_q46 <= (int64_t)0x400000000000) && (guess->axis_cam_q30[2] >= 0x0C000000);
}

bool ocel_cone_elect(const ocel_cone_samples_t *samples, const ocel_cone_place_t *place,
                     ocel_cone_guess_t *guess) {
    ocel_cone_plane_t plane = {0};
    bool found;

    guess->hypothesis_count = (uint16_t)elect(samples, place, &plane);
    found = guess->hypothesis_count > 0U;
    if (found) {
        guess->rms_px_q15 = settle(samples, place, &plane);
        found = cone_of(&plane, place, guess);
    }
    return found;
}
