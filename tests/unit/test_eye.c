/* SPDX-License-Identifier: MIT
 *
 * The eye as its caller meets it: line by line and whole frames give the same
 * bits, each status has its cause, and no mistake outlives the next begin.
 */
#include <math.h>
#include <stdio.h>

#include <ocellus/eye.h>

#include "board.h"
#include "masks.h"
#include "unity.h"

enum { SEED = 20120607, W = 320, H = 240, ON = 200, OFF = 30, ONE_PX = 65536 };

static ocel_eye_t eye;
static ocel_eye_t other;
static ocel_eye_config_t config;
static ocel_colour_t colour;
static ocel_detection_t detection;
static ocel_detection_t expected;
static mask_t mask;
static uint8_t frame[W * H];
static rng_t rng;

void setUp(void) {
    const ocel_colour_range_t bright = {OCEL_SPACE_GRAY, {100U, 0U, 0U}, {255U, 0U, 0U}};

    rng = rng_seed(SEED);
    memset(&config, 0, sizeof(config));
    config.width = W;
    config.height = H;
    memset(&eye, 0xA5, sizeof(eye));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_colour_compile(&colour, &bright, OCEL_FORMAT_GRAY8, NULL));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_init(&eye, &config));
    mask_clear(&mask, W, H);
}

void tearDown(void) {
}

static void paint(void) {
    for (int i = 0; i < mask.width * mask.height; i++) {
        frame[i] = (mask.pixel[i] != 0U) ? ON : OFF;
    }
}

/* The frame line by line. */
static ocel_status_t stream(ocel_eye_t *to, ocel_detection_t *result) {
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_begin(to));
    for (int y = 0; y < mask.height; y++) {
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_line(to, &colour, (uint16_t)y, &frame[y * mask.width],
                                                 (size_t)mask.width));
    }
    return ocel_eye_end(to, result);
}

static ocel_status_t detect(void) {
    paint();
    return ocel_eye_frame(&eye, &colour, frame, (size_t)mask.width, &detection);
}

/* Equal member by member; padding may be anything. */
static void assert_same_detection(const ocel_detection_t *a, const ocel_detection_t *b) {
    TEST_ASSERT_EQUAL(a->status, b->status);
    TEST_ASSERT_EQUAL_UINT32(a->blob.area, b->blob.area);
    TEST_ASSERT_EQUAL_MEMORY(&a->blob.box, &b->blob.box, sizeof(a->blob.box));
    TEST_ASSERT_EQUAL_UINT64(a->blob.sum_xx, b->blob.sum_xx);
    TEST_ASSERT_EQUAL_UINT64(a->blob.sum_xy, b->blob.sum_xy);
    TEST_ASSERT_EQUAL(a->has_ellipse, b->has_ellipse);
    TEST_ASSERT_EQUAL_INT32(a->ellipse.cx_px_q16, b->ellipse.cx_px_q16);
    TEST_ASSERT_EQUAL_INT32(a->ellipse.cy_px_q16, b->ellipse.cy_px_q16);
    TEST_ASSERT_EQUAL_INT32(a->ellipse.a_px_q16, b->ellipse.a_px_q16);
    TEST_ASSERT_EQUAL_INT32(a->ellipse.b_px_q16, b->ellipse.b_px_q16);
    TEST_ASSERT_EQUAL_UINT32(a->ellipse.angle_turn_q32, b->ellipse.angle_turn_q32);
    TEST_ASSERT_EQUAL_UINT32(a->ellipse.rms_px_q16, b->ellipse.rms_px_q16);
    TEST_ASSERT_EQUAL_UINT32(a->ellipse.centre_sigma_px_q16, b->ellipse.centre_sigma_px_q16);
    TEST_ASSERT_EQUAL_UINT32(a->ellipse.arc_coverage_q16, b->ellipse.arc_coverage_q16);
    TEST_ASSERT_EQUAL_UINT32(a->boundary_count, b->boundary_count);
    TEST_ASSERT_EQUAL_UINT32(a->boundary_stride, b->boundary_stride);
    TEST_ASSERT_EQUAL_UINT32(a->stats.runs, b->stats.runs);
}

