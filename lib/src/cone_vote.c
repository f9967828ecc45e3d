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

#include "int_math.h"
#include "q60.h"
#include "scale.h"
#include "sym3.h"

#define SAMPLES 64U

/* Rounds of least squares on the samples and, Q16 px, how far from the outline a
 * sample may be to take part: first what three noisy points may miss by, last what
 * the edge of a pixel does. */
#define ROUNDS 3U
static const uint32_t gate_px_q16[ROUNDS] = {98304U, 65536U, 52429U};

/* A hypothesis is voted on by samples within .75 px of it. */
#define VOTE_PX_Q16 49152U

/* u and v of a sample, A and B are within 3; e below 4. */
#define SIDE_MAX_Q13 24575
#define E_MAX_Q13 32767
#define SLOPE_MAX_Q12 12287

/* T between 1/16 and 3. */
#define T2_MIN_Q24 65536
#define T2_MAX_Q24 ((int64_t)9 << 24U)

/* Twice the area of a hypothesis's triangle, in h^2: 2^-10 at least. */
#define AREA_MIN_Q26 65536U

typedef struct {
    int16_t u_q13[SAMPLES];
    int16_t v_q13[SAMPLES];
    int16_t e_q13[SAMPLES];
} samples_t;

typedef struct {
    int16_t a_q12;
    int16_t b_q12;
    int32_t c_q25; /* |C| <= 22 */
    int64_t t_q58; /* T */
} plane_t;

/* Of a sample that lies too far out to be a number: outside of every cone. */
static void put_sample(samples_t *samples, uint32_t i, int64_t u_q13, int64_t v_q13,
                       int64_t e_q13) {
    const bool near = (ocel_abs64(u_q13) <= SIDE_MAX_Q13) && (ocel_abs64(v_q13) <= SIDE_MAX_Q13) &&
                      (e_q13 < E_MAX_Q13);

    samples->u_q13[i] = near ? (int16_t)u_q13 : (int16_t)0;
    samples->v_q13[i] = near ? (int16_t)v_q13 : (int16_t)0;
    samples->e_q13[i] = near ? (int16_t)e_q13 : (int16_t)E_MAX_Q13;
}

/* (u, v, e) of a ray p, |p|^2 = square.  n = 1 / |p| is y 2^e / 4, so u = p n is
 * within 1 in Q58 and h^-1 u within 2^14: kept in Q26, 2^40 at most.  Beyond 2^30
 * (16) it is cut off, which put_sample then sees. */
static int64_t side_q26(int32_t p_q28, int64_t n_q30, uint32_t spread_log2) {
    const int64_t u_q26 = ocel_shift_round64(p_q28 * n_q30, 32U - spread_log2);
    const int64_t most = (int64_t)1 << 30U;

    return (u_q26 > most) ? most : ((u_q26 < -most) ? -most : u_q26);
}

/* e = (u^2 + v^2) / (1 + w), exact for narrow cones where 1 - w is not.  1 + w is
 * 1/16 at least (160 degrees apart), its inverse y 2^e with e at most 4. */
static int64_t depth_q13(int64_t u_q26, int64_t v_q26, int64_t w_q28) {
    const int64_t square_q22 = ocel_asr64((u_q26 * u_q26) + (v_q26 * v_q26), 30U); /* <= 2^31 */
    uint32_t y_q31;
    int32_t e;

    ocel_recip_short((uint64_t)(w_q28 + 0x10000000) << 32U, &y_q31, &e);
    return ocel_scale_q60(square_q22 * (int64_t)y_q31, e - 40);
}

static bool take_sample(const ocel_cone_source_t *source, const ocel_cone_place_t *place,
                        uint32_t i, samples_t *samples) {
    int32_t p_cam_q28[3];
    int32_t p_q28[3];
    const bool seen =
        ocel_cone_ray(source, &place->frame, (i * source->count) / SAMPLES, p_cam_q28, p_q28);

    if (seen) {
        const int64_t square_q56 = ((int64_t)p_cam_q28[0] * p_cam_q28[0]) +
                                   ((int64_t)p_cam_q28[1] * p_cam_q28[1]) + ((int64_t)1 << 56U);
        ocel_scaled_t n;
        int64_t n_q30;
        int64_t u_q26;
        int64_t v_q26;

        ocel_rsqrt_q60((uint64_t)square_q56, &n.y_q60, &n.e);
        n_q30 = ocel_scale_q60(n.y_q60, n.e - 32);
        u_q26 = side_q26(p_q28[0], n_q30, place->spread_log2);
        v_q26 = side_q26(p_q28[1], n_q30, place->spread_log2);
        put_sample(samples, i, ocel_shift_round64(u_q26, 13U), ocel_shift_round64(v_q26, 13U),
                   depth_q13(u_q26, v_q26, ocel_asr64(p_q28[2] * n_q30, 30U)));
    }
    return seen;
}

