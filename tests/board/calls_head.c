/* SPDX-License-Identifier: MIT
 *
 * Calls of head.h, stereo.h, tracker.h and gaze.h.
 */
#include "calls.h"

static ocel_cone_t cone_right;
static ocel_pose_t eyes[OCEL_EYE_COUNT];
static ocel_ball_t ball;
static ocel_tracker_t tracker;
static ocel_track_t track;
static ocel_gaze_t gaze;
static ocel_gaze_error_t errors[OCEL_EYE_COUNT];
static int32_t command[OCEL_JOINT_COUNT];
static int32_t vector[3];

static const int32_t joints[OCEL_JOINT_COUNT] = {50000000,  -20000000, 90000000,
                                                 -30000000, 40000000,  110000000};

/* ---- Head and stereo ---- */

static void call_forward(void) {
    must(ocel_head_forward(&ocel_head_icub_v2, joints, eyes), "forward");
}

static void call_middle(void) {
    ocel_pose_t middle;
    must(ocel_head_middle(&ocel_head_icub_v2, joints, &middle), "middle");
}

static void call_place(void) {
    must(ocel_head_place(&eyes[OCEL_LEFT], point_u, vector), "place");
}

static void call_of_icub(void) {
    must(ocel_head_of_icub(point_u, vector), "axes");
}

/* Two rays that meet in point_u, 68000 u apart where they begin. */
static ocel_ray_t ray_left;
static ocel_ray_t ray_right;

static void look_at_point(ocel_ray_t *ray, int32_t begin_x) {
    const int32_t p[3] = {point_u[0] - begin_x, point_u[1], point_u[2]};
    ocel_point_t seen;
    must(ocel_camera_project(&camera, p, &seen), "project");
    must(ocel_camera_ray(&camera, &seen, ray->d_q30), "ray");
    ray->p_u[0] = begin_x;
}

static void call_midpoint(void) {
    ocel_midpoint_t middle;
    must(ocel_stereo_midpoint(&ray_left, &ray_right, &middle), "midpoint");
}

static void call_encoders(void) {
    static const int32_t residual[OCEL_EYE_COUNT] = {1000000, -2000000};
    must(ocel_stereo_encoders(OCEL_ENCODERS_EXACT, 68000, 40000000, 110000000, residual, vector),
         "encoders");
}

static void call_ball(void) {
    (void)ocel_stereo_ball(&cone, &cone_right, eyes, 35000, &ball);
}

/* ---- Tracker and gaze ---- */

static const ocel_tracker_config_t tracker_config = {500000U,     2000000, 300000,
                                                     4U * 65536U, 20000,   {0, 0, 0}};
static int64_t now_us;

static void call_tracker_init(void) {
    must(ocel_tracker_init(&tracker, &tracker_config), "tracker");
}

static void call_update(void) {
    const ocel_estimate_t seen = {{100000 + (int32_t)(now_us / 10), 200000, 300000},
                                  {250000, 1000, 1000, 250000, 1000, 250000}};
    now_us += 33333;
    must(ocel_tracker_update(&tracker, now_us, &seen, &track), "update");
}

static void call_update_unseen(void) {
    now_us += 33333;
    (void)ocel_tracker_update(&tracker, now_us, NULL, &track);
}

static void call_roi(void) {
    ocel_rect_t roi;
    (void)ocel_tracker_roi(&track, &eyes[OCEL_LEFT], &camera, 35000, &roi);
}

static void call_gaze_init(void) {
    must(ocel_gaze_init(&gaze, &ocel_head_icub_v2, &ocel_gaze_icub), "gaze");
}

static void call_gaze_error(void) {
    must(ocel_gaze_error(point_u, &errors[OCEL_LEFT]), "error");
}

static void call_gaze_update(void) {
    now_us += 33333;
    must(ocel_gaze_update(&gaze, now_us, errors, joints, command), "gaze");
}

void measure_head(void) {
    /* The same ball for both eyes, which converge on it. */
    cone_right = cone;
    look_at_point(&ray_left, 0);
    look_at_point(&ray_right, 68000);
    measure("ocel_head_forward", "icub v2", 1, call_forward);
    measure("ocel_head_middle", "icub v2", 1, call_middle);
    measure("ocel_head_place", "a point", 1, call_place);
    measure("ocel_head_of_icub", "a point", 1, call_of_icub);
    measure("ocel_stereo_midpoint", "two rays", 1, call_midpoint);
    measure("ocel_stereo_encoders", "exact", 1, call_encoders);
    measure("ocel_stereo_ball", "two cones", 1, call_ball);
    measure("ocel_tracker_init", "", 1, call_tracker_init);
    call_update();
    call_update();
    measure("ocel_tracker_update", "seen", 1, call_update);
    measure("ocel_tracker_update", "not seen", 1, call_update_unseen);
    measure("ocel_tracker_roi", "", 1, call_roi);
    measure("ocel_gaze_init", "icub v2", 1, call_gaze_init);
    measure("ocel_gaze_error", "a direction", 1, call_gaze_error);
    errors[OCEL_RIGHT] = errors[OCEL_LEFT];
    call_gaze_update();
    measure("ocel_gaze_update", "both eyes see", 1, call_gaze_update);
}
