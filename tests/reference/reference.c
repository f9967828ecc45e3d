/* SPDX-License-Identifier: MIT */
#include "reference.h"

#include <math.h>
#include <string.h>

#define PI 3.14159265358979323846264338327950288L

/* Eigenvalues below this share of the largest are the zeros of exact data: 64
 * mantissa bits leave rounding of about 1e-19. */
#define ZERO_SHARE 1e-22L

enum { JACOBI_SWEEPS = 60, CONIC = 6 };

typedef ref_real_t matrix_t[6][6];

const char *ref_method_name(ref_method_t method) {
    static const char *const names[REF_METHODS] = {"b2ac", "taubin", "taubin-shifted", "semi-hyper",
                                                   "hyper"};
    return (method < REF_METHODS) ? names[method] : "unknown";
}

/* ---- Symmetric eigenproblems ---- */

static void rotate(int n, matrix_t m, matrix_t v, int p, int q) {
    const ref_real_t theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
    const ref_real_t sign = (theta < 0) ? -1 : 1;
    const ref_real_t t = sign / (fabsl(theta) + sqrtl(theta * theta + 1));
    const ref_real_t c = 1 / sqrtl(t * t + 1);
    const ref_real_t s = t * c;
    for (int k = 0; k < n; k++) {
        const ref_real_t kp = m[k][p];
        const ref_real_t kq = m[k][q];
        m[k][p] = c * kp - s * kq;
        m[k][q] = s * kp + c * kq;
    }
    for (int k = 0; k < n; k++) {
        const ref_real_t pk = m[p][k];
        const ref_real_t qk = m[q][k];
        m[p][k] = c * pk - s * qk;
        m[q][k] = s * pk + c * qk;
    }
    m[p][q] = 0;
    m[q][p] = 0;
    for (int k = 0; k < n; k++) {
        const ref_real_t kp = v[k][p];
        const ref_real_t kq = v[k][q];
        v[k][p] = c * kp - s * kq;
        v[k][q] = s * kp + c * kq;
    }
}

void ref_jacobi(int n, matrix_t m, ref_real_t value[6], matrix_t v) {
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            v[i][j] = (i == j) ? 1 : 0;
        }
    }
    bool rotated = true;
    for (int sweep = 0; (sweep < JACOBI_SWEEPS) && rotated; sweep++) {
        rotated = false;
        for (int p = 0; p < n; p++) {
            for (int q = p + 1; q < n; q++) {
                /* Relative to the diagonal: small eigenvalues keep their digits. */
                const ref_real_t small = 1e-21L * sqrtl(fabsl(m[p][p]) * fabsl(m[q][q]));
                if ((m[p][q] != 0) && (fabsl(m[p][q]) > small)) {
                    rotate(n, m, v, p, q);
                    rotated = true;
                }
            }
        }
    }
    for (int i = 0; i < n; i++) {
        value[i] = m[i][i];
    }
}

/* The x that makes x^T c x / x^T m x largest in magnitude (or largest, when
 * `positive`), for a positive semi-definite m: m = V D V^T, then the symmetric
 * D^-1/2 V^T c V D^-1/2.  With an exact null vector of m (exact data) that vector
 * wins, as it should: zero eigenvalues are raised to ZERO_SHARE of the largest.
 * lambda gets x^T m x / x^T c x. */
static bool extreme(int n, matrix_t m, matrix_t c, bool positive, ref_real_t *x,
                    ref_real_t *lambda) {
    matrix_t v;
    matrix_t w;
    matrix_t u;
    ref_real_t d[6];
    ref_real_t mu[6];
    ref_jacobi(n, m, d, v);
    ref_real_t largest = 0;
    for (int i = 0; i < n; i++) {
        largest = fmaxl(largest, d[i]);
    }
    if (!(largest > 0)) {
        return false;
    }
    for (int i = 0; i < n; i++) {
        d[i] = sqrtl(fmaxl(d[i], ZERO_SHARE * largest));
    }
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            ref_real_t sum = 0;
            for (int k = 0; k < n; k++) {
                for (int l = 0; l < n; l++) {
                    sum += v[k][i] * c[k][l] * v[l][j];
                }
            }
            w[i][j] = sum / (d[i] * d[j]);
        }
    }
    ref_jacobi(n, w, mu, u);
    int best = 0;
    for (int i = 1; i < n; i++) {
        const bool better = positive ? (mu[i] > mu[best]) : (fabsl(mu[i]) > fabsl(mu[best]));
        best = better ? i : best;
    }
    for (int i = 0; i < n; i++) {
        x[i] = 0;
        for (int k = 0; k < n; k++) {
            x[i] += v[i][k] / d[k] * u[k][best];
        }
    }
    *lambda = 1 / mu[best];
    return !positive || (mu[best] > 0);
}

