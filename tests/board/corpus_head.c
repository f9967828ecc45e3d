/* SPDX-License-Identifier: MIT
 *
 * The head's poses, two eyes together, the tracker and the gaze: sequences of
 * plausible and of absurd numbers.
 */
#include <string.h>

#include "corpus.h"
#include "rng.h"

enum { MODELS = 3, ONE_Q30 = 1 << 30, QUARTER_Q32 = 1 << 30, FRAMES = 60 };

static const ocel_head_model_t *model_of(uint32_t i) {
    static const ocel_head_model_t *const models[MODELS] = {&ocel_head_paper, &ocel_head_icub_v1,
                                                            &ocel_head_icub_v2};
    return models[i];
}

/* All magnitudes below 2^bits, either sign. */
static int32_t any_i32(rng_t *rng, uint32_t bits) {
    const uint32_t size = rng_u32(rng) >> (32U - bits);
    const int32_t v = (int32_t)(size >> rng_below(rng, bits));
    return ((rng_u32(rng) & 1U) != 0U) ? -v : v;
}

static void hash_pose(hash_t *h, const ocel_pose_t *pose) {
    for (uint32_t i = 0U; i < 3U; i++) {
        hash_i32s(h, pose->r_q30[i], 3U);
    }
    hash_i32s(h, pose->p_u, 3U);
}

/* Within the limits, sometimes on one, sometimes a little beyond. */
static void any_joints(rng_t *rng, const ocel_head_model_t *model,
                       int32_t joints[OCEL_JOINT_COUNT]) {
    for (uint32_t k = 0U; k < (uint32_t)OCEL_JOINT_COUNT; k++) {
        const int32_t low = model->min_q32[k];
        const int32_t high = model->max_q32[k];
        const uint32_t choice = rng_below(rng, 100U);
        joints[k] = rng_between(rng, low / 2, high / 2);
        joints[k] = (choice == 0U) ? high : joints[k];
        joints[k] = (choice == 1U) ? (low - 1) : joints[k];
    }
}

/* ---- Poses ---- */

void corpus_head(hash_t *h) {
    rng_t rng = rng_seed(20110614U);
    for (uint32_t i = 0U; i < 150U; i++) {
        const ocel_head_model_t *const model = model_of(i % (uint32_t)MODELS);
        int32_t joints[OCEL_JOINT_COUNT];
        ocel_pose_t eyes[OCEL_EYE_COUNT];
        ocel_pose_t middle;
        int32_t p_eye[3];
        int32_t p_root[3] = {0, 0, 0};
        memset(eyes, 0, sizeof(eyes));
        memset(&middle, 0, sizeof(middle));
        any_joints(&rng, model, joints);
        hash_enum(h, ocel_head_forward(model, joints, eyes));
        hash_pose(h, &eyes[OCEL_LEFT]);
        hash_pose(h, &eyes[OCEL_RIGHT]);
        hash_enum(h, ocel_head_middle(model, joints, &middle));
        hash_pose(h, &middle);
        for (uint32_t k = 0U; k < 3U; k++) {
            p_eye[k] = any_i32(&rng, 31U);
        }
        hash_enum(h, ocel_head_place(&eyes[OCEL_LEFT], p_eye, p_root));
        hash_i32s(h, p_root, 3U);
        hash_enum(h, ocel_head_of_icub(p_eye, p_root));
        hash_i32s(h, p_root, 3U);
    }
}

/* ---- Two eyes ---- */

static void hash_estimate(hash_t *h, const ocel_estimate_t *estimate) {
    hash_i32s(h, estimate->p_root_u, 3U);
    hash_i64s(h, estimate->cov_root_u2, OCEL_SYM3_COUNT);
}

static void hash_ball(hash_t *h, const ocel_ball_t *ball) {
    hash_estimate(h, &ball->best);
    hash_estimate(h, &ball->stereo);
    hash_estimate(h, &ball->by_radius);
    hash_u32(h, ball->gap_u);
    hash_u32(h, ball->radius_u);
    hash_u32(h, (ball->has_stereo ? 1U : 0U) | (ball->has_radius ? 2U : 0U) |
                    (ball->disagree ? 4U : 0U));
}