static void assert_disc(double cx, double cy, double radius, double tolerance) {
    TEST_ASSERT_TRUE(detection.has_ellipse);
    TEST_ASSERT_DOUBLE_WITHIN(tolerance, cx, (double)detection.ellipse.cx_px_q16 / ONE_PX);
    TEST_ASSERT_DOUBLE_WITHIN(tolerance, cy, (double)detection.ellipse.cy_px_q16 / ONE_PX);
    TEST_ASSERT_DOUBLE_WITHIN(tolerance, radius, (double)detection.ellipse.a_px_q16 / ONE_PX);
    TEST_ASSERT_DOUBLE_WITHIN(tolerance, radius, (double)detection.ellipse.b_px_q16 / ONE_PX);
}

/* ---- What is seen ---- */

static void test_a_disc_is_seen_where_it_is(void) {
    for (int i = 0; i < TEST_TRIALS(50); i++) {
        const double radius = rng_uniform(&rng, 8.0, 100.0);
        const double cx = rng_uniform(&rng, radius + 1.0, W - radius - 2.0);
        const double cy = rng_uniform(&rng, radius + 1.0, H - radius - 2.0);

        mask_clear(&mask, W, H);
        mask_disc(&mask, cx, cy, radius, true);
        TEST_ASSERT_EQUAL(OCEL_OK, detect());
        TEST_ASSERT_EQUAL(OCEL_OK, detection.status);
        assert_disc(cx, cy, radius, 0.5);
        TEST_ASSERT_EQUAL_UINT32(1U, detection.boundary_stride);
        TEST_ASSERT_EQUAL_UINT32(detection.boundary_count, detection.ellipse.point_count);
        TEST_ASSERT_EQUAL_UINT32(ONE_PX, detection.ellipse.arc_coverage_q16);
    }
}

static void test_the_largest_is_seen_among_noise_and_holes(void) {
    mask_random(&mask, W, H, 0.05, &rng);
    mask_disc(&mask, 100.0, 60.0, 12.0, true);
    mask_disc(&mask, 200.0, 120.0, 40.0, true);
    for (int i = 0; i < 300; i++) {
        mask_set(&mask, rng_between(&rng, 170, 230), rng_between(&rng, 95, 145), false);
    }
    TEST_ASSERT_EQUAL(OCEL_OK, detect());
    assert_disc(200.0, 120.0, 40.0, 1.0);
    TEST_ASSERT_GREATER_THAN(100U, detection.stats.components);
}

static void test_nothing_and_too_little_are_not_seen(void) {
    TEST_ASSERT_EQUAL(OCEL_NOT_SEEN, detect());
    TEST_ASSERT_EQUAL_UINT32(0U, detection.blob.area);
    TEST_ASSERT_FALSE(detection.has_ellipse);
    mask_box(&mask, 10, 10, 5, 3, true); /* 15: the default asks for 16 */
    TEST_ASSERT_EQUAL(OCEL_NOT_SEEN, detect());
    TEST_ASSERT_EQUAL_UINT32(0U, detection.blob.area);
    TEST_ASSERT_EQUAL_UINT32(3U, detection.stats.runs);
    mask_set(&mask, 10, 13, true);
    TEST_ASSERT_NOT_EQUAL(OCEL_NOT_SEEN, detect());
    TEST_ASSERT_EQUAL_UINT32(16U, detection.blob.area);
    config.min_area = 17U;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_init(&eye, &config));
    TEST_ASSERT_EQUAL(OCEL_NOT_SEEN, detect());
    config.min_area = 1U;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_init(&eye, &config));
    mask_clear(&mask, W, H);
    mask_set(&mask, 5, 5, true);
    TEST_ASSERT_NOT_EQUAL(OCEL_NOT_SEEN, detect());
    TEST_ASSERT_EQUAL_UINT32(1U, detection.blob.area);
}

