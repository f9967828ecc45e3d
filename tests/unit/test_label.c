/* SPDX-License-Identifier: MIT
 *
 * Labelling against the twin that fills components on the whole mask: every
 * component of every mask, all sums, the counts, and that nothing that was taken
 * is kept.  test_label_512.c runs the same under larger limits, where the sums
 * are 64 bits wide.
 */
#include <math.h>

#include "label_check.h"

enum { SEED = 19840303, MASKS = TEST_TRIALS_AT_LEAST(40, 6000) };

static mask_t mask;
static rng_t rng;

void setUp(void) {
    rng = rng_seed(SEED);
    snprintf(where, sizeof(where), "seed %d", SEED);
}

void tearDown(void) {
}

static void check_both(const char *name) {
    for (int connectivity = 4; connectivity <= 8; connectivity += 4) {
        snprintf(where, sizeof(where), "%s, %d x %d, %d-connected", name, mask.width, mask.height,
                 connectivity);
        check_labels(&mask, connectivity, connectivity == 8);
    }
}

static int at_most(int value, int limit) {
    return (value < limit) ? value : limit;
}

/* ---- Against the twin ---- */

static void test_all_masks_of_four_by_four(void) {
    for (unsigned bits = 0U; bits < 65536U; bits += TEST_STEP) {
        mask_clear(&mask, 4, 4);
        for (int i = 0; i < 16; i++) {
            mask.pixel[i] = (uint8_t)((bits >> i) & 1U);
        }
        snprintf(where, sizeof(where), "bits %04x", bits);
        check_labels(&mask, 4, false);
        check_labels(&mask, 8, true);
    }
}

static void test_all_masks_of_seven_by_two(void) {
    for (unsigned bits = 0U; bits < 16384U; bits += TEST_STEP) {
        mask_clear(&mask, 7, 2);
        for (int i = 0; i < 14; i++) {
            mask.pixel[i] = (uint8_t)((bits >> i) & 1U);
        }
        snprintf(where, sizeof(where), "bits %04x", bits);
        check_labels(&mask, 4, true);
        check_labels(&mask, 8, false);
    }
}

static void test_random_masks_of_all_densities_and_widths(void) {
    static const int widths[] = {1, 2, 31, 32, 33, 63, 64, 65, 95, 96, 97, 128, 160, 161, 319, 320};
    const int special = (int)(sizeof(widths) / sizeof(widths[0]));

    for (int i = 0; i < MASKS; i++) {
        const int wide = at_most(widths[rng_below(&rng, (uint32_t)special)], OCEL_MAX_WIDTH);
        const int width = ((i % 2) == 0) ? wide : rng_between(&rng, 1, at_most(64, OCEL_MAX_WIDTH));
        const int height = rng_between(&rng, 1, at_most((i % 2 == 0) ? 12 : 64, OCEL_MAX_HEIGHT));
        const double density = rng_uniform(&rng, 0.02, 0.98);

        mask_random(&mask, width, height, density, &rng);
        snprintf(where, sizeof(where), "mask %d of seed %d, density %.3f", i, SEED, density);
        check_labels(&mask, 4, (i % 3) == 0);
        check_labels(&mask, 8, (i % 3) == 1);
    }
}

static void test_random_discs(void) {
    for (int i = 0; i < MASKS / 20; i++) {
        mask_random_discs(&mask, rng_between(&rng, 1, at_most(160, OCEL_MAX_WIDTH)),
                          rng_between(&rng, 1, at_most(120, OCEL_MAX_HEIGHT)),
                          rng_between(&rng, 1, 24), &rng);
        check_both("discs");
    }
}

static void test_shapes_at_full_size(void) {
    const int w = OCEL_MAX_WIDTH;
    const int h = OCEL_MAX_HEIGHT;

    for (int gap = 1; gap <= 3; gap++) {
        mask_spiral(&mask, w, h, gap);
        check_both("spiral");
        mask_rings(&mask, w, h, gap, false);
        check_both("rings");
        mask_rings(&mask, w, h, gap, true);
        check_both("U shapes");
    }
    mask_checkerboard(&mask, w, h);
    check_both("checkerboard");
    mask_comb(&mask, w, h, 0);
    check_both("comb, bar on top");
    mask_comb(&mask, w, h, h - 1);
    check_both("comb, bar below");
    mask_clear(&mask, w, h);
    mask_box(&mask, 0, 0, w, h, true);
    check_both("full");
    mask_random(&mask, w, h, 0.5, &rng);
    check_both("random");
    mask_random(&mask, w, h, 0.4, &rng);
    check_both("random");
}

