/* SPDX-License-Identifier: MIT
 *
 * What the library answers to a pair of frames, and every member of it by name.  In C:
 * the simulator records these answers, and a firmware (tests/firmware) gives its own.
 */
#ifndef OCELLUS_SIM_ANSWERS_H
#define OCELLUS_SIM_ANSWERS_H

#include <string.h>

#include <ocellus/ocellus.h>

/* ---- The answers ---- */

typedef struct {
    ocel_detection_t detection;
    ocel_status_t cone_status;
    ocel_cone_t cone;
    ocel_status_t sphere_status; /* OCEL_NOT_SEEN without a cone */
    ocel_sphere_t sphere;
} eye_answer_t;

typedef struct {
    eye_answer_t eye[OCEL_EYE_COUNT];
    ocel_status_t head_status;
    ocel_pose_t X_root_eye[OCEL_EYE_COUNT];
    ocel_status_t ball_status; /* the head's where there are no poses */
    ocel_ball_t ball;
} pair_answer_t;

/* What follows an eye's detection, which is in `answer` already. */
static inline void answer_to_sphere(const ocel_eye_t *eye, const ocel_camera_t *camera,
                                    int32_t radius_u, eye_answer_t *answer) {
    memset(&answer->sphere, 0, sizeof(answer->sphere));
    answer->sphere_status = OCEL_NOT_SEEN;
    answer->cone_status = ocel_eye_cone(eye, camera, &answer->detection, &answer->cone);
    if (answer->cone.sin_q30 != 0U) {
        answer->sphere_status = ocel_sphere_of_cone(&answer->cone, radius_u, &answer->sphere);
    }
}

static inline const ocel_cone_t *answer_cone(const eye_answer_t *answer) {
    return (answer->cone.sin_q30 != 0U) ? &answer->cone : NULL;
}

/* What follows both eyes': the head's poses, and the ball in its root's frame. */
static inline void answer_ball(const int32_t joints_q32[OCEL_JOINT_COUNT], int32_t radius_u,
                               pair_answer_t *answer) {
    memset(&answer->ball, 0, sizeof(answer->ball));
    answer->head_status = ocel_head_forward(&ocel_head_paper, joints_q32, answer->X_root_eye);
    answer->ball_status = answer->head_status;
    if (answer->head_status == OCEL_OK) {
        answer->ball_status = ocel_stereo_ball(answer_cone(&answer->eye[OCEL_LEFT]),
                                               answer_cone(&answer->eye[OCEL_RIGHT]),
                                               answer->X_root_eye, radius_u, &answer->ball);
    }
}

/* ---- Every member by name ---- */

/* Where they go: each as "part.name", or "part.name[index]" with an index of 0 or more. */
typedef struct {
    void (*put)(void *to, const char *part, const char *name, int index, int64_t value);
    void *to;
} answer_sink_t;

static inline void put_one(const answer_sink_t *out, const char *part, const char *name,
                           int64_t value) {
    out->put(out->to, part, name, -1, value);
}

static inline void put_i32s(const answer_sink_t *out, const char *part, const char *name,
                            const int32_t *v, int count) {
    for (int i = 0; i < count; i++) {
        out->put(out->to, part, name, i, v[i]);
    }
}

static inline void put_sym3(const answer_sink_t *out, const char *part, const char *name,
                            const int64_t *v) {
    for (int i = 0; i < OCEL_SYM3_COUNT; i++) {
        out->put(out->to, part, name, i, v[i]);
    }
}

static inline void put_blob(const answer_sink_t *out, const char *part, const ocel_blob_t *blob) {
    put_one(out, part, "blob_left", blob->box.left);
    put_one(out, part, "blob_top", blob->box.top);
    put_one(out, part, "blob_width", blob->box.width);
    put_one(out, part, "blob_height", blob->box.height);
    put_one(out, part, "blob_first_x", blob->first_x);
    put_one(out, part, "blob_touches_edge", blob->touches_edge);
    put_one(out, part, "blob_area", blob->area);
    put_one(out, part, "blob_sum_x", (int64_t)blob->sum_x);
    put_one(out, part, "blob_sum_y", (int64_t)blob->sum_y);
    put_one(out, part, "blob_sum_xx", (int64_t)blob->sum_xx);
    put_one(out, part, "blob_sum_xy", (int64_t)blob->sum_xy);
    put_one(out, part, "blob_sum_yy", (int64_t)blob->sum_yy);
}

