/* SPDX-License-Identifier: MIT
 *
 * In a frame that looks at the points a unit vector is (u, v, 1 - e), and
 * d . m = 1 is a plane over (u, v):
 *   e = A u + B v + C,  m = (A, B, 1) / (1 - C).
 * The vectors of a ball's outline have u and v of the order of h and e of h^2; all
 * is in these units here, so that it is well conditioned for a far ball too:
 *   m = (h A, h B, 1) / (1 - h^2 C),
 *   tan^2 = |m|^2 - 1 = h^2 T^2 / (1 - h^2 C)^2, T^2 = A^2 + B^2 + 2 C - h^2 C^2,
 * and a residual r of the plane is a distance of r / T from the outline.
 */
#include "cone_vote.h"

#include <stdbool.h>

#include <ocellus/config.h>

#include "../base/int_math.h"
#include "../base/q60.h"
#include "../base/scale.h"
#include "../base/sym3.h"

#define SAMPLES OCEL_CONE_SAMPLES

/* Rounds of least squares on the samples and, Q16 px, how far from the outline a
 * sample may be to take part: first what three noisy points may miss by, last what
 * the edge of a pixel does. */
#define ROUNDS 3U
static const uint32_t gate_px_q16[ROUNDS] = {98304U, 65536U, 52429U};

/* A hypothesis is voted on by samples within .75 px of it. */
#define VOTE_PX_Q16 49152U

/* A and B are within 3. */
#define SLOPE_MAX_Q28 ((uint64_t)12287U << 16U)

/* T between 1/16 and 3. */
#define T2_MIN_Q48 ((int64_t)0x10000000000)
#define T2_MAX_Q48 ((int64_t)0x9000000000000)

/* Twice the area of a hypothesis's triangle, in h^2: 2^-10 at least. */
#define AREA_MIN_Q26 65536U

typedef struct {
    int32_t a_q28;
    int32_t b_q28;
    int32_t c_q25; /* |C| <= 22 */
    int16_t a_q12; /* for residuals */
    int16_t b_q12;
    int64_t t2_q48; /* T^2 */
} plane_t;

/* Completes a plane whose A, B and C are known; false when it is no cone of a size
 * that these points can have.  h^2 C < 1/2: a cone under 90 degrees has less.
 * |C| is below 22 through three samples, and moves by less than 1 in a round. */
static bool finish_plane(int64_t a_q28, int64_t b_q28, int64_t c_q25, uint32_t spread_log2,
                         plane_t *plane) {
    bool valid = (ocel_abs64(a_q28) <= SLOPE_MAX_Q28) && (ocel_abs64(b_q28) <= SLOPE_MAX_Q28) &&
                 (ocel_asr64(c_q25, 2U * spread_log2) < 0x1000000);

    if (valid) {
        const int64_t a_q24 = ocel_asr64(a_q28, 4U);
        const int64_t b_q24 = ocel_asr64(b_q28, 4U);
        const int64_t c_q24 = ocel_asr64(c_q25, 1U);
        const int64_t t2_q48 = (a_q24 * a_q24) + (b_q24 * b_q24) + (c_q25 * 0x1000000) -
                               ocel_asr64(c_q24 * c_q24, 2U * spread_log2);

        valid = (t2_q48 >= T2_MIN_Q48) && (t2_q48 <= T2_MAX_Q48);
        if (valid) {
            plane->a_q28 = (int32_t)a_q28;
            plane->b_q28 = (int32_t)b_q28;
            plane->c_q25 = (int32_t)c_q25;
            plane->a_q12 = (int16_t)ocel_asr64(a_q28, 16U);
            plane->b_q12 = (int16_t)ocel_asr64(b_q28, 16U);
            plane->t2_q48 = t2_q48;
        }
    }
    return valid;
}

/* The plane through three samples, by Cramer's rule.  Differences are below 2^17,
 * determinants below 2^34.3 in Q26; a quotient is taken from 32 bits of them. */
static bool plane_through(const ocel_cone_samples_t *s, uint32_t i, uint32_t j, uint32_t k,
                          uint32_t spread_log2, plane_t *plane) {
    const int64_t u1 = (int64_t)s->u_q13[j] - s->u_q13[i];
    const int64_t v1 = (int64_t)s->v_q13[j] - s->v_q13[i];
    const int64_t e1 = ocel_asr32(s->e_q25[j] - s->e_q25[i], 12U);
    const int64_t u2 = (int64_t)s->u_q13[k] - s->u_q13[i];
    const int64_t v2 = (int64_t)s->v_q13[k] - s->v_q13[i];
    const int64_t e2 = ocel_asr32(s->e_q25[k] - s->e_q25[i], 12U);
    const int64_t area_q26 = (u1 * v2) - (u2 * v1);
    bool valid = ocel_abs64(area_q26) >= AREA_MIN_Q26;

    if (valid) {
        const int64_t sign = ocel_sign64(area_q26);
        const uint32_t up = ocel_clz64(ocel_abs64(area_q26)); /* 29 .. 47 */
        const int64_t y_q31 = ocel_recip32((uint32_t)((ocel_abs64(area_q26) << up) >> 32U));
        int64_t a_q12;
        int64_t b_q12;

        a_q12 = ocel_asr64((e1 * v2) - (e2 * v1), 5U) * y_q31;
        b_q12 = ocel_asr64((u1 * e2) - (u2 * e1), 5U) * y_q31;
        a_q12 = (ocel_asr64(a_q12, 77U - up) ^ sign) - sign;
        b_q12 = (ocel_asr64(b_q12, 77U - up) ^ sign) - sign;
        valid = finish_plane(a_q12 * 65536, b_q12 * 65536,
                             (int64_t)s->e_q25[i] - (a_q12 * s->u_q13[i]) - (b_q12 * s->v_q13[i]),
                             spread_log2, plane);
    }
    return valid;
}