/* Labels joined in every order: a row of teeth, then bars that join groups of
 * them from row to row, at random. */
static void test_merging_in_every_order(void) {
    for (int i = 0; i < MASKS / 10; i++) {
        const int width = rng_between(&rng, 8, OCEL_MAX_WIDTH);
        const int height = at_most(24, OCEL_MAX_HEIGHT);

        mask_comb(&mask, width, height, height);
        for (int bar = 0; bar < width / 3; bar++) {
            const int y = 2 * rng_between(&rng, 0, height / 2 - 1) + 1;
            const int x = rng_between(&rng, 0, width - 1);
            mask_box(&mask, x, y, rng_between(&rng, 1, 9), 1, true);
        }
        check_both("teeth and bars");
    }
}

/* ---- Published cases (OpenCV's own tests, and the comb) ---- */

static void assert_count(int connectivity, size_t count) {
    snprintf(where, sizeof(where), "%d x %d, %d-connected", mask.width, mask.height, connectivity);
    (void)label_mask(&mask, connectivity, false, NULL);
    TEST_ASSERT_EQUAL_MESSAGE(count, ended_count, where);
    assert_nothing_lost();
}

static void test_chessboard(void) {
    mask_checkerboard(&mask, 16, 16);
    assert_count(8, 1U);
    assert_count(4, 128U);
}

static void test_alternating_row(void) {
    mask_checkerboard(&mask, 15, 1);
    assert_count(8, 8U);
    assert_count(4, 8U);
}

static void test_zeros_and_ones(void) {
    mask_clear(&mask, 31, 87);
    assert_count(8, 0U);
    mask_clear(&mask, 10, 10);
    mask_box(&mask, 0, 0, 10, 10, true);
    assert_count(8, 1U);
    assert_count(4, 1U);
}

static void test_every_second_pixel_of_every_second_row(void) {
    const int w = OCEL_MAX_WIDTH;
    const int h = OCEL_MAX_HEIGHT;

    mask_clear(&mask, w, h);
    for (int y = 0; y < h; y += 2) {
        for (int x = 0; x < w; x += 2) {
            mask_set(&mask, x, y, true);
        }
    }
    check_both("isolated pixels");
    assert_count(8, (size_t)((w + 1) / 2) * (size_t)((h + 1) / 2));
}

static void test_comb_of_160_teeth_is_one_blob(void) {
    ocel_blob_t largest;

    mask_comb(&mask, 320, 101, 100);
    mask_box(&mask, 319, 100, 1, 1, true);
    TEST_ASSERT_EQUAL(OCEL_OK, label_mask(&mask, 8, false, &largest));
    TEST_ASSERT_EQUAL(1U, ended_count);
    TEST_ASSERT_EQUAL_UINT32(16320U, largest.area);
}

/* ---- Which is the largest ---- */

static void test_equals_go_to_the_first_in_raster_order(void) {
    ocel_blob_t largest;

    /* Two squares of four pixels; the one to the right begins a row higher. */
    mask_clear(&mask, 20, 8);
    mask_box(&mask, 1, 2, 2, 2, true);
    mask_box(&mask, 9, 1, 2, 2, true);
    TEST_ASSERT_EQUAL(OCEL_OK, label_mask(&mask, 8, false, &largest));
    TEST_ASSERT_EQUAL_UINT16(9U, largest.box.left);
    /* In the same row the left one is first, though the other ends before. */
    mask_clear(&mask, 20, 8);
    mask_box(&mask, 1, 1, 1, 4, true);
    mask_box(&mask, 9, 1, 2, 2, true);
    TEST_ASSERT_EQUAL(OCEL_OK, label_mask(&mask, 8, false, &largest));
    TEST_ASSERT_EQUAL_UINT16(1U, largest.box.left);
}