/* ---- Moments ---- */

static void monomials(ref_real_t x, ref_real_t y, ref_real_t xi[6]) {
    xi[0] = x * x;
    xi[1] = 2 * x * y;
    xi[2] = y * y;
    xi[3] = 2 * x;
    xi[4] = 2 * y;
    xi[5] = 1;
}

/* The covariance of xi under unit noise in x and y (Kanatani's V0[xi]). */
static void covariance(ref_real_t x, ref_real_t y, matrix_t v0) {
    const ref_real_t dx[6] = {2 * x, 2 * y, 0, 2, 0, 0};
    const ref_real_t dy[6] = {0, 2 * x, 2 * y, 0, 2, 0};
    for (int i = 0; i < CONIC; i++) {
        for (int j = 0; j < CONIC; j++) {
            v0[i][j] = dx[i] * dx[j] + dy[i] * dy[j];
        }
    }
}

static bool normalisation(const ref_point_t *points, size_t count, ref_conic_t *conic) {
    ref_real_t sx = 0;
    ref_real_t sy = 0;
    for (size_t i = 0; i < count; i++) {
        sx += points[i].x;
        sy += points[i].y;
    }
    conic->mean_x = sx / (ref_real_t)count;
    conic->mean_y = sy / (ref_real_t)count;
    ref_real_t sum = 0;
    for (size_t i = 0; i < count; i++) {
        const ref_real_t dx = points[i].x - conic->mean_x;
        const ref_real_t dy = points[i].y - conic->mean_y;
        sum += dx * dx + dy * dy;
    }
    conic->scale = sqrtl(sum / (ref_real_t)count);
    return conic->scale > 0;
}

static void normalise(const ref_conic_t *conic, const ref_point_t *point, ref_real_t *x,
                      ref_real_t *y) {
    *x = (point->x - conic->mean_x) / conic->scale;
    *y = (point->y - conic->mean_y) / conic->scale;
}

/* A term c x^p y^q. */
typedef struct {
    int c;
    int p;
    int q;
} term_t;

/* xi and its derivatives, as terms: monomials() and covariance() over again. */
static const term_t XI[6] = {{1, 2, 0}, {2, 1, 1}, {1, 0, 2}, {2, 1, 0}, {2, 0, 1}, {1, 0, 0}};
static const term_t XI_DX[6] = {{2, 1, 0}, {2, 0, 1}, {0, 0, 0}, {2, 0, 0}, {0, 0, 0}, {0, 0, 0}};
static const term_t XI_DY[6] = {{0, 0, 0}, {2, 1, 0}, {2, 0, 1}, {0, 0, 0}, {2, 0, 0}, {0, 0, 0}};

static ref_real_t mean_product(ref_real_t mean[5][5], term_t s, term_t t) {
    return s.c * t.c * mean[s.p + t.p][s.q + t.q];
}

/* Mean of xi xi^T (m) and of V0[xi] (nt): both are made of the fifteen means of
 * x^p y^q, p + q <= 4. */
