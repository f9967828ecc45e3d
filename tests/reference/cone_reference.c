/* SPDX-License-Identifier: MIT */
#include "cone_reference.h"

#include <math.h>
#include <string.h>

enum { SAMPLES = 32, HYPOTHESES = 32, ROUNDS = 3, SECTORS = 32 };

#define PI 3.14159265358979323846

typedef struct {
    double row[3][3]; /* camera to frame: its z is the last row */
} frame_t;

/* e = a u + b v + c over unit vectors (u, v, 1 - e), u, v in h and e in h^2. */
typedef struct {
    double a;
    double b;
    double c;
    double size; /* the outline's radius in h */
} plane_t;

typedef struct {
    double u;
    double v;
    double e;
} sample_t;

static void ray_of(const ref_camera_t *camera, ref_point_t p, double d[3]) {
    d[0] = (p.x - camera->cx) / camera->fx;
    d[1] = (p.y - camera->cy) / camera->fy;
    d[2] = 1.0;
}

static void normalise(double d[3]) {
    const double length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    for (int i = 0; i < 3; i++) {
        d[i] /= length;
    }
}

/* The shortest rotation that takes the axis to z. */
static frame_t frame_of(const double n[3]) {
    const double k = 1.0 / (1.0 + n[2]);
    const frame_t frame = {{{1.0 - n[0] * n[0] * k, -n[0] * n[1] * k, -n[0]},
                            {-n[0] * n[1] * k, 1.0 - n[1] * n[1] * k, -n[1]},
                            {n[0], n[1], n[2]}}};
    return frame;
}

static void rotate(const frame_t *frame, const double d[3], double out[3]) {
    for (int i = 0; i < 3; i++) {
        out[i] = frame->row[i][0] * d[0] + frame->row[i][1] * d[1] + frame->row[i][2] * d[2];
    }
}

/* The unit vector of (x, y, 1) in the frame, back in the camera's. */
static void turn(const frame_t *frame, double x, double y, double axis[3]) {
    for (int i = 0; i < 3; i++) {
        axis[i] = frame->row[0][i] * x + frame->row[1][i] * y + frame->row[2][i];
    }
    normalise(axis);
}

/* The inverse of a symmetric matrix by cofactors. */
static bool invert(double m[3][3], double inverse[3][3]) {
    double determinant = 0.0;
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            const int i1 = (i + 1) % 3;
            const int i2 = (i + 2) % 3;
            const int k1 = (k + 1) % 3;
            const int k2 = (k + 2) % 3;
            inverse[i][k] = m[i1][k1] * m[i2][k2] - m[i1][k2] * m[i2][k1];
        }
    }
    for (int k = 0; k < 3; k++) {
        determinant += m[0][k] * inverse[0][k];
    }
    for (int i = 0; i < 9; i++) {
        inverse[i / 3][i % 3] /= determinant;
    }
    return determinant > 0.0;
}

static void multiply(double m[3][3], const double b[3], double x[3]) {
    for (int i = 0; i < 3; i++) {
        x[i] = m[i][0] * b[0] + m[i][1] * b[1] + m[i][2] * b[2];
    }
}

static bool finish_plane(plane_t *plane, double h) {
    const double square =
        plane->a * plane->a + plane->b * plane->b + 2.0 * plane->c - h * h * plane->c * plane->c;
    plane->size = sqrt(fmax(square, 0.0));
    return (fabs(plane->a) < 3.0) && (fabs(plane->b) < 3.0) && (h * h * plane->c < 0.5) &&
           (square >= 1.0 / 256.0) && (square <= 9.0);
}

static bool plane_through(const sample_t *s, const sample_t *t, const sample_t *w, double h,
                          plane_t *plane) {
    const double u1 = t->u - s->u;
    const double v1 = t->v - s->v;
    const double e1 = t->e - s->e;
    const double u2 = w->u - s->u;
    const double v2 = w->v - s->v;
    const double e2 = w->e - s->e;
    const double area = u1 * v2 - u2 * v1;
    bool valid = fabs(area) >= 1.0 / 1024.0;
    if (valid) {
        plane->a = (e1 * v2 - e2 * v1) / area;
        plane->b = (u1 * e2 - u2 * e1) / area;
        plane->c = s->e - plane->a * s->u - plane->b * s->v;
        valid = finish_plane(plane, h);
    }
    return valid;
}

static double residual(const plane_t *plane, const sample_t *s) {
    return plane->a * s->u + plane->b * s->v + plane->c - s->e;
}

/* T as the library's gates take it: within 3 %. */
static double rough_size(const plane_t *plane) {
    const double power = exp2(floor(log2(plane->size)));
    return 22459.0 / 65536.0 * (plane->size * plane->size / power + 2.0 * power);
}

