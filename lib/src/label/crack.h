/* SPDX-License-Identifier: MIT
 *
 * Chains of cracks in the boundary pool.
 *
 * A boundary is walked clockwise on the screen: up along the left edges of
 * runs, over the top, down along the right edges.  Only its vertical cracks are
 * stored, one cell each: the column (0 .. width, the crack's, so a left edge of
 * pixel x is x and its right edge x + 1), the side, and the link to the next
 * cell.  What lies between two cells follows from them: after a left edge the
 * walk is at the row's top, after a right edge at its bottom, and there it goes
 * along the row to the column of the next cell.  The row follows too: from left
 * edge to left edge one up, from right to right one down, otherwise the same.
 *
 * While a component is open its chains begin and end at the sweep: each begins
 * (head) with the left edge of a run of the frontier and ends (tail) with the
 * right edge of one.  A tail's link is OCEL_NO_CELL.
 */
#ifndef OCEL_CRACK_H
#define OCEL_CRACK_H

#include <stdbool.h>
#include <stdint.h>

#include <ocellus/labeller.h>

/* No cell: the link of a chain's last cell, the head of a lost chain. */
#define OCEL_NO_CELL 0xFFFFU

/* Links are 16 bits without a sign, kept in the 16 bits of a coordinate.  C99
 * 6.3.1.3 leaves the conversion of the upper half to the implementation; all
 * that this library is built for document that it wraps.  One that does
 * otherwise fails to compile. */
typedef char ocel_assert_wrapping_t[((int16_t)(uint16_t)OCEL_NO_CELL == -1) ? 1 : -1];

static inline uint32_t ocel_crack_link(const ocel_crack_pool_t *pool, uint32_t at) {
    return (uint16_t)pool->cells[at].y_hpx;
}

static inline void ocel_crack_set_link(ocel_crack_pool_t *pool, uint32_t at, uint32_t link) {
    pool->cells[at].y_hpx = (int16_t)(uint16_t)link;
}

/* A cell's crack: its column, 0 .. OCEL_MAX_WIDTH <= 4096, and for a right edge
 * this flag. */
#define OCEL_CRACK_RIGHT 0x2000U

static inline void ocel_crack_set_left(ocel_crack_pool_t *pool, uint32_t at, uint32_t column) {
    pool->cells[at].x_hpx = (int16_t)column;
}

static inline void ocel_crack_set_right(ocel_crack_pool_t *pool, uint32_t at, uint32_t column) {
    pool->cells[at].x_hpx = (int16_t)(uint16_t)(column + OCEL_CRACK_RIGHT);
}

/* Two linked cells, the shortest chain there is. */
typedef struct {
    uint32_t head; /* OCEL_NO_CELL when the pool had no two cells left */
    uint32_t tail;
} ocel_crack_pair_t;

/* A pair when the free list has not two cells: of fresh ones, or of both. */
ocel_crack_pair_t ocel_crack_take_pair_slowly(ocel_crack_pool_t *pool, ocel_crack_ledger_t *ledger);

/* A chain from a left edge to a right edge of one row.  The first two cells of
 * the free list are linked already. */
static inline ocel_crack_pair_t ocel_crack_take_pair(ocel_crack_pool_t *pool,
                                                     ocel_crack_ledger_t *ledger) {
    ocel_crack_pair_t pair = {ledger->free, OCEL_NO_CELL};

    if (pair.head != OCEL_NO_CELL) {
        pair.tail = ocel_crack_link(pool, pair.head);
    }
    if (pair.tail != OCEL_NO_CELL) {
        ledger->free = (uint16_t)ocel_crack_link(pool, pair.tail);
        ocel_crack_set_link(pool, pair.tail, OCEL_NO_CELL);
    } else {
        pair = ocel_crack_take_pair_slowly(pool, ledger);
    }
    return pair;
}

/* Gives a whole chain back. */
static inline void ocel_crack_give(ocel_crack_pool_t *pool, ocel_crack_ledger_t *ledger,
                                   uint32_t head, uint32_t tail) {
    ocel_crack_set_link(pool, tail, ledger->free);
    ledger->free = (uint16_t)head;
}

/* Gives back a chain of which only the head is known (none: OCEL_NO_CELL).
 * Takes the time of its length; a cell is given back once, so all these walks
 * together are no longer than what was taken. */
void ocel_crack_give_from(ocel_crack_pool_t *pool, ocel_crack_ledger_t *ledger, uint32_t head);

/* The cracks of a closed boundary. */
typedef struct {
    uint32_t vertical; /* one a cell */
    uint32_t total;    /* at most OCEL_MAX_CRACKS * (1 + OCEL_MAX_WIDTH) < 2^29 */
} ocel_crack_count_t;

/* Counts the cracks of the closed boundary that is the chain from `head`. */
ocel_crack_count_t ocel_crack_count(const ocel_crack_pool_t *pool, uint32_t head);

/* Boundary points in the pool: `count` cells from `first` on. */
typedef struct {
    uint32_t first;
    uint32_t count;
    uint32_t stride; /* every stride-th crack; 0: there was no room for any */
} ocel_crack_points_t;

/* Writes the boundary that is the closed chain from `head`, a left edge in the
 * row `bottom`, as crack midpoints in order: beside all cells that have been
 * used when that many never were; otherwise over all but the chain's own, which
 * it moves to the pool's end, and only every stride-th, the smallest stride for
 * which the points fit.  Never more than OCEL_MAX_FIT_POINTS. */
ocel_crack_points_t ocel_crack_unroll(ocel_crack_pool_t *pool, const ocel_crack_ledger_t *ledger,
                                      uint32_t head, uint32_t bottom);

#endif
