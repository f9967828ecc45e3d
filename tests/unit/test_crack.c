/* SPDX-License-Identifier: MIT
 *
 * The pool of cracks by itself: no cell is lost or given out twice, and a chain
 * becomes the same points wherever its cells lie.
 */
#include <stdio.h>
#include <string.h>

#include "board.h"
#include "label/crack.h"
#include "rng.h"
#include "unity.h"

enum { SEED = 19680101, NO_OWNER = 0 };

static ocel_crack_pool_t pool;
static ocel_crack_ledger_t ledger;
static rng_t rng;

void setUp(void) {
    rng = rng_seed(SEED);
    printf("seed %d\n", SEED);
    memset(&pool, 0xA5, sizeof(pool));
    ledger.free = OCEL_NO_CELL;
    ledger.fresh = 0U;
}

void tearDown(void) {
}

static uint32_t length_of(uint32_t head) {
    uint32_t length = 0U;

    for (uint32_t cell = head; cell != OCEL_NO_CELL; cell = ocel_crack_link(&pool, cell)) {
        length++;
        TEST_ASSERT_LESS_OR_EQUAL(OCEL_MAX_CRACKS, length);
    }
    return length;
}

/* ---- Taking and giving ---- */

static void test_cells_come_once_each_and_then_none(void) {
    for (uint32_t i = 0U; i < OCEL_MAX_CRACKS; i += 2U) {
        const ocel_crack_pair_t pair = ocel_crack_take_pair(&pool, &ledger);

        TEST_ASSERT_EQUAL_UINT32(i, pair.head);
        TEST_ASSERT_EQUAL_UINT32(i + 1U, pair.tail);
    }
    TEST_ASSERT_EQUAL_UINT32(OCEL_NO_CELL, ocel_crack_take_pair(&pool, &ledger).head);
    ocel_crack_give(&pool, &ledger, 7U, 7U);
    TEST_ASSERT_EQUAL_UINT32(OCEL_NO_CELL, ocel_crack_take_pair(&pool, &ledger).head);
    ocel_crack_give(&pool, &ledger, 4U, 4U);
    TEST_ASSERT_EQUAL_UINT32(4U, ocel_crack_take_pair(&pool, &ledger).head);
    TEST_ASSERT_EQUAL_UINT32(OCEL_NO_CELL, ocel_crack_take_pair(&pool, &ledger).head);
}

static void assert_is_pair(ocel_crack_pair_t pair) {
    TEST_ASSERT_NOT_EQUAL(OCEL_NO_CELL, pair.head);
    TEST_ASSERT_EQUAL_UINT32(pair.tail, ocel_crack_link(&pool, pair.head));
    TEST_ASSERT_EQUAL_UINT32(OCEL_NO_CELL, ocel_crack_link(&pool, pair.tail));
    TEST_ASSERT_NOT_EQUAL(pair.head, pair.tail);
}

static void test_a_pair_of_fresh_or_free_cells_or_of_both(void) {
    const ocel_crack_pair_t first = ocel_crack_take_pair(&pool, &ledger);
    ocel_crack_pair_t pair;

    assert_is_pair(first);
    ocel_crack_give(&pool, &ledger, first.head, first.tail);
    pair = ocel_crack_take_pair(&pool, &ledger);
    assert_is_pair(pair);
    TEST_ASSERT_EQUAL_UINT16(2U, ledger.fresh);
    ocel_crack_give(&pool, &ledger, pair.tail, pair.tail);
    assert_is_pair(ocel_crack_take_pair(&pool, &ledger));
    TEST_ASSERT_EQUAL_UINT16(3U, ledger.fresh);
}

static void test_a_last_single_cell_is_no_pair_and_not_lost(void) {
    ledger.fresh = OCEL_MAX_CRACKS - 1U;
    TEST_ASSERT_EQUAL_UINT32(OCEL_NO_CELL, ocel_crack_take_pair(&pool, &ledger).head);
    TEST_ASSERT_EQUAL_UINT32(OCEL_NO_CELL, ocel_crack_take_pair(&pool, &ledger).head);
    ocel_crack_give(&pool, &ledger, 5U, 5U);
    TEST_ASSERT_EQUAL_UINT32(5U, ocel_crack_take_pair(&pool, &ledger).head);
    TEST_ASSERT_EQUAL_UINT16(OCEL_MAX_CRACKS, ledger.fresh);
    TEST_ASSERT_EQUAL_UINT16(OCEL_NO_CELL, ledger.free);
}