/* Completes a plane whose A, B and C are known; false when it is no cone of a size
 * that these points can have.  h^2 C < 1/2: a cone under 90 degrees has less. */
static bool finish_plane(int64_t a_q12, int64_t b_q12, int64_t c_q25, uint32_t spread_log2,
                         plane_t *plane) {
    const int64_t c_q12 = ocel_asr64(c_q25, 13U);
    bool valid = (ocel_abs64(a_q12) <= SLOPE_MAX_Q12) && (ocel_abs64(b_q12) <= SLOPE_MAX_Q12) &&
                 (ocel_abs64(c_q25) <= ((uint64_t)22 << 25U)) &&
                 (ocel_asr64(c_q25, 2U * spread_log2) < ((int64_t)1 << 24U));

    if (valid) {
        const int64_t t2_q24 =
            (a_q12 * a_q12) + (b_q12 * b_q12) + c_q25 - ocel_asr64(c_q12 * c_q12, 2U * spread_log2);

        valid = (t2_q24 >= T2_MIN_Q24) && (t2_q24 <= T2_MAX_Q24);
        if (valid) {
            plane->a_q12 = (int16_t)a_q12;
            plane->b_q12 = (int16_t)b_q12;
            plane->c_q25 = (int32_t)c_q25;
            plane->t_q58 = ocel_sqrt_q60((uint64_t)t2_q24 << 32U);
        }
    }
    return valid;
}

/* The plane through three samples, by Cramer's rule.  Differences are below 2^17,
 * determinants below 2^34.3 in Q26; a quotient is taken from 32 bits of them. */
static bool plane_through(const samples_t *s, uint32_t i, uint32_t j, uint32_t k,
                          uint32_t spread_log2, plane_t *plane) {
    const int64_t u1 = (int64_t)s->u_q13[j] - s->u_q13[i];
    const int64_t v1 = (int64_t)s->v_q13[j] - s->v_q13[i];
    const int64_t e1 = (int64_t)s->e_q13[j] - s->e_q13[i];
    const int64_t u2 = (int64_t)s->u_q13[k] - s->u_q13[i];
    const int64_t v2 = (int64_t)s->v_q13[k] - s->v_q13[i];
    const int64_t e2 = (int64_t)s->e_q13[k] - s->e_q13[i];
    const int64_t area_q26 = (u1 * v2) - (u2 * v1);
    bool valid = ocel_abs64(area_q26) >= AREA_MIN_Q26;

    if (valid) {
        const int64_t sign = ocel_sign64(area_q26);
        uint32_t y_q31;
        int32_t e;
        int64_t a_q12;
        int64_t b_q12;

        ocel_recip_short(ocel_abs64(area_q26), &y_q31, &e); /* e is 25..44 */
        a_q12 = ocel_asr64((e1 * v2) - (e2 * v1), 5U) * (int64_t)y_q31;
        b_q12 = ocel_asr64((u1 * e2) - (u2 * e1), 5U) * (int64_t)y_q31;
        a_q12 = ((ocel_scale_q60(a_q12, e - 74)) ^ sign) - sign;
        b_q12 = ((ocel_scale_q60(b_q12, e - 74)) ^ sign) - sign;
        valid = finish_plane(a_q12, b_q12,
                             ((int64_t)s->e_q13[i] * 4096) - (a_q12 * s->u_q13[i]) -
                                 (b_q12 * s->v_q13[i]),
                             spread_log2, plane);
    }
    return valid;
}

/* A distance in px from a plane's outline as a residual, Q25: T is at most 3, a pixel
 * at most h, the distance below 2 px. */