static void moments(const ref_conic_t *conic, const ref_point_t *points, size_t count, matrix_t m,
                    matrix_t nt) {
    ref_real_t mean[5][5] = {{0}};
    for (size_t k = 0; k < count; k++) {
        ref_real_t x;
        ref_real_t y;
        normalise(conic, &points[k], &x, &y);
        ref_real_t power_y = 1;
        for (int q = 0; q <= 4; q++) {
            ref_real_t product = power_y;
            for (int p = 0; p + q <= 4; p++) {
                mean[p][q] += product;
                product *= x;
            }
            power_y *= y;
        }
    }
    for (int p = 0; p <= 4; p++) {
        for (int q = 0; q <= 4; q++) {
            mean[p][q] /= (ref_real_t)count;
        }
    }
    for (int i = 0; i < CONIC; i++) {
        for (int j = 0; j < CONIC; j++) {
            m[i][j] = mean_product(mean, XI[i], XI[j]);
            nt[i][j] =
                mean_product(mean, XI_DX[i], XI_DX[j]) + mean_product(mean, XI_DY[i], XI_DY[j]);
        }
    }
}

/* Collinear points leave a line as null vector: the 2x2 scatter is singular. */
static bool spread_in_two_directions(matrix_t m) {
    const ref_real_t xx = m[3][3];
    const ref_real_t xy = m[3][4];
    const ref_real_t yy = m[4][4];
    return (xx * yy - xy * xy) > (1e-17L * (xx + yy) * (xx + yy));
}

/* ---- The methods ---- */

/* Schur complement of the linear part: r = S1 - S2 S3^-1 S2^T, back = -S3^-1 S2^T.
 * With the points about their mean S3 is a 2x2 block and a 1. */
static void eliminate_linear(matrix_t m, matrix_t r, ref_real_t back[3][3]) {
    const ref_real_t det = m[3][3] * m[4][4] - m[3][4] * m[3][4];
    const ref_real_t inverse[2][2] = {{m[4][4] / det, -m[3][4] / det},
                                      {-m[3][4] / det, m[3][3] / det}};
    for (int j = 0; j < 3; j++) {
        back[0][j] = -(inverse[0][0] * m[3][j] + inverse[0][1] * m[4][j]);
        back[1][j] = -(inverse[1][0] * m[3][j] + inverse[1][1] * m[4][j]);
        back[2][j] = -m[5][j];
    }
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            r[i][j] = m[i][j] + m[i][3] * back[0][j] + m[i][4] * back[1][j] + m[i][5] * back[2][j];
        }
    }
    for (int i = 0; i < 3; i++) {
        for (int j = i + 1; j < 3; j++) {
            r[j][i] = r[i][j];
        }
    }
}

static bool fit_b2ac(matrix_t m, ref_real_t theta[6]) {
    matrix_t r = {{0}};
    matrix_t c = {{0}};
    ref_real_t back[3][3];
    ref_real_t lambda;
    eliminate_linear(m, r, back);
    c[0][2] = 0.5L; /* x^T c x = AC - B^2 */
    c[2][0] = 0.5L;
    c[1][1] = -1;
    if (!extreme(3, r, c, true, theta, &lambda)) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        theta[3 + i] = back[i][0] * theta[0] + back[i][1] * theta[1] + back[i][2] * theta[2];
    }
    return true;
}

/* Taubin's problem on mean-free monomials: cov(xi5) t = lambda N_T5 t.  The rows of
 * the semi-hyper problem give the constant: mean F(x) = lambda (A + C). */
static bool fit_taubin(matrix_t m, matrix_t nt, bool shifted, ref_real_t theta[6]) {
    matrix_t cov;
    ref_real_t lambda;
    for (int i = 0; i < 5; i++) {
        for (int j = 0; j < 5; j++) {
            cov[i][j] = m[i][j] - m[i][5] * m[5][j];
        }
    }
    if (!extreme(5, cov, nt, true, theta, &lambda)) {
        return false;
    }
    theta[5] = shifted ? lambda * (theta[0] + theta[2]) : 0;
    for (int i = 0; i < 5; i++) {
        theta[5] -= m[5][i] * theta[i];
    }
    return true;
}

/* Adds 2 S[xi_c e^T], e = (1, 0, 1, 0, 0, 0) the mean of xi's second-order noise. */
static void add_second_order(matrix_t m, matrix_t n) {
    for (int i = 0; i < CONIC; i++) {
        n[i][0] += m[i][5];
        n[i][2] += m[i][5];
        n[0][i] += m[i][5];
        n[2][i] += m[i][5];
    }
}

