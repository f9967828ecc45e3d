/* SPDX-License-Identifier: MIT
 *
 * Balls as a camera sees them, exactly: a pixel is set when the ray through its
 * centre hits a ball and nothing hides it.  What hides is drawn in the image.  The
 * truth is the ball's centre and its outline, both in double precision.
 */
#ifndef SUPPORT_BALL_SCENE_H
#define SUPPORT_BALL_SCENE_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <ocellus/ocellus.h>

#include "frames.h"
#include "reference/reference.h"
#include "rng.h"

enum { SCENE_WIDTH = 320, SCENE_HEIGHT = 240, SCENE_PIXELS = 320 * 240, SCENE_EDGES = 2 };

/* The camera of the published figures: square pixels, no distortion, the axis
 * through the middle of the image. */
#define SCENE_F_PX 277.0
#define SCENE_CX_PX 159.5
#define SCENE_CY_PX 119.5

/* The ball of the published figures; the library's unit of length is then 1 um. */
#define SCENE_RADIUS_MM 35.0
#define SCENE_U_PER_MM 1000.0

#define SCENE_PI 3.14159265358979323846

typedef struct {
    double centre[3]; /* in the camera's frame, mm */
    double radius;    /* mm; 0: no ball */
} scene_ball_t;

/* Hides the pixels p with nx px + ny py > offset. */
typedef struct {
    double nx;
    double ny;
    double offset;
} scene_edge_t;

/* Hides a disc of the image; radius 0 hides nothing. */
typedef struct {
    double x;
    double y;
    double radius;
} scene_disc_t;

typedef struct {
    scene_ball_t ball;
    scene_ball_t other; /* of the same colour */
    scene_edge_t edge[SCENE_EDGES];
    int edges;
    scene_disc_t disc;
    double edge_noise_px; /* each pixel looks this far beside its centre, normal in x and y */
    double salt;          /* share of all pixels that are turned over */
} scene_t;

/* ---- The truth ---- */

