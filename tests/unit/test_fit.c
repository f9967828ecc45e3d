/* SPDX-License-Identifier: MIT
 *
 * The fits through their two functions: every status, hostile input, what must
 * not change the answer, and agreement with the long double reference.
 */
#include <stdio.h>
#include <string.h>

#include "board.h"
#include "fit_support.h"
#include "rng.h"
#include "unity.h"

enum { SEED = 20110308, MAX_POINTS = 600, METHODS = 3, ONE_PX = 65536 };

static const ocel_fit_method_t METHOD[METHODS] = {OCEL_FIT_B2AC, OCEL_FIT_LCSE, OCEL_FIT_HYPER};

static ref_point_t truth_points[MAX_POINTS];
static ref_point_t moved_points[MAX_POINTS];
static ocel_point_t points[MAX_POINTS];
static ocel_point_t other[MAX_POINTS];
static ocel_crack_t cracks[MAX_POINTS];
static rng_t rng;

void setUp(void) {
    rng = rng_seed(SEED);
}

void tearDown(void) {
}

static ocel_fit_options_t with(ocel_fit_method_t method) {
    return fit_options(method, OCEL_PERTURB_AUTO);
}

/* Points on an ellipse's arc, with noise, rounded to the input format. */
static void draw_arc(const ref_ellipse_t *ellipse, double first_deg, double arc_deg, size_t count,
                     double sigma) {
    const double steps = (arc_deg < 360.0) ? (double)(count - 1U) : (double)count;
    for (size_t i = 0; i < count; i++) {
        const double t = (first_deg + arc_deg * (double)i / steps) * FIT_PI / 180.0;
        truth_points[i] = ref_ellipse_point(ellipse, t);
        if (sigma > 0.0) {
            truth_points[i].x += sigma * rng_gauss(&rng);
            truth_points[i].y += sigma * rng_gauss(&rng);
        }
    }
    fit_round_points(truth_points, points, count);
}

/* An arc of random place and length; drawn in this order whatever the compiler. */
static void draw_random_arc(const ref_ellipse_t *ellipse, double least_deg, double most_deg,
                            size_t count, double sigma) {
    const double first = rng_uniform(&rng, 0.0, 360.0);
    draw_arc(ellipse, first, rng_uniform(&rng, least_deg, most_deg), count, sigma);
}

static ref_ellipse_t random_ellipse(double least, double most) {
    const double p = rng_log_uniform(&rng, least, most);
    const double q = rng_log_uniform(&rng, least, most);
    ref_ellipse_t e;
    e.a = fmax(p, q);
    e.b = fmin(p, q);
    e.cx = rng_uniform(&rng, 0.0, 639.0);
    e.cy = rng_uniform(&rng, 0.0, 479.0);
    e.angle = rng_uniform(&rng, 0.0, FIT_PI);
    return e;
}

/* The crack midpoints of a disc, in raster order. */
static size_t draw_disc_cracks(double cx, double cy, double radius) {
    size_t count = 0;
    for (int y = (int)(cy - radius) - 2; y <= (int)(cy + radius) + 2; y++) {
        for (int x = (int)(cx - radius) - 2; x <= (int)(cx + radius) + 2; x++) {
            const double r2 = radius * radius;
            const double dy2 = (y - cy) * (y - cy);
            const double dx2 = (x - cx) * (x - cx);
            const bool here = dx2 + dy2 <= r2;
            const bool right = (x + 1 - cx) * (x + 1 - cx) + dy2 <= r2;
            const bool below = dx2 + (y + 1 - cy) * (y + 1 - cy) <= r2;
            if (here != right) {
                cracks[count].x_hpx = (int16_t)(2 * x + 1);
                cracks[count].y_hpx = (int16_t)(2 * y);
                count++;
            }
            if (here != below) {
                cracks[count].x_hpx = (int16_t)(2 * x);
                cracks[count].y_hpx = (int16_t)(2 * y + 1);
                count++;
            }
        }
    }
    return count;
}

/* The same for a random disc; drawn in this order whatever the compiler. */
static size_t draw_random_disc(double least, double most) {
    const double cx = rng_uniform(&rng, 60, 70);
    const double cy = rng_uniform(&rng, 60, 70);
    return draw_disc_cracks(cx, cy, rng_log_uniform(&rng, least, most));
}

static void cracks_to_fixed(size_t count) {
    for (size_t i = 0; i < count; i++) {
        points[i].x_px_q16 = cracks[i].x_hpx * (ONE_PX / 2);
        points[i].y_px_q16 = cracks[i].y_hpx * (ONE_PX / 2);
    }
}

/* ---- Statuses ---- */

/* A refusal: the status, an output that was full of rubbish is zeroed. */
static void check_refused(ocel_status_t expected, const ocel_point_t *p, size_t count,
                          const ocel_fit_options_t *options) {
    ocel_ellipse_t ellipse;
    memset(&ellipse, 0xA5, sizeof(ellipse));
    const ocel_status_t status = ocel_fit_points(p, count, options, &ellipse);
    TEST_ASSERT_EQUAL_STRING(ocel_status_name(expected), ocel_status_name(status));
    TEST_ASSERT_TRUE(fit_is_zero(&ellipse));
}

static void check_cracks_refused(ocel_status_t expected, const ocel_crack_t *c, size_t count,
                                 const ocel_fit_options_t *options) {
    ocel_ellipse_t ellipse;
    memset(&ellipse, 0xA5, sizeof(ellipse));
    const ocel_status_t status = ocel_fit_cracks(c, count, options, &ellipse);
    TEST_ASSERT_EQUAL_STRING(ocel_status_name(expected), ocel_status_name(status));
    TEST_ASSERT_TRUE(fit_is_zero(&ellipse));
}

static void test_null_arguments(void) {
    ocel_ellipse_t ellipse;
    const size_t count = draw_disc_cracks(50.0, 50.0, 20.0);
    cracks_to_fixed(count);
    check_refused(OCEL_NULL_ARGUMENT, NULL, 100, NULL);
    check_cracks_refused(OCEL_NULL_ARGUMENT, NULL, 100, NULL);
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_fit_points(points, count, NULL, NULL));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_fit_cracks(cracks, count, NULL, NULL));
    /* No options: b2ac, auto. */
    ocel_ellipse_t named;
    const ocel_fit_options_t options = with(OCEL_FIT_B2AC);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_points(points, count, NULL, &ellipse));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_points(points, count, &options, &named));
    TEST_ASSERT_TRUE(fit_same_bits(&ellipse, &named));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_cracks(cracks, count, NULL, &ellipse));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_cracks(cracks, count, &options, &named));
    TEST_ASSERT_TRUE(fit_same_bits(&ellipse, &named));
}

static void test_bad_options(void) {
    const size_t count = draw_disc_cracks(50.0, 50.0, 20.0);
    cracks_to_fixed(count);
    static const int wrong[] = {3, 4, 255, 1000, -1};
    for (size_t i = 0; i < sizeof(wrong) / sizeof(wrong[0]); i++) {
        ocel_fit_options_t options = with(OCEL_FIT_LCSE);
        options.method = (ocel_fit_method_t)wrong[i];
        check_refused(OCEL_BAD_OPTION, points, count, &options);
        check_cracks_refused(OCEL_BAD_OPTION, cracks, count, &options);
        options = with(OCEL_FIT_LCSE);
        options.perturb = (ocel_perturb_t)wrong[i];
        check_refused(OCEL_BAD_OPTION, points, count, &options);
        check_cracks_refused(OCEL_BAD_OPTION, cracks, count, &options);
    }
}

