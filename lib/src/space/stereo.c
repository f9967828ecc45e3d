/* SPDX-License-Identifier: MIT
 *
 * Formats: vectors are 64 bits wide, so that one product, ocel_mul_q60, serves all:
 * directions in Q60, lengths in u with 30 fraction bits, relative covariances in Q60
 * and those in u^2 as they are.
 */
#include <ocellus/stereo.h>

#include <stddef.h>
#include <string.h>

#include <ocellus/sphere.h>

#include "../base/int_math.h"
#include "../base/q60.h"
#include "../base/scale.h"
#include "../base/sym3.h"
#include "../base/trig.h"
#include "pose.h"

#define ONE_Q30 ((int32_t)0x40000000)

/* The least sine between two rays, 2^-12: at 68 mm of baseline 278 m. */
#define LEAST_SINE_Q30 (ONE_Q30 / 4096)
#define LEAST_SQUARE_Q60 (OCEL_Q60_ONE / 4096 / 4096)

/* The largest relative covariance, a deviation of half the range. */
#define MOST_RELATIVE_Q60 (OCEL_Q60_ONE / 4)

/* ---- vectors ---- */

/* a x b / 2^60, to 1 LSB.  |a|, |b| < 2^61 as vectors; the result is below 2^62. */
static void cross(const int64_t a[3], const int64_t b[3], int64_t product[3]) {
    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
        const uint32_t j = (i == 2U) ? 0U : (i + 1U);
        const uint32_t k = (j == 2U) ? 0U : (j + 1U);

        product[i] = ocel_mul_q60(a[j], b[k]) - ocel_mul_q60(a[k], b[j]);
    }
}

/* a . b / 2^60, up to 3 LSB low; ranges as above. */
static int64_t dot(const int64_t a[3], const int64_t b[3]) {
    return ocel_mul_q60(a[0], b[0]) + ocel_mul_q60(a[1], b[1]) + ocel_mul_q60(a[2], b[2]);
}

/* A direction's component from Q30 to Q60, a length from u to Q30. */
static int64_t wide(int32_t v) {
    return (int64_t)v * ONE_Q30;
}

/* ---- two rays ---- */

typedef struct {
    int64_t p_q30[3]; /* u, at most 2^58 each */
    int64_t d_q60[3];
} line_t;

/* False for what is no ray: a unit vector to 2^-17, that begins within the stated
 * positions.  Three squares of up to 2^62 fit uint64_t; the sums wrap on purpose. */
static bool line_of(const int32_t p_u[3], const int32_t d_q30[3], line_t *line) {
    const uint64_t slack_q60 = (uint64_t)1U << 44U;
    uint64_t excess_q60 = slack_q60 - (uint64_t)OCEL_Q60_ONE;
    bool within = true;

    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
        const int64_t square_q60 = (int64_t)d_q30[i] * d_q30[i];

        excess_q60 += (uint64_t)square_q60;
        within = within && (p_u[i] >= -OCEL_MAX_STEREO_U) && (p_u[i] <= OCEL_MAX_STEREO_U);
        line->p_q30[i] = wide(p_u[i]);
        line->d_q60[i] = wide(d_q30[i]);
    }
    return within && (excess_q60 <= (2U * slack_q60));
}

typedef struct {
    int64_t half_q60[3];   /* half of d_left x d_right, which is the sine times the normal */
    int64_t normal_q60[3]; /* its unit vector */
    int64_t y_q60;         /* 2 / sine = y 2^e, e 1 .. 13 */
    int32_t e;
    int64_t gap_q30;  /* u, along the normal */
    int64_t t_q30[2]; /* along each ray to the closest approach, u: 2^30 .. 2^58 */
} crossing_t;

/* How far along one ray the other is closest: (w x d of the other) . normal / sine. */
static ocel_status_t reach(const int64_t w_q30[3], const line_t *other, const crossing_t *c,
                           int64_t *t_q30) {
    ocel_status_t status = OCEL_OUT_OF_RANGE;
    int64_t moment_q30[3];
    int64_t half_q30; /* t / 2^(e - 1) */

    cross(w_q30, other->d_q60, moment_q30);
    half_q30 = ocel_mul_q60(dot(moment_q30, c->normal_q60), c->y_q60);
    if (half_q30 < ocel_scale_q60(1, 59 - c->e)) {
        *t_q30 = ocel_scale_q60(half_q30, c->e - 1);
        status = (*t_q30 < ONE_Q30) ? OCEL_DEGENERATE : OCEL_OK;
    }
    return status;
}

