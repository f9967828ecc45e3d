/* SPDX-License-Identifier: MIT
 *
 * Forward kinematics, link by link.  The position is kept in u with 30 fraction
 * bits, products of whole u and the rotation's own bits, so only the rotation
 * rounds: a turn of two axes adds half an LSB of Q30 to each and the 1 LSB of
 * sine and of cosine, to a row 2.2 LSB at worst.  Turns by quarters, all alphas
 * and offsets of the models, are exact.  Five turns on the way: 11 LSB, 2^-26.5.
 */
#include <ocellus/head.h>

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

#include "../base/int_math.h"
#include "../base/trig.h"
#include "pose.h"

/* Turns the axes `first` and `first + 1` about the third: new = cos old + sin next.
 * A row of the rotation has the length 1, so each sum is below 2^60.1. */
static void turn_axes(int32_t r_q30[3][3], uint32_t first, uint32_t turn_q32) {
    int32_t sin_q30;
    int32_t cos_q30;

    ocel_sincos(turn_q32, &sin_q30, &cos_q30);
    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
        int32_t *row = &r_q30[i][first];
        const int64_t a = row[0];
        const int64_t b = row[1];

        row[0] = (int32_t)ocel_shift_round64((a * cos_q30) + (b * sin_q30), 30U);
        row[1] = (int32_t)ocel_shift_round64((b * cos_q30) - (a * sin_q30), 30U);
    }
}

/* The link's angle, modulo a turn.  Four terms below 2^33. */
static uint32_t link_turn(const ocel_head_link_t *link, const int32_t *joints_q32, int32_t side) {
    const int64_t half_q32 = ocel_asr32(joints_q32[OCEL_EYES_VERGENCE], 1U);
    int64_t turn_q32 = link->offset_q32 + (half_q32 * (side * link->vergence_sign));

    if (link->joint < (uint8_t)OCEL_JOINT_COUNT) {
        turn_q32 += (int64_t)joints_q32[link->joint] * link->sign;
    }
    return (uint32_t)((uint64_t)turn_q32 & 0xFFFFFFFFU);
}

/* The chain to one side's camera.  All lengths together are below 2^30 u, so the
 * position in Q30 is below 2^60 and fits int32_t in u. */
static void chain(const ocel_head_model_t *model, const int32_t *joints_q32, int32_t side,
                  ocel_pose_t *X_root_eye) {
    int64_t p_q30[3] = {0, 0, 0}; /* u, from the base */

    *X_root_eye = model->X_root_base;
    for (uint32_t n = 0U; n < model->link_count; n++) { /* bound: OCEL_MAX_HEAD_LINKS = 8 */
        const ocel_head_link_t *link = &model->links[n];
        const int32_t d_u = (int32_t)((int64_t)link->d_u + ((int64_t)side * link->d_side_u));

        turn_axes(X_root_eye->r_q30, 0U, link_turn(link, joints_q32, side));
        for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
            p_q30[i] += ((int64_t)link->a_u * X_root_eye->r_q30[i][0]) +
                        ((int64_t)d_u * X_root_eye->r_q30[i][2]);
        }
        turn_axes(X_root_eye->r_q30, 1U, (uint32_t)link->alpha_q32);
    }
    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 axes */
        X_root_eye->p_u[i] += (int32_t)ocel_shift_round64(p_q30[i], 30U);
    }
}

/* A model's vergence is at least 0 and its pan at most half a turn: what the vergence
 * leaves of the pan fits. */
static bool within_limits(const ocel_head_model_t *model, const int32_t *joints_q32) {
    bool within = true;

    for (uint32_t j = 0U; j < (uint32_t)OCEL_JOINT_COUNT; j++) { /* bound: OCEL_JOINT_COUNT = 6 */
        within =
            within && (joints_q32[j] >= model->min_q32[j]) && (joints_q32[j] <= model->max_q32[j]);
    }
    if (within) {
        const int32_t room_q32 =
            model->max_pan_q32 - ocel_asr32(joints_q32[OCEL_EYES_VERGENCE], 1U);

        within = (joints_q32[OCEL_EYES_VERSION] <= room_q32) &&
                 (joints_q32[OCEL_EYES_VERSION] >= -room_q32);
    }
    return within;
}

/* `count` poses, for the sides first, first + 2, ... */
static ocel_status_t poses(const ocel_head_model_t *model, const int32_t *joints_q32, int32_t first,
                           uint32_t count, ocel_pose_t *X_root_eye) {
    ocel_status_t status = OCEL_NULL_ARGUMENT;

    if (X_root_eye != NULL) {
        /* bytes: OCEL_EYE_COUNT * sizeof(ocel_pose_t) */
        (void)memset(X_root_eye, 0, count * sizeof(*X_root_eye));
        if ((model != NULL) && (joints_q32 != NULL)) {
            status = (model->link_count > (uint32_t)OCEL_MAX_HEAD_LINKS) ? OCEL_BAD_OPTION
                     : within_limits(model, joints_q32)                  ? OCEL_OK
                                                                         : OCEL_OUT_OF_RANGE;
        }
    }
    if (status == OCEL_OK) {
        for (uint32_t n = 0U; n < count; n++) { /* bound: OCEL_EYE_COUNT = 2 */
            chain(model, joints_q32, first + (2 * (int32_t)n), &X_root_eye[n]);
        }
    }
    return status;
}

ocel_status_t ocel_head_forward(const ocel_head_model_t *model,
                                const int32_t joints_q32[OCEL_JOINT_COUNT],
                                ocel_pose_t X_root_eye[OCEL_EYE_COUNT]) {
    return poses(model, joints_q32, -1, (uint32_t)OCEL_EYE_COUNT, X_root_eye);
}

ocel_status_t ocel_head_middle(const ocel_head_model_t *model,
                               const int32_t joints_q32[OCEL_JOINT_COUNT],
                               ocel_pose_t *X_root_middle) {
    return poses(model, joints_q32, 0, 1U, X_root_middle);
}

ocel_status_t ocel_head_place(const ocel_pose_t *X_root_eye, const int32_t p_eye_u[3],
                              int32_t p_root_u[3]) {
    ocel_status_t status = OCEL_NULL_ARGUMENT;

    if (p_root_u != NULL) {
        (void)memset(p_root_u, 0, 3U * sizeof(p_root_u[0]));
    }
    if ((X_root_eye != NULL) && (p_eye_u != NULL) && (p_root_u != NULL)) {
        status = ocel_pose_point(X_root_eye, p_eye_u, p_root_u) ? OCEL_OK : OCEL_OUT_OF_RANGE;
    }
    return status;
}

ocel_status_t ocel_head_of_icub(const int32_t v_icub[3], int32_t v_head[3]) {
    ocel_status_t status = OCEL_NULL_ARGUMENT;

    if (v_head != NULL) {
        (void)memset(v_head, 0, 3U * sizeof(v_head[0]));
    }
    if ((v_icub != NULL) && (v_head != NULL)) {
        status = OCEL_OUT_OF_RANGE;
        if ((v_icub[0] != INT32_MIN) && (v_icub[1] != INT32_MIN)) {
            v_head[0] = -v_icub[0];
            v_head[1] = -v_icub[1];
            v_head[2] = v_icub[2];
            status = OCEL_OK;
        }
    }
    return status;
}
