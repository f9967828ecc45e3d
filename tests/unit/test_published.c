/* SPDX-License-Identifier: MIT
 *
 * Cases that other libraries' own tests publish, and the degenerate points on
 * which they give random answers.  OCEL_GOLDEN_DIR is tests/golden.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fit_support.h"
#include "unity.h"

enum { MAX_POINTS = 1024, REPEATS = 5 };

void setUp(void) {
}

void tearDown(void) {
}

static const ocel_fit_method_t METHODS[] = {OCEL_FIT_B2AC, OCEL_FIT_LCSE, OCEL_FIT_HYPER};

static ocel_status_t fit(ocel_fit_method_t method, const ocel_point_t *points, size_t count,
                         ocel_ellipse_t *ellipse) {
    const ocel_fit_options_t options = fit_options(method, OCEL_PERTURB_AUTO);
    return ocel_fit_points(points, count, &options, ellipse);
}

/* ---- OpenCV's fitEllipseDirect ---- */

static FILE *open_golden(const char *name) {
    char path[1024];
    (void)snprintf(path, sizeof(path), "%s/%s", OCEL_GOLDEN_DIR, name);
    FILE *file = fopen(path, "r");
    TEST_ASSERT_NOT_NULL_MESSAGE(file, path);
    return file;
}

static size_t read_points(const char *name, ocel_point_t *points) {
    FILE *file = open_golden(name);
    size_t count = 0;
    double x = 0.0;
    double y = 0.0;
    while ((count < MAX_POINTS) && (fscanf(file, "%lf,%lf", &x, &y) == 2)) {
        points[count].x_px_q16 = fit_to_q16(x);
        points[count].y_px_q16 = fit_to_q16(y);
        count++;
    }
    TEST_ASSERT_TRUE_MESSAGE(feof(file), "not every line is x,y");
    (void)fclose(file);
    return count;
}

/* The five numbers after "name" in the JSON of expected answers. */
static void read_expected(const char *name, double value[5]) {
    static char text[4096];
    FILE *file = open_golden("opencv_direct_expected.json");
    const size_t length = fread(text, 1, sizeof(text) - 1U, file);
    (void)fclose(file);
    text[length] = '\0';
    const char *at = strstr(text, name);
    TEST_ASSERT_NOT_NULL(at);
    at = strchr(at, '[');
    TEST_ASSERT_NOT_NULL(at);
    for (int i = 0; i < 5; i++) {
        char *end = NULL;
        value[i] = strtod(at + 1, &end);
        TEST_ASSERT_TRUE(end != at + 1);
        at = strpbrk(end, ",]");
        TEST_ASSERT_NOT_NULL(at);
    }
}

