/* SPDX-License-Identifier: MIT */
#include "hyper.h"

#include <stdbool.h>
#include <string.h>

#include "../base/int_math.h"
#include "../base/q60.h"
#include "../base/scale.h"
#include "../base/scale_all.h"
#include "conic.h"
#include "scatter.h"

/* Inverse power steps t <- cov^-1 N t.  The second eigenvalue is 10 to 100 times
 * the first on arcs that an ellipse can be fitted to: after three steps the
 * centre is within 1 % of its expected error of the limit, after four no noise
 * that leaves an ellipse moves it. */
#define POWER_STEPS 4U

/* Monomials without the constant, in the order x, y, xx, xy, yy. */
#define SIZE 5U
#define AT_X 0U
#define AT_Y 1U
#define AT_XX 2U
#define AT_XY 3U
#define AT_YY 4U

/* Pivots: a middle one below this means no unique conic; the last one, which is
 * zero for exact points, is taken as this instead. */
#define LEAST_Q60 ((int64_t)0x400)

/* |A + C| at least 2^-12 of the largest coefficient. */
#define ROUND_MIN_BITS 12U

/* Coefficients are kept with the largest in [2^57, 2^58): a quarter, so that
 * five of them times entries of 1.01 stay below 2. */
#define VECTOR_BITS 58

typedef struct {
    int64_t t[SIZE];
} vector_t;

typedef struct {
    const int64_t *m_q60; /* the points' moments */
    int64_t p;            /* the noise's covariance in the frame, up to scale */
    int64_t q;
    int64_t r;
} metric_t;

/* Isotropic noise in the image is adj(G) adj(G)' in the frame, up to scale;
 * scaled here to at most 1/8. */
static void noise_metric(const int64_t *q60, metric_t *n) {
    const int64_t p = ocel_mul_q60(q60[OCEL_F_G22], q60[OCEL_F_G22]);
    const int64_t q = -ocel_mul_q60(q60[OCEL_F_G22], q60[OCEL_F_G21]);
    const int64_t r = ocel_mul_q60(q60[OCEL_F_G21], q60[OCEL_F_G21]) +
                      ocel_mul_q60(q60[OCEL_F_G11], q60[OCEL_F_G11]);
    const int64_t larger = (p > r) ? p : r;
    const int32_t e = 57 - ocel_bits_of(&larger, 1U);

    n->p = ocel_scale_q60(p, e);
    n->q = ocel_scale_q60(q, e);
    n->r = ocel_scale_q60(r, e);
}

/* v[i] <- rest / L[i][i].  The whole vector, solved and unsolved parts alike,
 * is scaled down as far as the new element needs to stay below 2^57. */
static void divide_element(vector_t *v, uint32_t i, int64_t rest, ocel_scaled_t inverse) {
    const int64_t product = ocel_mul_q60(rest, inverse.y_q60);
    const int32_t over = (ocel_bits_of(&product, 1U) + inverse.e) - (VECTOR_BITS - 1);
    const int32_t down = (over > 0) ? over : 0;

    v->t[i] = 0;
    if (down > 0) {
        ocel_scale_all(v->t, SIZE, (down > 62) ? -62 : -down);
    }
    v->t[i] = ocel_scale_q60(product, inverse.e - down);
}

/* v <- (L L')^-1 v up to scale, L the factor of the covariance. */
static void solve(const ocel_scatter_t *scatter, vector_t *v) {
    uint32_t i;
    uint32_t k;

    for (i = 0U; i < SIZE; i++) { /* bound: SIZE */
        int64_t rest = v->t[i];

        for (k = 0U; k < i; k++) { /* bound: SIZE */
            rest -= ocel_mul_q60(scatter->a_q60[ocel_scatter_at(i + 1U, k + 1U)], v->t[k]);
        }
        divide_element(v, i, rest, ocel_scatter_inverse(scatter, i + 1U));
    }
    for (i = SIZE; i > 0U; i--) { /* bound: SIZE */
        int64_t rest = v->t[i - 1U];

        for (k = i; k < SIZE; k++) { /* bound: SIZE */
            rest -= ocel_mul_q60(scatter->a_q60[ocel_scatter_at(k + 1U, i)], v->t[k]);
        }
        divide_element(v, i - 1U, rest, ocel_scatter_inverse(scatter, i));
    }
    (void)ocel_normalise(v->t, SIZE, VECTOR_BITS);
}