/* The closest approach of p_l + t_l d_l and p_r + t_r d_r.  With w = p_r - p_l and
 * n = d_l x d_r: t_l = (w x d_r) . n / n^2, t_r = (w x d_l) . n / n^2, and the gap is
 * w . n / |n|; none of it asks that the directions' length be 1 exactly.
 *
 * n / 2 is at most 2^59 and off by 2^-60; its square, 2^-26 or more, by 3 LSB: 2^-32 of
 * it at the least sine.  |n / 2| 2^e is 1 / y, within 1 and 2.01: halved it is fit for the
 * product, and the normal at most 1.01.  w is at most sqrt(3) 2^59 long, so are its
 * products; t / 2^e is held below 2^(58 - e). */
static ocel_status_t cross_rays(const line_t *left, const line_t *right, crossing_t *c) {
    ocel_status_t status = OCEL_DEGENERATE;
    int64_t w_q30[3];
    int64_t square_q60;

    cross(left->d_q60, right->d_q60, c->half_q60);
    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
        c->half_q60[i] = ocel_asr64(c->half_q60[i], 1U);
        w_q30[i] = right->p_q30[i] - left->p_q30[i];
    }
    square_q60 = dot(c->half_q60, c->half_q60);
    if (square_q60 >= (LEAST_SQUARE_Q60 / 4)) {
        ocel_rsqrt_q60((uint64_t)square_q60, &c->y_q60, &c->e);
        for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
            c->normal_q60[i] = 2 * ocel_mul_q60(ocel_scale_q60(c->half_q60[i], c->e - 1), c->y_q60);
        }
        c->gap_q30 = dot(w_q30, c->normal_q60);
        status = reach(w_q30, right, c, &c->t_q30[OCEL_LEFT]);
        if (status == OCEL_OK) {
            status = reach(w_q30, left, c, &c->t_q30[OCEL_RIGHT]);
        }
    }
    return status;
}

/* The point half-way and the gap.  Four terms of at most 2^58.1; the gap is at most |w|. */
static uint32_t between(const line_t *left, const line_t *right, const crossing_t *c,
                        int32_t p_u[3]) {
    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
        const int64_t twice_q30 = left->p_q30[i] + ocel_mul_q60(c->t_q30[0], left->d_q60[i]) +
                                  right->p_q30[i] + ocel_mul_q60(c->t_q30[1], right->d_q60[i]);

        p_u[i] = (int32_t)ocel_shift_round64(twice_q30, 31U);
    }
    return (uint32_t)((ocel_abs64(c->gap_q30) + ((uint64_t)1U << 29U)) >> 30U);
}

ocel_status_t ocel_stereo_midpoint(const ocel_ray_t *ray_left, const ocel_ray_t *ray_right,
                                   ocel_midpoint_t *midpoint) {
    ocel_status_t status = OCEL_NULL_ARGUMENT;

    if (midpoint != NULL) {
        (void)memset(midpoint, 0, sizeof(*midpoint));
    }
    if ((ray_left != NULL) && (ray_right != NULL) && (midpoint != NULL)) {
        line_t left;
        line_t right;
        crossing_t c;
        bool within;

        status = OCEL_OUT_OF_RANGE;
        within = line_of(ray_left->p_u, ray_left->d_q30, &left);
        if (line_of(ray_right->p_u, ray_right->d_q30, &right) && within) {
            status = cross_rays(&left, &right, &c);
        }
        if (status == OCEL_OK) {
            midpoint->gap_u = between(&left, &right, &c, midpoint->p_u);
            for (uint32_t i = 0U; i < 2U; i++) { /* bound: two eyes */
                midpoint->range_u[i] = (uint32_t)ocel_shift_round64(c.t_q30[i], 30U);
            }
        }
    }
    return status;
}

/* ---- encoders ---- */