static void test_giving_back_from_the_head_alone(void) {
    ocel_crack_pair_t a = ocel_crack_take_pair(&pool, &ledger);
    ocel_crack_pair_t b = ocel_crack_take_pair(&pool, &ledger);

    ocel_crack_give_from(&pool, &ledger, OCEL_NO_CELL);
    TEST_ASSERT_EQUAL_UINT32(0U, length_of(ledger.free));
    ocel_crack_set_link(&pool, a.tail, b.head);
    ocel_crack_give_from(&pool, &ledger, a.head);
    TEST_ASSERT_EQUAL_UINT32(4U, length_of(ledger.free));
    b = ocel_crack_take_pair(&pool, &ledger);
    ocel_crack_set_link(&pool, b.head, OCEL_NO_CELL);
    ocel_crack_give_from(&pool, &ledger, b.head);
    ocel_crack_give_from(&pool, &ledger, b.tail);
    a = ocel_crack_take_pair(&pool, &ledger);
    ocel_crack_give_from(&pool, &ledger, a.head);
    TEST_ASSERT_EQUAL_UINT32(4U, length_of(ledger.free));
}

/* Links and columns of every size that the largest limits have. */
static void test_links_and_columns_of_every_size(void) {
    for (uint32_t v = 0U; v <= 0xFFFFU; v++) {
        ocel_crack_set_link(&pool, 3U, v);
        TEST_ASSERT_EQUAL_UINT32(v, ocel_crack_link(&pool, 3U));
    }
    for (uint32_t column = 0U; column <= 4096U; column++) {
        ocel_crack_set_left(&pool, 3U, column);
        TEST_ASSERT_EQUAL_INT16(column, pool.cells[3].x_hpx);
        ocel_crack_set_right(&pool, 3U, column);
        TEST_ASSERT_EQUAL_INT16(column | OCEL_CRACK_RIGHT, pool.cells[3].x_hpx);
    }
}

/* Chains begun, lengthened and given back at random, each cell's owner kept
 * beside. */
static void test_no_cell_has_two_owners(void) {
    enum { CHAINS = 40, STEPS = TEST_TRIALS_AT_LEAST(20000, 200000) };
    static uint8_t owner[OCEL_MAX_CRACKS];
    uint32_t head[CHAINS + 1] = {0U};
    uint32_t tail[CHAINS + 1] = {0U};
    uint32_t owned = 0U;

    memset(owner, NO_OWNER, sizeof(owner));
    for (int step = 0; step < STEPS; step++) {
        const uint32_t chain = rng_below(&rng, CHAINS) + 1U;
        const bool gone = head[chain] == tail[chain]; /* both 0: none of either */
        uint32_t cell;

        if (gone) {
            const ocel_crack_pair_t pair = ocel_crack_take_pair(&pool, &ledger);

            TEST_ASSERT_EQUAL(owned + 2U > OCEL_MAX_CRACKS, pair.head == OCEL_NO_CELL);
            if (pair.head != OCEL_NO_CELL) {
                assert_is_pair(pair);
                TEST_ASSERT_EQUAL(NO_OWNER, owner[pair.head]);
                TEST_ASSERT_EQUAL(NO_OWNER, owner[pair.tail]);
                owner[pair.head] = (uint8_t)chain;
                owner[pair.tail] = (uint8_t)chain;
                head[chain] = pair.head;
                tail[chain] = pair.tail;
                owned += 2U;
            }
        } else if (rng_below(&rng, 150U) == 0U) {
            for (cell = head[chain]; cell != OCEL_NO_CELL; cell = ocel_crack_link(&pool, cell)) {
                TEST_ASSERT_EQUAL(chain, owner[cell]);
                owner[cell] = NO_OWNER;
                owned--;
            }
            if ((step % 2) == 0) {
                ocel_crack_give(&pool, &ledger, head[chain], tail[chain]);
            } else {
                ocel_crack_give_from(&pool, &ledger, head[chain]);
            }
            head[chain] = 0U;
            tail[chain] = 0U;
        } else {
            const ocel_crack_pair_t pair = ocel_crack_take_pair(&pool, &ledger);

            TEST_ASSERT_EQUAL(owned == OCEL_MAX_CRACKS, pair.head == OCEL_NO_CELL);
            if (pair.head != OCEL_NO_CELL) {
                TEST_ASSERT_EQUAL(NO_OWNER, owner[pair.head]);
                TEST_ASSERT_EQUAL(NO_OWNER, owner[pair.tail]);
                owner[pair.head] = (uint8_t)chain;
                owner[pair.tail] = (uint8_t)chain;
                ocel_crack_set_link(&pool, tail[chain], pair.head);
                tail[chain] = pair.tail;
                owned += 2U;
            }
        }
        TEST_ASSERT_LESS_OR_EQUAL(OCEL_MAX_CRACKS, ledger.fresh);
    }
    TEST_ASSERT_EQUAL_UINT32(ledger.fresh, owned + length_of(ledger.free));
    TEST_ASSERT_EQUAL_UINT32(OCEL_MAX_CRACKS, ledger.fresh); /* the pool was exhausted once */
}