/* Where the gradient's components, linear in (1, x, y), take their coefficients:
 * d/dx = (D, 2A, B), d/dy = (E, B, 2C). */
static const uint8_t in_dx[3] = {AT_X, AT_XX, AT_XY};
static const uint8_t in_dy[3] = {AT_Y, AT_XY, AT_YY};

static int64_t gradient(const vector_t *v, const uint8_t *in, uint32_t k) {
    const uint32_t at = in[k];

    return ((at == AT_XX) || (at == AT_YY)) ? (2 * v->t[at]) : v->t[at];
}

/* v <- N_T v, N_T = mean of J S J' with J the gradients of the monomials and
 * S = [p q; q r]: mixes the gradient's two components by S, applies the second
 * moments of (1, x, y), and goes back.  With
 * |v| <= 1/4 and S <= 1/8 the mixtures are below 1/8, the result below 3/2.
 * Returns v' N_T v, of v as it was. */
static int64_t apply_metric(const metric_t *n, vector_t *v) {
    /* The second moments of 1, x, y. */
    static const uint8_t place[3][3] = {{OCEL_M_1, OCEL_M_X, OCEL_M_Y},
                                        {OCEL_M_X, OCEL_M_XX, OCEL_M_XY},
                                        {OCEL_M_Y, OCEL_M_XY, OCEL_M_YY}};
    int64_t gx[3] = {0, 0, 0};
    int64_t gy[3] = {0, 0, 0};
    int64_t form = 0;
    uint32_t i;
    uint32_t k;

    for (k = 0U; k < 3U; k++) { /* bound: 3 */
        const int64_t dx = gradient(v, in_dx, k);
        const int64_t dy = gradient(v, in_dy, k);
        const int64_t mx = ocel_mul_q60(n->p, dx) + ocel_mul_q60(n->q, dy);
        const int64_t my = ocel_mul_q60(n->q, dx) + ocel_mul_q60(n->r, dy);

        for (i = 0U; i < 3U; i++) { /* bound: 3 */
            gx[i] += ocel_mul_q60(n->m_q60[place[i][k]], mx);
            gy[i] += ocel_mul_q60(n->m_q60[place[i][k]], my);
        }
    }
    for (k = 0U; k < 3U; k++) { /* bound: 3 */
        form +=
            ocel_mul_q60(gradient(v, in_dx, k), gx[k]) + ocel_mul_q60(gradient(v, in_dy, k), gy[k]);
    }
    v->t[AT_X] = gx[0];
    v->t[AT_Y] = gy[0];
    v->t[AT_XX] = 2 * gx[1];
    v->t[AT_XY] = gx[2] + gy[1];
    v->t[AT_YY] = 2 * gy[2];
    return form;
}

/* t' cov t = |L' t|^2. */
static int64_t residual_q60(const ocel_scatter_t *scatter, const vector_t *v) {
    int64_t sum = 0;
    uint32_t i;
    uint32_t k;

    for (k = 0U; k < SIZE; k++) { /* bound: SIZE */
        int64_t component = 0;

        for (i = k; i < SIZE; i++) { /* bound: SIZE */
            component += ocel_mul_q60(scatter->a_q60[ocel_scatter_at(i + 1U, k + 1U)], v->t[i]);
        }
        sum += ocel_mul_q60(component, component);
    }
    return sum;
}

/* The factor of the whole matrix, its last pivot kept above zero. */
static bool finish_factor(ocel_scatter_t *scatter) {
    int64_t *const last = &scatter->a_q60[ocel_scatter_at(OCEL_S_YY, OCEL_S_YY)];
    bool unique = ocel_scatter_eliminate(scatter, (uint32_t)OCEL_S_XX, LEAST_Q60);

    if (unique) {
        unique = ocel_scatter_eliminate(scatter, (uint32_t)OCEL_S_XY, LEAST_Q60);
    }
    if (unique) {
        *last = (*last < LEAST_Q60) ? LEAST_Q60 : *last;
        (void)ocel_scatter_eliminate(scatter, (uint32_t)OCEL_S_YY, 1);
    }
    return unique;
}