static int votes_for(const sample_t *samples, const plane_t *plane, double gate) {
    int votes = 0;
    for (int i = 0; i < SAMPLES; i++) {
        const double r = residual(plane, &samples[i]);
        votes += (fabs(r) <= gate) ? 1 : 0;
        votes -= (r < -gate) ? 1 : 0;
    }
    return votes;
}

static bool elect(const sample_t *samples, double h, double h_px, plane_t *best) {
    static const int steps[8][2] = {{7, 13},  {5, 12}, {8, 16}, {4, 8},
                                    {11, 21}, {5, 15}, {3, 10}, {6, 19}};
    int most = -2 * SAMPLES;
    bool found = false;
    for (int k = 0; k < HYPOTHESES; k++) {
        const int *step = steps[(k + k / SAMPLES) % 8];
        plane_t plane;
        if (plane_through(&samples[k % SAMPLES], &samples[(k + step[0]) % SAMPLES],
                          &samples[(k + step[1]) % SAMPLES], h, &plane)) {
            const int votes = votes_for(samples, &plane, 0.75 * rough_size(&plane) / h_px);
            if (votes > most) {
                most = votes;
                *best = plane;
                found = true;
            }
        }
    }
    return found;
}

/* Least squares on the samples; returns their scatter, px. */
static double settle(const sample_t *samples, double h, double h_px, plane_t *plane) {
    static const double gate_px[ROUNDS] = {1.5, 1.0, 0.8};
    double rms_px = 0.0;
    for (int round = 0; round < ROUNDS; round++) {
        const double gate = gate_px[round] * rough_size(plane) / h_px;
        double m[3][3] = {{0.0}};
        double inverse[3][3];
        double b[3] = {0.0, 0.0, 0.0};
        double x[3];
        double squares = 0.0;
        int count = 0;
        for (int i = 0; i < SAMPLES; i++) {
            const double r = residual(plane, &samples[i]);
            const double j[3] = {samples[i].u, samples[i].v, 1.0};
            if (fabs(r) <= gate) {
                for (int k = 0; k < 9; k++) {
                    m[k / 3][k % 3] += j[k / 3] * j[k % 3];
                }
                for (int k = 0; k < 3; k++) {
                    b[k] -= j[k] * r;
                }
                squares += r * r;
                count++;
            }
        }
        if ((count > 3) && invert(m, inverse)) {
            multiply(inverse, b, x);
            plane_t next = {plane->a + x[0], plane->b + x[1], plane->c + x[2], 0.0};
            rms_px = gate_px[round] * sqrt(squares / count) / gate;
            if (finish_plane(&next, h)) {
                *plane = next;
            }
        }
    }
    return rms_px;
}

/* The guess: axis, tangent and scatter. */
static bool guess(const ref_camera_t *camera, const ref_point_t *points, size_t count,
                  double axis[3], double *tangent, double *rms_px) {
    const double f = 0.5 * (camera->fx + camera->fy);
    const double inverse_f = 0.5 * (1.0 / camera->fx + 1.0 / camera->fy);
    ref_point_t mean = {0.0, 0.0};
    sample_t samples[SAMPLES];
    plane_t plane = {0.0, 0.0, 0.0, 1.0};
    double deviation = 0.0;
    double d[3];
    for (size_t k = 0; k < SAMPLES; k++) {
        mean.x += points[k * count / SAMPLES].x / SAMPLES;
        mean.y += points[k * count / SAMPLES].y / SAMPLES;
    }
    for (size_t k = 0; k < SAMPLES; k++) {
        const ref_point_t p = points[k * count / SAMPLES];
        deviation += (fabs(p.x - mean.x) + fabs(p.y - mean.y)) / SAMPLES;
    }
    ray_of(camera, mean, d);
    normalise(d);
    const frame_t frame = frame_of(d);
    const double h = fmin(1.0, exp2(ceil(log2(deviation * inverse_f))));
    const double h_px = f * h / (d[2] * d[2]);
    for (size_t k = 0; k < SAMPLES; k++) {
        double ray[3];
        double p[3];
        ray_of(camera, points[k * count / SAMPLES], ray);
        normalise(ray);
        rotate(&frame, ray, p);
        samples[k].u = p[0] / h;
        samples[k].v = p[1] / h;
        samples[k].e = (p[0] * p[0] + p[1] * p[1]) / (1.0 + p[2]) / (h * h);
        if ((fabs(samples[k].u) > 3.0) || (fabs(samples[k].v) > 3.0) || (samples[k].e > 4.0)) {
            samples[k].u = 0.0;
            samples[k].v = 0.0;
            samples[k].e = 4.0;
        }
    }
    const bool found = elect(samples, h, h_px, &plane);
    if (found) {
        *rms_px = settle(samples, h, h_px, &plane);
        *tangent = h * plane.size / (1.0 - h * h * plane.c);
        turn(&frame, h * plane.a, h * plane.b, axis);
    }
    return found && (*tangent <= 1.0) && (axis[2] >= 0.1875);
}

