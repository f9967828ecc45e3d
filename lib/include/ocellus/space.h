/* SPDX-License-Identifier: MIT
 *
 * The data in which the stages of the third dimension meet.
 *
 * Lengths are whole numbers of a unit u that the caller chooses, the same for
 * the ball's radius, positions and baselines: micrometres suit a robot's table
 * (a ball of 35 mm is 35000 u) and reach to 2 km.  The unit is also the
 * resolution of a result, so a ball's radius should be 1000 u or more.
 *
 * Frames, told by the names: `cam` x right, y down, z forward; `head` x forward,
 * y left, z up (the paper's); `root` the robot's own (head.h).  X_A_B is the
 * pose of B in A: it takes coordinates in B to coordinates in A.
 *
 * Angles are fractions of a turn, 2^32 = a turn; a joint's is signed, within
 * half a turn.
 */
#ifndef OCELLUS_SPACE_H
#define OCELLUS_SPACE_H

#include <stdint.h>

/* A symmetric 3x3 matrix, its upper triangle row by row. */
enum { OCEL_XX = 0, OCEL_XY, OCEL_XZ, OCEL_YY, OCEL_YZ, OCEL_ZZ, OCEL_SYM3_COUNT };

/* A rigid transform: p_A = r p_B + p. */
typedef struct {
    int32_t r_q30[3][3]; /* orthonormal, row by row: its columns are B's axes in A */
    int32_t p_u[3];      /* B's origin in A */
} ocel_pose_t;

/* A half-line, in the frame that its name tells. */
typedef struct {
    int32_t p_u[3];   /* where it begins */
    int32_t d_q30[3]; /* unit vector */
} ocel_ray_t;

#endif