/* value / (A + C), where |value| < 2 |A + C|; in Q60 scaled by 2^e more. */
static int64_t over(int64_t value, const ocel_scaled_t *inverse, int32_t e) {
    return ocel_scale_q60(ocel_mul_q60(value, inverse->y_q60), inverse->e + e);
}

/* Scales the vector to A + C = 1. */
static ocel_status_t conic_of(const vector_t *v, ocel_solution_t *solution,
                              ocel_scaled_t *inverse) {
    const int64_t sum = v->t[AT_XX] + v->t[AT_YY];
    const int64_t difference = v->t[AT_XX] - v->t[AT_YY];
    const uint64_t size = ocel_abs64(sum);
    ocel_status_t status = OCEL_NOT_AN_ELLIPSE;

    if ((size >= ((uint64_t)1 << (57U - ROUND_MIN_BITS))) && (ocel_abs64(difference) < size) &&
        (ocel_abs64(v->t[AT_XY]) < size)) {
        int64_t *const q = solution->q60;

        ocel_recip_q60(size, &inverse->y_q60, &inverse->e);
        inverse->y_q60 = (sum < 0) ? -inverse->y_q60 : inverse->y_q60;
        q[OCEL_F_V] = over(difference, inverse, 0);
        q[OCEL_F_W] = over(v->t[AT_XY], inverse, 0);
        q[OCEL_F_D_Q48] = over(v->t[AT_X], inverse, -12);
        q[OCEL_F_E_Q48] = over(v->t[AT_Y], inverse, -12);
        status = ocel_conic_flatten(solution);
    }
    return status;
}

/* lambda = (t' cov t) / (t' N t), the noise's variance in the metric's unit; a
 * value of 1 or more, noise as large as the figure, is refused. */
static bool variance_q60(int64_t residual, int64_t slope, int64_t *lambda) {
    const bool usable = (residual >= 0) && (slope > residual);

    if (usable) {
        ocel_scaled_t inverse;

        ocel_recip_q60((uint64_t)slope, &inverse.y_q60, &inverse.e);
        *lambda = over(residual, &inverse, 0);
    }
    return usable;
}

/* The polynomial's mean over the points that makes the fit unbiased, and its
 * mean square.  Uses v up. */
static ocel_status_t finish_conic(const ocel_scatter_t *scatter, const metric_t *n, vector_t *v,
                                  ocel_solution_t *solution) {
    const int64_t residual = residual_q60(scatter, v);
    const int64_t bias = ocel_mul_q60(n->p, v->t[AT_XX]) + ocel_mul_q60(n->q, v->t[AT_XY]) +
                         ocel_mul_q60(n->r, v->t[AT_YY]);
    ocel_scaled_t inverse;
    int64_t lambda;
    ocel_status_t status = conic_of(v, solution, &inverse);

    if ((status == OCEL_OK) && (!variance_q60(residual, apply_metric(n, v), &lambda))) {
        status = OCEL_NOT_AN_ELLIPSE;
    }
    if (status == OCEL_OK) {
        int64_t *const q = solution->q60;

        q[OCEL_F_MEAN] = over(ocel_mul_q60(lambda, bias), &inverse, 0);
        q[OCEL_F_ENERGY] = ocel_mul_q60(residual, ocel_mul_q60(inverse.y_q60, inverse.y_q60));
        q[OCEL_F_ENERGY_E] = (int64_t)2 * inverse.e;
    }
    return status;
}

ocel_status_t ocel_conic_hyper(ocel_solution_t *solution) {
    ocel_scatter_t scatter;
    ocel_status_t status = OCEL_DEGENERATE;

    if (ocel_scatter_reduce(solution, &scatter) && finish_factor(&scatter)) {
        vector_t v = {{0, 0, (int64_t)0x200000000000000, 0, (int64_t)0x200000000000000}};
        metric_t n;
        uint32_t i;

        noise_metric(solution->q60, &n);
        n.m_q60 = &solution->q60[OCEL_F_MOMENTS];
        for (i = 0U; i < POWER_STEPS; i++) { /* bound: POWER_STEPS */
            (void)apply_metric(&n, &v);
            solve(&scatter, &v);
        }
        status = finish_conic(&scatter, &n, &v, solution);
    }
    return status;
}