static void test_too_few_points(void) {
    const size_t count = draw_disc_cracks(50.0, 50.0, 20.0);
    cracks_to_fixed(count);
    for (size_t few = 0; few < (size_t)OCEL_MIN_FIT_POINTS; few++) {
        check_refused(OCEL_TOO_FEW_POINTS, points, few, NULL);
        check_cracks_refused(OCEL_TOO_FEW_POINTS, cracks, few, NULL);
    }
}

/* Too many is known from the count alone: nothing is read. */
static void test_too_many_points(void) {
    const ocel_point_t one_point = {0, 0};
    const ocel_crack_t one_crack = {0, 0};
    static const size_t counts[] = {(size_t)OCEL_MAX_FIT_POINTS + 1U, (size_t)1 << 31, SIZE_MAX};
    for (size_t i = 0; i < 3U; i++) {
        check_refused(OCEL_OVERFLOW, &one_point, counts[i], NULL);
        check_cracks_refused(OCEL_OVERFLOW, &one_crack, counts[i], NULL);
    }
}

static void test_most_points(void) {
    static ocel_point_t many[OCEL_MAX_FIT_POINTS];
    const ref_ellipse_t truth = {0.0, 0.0, 16000.0, 15000.0, 0.5};
    const ref_ellipse_t small = {300.0, 200.0, 80.0, 50.0, 1.0};
    const ref_ellipse_t *const both[2] = {&truth, &small};
    for (size_t k = 0; k < 2U; k++) {
        for (size_t i = 0; i < (size_t)OCEL_MAX_FIT_POINTS; i++) {
            const ref_point_t p =
                ref_ellipse_point(both[k], 2.0 * FIT_PI * (double)i / OCEL_MAX_FIT_POINTS);
            many[i].x_px_q16 = fit_to_q16(p.x);
            many[i].y_px_q16 = fit_to_q16(p.y);
        }
        for (size_t m = 0; m < METHODS; m++) {
            const ocel_fit_options_t options = fit_options(METHOD[m], OCEL_PERTURB_NEVER);
            ocel_ellipse_t ellipse;
            TEST_ASSERT_EQUAL(OCEL_OK,
                              ocel_fit_points(many, OCEL_MAX_FIT_POINTS, &options, &ellipse));
            const ref_ellipse_t e = fit_to_double(&ellipse);
            TEST_ASSERT_TRUE(fit_centre_distance(&e, both[k]) < 1e-4);
            TEST_ASSERT_TRUE(fit_axes_distance(&e, both[k]) < 1e-4);
        }
    }
}

static void test_coordinates_out_of_range(void) {
    static const int32_t beyond[] = {OCEL_MAX_COORDINATE_PX * ONE_PX + 1, INT32_MAX,
                                     -OCEL_MAX_COORDINATE_PX * ONE_PX - 1, INT32_MIN};
    const ref_ellipse_t truth = {100.0, 100.0, 50.0, 40.0, 0.3};
    for (size_t m = 0; m < METHODS; m++) {
        const ocel_fit_options_t options = with(METHOD[m]);
        for (size_t i = 0; i < 4U; i++) {
            for (size_t at = 0; at < 20U; at += 19U) {
                draw_arc(&truth, 0.0, 360.0, 20, 0.0);
                points[at].x_px_q16 = beyond[i];
                check_refused(OCEL_OUT_OF_RANGE, points, 20, &options);
                draw_arc(&truth, 0.0, 360.0, 20, 0.0);
                points[at].y_px_q16 = beyond[i];
                check_refused(OCEL_OUT_OF_RANGE, points, 20, &options);
            }
        }
    }
}

/* The last coordinates allowed, in each corner of the plane. */
static void test_coordinates_at_the_limit(void) {
    const double middle = OCEL_MAX_COORDINATE_PX - 384.0;
    for (int corner = 0; corner < 4; corner++) {
        const ref_ellipse_t truth = {((corner & 1) != 0) ? middle : -middle,
                                     ((corner & 2) != 0) ? middle : -middle, 384.0, 384.0, 0.0};
        draw_arc(&truth, 0.0, 360.0, 16, 0.0);
        for (size_t m = 0; m < METHODS; m++) {
            const ocel_fit_options_t options = fit_options(METHOD[m], OCEL_PERTURB_NEVER);
            ocel_ellipse_t ellipse;
            TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_points(points, 16, &options, &ellipse));
            const ref_ellipse_t e = fit_to_double(&ellipse);
            TEST_ASSERT_TRUE(fit_centre_distance(&e, &truth) < 1e-4);
            TEST_ASSERT_TRUE(fit_axes_distance(&e, &truth) < 1e-4);
        }
    }
}

/* A shallow arc of a circle so large that its centre has no int32 in Q16. */
static void test_result_out_of_range(void) {
    const ref_ellipse_t truth = {0.0, -45000.0, 50000.0, 50000.0, 0.0};
    draw_arc(&truth, 75.0, 30.0, 200, 0.0);
    for (size_t i = 0; i < 200U; i++) {
        TEST_ASSERT_TRUE(fabs(truth_points[i].x) < OCEL_MAX_COORDINATE_PX);
        TEST_ASSERT_TRUE(fabs(truth_points[i].y) < OCEL_MAX_COORDINATE_PX);
    }
    check_refused(OCEL_OUT_OF_RANGE, points, 200, NULL);
}

/* A hyperbola's branch.  (B2AC, bound to ellipses, has one for it all the same.) */
static void test_not_an_ellipse(void) {
    for (size_t i = 0; i < 101U; i++) {
        const double x = ((double)i - 50.0) / 2.0;
        truth_points[i].x = x;
        truth_points[i].y = sqrt(100.0 + 4.0 * x * x);
    }
    fit_round_points(truth_points, points, 101);
    const ocel_fit_options_t hyper = with(OCEL_FIT_HYPER);
    check_refused(OCEL_NOT_AN_ELLIPSE, points, 101, &hyper);
}

static void test_degenerate_cracks(void) {
    for (int32_t i = 0; i < 40; i++) {
        cracks[i].x_hpx = (int16_t)(2 * i);
        cracks[i].y_hpx = (int16_t)(i + 7);
    }
    for (size_t m = 0; m < METHODS; m++) {
        const ocel_fit_options_t options = with(METHOD[m]);
        check_cracks_refused(OCEL_DEGENERATE, cracks, 40, &options);
        for (size_t i = 1; i < 40U; i++) {
            cracks[i] = cracks[0];
        }
        check_cracks_refused(OCEL_DEGENERATE, cracks, 40, &options);
        for (int32_t i = 0; i < 40; i++) {
            cracks[i].x_hpx = (int16_t)(2 * i);
            cracks[i].y_hpx = (int16_t)(i + 7);
        }
    }
}

/* Two parallel lines, level, steep or tilted: the limit of ellipses, but none.  (On
 * the exact path, whose frame is not sheared, tilted ones may end as an estimate:
 * there the cubic has a double root, which Newton approaches slowly.) */