/* A point before the eyes' middle as fractions of half the baseline b, (b/2) over / under,
 * |over| <= 2.
 *
 * Paper (eq. 14, with 1/tan for tan^-1): forward = (b/2) cos(EVG) / sin(EVG).
 * Exact: with the lines of sight at gl = version - EVG - residual_l and gr = version +
 * EVG - residual_r to the left, x = b / (tan gr - tan gl) ahead of the eyes' plane and
 * y = b/2 + x tan gl to the left.  With sum = gl + gr and apart = gr - gl that is
 *   x = (b/2) (cos sum + cos apart) / sin apart,   y = (b/2) sin sum / sin apart,
 * which needs no tangent, and seen from the version's direction v:
 *   forward = (b/2) (cos(sum - v) + cos apart cos v) / sin apart
 *   right   = (b/2) (cos apart sin v - sin(sum - v)) / sin apart. */
typedef struct {
    int64_t forward_q60;
    int64_t right_q60;
    int32_t under_q30;
} fractions_t;

static void fractions(ocel_encoders_t variant, uint32_t version_q32, int32_t vergence_q32,
                      const int32_t *residual_q32, fractions_t *f) {
    int32_t sin_v_q30;
    int32_t cos_v_q30;
    int32_t cos_q30;

    ocel_sincos(version_q32, &sin_v_q30, &cos_v_q30);
    if (variant == OCEL_ENCODERS_EXACT) {
        const uint32_t left_q32 = (uint32_t)residual_q32[OCEL_LEFT];
        const uint32_t right_q32 = (uint32_t)residual_q32[OCEL_RIGHT];
        int32_t sin_off_q30;
        int32_t cos_off_q30;

        ocel_sincos(((uint32_t)vergence_q32 + left_q32) - right_q32, &f->under_q30, &cos_q30);
        ocel_sincos((version_q32 - left_q32) - right_q32, &sin_off_q30, &cos_off_q30);
        f->forward_q60 = ((int64_t)cos_q30 * cos_v_q30) + wide(cos_off_q30);
        f->right_q60 = ((int64_t)cos_q30 * sin_v_q30) - wide(sin_off_q30);
    } else {
        const int32_t factor_q30 = (variant == OCEL_ENCODERS_COSINE) ? cos_v_q30 : ONE_Q30;

        ocel_sincos((uint32_t)ocel_asr32(vergence_q32, 1U), &f->under_q30, &cos_q30);
        f->forward_q60 = (int64_t)cos_q30 * factor_q30;
        f->right_q60 = 0;
    }
}

/* The fractions times half the baseline.  1 / under is y 2^e, e at most 12; over / 2 in Q60
 * is at most 2^60, the baseline in Q30 2^58: the result is below 2^41 u. */
static ocel_status_t place_fractions(const fractions_t *f, int32_t baseline_u,
                                     int32_t p_middle_u[3]) {
    const int64_t over_q60[2] = {f->right_q60, f->forward_q60};
    ocel_status_t status = OCEL_DEGENERATE;

    if ((f->under_q30 >= LEAST_SINE_Q30) && (f->forward_q60 > 0)) {
        int64_t p_u[2];
        int64_t y_q60;
        int32_t e;

        ocel_recip_q60((uint64_t)wide(f->under_q30), &y_q60, &e);
        for (uint32_t i = 0U; i < 2U; i++) { /* bound: right, forward */
            const int64_t half_q60 = ocel_mul_q60(ocel_asr64(over_q60[i], 1U), y_q60);

            p_u[i] = ocel_scale_q60(ocel_mul_q60(wide(baseline_u), half_q60), e - 30);
        }
        status = OCEL_OUT_OF_RANGE;
        if ((ocel_abs64(p_u[0]) | (uint64_t)p_u[1]) < OCEL_MAX_POSITION_U) {
            p_middle_u[0] = (int32_t)p_u[0];
            p_middle_u[2] = (int32_t)p_u[1];
            status = OCEL_OK;
        }
    }
    return status;
}

ocel_status_t ocel_stereo_encoders(ocel_encoders_t variant, int32_t baseline_u, int32_t version_q32,
                                   int32_t vergence_q32, const int32_t residual_q32[OCEL_EYE_COUNT],
                                   int32_t p_middle_u[3]) {
    ocel_status_t status = OCEL_NULL_ARGUMENT;

    if (p_middle_u != NULL) {
        (void)memset(p_middle_u, 0, 3U * sizeof(p_middle_u[0]));
    }
    if ((residual_q32 != NULL) && (p_middle_u != NULL)) {
        /* A quarter turn more is below half a turn for what is within a quarter. */
        const uint32_t quarter = 0x40000000U;
        const uint32_t turns = ((uint32_t)version_q32 + quarter) |
                               ((uint32_t)vergence_q32 + quarter) |
                               ((uint32_t)residual_q32[OCEL_LEFT] + quarter) |
                               ((uint32_t)residual_q32[OCEL_RIGHT] + quarter);

        if ((uint32_t)variant > (uint32_t)OCEL_ENCODERS_EXACT) {
            status = OCEL_BAD_OPTION;
        } else if ((turns >= (2U * quarter)) || (baseline_u < 1) ||
                   (baseline_u > OCEL_MAX_STEREO_U)) {
            status = OCEL_OUT_OF_RANGE;
        } else {
            fractions_t f;

            fractions(variant, (uint32_t)version_q32, vergence_q32, residual_q32, &f);
            status = place_fractions(&f, baseline_u, p_middle_u);
        }
    }
    return status;
}

