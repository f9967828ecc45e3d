/* SPDX-License-Identifier: MIT
 *
 * The winner's boundary: crack for crack, in order, what a walk around the
 * finished mask gives; and that walk is the set of outer cracks by definition.
 * test_boundary_tiny.c runs the same with the smallest pool, which overflows all
 * the time.
 */
#include "label_check.h"

enum { SEED = 20030207, MASKS = TEST_TRIALS_AT_LEAST(80, 4000), TINY = OCEL_MAX_CRACKS < 1024 };

static mask_t mask;
static rng_t rng;

void setUp(void) {
    rng = rng_seed(SEED);
    snprintf(where, sizeof(where), "seed %d", SEED);
}

void tearDown(void) {
}

static int at_most(int value, int limit) {
    return (value < limit) ? value : limit;
}

static void check_both(const char *name, bool may_overflow) {
    for (int connectivity = 4; connectivity <= 8; connectivity += 4) {
        snprintf(where, sizeof(where), "%s, %d x %d, %d-connected", name, mask.width, mask.height,
                 connectivity);
        (void)check_boundary(&mask, connectivity, may_overflow);
    }
}

/* ---- Against the twin ---- */

static void test_all_masks_of_four_by_four(void) {
    for (unsigned bits = 0U; bits < 65536U; bits += TEST_STEP) {
        mask_clear(&mask, 4, 4);
        for (int i = 0; i < 16; i++) {
            mask.pixel[i] = (uint8_t)((bits >> i) & 1U);
        }
        snprintf(where, sizeof(where), "bits %04x", bits);
        (void)check_boundary(&mask, 4, false);
        (void)check_boundary(&mask, 8, false);
    }
}

static void test_random_masks(void) {
    for (int i = 0; i < MASKS; i++) {
        const int width = rng_between(&rng, 1, 66);
        const int height = rng_between(&rng, 1, 64);

        mask_random(&mask, at_most(width, OCEL_MAX_WIDTH), at_most(height, OCEL_MAX_HEIGHT),
                    rng_uniform(&rng, 0.02, 0.98), &rng);
        check_both("random", TINY);
    }
}

static void test_random_discs(void) {
    for (int i = 0; i < MASKS / 8; i++) {
        mask_random_discs(&mask, rng_between(&rng, 1, at_most(200, OCEL_MAX_WIDTH)),
                          rng_between(&rng, 1, at_most(150, OCEL_MAX_HEIGHT)),
                          rng_between(&rng, 1, 24), &rng);
        check_both("discs", TINY);
    }
}

static void test_disc_with_holes_in_noise(void) {
    for (int i = 0; i < MASKS / 80; i++) {
        const int side = at_most(100, at_most(OCEL_MAX_WIDTH, OCEL_MAX_HEIGHT));

        mask_random(&mask, side, side, 0.05, &rng);
        mask_disc(&mask, 0.5 * side, 0.45 * side, 0.4 * side, true);
        for (int hole = 0; hole < 150; hole++) {
            mask_set(&mask, rng_between(&rng, 0, side), rng_between(&rng, 0, side), false);
        }
        mask_disc(&mask, 0.5 * side, 0.4 * side, 0.2 * side, false);
        mask_disc(&mask, 0.5 * side, 0.4 * side, 0.1 * side, true);
        check_both("disc with holes and an island", TINY);
    }
}

static void test_shapes(void) {
    for (int gap = 1; gap <= 3; gap++) {
        for (int side = 1; side <= at_most(60, at_most(OCEL_MAX_WIDTH, OCEL_MAX_HEIGHT)); side++) {
            mask_spiral(&mask, side, side, gap);
            check_both("spiral", TINY);
            mask_rings(&mask, side, side, gap, false);
            check_both("rings", TINY);
            mask_rings(&mask, side, side, gap, true);
            check_both("U shapes", TINY);
        }
    }
    for (int height = 1; height <= 9; height++) {
        mask_comb(&mask, 64, height, 0);
        check_both("comb, bar on top", TINY);
        mask_comb(&mask, 64, height, height - 1);
        check_both("comb, bar below", TINY);
        mask_comb(&mask, 64, height, height / 2);
        check_both("comb, bar amid", TINY);
    }
}