static void test_each_border_touches_the_edge(void) {
    static const ocel_rect_t boxes[5] = {
        {0, 3, 2, 2}, {3, 0, 2, 2}, {8, 3, 2, 2}, {3, 8, 2, 2}, {1, 1, 8, 8}};

    for (int i = 0; i < 5; i++) {
        ocel_blob_t largest;

        mask_clear(&mask, 10, 10);
        mask_box(&mask, boxes[i].left, boxes[i].top, boxes[i].width, boxes[i].height, true);
        TEST_ASSERT_EQUAL(OCEL_OK, label_mask(&mask, 8, false, &largest));
        TEST_ASSERT_EQUAL(i < 4, largest.touches_edge);
    }
}

/* ---- Bounds ---- */

/* labeller.h's bound of labels is met exactly, by stripes, so it could not be
 * smaller.  (Nor could that of places: with one less the checkerboard whose rows
 * do not touch, in test_shapes_at_full_size, overwrites its own runs.) */
static void test_bounds_are_reached(void) {
    mask_clear(&mask, OCEL_MAX_WIDTH, 4);
    for (int x = 0; x < OCEL_MAX_WIDTH; x += 2) {
        mask_box(&mask, x, 0, 1, 4, true);
    }
    (void)label_mask(&mask, 8, false, NULL);
    TEST_ASSERT_EQUAL(OCEL_MAX_LABELS, ocel_label_stats(&labeller).labels_max);
}

/* Rows that alternate with jumps of phase, the densest there is. */
static void test_bounds_hold_on_dense_rows(void) {
    for (int i = 0; i < MASKS / 20; i++) {
        const int height = at_most(16, OCEL_MAX_HEIGHT);

        mask_clear(&mask, OCEL_MAX_WIDTH - (i % 2), height);
        for (int y = 0; y < height; y++) {
            for (int x = rng_between(&rng, 0, 1); x < mask.width; x += 2) {
                mask_set(&mask, x, y, true);
                x += (rng_below(&rng, 40U) == 0U) ? 1 : 0;
                if (rng_below(&rng, 60U) == 0U) {
                    mask_set(&mask, x + 1, y, true);
                }
            }
        }
        check_both("dense rows");
    }
}

/* ---- Specks: what is removed before the sweep ---- */

static int special_width(int i) {
    static const int widths[] = {1, 3, 8, 31, 32, 33, 63, 64, 65, 96, 97, 320, 512};

    return at_most(widths[i % 13], OCEL_MAX_WIDTH);
}

/* Solid but for single pixels, and empty but for single pixels, thick enough that
 * holes and pixels come beside each other, in corners and at all borders. */
static void test_specks_in_all_places(void) {
    for (int i = 0; i < MASKS / 6; i++) {
        const int width = special_width(i);
        const int height = rng_between(&rng, 1, at_most(12, OCEL_MAX_HEIGHT));
        const bool solid = (i % 2) == 0;
        const int specks = rng_between(&rng, 1, 1 + (width * height) / 6);

        mask_clear(&mask, width, height);
        mask_box(&mask, 0, 0, width, height, solid);
        for (int k = 0; k < specks; k++) {
            mask_set(&mask, rng_between(&rng, 0, width - 1), rng_between(&rng, 0, height - 1),
                     !solid);
        }
        check_both("specks");
    }
}

/* Each pixel of a small solid box, and of an empty one, turned by itself. */
static void test_one_speck_anywhere(void) {
    for (int width = 1; width <= 34; width += (width == 5) ? 25 : 1) {
        for (int i = 0; i < 5 * width; i++) {
            mask_clear(&mask, width, 5);
            mask_set(&mask, i % width, i / width, true);
            check_both("one pixel");
            mask_box(&mask, 0, 0, width, 5, true);
            mask_set(&mask, i % width, i / width, false);
            check_both("one hole");
        }
    }
}

/* Of pixels alone the first is the largest, wherever it is and whatever is removed. */
static void test_the_first_of_pixels_alone_wins(void) {
    for (int i = 0; i < 200; i++) {
        const int width = at_most(special_width(i) + 2, OCEL_MAX_WIDTH);

        mask_clear(&mask, width, 20);
        for (int y = rng_between(&rng, 0, 6); y < 20; y += rng_between(&rng, 2, 4)) {
            for (int x = rng_between(&rng, 0, 5); x < width; x += rng_between(&rng, 2, 9)) {
                mask_set(&mask, x, y, true);
            }
        }
        check_both("pixels alone");
    }
}

/* Rows over and over, so that some are not looked at but counted: with holes, with
 * specks between, at the top and at the bottom. */
