/* SPDX-License-Identifier: MIT
 *
 * Chains of cracks: what is not in the inner loop, and the way from the
 * winner's chain to its boundary points, all in the pool itself.
 */
#include "crack.h"

#include "../base/int_math.h"

#define POOL_CELLS ((uint32_t)OCEL_MAX_CRACKS)
#define FIT_POINTS ((uint32_t)OCEL_MAX_FIT_POINTS)

/* There is at most one free cell, which is the pair's head then. */
ocel_crack_pair_t ocel_crack_take_pair_slowly(ocel_crack_pool_t *pool,
                                              ocel_crack_ledger_t *ledger) {
    /* at most: 1; OCEL_MAX_CRACKS + 2 * OCEL_MAX_RUNS + 2 as cells in a call of ocel_sweep_row or
     * ocel_sweep_repeat */
    const uint32_t fresh = ledger->fresh;
    const uint32_t wanted = (ledger->free != OCEL_NO_CELL) ? 1U : 2U;
    ocel_crack_pair_t pair = {OCEL_NO_CELL, OCEL_NO_CELL};

    if ((fresh + wanted) <= POOL_CELLS) {
        pair.head = (wanted == 1U) ? (uint32_t)ledger->free : fresh;
        pair.tail = fresh + (wanted - 1U);
        ledger->free = OCEL_NO_CELL;
        /* at most: 1; OCEL_MAX_CRACKS + 2 * OCEL_MAX_RUNS + 2 as cells in a call of ocel_sweep_row
         * or ocel_sweep_repeat; OCEL_MAX_CRACKS in a call of ocel_eye_frame */
        ledger->fresh = (uint16_t)(fresh + wanted);
        ocel_crack_set_link(pool, pair.head, pair.tail);
        ocel_crack_set_link(pool, pair.tail, OCEL_NO_CELL);
    }
    return pair;
}

void ocel_crack_give_from(ocel_crack_pool_t *pool, ocel_crack_ledger_t *ledger, uint32_t head) {
    if (head != OCEL_NO_CELL) {
        uint32_t tail = head;
        uint32_t link = ocel_crack_link(pool, head);

        /* bound: OCEL_MAX_CRACKS; OCEL_MAX_CRACKS + OCEL_MAX_RUNS in a call of
         * ocel_sweep_row or ocel_sweep_repeat;
         * OCEL_MAX_CRACKS + 2 * OCEL_MAX_RUNS + 2 as cells in a call of ocel_sweep_row or
         * ocel_sweep_repeat; OCEL_MAX_CRACKS + 8 * OCEL_MAX_RUNS in a call of ocel_label_row;
         * OCEL_MAX_CRACKS + 6 * OCEL_MAX_RUNS in a call of ocel_label_end;
         * 2 * OCEL_MAX_HEIGHT * OCEL_MAX_RUNS as taken in a call of ocel_eye_frame */
        while (link != OCEL_NO_CELL) {
            tail = link;
            link = ocel_crack_link(pool, link);
        }
        /* at most: 1; 2 * OCEL_MAX_HEIGHT * OCEL_MAX_RUNS as taken in a call of ocel_eye_frame */
        ocel_crack_give(pool, ledger, head, tail);
    }
}

/* |a - b|. */
static inline uint32_t distance(uint32_t a, uint32_t b) {
    return (a > b) ? (a - b) : (b - a);
}

static inline uint32_t column_of(uint32_t crack) {
    return crack & (OCEL_CRACK_RIGHT - 1U);
}

/* The crack in a cell: its column and OCEL_CRACK_RIGHT. */
static inline uint32_t crack_in(const ocel_crack_pool_t *pool, uint32_t at) {
    return (uint16_t)pool->cells[at].x_hpx;
}

ocel_crack_count_t ocel_crack_count(const ocel_crack_pool_t *pool, uint32_t head) {
    const uint32_t start = column_of(crack_in(pool, head));
    ocel_crack_count_t count = {0U, 0U};
    uint32_t column = start;
    uint32_t at = head;

    while (at != OCEL_NO_CELL) { /* bound: OCEL_MAX_CRACKS */
        const uint32_t next = column_of(crack_in(pool, at));

        count.total += distance(column, next);
        count.vertical++;
        column = next;
        at = ocel_crack_link(pool, at);
    }
    count.total += distance(column, start) + count.vertical;
    return count;
}

/* Moves the chain's cells to 0, 1, 2, ... in its order.  (MacLaren's
 * rearrangement of a linked list in place: Knuth, The Art of Computer
 * Programming 3, section 5.2, exercise 12.)  Whatever stood at k goes to where
 * the k-th cell was, and the link at k then says where that is.  A cell is
 * looked for once, along as many such links as it has been displaced, and there
 * is one displacement a cell: linear in all. */