static void test_parallel_lines(void) {
    static const int16_t step[][2] = {{2, 0}, {0, 2}, {2, 2}, {2, -2}, {6, 2}, {-2, 14}};
    for (size_t k = 0; k < sizeof(step) / sizeof(step[0]); k++) {
        for (int16_t i = 0; i < 20; i++) {
            cracks[2 * i].x_hpx = (int16_t)(200 + i * step[k][0]);
            cracks[2 * i].y_hpx = (int16_t)(301 + i * step[k][1]);
            cracks[2 * i + 1].x_hpx = (int16_t)(200 + i * step[k][0] - step[k][1] / 2);
            cracks[2 * i + 1].y_hpx = (int16_t)(301 + i * step[k][1] + step[k][0] / 2);
        }
        cracks_to_fixed(40);
        for (size_t m = 0; m < METHODS; m++) {
            const ocel_fit_options_t options = with(METHOD[m]);
            ocel_ellipse_t ellipse;
            TEST_ASSERT_NOT_EQUAL(OCEL_OK, ocel_fit_cracks(cracks, 40, &options, &ellipse));
            const ocel_status_t status = ocel_fit_points(points, 40, &options, &ellipse);
            TEST_ASSERT_TRUE_MESSAGE((status == OCEL_DEGENERATE) || (status == OCEL_NOT_AN_ELLIPSE),
                                     ocel_status_name(status));
            TEST_ASSERT_TRUE(fit_is_zero(&ellipse));
        }
    }
}

static uint32_t centres_apart(const ocel_ellipse_t *p, const ocel_ellipse_t *q) {
    return (uint32_t)hypot((double)p->cx_px_q16 - q->cx_px_q16,
                           (double)p->cy_px_q16 - q->cy_px_q16);
}

/* The rule of fit.h, from the two opinions: an arc under 27/32 of the turn is
 * vouched for when B2AC and hyper agree on the centre within 10 % of hyper's
 * semi-minor axis, and under 11/32 hyper's sigma is within 5 % of it. */
static ocel_status_t status_by_the_rule(const ocel_ellipse_t *e, size_t count) {
    const ocel_fit_options_t options =
        with((e->method == OCEL_FIT_HYPER) ? OCEL_FIT_B2AC : OCEL_FIT_HYPER);
    ocel_ellipse_t second;
    if (e->arc_coverage_q16 >= 27U * 2048U) {
        return OCEL_OK;
    }
    if (!fit_has_ellipse(ocel_fit_points(points, count, &options, &second))) {
        return OCEL_PARTIAL;
    }
    const ocel_ellipse_t *unbiased = (e->method == OCEL_FIT_HYPER) ? e : &second;
    const uint32_t b = (uint32_t)unbiased->b_px_q16;
    const bool known =
        (unbiased->arc_coverage_q16 >= 11U * 2048U) || (unbiased->centre_sigma_px_q16 <= b / 20U);
    return (known && (centres_apart(e, &second) <= 2U * (b / 20U))) ? OCEL_OK : OCEL_PARTIAL;
}

/* Too short an arc for its noise: an estimate, not vouched for, that says how
 * uncertain it is.  What is vouched for is hardly ever far off. */
static void test_partial(void) {
    static const double arcs[] = {60.0, 75.0, 90.0, 105.0, 135.0, 150.0, 180.0};
    const ref_ellipse_t truth = {160.0, 120.0, 40.0, 40.0, 0.0};
    enum { TRIALS = TEST_TRIALS_AT_LEAST(20, 300) };
    for (size_t k = 0; k < sizeof(arcs) / sizeof(arcs[0]); k++) {
        int vouched[METHODS] = {0, 0, 0};
        int wrong[METHODS] = {0, 0, 0};
        const size_t count = (size_t)(arcs[k] * 0.7);
        for (int trial = 0; trial < TRIALS; trial++) {
            draw_arc(&truth, rng_uniform(&rng, 0, 360), arcs[k], count, 0.3);
            for (size_t m = 0; m < METHODS; m++) {
                const ocel_fit_options_t options = with(METHOD[m]);
                ocel_ellipse_t ellipse;
                const ocel_status_t status = ocel_fit_points(points, count, &options, &ellipse);
                if (fit_has_ellipse(status)) {
                    TEST_ASSERT_EQUAL(status_by_the_rule(&ellipse, count), status);
                }
                if (status == OCEL_OK) {
                    const ref_ellipse_t e = fit_to_double(&ellipse);
                    vouched[m]++;
                    wrong[m] += (fit_centre_distance(&e, &truth) > 0.15 * truth.a) ? 1 : 0;
                }
            }
        }
        printf("arc %.0f deg, R = 40, sigma = .3: vouched for b2ac %d, hyper %d of %d; centre off "
               "by over .15 R: %d, %d\n",
               arcs[k], vouched[0], vouched[2], TRIALS, wrong[0], wrong[2]);
        for (size_t m = 0; m < METHODS; m++) {
            TEST_ASSERT_TRUE(wrong[m] <= TRIALS / 50);
            TEST_ASSERT_TRUE((arcs[k] < 110.0) || (arcs[k] > 140.0) || (vouched[m] > 0));
            TEST_ASSERT_TRUE((arcs[k] > 110.0) || (vouched[m] <= TRIALS / 50));
            TEST_ASSERT_TRUE((arcs[k] < 180.0) || (vouched[m] == TRIALS));
        }
    }
}

/* The rule where both opinions agree and both may be off: few points, little noise. */
static void test_short_arcs_of_few_points(void) {
    const ref_ellipse_t truth = {160.0, 120.0, 40.0, 40.0, 0.0};
    int told[2] = {0, 0};
    const int trials = TEST_TRIALS_AT_LEAST(30, 300);
    for (int trial = 0; trial < trials; trial++) {
        const double first = rng_uniform(&rng, 0, 360);
        draw_arc(&truth, first, 90.0, 9, rng_log_uniform(&rng, 0.005, 0.1));
        for (size_t m = 0; m < METHODS; m++) {
            const ocel_fit_options_t options = with(METHOD[m]);
            ocel_ellipse_t ellipse;
            const ocel_status_t status = ocel_fit_points(points, 9, &options, &ellipse);
            if (fit_has_ellipse(status)) {
                TEST_ASSERT_EQUAL(status_by_the_rule(&ellipse, 9), status);
                told[(status == OCEL_OK) ? 0 : 1]++;
            }
        }
    }
    TEST_ASSERT_TRUE((told[0] > trials / 3) && (told[1] > trials / 3));
}

/* Exact points are vouched for whatever their arc. */
static void test_exact_short_arcs_are_vouched_for(void) {
    for (int trial = 0; trial < TEST_TRIALS(200); trial++) {
        const ref_ellipse_t truth = random_ellipse(10.0, 200.0);
        draw_random_arc(&truth, 45.0, 90.0, 60, 0.0);
        for (size_t m = 0; m < METHODS; m++) {
            const ocel_fit_options_t options = fit_options(METHOD[m], OCEL_PERTURB_NEVER);
            ocel_ellipse_t ellipse;
            TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_points(points, 60, &options, &ellipse));
            TEST_ASSERT_EQUAL(OCEL_OK, status_by_the_rule(&ellipse, 60));
        }
    }
}

/* `closed` is the caller's word for a whole boundary. */
static void test_closed(void) {
    const size_t count = draw_disc_cracks(70.2, 70.6, 40.0);
    for (size_t m = 0; m < METHODS; m++) {
        ocel_fit_options_t options = with(METHOD[m]);
        ocel_ellipse_t measured;
        ocel_ellipse_t closed;
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_cracks(cracks, count, &options, &measured));
        options.closed = true;
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_cracks(cracks, count, &options, &closed));
        TEST_ASSERT_EQUAL_UINT32(65536, measured.arc_coverage_q16);
        TEST_ASSERT_TRUE(fit_same_bits(&measured, &closed));
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_cracks(cracks, count / 2U, &options, &closed));
        TEST_ASSERT_EQUAL_UINT32(65536, closed.arc_coverage_q16);
    }
}

