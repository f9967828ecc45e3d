/* SPDX-License-Identifier: MIT
 *
 * The heads in double precision: 4x4 matrices of the Denavit-Hartenberg tables as
 * their sources print them (metres or SMU, degrees), independent of the library's
 * models, whose units, links and signs they check.
 */
#ifndef SUPPORT_HEAD_REFERENCE_H
#define SUPPORT_HEAD_REFERENCE_H

#include <math.h>
#include <string.h>

#include <ocellus/head.h>

#define REF_DEGREE (0.017453292519943295)
#define REF_TURN_Q32 4294967296.0

enum { REF_PAPER, REF_ICUB_V1, REF_ICUB_V2, REF_HEADS };

typedef struct {
    double m[4][4];
} ref_matrix_t;

typedef struct {
    double a, d, alpha, offset;
} ref_link_t;

static const char *const REF_HEAD_NAMES[REF_HEADS] = {"paper", "icub v1", "icub v2"};
static const ocel_head_model_t *const REF_HEAD_MODELS[REF_HEADS] = {
    &ocel_head_paper, &ocel_head_icub_v1, &ocel_head_icub_v2};

/* Torso (3), neck pitch, roll, yaw, eyes tilt (d by side), pan. */
static const ref_link_t REF_ICUB_LINKS[2][8] = {{{.032, 0, 90, 0},
                                                 {0, -.0055, 90, -90},
                                                 {.00231, -.1933, -90, -90},
                                                 {.033, 0, 90, 90},
                                                 {0, .001, -90, -90},
                                                 {-.054, .0825, -90, 90},
                                                 {0, 0, -90, 0},
                                                 {0, 0, 90, -90}},
                                                {{.032, 0, 90, 0},
                                                 {0, -.0055, 90, -90},
                                                 {0, -.2233, -90, -90},
                                                 {.0095, 0, 90, 90},
                                                 {0, 0, -90, -90},
                                                 {-.0509, .08205, -90, 90},
                                                 {0, 0, -90, 0},
                                                 {0, 0, 90, -90}}};

static inline ref_matrix_t ref_times(ref_matrix_t a, ref_matrix_t b) {
    ref_matrix_t c;
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            c.m[i][j] = 0.0;
            for (int k = 0; k < 4; k++) {
                c.m[i][j] += a.m[i][k] * b.m[k][j];
            }
        }
    }
    return c;
}

static inline ref_matrix_t ref_link(double a, double d, double alpha_deg, double theta_deg) {
    const double ca = cos(alpha_deg * REF_DEGREE);
    const double sa = sin(alpha_deg * REF_DEGREE);
    const double ct = cos(theta_deg * REF_DEGREE);
    const double st = sin(theta_deg * REF_DEGREE);
    const ref_matrix_t link = {{{ct, -st * ca, st * sa, a * ct},
                                {st, ct * ca, -ct * sa, a * st},
                                {0, sa, ca, d},
                                {0, 0, 0, 1}}};
    return link;
}

static inline ref_matrix_t ref_icub_eye(int version, const double deg[OCEL_JOINT_COUNT],
                                        double side) {
    const double turned[8] = {0.0,
                              0.0,
                              0.0,
                              deg[OCEL_NECK_PITCH],
                              deg[OCEL_NECK_ROLL],
                              deg[OCEL_NECK_YAW],
                              deg[OCEL_EYES_TILT],
                              deg[OCEL_EYES_VERSION] - (side * deg[OCEL_EYES_VERGENCE] / 2.0)};
    ref_matrix_t t = {{{0, -1, 0, 0}, {0, 0, -1, 0}, {1, 0, 0, 0}, {0, 0, 0, 1}}};
    for (int n = 0; n < 8; n++) {
        const ref_link_t *link = &REF_ICUB_LINKS[version - 1][n];
        const double d = link->d + ((n == 6) ? side * .034 : 0.0);
        t = ref_times(t, ref_link(link->a, d, link->alpha, link->offset + turned[n]));
    }
    return t;
}

/* Table 2 of the paper, T05 with d0 in L5. */
static inline ref_matrix_t ref_paper_t05(const double deg[OCEL_JOINT_COUNT], double d0) {
    ref_matrix_t t = ref_link(0, 3.01, 90, 0);
    t = ref_times(t, ref_link(0, 0, -90, deg[OCEL_NECK_PITCH]));
    t = ref_times(t, ref_link(.36, 3.50 - 3.01, 90, deg[OCEL_NECK_YAW]));
    t = ref_times(t, ref_link(0, 0, -90, deg[OCEL_EYES_TILT]));
    return ref_times(t, ref_link(d0, 0, 0, deg[OCEL_EYES_VERSION]));
}

/* The paper's eye: half the baseline to its side of T04, whose y is left, then version
 * and its own angle, inwards; then the camera's axes: right -y, down -z, forward x. */
static inline ref_matrix_t ref_paper_eye(const double deg[OCEL_JOINT_COUNT], double side) {
    double straight[OCEL_JOINT_COUNT];
    memcpy(straight, deg, sizeof(straight));
    straight[OCEL_EYES_VERSION] = 0.0;
    const ref_matrix_t shift = {
        {{1, 0, 0, 0}, {0, 1, 0, -side * .35 / 2.0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    const ref_matrix_t camera = {{{0, 0, 1, 0}, {-1, 0, 0, 0}, {0, -1, 0, 0}, {0, 0, 0, 1}}};
    const double pan = deg[OCEL_EYES_VERSION] + (side * deg[OCEL_EYES_VERGENCE] / 2.0);
    ref_matrix_t t = ref_times(ref_paper_t05(straight, 0.0), shift);
    t = ref_times(t, ref_link(0, 0, 0, pan));
    return ref_times(t, camera);
}

/* The camera's pose in the root: side -1 left, +1 right, 0 the middle. */
static inline ref_matrix_t ref_head_eye(int head, const double deg[OCEL_JOINT_COUNT], double side) {
    return (head == REF_PAPER) ? ref_paper_eye(deg, side) : ref_icub_eye(head, deg, side);
}

static inline int32_t ref_angle_q32(double deg) {
    return (int32_t)lround(deg / 360.0 * REF_TURN_Q32);
}

#endif
