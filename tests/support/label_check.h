/* SPDX-License-Identifier: MIT
 *
 * Runs the labeller over a mask and compares everything it says with the twin
 * of masks.h, and what it keeps with the bounds that labeller.h derives.
 */
#ifndef SUPPORT_LABEL_CHECK_H
#define SUPPORT_LABEL_CHECK_H

#include <stdbool.h>
#include <stdio.h>

#include <ocellus/label.h>

#include "board.h"
#include "label/crack.h"
#include "masks.h"
#include "unity.h"

static ocel_labeller_t labeller;
static ocel_crack_pool_t pool;
static twin_t twin;
static ocel_blob_t ended[MASK_MAX_BLOBS];
static size_t ended_count;
static char where[160]; /* what a failure prints */

static inline bool blob_before(const ocel_blob_t *p, const ocel_blob_t *q) {
    return (p->box.top != q->box.top) ? (p->box.top < q->box.top) : (p->first_x < q->first_x);
}

/* By first pixel.  Shell's sort: some C libraries' qsort takes quadratic time on
 * what is nearly in order, and this is. */
static inline void sort_blobs(ocel_blob_t *blobs, size_t count) {
    for (size_t gap = count / 2U; gap > 0U; gap = (gap == 2U) ? 1U : (gap * 5U) / 11U) {
        for (size_t i = gap; i < count; i++) {
            const ocel_blob_t blob = blobs[i];
            size_t at = i;
            while ((at >= gap) && blob_before(&blob, &blobs[at - gap])) {
                blobs[at] = blobs[at - gap];
                at -= gap;
            }
            blobs[at] = blob;
        }
    }
}

static inline void assert_same_blob(const ocel_blob_t *expected, const ocel_blob_t *actual) {
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(expected->area, actual->area, where);
    TEST_ASSERT_EQUAL_UINT16_MESSAGE(expected->box.left, actual->box.left, where);
    TEST_ASSERT_EQUAL_UINT16_MESSAGE(expected->box.top, actual->box.top, where);
    TEST_ASSERT_EQUAL_UINT16_MESSAGE(expected->box.width, actual->box.width, where);
    TEST_ASSERT_EQUAL_UINT16_MESSAGE(expected->box.height, actual->box.height, where);
    TEST_ASSERT_EQUAL_UINT16_MESSAGE(expected->first_x, actual->first_x, where);
    TEST_ASSERT_EQUAL_MESSAGE(expected->touches_edge, actual->touches_edge, where);
    TEST_ASSERT_EQUAL_UINT64_MESSAGE(expected->sum_x, actual->sum_x, where);
    TEST_ASSERT_EQUAL_UINT64_MESSAGE(expected->sum_y, actual->sum_y, where);
    TEST_ASSERT_EQUAL_UINT64_MESSAGE(expected->sum_xx, actual->sum_xx, where);
    TEST_ASSERT_EQUAL_UINT64_MESSAGE(expected->sum_xy, actual->sum_xy, where);
    TEST_ASSERT_EQUAL_UINT64_MESSAGE(expected->sum_yy, actual->sum_yy, where);
}

/* Labels rows first .. last - 1 of a frame that has been begun. */
static inline void label_rows(const mask_t *mask, int first, int last, bool beyond) {
    for (int y = first; y < last; y++) {
        uint32_t row[OCEL_ROW_WORDS];
        size_t count = 99U;

        mask_row(mask, y, beyond, row);
        TEST_ASSERT_EQUAL_MESSAGE(
            OCEL_OK, ocel_label_row(&labeller, &pool, row, &ended[ended_count], &count), where);
        TEST_ASSERT_LESS_OR_EQUAL_MESSAGE(OCEL_MAX_RUNS, count, where);
        ended_count += count;
    }
}

static inline ocel_status_t label_finish(ocel_blob_t *largest) {
    size_t count = 99U;
    const ocel_status_t status =
        ocel_label_end(&labeller, &pool, &ended[ended_count], &count, largest);

    ended_count += count;
    sort_blobs(ended, ended_count);
    return status;
}

