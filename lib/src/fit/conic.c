/* SPDX-License-Identifier: MIT */
#include "conic.h"

#include <stdbool.h>

#include "../base/int_math.h"
#include "../base/q60.h"

/* Newton steps on the cubic.  In double-precision prototypes the descent from uu
 * took 6 steps in the median and 12 at most on arcs of 90 degrees; the start
 * below is never farther from the root.  A double root, where the convergence is
 * linear and no ellipse is to be had, runs into this cap. */
#define NEWTON_MAX 16U

/* A trace, a determinant or a derivative below 2^-44 of the largest possible
 * is what rounding leaves of zero (entries are good to about 2^-57). */
#define NOTHING_Q60 ((int64_t)0x10000)

/* |D|, |E| < 2^10 in Q48: beyond, the centre is far outside the points. */
#define LINEAR_MAX_Q48 ((int64_t)0x400000000000000)

/* The reduced problem M a = lambda C1 a in u = A + C, v = A - C, w = B, where
 * the constraint 4AC - B^2 is u^2 - v^2 - w^2 and M is scaled to a trace in
 * [1/2, 1).  M is positive semi-definite, so no entry exceeds the trace. */
typedef struct {
    int64_t uu;
    int64_t vv;
    int64_t ww;
    int64_t uv;
    int64_t uw;
    int64_t vw;
    int32_t up; /* the scaling was 2^up, -2..44 */
} reduced_t;

/* p(lambda) = -lambda^3 + c2 lambda^2 + c1 lambda + c0 = det(M - lambda J). */
typedef struct {
    int64_t c2;
    int64_t c1;
    int64_t c0;
} cubic_t;

/* The congruence (A, B, C) -> (u, v, w).  Sums of four entries stay within
 * 4.1 * 2^60 < 2^63. */
static ocel_status_t reduce(const ocel_scatter_t *scatter, reduced_t *m) {
    const int64_t aa = scatter->a_q60[ocel_scatter_at(OCEL_S_XX, OCEL_S_XX)];
    const int64_t ab = scatter->a_q60[ocel_scatter_at(OCEL_S_XY, OCEL_S_XX)];
    const int64_t ac = scatter->a_q60[ocel_scatter_at(OCEL_S_YY, OCEL_S_XX)];
    const int64_t bb = scatter->a_q60[ocel_scatter_at(OCEL_S_XY, OCEL_S_XY)];
    const int64_t bc = scatter->a_q60[ocel_scatter_at(OCEL_S_YY, OCEL_S_XY)];
    const int64_t cc = scatter->a_q60[ocel_scatter_at(OCEL_S_YY, OCEL_S_YY)];
    const int64_t uu = ocel_shift_round64(aa + (2 * ac) + cc, 2U);
    const int64_t vv = ocel_shift_round64((aa - (2 * ac)) + cc, 2U);
    const int64_t trace = uu + vv + bb;
    ocel_status_t status = OCEL_DEGENERATE;

    if (trace >= NOTHING_Q60) {
        m->up = (int32_t)ocel_clz64((uint64_t)trace) - 4;
        m->uu = ocel_scale_q60(uu, m->up);
        m->vv = ocel_scale_q60(vv, m->up);
        m->ww = ocel_scale_q60(bb, m->up);
        m->uv = ocel_scale_q60(ocel_shift_round64(aa - cc, 2U), m->up);
        m->uw = ocel_scale_q60(ocel_shift_round64(ab + bc, 1U), m->up);
        m->vw = ocel_scale_q60(ocel_shift_round64(ab - bc, 1U), m->up);
        status = OCEL_OK;
    }
    return status;
}

/* With H = [vv vw; vw ww] and g = (uv, uw):
 *   det(M - lambda J) = (uu - lambda) det(H + lambda I) - g' adj(H + lambda I) g.
 * Every term is a product of entries below 1 with a sum below 1. */
static cubic_t characteristic(const reduced_t *m) {
    const int64_t trace_h = m->vv + m->ww;
    const int64_t det_h = ocel_mul_q60(m->vv, m->ww) - ocel_mul_q60(m->vw, m->vw);
    const int64_t uv2 = ocel_mul_q60(m->uv, m->uv);
    const int64_t uw2 = ocel_mul_q60(m->uw, m->uw);
    const int64_t cross = ocel_mul_q60(m->vw, ocel_mul_q60(m->uv, m->uw));
    cubic_t p;

    p.c2 = m->uu - trace_h;
    p.c1 = ocel_mul_q60(m->uu, trace_h) - det_h - uv2 - uw2;
    p.c0 = ocel_mul_q60(m->uu, det_h) -
           ((ocel_mul_q60(m->ww, uv2) - (2 * cross)) + ocel_mul_q60(m->vv, uw2));
    return p;
}