static void test_rows_that_repeat(void) {
    for (int i = 0; i < MASKS / 20; i++) {
        const int width = special_width(i);
        const int height = at_most(40, OCEL_MAX_HEIGHT);
        const double density = rng_uniform(&rng, 0.1, 0.9);
        mask_t rows;

        mask_random(&rows, width, height, density, &rng);
        mask_clear(&mask, width, height);
        for (int y = 0, from = 0; y < height; y++) {
            from = (rng_below(&rng, 5U) == 0U) ? y : from;
            memcpy(&mask.pixel[(size_t)y * (size_t)width],
                   &rows.pixel[(size_t)from * (size_t)width], (size_t)width);
        }
        for (int k = 0; k < i % 4; k++) {
            mask_set(&mask, rng_between(&rng, 0, width - 1), rng_between(&rng, 0, height - 1),
                     (i % 8) < 4);
        }
        check_both("repeated rows");
    }
}

/* Rows that keep to a few words, others from row to row, or have nothing: what a row
 * spans is all that is looked at. */
static void test_rows_in_spans(void) {
    for (int i = 0; i < MASKS / 6; i++) {
        const int width = at_most(97 + 32 * (i % 13), OCEL_MAX_WIDTH);

        mask_clear(&mask, width, at_most(16, OCEL_MAX_HEIGHT));
        for (int y = 0; y < mask.height; y++) {
            const int left = rng_between(&rng, 0, width - 1);
            const int span = at_most(rng_between(&rng, 1, 70), width - left);

            if (rng_below(&rng, 3U) != 0U) {
                mask_box(&mask, left, y, span, 1, true);
                for (int k = rng_between(&rng, 0, 4); k > 0; k--) {
                    mask_set(&mask, left + rng_between(&rng, 0, span - 1), y, false);
                }
            }
        }
        check_both("spans");
    }
}

/* ---- Contexts and order ---- */

static void test_a_copy_goes_on_by_itself(void) {
    for (int i = 0; i < 40; i++) {
        static ocel_labeller_t other;
        static ocel_crack_pool_t other_pool;
        const ocel_crack_t *cracks = NULL;
        static ocel_crack_t kept[OCEL_MAX_CRACKS];
        ocel_blob_t largest;
        size_t count = 0U;
        size_t other_count = 0U;
        const int half = rng_between(&rng, 0, 30);

        mask_random(&mask, 64, 30, rng_uniform(&rng, 0.3, 0.6), &rng);
        ended_count = 0U;
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_label_begin(&labeller, &pool, 64, 30, OCEL_CONNECT_8));
        if ((i % 2) == 0) {
            label_rows(&mask, 0, half, false);
        } else {
            label_rows_quietly(&mask, 0, half, 0U);
        }
        other = labeller;
        other_pool = pool;
        label_rows(&mask, half, 30, false);
        TEST_ASSERT_EQUAL(OCEL_OK, label_finish(NULL));
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_label_boundary(&labeller, &pool, &cracks, &count, NULL));
        memcpy(kept, cracks, count * sizeof(kept[0]));
        /* The copy stands elsewhere, and nothing is left of the original. */
        memset(&labeller, 0xA5, sizeof(labeller));
        memset(&pool, 0xA5, sizeof(pool));
        for (int y = half; y < 30; y++) {
            uint32_t row[OCEL_ROW_WORDS];

            mask_row(&mask, y, true, row);
            TEST_ASSERT_EQUAL(OCEL_OK, ocel_label_row(&other, &other_pool, row, NULL, NULL));
        }
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_label_end(&other, &other_pool, NULL, NULL, &largest));
        twin_label(&twin, &mask, 8);
        assert_same_blob(&twin.blob[twin.best], &largest);
        TEST_ASSERT_EQUAL(OCEL_OK,
                          ocel_label_boundary(&other, &other_pool, &cracks, &other_count, NULL));
        TEST_ASSERT_EQUAL(count, other_count);
        TEST_ASSERT_EQUAL_MEMORY(kept, cracks, count * sizeof(kept[0]));
    }
}