/* ---- covariances ---- */

typedef struct {
    int64_t row_q60[3][3];
} matrix_t;

/* C v.  |v| <= 1.51 in Q60, elements of C below 2^60. */
static void times(const int64_t cov[OCEL_SYM3_COUNT], const int64_t v_q60[3], int64_t product[3]) {
    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
        const int64_t row[3] = {cov[ocel_sym3_at[i][0]], cov[ocel_sym3_at[i][1]],
                                cov[ocel_sym3_at[i][2]]};

        product[i] = dot(row, v_q60);
    }
}

/* sum += A C A^T. */
static void add_sandwich(const matrix_t *a, const int64_t cov[OCEL_SYM3_COUNT],
                         int64_t sum[OCEL_SYM3_COUNT]) {
    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
        int64_t product[3];

        times(cov, a->row_q60[i], product); /* row i of A C */
        for (uint32_t j = i; j < 3U; j++) { /* bound: 3 axes */
            sum[ocel_sym3_at[i][j]] += dot(product, a->row_q60[j]);
        }
    }
}

/* cov factor 2^shift, rounded up on the diagonal. */
static void scale_up(const int64_t cov[OCEL_SYM3_COUNT], int64_t factor_q60, int32_t shift,
                     int64_t out[OCEL_SYM3_COUNT]) {
    for (uint32_t k = 0U; k < (uint32_t)OCEL_SYM3_COUNT; k++) { /* bound: 6 elements */
        out[k] = ocel_scale_q60(ocel_mul_q60(cov[k], factor_q60), shift);
    }
    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
        out[ocel_sym3_at[i][i]]++;
    }
}

/* ---- the ball ---- */

/* What an eye sees, in the root's frame. */
typedef struct {
    line_t line;                      /* towards the ball */
    int64_t cov_q60[OCEL_SYM3_COUNT]; /* of the centre, over its distance squared */
    int64_t sin_q60;                  /* radius over distance */
    uint32_t range_u;                 /* by the radius */
    int64_t variance_u2;              /* of that */
} sight_t;

/* False for what is no cone.  Rows of a rotation have length 1 and elements of the
 * covariance are at most 2^58: whatever is in it, the rotated ones are at most 3 * 2^58.
 * A rotation keeps lengths, so the axis is checked in the root's frame. */
static bool look(const ocel_cone_t *cone, const ocel_pose_t *X_root_eye, sight_t *sight) {
    bool good = cone->sin_q30 <= (uint32_t)ONE_Q30;
    int32_t axis_q30[3];
    matrix_t r;

    for (uint32_t k = 0U; k < (uint32_t)OCEL_SYM3_COUNT; k++) { /* bound: 6 elements */
        good = good && (cone->cov_q60[k] >= -MOST_RELATIVE_Q60) &&
               (cone->cov_q60[k] <= MOST_RELATIVE_Q60);
    }
    ocel_pose_direction(X_root_eye, cone->axis_cam_q30, axis_q30);
    good = line_of(X_root_eye->p_u, axis_q30, &sight->line) && good;
    if (good) {
        for (uint32_t i = 0U; i < 3U; i++) {     /* bound: 3 axes */
            for (uint32_t j = 0U; j < 3U; j++) { /* bound: 3 axes */
                r.row_q60[i][j] = wide(X_root_eye->r_q30[i][j]);
            }
        }
        add_sandwich(&r, cone->cov_q60, sight->cov_q60);
        sight->sin_q60 = ocel_shl64((int64_t)cone->sin_q30, 30U);
    }
    return good;
}

