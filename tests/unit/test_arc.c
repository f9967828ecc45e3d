/* SPDX-License-Identifier: MIT
 *
 * The table behind centre_sigma, recomputed: the Kanatani-Cramer-Rao bound of
 * the centre for points spread evenly over one arc of a circle.
 */
#include <math.h>
#include <stdint.h>
#include <string.h>

#include <ocellus/types.h>

#include "board.h"
#include "fit/arc.h"
#include "unity.h"

enum { TERMS = 5, STEPS = TEST_TRIALS_AT_LEAST(400, 20000) };

void setUp(void) {
}

void tearDown(void) {
}

/* Solves a x = b in place, a symmetric and positive definite. */
static void solve(long double a[TERMS][TERMS], long double b[TERMS]) {
    for (int k = 0; k < TERMS; k++) {
        for (int i = k + 1; i < TERMS; i++) {
            const long double factor = a[i][k] / a[k][k];
            for (int j = k; j < TERMS; j++) {
                a[i][j] -= factor * a[k][j];
            }
            b[i] -= factor * b[k];
        }
    }
    for (int k = TERMS - 1; k >= 0; k--) {
        for (int j = k + 1; j < TERMS; j++) {
            b[k] -= a[k][j] * b[j];
        }
        b[k] /= a[k][k];
    }
}

/* The radial residual of an ellipse near a circle is a combination of 1, cos t,
 * sin t, cos 2t and sin 2t, the second and third of which move the centre: the
 * bound is the root of their variances, for unit noise and one point. */
static double bound(double arc) {
    long double fisher[TERMS][TERMS] = {{0}};
    long double variance = 0.0L;
    for (int s = 0; s < STEPS; s++) {
        const long double t = (long double)arc * ((s + 0.5L) / STEPS - 0.5L);
        const long double term[TERMS] = {1.0L, cosl(t), sinl(t), cosl(2 * t), sinl(2 * t)};
        for (int i = 0; i < TERMS; i++) {
            for (int j = 0; j < TERMS; j++) {
                fisher[i][j] += term[i] * term[j] / STEPS;
            }
        }
    }
    for (int axis = 1; axis <= 2; axis++) {
        long double a[TERMS][TERMS];
        long double b[TERMS] = {0};
        memcpy(a, fisher, sizeof(a));
        b[axis] = 1.0L;
        solve(a, b);
        variance += b[axis];
    }
    return (double)sqrtl(variance);
}

/* An rms of 1 px and 2^14 points make sigma the table's entry over 2^7. */
static void test_sigma_is_the_bound(void) {
    for (uint32_t sectors = 4; sectors <= OCEL_SECTORS; sectors++) {
        const uint32_t seen = (sectors < OCEL_SECTORS) ? (sectors - 1U) : sectors;
        const double wanted = bound(2.0 * 3.14159265358979323846 * seen / OCEL_SECTORS);
        ocel_ellipse_t ellipse = {0};
        ellipse.rms_px_q16 = 65536U;
        ellipse.point_count = 16384U;
        ocel_arc_judge(sectors, &ellipse);
        /* Half an LSB of the table, 1/32, and a thousandth for what it was made with. */
        TEST_ASSERT_DOUBLE_WITHIN(1.0 / 32.0 + wanted / 1000.0, wanted,
                                  (double)ellipse.centre_sigma_px_q16 * 128.0 / 65536.0);
        TEST_ASSERT_EQUAL_UINT32(sectors * 2048U, ellipse.arc_coverage_q16);
    }
}

int main(void) {
    UNITY_BEGIN();
    RUN_TEST(test_sigma_is_the_bound);
    return UNITY_END();
}