/* The ball cut by each edge and corner: the arc inside still gives the ball. */
static void test_a_clipped_ball(void) {
    static const double centre[6][2] = {{10.0, 120.0},  {310.0, 120.0}, {160.0, 10.0},
                                        {160.0, 230.0}, {12.0, 14.0},   {300.0, 222.0}};

    for (int i = 0; i < 6; i++) {
        size_t count = 0U;
        const ocel_crack_t *cracks;

        mask_clear(&mask, W, H);
        mask_disc(&mask, centre[i][0], centre[i][1], 40.0, true);
        TEST_ASSERT_EQUAL(OCEL_CLIPPED, detect());
        TEST_ASSERT_TRUE(detection.blob.touches_edge);
        assert_disc(centre[i][0], centre[i][1], 40.0, 4.0);
        TEST_ASSERT_LESS_THAN(ONE_PX, detection.ellipse.arc_coverage_q16);
        cracks = ocel_eye_boundary(&eye, &count);
        TEST_ASSERT_EQUAL(detection.boundary_count, count);
        for (size_t k = 0U; k < count; k++) {
            TEST_ASSERT_TRUE((cracks[k].x_hpx >= 0) && (cracks[k].x_hpx < 2 * W - 1));
            TEST_ASSERT_TRUE((cracks[k].y_hpx >= 0) && (cracks[k].y_hpx < 2 * H - 1));
        }
    }
}

static void test_a_covered_camera_is_clipped_and_has_no_ellipse(void) {
    size_t count = 99U;

    mask_box(&mask, 0, 0, W, H, true);
    TEST_ASSERT_EQUAL(OCEL_CLIPPED, detect());
    TEST_ASSERT_EQUAL_UINT32(W * H, detection.blob.area);
    TEST_ASSERT_FALSE(detection.has_ellipse);
    TEST_ASSERT_EQUAL_UINT32(0U, detection.boundary_count);
    TEST_ASSERT_NULL(ocel_eye_boundary(&eye, &count));
    TEST_ASSERT_EQUAL(0U, count);
}

static void test_the_connectivity_is_the_callers(void) {
    /* Two boxes that meet at a corner. */
    mask_box(&mask, 10, 10, 10, 10, true);
    mask_box(&mask, 20, 20, 8, 8, true);
    (void)detect();
    TEST_ASSERT_EQUAL_UINT32(164U, detection.blob.area);
    config.connectivity = OCEL_CONNECT_4;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_init(&eye, &config));
    (void)detect();
    TEST_ASSERT_EQUAL_UINT32(100U, detection.blob.area);
}

static void test_a_comb_overflows_and_its_sums_are_right(void) {
    mask_comb(&mask, W, 101, 100);
    mask.height = H;
    for (int i = 0; i < 101; i++) { /* keep it off the edges */
        mask_set(&mask, 0, i, false);
        mask_set(&mask, W - 1, i, false);
    }
    mask_box(&mask, 0, 0, W, 1, false);
    memset(&mask.pixel[101 * W], 0, (size_t)(H - 101) * W);
    TEST_ASSERT_EQUAL(OCEL_OVERFLOW, detect());
    TEST_ASSERT_FALSE(detection.has_ellipse);
    TEST_ASSERT_EQUAL_UINT32(0U, detection.boundary_count);
    TEST_ASSERT_EQUAL_UINT32(159U * 99U + 318U, detection.blob.area);
    TEST_ASSERT_NULL(ocel_eye_boundary(&eye, NULL));
}

/* A line of pixels has a blob and no ellipse. */
static void test_a_line_of_pixels_has_no_ellipse(void) {
    mask_box(&mask, 20, 20, 200, 1, true);
    TEST_ASSERT_EQUAL_UINT32(0U, detection.ellipse.point_count);
    (void)detect();
    TEST_ASSERT_EQUAL_UINT32(200U, detection.blob.area);
    TEST_ASSERT_EQUAL(detection.has_ellipse,
                      (detection.status == OCEL_OK) || (detection.status == OCEL_PARTIAL));
}

/* ---- Two ways, the same bits ---- */