static void test_without_a_list_of_the_ended(void) {
    ocel_blob_t largest;

    mask_random(&mask, 100, 60, 0.4, &rng);
    twin_label(&twin, &mask, 8);
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_label_begin(&labeller, &pool, 100, 60, OCEL_CONNECT_8));
    for (int y = 0; y < 60; y++) {
        uint32_t row[OCEL_ROW_WORDS];
        size_t count = 99U;

        mask_row(&mask, y, true, row);
        TEST_ASSERT_EQUAL(OCEL_OK,
                          ocel_label_row(&labeller, &pool, row, NULL, (y % 2) ? &count : NULL));
        TEST_ASSERT_EQUAL((y % 2) ? 0U : 99U, count);
    }
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_label_end(&labeller, &pool, NULL, NULL, &largest));
    assert_same_blob(&twin.blob[twin.best], &largest);
}

static void test_rows_out_of_order(void) {
    const uint32_t row[OCEL_ROW_WORDS] = {1U};
    ocel_blob_t largest;

    memset(&labeller, 0, sizeof(labeller));
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_label_row(&labeller, &pool, row, NULL, NULL));
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_label_end(&labeller, &pool, NULL, NULL, &largest));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_label_begin(&labeller, &pool, 8, 2, OCEL_CONNECT_8));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_label_row(&labeller, &pool, row, NULL, NULL));
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_label_end(&labeller, &pool, NULL, NULL, &largest));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_label_row(&labeller, &pool, row, NULL, NULL));
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_label_row(&labeller, &pool, row, NULL, NULL));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_label_end(&labeller, &pool, NULL, NULL, &largest));
    TEST_ASSERT_EQUAL_UINT32(2U, largest.area);
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_label_end(&labeller, &pool, NULL, NULL, &largest));
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_label_row(&labeller, &pool, row, NULL, NULL));
}

/* ---- Hostile input ---- */

static void test_null_arguments(void) {
    const uint32_t row[OCEL_ROW_WORDS] = {0U};
    const ocel_label_stats_t none = ocel_label_stats(NULL);

    TEST_ASSERT_EQUAL(0U, none.runs);
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_label_begin(NULL, &pool, 8, 2, OCEL_CONNECT_8));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_label_begin(&labeller, NULL, 8, 2, OCEL_CONNECT_8));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_label_begin(&labeller, &pool, 8, 1, OCEL_CONNECT_8));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_label_row(NULL, &pool, row, NULL, NULL));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_label_row(&labeller, NULL, row, NULL, NULL));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_label_row(&labeller, &pool, NULL, NULL, NULL));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_label_row(&labeller, &pool, row, ended, NULL));
    TEST_ASSERT_EQUAL(OCEL_OK, ocel_label_row(&labeller, &pool, row, NULL, NULL));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_label_end(NULL, &pool, NULL, NULL, NULL));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_label_end(&labeller, NULL, NULL, NULL, NULL));
    TEST_ASSERT_EQUAL(OCEL_NULL_ARGUMENT, ocel_label_end(&labeller, &pool, ended, NULL, NULL));
    TEST_ASSERT_EQUAL(OCEL_NOT_SEEN, ocel_label_end(&labeller, &pool, NULL, NULL, NULL));
}

static void test_bad_sizes_and_options(void) {
    const uint32_t row[OCEL_ROW_WORDS] = {0U};
    const uint16_t w = OCEL_MAX_WIDTH;
    const uint16_t h = OCEL_MAX_HEIGHT;

    TEST_ASSERT_EQUAL(OCEL_BAD_SIZE, ocel_label_begin(&labeller, &pool, 0, h, OCEL_CONNECT_8));
    TEST_ASSERT_EQUAL(OCEL_BAD_SIZE, ocel_label_begin(&labeller, &pool, w, 0, OCEL_CONNECT_8));
    TEST_ASSERT_EQUAL(OCEL_BAD_SIZE,
                      ocel_label_begin(&labeller, &pool, (uint16_t)(w + 1U), h, OCEL_CONNECT_8));
    TEST_ASSERT_EQUAL(OCEL_BAD_SIZE,
                      ocel_label_begin(&labeller, &pool, w, (uint16_t)(h + 1U), OCEL_CONNECT_8));
    TEST_ASSERT_EQUAL(OCEL_BAD_SIZE, ocel_label_begin(&labeller, &pool, 65535, h, OCEL_CONNECT_8));
    TEST_ASSERT_EQUAL(OCEL_BAD_OPTION,
                      ocel_label_begin(&labeller, &pool, w, h, (ocel_connectivity_t)6));
    TEST_ASSERT_EQUAL(OCEL_BAD_OPTION,
                      ocel_label_begin(&labeller, &pool, w, h, (ocel_connectivity_t)0));
    /* A frame that was not begun takes no row; the next one is as good as any. */
    TEST_ASSERT_EQUAL(OCEL_BAD_ORDER, ocel_label_row(&labeller, &pool, row, NULL, NULL));
    mask_random(&mask, w, at_most(h, 20), 0.5, &rng);
    check_both("after mistakes");
}