/* ---- Unrolling ---- */

/* Lays the boundary of a box into the cells place[0], place[1], ...: up its left
 * edge, down its right one.  Returns the head. */
static uint32_t lay_box(const uint32_t *place, uint32_t left, uint32_t right, uint32_t rows) {
    for (uint32_t i = 0U; i < 2U * rows; i++) {
        if (i < rows) {
            ocel_crack_set_left(&pool, place[i], left);
        } else {
            ocel_crack_set_right(&pool, place[i], right);
        }
        ocel_crack_set_link(&pool, place[i], (i + 1U < 2U * rows) ? place[i + 1U] : OCEL_NO_CELL);
    }
    return place[0];
}

/* The i-th crack of that box, whose last row is `bottom`. */
static ocel_crack_t box_crack(uint32_t i, uint32_t left, uint32_t right, uint32_t rows,
                              uint32_t bottom) {
    const int32_t l = (int32_t)left;
    const int32_t r = (int32_t)right;
    const int32_t h = (int32_t)rows;
    const int32_t b = (int32_t)bottom;
    const int32_t at = (int32_t)i;
    int32_t x = 0;
    int32_t y = 0;

    if (at < h) { /* up */
        x = 2 * l - 1;
        y = 2 * (b - at);
    } else if (at < h + r - l) { /* over the top */
        x = 2 * (l + at - h);
        y = 2 * (b - h) + 1;
    } else if (at < 2 * h + r - l) { /* down */
        x = 2 * r - 1;
        y = 2 * (b - h + 1 + at - (h + r - l));
    } else { /* back below */
        x = 2 * (r - 1 - (at - (2 * h + r - l)));
        y = 2 * b + 1;
    }
    return (ocel_crack_t){(int16_t)x, (int16_t)y};
}

static void assert_box(ocel_crack_points_t points, uint32_t left, uint32_t right, uint32_t rows,
                       uint32_t bottom, uint32_t room) {
    const uint32_t all = 2U * (rows + right - left);

    TEST_ASSERT_EQUAL_UINT32((all + room - 1U) / room, points.stride);
    TEST_ASSERT_EQUAL_UINT32((all + points.stride - 1U) / points.stride, points.count);
    TEST_ASSERT_LESS_OR_EQUAL(OCEL_MAX_CRACKS, points.first + points.count);
    for (uint32_t i = 0U; i < points.count; i++) {
        const ocel_crack_t expected = box_crack(i * points.stride, left, right, rows, bottom);
        const ocel_crack_t actual = pool.cells[points.first + i];

        TEST_ASSERT_EQUAL_INT16(expected.x_hpx, actual.x_hpx);
        TEST_ASSERT_EQUAL_INT16(expected.y_hpx, actual.y_hpx);
    }
}