static int32_t residual_of(const plane_t *plane, uint32_t pixel_q25, uint32_t px_q16) {
    const uint64_t t_q30 = (uint64_t)ocel_asr64(plane->t_q58, 28U);

    return (int32_t)((((t_q30 * pixel_q25) >> 30U) * px_q16) >> 16U);
}

/* A sample's residual, positive inside: |A u|, |B v| <= 9, |C| <= 22, e <= 4. */
static int32_t residual_q25(const plane_t *plane, const samples_t *s, uint32_t i) {
    return ((plane->a_q12 * s->u_q13[i]) + (plane->b_q12 * s->v_q13[i])) +
           (plane->c_q25 - (s->e_q13[i] * 4096));
}

/* Those on the outline less those outside it, less SAMPLES: a ball that is only
 * hidden has nothing outside.  Twice "not outside" less "inside" counts just that,
 * without a branch. */
static int32_t votes_for(const samples_t *s, const plane_t *plane, int32_t gate_q25) {
    int32_t votes = 0;

    for (uint32_t i = 0U; i < SAMPLES; i++) { /* bound: SAMPLES = 64 */
        const int32_t r_q25 = residual_q25(plane, s, i);

        votes += (r_q25 >= -gate_q25) ? 2 : 0;
        votes -= (r_q25 > gate_q25) ? 1 : 0;
    }
    return votes;
}

/* The hypothesis with the most votes, the first of equals: through the samples k,
 * k + step, k + other, where the steps change with k.  Points in order along the
 * boundary have their triples within 19, 31, 33, 39, 50, 66, 75 and 100 % of it; of points in
 * any order any three are as good. */
static bool elect(const samples_t *samples, const ocel_cone_place_t *place, plane_t *best) {
    static const uint8_t steps[8][2] = {{13U, 26U}, {11U, 25U}, {16U, 32U}, {8U, 16U},
                                        {21U, 42U}, {10U, 31U}, {6U, 20U},  {13U, 38U}};
    int32_t most = INT32_MIN;

    for (uint32_t k = 0U; k < OCEL_CONE_HYPOTHESES; k++) { /* bound: OCEL_CONE_HYPOTHESES = 64 */
        const uint8_t *step = steps[k % 8U];
        plane_t plane;

        if (plane_through(samples, k % SAMPLES, (k + step[0]) % SAMPLES, (k + step[1]) % SAMPLES,
                          place->spread_log2, &plane)) {
            const int32_t votes =
                votes_for(samples, &plane, residual_of(&plane, place->pixel_q25, VOTE_PX_Q16));

            if (votes > most) {
                most = votes;
                *best = plane;
            }
        }
    }
    return most > INT32_MIN;
}

/* The normal equations of the plane's correction, in 2^-10: |u|, |v| <= 3, so that
 * 64 squares are below 576 / 1024. */
typedef struct {
    int64_t m_q60[OCEL_SYM3_COUNT];
    int64_t b_q60[3];
    int64_t squares_q50;
    uint32_t count;
} normal_t;

static void sum_samples(const samples_t *s, const plane_t *plane, int32_t gate_q25,
                        normal_t *normal) {
    int64_t m[OCEL_SYM3_COUNT] = {0, 0, 0, 0, 0, 0};
    int64_t b[3] = {0, 0, 0};

    normal->squares_q50 = 0;
    for (uint32_t i = 0U; i < SAMPLES; i++) { /* bound: SAMPLES = 64 */
        const int32_t r_q25 = residual_q25(plane, s, i);

        if ((r_q25 >= -gate_q25) && (r_q25 <= gate_q25)) {
            const int32_t u = s->u_q13[i];
            const int32_t v = s->v_q13[i];

            m[OCEL_XX] += u * u;
            m[OCEL_XY] += u * v;
            m[OCEL_XZ] += u;
            m[OCEL_YY] += v * v;
            m[OCEL_YZ] += v;
            m[OCEL_ZZ] += 1;
            b[0] -= (int64_t)u * r_q25;
            b[1] -= (int64_t)v * r_q25;
            b[2] -= r_q25;
            normal->squares_q50 += (int64_t)r_q25 * r_q25;
        }
    }
    normal->count = (uint32_t)m[OCEL_ZZ];
    normal->m_q60[OCEL_XX] = ocel_shl64(m[OCEL_XX], 24U);
    normal->m_q60[OCEL_XY] = ocel_shl64(m[OCEL_XY], 24U);
    normal->m_q60[OCEL_XZ] = ocel_shl64(m[OCEL_XZ], 37U);
    normal->m_q60[OCEL_YY] = ocel_shl64(m[OCEL_YY], 24U);
    normal->m_q60[OCEL_YZ] = ocel_shl64(m[OCEL_YZ], 37U);
    normal->m_q60[OCEL_ZZ] = ocel_shl64(m[OCEL_ZZ], 50U);
    normal->b_q60[0] = ocel_shl64(b[0], 12U);
    normal->b_q60[1] = ocel_shl64(b[1], 12U);
    normal->b_q60[2] = ocel_shl64(b[2], 25U);
}