static void corners(double cx, double cy, double half_u, double half_v, double angle,
                    ref_point_t corner[4]) {
    static const double sign[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (int i = 0; i < 4; i++) {
        const double u = sign[i][0] * half_u;
        const double v = sign[i][1] * half_v;
        corner[i].x = cx + u * cos(angle) - v * sin(angle);
        corner[i].y = cy + u * sin(angle) + v * cos(angle);
    }
}

/* OpenCV's measure: over the expected corners, the distance to the nearest one. */
static double corner_error(const double expected[5], const ocel_ellipse_t *ellipse) {
    ref_point_t want[4];
    ref_point_t got[4];
    const ref_ellipse_t e = fit_to_double(ellipse);
    corners(expected[0], expected[1], expected[2] / 2.0, expected[3] / 2.0,
            expected[4] * FIT_PI / 180.0, want);
    corners(e.cx, e.cy, e.a, e.b, e.angle, got);
    double sum = 0.0;
    for (int i = 0; i < 4; i++) {
        double nearest = INFINITY;
        for (int j = 0; j < 4; j++) {
            nearest = fmin(nearest, hypot(want[i].x - got[j].x, want[i].y - got[j].y));
        }
        sum += nearest;
    }
    return sum;
}

static void check_opencv_direct(int number, size_t points_in_file) {
    static ocel_point_t points[MAX_POINTS];
    char name[32];
    char file[40];
    double expected[5];
    ocel_ellipse_t ellipse;
    (void)snprintf(name, sizeof(name), "opencv_direct_%d", number);
    (void)snprintf(file, sizeof(file), "%s.csv", name);
    const size_t count = read_points(file, points);
    read_expected(name, expected);
    TEST_ASSERT_EQUAL_size_t(points_in_file, count);
    TEST_ASSERT_EQUAL(OCEL_OK, fit(OCEL_FIT_B2AC, points, count, &ellipse));
    const double error = corner_error(expected, &ellipse);
    printf("%s: corner error %.5f px\n", name, error);
    TEST_ASSERT_TRUE(error < 0.01);
    /* Noisy points are a stable case: LCSE leaves them alone. */
    TEST_ASSERT_EQUAL(OCEL_OK, fit(OCEL_FIT_LCSE, points, count, &ellipse));
    TEST_ASSERT_FALSE(ellipse.perturbed);
    TEST_ASSERT_TRUE(corner_error(expected, &ellipse) < 0.01);
}

static void test_opencv_direct_1(void) {
    check_opencv_direct(1, 40);
}

static void test_opencv_direct_2(void) {
    check_opencv_direct(2, 10);
}

static void test_opencv_direct_3(void) {
    check_opencv_direct(3, 20);
}

/* OpenCV asks 2 px of the centre here. */
static void test_near_circle(void) {
    static const size_t counts[] = {200, 360, 1000};
    static ocel_point_t points[MAX_POINTS];
    const ref_ellipse_t truth = {27.0, 27.0, 17.0, 16.5, 0.0};
    for (size_t c = 0; c < 3U; c++) {
        for (size_t i = 0; i < counts[c]; i++) {
            const ref_point_t p =
                ref_ellipse_point(&truth, 2.0 * FIT_PI * (double)i / (double)counts[c]);
            points[i].x_px_q16 = fit_to_q16(p.x);
            points[i].y_px_q16 = fit_to_q16(p.y);
        }
        for (size_t m = 0; m < 3U; m++) {
            ocel_ellipse_t ellipse;
            TEST_ASSERT_EQUAL(OCEL_OK, fit(METHODS[m], points, counts[c], &ellipse));
            const ref_ellipse_t e = fit_to_double(&ellipse);
            TEST_ASSERT_TRUE(fit_centre_distance(&e, &truth) < 0.01);
            TEST_ASSERT_TRUE(fit_axes_distance(&e, &truth) < 0.01);
            TEST_ASSERT_EQUAL_UINT32(counts[c], ellipse.point_count);
        }
    }
}

/* OpenCV's "Java case": four corners of a square and its centre. */
static void test_square_and_its_centre(void) {
    const int32_t one = 65536;
    const ocel_point_t points[5] = {{0, 0}, {one, one}, {-one, one}, {-one, -one}, {one, -one}};
    ocel_ellipse_t ellipse;
    const ocel_status_t status = fit(OCEL_FIT_B2AC, points, 5, &ellipse);
    TEST_ASSERT_TRUE(fit_has_ellipse(status));
    const ref_ellipse_t e = fit_to_double(&ellipse);
    printf("square: status %s, centre (%.5f, %.5f), axes %.4f %.4f\n", ocel_status_name(status),
           e.cx, e.cy, 2.0 * e.a, 2.0 * e.b);
    TEST_ASSERT_TRUE(hypot(e.cx, e.cy) < 0.01);
    TEST_ASSERT_TRUE(fabs(2.0 * e.a - 2.0 * sqrt(2.0)) < 0.4);
    TEST_ASSERT_TRUE(fabs(2.0 * e.b - 2.0 * sqrt(2.0)) < 0.4);
}

/* ---- Degenerate points: a status, the same every time ---- */

/* Calls every method several times over an output full of rubbish, through both
 * orders of the points; every answer must be one of the two statuses given, carry
 * no ellipse, and be the same each time. */
static void check_refused(const ocel_point_t *points, size_t count, ocel_status_t either,
                          ocel_status_t other) {
    for (size_t m = 0; m < 3U; m++) {
        ocel_ellipse_t first;
        memset(&first, 0xA5, sizeof(first));
        const ocel_status_t status = fit(METHODS[m], points, count, &first);
        TEST_ASSERT_TRUE_MESSAGE((status == either) || (status == other), ocel_status_name(status));
        TEST_ASSERT_TRUE(fit_is_zero(&first));
        for (int repeat = 1; repeat < REPEATS; repeat++) {
            ocel_ellipse_t again;
            memset(&again, repeat * 0x11, sizeof(again));
            TEST_ASSERT_EQUAL(status, fit(METHODS[m], points, count, &again));
            TEST_ASSERT_TRUE(fit_same_bits(&first, &again));
        }
    }
}

static void test_collinear(void) {
    ocel_point_t points[64];
    static const int32_t step[][2] = {{65536, 0},      {0, 65536},  {65536, 65536}, {65536, -32768},
                                      {3 * 65536, 11}, {-7, 65536}, {12345, 54321}};
    for (size_t s = 0; s < sizeof(step) / sizeof(step[0]); s++) {
        for (int32_t i = 0; i < 64; i++) {
            points[i].x_px_q16 = 100 * 65536 + i * step[s][0];
            points[i].y_px_q16 = -50 * 65536 + i * step[s][1];
        }
        check_refused(points, 64, OCEL_DEGENERATE, OCEL_DEGENERATE);
        check_refused(points, 5, OCEL_DEGENERATE, OCEL_DEGENERATE);
    }
}

static void test_all_equal(void) {
    ocel_point_t points[50];
    static const int32_t at[][2] = {
        {0, 0}, {65536, -65536}, {-1, 1}, {16384 * 65536, 16384 * 65536}};
    for (size_t s = 0; s < sizeof(at) / sizeof(at[0]); s++) {
        for (size_t i = 0; i < 50U; i++) {
            points[i].x_px_q16 = at[s][0];
            points[i].y_px_q16 = at[s][1];
        }
        check_refused(points, 50, OCEL_DEGENERATE, OCEL_DEGENERATE);
    }
}

static void test_two_distinct_points(void) {
    ocel_point_t points[20];
    static const int32_t apart[][2] = {{65536, 0}, {0, 1}, {640 * 65536, 480 * 65536}, {-1, 1}};
    for (size_t s = 0; s < sizeof(apart) / sizeof(apart[0]); s++) {
        for (size_t i = 0; i < 20U; i++) {
            points[i].x_px_q16 = ((i % 3U) == 0U) ? apart[s][0] : 0;
            points[i].y_px_q16 = ((i % 3U) == 0U) ? apart[s][1] : 0;
        }
        check_refused(points, 20, OCEL_DEGENERATE, OCEL_DEGENERATE);
    }
}

/* y = x^2 / 10 over -20 .. 20: the best conic is the parabola itself. */
static void test_parabola(void) {
    ocel_point_t points[41];
    for (int32_t i = 0; i < 41; i++) {
        const double x = i - 20;
        points[i].x_px_q16 = fit_to_q16(x);
        points[i].y_px_q16 = fit_to_q16(x * x / 10.0);
    }
    check_refused(points, 41, OCEL_NOT_AN_ELLIPSE, OCEL_NOT_AN_ELLIPSE);
}

/* OpenCV's issue 10270: four of five points on a line, so every pair of that line
 * and another through the fifth point fits. */
static void test_four_of_five_on_a_line(void) {
    const int32_t one = 65536;
    const ocel_point_t points[5] = {
        {0, one}, {0, 2 * one}, {0, 3 * one}, {2 * one, 3 * one}, {0, 4 * one}};
    check_refused(points, 5, OCEL_DEGENERATE, OCEL_NOT_AN_ELLIPSE);
}

int main(void) {
    UNITY_BEGIN();
    RUN_TEST(test_opencv_direct_1);
    RUN_TEST(test_opencv_direct_2);
    RUN_TEST(test_opencv_direct_3);
    RUN_TEST(test_near_circle);
    RUN_TEST(test_square_and_its_centre);
    RUN_TEST(test_collinear);
    RUN_TEST(test_all_equal);
    RUN_TEST(test_two_distinct_points);
    RUN_TEST(test_parabola);
    RUN_TEST(test_four_of_five_on_a_line);
    return UNITY_END();
}