static void test_largest_frames(void) {
    mask_checkerboard(&mask, OCEL_MAX_WIDTH, OCEL_MAX_HEIGHT);
    check_both("checkerboard", TINY);
    mask_clear(&mask, OCEL_MAX_WIDTH, OCEL_MAX_HEIGHT);
    mask_box(&mask, 0, 0, OCEL_MAX_WIDTH, OCEL_MAX_HEIGHT, true);
    check_both("full", TINY);
    mask_clear(&mask, OCEL_MAX_WIDTH, OCEL_MAX_HEIGHT);
    mask_disc(&mask, 0.5 * OCEL_MAX_WIDTH, 0.5 * OCEL_MAX_HEIGHT, 0.5 * OCEL_MAX_HEIGHT, true);
    check_both("disc", TINY);
    mask_random(&mask, OCEL_MAX_WIDTH, OCEL_MAX_HEIGHT, 0.5, &rng);
    check_both("random", true);
}

/* Two pixels that meet at a corner: one walk for 8, the later one of the two
 * alone for 4 (the first in raster order). */
static void test_corner_contact(void) {
    const ocel_crack_t *cracks = NULL;
    size_t count = 0U;
    size_t stride = 0U;

    mask_clear(&mask, 4, 4);
    mask_set(&mask, 1, 1, true);
    mask_set(&mask, 2, 2, true);
    (void)label_mask(&mask, 8, false, NULL);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_label_boundary(&labeller, &pool, &cracks, &count, &stride));
    TEST_ASSERT_EQUAL(8U, count);
    (void)label_mask(&mask, 4, false, NULL);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_label_boundary(&labeller, &pool, &cracks, &count, &stride));
    TEST_ASSERT_EQUAL(4U, count);
    TEST_ASSERT_EQUAL(1U, stride);
    TEST_ASSERT_EQUAL_INT16(1, cracks[0].x_hpx); /* left of pixel (1,1) */
    TEST_ASSERT_EQUAL_INT16(2, cracks[0].y_hpx);
    TEST_ASSERT_EQUAL_INT16(2, cracks[1].x_hpx); /* above it */
    TEST_ASSERT_EQUAL_INT16(1, cracks[1].y_hpx);
    TEST_ASSERT_EQUAL_INT16(3, cracks[2].x_hpx);
    TEST_ASSERT_EQUAL_INT16(2, cracks[2].y_hpx);
    TEST_ASSERT_EQUAL_INT16(2, cracks[3].x_hpx);
    TEST_ASSERT_EQUAL_INT16(3, cracks[3].y_hpx);
}

/* ---- More cracks than the pool holds points ---- */

/* check_boundary checks the rule of label.h everywhere; here, that it comes to
 * more than one, and that the pool is then put to use. */
static void test_every_stride_th(void) {
    const ocel_crack_t *cracks = NULL;
    size_t count = 0U;
    size_t stride = 0U;
    const int tallest = at_most(OCEL_MAX_HEIGHT, OCEL_MAX_CRACKS / 4);

    for (int height = 1; height <= tallest;
         height = (height < tallest / 2) ? 2 * height : height + tallest / 2) {
        /* Rows joined alternately at the right and at the left: a snake. */
        mask_clear(&mask, OCEL_MAX_WIDTH, tallest);
        for (int y = 0; y < height; y++) {
            mask_box(&mask, 0, y, OCEL_MAX_WIDTH, 1, (y % 2) == 0);
            if ((y % 2) == 1) {
                mask_set(&mask, ((y % 4) == 1) ? 0 : OCEL_MAX_WIDTH - 1, y, true);
            }
        }
        check_both("snake", false);
    }
    (void)label_mask(&mask, 8, false, NULL);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_label_boundary(&labeller, &pool, &cracks, &count, &stride));
    TEST_ASSERT_GREATER_THAN(1U, stride);
    TEST_ASSERT_GREATER_THAN(at_most(OCEL_MAX_CRACKS, OCEL_MAX_FIT_POINTS) / 4, count);
}

/* ---- The pool runs out ---- */

/* As many cells as the pool has: a bar of OCEL_MAX_CRACKS / 2 rows takes them all
 * and leaves no room for a point; one row less leaves room for two. */
static void test_the_last_cells(void) {
    const int rows = OCEL_MAX_CRACKS / 2;

    if (rows <= OCEL_MAX_HEIGHT) {
        mask_clear(&mask, 5, rows);
        mask_box(&mask, 1, 0, 3, rows, true);
        TEST_ASSERT_EQUAL(OCEL_OVERFLOW, check_boundary(&mask, 8, true));
        mask_clear(&mask, 5, rows - 1);
        mask_box(&mask, 1, 0, 3, rows - 1, true);
        TEST_ASSERT_EQUAL(OCEL_OK, check_boundary(&mask, 8, false));
        mask_clear(&mask, 5, rows + 1);
        mask_box(&mask, 1, 0, 3, rows + 1, true);
        TEST_ASSERT_EQUAL(OCEL_OVERFLOW, check_boundary(&mask, 8, true));
    }
}