/* The position by one eye and the radius.  The range squared is at most 2^60. */
static ocel_status_t place_by_radius(const ocel_cone_t *cone, const ocel_pose_t *X_root_eye,
                                     int32_t radius_u, sight_t *sight, ocel_estimate_t *estimate) {
    ocel_sphere_t sphere;
    ocel_status_t status = ocel_sphere_of_cone(cone, radius_u, &sphere);

    if (status == OCEL_OK) {
        const int64_t range_u = (int64_t)sphere.range_u;
        const int64_t square_u2 = range_u * range_u;
        int64_t along_q60[3] = {0, 0, 0};

        times(sight->cov_q60, sight->line.d_q60, along_q60);
        sight->range_u = sphere.range_u;
        sight->variance_u2 = ocel_mul_q60(dot(along_q60, sight->line.d_q60), square_u2) + 1;
        scale_up(sight->cov_q60, square_u2, 0, estimate->cov_root_u2);
        if (!ocel_pose_point(X_root_eye, sphere.p_cam_u, estimate->p_root_u)) {
            status = OCEL_OUT_OF_RANGE;
        }
    }
    return status;
}

/* How the midpoint follows the point that an eye sees: with k the eye's direction x normal,
 *   left:  M = (-d_right k^T + n normal^T / 2) / sine
 *   right: M = ( d_left  k^T + n normal^T / 2) / sine
 * (the solution of k_l . dp = k_l . e_l, k_r . dp = k_r . e_r and normal . dp = normal .
 * (e_l + e_r) / 2).  k and the normal are normal to the eye's direction: its uncertainty
 * along the ray falls out by itself.  Here M sine, whose rows are at most 1.51 long; `sign`
 * is -1 or 1. */
static void lever(const line_t *own, const line_t *other, int64_t sign, const crossing_t *c,
                  matrix_t *m) {
    int64_t k_q60[3];

    cross(own->d_q60, c->normal_q60, k_q60);
    for (uint32_t i = 0U; i < 3U; i++) {     /* bound: 3 axes */
        for (uint32_t j = 0U; j < 3U; j++) { /* bound: 3 axes */
            m->row_q60[i][j] = ocel_mul_q60(sign * other->d_q60[i], k_q60[j]) +
                               ocel_mul_q60(c->half_q60[i], c->normal_q60[j]);
        }
    }
}

/* The covariance of the midpoint: (M C M^T of both eyes) range^2 / sine^2.  The ranges go
 * to below 2^28 first, the farther one to 2^27 or more, so that small units lose nothing:
 * t = tau 2^(6 - lead).  Relative covariances of at most 3 * 2^58 then become at most
 * 2^55.6, and the sum of the sandwiches is below 2 * (1.51 sqrt(3))^2 * 2^55.6 < 2^59.4.
 * With 1 / sine^2 = y^2 2^(2 e - 2) no element is to exceed 2^50, a 16th of tau^2 or less,
 * so 2^52 u^2: otherwise the rays say nothing of the range (false). */
static bool spread_of_midpoint(const sight_t sights[OCEL_EYE_COUNT], const crossing_t *c,
                               int64_t cov_root_u2[OCEL_SYM3_COUNT]) {
    const int32_t lead = (int32_t)ocel_clz64((uint64_t)c->t_q30[0] | (uint64_t)c->t_q30[1]);
    const int64_t factor_q60 = ocel_mul_q60(c->y_q60, c->y_q60);
    int64_t sum[OCEL_SYM3_COUNT] = {0, 0, 0, 0, 0, 0};
    int64_t scaled[OCEL_SYM3_COUNT];
    uint64_t size = 0U;
    bool known;

    for (uint32_t i = 0U; i < 2U; i++) { /* bound: two eyes */
        const int64_t tau = ocel_scale_q60(c->t_q30[i], lead - 36);
        matrix_t m;

        scale_up(sights[i].cov_q60, tau * tau, 0, scaled);
        lever(&sights[i].line, &sights[1U - i].line, (2 * (int64_t)i) - 1, c, &m);
        add_sandwich(&m, scaled, sum);
    }
    for (uint32_t k = 0U; k < (uint32_t)OCEL_SYM3_COUNT; k++) { /* bound: 6 elements */
        size |= ocel_abs64(sum[k]);
    }
    known = ocel_mul_q60((int64_t)size, factor_q60) <= ocel_scale_q60(1, 52 - (2 * c->e));
    if (known) {
        scale_up(sum, factor_q60, (2 * (c->e - lead)) + 10, cov_root_u2);
    }
    return known;
}