/* T of a plane.  T^2 <= 9: over 16 it is a number of Q60, and so is T / 4. */
static int64_t size_q58(const plane_t *plane) {
    return ocel_sqrt_q60((uint64_t)plane->t2_q48 << 8U);
}

/* T within 3 %, which a gate can bear: with T^2 = m 4^e, m in [1, 4), the line
 * (m + 2) / 3 raised by half its sag.  T^2 is T2_MIN_Q48 at least; the 1 tells a compiler that
 * it is not 0. */
static uint32_t rough_size_q12(const plane_t *plane) {
    const uint32_t t2 = (uint32_t)ocel_asr64(plane->t2_q48, 24U);
    const uint32_t e = (31U - ocel_clz32(t2 | 1U)) / 2U; /* 8 .. 13 */

    return (((t2 >> e) + ((uint32_t)2U << e)) * 22459U) >> 16U;
}

/* A distance in px from the outline as a residual, Q25: T is at most 3.1, a pixel at most
 * h, the distance below 2 px. */
static int32_t residual_of(uint32_t size_q12, uint32_t pixel_q25, uint32_t px_q16) {
    const uint64_t r_q25 = ((((uint64_t)size_q12 * pixel_q25) >> 12U) * px_q16) >> 16U;

    return (int32_t)r_q25;
}

/* A sample's residual, positive inside: |A u|, |B v| <= 9, |C| <= 22, e <= 4. */
static int32_t residual_q25(const plane_t *plane, const ocel_cone_samples_t *s, uint32_t i) {
    return ((plane->a_q12 * s->u_q13[i]) + (plane->b_q12 * s->v_q13[i])) +
           (plane->c_q25 - s->e_q25[i]);
}

/* Of the samples, those on the outline less those outside it: a ball that is only hidden has
 * nothing outside. */
static int32_t votes_for(const ocel_cone_samples_t *s, const plane_t *plane, int32_t gate_q25) {
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
                      plane_t *best) {
    static const uint8_t steps[8][2] = {{7U, 13U},  {5U, 12U}, {8U, 16U}, {4U, 8U},
                                        {11U, 21U}, {5U, 15U}, {3U, 10U}, {6U, 19U}};
    int32_t most = INT32_MIN;
    uint32_t count = 0U;

    for (uint32_t k = 0U; k < (uint32_t)OCEL_CONE_HYPOTHESES; k++) { /* bound: 32 */
        const uint8_t *step = steps[k % 8U];
        plane_t plane;

        if (plane_through(samples, k % SAMPLES, (k + step[0]) % SAMPLES, (k + step[1]) % SAMPLES,
                          place->spread_log2, &plane)) {
            const int32_t votes =
                votes_for(samples, &plane,
                          residual_of(rough_size_q12(&plane), place->pixel_q25, VOTE_PX_Q16));

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
static void sum_samples(const ocel_cone_samples_t *s, const plane_t *plane, int32_t gate_q25,
                        plane_normal_t *normal) {
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
                       plane_t *plane) {
    uint64_t squares_q50 = 0U; /* of the last round that could be solved; its count, its gate */
    uint64_t count = 1U;
    uint64_t gate_q25 = 1U;
    uint32_t gate_px = 0U;

    for (uint32_t round = 0U; round < ROUNDS; round++) { /* bound: ROUNDS = 3 */
        const int32_t r_q25 =
            residual_of(rough_size_q12(plane), place->pixel_q25, gate_px_q16[round]);
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
            (void)finish_plane(((int64_t)plane->a_q12 * 65536) + ocel_shift_round64(x_q60[0], 32U),
                               ((int64_t)plane->b_q12 * 65536) + ocel_shift_round64(x_q60[1], 32U),
                               plane->c_q25 + ocel_shift_round64(x_q60[2], 35U), place->spread_log2,
                               plane);
        }
    }
    squares_q50 = ocel_udiv64(squares_q50, count);
    return (uint16_t)ocel_udiv64(
        (uint64_t)ocel_asr64(ocel_sqrt_q60(squares_q50 << 4U), 32U) * gate_px, 2U * gate_q25);
}

/* The cone of a plane; false when its axis is over 80 degrees from the frame's or
 * the camera's, or it opens by more than 90 degrees.  1 - h^2 C is 1/2 to 23; T / 4 over
 * it, with h, is tan / 4. */
static bool cone_of(const plane_t *plane, const ocel_cone_place_t *place,
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
    plane_t plane = {0};
    bool found;

    guess->hypothesis_count = (uint16_t)elect(samples, place, &plane);
    found = guess->hypothesis_count > 0U;
    if (found) {
        guess->rms_px_q15 = settle(samples, place, &plane);
        found = cone_of(&plane, place, guess);
    }
    return found;
}