/* Labels a whole mask. */
static inline ocel_status_t label_mask(const mask_t *mask, int connectivity, bool beyond,
                                       ocel_blob_t *largest) {
    ended_count = 0U;
    TEST_ASSERT_EQUAL_MESSAGE(OCEL_OK,
                              ocel_label_begin(&labeller, &pool, (uint16_t)mask->width,
                                               (uint16_t)mask->height,
                                               (ocel_connectivity_t)connectivity),
                              where);
    label_rows(mask, 0, mask->height, beyond);
    return label_finish(largest);
}

/* The same as the eye does it, without a list of what has ended: rows are held
 * then, and their specks removed.  A list is asked for in the rows whose bits of
 * `asked` are set, over and over, and not read. */
static inline void label_rows_quietly(const mask_t *mask, int first, int last, uint32_t asked) {
    for (int y = first; y < last; y++) {
        const bool ask = ((asked >> ((unsigned)y % 32U)) & 1U) != 0U;
        uint32_t row[OCEL_ROW_WORDS];
        size_t count = 99U;

        mask_row(mask, y, true, row);
        TEST_ASSERT_EQUAL_MESSAGE(
            OCEL_OK, ocel_label_row(&labeller, &pool, row, ask ? ended : NULL, &count), where);
    }
}

static inline ocel_status_t label_quietly(const mask_t *mask, int connectivity, uint32_t asked,
                                          ocel_blob_t *largest) {
    TEST_ASSERT_EQUAL_MESSAGE(OCEL_OK,
                              ocel_label_begin(&labeller, &pool, (uint16_t)mask->width,
                                               (uint16_t)mask->height,
                                               (ocel_connectivity_t)connectivity),
                              where);
    label_rows_quietly(mask, 0, mask->height, asked);
    return ocel_label_end(&labeller, &pool, NULL, NULL, largest);
}

static inline uint32_t chain_length(uint32_t head) {
    uint32_t length = 0U;

    for (uint32_t cell = head; cell != OCEL_NO_CELL; cell = ocel_crack_link(&pool, cell)) {
        length++;
        TEST_ASSERT_LESS_OR_EQUAL_MESSAGE(OCEL_MAX_CRACKS, length, where);
    }
    return length;
}

static inline uint32_t list_length(const uint16_t *next, uint32_t first, uint32_t end) {
    uint32_t length = 0U;

    for (uint32_t at = first; at != end; at = next[at]) {
        length++;
        TEST_ASSERT_LESS_OR_EQUAL_MESSAGE(OCEL_FRONTIER_RUNS, length, where);
    }
    return length;
}

/* When a frame has ended everything is free again but the winner's chain, and
 * nothing was ever beyond its bound. */
static inline void assert_nothing_lost(void) {
    const ocel_label_stats_t stats = ocel_label_stats(&labeller);
    const uint32_t no_label = 0x7FFFU;

    TEST_ASSERT_LESS_OR_EQUAL_MESSAGE(OCEL_MAX_LABELS, stats.labels_max, where);
    TEST_ASSERT_LESS_OR_EQUAL_MESSAGE(OCEL_MAX_CRACKS, stats.cracks_max, where);
    TEST_ASSERT_LESS_OR_EQUAL_MESSAGE(stats.runs, stats.unions, where);
    TEST_ASSERT_EQUAL_MESSAGE(labeller.first_run, labeller.last_run, where);
    TEST_ASSERT_EQUAL_MESSAGE(stats.labels_max,
                              list_length(labeller.live, labeller.free_label, no_label), where);
    TEST_ASSERT_EQUAL_MESSAGE(labeller.ledger.fresh,
                              chain_length(labeller.ledger.free) + chain_length(labeller.best_head),
                              where);
}

/* What is to be said of a mask whose twin has been made, and only once. */
static inline void assert_twin(const mask_t *mask, ocel_status_t status,
                               const ocel_blob_t *largest) {
    const ocel_label_stats_t stats = ocel_label_stats(&labeller);

    TEST_ASSERT_EQUAL_MESSAGE((twin.count > 0) ? OCEL_OK : OCEL_NOT_SEEN, status, where);
    if (twin.count > 0) {
        assert_same_blob(&twin.blob[twin.best], largest);
    }
    TEST_ASSERT_EQUAL_MESSAGE(mask_runs(mask), stats.runs, where);
    TEST_ASSERT_EQUAL_MESSAGE(twin.count, stats.components, where);
    assert_nothing_lost();
}