/* p += g off, C -= g (C d)^T with g = C d / s; size is the trace of C.
 *
 * Elements of C are at most 2^52, components of C d at most the trace; s and the trace are
 * brought to below 2^60 together, one of them to 2^59 or more, so for e <= 4 g is at most
 * trace / s <= 2^5, 2^61 in Q56.  (For a larger e the directions know the range far better
 * than the radius, and nothing is added.)  What is off is within 5 sigmas and a 32nd, so the
 * step is below 5 * 2^26.5 + 2^5 * 2^28 / 32 < 2^30; the sum wraps for what is no covariance. */
static void kalman_step(const int64_t cd[3], int64_t s, uint64_t size, int64_t off_u,
                        ocel_estimate_t *estimate) {
    int64_t *cov = estimate->cov_root_u2;
    const int32_t up = (int32_t)ocel_clz64((uint64_t)s | size) - 4;
    int64_t y_q60;
    int32_t e;

    ocel_recip_q60((uint64_t)ocel_scale_q60(s, up), &y_q60, &e);
    for (uint32_t i = 0U; (i < 3U) && (e <= 4); i++) { /* bound: 3 axes */
        const int64_t g_q56 = ocel_scale_q60(ocel_mul_q60(ocel_scale_q60(cd[i], up), y_q60), e - 4);
        const int64_t step_q21 = ocel_mul_q60(g_q56, ocel_shl64(off_u, 25U));
        const uint32_t p_u =
            (uint32_t)estimate->p_root_u[i] + (uint32_t)ocel_shift_round64(step_q21, 21U);

        estimate->p_root_u[i] = (int32_t)p_u;
        for (uint32_t j = i; j < 3U; j++) { /* bound: 3 axes */
            cov[ocel_sym3_at[i][j]] -= ocel_mul_q60(g_q56, ocel_shl64(cd[j], 4U));
        }
    }
}

/* Adds an eye's range by the radius to an estimate by directions: one Kalman step with a
 * scalar, for the range and the directions of a cone have little in common (nothing, when
 * the whole outline is seen).  False, and the estimate as it was, when the two disagree, or
 * when a component of C d exceeds the trace, as none of a covariance does.  C's elements are
 * at most 2^52, so s = d C d + variance fits. */
static bool add_range(const sight_t *sight, ocel_estimate_t *estimate) {
    const int64_t *d_q60 = sight->line.d_q60;
    const int64_t *cov = estimate->cov_root_u2;
    const uint64_t size = (uint64_t)cov[OCEL_XX] + (uint64_t)cov[OCEL_YY] + (uint64_t)cov[OCEL_ZZ];
    bool agree = true;
    int64_t away_q30[3];
    int64_t cd[3];
    uint64_t limit_u;
    int64_t off_u;
    int64_t s;

    times(cov, d_q60, cd);
    s = dot(cd, d_q60) + sight->variance_u2;
    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
        away_q30[i] = wide(estimate->p_root_u[i]) - sight->line.p_q30[i];
        agree = agree && (ocel_abs64(cd[i]) <= size);
    }
    off_u = (int64_t)sight->range_u - ocel_shift_round64(dot(away_q30, d_q60), 30U);
    limit_u = ((uint64_t)OCEL_DISAGREE_SIGMAS * ocel_isqrt64((uint64_t)s)) +
              (sight->range_u >> OCEL_DISAGREE_SHIFT);
    agree = agree && (ocel_abs64(off_u) <= limit_u);
    if (agree) {
        kalman_step(cd, s, size, off_u, estimate);
    }
    return agree;
}

/* The directions' part: false when the rays do not meet. */
static bool place_by_stereo(const sight_t sights[OCEL_EYE_COUNT], ocel_ball_t *result) {
    const sight_t *const left = &sights[OCEL_LEFT];
    const sight_t *const right = &sights[OCEL_RIGHT];
    crossing_t c;
    bool meet = cross_rays(&left->line, &right->line, &c) == OCEL_OK;

    if (meet) {
        result->has_stereo = spread_of_midpoint(sights, &c, result->stereo.cov_root_u2);
    }
    if (result->has_stereo) {
        const int64_t radii_q30 = ocel_mul_q60(c.t_q30[OCEL_LEFT], left->sin_q60) +
                                  ocel_mul_q60(c.t_q30[OCEL_RIGHT], right->sin_q60);

        result->radius_u = (uint32_t)ocel_shift_round64(radii_q30, 31U);
        result->gap_u = between(&left->line, &right->line, &c, result->stereo.p_root_u);
        meet = result->gap_u <= (uint32_t)ocel_asr64(c.t_q30[OCEL_LEFT], 30U + OCEL_DISAGREE_SHIFT);
    }
    return meet;
}