/* M's pseudo-inverse of rank 5: without its smallest eigenvalue. */
static void pseudo_inverse(matrix_t m, matrix_t inverse) {
    matrix_t copy;
    matrix_t v;
    ref_real_t d[6];
    memcpy(copy, m, sizeof(copy));
    ref_jacobi(CONIC, copy, d, v);
    int least = 0;
    for (int k = 1; k < CONIC; k++) {
        least = (d[k] < d[least]) ? k : least;
    }
    for (int i = 0; i < CONIC; i++) {
        for (int j = 0; j < CONIC; j++) {
            inverse[i][j] = 0;
            for (int k = 0; k < CONIC; k++) {
                inverse[i][j] += (k == least) ? 0 : v[i][k] * v[j][k] / d[k];
            }
        }
    }
}

/* One point's share of the 1/N terms: tr[M^- V0] xi xi^T + (xi, M^- xi) V0
 * + 2 S[V0 M^- xi xi^T]. */
static void add_finite_sample(matrix_t n, matrix_t inverse, ref_real_t x, ref_real_t y,
                              ref_real_t factor) {
    ref_real_t xi[6];
    ref_real_t h[6];
    ref_real_t vh[6];
    matrix_t v0;
    monomials(x, y, xi);
    covariance(x, y, v0);
    ref_real_t trace = 0;
    ref_real_t square = 0;
    for (int i = 0; i < CONIC; i++) {
        h[i] = 0;
        for (int j = 0; j < CONIC; j++) {
            h[i] += inverse[i][j] * xi[j];
            trace += inverse[i][j] * v0[j][i];
        }
        square += xi[i] * h[i];
    }
    for (int i = 0; i < CONIC; i++) {
        vh[i] = 0;
        for (int j = 0; j < CONIC; j++) {
            vh[i] += v0[i][j] * h[j];
        }
    }
    for (int i = 0; i < CONIC; i++) {
        for (int j = 0; j < CONIC; j++) {
            n[i][j] += factor *
                       (trace * xi[i] * xi[j] + square * v0[i][j] + vh[i] * xi[j] + xi[i] * vh[j]);
        }
    }
}

static bool fit_hyper(const ref_conic_t *conic, const ref_point_t *points, size_t count, bool full,
                      matrix_t m, matrix_t n, ref_real_t theta[6]) {
    add_second_order(m, n);
    if (full) {
        matrix_t inverse;
        const ref_real_t weight = (ref_real_t)count * (ref_real_t)count;
        pseudo_inverse(m, inverse);
        for (size_t k = 0; k < count; k++) {
            ref_real_t x;
            ref_real_t y;
            normalise(conic, &points[k], &x, &y);
            add_finite_sample(n, inverse, x, y, -1 / weight);
        }
    }
    ref_real_t lambda;
    return extreme(CONIC, m, n, false, theta, &lambda);
}

bool ref_fit_conic(ref_method_t method, const ref_point_t *points, size_t count,
                   ref_conic_t *conic) {
    matrix_t m;
    matrix_t nt;
    if ((count < 5U) || !normalisation(points, count, conic)) {
        return false;
    }
    moments(conic, points, count, m, nt);
    if (!spread_in_two_directions(m)) {
        return false;
    }
    switch (method) {
    case REF_B2AC:
        return fit_b2ac(m, conic->theta);
    case REF_TAUBIN:
        return fit_taubin(m, nt, false, conic->theta);
    case REF_TAUBIN_SHIFTED:
        return fit_taubin(m, nt, true, conic->theta);
    case REF_HYPER_SEMI:
        return fit_hyper(conic, points, count, false, m, nt, conic->theta);
    case REF_HYPER:
        return fit_hyper(conic, points, count, true, m, nt, conic->theta);
    case REF_METHODS:
    default:
        return false;
    }
}

/* ---- Conic to ellipse ---- */