static void test_streamed_and_whole_frames_agree(void) {
    for (int i = 0; i < TEST_TRIALS(60); i++) {
        const int width = rng_between(&rng, 1, W);
        const int height = rng_between(&rng, 1, H);

        config.width = (uint16_t)width;
        config.height = (uint16_t)height;
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_init(&eye, &config));
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_init(&other, &config));
        if ((i % 2) == 0) {
            mask_random(&mask, width, height, rng_uniform(&rng, 0.1, 0.9), &rng);
        } else {
            mask_random_discs(&mask, width, height, 6, &rng);
        }
        (void)detect();
        (void)stream(&other, &expected);
        assert_same_detection(&expected, &detection);
        /* And once more, in the same context. */
        (void)stream(&eye, &expected);
        assert_same_detection(&expected, &detection);
    }
}

static void test_rows_of_bits_and_lines_agree(void) {
    mask_random(&mask, W, H, 0.03, &rng);
    mask_disc(&mask, 150.0, 100.0, 30.0, true);
    (void)detect();
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_begin(&eye));
    for (int y = 0; y < H; y++) {
        uint32_t row[OCEL_ROW_WORDS];

        mask_row(&mask, y, true, row);
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_row(&eye, (uint16_t)y, row));
    }
    (void)ocel_eye_end(&eye, &expected);
    assert_same_detection(&expected, &detection);
}

static void test_a_stride_longer_than_the_line(void) {
    static uint8_t wide[(W + 13) * H];

    mask_disc(&mask, 150.0, 100.0, 30.0, true);
    (void)detect();
    expected = detection;
    for (int y = 0; y < H; y++) {
        memset(&wide[y * (W + 13)], ON, W + 13);
        memcpy(&wide[y * (W + 13)], &frame[y * W], W);
    }
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_frame(&eye, &colour, wide, W + 13, &detection));
    assert_same_detection(&expected, &detection);
}

static void test_a_copy_goes_on_by_itself(void) {
    mask_disc(&mask, 150.0, 100.0, 30.0, true);
    (void)detect();
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_begin(&eye));
    for (int y = 0; y < H; y++) {
        ocel_eye_t *in_use = ((y / 7) % 2 == 0) ? &eye : &other;

        TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_line(in_use, &colour, (uint16_t)y, &frame[y * W], W));
        if ((y % 7) == 6) { /* moves over to the other one */
            memcpy((in_use == &eye) ? &other : &eye, in_use, sizeof(eye));
            memset(in_use, 0xA5, sizeof(eye));
        }
    }
    (void)ocel_eye_end(((H - 1) / 7 % 2 == 0) ? &eye : &other, &expected);
    assert_same_detection(&expected, &detection);
}

/* ---- The boundary, and other fits of it ---- */

static void test_the_boundary_that_was_fitted(void) {
    ocel_ellipse_t ellipse;
    size_t count = 0U;
    const ocel_crack_t *cracks;

    mask_disc(&mask, 150.0, 100.0, 30.0, true);
    TEST_ASSERT_EQUAL(OCEL_OK, detect());
    cracks = ocel_eye_boundary(&eye, &count);
    TEST_ASSERT_NOT_NULL(cracks);
    TEST_ASSERT_EQUAL(detection.boundary_count, count);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_boundary(cracks, count, true, &ellipse));
    TEST_ASSERT_EQUAL_INT32(detection.ellipse.cx_px_q16, ellipse.cx_px_q16);
    TEST_ASSERT_EQUAL_INT32(detection.ellipse.a_px_q16, ellipse.a_px_q16);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_begin(&eye));
    TEST_ASSERT_NULL(ocel_eye_boundary(&eye, &count));
    TEST_ASSERT_EQUAL(0U, count);
    /* Nor is it there after a frame in which nothing is seen. */
    mask_clear(&mask, W, H);
    TEST_ASSERT_EQUAL(OCEL_NOT_SEEN, detect());
    TEST_ASSERT_NULL(ocel_eye_boundary(&eye, &count));
    TEST_ASSERT_NULL(ocel_eye_boundary(NULL, &count));
    TEST_ASSERT_NULL(ocel_eye_boundary(NULL, NULL));
}