/* What to believe.  Rays that miss each other discredit stereo; rays that meet vouch for
 * the eyes' poses, and a radius that denies their range is another ball's. */
static ocel_status_t judge(const sight_t sights[OCEL_EYE_COUNT], bool meet, ocel_ball_t *result) {
    const bool trusted = meet && result->has_stereo;
    ocel_status_t status = OCEL_OK;

    result->disagree = !meet;
    result->best = (result->has_radius && !trusted) ? result->by_radius : result->stereo;
    for (uint32_t i = 0U; i < 2U; i++) { /* bound: two eyes */
        if (result->has_radius && trusted && !result->disagree) {
            result->disagree = !add_range(&sights[i], &result->best);
        }
    }
    if (trusted && result->disagree) {
        result->best = result->stereo;
    }
    if (!result->has_stereo && !result->has_radius) {
        status = OCEL_DEGENERATE;
    } else if (result->disagree) {
        status = OCEL_PARTIAL;
    } else {
        /* vouched for */
    }
    return status;
}

static ocel_status_t see(const ocel_cone_t *cone, const ocel_pose_t *X_root_eye, int32_t radius_u,
                         sight_t *sight, ocel_estimate_t *estimate) {
    ocel_status_t status = look(cone, X_root_eye, sight) ? OCEL_OK : OCEL_OUT_OF_RANGE;

    if ((status == OCEL_OK) && (radius_u > 0)) {
        status = place_by_radius(cone, X_root_eye, radius_u, sight, estimate);
    }
    return status;
}

/* Of two eyes the surer one places the ball by its radius.  Their mean would be surer by a
 * factor of sqrt(2) at best, and would take half of the error of an eye that is fooled;
 * `best` takes both ranges anyway. */
static ocel_status_t place_ball(const ocel_cone_t *const cones[OCEL_EYE_COUNT],
                                const ocel_pose_t X_root_eye[OCEL_EYE_COUNT], int32_t radius_u,
                                ocel_ball_t *result) {
    ocel_status_t status = (radius_u < 0) ? OCEL_OUT_OF_RANGE : OCEL_OK;
    int64_t least_u2 = INT64_MAX;
    sight_t sights[OCEL_EYE_COUNT];

    (void)memset(sights, 0, sizeof(sights));
    result->has_radius = radius_u > 0;
    for (uint32_t i = 0U; i < 2U; i++) { /* bound: two eyes */
        if ((status == OCEL_OK) && (cones[i] != NULL)) {
            status = see(cones[i], &X_root_eye[i], radius_u, &sights[i], &result->best);
            if (result->has_radius && (sights[i].variance_u2 < least_u2)) {
                least_u2 = sights[i].variance_u2;
                result->by_radius = result->best;
            }
        }
    }
    if (status == OCEL_OK) {
        bool meet = true;

        if ((cones[OCEL_LEFT] != NULL) && (cones[OCEL_RIGHT] != NULL)) {
            meet = place_by_stereo(sights, result);
        }
        status = judge(sights, meet, result);
    }
    return status;
}

ocel_status_t ocel_stereo_ball(const ocel_cone_t *cone_left, const ocel_cone_t *cone_right,
                               const ocel_pose_t X_root_eye[OCEL_EYE_COUNT], int32_t radius_u,
                               ocel_ball_t *result) {
    const ocel_cone_t *const cones[OCEL_EYE_COUNT] = {cone_left, cone_right};
    ocel_status_t status = OCEL_NULL_ARGUMENT;

    if (result != NULL) {
        (void)memset(result, 0, sizeof(*result));
    }
    if ((result != NULL) && (X_root_eye != NULL)) {
        status = OCEL_NOT_SEEN;
        if ((cone_left != NULL) || (cone_right != NULL)) {
            status = place_ball(cones, X_root_eye, radius_u, result);
        }
        if ((status != OCEL_OK) && (status != OCEL_PARTIAL)) {
            (void)memset(result, 0, sizeof(*result));
        }
    }
    return status;
}