typedef struct {
    double distance[SECTORS];
    double low[SECTORS];
    double high[SECTORS];
    double inliers[SECTORS];
    double others[SECTORS];
    bool mixed[SECTORS];
    double squares;
    size_t inlier_count;
    size_t outside;
    bool cracks;
    double r_px;
} sums_t;

/* Half of a crack's extent across the outline, px; (x, y) is the outline's direction. */
static double half_across(const ref_camera_t *camera, ref_point_t p, double x, double y) {
    const double f = 0.5 * (camera->fx + camera->fy);
    const bool along_x = fabs(p.x - floor(p.x) - 0.5) < 0.25;
    return fmin(0.65, along_x ? 0.5 * fabs(x) * f / camera->fx : 0.5 * fabs(y) * f / camera->fy);
}

static void sum_point(sums_t *sums, int sector, double px, double half, double gate, bool beyond) {
    if (fabs(px) <= gate + half) {
        sums->inliers[sector] += 1.0;
        sums->distance[sector] += px;
        sums->low[sector] = fmax(sums->low[sector], px - half);
        sums->high[sector] = fmin(sums->high[sector], px + half);
        sums->squares += px * px;
        sums->inlier_count++;
    } else {
        sums->others[sector] += 1.0;
        sums->mixed[sector] = sums->mixed[sector] || (fabs(px) <= gate + half + 2.0);
        sums->outside += (beyond && (fabs(px) > gate + half + 0.4)) ? 1U : 0U;
    }
}

static void sum_points(const ref_camera_t *camera, const ref_point_t *points, size_t count,
                       const double axis[3], double tangent, double rms_px, sums_t *sums) {
    const frame_t frame = frame_of(axis);
    const double z0 = 1.0 / axis[2];
    sums->r_px = 0.5 * (camera->fx + camera->fy) * tangent * z0 * z0;
    for (int k = 0; k < SECTORS; k++) {
        sums->low[k] = -4.0;
        sums->high[k] = 4.0;
    }
    const double gate =
        fmin(fmin(fmax(3.0 * rms_px, 0.65), 1.5) - (sums->cracks ? 0.25 : 0.0), 0.25 * sums->r_px);
    for (size_t i = 0; i < count; i++) {
        double d[3];
        double p[3];
        ray_of(camera, points[i], d);
        rotate(&frame, d, p);
        const double x = p[0] / (tangent * z0);
        const double y = p[1] / (tangent * z0);
        const double z = p[2] / z0;
        const double a = 0.5 * (x * x + y * y - z * z);
        const double px = (fabs(a) < 0.5) ? (a - 0.5 * a * a) * sums->r_px : 1e9;
        const int sector = (int)floor(atan2(y, x) / (2.0 * PI) * SECTORS + SECTORS) % SECTORS;
        sum_point(sums, sector, px, sums->cracks ? half_across(camera, points[i], x, y) : 0.0, gate,
                  a > 0.0);
    }
}

static int sectors_of(const sums_t *sums) {
    const int gap = (int)(2U * SECTORS / (sums->inlier_count + 1U));
    int covered = 0;
    int first = -1;
    int empty = 0;
    for (int i = 0; i < 2 * SECTORS; i++) {
        const int k = i % SECTORS;
        if (sums->inliers[k] > sums->others[k]) {
            if ((first >= 0) && (i > first) && (i <= first + SECTORS)) {
                covered += 1 + ((empty <= gap) ? empty : 0);
            }
            first = (first < 0) ? i : first;
            empty = 0;
        } else {
            empty++;
        }
    }
    return covered;
}

static double shift(const double x[3], int k) {
    return x[0] * cos((k + 0.5) * 2.0 * PI / SECTORS) + x[1] * sin((k + 0.5) * 2.0 * PI / SECTORS) +
           x[2];
}

/* least / variance by the library's line for a reciprocal: up to 12 % over it. */
static double ratio(double least, double variance) {
    const double power = exp2(floor(log2(variance)));
    return least * 0.5 * (3.0 - variance / power) / power;
}

/* Sectors' estimates, and what each may be in. */
typedef struct {
    double d[SECTORS];
    double width[SECTORS];
    double least; /* variance */
    int count;
} estimates_t;

static void estimate(const sums_t *sums, estimates_t *estimates) {
    double overlap = 0.0;
    estimates->count = 0;
    for (int k = 0; k < SECTORS; k++) {
        if (sums->inliers[k] > 0.0) {
            const double low = sums->low[k];
            const double high = sums->high[k];
            estimates->width[k] = fabs(high - low);
            estimates->d[k] = 0.5 * (low + high);
            if (low > high) {
                estimates->d[k] = fmax(high, fmin(low, sums->distance[k] / sums->inliers[k]));
                overlap += low - high;
            }
            estimates->count++;
        }
    }
    const double mean = 2.0 * overlap / fmax(1.0, estimates->count);
    estimates->least = 1.0 / 256.0 + mean * mean;
}