/* num / den for den > 0 to 30 bits; |num / den| < 2^3. */
static int64_t quotient_q60(int64_t num, int64_t den) {
    uint32_t y_q31;
    int32_t e;

    ocel_recip_short((uint64_t)den, &y_q31, &e);
    return ocel_scale_q60(ocel_mul_q60(num, (int64_t)((uint64_t)y_q31 << 29U)), e);
}

/* -p'(lambda) / 2, where 0 <= lambda <= uu: |c2 - 1.5 lambda| <= 1. */
static int64_t fall_q60(const cubic_t *p, int64_t lambda) {
    const int64_t inner = p->c2 - (lambda + ocel_asr64(lambda, 1U));

    return -(ocel_mul_q60(inner, lambda) + ocel_asr64(p->c1, 1U));
}

/* Where Newton starts.  The largest root is the only one that is >= 0, and it
 * is at most uu; to its right p falls and is concave, so Newton from any point
 * there descends to it monotonically.  When p is concave from 0 on (c2 <= 0)
 * and falls at 0, the tangent at 0 meets zero right of the root, and for good
 * data much nearer to it than uu. */
static int64_t newton_start(const cubic_t *p, int64_t uu) {
    int64_t start = uu;

    if ((p->c2 <= 0) && (p->c1 <= -NOTHING_Q60) && (p->c0 < -p->c1)) {
        const int64_t tangent = quotient_q60((p->c0 > 0) ? p->c0 : 0, -p->c1);

        start = (tangent < uu) ? tangent : uu;
    }
    return start;
}

/* The largest root, by at most NEWTON_MAX steps; a step's quotient of 30 bits
 * leaves the limit, where p vanishes, as exact as p is. */
static int64_t largest_root_q60(const cubic_t *p, int64_t uu) {
    int64_t lambda = newton_start(p, uu);
    bool moving = true;
    uint32_t i;

    for (i = 0U; moving && (i < NEWTON_MAX); i++) { /* bound: NEWTON_MAX */
        const int64_t inner = ocel_mul_q60(p->c2 - lambda, lambda) + p->c1;
        const int64_t value = ocel_mul_q60(inner, lambda) + p->c0;
        const int64_t fall = fall_q60(p, lambda);
        int64_t step = 0;

        if (fall >= NOTHING_Q60) {
            step = quotient_q60(ocel_asr64(value, 1U), fall);
        }
        lambda += step;
        lambda = (lambda < 0) ? 0 : lambda;
        lambda = (lambda > uu) ? uu : lambda;
        moving = (step < -8) || (step > 8);
    }
    return lambda;
}

/* -num / det for |num| < det: within +-1. */
static int64_t minus_ratio_q60(int64_t num, const ocel_scaled_t *inverse) {
    return -ocel_scale_q60(ocel_mul_q60(num, inverse->y_q60), inverse->e);
}

/* The null vector of M - lambda J with u = 1: (v, w) = -(H + lambda I)^-1 g. */
static ocel_status_t null_vector(const reduced_t *m, int64_t lambda, ocel_conic_t *conic) {
    const int64_t vv = m->vv + lambda;
    const int64_t ww = m->ww + lambda;
    const int64_t det = ocel_mul_q60(vv, ww) - ocel_mul_q60(m->vw, m->vw);
    const int64_t num_v = ocel_mul_q60(ww, m->uv) - ocel_mul_q60(m->vw, m->uw);
    const int64_t num_w = ocel_mul_q60(vv, m->uw) - ocel_mul_q60(m->vw, m->uv);
    ocel_status_t status = OCEL_OK;

    if (det < NOTHING_Q60) {
        status = OCEL_DEGENERATE;
    } else if ((ocel_abs64(num_v) >= (uint64_t)det) || (ocel_abs64(num_w) >= (uint64_t)det)) {
        status = OCEL_NOT_AN_ELLIPSE;
    } else {
        ocel_scaled_t inverse;

        ocel_recip_q60((uint64_t)det, &inverse.y_q60, &inverse.e);
        conic->v_q60 = minus_ratio_q60(num_v, &inverse);
        conic->w_q60 = minus_ratio_q60(num_w, &inverse);
        status =
            (ocel_conic_flatness_q60(conic) < OCEL_CONIC_FLAT_Q60) ? OCEL_NOT_AN_ELLIPSE : OCEL_OK;
    }
    return status;
}