static inline void put_ellipse(const answer_sink_t *out, const char *part,
                               const ocel_ellipse_t *ellipse) {
    put_one(out, part, "cx_px_q16", ellipse->cx_px_q16);
    put_one(out, part, "cy_px_q16", ellipse->cy_px_q16);
    put_one(out, part, "a_px_q16", ellipse->a_px_q16);
    put_one(out, part, "b_px_q16", ellipse->b_px_q16);
    put_one(out, part, "angle_turn_q32", ellipse->angle_turn_q32);
    put_one(out, part, "rms_px_q16", ellipse->rms_px_q16);
    put_one(out, part, "centre_sigma_px_q16", ellipse->centre_sigma_px_q16);
    put_one(out, part, "arc_coverage_q16", ellipse->arc_coverage_q16);
    put_one(out, part, "point_count", ellipse->point_count);
    put_one(out, part, "method", ellipse->method);
    put_one(out, part, "perturbed", ellipse->perturbed);
}

static inline void put_stats(const answer_sink_t *out, const char *part,
                             const ocel_label_stats_t *stats) {
    put_one(out, part, "stats_runs", stats->runs);
    put_one(out, part, "stats_unions", stats->unions);
    put_one(out, part, "stats_components", stats->components);
    put_one(out, part, "stats_labels_max", stats->labels_max);
    put_one(out, part, "stats_cracks_max", stats->cracks_max);
}

static inline void put_detection(const answer_sink_t *out, const char *part,
                                 const ocel_detection_t *detection) {
    put_one(out, part, "status", detection->status);
    put_blob(out, part, &detection->blob);
    put_ellipse(out, part, &detection->ellipse);
    put_one(out, part, "has_ellipse", detection->has_ellipse);
    put_one(out, part, "boundary_count", detection->boundary_count);
    put_one(out, part, "boundary_stride", detection->boundary_stride);
    put_stats(out, part, &detection->stats);
}

static inline void put_cone(const answer_sink_t *out, const char *part, const ocel_cone_t *cone) {
    put_i32s(out, part, "cone_axis_cam_q30", cone->axis_cam_q30, 3);
    put_one(out, part, "cone_sin_q30", cone->sin_q30);
    put_sym3(out, part, "cone_cov_q60", cone->cov_q60);
    put_one(out, part, "cone_rms_px_q16", cone->rms_px_q16);
    put_one(out, part, "cone_arc_coverage_q16", cone->arc_coverage_q16);
    put_one(out, part, "cone_point_count", cone->point_count);
    put_one(out, part, "cone_inlier_count", cone->inlier_count);
}

static inline void put_sphere(const answer_sink_t *out, const char *part,
                              const ocel_sphere_t *sphere) {
    put_i32s(out, part, "sphere_p_cam_u", sphere->p_cam_u, 3);
    put_one(out, part, "sphere_radius_u", sphere->radius_u);
    put_one(out, part, "sphere_range_u", sphere->range_u);
    put_sym3(out, part, "sphere_cov_cam_u2", sphere->cov_cam_u2);
}

static inline void put_eye(const answer_sink_t *out, const char *part, const eye_answer_t *eye) {
    put_detection(out, part, &eye->detection);
    put_one(out, part, "cone_status", eye->cone_status);
    put_cone(out, part, &eye->cone);
    put_one(out, part, "sphere_status", eye->sphere_status);
    put_sphere(out, part, &eye->sphere);
}

static inline void put_pose(const answer_sink_t *out, const char *part, const ocel_pose_t *pose) {
    put_i32s(out, part, "X_root_eye_r_q30", &pose->r_q30[0][0], 9);
    put_i32s(out, part, "X_root_eye_p_u", pose->p_u, 3);
}

static inline void put_estimate(const answer_sink_t *out, const char *part,
                                const ocel_estimate_t *estimate) {
    put_i32s(out, part, "p_root_u", estimate->p_root_u, 3);
    put_sym3(out, part, "cov_root_u2", estimate->cov_root_u2);
}

static inline void put_ball(const answer_sink_t *out, const ocel_ball_t *ball) {
    put_estimate(out, "best", &ball->best);
    put_estimate(out, "stereo", &ball->stereo);
    put_estimate(out, "by_radius", &ball->by_radius);
    put_one(out, "ball", "gap_u", ball->gap_u);
    put_one(out, "ball", "radius_u", ball->radius_u);
    put_one(out, "ball", "has_stereo", ball->has_stereo);
    put_one(out, "ball", "has_radius", ball->has_radius);
    put_one(out, "ball", "disagree", ball->disagree);
}

static inline void put_pair(const answer_sink_t *out, const pair_answer_t *answer) {
    static const char *const parts[OCEL_EYE_COUNT] = {"left", "right"};
    put_one(out, "head", "status", answer->head_status);
    for (int side = 0; side < OCEL_EYE_COUNT; side++) {
        put_eye(out, parts[side], &answer->eye[side]);
        put_pose(out, parts[side], &answer->X_root_eye[side]);
    }
    put_one(out, "ball", "status", answer->ball_status);
    put_ball(out, &answer->ball);
}

#endif