static void test_refit(void) {
    ocel_fit_options_t options = {OCEL_FIT_HYPER, OCEL_PERTURB_AUTO, false};
    ocel_ellipse_t ellipse;
    size_t count = 0U;
    const ocel_crack_t *cracks;

    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_eye_refit(&eye, &options, &detection));
    mask_disc(&mask, 150.0, 100.0, 30.0, true);
    TEST_ASSERT_EQUAL(OCEL_OK, detect());
    expected = detection;
    cracks = ocel_eye_boundary(&eye, &count);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_refit(&eye, &options, &detection));
    options.closed = true;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_fit_cracks(cracks, count, &options, &ellipse));
    TEST_ASSERT_EQUAL_INT32(ellipse.cx_px_q16, detection.ellipse.cx_px_q16);
    TEST_ASSERT_EQUAL_INT32(ellipse.a_px_q16, detection.ellipse.a_px_q16);
    TEST_ASSERT_EQUAL(OCEL_FIT_HYPER, detection.ellipse.method);
    options.method = OCEL_FIT_B2AC;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_refit(&eye, &options, &detection));
    assert_same_detection(&expected, &detection);
    options.method = (ocel_fit_method_t)9;
    TEST_ASSERT_EQUAL(OCEL_BAD_OPTION, ocel_eye_refit(&eye, &options, &detection));
    assert_same_detection(&expected, &detection);
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_eye_refit(NULL, &options, &detection));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_eye_refit(&eye, NULL, &detection));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_eye_refit(&eye, &options, NULL));
    /* Clipped stays clipped. */
    options.method = OCEL_FIT_HYPER;
    mask_clear(&mask, W, H);
    mask_disc(&mask, 10.0, 100.0, 40.0, true);
    TEST_ASSERT_EQUAL(OCEL_CLIPPED, detect());
    TEST_ASSERT_EQUAL(OCEL_CLIPPED, ocel_eye_refit(&eye, &options, &detection));
    TEST_ASSERT_EQUAL(OCEL_CLIPPED, detection.status);
    assert_disc(10.0, 100.0, 40.0, 1.0);
}

/* ---- Order ---- */

static void test_lines_out_of_order(void) {
    mask_disc(&mask, 150.0, 100.0, 30.0, true);
    (void)detect();
    expected = detection;
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_eye_line(&eye, &colour, 0, frame, W)); /* not begun */
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_eye_end(&eye, &detection));
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, detection.status);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_begin(&eye));
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_eye_line(&eye, &colour, 1, frame, W));
    for (int y = 0; y < H; y++) {
        const uint8_t *line = &frame[y * W];
        const uint32_t row[OCEL_ROW_WORDS] = {1U};

        /* Each line is right although the one before, a repeated one and one too
         * far ahead were refused. */
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_line(&eye, &colour, (uint16_t)y, line, W));
        TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_eye_line(&eye, &colour, (uint16_t)y, line, W));
        TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_eye_row(&eye, (uint16_t)(y + 2), row));
    }
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_eye_line(&eye, &colour, H, frame, W));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_end(&eye, &detection));
    assert_same_detection(&expected, &detection);
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_eye_end(&eye, &detection));
}

static void test_missing_lines_give_the_frame_up(void) {
    mask_disc(&mask, 150.0, 100.0, 30.0, true);
    paint();
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_begin(&eye));
    for (int y = 0; y < H - 1; y++) {
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_line(&eye, &colour, (uint16_t)y, &frame[y * W], W));
    }
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_eye_end(&eye, &detection));
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, detection.status);
    TEST_ASSERT_EQUAL_UINT32(0U, detection.blob.area);
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_eye_line(&eye, &colour, H - 1, &frame[(H - 1) * W], W));
    TEST_ASSERT_EQUAL(OCEL_OK, detect());
}

static void test_begin_in_the_middle_of_a_frame(void) {
    mask_random(&mask, W, H, 0.5, &rng);
    paint();
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_begin(&eye));
    for (int y = 0; y < 100; y++) {
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_line(&eye, &colour, (uint16_t)y, &frame[y * W], W));
    }
    mask_clear(&mask, W, H);
    mask_disc(&mask, 150.0, 100.0, 30.0, true);
    TEST_ASSERT_EQUAL(OCEL_OK, detect());
    assert_disc(150.0, 100.0, 30.0, 0.2);
}

/* ---- Hostile input ---- */