bool ref_conic_ellipse(const ref_conic_t *conic, ref_ellipse_t *ellipse) {
    const ref_real_t *t = conic->theta;
    const ref_real_t det = t[0] * t[2] - t[1] * t[1];
    if (!(det > 0)) {
        return false;
    }
    const ref_real_t u = (t[1] * t[4] - t[2] * t[3]) / det;
    const ref_real_t v = (t[1] * t[3] - t[0] * t[4]) / det;
    const ref_real_t at_centre = t[5] + t[3] * u + t[4] * v;
    const ref_real_t half_trace = (t[0] + t[2]) / 2;
    const ref_real_t half_gap = hypotl((t[0] - t[2]) / 2, t[1]);
    const ref_real_t large = half_trace + ((half_trace < 0) ? -half_gap : half_gap);
    const ref_real_t small = det / large; /* no cancellation */
    const ref_real_t a2 = -at_centre / small;
    const ref_real_t b2 = -at_centre / large;
    if (!(b2 > 0)) {
        return false;
    }
    /* The major axis is the eigenvector of the eigenvalue of smaller magnitude. */
    const ref_real_t sign = (half_trace < 0) ? -1 : 1;
    ref_real_t angle = atan2l(-2 * sign * t[1], sign * (t[2] - t[0])) / 2;
    angle = (angle < 0) ? angle + PI : angle;
    ellipse->cx = (double)(conic->mean_x + conic->scale * u);
    ellipse->cy = (double)(conic->mean_y + conic->scale * v);
    ellipse->a = (double)(conic->scale * sqrtl(a2));
    ellipse->b = (double)(conic->scale * sqrtl(b2));
    ellipse->angle = ((double)angle < (double)PI) ? (double)angle : 0.0;
    return true;
}

bool ref_fit(ref_method_t method, const ref_point_t *points, size_t count, ref_ellipse_t *ellipse) {
    ref_conic_t conic;
    return ref_fit_conic(method, points, count, &conic) && ref_conic_ellipse(&conic, ellipse);
}

double ref_rms(const ref_conic_t *conic, const ref_point_t *points, size_t count) {
    const ref_real_t *t = conic->theta;
    ref_real_t squares = 0;
    ref_real_t gradients = 0;
    for (size_t k = 0; k < count; k++) {
        ref_real_t x;
        ref_real_t y;
        ref_real_t xi[6];
        ref_real_t f = 0;
        normalise(conic, &points[k], &x, &y);
        monomials(x, y, xi);
        for (int i = 0; i < CONIC; i++) {
            f += t[i] * xi[i];
        }
        const ref_real_t gx = 2 * (t[0] * x + t[1] * y + t[3]);
        const ref_real_t gy = 2 * (t[1] * x + t[2] * y + t[4]);
        squares += f * f;
        gradients += gx * gx + gy * gy;
    }
    return (double)(conic->scale * sqrtl(squares / gradients));
}

/* ---- LCSE ---- */

static void perturb_in_square(ref_real_t *u, ref_real_t *v) {
    const ref_real_t rho = hypotl(*u, *v);
    const ref_real_t turn = atan2l(*v, *u) / (2 * PI);
    const ref_real_t theta = roundl((turn - floorl(turn)) * 4294967296.0L) / 4294967296.0L;
    const ref_real_t shift = 0.001L * sinl(2 * PI * fmodl(1000 * 2 * PI * theta, 1));
    if (rho > 0) {
        *u += shift * *u / rho;
        *v += shift * *v / rho;
    }
}

void ref_lcse_perturb(const ref_point_t *points, size_t count, ref_point_t *perturbed) {
    ref_real_t low[2] = {points[0].x, points[0].y};
    ref_real_t high[2] = {points[0].x, points[0].y};
    for (size_t i = 1; i < count; i++) {
        low[0] = fminl(low[0], points[i].x);
        low[1] = fminl(low[1], points[i].y);
        high[0] = fmaxl(high[0], points[i].x);
        high[1] = fmaxl(high[1], points[i].y);
    }
    for (size_t i = 0; i < count; i++) {
        const ref_real_t side_x = (high[0] - low[0]) / 2;
        const ref_real_t side_y = (high[1] - low[1]) / 2;
        ref_real_t u = (points[i].x - low[0]) / side_x - 1;
        ref_real_t v = (points[i].y - low[1]) / side_y - 1;
        perturb_in_square(&u, &v);
        perturbed[i].x = (double)(low[0] + (u + 1) * side_x);
        perturbed[i].y = (double)(low[1] + (v + 1) * side_y);
    }
}