static void line_up(ocel_crack_pool_t *pool, uint32_t head) {
    uint32_t at = head;
    uint32_t k = 0U;

    while (at != OCEL_NO_CELL) { /* bound: OCEL_MAX_CRACKS */
        ocel_crack_t crack;

        while (at < k) { /* bound: OCEL_MAX_CRACKS in all rounds of the outer loop */
            at = ocel_crack_link(pool, at);
        }
        crack = pool->cells[at];
        pool->cells[at] = pool->cells[k];
        pool->cells[k].x_hpx = crack.x_hpx;
        ocel_crack_set_link(pool, k, at);
        at = (uint16_t)crack.y_hpx;
        k++;
    }
}

/* Moves the chain's `count` cells to the pool's end, in order, so that all other
 * cells are in one piece.  Returns its head. */
static uint32_t move_to_end(ocel_crack_pool_t *pool, uint32_t head, uint32_t count) {
    const uint32_t first = POOL_CELLS - count;
    uint32_t link = OCEL_NO_CELL;

    line_up(pool, head);
    for (uint32_t i = count; i > 0U; i--) { /* bound: OCEL_MAX_CRACKS */
        const uint32_t to = first + (i - 1U);

        pool->cells[to].x_hpx = pool->cells[i - 1U].x_hpx;
        ocel_crack_set_link(pool, to, link);
        link = to;
    }
    return first;
}

/* Where the points go. */
typedef struct {
    ocel_crack_t *point;
    uint32_t count;  /* written */
    uint32_t next;   /* the next one written is the next-th crack from here, >= 1 */
    uint32_t stride; /* >= 1 */
} point_sink_t;

/* Coordinates -1 .. 8191. */
static inline void put_point(point_sink_t *sink, int32_t x_hpx, int32_t y_hpx) {
    sink->next--;
    if (sink->next == 0U) {
        /* at most: 1; OCEL_MAX_CRACKS in a call of ocel_crack_unroll */
        sink->point[sink->count].x_hpx = (int16_t)x_hpx;
        sink->point[sink->count].y_hpx = (int16_t)y_hpx;
        sink->count++;
        sink->next = sink->stride;
    }
}

/* The horizontal cracks from column `from` to column `to`, in the order of the
 * walk; that over pixel x has its midpoint at 2 x. */
static inline void put_horizontal(point_sink_t *sink, uint32_t from, uint32_t to, int32_t y_hpx) {
    const int32_t step = (from < to) ? 2 : -2;
    const uint32_t columns = distance(from, to);
    int32_t x_hpx = (2 * (int32_t)from) + ((from < to) ? 0 : -2);

    /* bound: OCEL_MAX_WIDTH; OCEL_MAX_WIDTH * (OCEL_MAX_HEIGHT + 1) in a call of
     * ocel_crack_unroll */
    for (uint32_t i = 0U; i < columns; i++) {
        put_point(sink, x_hpx, y_hpx);
        x_hpx += step;
    }
}

/* Walks along the closed chain from `head`, in the row `bottom`, and writes every
 * stride-th crack from the cell `first` on.  Returns how many. */
static uint32_t put_points(ocel_crack_pool_t *pool, uint32_t head, uint32_t bottom, uint32_t first,
                           uint32_t stride) {
    const uint32_t start = crack_in(pool, head);
    point_sink_t sink = {&pool->cells[first], 0U, 1U, stride};
    uint32_t crack = start;
    uint32_t at = head;
    int32_t y_hpx = 2 * (int32_t)bottom;

    while (at != OCEL_NO_CELL) { /* bound: OCEL_MAX_CRACKS */
        const int32_t half_down = ((crack & OCEL_CRACK_RIGHT) != 0U) ? 1 : -1;
        uint32_t next = start;

        at = ocel_crack_link(pool, at);
        if (at != OCEL_NO_CELL) {
            next = crack_in(pool, at);
        }
        put_point(&sink, (2 * (int32_t)column_of(crack)) - 1, y_hpx);
        put_horizontal(&sink, column_of(crack), column_of(next), y_hpx + half_down);
        if (((crack ^ next) & OCEL_CRACK_RIGHT) == 0U) {
            y_hpx += 2 * half_down;
        }
        crack = next;
    }
    return sink.count;
}

ocel_crack_points_t ocel_crack_unroll(ocel_crack_pool_t *pool, const ocel_crack_ledger_t *ledger,
                                      uint32_t head, uint32_t bottom) {
    const ocel_crack_count_t count = ocel_crack_count(pool, head);
    const uint32_t beside = POOL_CELLS - ledger->fresh;
    const uint32_t over = POOL_CELLS - count.vertical;
    const uint32_t room = (over < FIT_POINTS) ? over : FIT_POINTS;
    ocel_crack_points_t points = {ledger->fresh, 0U, 1U};
    uint32_t chain = head;

    if ((count.total > beside) || (count.total > room)) {
        const uint32_t up = count.total + (room - 1U); /* < 2^30; not read when room is 0 */

        points.first = 0U;
        points.stride = (room > 0U) ? (uint32_t)ocel_udiv64(up, room) : 0U;
        chain = move_to_end(pool, head, count.vertical);
    }
    if (points.stride > 0U) {
        points.count = put_points(pool, chain, bottom, points.first, points.stride);
    }
    return points;
}
