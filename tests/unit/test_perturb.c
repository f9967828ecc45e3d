/* SPDX-License-Identifier: MIT
 *
 * Two references in long double: the paper's formula with theta in the stated
 * format (32 fraction bits of a turn), and the paper's formula as it stands.
 */
#include <math.h>
#include <stdio.h>

#include "base/trig.h"
#include "board.h"
#include "fit/perturb.h"
#include "rng.h"
#include "unity.h"

enum { SEED = 20110605, RANDOM_TRIALS = TEST_TRIALS(500000) };

#define ONE_Q26 ((int32_t)1 << 26)
#define AMPLITUDE_LSB 67109 /* 0.001 * 2^26 = 67108.864, rounded up */
#define AMPLITUDE 0.001L
#define FREQUENCY 1000.0L

static rng_t rng;

void setUp(void) {
    rng = rng_seed(SEED);
}

void tearDown(void) {
}

static long double two_pi(void) {
    return 2.0L * acosl(-1.0L);
}

/* The paper's eqs. 11-13 for a given theta in radians; the larger difference
 * of the two coordinates, in LSB. */
static long double difference(int32_t x, int32_t y, long double theta) {
    const long double rho = hypotl((long double)x, (long double)y);
    const long double moved = rho + ldexpl(AMPLITUDE * sinl(two_pi() * FREQUENCY * theta), 26);
    int32_t px = x;
    int32_t py = y;
    ocel_perturb_point(&px, &py);
    /* (x, y) / rho is (cos, sin) of the true angle, not of the rounded one. */
    return fmaxl(fabsl((long double)px - (moved * ((long double)x / rho))),
                 fabsl((long double)py - (moved * ((long double)y / rho))));
}

static long double stated_theta(int32_t x, int32_t y) {
    int64_t magnitude = 0;
    uint32_t turn_q32 = 0U;
    ocel_polar(x, y, &magnitude, &turn_q32);
    return ldexpl((long double)turn_q32, -32) * two_pi();
}

static long double paper_theta(int32_t x, int32_t y) {
    const long double theta = atan2l((long double)y, (long double)x);
    return (theta < 0.0L) ? (theta + two_pi()) : theta;
}

static long double worst_stated;
static long double worst_paper;

static void check_point(int32_t x, int32_t y) {
    const long double stated = difference(x, y, stated_theta(x, y));
    const long double paper = difference(x, y, paper_theta(x, y));
    worst_stated = fmaxl(worst_stated, stated);
    worst_paper = fmaxl(worst_paper, paper);
    /* Rounding to Q26 is half an LSB; rounding theta moves the phase by up to
     * 2 pi * 6283 * 2^-33 rad: 0.31 LSB more. */
    if ((stated > 0.501L) || (paper > 0.82L)) {
        printf("x %ld y %ld: %f and %f LSB\n", (long)x, (long)y, (double)stated, (double)paper);
        TEST_FAIL_MESSAGE("perturbation beyond its stated error");
    }
}

static int32_t any_coordinate(void) {
    return rng_between(&rng, -ONE_Q26, ONE_Q26);
}

static void random_points_follow_the_formula(void) {
    worst_stated = 0.0L;
    worst_paper = 0.0L;
    for (int i = 0; i < RANDOM_TRIALS; i++) {
        /* Half of them near the origin, at every scale. */
        const uint32_t shift = ((i % 2) == 0) ? 0U : rng_below(&rng, 27U);
        const int32_t x = any_coordinate() / ((int32_t)1 << shift);
        const int32_t y = any_coordinate() / ((int32_t)1 << shift);
        if ((x != 0) || (y != 0)) {
            check_point(x, y);
        }
    }
    printf("perturb: worst %.4f LSB with theta as stated (0.501), %.4f LSB against the plain "
           "formula (0.82)\n",
           (double)worst_stated, (double)worst_paper);
}