/* ---- The eye's own fit ---- */

static void test_boundary_statuses(void) {
    ocel_ellipse_t ellipse;
    static const ocel_crack_t line[6] = {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {8, 9}, {10, 11}};
    static const ocel_crack_t far[6] = {{0, 1},       {32767, 0},   {32766, 32767},
                                        {-1, -32768}, {9000, 9001}, {-20000, 13}};
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_fit_boundary(NULL, 100, true, &ellipse));
    TEST_ASSERT_TRUE(fit_is_zero(&ellipse));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_fit_boundary(line, 6, true, NULL));
    for (size_t few = 0; few < (size_t)OCEL_MIN_FIT_POINTS; few++) {
        memset(&ellipse, 0xA5, sizeof(ellipse));
        TEST_ASSERT_EQUAL(OCEL_TOO_FEW_POINTS, ocel_fit_boundary(line, few, false, &ellipse));
        TEST_ASSERT_TRUE(fit_is_zero(&ellipse));
    }
    memset(&ellipse, 0xA5, sizeof(ellipse));
    TEST_ASSERT_EQUAL(OCEL_OVERFLOW,
                      ocel_fit_boundary(line, (size_t)OCEL_MAX_FIT_POINTS + 1U, true, &ellipse));
    TEST_ASSERT_TRUE(fit_is_zero(&ellipse));
    TEST_ASSERT_EQUAL(OCEL_OVERFLOW, ocel_fit_boundary(line, SIZE_MAX, true, &ellipse));
    memset(&ellipse, 0xA5, sizeof(ellipse));
    TEST_ASSERT_EQUAL(OCEL_DEGENERATE, ocel_fit_boundary(line, 6, true, &ellipse));
    TEST_ASSERT_TRUE(fit_is_zero(&ellipse));
    memset(&ellipse, 0xA5, sizeof(ellipse));
    TEST_ASSERT_EQUAL(OCEL_OVERFLOW, ocel_fit_boundary(far, 6, true, &ellipse));
    TEST_ASSERT_TRUE(fit_is_zero(&ellipse));
}

/* The bits of ocel_fit_cracks with b2ac, closed or not; but a short arc gets no
 * second opinion here, so it is never vouched for. */
static void test_boundary_equals_cracks(void) {
    for (int trial = 0; trial < TEST_TRIALS(200); trial++) {
        const size_t count = draw_random_disc(2, 60);
        const size_t used = (trial % 2 == 0) ? count : count / 2U + 3U;
        for (int closed = 0; closed < 2; closed++) {
            ocel_fit_options_t options = with(OCEL_FIT_B2AC);
            ocel_ellipse_t one;
            ocel_ellipse_t two;
            options.closed = closed != 0;
            const ocel_status_t status = ocel_fit_cracks(cracks, used, &options, &one);
            const bool arc = one.arc_coverage_q16 < 27U * 2048U;
            TEST_ASSERT_EQUAL(((status == OCEL_OK) && arc) ? OCEL_PARTIAL : status,
                              ocel_fit_boundary(cracks, used, closed != 0, &two));
            TEST_ASSERT_TRUE(fit_same_bits(&one, &two));
        }
    }
}

/* Boundaries of ellipses of every shape and tilt, thin ones too, against the
 * reference on the same cracks. */
static void test_boundary_of_thin_ellipses(void) {
    static ocel_crack_t boundary[4096];
    static ref_point_t same[4096];
    double worst = 0.0;
    int tried = 0;
    for (int trial = 0; trial < TEST_TRIALS(400); trial++) {
        const double a = rng_log_uniform(&rng, 10.0, 150.0);
        const double b = rng_log_uniform(&rng, 1.5, a);
        const double angle = rng_uniform(&rng, 0.0, FIT_PI);
        const double cx = 160.0 + rng_unit(&rng);
        const double cy = 160.0 + rng_unit(&rng);
        const double c = cos(angle);
        const double s = sin(angle);
        const int reach = (int)a + 2;
        size_t count = 0;
        for (int y = 160 - reach; y <= 161 + reach; y++) {
            for (int x = 160 - reach; x <= 161 + reach; x++) {
                bool in[3];
                for (int k = 0; k < 3; k++) {
                    const double dx = x + (k == 1 ? 1 : 0) - cx;
                    const double dy = y + (k == 2 ? 1 : 0) - cy;
                    const double u = (dx * c + dy * s) / a;
                    const double v = (dy * c - dx * s) / b;
                    in[k] = u * u + v * v <= 1.0;
                }
                for (int k = 1; k < 3; k++) {
                    if (in[0] != in[k]) {
                        boundary[count].x_hpx = (int16_t)(2 * x + (k == 1 ? 1 : 0));
                        boundary[count].y_hpx = (int16_t)(2 * y + (k == 2 ? 1 : 0));
                        count++;
                    }
                }
            }
        }
        ocel_ellipse_t ellipse;
        ref_ellipse_t want;
        fit_cracks_to_points(boundary, count, same);
        TEST_ASSERT_TRUE(ref_fit(REF_B2AC, same, count, &want));
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_boundary(boundary, count, true, &ellipse));
        const ref_ellipse_t got = fit_to_double(&ellipse);
        worst = fmax(worst, fmax(fit_centre_distance(&want, &got), fit_axes_distance(&want, &got)));
        tried++;
    }
    printf("boundaries of %d ellipses, axes 150:1.5 and rounder: worst error %.1e px\n", tried,
           worst);
    TEST_ASSERT_TRUE(worst < 1e-4);
}

/* ---- What must not change the answer ---- */

static void test_translation_by_whole_pixels(void) {
    static const int32_t shift[][2] = {{1, 0}, {0, -1}, {-640, 480}, {15000, -15000}};
    for (int trial = 0; trial < TEST_TRIALS(60); trial++) {
        const ref_ellipse_t truth = random_ellipse(5.0, 200.0);
        const size_t count = (size_t)rng_between(&rng, 20, 300);
        draw_random_arc(&truth, 100, 360, count, (trial % 2) * 0.3);
        const int32_t *by = shift[trial % 4];
        for (size_t i = 0; i < count; i++) {
            other[i].x_px_q16 = points[i].x_px_q16 + by[0] * ONE_PX;
            other[i].y_px_q16 = points[i].y_px_q16 + by[1] * ONE_PX;
        }
        for (size_t m = 0; m < METHODS; m++) {
            const ocel_fit_options_t options = with(METHOD[m]);
            ocel_ellipse_t here;
            ocel_ellipse_t there;
            const ocel_status_t status = ocel_fit_points(points, count, &options, &here);
            TEST_ASSERT_EQUAL(status, ocel_fit_points(other, count, &options, &there));
            if (fit_has_ellipse(status)) {
                there.cx_px_q16 -= by[0] * ONE_PX;
                there.cy_px_q16 -= by[1] * ONE_PX;
            }
            TEST_ASSERT_TRUE(fit_same_bits(&here, &there));
        }
    }
}