/* Labels a mask and compares every component. */
static inline void check_components(const mask_t *mask, int connectivity, bool beyond) {
    ocel_blob_t largest;
    const ocel_status_t status = label_mask(mask, connectivity, beyond, &largest);

    twin_label(&twin, mask, connectivity);
    TEST_ASSERT_EQUAL_MESSAGE(twin.count, ended_count, where);
    for (int i = 0; i < twin.count; i++) {
        assert_same_blob(&twin.blob[i], &ended[i]);
    }
    assert_twin(mask, status, &largest);
}

/* Labels a mask and compares every component, the largest and the counts; and
 * the latter again without a list, and with one now and then. */
static inline void check_labels(const mask_t *mask, int connectivity, bool beyond) {
    ocel_blob_t largest;
    ocel_status_t status;

    check_components(mask, connectivity, beyond);
    status = label_quietly(mask, connectivity, 0x3A1CCA64U, &largest);
    assert_twin(mask, status, &largest);
    status = label_quietly(mask, connectivity, 0U, &largest);
    assert_twin(mask, status, &largest);
}

/* The boundary of the component that is the largest, just labelled: OCEL_OK and
 * exact, or, when `may_overflow`, OCEL_OVERFLOW.  Returns the status. */
static inline ocel_status_t check_largest_boundary(const mask_t *mask, int connectivity,
                                                   bool may_overflow) {
    static ocel_crack_t expected[MASK_MAX_CRACKS];
    const ocel_crack_t *cracks = NULL;
    size_t count = 99U;
    size_t stride = 0U;
    int vertical = 0;
    int all;
    int room;
    const ocel_status_t status = ocel_label_boundary(&labeller, &pool, &cracks, &count, &stride);

    if (twin.count == 0) {
        TEST_ASSERT_EQUAL_MESSAGE(OCEL_NOT_SEEN, status, where);
        TEST_ASSERT_EQUAL_MESSAGE(0U, count, where);
        return status;
    }
    all = twin_boundary(&twin, mask, connectivity, twin.best, expected, &vertical);
    TEST_ASSERT_TRUE_MESSAGE(twin_is_outer(&twin, mask, connectivity, twin.best, expected, all),
                             where);
    if ((status == OCEL_OVERFLOW) && may_overflow) {
        TEST_ASSERT_EQUAL_MESSAGE(0U, count, where);
        return status;
    }
    TEST_ASSERT_EQUAL_MESSAGE(OCEL_OK, status, where);
    TEST_ASSERT_TRUE_MESSAGE(
        (cracks >= pool.cells) && (cracks + count <= pool.cells + OCEL_MAX_CRACKS), where);
    room = OCEL_MAX_CRACKS - vertical;
    room = (room < OCEL_MAX_FIT_POINTS) ? room : OCEL_MAX_FIT_POINTS;
    TEST_ASSERT_EQUAL_MESSAGE((all + room - 1) / room, stride, where);
    TEST_ASSERT_EQUAL_MESSAGE(((size_t)all + stride - 1U) / stride, count, where);
    for (size_t i = 0U; i < count; i++) {
        TEST_ASSERT_EQUAL_INT16_MESSAGE(expected[i * stride].x_hpx, cracks[i].x_hpx, where);
        TEST_ASSERT_EQUAL_INT16_MESSAGE(expected[i * stride].y_hpx, cracks[i].y_hpx, where);
    }
    return status;
}

/* Everything, with a list and without.  Returns the boundary's status without.
 * (Where the pool overflows the two may differ: it is not always the same
 * component that asks when there is nothing left.) */
static inline ocel_status_t check_boundary(const mask_t *mask, int connectivity,
                                           bool may_overflow) {
    check_components(mask, connectivity, true);
    (void)check_largest_boundary(mask, connectivity, may_overflow);
    check_labels(mask, connectivity, true);
    return check_largest_boundary(mask, connectivity, may_overflow);
}

#endif
