/* SPDX-License-Identifier: MIT
 *
 * The ball by two cones of rays: directions by stereo, ranges by the radius, and whether
 * they agree.
 */
#include <ocellus/stereo.h>

#include <stddef.h>
#include <string.h>

#include <ocellus/sphere.h>

#include "../base/int_math.h"
#include "../base/q60.h"
#include "../base/scale.h"
#include "covariance.h"
#include "pose.h"
#include "ray_pair.h"

#define ONE_Q30 ((int32_t)0x40000000)

/* The largest relative covariance, a deviation of half the range. */
#define MOST_RELATIVE_Q60 (OCEL_Q60_ONE / 4)

/* What an eye sees, in the root's frame. */
typedef struct {
    ocel_line_t line;                 /* towards the ball */
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
    ocel_matrix_t r;

    for (uint32_t k = 0U; k < (uint32_t)OCEL_SYM3_COUNT; k++) { /* bound: 6 elements */
        good = good && (cone->cov_q60[k] >= -MOST_RELATIVE_Q60) &&
               (cone->cov_q60[k] <= MOST_RELATIVE_Q60);
    }
    ocel_pose_direction(X_root_eye, cone->axis_cam_q30, axis_q30);
    good = ocel_line_of(X_root_eye->p_u, axis_q30, &sight->line) && good;
    if (good) {
        for (uint32_t i = 0U; i < 3U; i++) {     /* bound: 3 axes */
            for (uint32_t j = 0U; j < 3U; j++) { /* bound: 3 axes */
                r.row_q60[i][j] = ocel_widen_q30(X_root_eye->r_q30[i][j]);
            }
        }
        ocel_cov_add_sandwich(&r, cone->cov_q60, sight->cov_q60);
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

        ocel_cov_times(sight->cov_q60, sight->line.d_q60, along_q60);
        sight->range_u = sphere.range_u;
        sight->variance_u2 =
            ocel_mul_q60(ocel_dot_q60(along_q60, sight->line.d_q60), square_u2) + 1;
        ocel_cov_scale(sight->cov_q60, square_u2, 0, estimate->cov_root_u2);
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
static void lever(const ocel_line_t *own, const ocel_line_t *other, int64_t sign,
                  const ocel_crossing_t *c, ocel_matrix_t *m) {
    int64_t k_q60[3];

    ocel_cross_q60(own->d_q60, c->normal_q60, k_q60);
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
static bool spread_of_midpoint(const sight_t sights[OCEL_EYE_COUNT], const ocel_crossing_t *c,
                               int64_t cov_root_u2[OCEL_SYM3_COUNT]) {
    const int32_t lead = (int32_t)ocel_clz64((uint64_t)c->t_q30[0] | (uint64_t)c->t_q30[1]);
    const int64_t factor_q60 = ocel_mul_q60(c->y_q60, c->y_q60);
    int64_t sum[OCEL_SYM3_COUNT] = {0, 0, 0, 0, 0, 0};
    int64_t scaled[OCEL_SYM3_COUNT];
    uint64_t size = 0U;
    bool known;

    for (uint32_t i = 0U; i < 2U; i++) { /* bound: 2 eyes */
        const int64_t tau = ocel_scale_q60(c->t_q30[i], lead - 36);
        ocel_matrix_t m;

        ocel_cov_scale(sights[i].cov_q60, tau * tau, 0, scaled);
        lever(&sights[i].line, &sights[1U - i].line, (2 * (int64_t)i) - 1, c, &m);
        ocel_cov_add_sandwich(&m, scaled, sum);
    }
    for (uint32_t k = 0U; k < (uint32_t)OCEL_SYM3_COUNT; k++) { /* bound: 6 elements */
        size |= ocel_abs64(sum[k]);
    }
    known = ocel_mul_q60((int64_t)size, factor_q60) <= ocel_scale_q60(1, 52 - (2 * c->e));
    if (known) {
        ocel_cov_scale(sum, factor_q60, (2 * (c->e - lead)) + 10, cov_root_u2);
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

    ocel_cov_times(cov, d_q60, cd);
    s = ocel_dot_q60(cd, d_q60) + sight->variance_u2;
    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
        away_q30[i] = ocel_widen_q30(estimate->p_root_u[i]) - sight->line.p_q30[i];
        agree = agree && (ocel_abs64(cd[i]) <= size);
    }
    off_u = (int64_t)sight->range_u - ocel_shift_round64(ocel_dot_q60(away_q30, d_q60), 30U);
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
    ocel_crossing_t c;
    bool meet = ocel_line_cross(&left->line, &right->line, &c) == OCEL_OK;

    if (meet) {
        result->has_stereo = spread_of_midpoint(sights, &c, result->stereo.cov_root_u2);
    }
    if (result->has_stereo) {
        const int64_t radii_q30 = ocel_mul_q60(c.t_q30[OCEL_LEFT], left->sin_q60) +
                                  ocel_mul_q60(c.t_q30[OCEL_RIGHT], right->sin_q60);

        result->radius_u = (uint32_t)ocel_shift_round64(radii_q30, 31U);
        result->gap_u = ocel_line_between(&left->line, &right->line, &c, result->stereo.p_root_u);
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
    for (uint32_t i = 0U; i < 2U; i++) { /* bound: 2 eyes */
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
    for (uint32_t i = 0U; i < 2U; i++) { /* bound: 2 eyes */
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