static void test_translated_cracks(void) {
    for (int trial = 0; trial < TEST_TRIALS(40); trial++) {
        const size_t count = draw_random_disc(4, 50);
        const int16_t dx = (int16_t)rng_between(&rng, -10, 3000);
        const int16_t dy = (int16_t)rng_between(&rng, -10, 3000);
        for (size_t m = 0; m < METHODS; m++) {
            const ocel_fit_options_t options = with(METHOD[m]);
            ocel_ellipse_t here;
            ocel_ellipse_t there;
            static ocel_crack_t moved[MAX_POINTS];
            for (size_t i = 0; i < count; i++) {
                moved[i].x_hpx = (int16_t)(cracks[i].x_hpx + 2 * dx);
                moved[i].y_hpx = (int16_t)(cracks[i].y_hpx + 2 * dy);
            }
            TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_cracks(cracks, count, &options, &here));
            TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_cracks(moved, count, &options, &there));
            there.cx_px_q16 -= dx * ONE_PX;
            there.cy_px_q16 -= dy * ONE_PX;
            TEST_ASSERT_TRUE(fit_same_bits(&here, &there));
        }
    }
}

static void test_order_of_points(void) {
    static uint32_t order[MAX_POINTS];
    for (int trial = 0; trial < TEST_TRIALS(60); trial++) {
        const ref_ellipse_t truth = random_ellipse(5.0, 200.0);
        const size_t count = (size_t)rng_between(&rng, 20, 300);
        draw_random_arc(&truth, 100, 360, count, (trial % 2) * 0.3);
        rng_shuffle(&rng, order, (uint32_t)count);
        for (size_t i = 0; i < count; i++) {
            other[i] = points[order[i]];
        }
        for (size_t m = 0; m < METHODS; m++) {
            const ocel_fit_options_t options = with(METHOD[m]);
            ocel_ellipse_t here;
            ocel_ellipse_t there;
            const ocel_status_t status = ocel_fit_points(points, count, &options, &here);
            TEST_ASSERT_EQUAL(status, ocel_fit_points(other, count, &options, &there));
            TEST_ASSERT_TRUE(fit_same_bits(&here, &there));
        }
    }
}

static void test_order_of_cracks(void) {
    static uint32_t order[MAX_POINTS];
    static ocel_crack_t shuffled[MAX_POINTS];
    const size_t count = draw_disc_cracks(70.3, 70.9, 60.0);
    rng_shuffle(&rng, order, (uint32_t)count);
    for (size_t i = 0; i < count; i++) {
        shuffled[i] = cracks[order[i]];
    }
    for (size_t m = 0; m < METHODS; m++) {
        const ocel_fit_options_t options = with(METHOD[m]);
        ocel_ellipse_t here;
        ocel_ellipse_t there;
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_cracks(cracks, count, &options, &here));
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_cracks(shuffled, count, &options, &there));
        TEST_ASSERT_TRUE(fit_same_bits(&here, &there));
    }
}

/* Mirrored and turned by quarters: the same ellipse to a few LSB, since rounding
 * knows up from down. */
static void test_mirrored_and_turned(void) {
    const double few = 4.0 / ONE_PX;
    for (int trial = 0; trial < TEST_TRIALS(100); trial++) {
        const ref_ellipse_t truth = random_ellipse(5.0, 200.0);
        const size_t count = (size_t)rng_between(&rng, 20, 300);
        draw_random_arc(&truth, 180, 360, count, (trial % 2) * 0.3);
        for (int way = 0; way < 3; way++) {
            for (size_t i = 0; i < count; i++) {
                const ocel_point_t p = points[i];
                other[i].x_px_q16 =
                    (way == 0) ? -p.x_px_q16 : ((way == 1) ? p.y_px_q16 : -p.y_px_q16);
                other[i].y_px_q16 = (way == 0) ? p.y_px_q16 : p.x_px_q16;
            }
            for (size_t m = 0; m < METHODS; m++) {
                /* The perturbation of the paper is no symmetric thing. */
                const ocel_fit_options_t options = fit_options(METHOD[m], OCEL_PERTURB_NEVER);
                ocel_ellipse_t here;
                ocel_ellipse_t there;
                TEST_ASSERT_TRUE(fit_has_ellipse(ocel_fit_points(points, count, &options, &here)));
                TEST_ASSERT_TRUE(fit_has_ellipse(ocel_fit_points(other, count, &options, &there)));
                ref_ellipse_t want = fit_to_double(&here);
                const ref_ellipse_t got = fit_to_double(&there);
                const ref_ellipse_t e = want;
                want.cx = (way == 0) ? -e.cx : ((way == 1) ? e.cy : -e.cy);
                want.cy = (way == 0) ? e.cy : e.cx;
                want.angle = (way == 0)
                                 ? FIT_PI - e.angle
                                 : ((way == 1) ? FIT_PI / 2.0 - e.angle : FIT_PI / 2.0 + e.angle);
                TEST_ASSERT_TRUE(fit_centre_distance(&want, &got) < few);
                TEST_ASSERT_TRUE(fit_axes_distance(&want, &got) < few);
                TEST_ASSERT_TRUE(fit_angle_distance(want.angle, got.angle) * (e.a - e.b) <
                                 4.0 * few);
                TEST_ASSERT_INT_WITHIN(2, here.rms_px_q16, there.rms_px_q16);
            }
        }
    }
}

/* Each point twice says nothing new. */
static void test_repeated_points(void) {
    const ref_ellipse_t truth = {100.0, 80.0, 60.0, 35.0, 0.4};
    draw_arc(&truth, 0.0, 250.0, 150, 0.2);
    for (size_t i = 0; i < 150U; i++) {
        other[2U * i] = points[i];
        other[2U * i + 1U] = points[i];
    }
    for (size_t m = 0; m < METHODS; m++) {
        const ocel_fit_options_t options = with(METHOD[m]);
        ocel_ellipse_t once;
        ocel_ellipse_t twice;
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_points(points, 150, &options, &once));
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_points(other, 300, &options, &twice));
        TEST_ASSERT_INT32_WITHIN(1, once.cx_px_q16, twice.cx_px_q16);
        TEST_ASSERT_INT32_WITHIN(1, once.cy_px_q16, twice.cy_px_q16);
        TEST_ASSERT_INT32_WITHIN(1, once.a_px_q16, twice.a_px_q16);
        TEST_ASSERT_INT32_WITHIN(1, once.b_px_q16, twice.b_px_q16);
        TEST_ASSERT_EQUAL_UINT32(300, twice.point_count);
    }
}

/* ---- Agreement ---- */

/* The fast path and the wide one on the same boundary. */
static void test_cracks_against_points(void) {
    for (int trial = 0; trial < TEST_TRIALS(200); trial++) {
        const size_t count = draw_random_disc(3, 60);
        cracks_to_fixed(count);
        /* Whole boundaries, and parts of them. */
        const size_t used = (trial % 2 == 0) ? count : count / 2U + 3U;
        for (size_t m = 0; m < METHODS; m++) {
            const ocel_fit_options_t options = with(METHOD[m]);
            ocel_ellipse_t fast;
            ocel_ellipse_t wide;
            const ocel_status_t status = ocel_fit_cracks(cracks, used, &options, &fast);
            const ocel_status_t other_status = ocel_fit_points(points, used, &options, &wide);
            /* (Vouched for or not may hang on a last digit.) */
            TEST_ASSERT_EQUAL(fit_has_ellipse(status), fit_has_ellipse(other_status));
            if (fit_has_ellipse(status)) {
                const ref_ellipse_t p = fit_to_double(&fast);
                const ref_ellipse_t q = fit_to_double(&wide);
                /* Hyper's inverse iterations start in the frame, and stop: on a few
                 * points the two frames leave different rests. */
                const double allowed = (METHOD[m] == OCEL_FIT_HYPER) ? 5e-3 : 1e-4;
                TEST_ASSERT_TRUE(fit_centre_distance(&p, &q) < allowed);
                TEST_ASSERT_TRUE(fit_axes_distance(&p, &q) < allowed);
                TEST_ASSERT_INT_WITHIN(2, fast.rms_px_q16, wide.rms_px_q16);
                TEST_ASSERT_INT_WITHIN(2048, fast.arc_coverage_q16, wide.arc_coverage_q16);
            }
        }
    }
}