int64_t ocel_conic_flatness_q60(const ocel_conic_t *conic) {
    return OCEL_Q60_ONE - ocel_mul_q60(conic->v_q60, conic->v_q60) -
           ocel_mul_q60(conic->w_q60, conic->w_q60);
}

/* Row j of L times (A, B, C), over 4: |.| <= 3.1 / 4. */
static int64_t projection_q58(const ocel_scatter_t *scatter, const ocel_conic_t *conic,
                              uint32_t j) {
    const int64_t a = ocel_asr64(OCEL_Q60_ONE + conic->v_q60, 1U);
    const int64_t c = ocel_asr64(OCEL_Q60_ONE - conic->v_q60, 1U);
    const int64_t sum = ocel_mul_q60(scatter->a_q60[ocel_scatter_at(OCEL_S_XX, j)], a) +
                        ocel_mul_q60(scatter->a_q60[ocel_scatter_at(OCEL_S_XY, j)], conic->w_q60) +
                        ocel_mul_q60(scatter->a_q60[ocel_scatter_at(OCEL_S_YY, j)], c);

    return ocel_shift_round64(sum, 2U);
}

/* value * inverse * 2^down in the value's format, saturated to LINEAR_MAX. */
static int64_t solved(int64_t value, ocel_scaled_t inverse, int32_t up) {
    const int64_t product = ocel_mul_q60(value, inverse.y_q60);
    const int32_t shift = inverse.e + up;
    int64_t result = 0;

    if ((shift > 0) && (ocel_abs64(product) >= ((uint64_t)LINEAR_MAX_Q48 >> (uint32_t)shift))) {
        result = LINEAR_MAX_Q48;
    } else {
        result = ocel_scale_q60(product, shift);
    }
    return result;
}

/* Back substitution in L' (F, D, E) = -L'(quadratic part), rows y and x. */
ocel_status_t ocel_conic_linear(const ocel_scatter_t *scatter, ocel_conic_t *conic) {
    const int64_t y_part = projection_q58(scatter, conic, (uint32_t)OCEL_S_Y);
    const int64_t x_part = projection_q58(scatter, conic, (uint32_t)OCEL_S_X);
    bool small;

    conic->e_q48 = -solved(y_part, ocel_scatter_inverse(scatter, OCEL_S_Y), -10);
    small = ocel_abs64(conic->e_q48) < (uint64_t)LINEAR_MAX_Q48;
    if (small) {
        const int64_t rest =
            ocel_shift_round64(x_part, 10U) +
            ocel_mul_q60(scatter->a_q60[ocel_scatter_at(OCEL_S_Y, OCEL_S_X)], conic->e_q48);

        conic->d_q48 = -solved(rest, ocel_scatter_inverse(scatter, OCEL_S_X), 0);
        small = ocel_abs64(conic->d_q48) < (uint64_t)LINEAR_MAX_Q48;
    }
    return small ? OCEL_OK : OCEL_NOT_AN_ELLIPSE;
}

ocel_status_t ocel_conic_b2ac(const ocel_scatter_t *scatter, ocel_conic_t *conic,
                              int64_t *eigenvalue_q60) {
    reduced_t m;
    ocel_status_t status = reduce(scatter, &m);

    *eigenvalue_q60 = 0;
    if (status == OCEL_OK) {
        const cubic_t p = characteristic(&m);
        const int64_t lambda = largest_root_q60(&p, m.uu);

        *eigenvalue_q60 = lambda;
        status = null_vector(&m, lambda, conic);
        if (status == OCEL_OK) {
            conic->mean_q60 = 0; /* the constant F is free, so the mean vanishes */
            conic->energy.y_q60 = ocel_mul_q60(lambda, ocel_conic_flatness_q60(conic));
            conic->energy.e = -m.up;
            status = ocel_conic_linear(scatter, conic);
        }
    }
    return status;
}
