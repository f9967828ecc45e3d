/* SPDX-License-Identifier: MIT
 *
 * Rigid transforms.  A rotation must be orthonormal to 2^-20 (those of head.h
 * are to 2^-26): that bounds every sum here and nothing checks it.
 */
#ifndef OCEL_POSE_H
#define OCEL_POSE_H

#include <stdbool.h>
#include <stdint.h>

#include <ocellus/space.h>

/* Positions that the stages of the third dimension take and give: |p| <= this, each. */
#define OCEL_MAX_POSITION_U 0x40000000U /* 2^30 */

/* a . b of vectors in any format: |a| |b| < 2^63 as integers, which unit vectors
 * in Q30 and any int32 vectors of 2^61.9 together are. */
int64_t ocel_dot(const int32_t a[3], const int32_t b[3]);

/* v_A = r v_B.  |v_B| < 2^31 as a vector; each component rounded to half an LSB. */
void ocel_pose_direction(const ocel_pose_t *X_A_B, const int32_t v_B[3], int32_t v_A[3]);

/* p_A = r p_B + p, rounded to half a u.  Any p_B.  False, and p_A zero, when a
 * coordinate is beyond OCEL_MAX_POSITION_U. */
bool ocel_pose_point(const ocel_pose_t *X_A_B, const int32_t p_B_u[3], int32_t p_A_u[3]);

#endif