/* ---- The textbook's B2AC ---- */

/* inverse = m^-1 by Gauss-Jordan with partial pivoting, in double as the textbooks'
 * programs do; false when a pivot is exactly zero. */
static bool invert_double(double m[6][6], double inverse[6][6]) {
    memset(inverse, 0, sizeof(double[6][6]));
    for (int i = 0; i < CONIC; i++) {
        inverse[i][i] = 1.0;
    }
    for (int p = 0; p < CONIC; p++) {
        int pivot = p;
        for (int i = p + 1; i < CONIC; i++) {
            pivot = (fabs(m[i][p]) > fabs(m[pivot][p])) ? i : pivot;
        }
        if (m[pivot][p] == 0.0) {
            return false;
        }
        for (int j = 0; j < CONIC; j++) {
            const double swap_m = m[p][j];
            const double swap_i = inverse[p][j];
            m[p][j] = m[pivot][j];
            m[pivot][j] = swap_m;
            inverse[p][j] = inverse[pivot][j];
            inverse[pivot][j] = swap_i;
        }
        const double scale = 1.0 / m[p][p];
        for (int j = 0; j < CONIC; j++) {
            m[p][j] *= scale;
            inverse[p][j] *= scale;
        }
        for (int i = 0; i < CONIC; i++) {
            const double factor = (i == p) ? 0.0 : m[i][p];
            for (int j = 0; j < CONIC; j++) {
                m[i][j] -= factor * m[p][j];
                inverse[i][j] -= factor * inverse[p][j];
            }
        }
    }
    return true;
}

/* The positive real eigenvalues of a 3x3 matrix: roots of its characteristic
 * polynomial; returns how many, *root gets the largest. */
static int positive_eigenvalues(double g[3][3], double *root) {
    const ref_real_t a = -((ref_real_t)g[0][0] + g[1][1] + g[2][2]);
    ref_real_t b = 0;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3;
        b += (ref_real_t)g[i][i] * g[j][j] - (ref_real_t)g[i][j] * g[j][i];
    }
    ref_real_t c = 0;
    for (int j = 0; j < 3; j++) {
        const int k = (j + 1) % 3;
        const int l = (j + 2) % 3;
        c -= g[0][j] * ((ref_real_t)g[1][k] * g[2][l] - (ref_real_t)g[1][l] * g[2][k]);
    }
    const ref_real_t p = a * a / 9 - b / 3;
    const ref_real_t q = a * a * a / 27 - a * b / 6 + c / 2;
    const ref_real_t third = -a / 3;
    ref_real_t roots[3] = {0, 0, 0};
    if ((p > 0) && (q * q <= p * p * p)) {
        const ref_real_t phi = acosl(fmaxl(-1, fminl(1, -q / (p * sqrtl(p)))));
        for (int i = 0; i < 3; i++) {
            roots[i] = third + 2 * sqrtl(p) * cosl((phi + 2 * PI * i) / 3);
        }
    } else {
        const ref_real_t s = cbrtl(fabsl(q) + sqrtl(fmaxl(0, q * q - p * p * p)));
        const ref_real_t t = (s > 0) ? s + p / s : 0;
        roots[0] = third + ((q > 0) ? -t : t);
    }
    /* The two small roots carry the rounding of the large one: below 1e-15 of it
     * they are zeros, not signs. */
    const ref_real_t largest = fmaxl(fabsl(roots[0]), fmaxl(fabsl(roots[1]), fabsl(roots[2])));
    int found = 0;
    *root = 0.0;
    for (int i = 0; i < 3; i++) {
        if (roots[i] > 1e-15L * largest) {
            found++;
            *root = fmax(*root, (double)roots[i]);
        }
    }
    return found;
}