static void test_an_eye_that_was_not_initialised(void) {
    memset(&eye, 0, sizeof(eye));
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_eye_begin(&eye));
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_eye_line(&eye, &colour, 0, frame, W));
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_eye_end(&eye, &detection));
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_eye_frame(&eye, &colour, frame, W, &detection));
    TEST_ASSERT_NULL(ocel_eye_boundary(&eye, NULL));
}

static void test_bad_configurations(void) {
    static const uint16_t bad_sides[] = {0U, 0xFFFFU, OCEL_MAX_WIDTH + 1U};
    ocel_eye_config_t bad;

    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_eye_init(NULL, &config));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_eye_init(&eye, NULL));
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_eye_begin(&eye));
    for (int i = 0; i < 3; i++) {
        bad = config;
        bad.width = bad_sides[i];
        TEST_ASSERT_EQUAL(OCEL_BAD_SIZE, ocel_eye_init(&eye, &bad));
        bad = config;
        bad.height = bad_sides[i];
        TEST_ASSERT_EQUAL(OCEL_BAD_SIZE, ocel_eye_init(&eye, &bad));
        TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_eye_begin(&eye));
    }
    bad = config;
    bad.connectivity = (ocel_connectivity_t)5;
    TEST_ASSERT_EQUAL(OCEL_BAD_OPTION, ocel_eye_init(&eye, &bad));
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_eye_begin(&eye));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_init(&eye, &config));
    TEST_ASSERT_EQUAL(OCEL_NOT_SEEN, detect());
}

static void test_null_arguments(void) {
    const uint32_t row[OCEL_ROW_WORDS] = {0U};

    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_eye_begin(NULL));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_begin(&eye));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_eye_line(NULL, &colour, 0, frame, W));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_eye_line(&eye, NULL, 0, frame, W));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_eye_line(&eye, &colour, 0, NULL, W));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_eye_row(NULL, 0, row));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_eye_row(&eye, 0, NULL));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_eye_end(NULL, &detection));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_eye_end(&eye, NULL));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_eye_frame(NULL, &colour, frame, W, &detection));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_eye_frame(&eye, NULL, frame, W, &detection));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_eye_frame(&eye, &colour, NULL, W, &detection));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_eye_frame(&eye, &colour, frame, W, NULL));
}

/* What the colour stage refuses leaves the frame as it was. */
static void test_bad_lines(void) {
    const ocel_colour_range_t any = {OCEL_SPACE_YUV, {0U, 0U, 0U}, {255U, 255U, 255U}};
    ocel_colour_t yuyv;
    ocel_colour_t unmade;

    memset(&unmade, 0, sizeof(unmade));
    (void)ocel_colour_compile(&unmade, &any, (ocel_format_t)77, NULL);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_colour_compile(&yuyv, &any, OCEL_FORMAT_YUYV, NULL));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_begin(&eye));
    TEST_ASSERT_EQUAL(OCEL_BAD_STRIDE, ocel_eye_line(&eye, &colour, 0, frame, W - 1));
    TEST_ASSERT_EQUAL(OCEL_BAD_STRIDE, ocel_eye_line(&eye, &colour, 0, frame, 0));
    TEST_ASSERT_EQUAL(OCEL_BAD_FORMAT, ocel_eye_line(&eye, &unmade, 0, frame, W));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_line(&eye, &colour, 0, frame, W));
    TEST_ASSERT_EQUAL(OCEL_BAD_STRIDE, ocel_eye_frame(&eye, &colour, frame, W - 1, &detection));
    TEST_ASSERT_EQUAL(OCEL_BAD_STRIDE, detection.status);
    config.width = W - 1;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_init(&eye, &config));
    TEST_ASSERT_EQUAL(OCEL_BAD_SIZE, ocel_eye_frame(&eye, &yuyv, frame, 2 * W, &detection));
    TEST_ASSERT_EQUAL(OCEL_BAD_SIZE, detection.status);
}

/* The frame is handed over at its last byte: nothing beyond is read (a sanitized
 * build sees it), and what stands around the context is left alone. */
