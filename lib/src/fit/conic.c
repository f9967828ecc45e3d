/* SPDX-License-Identifier: MIT */
#include "conic.h"

#include <stdbool.h>

#include "../base/int_math.h"
#include "../base/q60.h"
#include "../base/scale.h"
#include "../base/scale_all.h"
#include "../base/terms.h"

/* Newton steps on the cubic.  In double-precision prototypes the descent from uu
 * took 6 steps in the median and 12 at most on arcs of 90 degrees; the start
 * below is never farther from the root.  A double root, where the convergence is
 * linear and no ellipse is to be had, runs into this cap. */
#define NEWTON_MAX 16U

/* A trace, a determinant or a derivative below 2^-44 of the largest possible
 * is what rounding leaves of zero (entries are good to about 2^-57). */
#define NOTHING_Q60 ((int64_t)0x10000)

/* |D|, |E| < 2^10 in Q48: beyond, the centre is far outside the points. */
#define LINEAR_BITS 58

/* An axis ratio under 2^-15. */
#define FLAT_Q60 ((int64_t)4294967296)

/* The reduced problem M a = lambda C1 a in u = A + C, v = A - C, w = B, where
 * the constraint 4AC - B^2 is u^2 - v^2 - w^2 and M is scaled to a trace in
 * [1/2, 1).  M is positive semi-definite, so no entry exceeds the trace.  H is
 * [vv vw; vw ww], g is (uv, uw), and
 *   p(lambda) = -lambda^3 + c2 lambda^2 + c1 lambda + c0 = det(M - lambda J)
 *             = (uu - lambda) det(H + lambda I) - g' adj(H + lambda I) g. */
enum { M_UU = 0, M_VV, M_WW, M_UV, M_UW, M_VW, M_COUNT };
enum { TRACE_H = M_COUNT, DET_H, UV_UV, UW_UW, UV_UW, C2, C1, C0, WORK_COUNT };

/* Of the null vector, for which M's squares serve no more. */
enum { NUMERATOR_V = UV_UV, NUMERATOR_W = UW_UW };

/* The congruence (A, B, C) -> (u, v, w), and its scaling by 2^up, -2..44.  Sums of four
 * entries stay within 4.1 * 2^60 < 2^63. */
static ocel_status_t reduce(const ocel_scatter_t *scatter, int64_t *m, int64_t *down) {
    const int64_t aa = scatter->a_q60[ocel_scatter_at(OCEL_S_XX, OCEL_S_XX)];
    const int64_t ab = scatter->a_q60[ocel_scatter_at(OCEL_S_XY, OCEL_S_XX)];
    const int64_t ac = scatter->a_q60[ocel_scatter_at(OCEL_S_YY, OCEL_S_XX)];
    const int64_t bb = scatter->a_q60[ocel_scatter_at(OCEL_S_XY, OCEL_S_XY)];
    const int64_t bc = scatter->a_q60[ocel_scatter_at(OCEL_S_YY, OCEL_S_XY)];
    const int64_t cc = scatter->a_q60[ocel_scatter_at(OCEL_S_YY, OCEL_S_YY)];
    ocel_status_t status = OCEL_DEGENERATE;
    int64_t trace;

    m[M_UU] = aa + (2 * ac) + cc;
    m[M_VV] = (aa - (2 * ac)) + cc;
    m[M_WW] = 4 * bb;
    m[M_UV] = aa - cc;
    m[M_UW] = 2 * (ab + bc);
    m[M_VW] = 2 * (ab - bc);
    ocel_scale_all(m, (uint32_t)M_COUNT, -2);
    trace = m[M_UU] + m[M_VV] + m[M_WW];
    if (trace >= NOTHING_Q60) {
        const int32_t up = (int32_t)ocel_clz64((uint64_t)trace) - 4;

        ocel_scale_all(m, (uint32_t)M_COUNT, up);
        *down = -up;
        status = OCEL_OK;
    }
    return status;
}