static ref_method_t reference_of(ocel_fit_method_t method) {
    return (method == OCEL_FIT_HYPER) ? REF_TAUBIN_SHIFTED : REF_B2AC;
}

/* Noisy arcs against the reference on the same rounded points. */
static void test_against_the_reference(void) {
    double worst[METHODS] = {0.0, 0.0, 0.0};
    double worst_rms = 0.0;
    for (int trial = 0; trial < TEST_TRIALS(2000); trial++) {
        const ref_ellipse_t truth = random_ellipse(10.0, 200.0);
        const size_t count = (size_t)rng_between(&rng, 20, 300);
        const double sigma = rng_log_uniform(&rng, 1e-3, 0.02 * truth.b);
        draw_random_arc(&truth, 150, 360, count, sigma);
        for (size_t m = 0; m < METHODS; m++) {
            const ocel_fit_options_t options = fit_options(METHOD[m], OCEL_PERTURB_NEVER);
            ocel_ellipse_t ellipse;
            ref_conic_t conic;
            ref_ellipse_t want;
            const ocel_status_t status = ocel_fit_points(points, count, &options, &ellipse);
            const bool known =
                ref_fit_conic(reference_of(METHOD[m]), truth_points, count, &conic) &&
                ref_conic_ellipse(&conic, &want);
            if (fit_has_ellipse(status) && known) {
                const ref_ellipse_t got = fit_to_double(&ellipse);
                const double scale = fmax(1.0, want.a / truth.a); /* shallow fits run away */
                const double off =
                    fmax(fit_centre_distance(&want, &got), fit_axes_distance(&want, &got)) / scale;
                const double rms = ref_rms(&conic, truth_points, count);
                worst[m] = fmax(worst[m], off);
                worst_rms = fmax(worst_rms, fabs(fit_from_q16(ellipse.rms_px_q16) - rms));
                TEST_ASSERT_TRUE(fit_angle_distance(want.angle, got.angle) * (want.a - want.b) <
                                 1e-3 * scale);
            } else {
                TEST_ASSERT_FALSE(status == OCEL_OK);
            }
        }
    }
    printf("worst error against the reference: b2ac %.1e, lcse %.1e, hyper %.1e px; rms %.1e px\n",
           worst[0], worst[1], worst[2], worst_rms);
    TEST_ASSERT_TRUE(worst[0] < 1e-4);
    TEST_ASSERT_TRUE(worst[1] < 1e-4);
    TEST_ASSERT_TRUE(worst[2] < 1e-2); /* the fixed count of inverse iterations */
    TEST_ASSERT_TRUE(worst_rms < 1e-3);
}

/* ---- LCSE ---- */

static void test_lcse_leaves_stable_points_alone(void) {
    for (int trial = 0; trial < TEST_TRIALS(50); trial++) {
        const ref_ellipse_t truth = random_ellipse(10.0, 200.0);
        draw_arc(&truth, 0.0, 300.0, 120, 1e-3 * truth.a);
        static const ocel_perturb_t quiet[2] = {OCEL_PERTURB_AUTO, OCEL_PERTURB_NEVER};
        ocel_ellipse_t b2ac;
        const ocel_status_t status = ocel_fit_points(points, 120, NULL, &b2ac);
        for (size_t k = 0; k < 2U; k++) {
            const ocel_fit_options_t options = fit_options(OCEL_FIT_LCSE, quiet[k]);
            ocel_ellipse_t lcse;
            TEST_ASSERT_EQUAL(status, ocel_fit_points(points, 120, &options, &lcse));
            TEST_ASSERT_FALSE(lcse.perturbed);
            TEST_ASSERT_TRUE(!fit_has_ellipse(status) || (lcse.method == OCEL_FIT_LCSE));
            lcse.method = b2ac.method;
            TEST_ASSERT_TRUE(fit_same_bits(&b2ac, &lcse));
        }
    }
}

/* Exact points are the paper's unstable case; `never` says never. */
static void test_lcse_perturbs_exact_points(void) {
    const ref_ellipse_t truth = {200.0, 150.0, 80.0, 60.0, 0.7};
    draw_arc(&truth, 3.0, 360.0, 200, 0.0);
    ocel_fit_options_t options = fit_options(OCEL_FIT_LCSE, OCEL_PERTURB_AUTO);
    ocel_ellipse_t automatic;
    ocel_ellipse_t always;
    ocel_ellipse_t never;
    ocel_ellipse_t b2ac;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_points(points, 200, &options, &automatic));
    options.perturb = OCEL_PERTURB_ALWAYS;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_points(points, 200, &options, &always));
    options.perturb = OCEL_PERTURB_NEVER;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_points(points, 200, &options, &never));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_points(points, 200, NULL, &b2ac));
    TEST_ASSERT_TRUE(automatic.perturbed);
    TEST_ASSERT_TRUE(fit_same_bits(&automatic, &always));
    TEST_ASSERT_FALSE(never.perturbed);
    TEST_ASSERT_FALSE(b2ac.perturbed);
    never.method = OCEL_FIT_B2AC;
    TEST_ASSERT_TRUE(fit_same_bits(&never, &b2ac));
    TEST_ASSERT_FALSE(fit_same_bits(&never, &always));
    /* Its price on a full ellipse: some hundredths of a pixel at most. */
    const ref_ellipse_t e = fit_to_double(&always);
    TEST_ASSERT_TRUE(fit_centre_distance(&e, &truth) < 0.05);
    TEST_ASSERT_TRUE(fit_axes_distance(&e, &truth) < 0.05);
}

/* Only LCSE reads the perturb option. */
static void test_perturb_is_for_lcse_only(void) {
    const ref_ellipse_t truth = {200.0, 150.0, 80.0, 60.0, 0.7};
    draw_arc(&truth, 3.0, 360.0, 200, 0.0);
    for (size_t m = 0; m < METHODS; m += 2U) {
        ocel_fit_options_t options = with(METHOD[m]);
        ocel_ellipse_t automatic;
        ocel_ellipse_t always;
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_points(points, 200, &options, &automatic));
        options.perturb = OCEL_PERTURB_ALWAYS;
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_points(points, 200, &options, &always));
        TEST_ASSERT_TRUE(fit_same_bits(&automatic, &always));
        TEST_ASSERT_FALSE(always.perturbed);
    }
}

static void test_lcse_against_the_reference(void) {
    double worst = 0.0;
    for (int trial = 0; trial < TEST_TRIALS(300); trial++) {
        const ref_ellipse_t truth = random_ellipse(10.0, 200.0);
        const size_t count = (size_t)rng_between(&rng, 40, 300);
        draw_random_arc(&truth, 200, 360, count, (trial % 2) * 0.1);
        const ocel_fit_options_t options = fit_options(OCEL_FIT_LCSE, OCEL_PERTURB_ALWAYS);
        ocel_ellipse_t ellipse;
        ref_ellipse_t want;
        const ocel_status_t status = ocel_fit_points(points, count, &options, &ellipse);
        ref_lcse_perturb(truth_points, count, moved_points);
        if (fit_has_ellipse(status) && ref_fit(REF_B2AC, moved_points, count, &want)) {
            const ref_ellipse_t got = fit_to_double(&ellipse);
            worst =
                fmax(worst, fmax(fit_centre_distance(&want, &got), fit_axes_distance(&want, &got)));
            TEST_ASSERT_TRUE(ellipse.perturbed);
        } else {
            TEST_ASSERT_FALSE(status == OCEL_OK);
        }
    }
    printf("worst error of the perturbed fit against the reference: %.1e px\n", worst);
    TEST_ASSERT_TRUE(worst < 1e-3);
}

