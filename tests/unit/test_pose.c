/* SPDX-License-Identifier: MIT
 *
 * References: the same sums in long double.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "board.h"
#include "rng.h"
#include "rotations.h"
#include "space/pose.h"
#include "unity.h"

enum { SEED = 20110612, TRIALS = TEST_TRIALS(20000) };

static rng_t rng;

void setUp(void) {
    rng = rng_seed(SEED);
}

void tearDown(void) {
}

static int32_t any_coordinate(int32_t most) {
    return rng_between(&rng, -most, most) >> rng_below(&rng, 30U);
}

static ocel_pose_t any_pose(int32_t most) {
    ocel_pose_t pose = rotation_any(&rng);
    for (int i = 0; i < 3; i++) {
        pose.p_u[i] = any_coordinate(most);
    }
    return pose;
}

static double product(const ocel_pose_t *pose, int row, const int32_t v[3]) {
    double sum = 0.0;
    for (int k = 0; k < 3; k++) {
        sum += ldexp((double)pose->r_q30[row][k], -30) * (double)v[k];
    }
    return sum;
}

static void dot_is_the_exact_sum(void) {
    static const int32_t A[3] = {INT32_MAX, -1, 7};
    static const int32_t B[3] = {INT32_MAX, 1073741824, -3};
    TEST_ASSERT_EQUAL_INT64((int64_t)INT32_MAX * INT32_MAX - 1073741824 - 21, ocel_dot(A, B));
}

static void directions_turn(void) {
    for (int trial = 0; trial < TRIALS; trial++) {
        const ocel_pose_t pose = any_pose(1 << 28);
        const int32_t v[3] = {any_coordinate(1 << 30), any_coordinate(1 << 30),
                              any_coordinate(1 << 30)};
        int32_t turned[3];
        ocel_pose_direction(&pose, v, turned);
        for (int i = 0; i < 3; i++) {
            TEST_ASSERT_DOUBLE_WITHIN(0.500001, product(&pose, i, v), turned[i]);
        }
    }
}

static void points_turn_and_move(void) {
    for (int trial = 0; trial < TRIALS; trial++) {
        const ocel_pose_t pose = any_pose(1 << 28);
        const int32_t p[3] = {any_coordinate(1 << 28), any_coordinate(1 << 28),
                              any_coordinate(1 << 28)};
        int32_t placed[3];
        TEST_ASSERT_TRUE(ocel_pose_point(&pose, p, placed));
        for (int i = 0; i < 3; i++) {
            TEST_ASSERT_DOUBLE_WITHIN(0.500001, product(&pose, i, p) + pose.p_u[i], placed[i]);
        }
    }
}

/* X_A_B takes coordinates in B to coordinates in A: its columns are B's axes. */
static void columns_are_the_axes(void) {
    const ocel_pose_t pose = any_pose(1000);
    for (int axis = 0; axis < 3; axis++) {
        int32_t v[3] = {0, 0, 0};
        int32_t turned[3];
        v[axis] = 1 << 30;
        ocel_pose_direction(&pose, v, turned);
        for (int i = 0; i < 3; i++) {
            TEST_ASSERT_EQUAL_INT32(pose.r_q30[i][axis], turned[i]);
        }
    }
}

/* Whatever coordinates come: a point within 2^30 on each axis, or none. */
static void far_points_are_refused(void) {
    int refused = 0;
    for (int trial = 0; trial < TRIALS; trial++) {
        const ocel_pose_t pose = any_pose(INT32_MAX);
        const int32_t p[3] = {(int32_t)rng_u32(&rng), (int32_t)rng_u32(&rng), INT32_MIN};
        int32_t placed[3] = {1, 1, 1};
        bool inside = true;
        for (int i = 0; i < 3; i++) {
            inside = inside && (fabs(product(&pose, i, p) + pose.p_u[i]) <= ldexp(1.0, 30));
        }
        TEST_ASSERT_EQUAL(inside, ocel_pose_point(&pose, p, placed));
        if (!inside) {
            refused++;
            TEST_ASSERT_EQUAL_INT32(0, placed[0]);
            TEST_ASSERT_EQUAL_INT32(0, placed[1]);
            TEST_ASSERT_EQUAL_INT32(0, placed[2]);
        }
    }
    TEST_ASSERT_TRUE((refused > TRIALS / 2) && (refused < TRIALS));
}

static void the_farthest_point_is_taken(void) {
    ocel_pose_t pose = {{{1 << 30, 0, 0}, {0, 1 << 30, 0}, {0, 0, 1 << 30}}, {0, 0, 0}};
    const int32_t p[3] = {0, -(1 << 30), 0};
    int32_t placed[3];
    TEST_ASSERT_TRUE(ocel_pose_point(&pose, p, placed));
    TEST_ASSERT_EQUAL_INT32(-(1 << 30), placed[1]);
    pose.p_u[1] = -1;
    TEST_ASSERT_FALSE(ocel_pose_point(&pose, p, placed));
}

int main(void) {
    printf("seed %d\n", SEED);
    UNITY_BEGIN();
    RUN_TEST(dot_is_the_exact_sum);
    RUN_TEST(directions_turn);
    RUN_TEST(points_turn_and_move);
    RUN_TEST(columns_are_the_axes);
    RUN_TEST(the_farthest_point_is_taken);
    RUN_TEST(far_points_are_refused);
    return UNITY_END();
}