/* Every term is a product of entries below 1 with a sum below 1. */
static void characteristic(int64_t *m) {
    static const ocel_term_t terms[] = {
        {OCEL_GOES_ON, M_VV, M_WW},    {OCEL_MINUS | DET_H, M_VW, M_VW},
        {UV_UV, M_UV, M_UV},           {UW_UW, M_UW, M_UW},
        {UV_UW, M_UV, M_UW},           {OCEL_GOES_ON, M_UU, TRACE_H},
        {OCEL_MINUS, M_VV, M_WW}, /* det H again, as it stands above */
        {OCEL_GOES_ON, M_VW, M_VW},    {OCEL_MINUS, M_UV, M_UV},
        {OCEL_MINUS | C1, M_UW, M_UW}, {OCEL_GOES_ON, M_UU, DET_H},
        {OCEL_MINUS, M_WW, UV_UV},     {OCEL_GOES_ON, M_VW, UV_UW},
        {OCEL_GOES_ON, M_VW, UV_UW},   {OCEL_LAST | OCEL_MINUS | C0, M_VV, UW_UW},
    };

    m[TRACE_H] = m[M_VV] + m[M_WW];
    m[C2] = m[M_UU] - m[TRACE_H];
    ocel_sum_terms(m, terms);
}

/* num / den for den > 0 to 30 bits; |num / den| < 2^3. */
static int64_t quotient_q60(int64_t num, int64_t den) {
    uint32_t y_q31;
    int32_t e;

    ocel_recip_short((uint64_t)den, &y_q31, &e);
    return ocel_scale_q60(ocel_mul_q60(num, (int64_t)((uint64_t)y_q31 << 29U)), e);
}

/* -p'(lambda) / 2, where 0 <= lambda <= uu: |c2 - 1.5 lambda| <= 1. */
static int64_t fall_q60(const int64_t *m, int64_t lambda) {
    const int64_t inner = m[C2] - (lambda + ocel_asr64(lambda, 1U));

    return -(ocel_mul_q60(inner, lambda) + ocel_asr64(m[C1], 1U));
}

/* Where Newton starts.  The largest root is the only one that is >= 0, and it
 * is at most uu; to its right p falls and is concave, so Newton from any point
 * there descends to it monotonically.  When p is concave from 0 on (c2 <= 0)
 * and falls at 0, the tangent at 0 meets zero right of the root, and for good
 * data much nearer to it than uu. */
static int64_t newton_start(const int64_t *m) {
    int64_t start = m[M_UU];

    if ((m[C2] <= 0) && (m[C1] <= -NOTHING_Q60) && (m[C0] < -m[C1])) {
        const int64_t tangent = quotient_q60((m[C0] > 0) ? m[C0] : 0, -m[C1]);

        start = (tangent < start) ? tangent : start;
    }
    return start;
}

/* The largest root, by at most NEWTON_MAX steps; a step's quotient of 30 bits
 * leaves the limit, where p vanishes, as exact as p is. */
static int64_t largest_root_q60(const int64_t *m) {
    int64_t lambda = newton_start(m);
    bool moving = true;
    uint32_t i;

    for (i = 0U; moving && (i < NEWTON_MAX); i++) { /* bound: NEWTON_MAX */
        const int64_t inner = ocel_mul_q60(m[C2] - lambda, lambda) + m[C1];
        const int64_t value = ocel_mul_q60(inner, lambda) + m[C0];
        const int64_t fall = fall_q60(m, lambda);
        int64_t step = 0;

        if (fall >= NOTHING_Q60) {
            step = quotient_q60(ocel_asr64(value, 1U), fall);
        }
        lambda += step;
        lambda = (lambda < 0) ? 0 : lambda;
        lambda = (lambda > m[M_UU]) ? m[M_UU] : lambda;
        moving = (step < -8) || (step > 8);
    }
    return lambda;
}

ocel_status_t ocel_conic_flatten(ocel_solution_t *solution) {
    int64_t *const q = solution->q60;
    const int64_t flatness = OCEL_Q60_ONE - ocel_mul_q60(q[OCEL_F_V], q[OCEL_F_V]) -
                             ocel_mul_q60(q[OCEL_F_W], q[OCEL_F_W]);

    q[OCEL_F_FLATNESS] = flatness;
    return (flatness < FLAT_Q60) ? OCEL_NOT_AN_ELLIPSE : OCEL_OK;
}

/* The null vector of M - lambda J with u = 1: (v, w) = -(H + lambda I)^-1 g, each within
 * 1. */