/* Least squares on the samples near the plane, ROUNDS times; what cannot be solved
 * leaves the plane as it is.  Returns the samples' scatter about the last plane but
 * one, px. */
static uint32_t settle(const samples_t *s, const ocel_cone_place_t *place, plane_t *plane) {
    uint32_t rms_px_q16 = 0U;

    for (uint32_t round = 0U; round < ROUNDS; round++) { /* bound: ROUNDS = 3 */
        const int32_t gate_q25 = residual_of(plane, place->pixel_q25, gate_px_q16[round]);
        normal_t normal;
        ocel_sym3_inverse_t inverse;
        int64_t x_q60[3];

        sum_samples(s, plane, gate_q25, &normal);
        if ((normal.count > 3U) && ocel_sym3_invert(normal.m_q60, &inverse) &&
            ocel_sym3_apply(&inverse, normal.b_q60, x_q60)) {
            const uint64_t square_q50 = ocel_udiv64((uint64_t)normal.squares_q50, normal.count);

            rms_px_q16 = (uint32_t)ocel_udiv64(
                (uint64_t)ocel_isqrt64(square_q50) * gate_px_q16[round], (uint64_t)gate_q25);
            (void)finish_plane(plane->a_q12 + ocel_shift_round64(x_q60[0], 48U),
                               plane->b_q12 + ocel_shift_round64(x_q60[1], 48U),
                               plane->c_q25 + ocel_shift_round64(x_q60[2], 35U), place->spread_log2,
                               plane);
        }
    }
    return rms_px_q16;
}

/* The cone of a plane; false when its axis is over 80 degrees from the frame's or
 * the camera's, or it opens by more than 90 degrees.  1 - h^2 C is 1/2 to 23; T / 4 over
 * it, with h, is tan / 4. */
static bool cone_of(const plane_t *plane, const ocel_cone_place_t *place,
                    ocel_cone_guess_t *guess) {
    const int64_t below_q55 =
        ((int64_t)1 << 55U) -
        ocel_scale_q60((int64_t)plane->c_q25, 30 - (2 * (int32_t)place->spread_log2));
    ocel_scaled_t rate;

    ocel_recip_q60((uint64_t)below_q55, &rate.y_q60, &rate.e);
    guess->tan_q46 = ocel_scale_q60(ocel_mul_q60(plane->t_q58, rate.y_q60),
                                    rate.e - 5 - 12 - (int32_t)place->spread_log2);
    ocel_cone_turn(&place->frame,
                   (int32_t)ocel_scale_q60(plane->a_q12, 16 - (int32_t)place->spread_log2),
                   (int32_t)ocel_scale_q60(plane->b_q12, 16 - (int32_t)place->spread_log2),
                   guess->axis_cam_q30);
    return (guess->tan_q46 <= ((int64_t)1 << 46U)) && (guess->axis_cam_q30[2] >= 0x0C000000);
}

ocel_status_t ocel_cone_guess(const ocel_cone_source_t *source, const ocel_cone_place_t *place,
                              ocel_cone_guess_t *guess) {
    samples_t samples;
    plane_t plane;
    bool seen = true;
    ocel_status_t status = OCEL_OUT_OF_RANGE;

    for (uint32_t i = 0U; i < SAMPLES; i++) { /* bound: SAMPLES = 64 */
        seen = take_sample(source, place, i, &samples) && seen;
    }
    if (seen) {
        status = OCEL_DEGENERATE;
        if (elect(&samples, place, &plane)) {
            guess->rms_px_q16 = settle(&samples, place, &plane);
            status = cone_of(&plane, place, guess) ? OCEL_OK : OCEL_DEGENERATE;
        }
    }
    return status;
}