/* Towards a point in front of an eye; the ray's length is 1 to the last bits. */
static bool unit_towards(const int32_t p_cam_u[3], int32_t d_q30[3]) {
    static const ocel_intrinsics_t wide = {16 << 16, 16 << 16, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    ocel_camera_t camera;
    ocel_point_t pixel = {0, 0};
    const bool ok = (ocel_camera_init(&camera, &wide) == OCEL_OK) &&
                    (ocel_camera_project(&camera, p_cam_u, &pixel) == OCEL_OK);
    return ok && (ocel_camera_ray(&camera, &pixel, d_q30) == OCEL_OK);
}

static void any_cone(rng_t *rng, const int32_t p_cam_u[3], ocel_cone_t *cone) {
    memset(cone, 0, sizeof(*cone));
    (void)unit_towards(p_cam_u, cone->axis_cam_q30);
    cone->sin_q30 = (uint32_t)rng_between(rng, 0, ONE_Q30);
    cone->sin_q30 >>= rng_below(rng, 12U);
    for (uint32_t k = 0U; k < (uint32_t)OCEL_SYM3_COUNT; k++) {
        const uint64_t noise = rng_u64(rng);
        cone->cov_q60[k] = (int64_t)(noise >> (20U + rng_below(rng, 20U)));
    }
    cone->cov_q60[OCEL_XY] /= 4;
    cone->cov_q60[OCEL_XZ] /= -4;
    cone->cov_q60[OCEL_YZ] /= 4;
    cone->point_count = 100U;
    cone->inlier_count = 90U;
}

static void midpoint(hash_t *h, rng_t *rng) {
    ocel_ray_t left;
    ocel_ray_t right;
    ocel_midpoint_t meeting;
    memset(&left, 0, sizeof(left));
    memset(&right, 0, sizeof(right));
    memset(&meeting, 0, sizeof(meeting));
    const int32_t away = (1 << 16) + (any_i32(rng, 20U) & 0xFFFFF);
    int32_t p_left[3] = {0, 0, away};
    p_left[0] = any_i32(rng, 17U); /* one draw a statement: the order is then the source's */
    p_left[1] = any_i32(rng, 17U);
    const int32_t p_right[3] = {p_left[0] - 68000, p_left[1] + any_i32(rng, 10U), away};
    right.p_u[0] = 68000;
    (void)unit_towards(p_left, left.d_q30);
    (void)unit_towards(p_right, right.d_q30);
    hash_enum(h, ocel_stereo_midpoint(&left, &right, &meeting));
    hash_i32s(h, meeting.p_u, 3U);
    hash_u32(h, meeting.gap_u);
    hash_u32(h, meeting.range_u[0]);
    hash_u32(h, meeting.range_u[1]);
}

static void encoders(hash_t *h, rng_t *rng) {
    for (int32_t variant = 0; variant < 4; variant++) {
        const int32_t version = any_i32(rng, 31U);
        const int32_t vergence = any_i32(rng, 30U);
        int32_t residual[OCEL_EYE_COUNT];
        int32_t p[3] = {0, 0, 0};
        residual[OCEL_LEFT] = any_i32(rng, 28U);
        residual[OCEL_RIGHT] = any_i32(rng, 28U);
        hash_enum(h, ocel_stereo_encoders((ocel_encoders_t)variant, 68000, version, vergence,
                                          residual, p));
        hash_i32s(h, p, 3U);
    }
}

void corpus_stereo(hash_t *h) {
    rng_t rng = rng_seed(20110615U);
    for (uint32_t i = 0U; i < 200U; i++) {
        const ocel_head_model_t *const model = model_of(i % (uint32_t)MODELS);
        const int32_t radii[3] = {35000, 0, any_i32(&rng, 24U)};
        int32_t joints[OCEL_JOINT_COUNT];
        ocel_pose_t eyes[OCEL_EYE_COUNT];
        ocel_cone_t cones[OCEL_EYE_COUNT];
        ocel_ball_t ball;
        midpoint(h, &rng);
        encoders(h, &rng);
        any_joints(&rng, model, joints);
        memset(eyes, 0, sizeof(eyes));
        memset(&ball, 0, sizeof(ball));
        (void)ocel_head_forward(model, joints, eyes);
        for (uint32_t k = 0U; k < (uint32_t)OCEL_EYE_COUNT; k++) {
            int32_t p[3];
            p[0] = any_i32(&rng, 17U);
            p[1] = any_i32(&rng, 17U);
            p[2] = rng_between(&rng, 100000, 1000000);
            any_cone(&rng, p, &cones[k]);
        }
        for (uint32_t k = 0U; k < 3U; k++) {
            hash_enum(h, ocel_stereo_ball(((i % 7U) == 1U) ? NULL : &cones[OCEL_LEFT],
                                          ((i % 5U) == 1U) ? NULL : &cones[OCEL_RIGHT], eyes,
                                          radii[k], &ball));
            hash_ball(h, &ball);
        }
    }
}

/* ---- The tracker ---- */

static void hash_track(hash_t *h, const ocel_track_t *track) {
    hash_enum(h, track->state);
    hash_i32s(h, track->p_root_u, 3U);
    hash_i32s(h, track->v_root_u_s, 3U);
    hash_i64s(h, track->cov_root_u2, OCEL_SYM3_COUNT);
    hash_i64(h, track->seen_us);
}

/* Where the ball is expected in an image of an eye that looks along the root's z. */
static void region(hash_t *h, const ocel_track_t *track) {
    static const ocel_intrinsics_t lens = {277 << 16, 277 << 16, 160 << 16, 120 << 16, 0,  0,
                                           0,         0,         0,         320,       240};
    static const ocel_pose_t ahead = {{{ONE_Q30, 0, 0}, {0, ONE_Q30, 0}, {0, 0, ONE_Q30}},
                                      {0, 0, -400000}};
    ocel_camera_t camera;
    ocel_rect_t roi;
    memset(&roi, 0, sizeof(roi));
    hash_enum(h, ocel_camera_init(&camera, &lens));
    hash_enum(h, ocel_tracker_roi(track, &ahead, &camera, 35000, &roi));
    hash_u32(h, roi.left);
    hash_u32(h, roi.top);
    hash_u32(h, roi.width);
    hash_u32(h, roi.height);
}

/* A ball that flies, is hidden, jumps; then anything. */
static void track(hash_t *h, rng_t *rng, const ocel_tracker_config_t *config, bool wild) {
    ocel_tracker_t tracker;
    int64_t time = wild ? (int64_t)rng_u64(rng) : 0;
    memset(&tracker, 0, sizeof(tracker));
    hash_enum(h, ocel_tracker_init(&tracker, config));
    for (int32_t frame = 0; frame < FRAMES; frame++) {
        ocel_estimate_t seen;
        ocel_track_t now;
        memset(&now, 0, sizeof(now));
        memset(&seen, 0, sizeof(seen));
        for (uint32_t k = 0U; k < 3U; k++) {
            seen.p_root_u[k] = (wild || (frame == 40))
                                   ? any_i32(rng, 30U)
                                   : (frame * 2000 * (int32_t)(k + 1U) + any_i32(rng, 9U));
        }
        for (uint32_t k = 0U; k < (uint32_t)OCEL_SYM3_COUNT; k++) {
            const bool diagonal = (k == OCEL_XX) || (k == OCEL_YY) || (k == OCEL_ZZ);
            seen.cov_root_u2[k] = diagonal ? 250000 : 1000;
            if (wild) {
                const uint64_t noise = rng_u64(rng);
                seen.cov_root_u2[k] = (int64_t)(noise >> (10U + rng_below(rng, 50U)));
            }
        }
        const bool hidden = ((frame / 10) % 3) == 1;
        time = (int64_t)((uint64_t)time + (wild ? rng_below(rng, 200000U) : 33333U));
        hash_enum(h, ocel_tracker_update(&tracker, time, hidden ? NULL : &seen, &now));
        hash_track(h, &now);
        region(h, &now);
    }
}

void corpus_tracker(hash_t *h) {
    static const ocel_tracker_config_t configs[] = {
        {500000U, 2000000, 300000, 4U * 65536U, 20000, {0, 0, 0}},
        {4000000U, 10000000, 10000000, 65536U, 0, {0, 0, -9810000}},
        {1U, 1, 0, 16U * 65536U, 1 << 26, {1 << 27, -(1 << 27), 0}},
        {0U, 1, 0, 65536U, 0, {0, 0, 0}},
    };
    rng_t rng = rng_seed(20110616U);
    for (size_t i = 0U; i < sizeof(configs) / sizeof(configs[0]); i++) {
        track(h, &rng, &configs[i], false);
        track(h, &rng, &configs[i], true);
    }
}

/* ---- The gaze ---- */

static void follow(hash_t *h, rng_t *rng, const ocel_head_model_t *model,
                   const ocel_gaze_config_t *config, bool wild) {
    ocel_gaze_t gaze;
    int32_t joints[OCEL_JOINT_COUNT];
    int64_t time = 0;
    memset(&gaze, 0, sizeof(gaze));
    memset(joints, 0, sizeof(joints));
    joints[OCEL_EYES_VERGENCE] = 1 << 26;
    hash_enum(h, ocel_gaze_init(&gaze, model, config));
    for (int32_t frame = 0; frame < FRAMES; frame++) {
        ocel_gaze_error_t errors[OCEL_EYE_COUNT];
        int32_t command[OCEL_JOINT_COUNT];
        memset(errors, 0, sizeof(errors));
        memset(command, 0, sizeof(command));
        for (uint32_t k = 0U; k < (uint32_t)OCEL_EYE_COUNT; k++) {
            int32_t d[3];
            d[0] = any_i32(rng, 20U);
            d[1] = any_i32(rng, 20U);
            d[2] = wild ? any_i32(rng, 31U) : (1 << 21);
            hash_enum(h, ocel_gaze_error(d, &errors[k]));
            hash_i32(h, errors[k].right_q32);
            hash_i32(h, errors[k].down_q32);
            errors[k].seen = (frame % 9) != (int32_t)k;
        }
        time += wild ? any_i32(rng, 18U) : 33333;
        hash_enum(h, ocel_gaze_update(&gaze, time, errors, joints, command));
        hash_i32s(h, command, OCEL_JOINT_COUNT);
        for (uint32_t k = 0U; k < (uint32_t)OCEL_JOINT_COUNT; k++) {
            joints[k] = wild ? any_i32(rng, 31U) : (joints[k] + command[k] / 30);
        }
    }
}

void corpus_gaze(hash_t *h) {
    rng_t rng = rng_seed(20110617U);
    for (uint32_t i = 0U; i < (uint32_t)MODELS; i++) {
        const ocel_gaze_config_t *const config = (i == 0U) ? &ocel_gaze_paper : &ocel_gaze_icub;
        ocel_gaze_config_t other = *config;
        follow(h, &rng, model_of(i), config, false);
        follow(h, &rng, model_of(i), config, true);
        other.sign[OCEL_NECK_YAW] = 2;
        follow(h, &rng, model_of(i), &other, false);
    }
}
