/* SPDX-License-Identifier: MIT
 *
 * The frontier's runs and the components that they belong to: labels and what
 * happens to them apart from the sweep, when runs are born, meet and end.
 */
#ifndef OCEL_FRONTIER_H
#define OCEL_FRONTIER_H

#include <stddef.h>
#include <stdint.h>

#include <ocellus/labeller.h>
#include <ocellus/types.h>

#include "crack.h"

/* What can happen together.  The bounds beside the loops of this stage count events in
 * groups; n is OCEL_MAX_RUNS, so a row has at most 2 n + 1 columns with the one behind it.
 * In a sweep over a row:
 *
 *   parents  Each run above is a run's first parent, or absorbed by one, or ends: n.
 *   columns  Runs above that end and runs with a parent: n.  Of each choose a column: of
 *            the one any; of the other one in which its parent is above it, or, where
 *            corners touch, any.  No two of these are neighbours.
 *   heirs    Sums of the row, one at most for a run with a parent, and runs above that
 *            end: n.
 *   places   A run with h filled holes takes 2 h + 2 columns, so runs and holes: n.
 *   olds     A repeated row has no newborn run, so runs above that are added for it and
 *            runs above that are settled: n.
 *   joins    Sums begin at a run's first parent, or where a run without one of its own
 *            comes to a larger set of labels.  Such a set has met before, so its first
 *            parents are others: sums and what is absorbed are n + n / 2.
 *   losses   A component is lost once, and a chain that is given back is of a run above:
 *            n.
 *   cells    Cells of chains that are walked, but for one a walk that is new, and cells
 *            taken that were never used are different ones.  With a cell too few for n
 *            times and none for n: OCEL_MAX_CRACKS + 3 n.
 *
 * In a frame of h rows, and in the last sweep, over nothing.  Of a row's runs K have a parent
 * and N have none, A parents are absorbed and E runs above end; U unions and the ends of
 * components end labels, each of which was settled, S, and had been an N of the row before.
 * A run that absorbs a parents spans the gaps between them, a columns and one behind it at
 * the least.
 *
 *   runs      K + N is n at most, or the row repeats the one above and its runs are counted
 *             then: with S for N, h n.  places, sums: h n by the same division.
 *   lives     places with U and ends for S: h n.  labels: K with U and ends, the same.
 *   absorbed  A + N is n at most: with S for N, h n.  united: with U for S, the same.
 *   fates     With 4-connectivity E + K + A is n at most, as each touch of a run and a parent
 *             has a column of its own, and U counts among A.  With 8-connectivity it is
 *             N + K + E, and U counts among N.  So E + K + U: (h + 1) n.
 *   rows      Rows are swept over, or repeat one and are added later: h.
 *   taken     Two cells are taken at most for a run with a parent and one that is settled,
 *             and none for one that is lost: cells that are walked, walks, and what is lost
 *             twice, 2 h n.
 *
 * A call of ocel_label_row that is asked what has ended sweeps over two rows, of which only
 * the first may be repeated; one of ocel_label_end over one and over nothing.  So K and A of
 * the first with S of the second are n each (next, absorbed), U and ends with K of the first
 * 2 n (labels), and K, S and repeats 3 n and 2 n (born). */

/* No label: ends the lists of free and of merged labels. */
#define OCEL_NO_LABEL 0x7FFFU

/* The label of a run that is a component by itself so far.  It has neither a
 * label nor sums nor cells until it meets a child: most of what noise consists
 * of never does.  It is the root of itself alone. */
#define OCEL_NEWBORN ((uint32_t)OCEL_MAX_LABELS)

/* Flag in live[]: at a root, the boundary is lost (the count itself is at most
 * OCEL_MAX_RUNS + 1 <= 2049). */
#define OCEL_LOST 0x8000U

/* The columns of the place that ends a row: beyond every column and every reach. */
#define OCEL_ROW_END 0xFFFFU

/* Where components that end are reported; blob is null when nobody asks. */
typedef struct {
    ocel_blob_t *blob;
    size_t count;
} ocel_ended_t;

/* The place after that of a run, in the ring. */
static inline ocel_run_t *ocel_frontier_after(ocel_labeller_t *lab, ocel_run_t *run) {
    ocel_run_t *const next = &run[1];

    return (next == &lab->frontier[OCEL_FRONTIER_RUNS]) ? lab->frontier : next;
}

/* Makes the frontier the places from `first` up to `last`, which ends the row: it
 * touches nothing. */
void ocel_frontier_set(ocel_labeller_t *lab, const ocel_run_t *first, ocel_run_t *last);

/* Loses a component's boundary and gives back a chain of it (none: OCEL_NO_CELL). */
void ocel_frontier_lose(ocel_labeller_t *lab, ocel_crack_pool_t *pool, uint32_t root,
                        uint32_t chain);

/* A chain of the edges of a run [start, end), from the left one to the right one; without
 * a cell when there are none left. */
static inline ocel_crack_pair_t ocel_frontier_take_edges(ocel_labeller_t *lab,
                                                         ocel_crack_pool_t *pool, uint32_t start,
                                                         uint32_t end) {
    const ocel_crack_pair_t pair = ocel_crack_take_pair(pool, &lab->ledger);

    if (pair.head != OCEL_NO_CELL) {
        ocel_crack_set_left(pool, pair.head, start);
        ocel_crack_set_right(pool, pair.tail, end);
    }
    return pair;
}

/* The edges of a run [start, end) of a component that goes on: the left one is linked to
 * the cell `after`, which a component that is not lost always has.  If it is lost, or is
 * now for want of cells, there are none and the chain from `after` is given back. */
static inline ocel_crack_pair_t ocel_frontier_continue(ocel_labeller_t *lab,
                                                       ocel_crack_pool_t *pool, uint32_t root,
                                                       uint32_t start, uint32_t end,
                                                       uint32_t after) {
    ocel_crack_pair_t pair = {OCEL_NO_CELL, OCEL_NO_CELL};

    if (lab->live[root] < OCEL_LOST) {
        pair = ocel_frontier_take_edges(lab, pool, start, end);
    }
    if (pair.head != OCEL_NO_CELL) {
        ocel_crack_set_link(pool, pair.head, after);
    } else {
        ocel_frontier_lose(lab, pool, root, after);
    }
    return pair;
}

/* A newborn run of the row above gets what a component has, a label, its sums and its
 * edges; lost at once when there are no cells.  Returns the label. */
uint32_t ocel_frontier_settle(ocel_labeller_t *lab, ocel_crack_pool_t *pool, ocel_run_t *run);

/* The root of a run. */
static inline uint32_t ocel_frontier_root(ocel_labeller_t *lab, ocel_crack_pool_t *pool,
                                          ocel_run_t *run) {
    const uint32_t root = lab->root[run->label];

    return (root != OCEL_NEWBORN) ? root : ocel_frontier_settle(lab, pool, run);
}

/* Merges two components, the one with fewer pixels into the other; lost if one
 * was.  Returns the root. */
uint32_t ocel_frontier_unite(ocel_labeller_t *lab, uint32_t a, uint32_t b);

/* At the row's end: frees the labels that were merged away in it.  Until they are
 * taken again parent[] tells the root of each. */
void ocel_frontier_release(ocel_labeller_t *lab);

/* Ends the runs above, from `run` on, that touch nothing from column `start` on: they
 * have no child, and `run` is one of them.  Returns the first that does. */
ocel_run_t *ocel_frontier_end(ocel_labeller_t *lab, ocel_crack_pool_t *pool, ocel_run_t *run,
                              uint32_t start, ocel_ended_t *ended);

#endif