static ocel_status_t null_vector(int64_t *m, int64_t lambda, ocel_solution_t *solution) {
    static const ocel_term_t terms[] = {
        {OCEL_GOES_ON, M_VV, M_WW}, {OCEL_MINUS | DET_H, M_VW, M_VW},
        {OCEL_GOES_ON, M_WW, M_UV}, {OCEL_MINUS | NUMERATOR_V, M_VW, M_UW},
        {OCEL_GOES_ON, M_VV, M_UW}, {OCEL_LAST | OCEL_MINUS | NUMERATOR_W, M_VW, M_UV},
    };
    ocel_status_t status = OCEL_DEGENERATE;

    m[M_VV] += lambda;
    m[M_WW] += lambda;
    ocel_sum_terms(m, terms);
    if (m[DET_H] >= NOTHING_Q60) {
        ocel_scaled_t inverse;

        status = OCEL_OK;
        ocel_recip_q60((uint64_t)m[DET_H], &inverse.y_q60, &inverse.e);
        for (uint32_t i = 0U; i < 2U; i++) { /* bound: 2 */
            const int64_t numerator = m[NUMERATOR_V + i];

            if (ocel_abs64(numerator) >= (uint64_t)m[DET_H]) {
                status = OCEL_NOT_AN_ELLIPSE;
            } else {
                solution->q60[OCEL_F_V + i] =
                    -ocel_scale_q60(ocel_mul_q60(numerator, inverse.y_q60), inverse.e);
            }
        }
        if (status == OCEL_OK) {
            status = ocel_conic_flatten(solution);
        }
    }
    return status;
}

/* Row j of L times (A, B, C), over 4: |.| <= 3.1 / 4. */
static int64_t projection_q58(const ocel_scatter_t *scatter, const int64_t quadratic_q60[3],
                              uint32_t j) {
    int64_t sum = 0;

    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 */
        sum += ocel_mul_q60(scatter->a_q60[ocel_scatter_at((uint32_t)OCEL_S_XX + i, j)],
                            quadratic_q60[i]);
    }
    return ocel_shift_round64(sum, 2U);
}

/* D and E that make the mean of the polynomial times x, and times y, vanish: back
 * substitution in L' (F, D, E) = -L'(quadratic part), row y, then row x. */
static ocel_status_t find_linear(const ocel_scatter_t *scatter, ocel_solution_t *solution) {
    int64_t *const q = solution->q60;
    const int64_t quadratic_q60[3] = {ocel_asr64(OCEL_Q60_ONE + q[OCEL_F_V], 1U), q[OCEL_F_W],
                                      ocel_asr64(OCEL_Q60_ONE - q[OCEL_F_V], 1U)};
    bool small = true;

    for (uint32_t row = OCEL_S_Y; small && (row >= (uint32_t)OCEL_S_X); row--) { /* bound: 2 */
        int64_t *const linear = &q[(uint32_t)OCEL_F_D_Q48 + (row - (uint32_t)OCEL_S_X)];
        const ocel_scaled_t inverse = ocel_scatter_inverse(scatter, row);
        int32_t up = -10; /* from the projection's 2^-2 to Q48 */
        int64_t rest = projection_q58(scatter, quadratic_q60, row);

        if (row == (uint32_t)OCEL_S_X) {
            rest =
                ocel_shift_round64(rest, 10U) +
                ocel_mul_q60(scatter->a_q60[ocel_scatter_at(OCEL_S_Y, OCEL_S_X)], q[OCEL_F_E_Q48]);
            up = 0;
        }
        *linear = ocel_mul_q60(rest, inverse.y_q60);
        up += inverse.e;
        small = (ocel_bits_of(linear, 1U) + up) <= LINEAR_BITS; /* so that it can be shifted */
        if (small) {
            *linear = -ocel_scale_q60(*linear, up);
            small = ocel_bits_of(linear, 1U) <= LINEAR_BITS;
        }
    }
    return small ? OCEL_OK : OCEL_NOT_AN_ELLIPSE;
}

ocel_status_t ocel_conic_b2ac(const ocel_scatter_t *scatter, ocel_solution_t *solution,
                              int64_t *eigenvalue_q60) {
    int64_t m[WORK_COUNT];
    int64_t *const q = solution->q60;
    ocel_status_t status = reduce(scatter, m, &q[OCEL_F_ENERGY_E]);

    *eigenvalue_q60 = 0;
    if (status == OCEL_OK) {
        int64_t lambda;

        characteristic(m);
        lambda = largest_root_q60(m);
        *eigenvalue_q60 = lambda;
        status = null_vector(m, lambda, solution);
        if (status == OCEL_OK) {
            q[OCEL_F_MEAN] = 0; /* the constant F is free, so the mean vanishes */
            q[OCEL_F_ENERGY] = ocel_mul_q60(lambda, q[OCEL_F_FLATNESS]);
            status = find_linear(scatter, solution);
        }
    }
    return status;
}