/* A comb's teeth take the pool; the disc beside begins when that has given it
 * back, and its boundary is as good as any. */
static void test_others_go_on(void) {
    const int height = at_most(OCEL_MAX_HEIGHT, 64);
    int overflows = 0;

    for (int teeth = 2; teeth < OCEL_MAX_WIDTH / 2; teeth += 3) {
        mask_clear(&mask, OCEL_MAX_WIDTH, height);
        for (int i = 0; i < teeth; i++) {
            mask_box(&mask, 2 * i, 0, 1, 20, true);
        }
        mask_box(&mask, 0, 20, 2 * teeth - 1, 1, true);
        mask_box(&mask, 1, 24, 10, 10, true);
        overflows += (check_boundary(&mask, 8, true) == OCEL_OVERFLOW) ? 1 : 0;
        mask_box(&mask, 0, 0, OCEL_MAX_WIDTH, 1, false);
        mask_box(&mask, 0, 20, OCEL_MAX_WIDTH, 1, false);
        /* Now the teeth are components of their own and the box is the largest:
         * whatever became of them, its own rows are below all of theirs. */
        TEST_ASSERT_EQUAL_MESSAGE(OCEL_OK, check_boundary(&mask, 8, false), where);
    }
    TEST_ASSERT_TRUE((overflows > 0) || (OCEL_MAX_WIDTH * 20 < OCEL_MAX_CRACKS));
}

/* A comb that is lost gives its cells back while it is still there: the box that
 * begins some rows later has all it needs. */
static void test_what_is_lost_holds_nothing(void) {
    const int rows = OCEL_MAX_CRACKS / 4;

    if (rows + 8 <= OCEL_MAX_HEIGHT) {
        const int teeth = OCEL_MAX_WIDTH / 4;

        mask_clear(&mask, OCEL_MAX_WIDTH, rows + 8);
        mask_box(&mask, 0, 0, 2 * teeth, 1, true);
        for (int i = 0; i < teeth; i++) {
            mask_box(&mask, 2 * i, 0, 1, rows + 8, true);
        }
        mask_box(&mask, 2 * teeth + 2, 7, OCEL_MAX_WIDTH - 2 * teeth - 3, rows, true);
        TEST_ASSERT_EQUAL(OCEL_OK, check_boundary(&mask, 8, false));
        TEST_ASSERT_EQUAL(2 * teeth + 2, twin.blob[twin.best].box.left);
    }
}

/* ---- Order and hostile input ---- */

static void test_order(void) {
    const ocel_crack_t *cracks = NULL;
    size_t count = 99U;

    memset(&labeller, 0, sizeof(labeller));
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_label_boundary(&labeller, &pool, &cracks, &count, NULL));
    TEST_ASSERT_EQUAL(0U, count);
    mask_clear(&mask, 8, 8);
    mask_box(&mask, 2, 2, 3, 3, true);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_label_begin(&labeller, &pool, 8, 8, OCEL_CONNECT_8));
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_label_boundary(&labeller, &pool, &cracks, &count, NULL));
    (void)label_mask(&mask, 8, false, NULL);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_label_boundary(&labeller, &pool, &cracks, &count, NULL));
    TEST_ASSERT_EQUAL(12U, count);
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_label_boundary(&labeller, &pool, &cracks, &count, NULL));
}

static void test_null_arguments(void) {
    const ocel_crack_t *cracks = NULL;
    size_t count = 99U;
    size_t stride = 99U;

    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT,
                      ocel_label_boundary(NULL, &pool, &cracks, &count, &stride));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT,
                      ocel_label_boundary(&labeller, NULL, &cracks, &count, &stride));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT,
                      ocel_label_boundary(&labeller, &pool, NULL, &count, &stride));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT,
                      ocel_label_boundary(&labeller, &pool, &cracks, NULL, &stride));
}

int main(void) {
    UNITY_BEGIN();
    RUN_TEST(test_all_masks_of_four_by_four);
    RUN_TEST(test_random_masks);
    RUN_TEST(test_random_discs);
    RUN_TEST(test_disc_with_holes_in_noise);
    RUN_TEST(test_shapes);
    RUN_TEST(test_largest_frames);
    RUN_TEST(test_corner_contact);
    RUN_TEST(test_every_stride_th);
    RUN_TEST(test_the_last_cells);
    RUN_TEST(test_others_go_on);
    RUN_TEST(test_what_is_lost_holds_nothing);
    RUN_TEST(test_order);
    RUN_TEST(test_null_arguments);
    return UNITY_END();
}