static void edges_follow_the_formula(void) {
    static const int32_t EDGES[] = {0, 1, 2, ONE_Q26, ONE_Q26 - 1, ONE_Q26 / 2, AMPLITUDE_LSB};
    for (size_t i = 0; i < sizeof(EDGES) / sizeof(EDGES[0]); i++) {
        for (size_t j = 0; j < sizeof(EDGES) / sizeof(EDGES[0]); j++) {
            if ((i != 0U) || (j != 0U)) {
                check_point(EDGES[i], EDGES[j]);
                check_point(-EDGES[i], EDGES[j]);
                check_point(EDGES[i], -EDGES[j]);
                check_point(-EDGES[i], -EDGES[j]);
            }
        }
    }
}

static void the_origin_stays(void) {
    int32_t x = 0;
    int32_t y = 0;
    ocel_perturb_point(&x, &y);
    TEST_ASSERT_EQUAL_INT32(0, x);
    TEST_ASSERT_EQUAL_INT32(0, y);
}

/* theta = 0, phase = 0: nothing moves, at any radius. */
static void the_positive_x_axis_stays(void) {
    for (int i = 0; i < TEST_TRIALS(10000); i++) {
        const int32_t start = 1 + (int32_t)rng_below(&rng, (uint32_t)ONE_Q26);
        int32_t x = start;
        int32_t y = 0;
        ocel_perturb_point(&x, &y);
        TEST_ASSERT_EQUAL_INT32(start, x);
        TEST_ASSERT_EQUAL_INT32(0, y);
    }
}

static void points_stay_in_the_stated_range(void) {
    int32_t furthest = 0;
    for (int32_t i = 0; i < 200000; i += TEST_STEP) { /* along two sides of the unit square */
        int32_t x = ONE_Q26;
        int32_t y = -ONE_Q26 + (i * 671);
        int32_t u = -y;
        int32_t v = -x;
        ocel_perturb_point(&x, &y);
        ocel_perturb_point(&u, &v);
        furthest = (x > furthest) ? x : furthest;
        furthest = (-v > furthest) ? -v : furthest;
    }
    TEST_ASSERT_TRUE(furthest <= ONE_Q26 + AMPLITUDE_LSB);
    TEST_ASSERT_TRUE(furthest > ONE_Q26 + (AMPLITUDE_LSB / 2)); /* and they do move */
}

/* "Maintaining the ellipse average": displacements of many points cancel, and
 * their mean square is that of a sine, A^2 / 2. */
static void displacements_average_out(void) {
    enum { COUNT = TEST_TRIALS_AT_LEAST(1000, 100000) };
    double sum = 0.0;
    double squares = 0.0;
    for (int i = 0; i < COUNT; i++) {
        const double angle = rng_uniform(&rng, 0.0, 6.283185307179586);
        const int32_t x = (int32_t)(60000000.0 * cos(angle));
        const int32_t y = (int32_t)(40000000.0 * sin(angle));
        int32_t px = x;
        int32_t py = y;
        ocel_perturb_point(&px, &py);
        const double moved = hypot(px, py) - hypot(x, y);
        sum += moved;
        squares += moved * moved;
    }
    const double amplitude = 67108.864;
    const double mean = sum / COUNT / amplitude;
    const double power = squares / COUNT / (amplitude * amplitude);
    printf("perturb: mean %.5f A, mean square %.5f A^2\n", mean, power);
    TEST_ASSERT_TRUE(fabs(mean) < 4.0 * sqrt(0.5 / COUNT));
    TEST_ASSERT_TRUE(fabs(power - 0.5) < 4.0 * sqrt(0.125 / COUNT));
}

int main(void) {
    printf("seed %d\n", SEED);
    UNITY_BEGIN();
    RUN_TEST(random_points_follow_the_formula);
    RUN_TEST(edges_follow_the_formula);
    RUN_TEST(the_origin_stays);
    RUN_TEST(the_positive_x_axis_stays);
    RUN_TEST(points_stay_in_the_stated_range);
    RUN_TEST(displacements_average_out);
    return UNITY_END();
}
