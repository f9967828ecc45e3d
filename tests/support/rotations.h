/* SPDX-License-Identifier: MIT
 *
 * Random directions and rotations.
 */
#ifndef SUPPORT_ROTATIONS_H
#define SUPPORT_ROTATIONS_H

#include <math.h>

#include <ocellus/space.h>

#include "rng.h"

/* A unit vector, every direction as likely as any other. */
static inline void rotation_direction(rng_t *rng, double d[3]) {
    double square = 0.0;
    while (square < 1e-12) {
        square = 0.0;
        for (int i = 0; i < 3; i++) {
            d[i] = rng_gauss(rng);
            square += d[i] * d[i];
        }
    }
    for (int i = 0; i < 3; i++) {
        d[i] /= sqrt(square);
    }
}

static inline void rotation_cross(const double a[3], const double b[3], double c[3]) {
    for (int i = 0; i < 3; i++) {
        c[i] = (a[(i + 1) % 3] * b[(i + 2) % 3]) - (a[(i + 2) % 3] * b[(i + 1) % 3]);
    }
}

/* The rotation whose z axis is `forward`, x and y turned at random about it. */
static inline void rotation_about(rng_t *rng, const double forward[3], double r[3][3]) {
    double helper[3];
    double axes[3][3];
    double length = 0.0;
    do {
        rotation_direction(rng, helper);
        rotation_cross(helper, forward, axes[0]);
        length =
            sqrt((axes[0][0] * axes[0][0]) + (axes[0][1] * axes[0][1]) + (axes[0][2] * axes[0][2]));
    } while (length < 0.1);
    for (int i = 0; i < 3; i++) {
        axes[0][i] /= length;
        axes[2][i] = forward[i];
    }
    rotation_cross(axes[2], axes[0], axes[1]);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            r[i][j] = axes[j][i];
        }
    }
}

static inline int32_t rotation_q30(double v) {
    return (int32_t)lround(ldexp(v, 30));
}

/* A pose at the origin. */
static inline ocel_pose_t rotation_pose(double r[3][3]) {
    ocel_pose_t pose = {{{0}}, {0, 0, 0}};
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            pose.r_q30[i][j] = rotation_q30(r[i][j]);
        }
    }
    return pose;
}

static inline ocel_pose_t rotation_any(rng_t *rng) {
    double forward[3];
    double r[3][3];
    rotation_direction(rng, forward);
    rotation_about(rng, forward, r);
    return rotation_pose(r);
}

#endif