static inline double scene_norm(const double v[3]) {
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/* The ball of `radius` at the distance `range` whose centre projects to (x, y). */
static inline scene_ball_t scene_ball_at(double x, double y, double range, double radius) {
    scene_ball_t ball = {{(x - SCENE_CX_PX) / SCENE_F_PX, (y - SCENE_CY_PX) / SCENE_F_PX, 1.0},
                         radius};
    const double scale = range / scene_norm(ball.centre);
    for (int i = 0; i < 3; i++) {
        ball.centre[i] *= scale;
    }
    return ball;
}

/* The outline.  Rays d with (d.C)^2 = |d|^2 (|C|^2 - R^2): symmetric about the plane of
 * C and the optical axis, in which the two rays at the angles theta -+ alpha from the
 * axis end the outline's long diameter.  Its middle is the centre; the short semi-axis
 * follows from the conic there: b^2 = a^2 (1 - (sin theta / cos alpha)^2), a section of a
 * circular cone.  The ball must be in front of the camera: theta + alpha < 90 degrees. */
static inline ref_ellipse_t scene_outline(const scene_ball_t *ball) {
    const double *c = ball->centre;
    const double theta = atan2(hypot(c[0], c[1]), c[2]);
    const double alpha = asin(ball->radius / scene_norm(c));
    const double far_end = SCENE_F_PX * tan(theta + alpha);
    const double near_end = SCENE_F_PX * tan(theta - alpha);
    const double around = atan2(c[1], c[0]);
    const double slope = sin(theta) / cos(alpha);
    ref_ellipse_t e;
    e.cx = SCENE_CX_PX + 0.5 * (far_end + near_end) * cos(around);
    e.cy = SCENE_CY_PX + 0.5 * (far_end + near_end) * sin(around);
    e.a = 0.5 * (far_end - near_end);
    e.b = e.a * sqrt(1.0 - slope * slope);
    e.angle = fmod(around + 2.0 * SCENE_PI, SCENE_PI);
    return e;
}

/* Half the outline's extent along the unit vector (nx, ny). */
static inline double scene_half_width(const ref_ellipse_t *e, double nx, double ny) {
    const double along = nx * cos(e->angle) + ny * sin(e->angle);
    const double across = ny * cos(e->angle) - nx * sin(e->angle);
    return hypot(e->a * along, e->b * across);
}

/* The outline lies in the image, `margin` px from its edges. */
static inline bool scene_is_inside(const ref_ellipse_t *e, double margin) {
    const double wide = scene_half_width(e, 1.0, 0.0) + margin - 0.5;
    const double high = scene_half_width(e, 0.0, 1.0) + margin - 0.5;
    return (e->cx >= wide) && (e->cy >= high) && (e->cx <= SCENE_WIDTH - 1 - wide) &&
           (e->cy <= SCENE_HEIGHT - 1 - high);
}

/* ---- What hides it: a share is one of the outline's area ---- */

/* Of a circle's area, the part beyond a chord at k radii from the centre, |k| <= 1; of an
 * ellipse's, beyond k half widths. */
static inline double scene_segment(double k) {
    return (acos(k) - k * sqrt(1.0 - k * k)) / SCENE_PI;
}

/* The k of a share. */
static inline double scene_chord(double share) {
    double lo = -1.0;
    double hi = 1.0;
    for (int i = 0; i < 60; i++) {
        const double k = 0.5 * (lo + hi);
        if (scene_segment(k) > share) {
            lo = k;
        } else {
            hi = k;
        }
    }
    return lo;
}

/* Adds a straight edge that hides `share` of the ball, on the side of `angle`. */
static inline void scene_add_edge(scene_t *scene, double angle, double share) {
    const ref_ellipse_t e = scene_outline(&scene->ball);
    scene_edge_t *edge = &scene->edge[scene->edges++];
    edge->nx = cos(angle);
    edge->ny = sin(angle);
    edge->offset = e.cx * edge->nx + e.cy * edge->ny +
                   scene_chord(share) * scene_half_width(&e, edge->nx, edge->ny);
}

/* Of the unit circle's area, the part in a disc of radius r, its centre at d. */
static inline double scene_lens(double d, double r) {
    double share = fmin(1.0, r * r);
    if (d >= 1.0 + r) {
        share = 0.0;
    } else if (d > fabs(1.0 - r)) {
        const double at = (d * d + 1.0 - r * r) / (2.0 * d); /* the common chord */
        share = scene_segment(at) + r * r * scene_segment((d - at) / r);
    } else {
        /* One lies in the other. */
    }
    return share;
}

/* Hides `share` of the ball, on the side of `angle`, by a disc of `ratio` times its
 * radius; share <= ratio^2.  The outline is taken as the circle of its area. */
static inline void scene_set_disc(scene_t *scene, double angle, double share, double ratio) {
    const ref_ellipse_t e = scene_outline(&scene->ball);
    const double radius = sqrt(e.a * e.b);
    double near = fabs(1.0 - ratio);
    double far = 1.0 + ratio;
    for (int i = 0; i < 60; i++) {
        const double d = 0.5 * (near + far);
        if (scene_lens(d, ratio) > share) {
            near = d;
        } else {
            far = d;
        }
    }
    scene->disc.x = e.cx + near * radius * cos(angle);
    scene->disc.y = e.cy + near * radius * sin(angle);
    scene->disc.radius = ratio * radius;
}

/* Moves the ball, at its range, until the image's edge hides `share` of it: side 0 left,
 * 1 top, 2 right, 3 bottom; `along` is where on that side, px. */
static inline void scene_move_to_border(scene_ball_t *ball, int side, double along, double share) {
    const bool upright = (side % 2) == 0;
    const double outward = (side < 2) ? -1.0 : 1.0;
    const double size = upright ? SCENE_WIDTH : SCENE_HEIGHT;
    const double border = (side < 2) ? -0.5 : size - 0.5;
    const double range = scene_norm(ball->centre);
    double in = -0.5 * size; /* how far the centre lies beyond the border */
    double out = 0.5 * size;
    for (int i = 0; i < 60; i++) {
        const double beyond = 0.5 * (in + out);
        const double x = upright ? border + outward * beyond : along;
        const double y = upright ? along : border + outward * beyond;
        *ball = scene_ball_at(x, y, range, ball->radius);
        const ref_ellipse_t e = scene_outline(ball);
        const double inside = outward * (border - (upright ? e.cx : e.cy));
        const double width = scene_half_width(&e, upright ? 1.0 : 0.0, upright ? 0.0 : 1.0);
        if (scene_segment(fmin(1.0, fmax(-1.0, inside / width))) > share) {
            out = beyond;
        } else {
            in = beyond;
        }
    }
}

/* A ball whose outline has a radius of `radius_px` on the camera's axis, and a straight
 * edge at any angle that hides `share` of it.  `anywhere`: in the image, wholly inside
 * it but for the edge; otherwise within half a pixel of the axis. */
static inline void scene_occluded(scene_t *scene, double radius_px, double share, bool anywhere,
                                  rng_t *rng) {
    const double range = SCENE_RADIUS_MM / sin(atan(radius_px / SCENE_F_PX));
    const double reach_x = anywhere ? SCENE_CX_PX : 0.5;
    const double reach_y = anywhere ? SCENE_CY_PX : 0.5;
    ref_ellipse_t outline;
    memset(scene, 0, sizeof(*scene));
    do {
        const double x = SCENE_CX_PX + rng_uniform(rng, -reach_x, reach_x);
        const double y = SCENE_CY_PX + rng_uniform(rng, -reach_y, reach_y);
        scene->ball = scene_ball_at(x, y, range, SCENE_RADIUS_MM);
        outline = scene_outline(&scene->ball);
    } while (!scene_is_inside(&outline, 1.0));
    scene_add_edge(scene, rng_uniform(rng, 0.0, 2.0 * SCENE_PI), share);
}

/* ---- Drawing ---- */

static inline bool scene_ball_hit(const scene_ball_t *ball, double x, double y) {
    const double d[3] = {(x - SCENE_CX_PX) / SCENE_F_PX, (y - SCENE_CY_PX) / SCENE_F_PX, 1.0};
    const double *c = ball->centre;
    const double dot = d[0] * c[0] + d[1] * c[1] + d[2] * c[2];
    const double dd = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    const double cc = c[0] * c[0] + c[1] * c[1] + c[2] * c[2];
    return (ball->radius > 0.0) && (dot > 0.0) &&
           (dot * dot >= dd * (cc - ball->radius * ball->radius));
}

static inline bool scene_is_hidden(const scene_t *scene, double x, double y) {
    const double dx = x - scene->disc.x;
    const double dy = y - scene->disc.y;
    bool hidden = dx * dx + dy * dy < scene->disc.radius * scene->disc.radius;
    for (int i = 0; i < scene->edges; i++) {
        const scene_edge_t *edge = &scene->edge[i];
        hidden = hidden || (edge->nx * x + edge->ny * y > edge->offset);
    }
    return hidden;
}

/* The mask, 0 or 1 a pixel, rows of SCENE_WIDTH.  `rng` is drawn from for noise only. */
static inline void scene_draw(const scene_t *scene, rng_t *rng, uint8_t *mask) {
    for (int y = 0; y < SCENE_HEIGHT; y++) {
        for (int x = 0; x < SCENE_WIDTH; x++) {
            double px = x;
            double py = y;
            if (scene->edge_noise_px > 0.0) {
                px += scene->edge_noise_px * rng_gauss(rng);
                py += scene->edge_noise_px * rng_gauss(rng);
            }
            bool on =
                (scene_ball_hit(&scene->ball, px, py) || scene_ball_hit(&scene->other, px, py)) &&
                !scene_is_hidden(scene, px, py);
            if (scene->salt > 0.0) {
                on = on != (rng_unit(rng) < scene->salt);
            }
            mask[y * SCENE_WIDTH + x] = on ? 1U : 0U;
        }
    }
}

/* ---- Looking ---- */

/* The ball that the cone and the known radius give, mm. */
static inline bool scene_place(const ocel_cone_t *cone, ocel_sphere_t *sphere, double p_mm[3]) {
    const bool placed =
        ocel_sphere_of_cone(cone, (int32_t)(SCENE_RADIUS_MM * SCENE_U_PER_MM), sphere) == OCEL_OK;
    for (int i = 0; i < 3; i++) {
        p_mm[i] = sphere->p_cam_u[i] / SCENE_U_PER_MM;
    }
    return placed;
}

static inline void scene_camera(ocel_camera_t *camera) {
    ocel_intrinsics_t intrinsics;
    memset(&intrinsics, 0, sizeof(intrinsics));
    intrinsics.fx_px_q16 = (int32_t)(SCENE_F_PX * 65536.0);
    intrinsics.fy_px_q16 = intrinsics.fx_px_q16;
    intrinsics.cx_px_q16 = (int32_t)(SCENE_CX_PX * 65536.0);
    intrinsics.cy_px_q16 = (int32_t)(SCENE_CY_PX * 65536.0);
    intrinsics.width = SCENE_WIDTH;
    intrinsics.height = SCENE_HEIGHT;
    if (ocel_camera_init(camera, &intrinsics) != OCEL_OK) {
        abort();
    }
}

/* The mask through the eye, row by row, as a firmware would. */
static inline ocel_status_t scene_look(const uint8_t *mask, ocel_eye_t *eye,
                                       ocel_detection_t *detection) {
    static uint32_t rows[SCENE_HEIGHT * (SCENE_WIDTH / 32)];
    ocel_eye_config_t config;
    memset(&config, 0, sizeof(config));
    config.width = SCENE_WIDTH;
    config.height = SCENE_HEIGHT;
    frame_mask_to_bits(mask, SCENE_WIDTH, SCENE_HEIGHT, rows);
    ocel_status_t status = ocel_eye_init(eye, &config);
    if (status == OCEL_OK) {
        status = ocel_eye_begin(eye);
    }
    for (uint16_t y = 0; (y < SCENE_HEIGHT) && (status == OCEL_OK); y++) {
        status = ocel_eye_row(eye, y, &rows[(size_t)y * (SCENE_WIDTH / 32)]);
    }
    return (status == OCEL_OK) ? ocel_eye_end(eye, detection) : status;
}

/* The inside pixels with an outside one beside them: what the paper, and OpenCV's
 * contours, call the boundary. */
static inline size_t scene_inner_pixels(const uint8_t *mask, ref_point_t *points, size_t room) {
    size_t count = 0;
    for (int y = 1; y < SCENE_HEIGHT - 1; y++) {
        for (int x = 1; x < SCENE_WIDTH - 1; x++) {
            const uint8_t *p = &mask[y * SCENE_WIDTH + x];
            const bool inner = (p[0] != 0U) && ((p[-1] == 0U) || (p[1] == 0U) ||
                                                (p[-SCENE_WIDTH] == 0U) || (p[SCENE_WIDTH] == 0U));
            if (inner && (count < room)) {
                points[count].x = x;
                points[count].y = y;
                count++;
            }
        }
    }
    return count;
}

/* The paper's chain: B2AC through the inner boundary pixels, the circle of the ellipse's
 * mean axis, z = f R / r, the centre along the ray through the ellipse's centre. */
static inline bool scene_paper(const uint8_t *mask, ref_ellipse_t *e, double p_mm[3]) {
    enum { ROOM = 8192 };
    static ref_point_t points[ROOM];
    const bool found = ref_fit(REF_B2AC, points, scene_inner_pixels(mask, points, ROOM), e);
    if (found) {
        const double z = SCENE_F_PX * SCENE_RADIUS_MM / (0.5 * (e->a + e->b));
        p_mm[0] = z * (e->cx - SCENE_CX_PX) / SCENE_F_PX;
        p_mm[1] = z * (e->cy - SCENE_CY_PX) / SCENE_F_PX;
        p_mm[2] = z;
    }
    return found;
}

#endif