/* Cracks are always a stable case, and may be perturbed all the same. */
static void test_lcse_on_cracks(void) {
    const size_t count = draw_disc_cracks(70.2, 70.6, 40.0);
    ocel_fit_options_t options = fit_options(OCEL_FIT_LCSE, OCEL_PERTURB_AUTO);
    ocel_ellipse_t automatic;
    ocel_ellipse_t always;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_cracks(cracks, count, &options, &automatic));
    TEST_ASSERT_FALSE(automatic.perturbed);
    options.perturb = OCEL_PERTURB_ALWAYS;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_cracks(cracks, count, &options, &always));
    TEST_ASSERT_TRUE(always.perturbed);
    const ref_ellipse_t p = fit_to_double(&automatic);
    const ref_ellipse_t q = fit_to_double(&always);
    TEST_ASSERT_TRUE(fit_centre_distance(&p, &q) < 0.05);
}

/* ---- Hyper, and what an answer says of itself ---- */

/* Algebraic fits overrate the radius of a small noisy circle; hyper does not. */
static void test_hyper_has_no_radius_bias(void) {
    const ref_ellipse_t truth = {50.0, 50.0, 5.0, 5.0, 0.0};
    double bias[METHODS] = {0.0, 0.0, 0.0};
    enum { TRIALS = TEST_TRIALS_AT_LEAST(200, 2000) };
    for (int trial = 0; trial < TRIALS; trial++) {
        draw_arc(&truth, 0.0, 360.0, 100, 0.3);
        for (size_t m = 0; m < METHODS; m++) {
            const ocel_fit_options_t options = with(METHOD[m]);
            ocel_ellipse_t ellipse;
            TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_points(points, 100, &options, &ellipse));
            const ref_ellipse_t e = fit_to_double(&ellipse);
            bias[m] += (sqrt(e.a * e.b) - 5.0) / TRIALS;
        }
    }
    printf("radius bias, R = 5, sigma = .3: b2ac %+.4f, hyper %+.4f px\n", bias[0], bias[2]);
    TEST_ASSERT_TRUE(bias[0] > 0.012); /* .018 */
    TEST_ASSERT_TRUE(fabs(bias[2]) < 0.004);
}

static void test_arc_coverage(void) {
    const ref_ellipse_t circle = {100.0, 100.0, 50.0, 50.0, 0.0};
    for (int k = 4; k <= 32; k++) {
        draw_arc(&circle, 11.0 * k, 360.0 * k / 32.0, 300, 0.0);
        for (size_t m = 0; m < METHODS; m++) {
            const ocel_fit_options_t options = with(METHOD[m]);
            ocel_ellipse_t ellipse;
            TEST_ASSERT_TRUE(fit_has_ellipse(ocel_fit_points(points, 300, &options, &ellipse)));
            TEST_ASSERT_DOUBLE_WITHIN(1.5 / 32.0, k / 32.0, ellipse.arc_coverage_q16 / 65536.0);
            TEST_ASSERT_TRUE(ellipse.arc_coverage_q16 <= 65536U);
        }
    }
    /* Few points leave gaps that count as covered, and a gap that does not. */
    for (int k = 14; k <= 26; k++) {
        /* (The gap must be longer than one between points may be.) */
        for (size_t count = 66U / (32U - (size_t)k - 2U) + 3U; count <= 24U; count++) {
            ocel_ellipse_t ellipse;
            draw_arc(&circle, 7.0 * k + (double)count, 360.0 * k / 32.0, count, 0.0);
            TEST_ASSERT_TRUE(fit_has_ellipse(ocel_fit_points(points, count, NULL, &ellipse)));
            TEST_ASSERT_DOUBLE_WITHIN(1.5 / 32.0, k / 32.0, ellipse.arc_coverage_q16 / 65536.0);
        }
    }
    /* The whole turn is the whole turn, few points or many, and an ellipse's too. */
    for (size_t count = 20; count <= 600U; count += 29U) {
        const ref_ellipse_t flat = {100.0, 100.0, 80.0, 10.0, 0.3};
        ocel_ellipse_t ellipse;
        draw_arc(&circle, 5.0, 360.0, count, 0.0);
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_points(points, count, NULL, &ellipse));
        TEST_ASSERT_EQUAL_UINT32(65536, ellipse.arc_coverage_q16);
        draw_arc(&flat, 5.0, 360.0, count, 0.0);
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_points(points, count, NULL, &ellipse));
        TEST_ASSERT_EQUAL_UINT32(65536, ellipse.arc_coverage_q16);
    }
}

/* centre_sigma foretells the RMS error of the centre, for the unbiased fit. */
static void test_centre_sigma(void) {
    static const double arcs[] = {130.0, 180.0, 240.0, 360.0};
    const ref_ellipse_t circle = {160.0, 120.0, 50.0, 50.0, 0.0};
    enum { TRIALS = TEST_TRIALS_AT_LEAST(20, 400) };
    for (size_t k = 0; k < 4U; k++) {
        double squares = 0.0;
        double foretold = 0.0;
        for (int trial = 0; trial < TRIALS; trial++) {
            const ocel_fit_options_t options = with(OCEL_FIT_HYPER);
            ocel_ellipse_t ellipse;
            draw_arc(&circle, rng_uniform(&rng, 0, 360), arcs[k], 150, 0.2);
            TEST_ASSERT_TRUE(fit_has_ellipse(ocel_fit_points(points, 150, &options, &ellipse)));
            const ref_ellipse_t e = fit_to_double(&ellipse);
            squares += pow(fit_centre_distance(&e, &circle), 2.0) / TRIALS;
            foretold += fit_from_q16(ellipse.centre_sigma_px_q16) / TRIALS;
        }
        printf("arc %.0f deg: centre RMS %.3f px, foretold %.3f px\n", arcs[k], sqrt(squares),
               foretold);
        TEST_ASSERT_TRUE(foretold > 0.6 * sqrt(squares));
        TEST_ASSERT_TRUE(foretold < 1.6 * sqrt(squares));
    }
}

/* ---- Hostile points ---- */

/* An answer keeps its promises, whatever the points. */
static void check_promises(ocel_status_t status, const ocel_ellipse_t *e, size_t count,
                           ocel_fit_method_t method) {
    if (fit_has_ellipse(status)) {
        TEST_ASSERT_TRUE(e->b_px_q16 > 0);
        TEST_ASSERT_TRUE(e->a_px_q16 >= e->b_px_q16);
        TEST_ASSERT_TRUE(e->angle_turn_q32 < 0x80000000U);
        TEST_ASSERT_TRUE(e->arc_coverage_q16 <= 65536U);
        TEST_ASSERT_EQUAL_UINT32(count, e->point_count);
        TEST_ASSERT_EQUAL(method, e->method);
    } else {
        TEST_ASSERT_TRUE((status == OCEL_DEGENERATE) || (status == OCEL_NOT_AN_ELLIPSE) ||
                         (status == OCEL_OUT_OF_RANGE));
        TEST_ASSERT_TRUE(fit_is_zero(e));
    }
}