/* A frame given up half way leaves nothing behind for the next. */
static void test_a_frame_may_be_given_up(void) {
    for (int i = 0; i < 20; i++) {
        mask_random(&mask, 64, 20, 0.6, &rng);
        ended_count = 0U;
        TEST_ASSERT_EQUAL(OCEL_OK, ocel_label_begin(&labeller, &pool, 64, 20, OCEL_CONNECT_8));
        label_rows(&mask, 0, rng_between(&rng, 1, 20), false);
        mask_random(&mask, 40, 30, 0.4, &rng);
        check_both("after a frame given up");
    }
}

/* ---- Centroids ---- */

static void test_centroid_is_rounded_to_the_nearest(void) {
    for (int i = 0; i < TEST_TRIALS(2000); i++) {
        ocel_blob_t blob;
        int32_t cx = -1;
        int32_t cy = -1;

        memset(&blob, 0, sizeof(blob));
        blob.area = rng_below(&rng, (i % 2) ? 50U : (1U << 24)) + 1U;
        blob.sum_x = (uint64_t)(rng_unit(&rng) * 4095.0 * blob.area);
        blob.sum_y = (uint64_t)(rng_unit(&rng) * 4095.0 * blob.area);
        ocel_blob_centroid(&blob, &cx, &cy);
        TEST_ASSERT_TRUE(fabsl(65536.0L * (long double)blob.sum_x / blob.area - cx) <= 0.5L);
        TEST_ASSERT_TRUE(fabsl(65536.0L * (long double)blob.sum_y / blob.area - cy) <= 0.5L);
    }
}

static void test_centroid_of_nothing(void) {
    ocel_blob_t blob;
    int32_t cx = 7;
    int32_t cy = 7;

    memset(&blob, 0, sizeof(blob));
    ocel_blob_centroid(&blob, &cx, &cy);
    TEST_ASSERT_EQUAL_INT32(0, cx);
    TEST_ASSERT_EQUAL_INT32(0, cy);
    cx = 7;
    ocel_blob_centroid(NULL, &cx, &cy);
    TEST_ASSERT_EQUAL_INT32(0, cx);
    ocel_blob_centroid(&blob, NULL, &cy);
    ocel_blob_centroid(&blob, &cx, NULL);
}

int main(void) {
    UNITY_BEGIN();
    RUN_TEST(test_all_masks_of_four_by_four);
    RUN_TEST(test_all_masks_of_seven_by_two);
    RUN_TEST(test_random_masks_of_all_densities_and_widths);
    RUN_TEST(test_random_discs);
    RUN_TEST(test_shapes_at_full_size);
    RUN_TEST(test_merging_in_every_order);
    RUN_TEST(test_chessboard);
    RUN_TEST(test_alternating_row);
    RUN_TEST(test_zeros_and_ones);
    RUN_TEST(test_every_second_pixel_of_every_second_row);
    RUN_TEST(test_comb_of_160_teeth_is_one_blob);
    RUN_TEST(test_equals_go_to_the_first_in_raster_order);
    RUN_TEST(test_each_border_touches_the_edge);
    RUN_TEST(test_bounds_are_reached);
    RUN_TEST(test_bounds_hold_on_dense_rows);
    RUN_TEST(test_specks_in_all_places);
    RUN_TEST(test_one_speck_anywhere);
    RUN_TEST(test_the_first_of_pixels_alone_wins);
    RUN_TEST(test_rows_that_repeat);
    RUN_TEST(test_rows_in_spans);
    RUN_TEST(test_a_copy_goes_on_by_itself);
    RUN_TEST(test_without_a_list_of_the_ended);
    RUN_TEST(test_rows_out_of_order);
    RUN_TEST(test_null_arguments);
    RUN_TEST(test_bad_sizes_and_options);
    RUN_TEST(test_a_frame_may_be_given_up);
    RUN_TEST(test_centroid_is_rounded_to_the_nearest);
    RUN_TEST(test_centroid_of_nothing);
    return UNITY_END();
}