bool ref_fit_b2ac_strict(const ref_point_t *points, size_t count, ref_ellipse_t *ellipse) {
    static const double c1[3][3] = {{0.0, 0.0, 0.5}, {0.0, -1.0, 0.0}, {0.5, 0.0, 0.0}};
    ref_conic_t conic;
    double s[6][6] = {{0.0}};
    double inverse[6][6];
    if ((count < 5U) || !normalisation(points, count, &conic)) {
        return false;
    }
    for (size_t k = 0; k < count; k++) {
        const double x = (points[k].x - (double)conic.mean_x) / (double)conic.scale;
        const double y = (points[k].y - (double)conic.mean_y) / (double)conic.scale;
        const double xi[6] = {x * x, 2.0 * x * y, y * y, 2.0 * x, 2.0 * y, 1.0};
        for (int i = 0; i < CONIC; i++) {
            for (int j = 0; j < CONIC; j++) {
                s[i][j] += xi[i] * xi[j];
            }
        }
    }
    if (!invert_double(s, inverse)) {
        return false;
    }
    /* C has a 3x3 block only, so the eigenvalues of S^-1 C that are not zero are
     * those of the upper left block of S^-1 times it. */
    double g[3][3];
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            g[i][j] = 0.0;
            for (int k = 0; k < 3; k++) {
                g[i][j] += inverse[i][k] * c1[k][j];
            }
        }
    }
    double mu;
    if (positive_eigenvalues(g, &mu) != 1) {
        return false;
    }
    /* Null vector of g - mu: the longest cross product of two of its rows. */
    double best = 0.0;
    double x[3] = {0.0, 0.0, 0.0};
    for (int i = 0; i < 3; i++) {
        g[i][i] -= mu;
    }
    for (int i = 0; i < 3; i++) {
        const double *u = g[i];
        const double *v = g[(i + 1) % 3];
        const double w[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                             u[0] * v[1] - u[1] * v[0]};
        const double length = sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
        if (length > best) {
            best = length;
            memcpy(x, w, sizeof(x));
        }
    }
    if (!(best > 0.0)) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        x[i] /= best;
    }
    /* theta = S^-1 C theta / mu. */
    for (int i = 0; i < CONIC; i++) {
        double sum = 0.0;
        for (int k = 0; k < 3; k++) {
            sum += inverse[i][k] * (c1[k][0] * x[0] + c1[k][1] * x[1] + c1[k][2] * x[2]);
        }
        conic.theta[i] = sum / mu;
    }
    return ref_conic_ellipse(&conic, ellipse);
}

/* ---- The bound ---- */

ref_point_t ref_ellipse_point(const ref_ellipse_t *ellipse, double t) {
    const double u = ellipse->a * cos(t);
    const double v = ellipse->b * sin(t);
    const double c = cos(ellipse->angle);
    const double s = sin(ellipse->angle);
    const ref_point_t point = {ellipse->cx + u * c - v * s, ellipse->cy + u * s + v * c};
    return point;
}

double ref_kcr_centre(const ref_ellipse_t *ellipse, const double *t, size_t count, double sigma) {
    const double a = ellipse->a;
    const double b = ellipse->b;
    matrix_t fisher;
    matrix_t v;
    ref_real_t d[6];
    memset(fisher, 0, sizeof(fisher));
    /* In the ellipse's own axes, F = A x^2 + 2B xy + C y^2 + 2D x + 2E y - 1: the
     * five coefficients are parameters without the circle's singular angle.  Each
     * is scaled so that the derivatives below are of order one. */
    for (size_t k = 0; k < count; k++) {
        const ref_real_t c = cosl((ref_real_t)t[k]);
        const ref_real_t s = sinl((ref_real_t)t[k]);
        const ref_real_t gradient = 2 * hypotl(c / a, s / b);
        const ref_real_t row[5] = {c * c / gradient, 2 * c * s / gradient, s * s / gradient,
                                   2 * c / gradient, 2 * s / gradient};
        for (int i = 0; i < 5; i++) {
            for (int j = 0; j < 5; j++) {
                fisher[i][j] += row[i] * row[j];
            }
        }
    }
    ref_jacobi(5, fisher, d, v);
    /* Centre: -D/A and -E/C at first order, in these scales a D and b E. */
    ref_real_t variance = 0;
    for (int k = 0; k < 5; k++) {
        variance +=
            ((ref_real_t)a * a * v[3][k] * v[3][k] + (ref_real_t)b * b * v[4][k] * v[4][k]) / d[k];
    }
    return sigma * (double)sqrtl(variance);
}