static void test_counting(void) {
    uint32_t place[20];

    for (uint32_t i = 0U; i < 20U; i++) {
        place[i] = 19U - i;
    }
    const ocel_crack_count_t count = ocel_crack_count(&pool, lay_box(place, 3U, 50U, 10U));
    TEST_ASSERT_EQUAL_UINT32(20U, count.vertical);
    TEST_ASSERT_EQUAL_UINT32(2U * (10U + 47U), count.total);
}

static void test_beside_the_used_cells_when_there_is_room(void) {
    const uint32_t place[4] = {5U, 0U, 9U, 2U};
    const uint32_t head = lay_box(place, 0U, 4U, 2U);

    ledger.fresh = 10U;
    const ocel_crack_points_t points = ocel_crack_unroll(&pool, &ledger, head, 7U);
    TEST_ASSERT_EQUAL_UINT32(10U, points.first);
    assert_box(points, 0U, 4U, 2U, 7U, OCEL_MAX_CRACKS);
    /* To the last cell, and no further. */
    ledger.fresh = OCEL_MAX_CRACKS - 12U;
    TEST_ASSERT_EQUAL_UINT32(12U, ocel_crack_unroll(&pool, &ledger, head, 7U).count);
    ledger.fresh = OCEL_MAX_CRACKS - 11U;
    assert_box(ocel_crack_unroll(&pool, &ledger, head, 7U), 0U, 4U, 2U, 7U, OCEL_MAX_CRACKS);
}

/* The cells anywhere in the pool: the chain must be lined up first. */
static void test_wherever_the_cells_lie(void) {
    static uint32_t place[OCEL_MAX_CRACKS];

    ledger.fresh = OCEL_MAX_CRACKS;
    for (int i = 0; i < TEST_TRIALS(400); i++) {
        const uint32_t rows = rng_below(&rng, OCEL_MAX_CRACKS / 2U - 1U) + 1U;
        const uint32_t left = rng_below(&rng, 300U);
        const uint32_t right = left + 1U + rng_below(&rng, (i % 2) ? 20U : 3000U);
        const uint32_t bottom = rows + rng_below(&rng, 50U);

        memset(&pool, 0xA5, sizeof(pool));
        rng_shuffle(&rng, place, OCEL_MAX_CRACKS);
        assert_box(ocel_crack_unroll(&pool, &ledger, lay_box(place, left, right, rows), bottom),
                   left, right, rows, bottom,
                   (OCEL_MAX_CRACKS - 2U * rows < OCEL_MAX_FIT_POINTS) ? OCEL_MAX_CRACKS - 2U * rows
                                                                       : OCEL_MAX_FIT_POINTS);
    }
}

static void test_a_chain_that_fills_the_pool_has_no_points(void) {
    static uint32_t place[OCEL_MAX_CRACKS];
    uint32_t head;

    rng_shuffle(&rng, place, OCEL_MAX_CRACKS);
    head = lay_box(place, 1U, 2U, OCEL_MAX_CRACKS / 2U);
    ledger.fresh = OCEL_MAX_CRACKS;
    const ocel_crack_points_t points = ocel_crack_unroll(&pool, &ledger, head, 4000U);
    TEST_ASSERT_EQUAL_UINT32(0U, points.stride);
    TEST_ASSERT_EQUAL_UINT32(0U, points.count);
}

int main(void) {
    UNITY_BEGIN();
    RUN_TEST(test_cells_come_once_each_and_then_none);
    RUN_TEST(test_a_pair_of_fresh_or_free_cells_or_of_both);
    RUN_TEST(test_a_last_single_cell_is_no_pair_and_not_lost);
    RUN_TEST(test_giving_back_from_the_head_alone);
    RUN_TEST(test_links_and_columns_of_every_size);
    RUN_TEST(test_no_cell_has_two_owners);
    RUN_TEST(test_counting);
    RUN_TEST(test_beside_the_used_cells_when_there_is_room);
    RUN_TEST(test_wherever_the_cells_lie);
    RUN_TEST(test_a_chain_that_fills_the_pool_has_no_points);
    return UNITY_END();
}