static double weight(const sums_t *sums, const estimates_t *e, int k, double miss) {
    const double few = 0.5 / exp2(floor(log2(sums->inliers[k])));
    return !sums->cracks ? sums->inliers[k]
                         : ratio(e->least, e->least + e->width[k] * e->width[k] + few * few +
                                               9.0 * miss * miss + (sums->mixed[k] ? 0.25 : 0.0));
}

/* Weighted least squares, first by the sectors' own worth, then also by what each misses the
 * step by; returns the misfit. */
static bool solve(const sums_t *sums, const estimates_t *e, double x[3], double inverse[3][3],
                  double *misfit) {
    bool known = sums->inlier_count > 3U;
    for (int round = 0; (round < 2) && known; round++) {
        double m[3][3] = {{0.0}};
        double b[3] = {0.0, 0.0, 0.0};
        *misfit = 0.0;
        for (int k = 0; k < SECTORS; k++) {
            if (sums->inliers[k] > 0.0) {
                const double j[3] = {cos((k + 0.5) * 2.0 * PI / SECTORS),
                                     sin((k + 0.5) * 2.0 * PI / SECTORS), 1.0};
                const double miss =
                    fmin(2.0, fmax(0.0, fabs(e->d[k] - shift(x, k)) - 0.5 * e->width[k]));
                const double w = weight(sums, e, k, (round == 0) ? 0.0 : miss);
                for (int i = 0; i < 9; i++) {
                    m[i / 3][i % 3] += w * j[i / 3] * j[i % 3];
                }
                for (int i = 0; i < 3; i++) {
                    b[i] += w * e->d[k] * j[i];
                }
                *misfit += w * e->d[k] * e->d[k];
            }
        }
        known = invert(m, inverse);
        if (known) {
            multiply(inverse, b, x);
            *misfit -= x[0] * b[0] + x[1] * b[1] + x[2] * b[2];
        }
    }
    return known;
}

/* The step from the sums, and what it is worth. */
static void refine(const sums_t *sums, double axis[3], double tangent, size_t count,
                   ref_cone_t *cone) {
    const double open = 1.0 + tangent * tangent;
    double inverse[3][3];
    double x[3] = {0.0, 0.0, 0.0};
    double points = sums->squares;
    double sectors = 0.0;
    double misfit = 0.0;
    estimates_t estimates;
    const int covered = sectors_of(sums);
    estimate(sums, &estimates);
    const bool known = solve(sums, &estimates, x, inverse, &misfit);
    for (int k = 0; k < SECTORS; k++) {
        const double step = shift(x, k);
        const double left = sums->distance[k] - sums->inliers[k] * step;
        points -= step * (sums->distance[k] + left);
        sectors += sums->mixed[k] ? 0.0 : left * left;
    }
    points = fmax(points, 0.0);
    const frame_t frame = frame_of(axis);
    const double turned = tangent / open / sums->r_px;
    turn(&frame, x[0] * turned, x[1] * turned, cone->axis);
    tangent *= 1.0 + x[2] / sums->r_px;
    cone->sine = tangent / sqrt(1.0 + tangent * tangent);
    cone->range_sigma = 1.0;
    if (known) {
        const double variance =
            2.0 * fmax(misfit, 0.0) / fmax(1.0, estimates.count - 3.0) * inverse[2][2];
        cone->range_sigma = sqrt(variance) / (sums->r_px * open);
    }
    cone->inliers = sums->inlier_count;
    cone->rms_px = sqrt(points / fmax(1.0, (double)sums->inlier_count));
    cone->coverage = (double)covered / SECTORS;
    cone->vouched = (2U * sums->inlier_count > count) && (25U * sums->outside <= count) &&
                    (covered >= 8) &&
                    (sectors <= 3.0 * points + (double)sums->inlier_count / 64.0) &&
                    (cone->range_sigma <= 0.01) && (cone->rms_px <= 0.14 + 0.012 * covered);
}

bool ref_cone_fit(const ref_camera_t *camera, const ref_point_t *points, size_t count, bool cracks,
                  ref_cone_t *cone) {
    double axis[3];
    double tangent = 0.0;
    double rms_px = 0.0;
    const bool found = guess(camera, points, count, axis, &tangent, &rms_px);
    memset(cone, 0, sizeof(*cone));
    if (found) {
        sums_t sums;
        memset(&sums, 0, sizeof(sums));
        sums.cracks = cracks;
        sum_points(camera, points, count, axis, tangent, rms_px, &sums);
        refine(&sums, axis, tangent, count, cone);
    }
    return found;
}