static void test_nothing_beyond_is_touched(void) {
    static struct {
        uint32_t before[8];
        ocel_eye_t eye;
        uint32_t after[8];
    } guarded;
    static uint8_t exact[33 * 20];

    memset(&guarded, 0x5C, sizeof(guarded));
    memset(exact, ON, sizeof(exact));
    config.width = 33;
    config.height = 20;
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_eye_init(&guarded.eye, &config));
    TEST_ASSERT_EQUAL(OCEL_CLIPPED, ocel_eye_frame(&guarded.eye, &colour, exact, 33, &detection));
    TEST_ASSERT_EQUAL_UINT32(660U, detection.blob.area);
    TEST_ASSERT_EACH_EQUAL_HEX32(0x5C5C5C5CU, guarded.before, 8);
    TEST_ASSERT_EACH_EQUAL_HEX32(0x5C5C5C5CU, guarded.after, 8);
}

/* What the README promises of the contexts at 320x240. */
static void test_sizes(void) {
    TEST_ASSERT_LESS_OR_EQUAL(8192U, sizeof(ocel_eye_t) - sizeof(ocel_crack_pool_t));
    TEST_ASSERT_LESS_OR_EQUAL(8192U, sizeof(ocel_crack_pool_t));
}

/* A straight edge that hides a tenth of a ball's width: the
 * boundary is whole and is no ellipse's, whatever the method.  Noise of half a pixel is
 * no shape. */
static void test_what_is_no_ellipse_is_not_vouched_for(void) {
    const ocel_fit_options_t hyper = {OCEL_FIT_HYPER, OCEL_PERTURB_NEVER, false};

    for (int radius = 20; radius <= 100; radius += 20) {
        mask_clear(&mask, W, H);
        mask_disc(&mask, 150.3, 118.6, radius, true);
        TEST_ASSERT_EQUAL(OCEL_OK, detect());
        mask_box(&mask, 150 + ((radius * 4) / 5), 0, 130, H, false);
        TEST_ASSERT_EQUAL(OCEL_PARTIAL, detect());
        TEST_ASSERT_TRUE(detection.has_ellipse);
        TEST_ASSERT_EQUAL(OCEL_PARTIAL, ocel_eye_refit(&eye, &hyper, &detection));
    }
    mask_clear(&mask, W, H);
    for (int y = 0; y < H; y++) {
        for (int x = 0; x < W; x++) {
            const double noisy = 40.0 + (0.5 * rng_gauss(&rng));

            mask.pixel[(y * W) + x] = (hypot(x - 150.3, y - 118.6) <= noisy) ? 1U : 0U;
        }
    }
    TEST_ASSERT_EQUAL(OCEL_OK, detect());
}

int main(void) {
    UNITY_BEGIN();
    printf("seed %d\n", SEED);
    RUN_TEST(test_a_disc_is_seen_where_it_is);
    RUN_TEST(test_the_largest_is_seen_among_noise_and_holes);
    RUN_TEST(test_nothing_and_too_little_are_not_seen);
    RUN_TEST(test_a_clipped_ball);
    RUN_TEST(test_a_covered_camera_is_clipped_and_has_no_ellipse);
    RUN_TEST(test_the_connectivity_is_the_callers);
    RUN_TEST(test_a_comb_overflows_and_its_sums_are_right);
    RUN_TEST(test_a_line_of_pixels_has_no_ellipse);
    RUN_TEST(test_streamed_and_whole_frames_agree);
    RUN_TEST(test_rows_of_bits_and_lines_agree);
    RUN_TEST(test_a_stride_longer_than_the_line);
    RUN_TEST(test_a_copy_goes_on_by_itself);
    RUN_TEST(test_the_boundary_that_was_fitted);
    RUN_TEST(test_refit);
    RUN_TEST(test_lines_out_of_order);
    RUN_TEST(test_missing_lines_give_the_frame_up);
    RUN_TEST(test_begin_in_the_middle_of_a_frame);
    RUN_TEST(test_an_eye_that_was_not_initialised);
    RUN_TEST(test_bad_configurations);
    RUN_TEST(test_null_arguments);
    RUN_TEST(test_bad_lines);
    RUN_TEST(test_nothing_beyond_is_touched);
    RUN_TEST(test_sizes);
    RUN_TEST(test_what_is_no_ellipse_is_not_vouched_for);
    return UNITY_END();
}