static int32_t hostile_coordinate(int kind) {
    static const int32_t edges[] = {-1073741824, -1073741823, -1, 0, 1, 1073741823, 1073741824};
    int32_t magnitude = 0;
    switch (kind) {
    case 0: /* anywhere allowed */
        return rng_between(&rng, -1073741824, 1073741824);
    case 1: /* the edges of the range */
        return edges[rng_below(&rng, 7)];
    case 2: /* a few LSB */
        return rng_between(&rng, -3, 3);
    case 3: /* a small grid, far away */
        return 1073741824 - 4 + rng_between(&rng, 0, 4);
    case 4: /* whole pixels */
        return rng_between(&rng, -4, 4) * ONE_PX;
    default: /* all sizes */
        magnitude = (int32_t)(1U << rng_below(&rng, 31));
        return rng_between(&rng, -1, 1) * magnitude;
    }
}

static void test_hostile_points(void) {
    for (int trial = 0; trial < TEST_TRIALS(30000); trial++) {
        const size_t count = (size_t)rng_between(&rng, 5, 12);
        const int kind_x = (int)rng_below(&rng, 6);
        const int kind_y = (rng_below(&rng, 2) == 0U) ? kind_x : (int)rng_below(&rng, 6);
        for (size_t i = 0; i < count; i++) {
            points[i].x_px_q16 = hostile_coordinate(kind_x);
            points[i].y_px_q16 = hostile_coordinate(kind_y);
        }
        for (int o = 0; o < 9; o++) {
            const ocel_fit_options_t options = fit_options(METHOD[o % 3], (ocel_perturb_t)(o / 3));
            ocel_ellipse_t ellipse;
            memset(&ellipse, 0xA5, sizeof(ellipse));
            const ocel_status_t status = ocel_fit_points(points, count, &options, &ellipse);
            check_promises(status, &ellipse, count, options.method);
        }
    }
}

static void test_hostile_cracks(void) {
    for (int trial = 0; trial < TEST_TRIALS(20000); trial++) {
        const size_t count = (size_t)rng_between(&rng, 5, 12);
        const int32_t reach = (trial % 3 == 0) ? 32767 : ((trial % 3 == 1) ? 8192 : 5);
        for (size_t i = 0; i < count; i++) {
            cracks[i].x_hpx = (int16_t)rng_between(&rng, (reach < 32767) ? -1 : -32768, reach);
            cracks[i].y_hpx = (int16_t)rng_between(&rng, (reach < 32767) ? -1 : -32768, reach);
        }
        for (int o = 0; o < 9; o++) {
            const ocel_fit_options_t options = fit_options(METHOD[o % 3], (ocel_perturb_t)(o / 3));
            ocel_ellipse_t ellipse;
            memset(&ellipse, 0xA5, sizeof(ellipse));
            const ocel_status_t status = ocel_fit_cracks(cracks, count, &options, &ellipse);
            check_promises(status, &ellipse, count, options.method);
        }
    }
}

/* As many cracks as there may be, as far apart as int16 goes: the sums' limits. */
static void test_most_cracks_at_the_corners(void) {
    static ocel_crack_t many[OCEL_MAX_FIT_POINTS];
    static const int16_t corner[5][2] = {
        {-32768, -32768}, {32767, -32768}, {32767, 32767}, {-32768, 32767}, {32767, 0}};
    static const int16_t image[5][2] = {{-1, 0}, {8191, 0}, {8190, 8191}, {0, 8191}, {8191, 4096}};
    for (int k = 0; k < 2; k++) {
        for (size_t i = 0; i < (size_t)OCEL_MAX_FIT_POINTS; i++) {
            many[i].x_hpx = (k == 0) ? image[i % 5U][0] : corner[i % 5U][0];
            many[i].y_hpx = (k == 0) ? image[i % 5U][1] : corner[i % 5U][1];
        }
        for (size_t m = 0; m < METHODS; m++) {
            const ocel_fit_options_t options = with(METHOD[m]);
            ocel_ellipse_t ellipse;
            const ocel_status_t status =
                ocel_fit_cracks(many, OCEL_MAX_FIT_POINTS, &options, &ellipse);
            check_promises(status, &ellipse, OCEL_MAX_FIT_POINTS, METHOD[m]);
        }
    }
}

/* Nothing is written beside the result, and the points are left alone. */
static void test_writes_only_the_result(void) {
    struct {
        uint8_t before[64];
        ocel_ellipse_t ellipse;
        uint8_t after[64];
    } guarded;
    memset(&guarded, 0x5A, sizeof(guarded));
    const size_t count = draw_disc_cracks(70.2, 70.6, 40.0);
    cracks_to_fixed(count);
    memcpy(other, points, sizeof(points));
    for (int o = 0; o < 9; o++) {
        const ocel_fit_options_t options = fit_options(METHOD[o % 3], (ocel_perturb_t)(o / 3));
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_points(points, count, &options, &guarded.ellipse));
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_cracks(cracks, count, &options, &guarded.ellipse));
    }
    TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, guarded.before, 64);
    TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, guarded.after, 64);
    TEST_ASSERT_EQUAL_MEMORY(other, points, sizeof(points));
}

int main(void) {
    printf("seed %d\n", SEED);
    UNITY_BEGIN();
    RUN_TEST(test_null_arguments);
    RUN_TEST(test_bad_options);
    RUN_TEST(test_too_few_points);
    RUN_TEST(test_too_many_points);
    RUN_TEST(test_most_points);
    RUN_TEST(test_coordinates_out_of_range);
    RUN_TEST(test_coordinates_at_the_limit);
    RUN_TEST(test_result_out_of_range);
    RUN_TEST(test_not_an_ellipse);
    RUN_TEST(test_degenerate_cracks);
    RUN_TEST(test_parallel_lines);
    RUN_TEST(test_partial);
    RUN_TEST(test_short_arcs_of_few_points);
    RUN_TEST(test_exact_short_arcs_are_vouched_for);
    RUN_TEST(test_closed);
    RUN_TEST(test_boundary_statuses);
    RUN_TEST(test_boundary_equals_cracks);
    RUN_TEST(test_boundary_of_thin_ellipses);
    RUN_TEST(test_translation_by_whole_pixels);
    RUN_TEST(test_translated_cracks);
    RUN_TEST(test_order_of_points);
    RUN_TEST(test_order_of_cracks);
    RUN_TEST(test_mirrored_and_turned);
    RUN_TEST(test_repeated_points);
    RUN_TEST(test_cracks_against_points);
    RUN_TEST(test_against_the_reference);
    RUN_TEST(test_lcse_leaves_stable_points_alone);
    RUN_TEST(test_lcse_perturbs_exact_points);
    RUN_TEST(test_perturb_is_for_lcse_only);
    RUN_TEST(test_lcse_against_the_reference);
    RUN_TEST(test_lcse_on_cracks);
    RUN_TEST(test_hyper_has_no_radius_bias);
    RUN_TEST(test_arc_coverage);
    RUN_TEST(test_centre_sigma);
    RUN_TEST(test_hostile_points);
    RUN_TEST(test_hostile_cracks);
    RUN_TEST(test_most_cracks_at_the_corners);
    RUN_TEST(test_writes_only_the_result);
    return UNITY_END();
}
