/* SPDX-License-Identifier: MIT
 *
 * The sweep: one pass over the rows, one chain of cracks for each boundary.
 * labeller.h derives the sizes, crack.h tells what a chain is.
 *
 * Each run C of a row, from left to right, meets the runs of the row above that
 * it touches, its parents P, in order.  A run above has two loose threads at its
 * lower corners: the head of a chain, its left edge, and the tail of one, its
 * right edge.  All that can happen to them:
 *
 *   C's first parent has no child yet   C's left edge is linked to P's head
 *   ... has one, the run before C       P splits: C's left edge is linked to that
 *                                       run's right edge, and a chain begins:
 *                                       background enters between the two
 *   C has one more parent               the gap between the two parents closes:
 *                                       the left one's tail is linked to the
 *                                       right one's head
 *   C's last parent                     its tail is linked to C's right edge, once
 *                                       the next run turns out not to be its child
 *   C has no parent                     its left edge is linked to its right edge
 *   P has no child                      its tail is linked to its head
 *
 * Where a tail is linked to a head, is that the same chain, which then is
 * closed?  The labels say.  A gap that closes between two parents of one
 * component has been walled in by it all along: a hole, whose chain is given
 * back at once.  Between two components it never is.  And P without a child ends
 * its component when no other run of it is left in the frontier; then the chain
 * is the outer boundary, for nothing else is open.  So a chain's ends need not
 * know each other, and a run that goes straight down touches two cells only.
 *
 * What is still needed of a parent that has been taken off the frontier, how far
 * it reaches and its tail, the sweep holds: that can only be the last parent of
 * the run finished last.
 *
 * Of a row there are three passes: the columns of its edges are written down, a
 * few words at a time, its runs meet those above, and its pixels are added to
 * their components.  None of them has much to keep in mind, so that it stays in
 * registers; and the last adds neighbours of one component together.
 *
 * When the pool is exhausted the component that asked is lost: it goes on
 * without cells, and so does what it is merged with.  A chain that it had is
 * given back when the run that holds its head is come upon next.
 */
#include "sweep.h"

#include <stdbool.h>
#include <stddef.h>

#include "../base/int_math.h"
#include "component.h"
#include "crack.h"
#include "run.h"
#include "sums.h"

/* Words of a row whose runs are found in one go. */
#define CHUNK_WORDS 4U

/* Where the sweep stands in the row. */
typedef struct {
    ocel_run_t *parent; /* the first run above that is not above the finished runs only */
    ocel_run_t *child;  /* the place for the run in hand */
    uint32_t root;      /* the component of the run in hand, or else of the run before */
    uint32_t reach_end; /* its last parent touches runs that start before; 0: no parent */
    uint32_t tail;      /* that parent's tail, not linked yet to ... */
    uint32_t right;     /* ... the right edge of the run before; OCEL_NO_CELL: none */
    uint32_t reach;     /* the labeller's */
} sweep_t;

/* ---- The run in hand ---- */

/* The run before the one in hand was the last child of its last parent: now
 * that parent's tail is linked to its right edge. */
static inline void link_right(ocel_crack_pool_t *pool, const sweep_t *s) {
    if (s->right != OCEL_NO_CELL) {
        ocel_crack_set_link(pool, s->tail, s->right);
    }
}

/* Takes the next run above as the last parent of the run in hand. */
static inline void take_parent(ocel_labeller_t *lab, sweep_t *s) {
    s->reach_end = s->parent->end;
    s->tail = s->parent->tail;
    s->parent = ocel_frontier_after(lab, s->parent);
}

/* The run in hand has one more parent: the gap between it and the one before
 * closes. */
static inline void absorb_parent(ocel_labeller_t *lab, ocel_crack_pool_t *pool, sweep_t *s) {
    const uint32_t other = ocel_frontier_root(lab, pool, s->parent);
    const uint32_t head = s->parent->head;
    const bool is_hole = s->root == other;

    if (!is_hole) {
        /* at most: OCEL_MAX_RUNS in a call of ocel_sweep_row or ocel_label_end;
         * OCEL_MAX_HEIGHT * OCEL_MAX_RUNS as labels in a call of ocel_eye_frame;
         * OCEL_MAX_RUNS as labels in a call of ocel_sweep_row;
         * 2 * OCEL_MAX_RUNS as labels in a call of ocel_label_row;
         * 2 * OCEL_MAX_RUNS as labels in a call of ocel_label_end;
         * OCEL_MAX_HEIGHT * OCEL_MAX_RUNS as united in a call of ocel_eye_frame;
         * OCEL_MAX_HEIGHT * OCEL_MAX_RUNS as lives in a call of ocel_eye_frame;
         * (OCEL_MAX_HEIGHT + 1) * OCEL_MAX_RUNS as fates in a call of ocel_eye_frame */
        s->root = ocel_frontier_unite(lab, s->root, other);
    }
    lab->live[s->root]--;
    if (lab->live[s->root] >= OCEL_LOST) {
        if (head != OCEL_NO_CELL) {
            /* at most: OCEL_MAX_RUNS as losses in a call of ocel_sweep_row or ocel_sweep_repeat */
            ocel_crack_give_from(pool, &lab->ledger, head);
        }
    } else if (is_hole) {
        ocel_crack_give(pool, &lab->ledger, head, s->tail);
    } else {
        ocel_crack_set_link(pool, s->tail, head);
    }
    take_parent(lab, s);
}

/* The run in hand has a parent; its left edge is to be linked to the cell
 * `after`. */
static inline void continue_component(ocel_labeller_t *lab, ocel_crack_pool_t *pool, sweep_t *s,
                                      uint32_t start, uint32_t end, uint32_t after) {
    const uint32_t touch_end = end + s->reach;
    ocel_crack_pair_t pair = {OCEL_NO_CELL, OCEL_NO_CELL};

    /* bound: OCEL_MAX_RUNS; OCEL_MAX_RUNS as parents in a call of ocel_sweep_row;
     * OCEL_MAX_RUNS in a call of ocel_label_end */
    while ((touch_end > s->reach_end) && (s->parent->start < touch_end)) {
        /* at most: 1; OCEL_MAX_RUNS + OCEL_MAX_RUNS / 2 as joins in a call of ocel_sweep_row;
         * OCEL_MAX_RUNS as absorbed in a call of ocel_label_row through ocel_specks_sweep;
         * 2 * OCEL_MAX_RUNS as absorbed in a call of ocel_label_end;
         * OCEL_MAX_HEIGHT * OCEL_MAX_RUNS as absorbed in a call of ocel_eye_frame;
         * OCEL_MAX_HEIGHT * OCEL_MAX_RUNS as united in a call of ocel_eye_frame */
        absorb_parent(lab, pool, s);
    }
    if ((lab->live[s->root] < OCEL_LOST) || (after != OCEL_NO_CELL)) {
        pair = ocel_frontier_continue(lab, pool, s->root, start, end, after);
    }
    s->right = pair.tail;
    s->child->label = (uint16_t)s->root;
    /* at most: OCEL_MAX_RUNS as columns in a call of ocel_sweep_row;
     * OCEL_MAX_RUNS in a call of ocel_label_end;
     * 3 * OCEL_MAX_RUNS as born in a call of ocel_label_row;
     * 2 * OCEL_MAX_RUNS as born in a call of ocel_label_end;
     * OCEL_MAX_HEIGHT * OCEL_MAX_RUNS as runs in a call of ocel_eye_frame;
     * OCEL_MAX_HEIGHT * OCEL_MAX_RUNS as labels in a call of ocel_eye_frame;
     * OCEL_MAX_RUNS as next in a call of ocel_label_row through ocel_specks_sweep;
     * 2 * OCEL_MAX_RUNS as labels in a call of ocel_label_row through ocel_specks_sweep;
     * 2 * OCEL_MAX_RUNS as labels in a call of ocel_label_end;
     * (OCEL_MAX_HEIGHT + 1) * OCEL_MAX_RUNS as fates in a call of ocel_eye_frame */
    s->child->head = (uint16_t)pair.head;
    s->child->tail = (uint16_t)pair.tail;
}

/* Takes the run [start, end). */
static inline void sweep_run(ocel_labeller_t *lab, ocel_crack_pool_t *pool, sweep_t *s,
                             uint32_t start, uint32_t end, ocel_ended_t *ended) {
    const uint32_t touch_end = end + s->reach;
    uint32_t after = s->right;
    bool has_parent = true;

    if (start < s->reach_end) {
        lab->live[s->root]++;
    } else {
        link_right(pool, s);
        if (s->parent->end <= start) {
            s->parent = ocel_frontier_end(lab, pool, s->parent, start, ended);
        }
        has_parent = s->parent->start < touch_end;
        if (has_parent) {
            s->root = ocel_frontier_root(lab, pool, s->parent);
            /* at most: OCEL_MAX_RUNS as parents in a call of ocel_sweep_row */
            after = s->parent->head;
            take_parent(lab, s);
        }
    }
    if (has_parent) {
        continue_component(lab, pool, s, start, end, after);
    } else {
        s->child->label = OCEL_NEWBORN;
        s->right = OCEL_NO_CELL;
        s->reach_end = 0U;
    }
    s->child->start = (uint16_t)start;
    s->child->end = (uint16_t)touch_end;
    s->child = ocel_frontier_after(lab, s->child);
}

/* ---- The row ---- */

/* Writes the columns at which pixels from word `first` up to word `end` differ
 * from their left neighbours.  Returns where the next one would go. */
static inline uint16_t *find_edges(const uint32_t *row, uint32_t first, uint32_t end,
                                   uint16_t *edge) {
    uint16_t *at = edge;

    /* bound: CHUNK_WORDS; OCEL_ROW_WORDS + 1 in a call of ocel_sweep_row */
    for (uint32_t k = first; k < end; k += OCEL_RUN_WORDS) {
        const ocel_word_t word = ocel_run_load(&row[k + 1U]);
        ocel_word_t bits = word ^ ((word << 1U) | (row[k] >> 31U));

        /* bound: OCEL_WORD_BITS; 2 * OCEL_MAX_RUNS in a call of ocel_sweep_row;
         * 2 * OCEL_MAX_RUNS in a call of ocel_label_end */
        while (bits != 0U) {
            *at = (uint16_t)((k << 5U) + ocel_run_lowest(bits));
            at = &at[1];
            bits &= bits - 1U;
        }
    }
    return at;
}

/* Takes the row's runs from left to right; they become the frontier.  The state is this
 * function's own, so that it stays in registers. */
static void sweep_runs(ocel_labeller_t *lab, ocel_crack_pool_t *pool, ocel_ended_t *ended) {
    const ocel_bit_row_t *const row = &lab->rows[lab->above];
    const uint32_t words = (uint32_t)row->end + 1U; /* a run may end in the next one's bit 0 */
    ocel_run_t *const first = ocel_frontier_after(lab, &lab->frontier[lab->last_run]);
    sweep_t s = {
        &lab->frontier[lab->first_run], first, 0U, 0U, OCEL_NO_CELL, OCEL_NO_CELL, lab->reach};
    uint16_t edge[(32U * CHUNK_WORDS) + 1U];
    uint32_t runs = 0U;
    uint32_t open = 0U; /* 1: edge[0] is the start of a run that has not ended yet */

    /* bound: (OCEL_ROW_WORDS + CHUNK_WORDS) / CHUNK_WORDS */
    for (uint32_t k = row->first; k < words; k += CHUNK_WORDS) {
        const uint32_t rest = words - k;
        const uint32_t end = k + ((rest < CHUNK_WORDS) ? rest : CHUNK_WORDS);
        const uint16_t *const past = find_edges(row->word, k, end, &edge[open]);
        const uint16_t *at = edge;

        /* bound: OCEL_MAX_RUNS in all rounds of the outer loop; OCEL_MAX_RUNS in a call of
         * ocel_label_end */
        while (&at[1] < past) {
            sweep_run(lab, pool, &s, at[0], at[1], ended);
            at = &at[2];
            runs++;
        }
        open = (at < past) ? 1U : 0U;
        edge[0] = at[0];
    }
    link_right(pool, &s);
    if (s.parent->end != OCEL_ROW_END) {
        (void)ocel_frontier_end(lab, pool, s.parent, OCEL_ROW_END - 1U, ended);
    }
    ocel_frontier_set(lab, first, s.child);
    lab->runs = (uint16_t)runs;
}

void ocel_sweep_row(ocel_labeller_t *lab, ocel_crack_pool_t *pool, const uint32_t *holes,
                    ocel_ended_t *ended) {
    if (lab->repeats.count != 0U) {
        /* at most: 1; 1 in a call of ocel_label_row or ocel_label_end;
         * OCEL_MAX_HEIGHT as rows in a call of ocel_eye_frame */
        ocel_sums_add_repeats(lab);
    }
    sweep_runs(lab, pool, ended);
    ocel_frontier_release(lab);
    ocel_sums_add_row(lab, holes);
    lab->stats.runs += lab->runs;
    lab->swept++;
    lab->repeats_lost = 0U;
}

/* The runs above go straight down.  Returns true when all are lost and nothing is
 * left to give back. */
static bool repeat_runs(ocel_labeller_t *lab, ocel_crack_pool_t *pool) {
    ocel_run_t *run = &lab->frontier[lab->first_run];
    bool lost = true;

    /* bound: OCEL_MAX_RUNS;
     * OCEL_MAX_HEIGHT * OCEL_MAX_RUNS as runs in a call of ocel_eye_frame;
     * OCEL_MAX_HEIGHT * OCEL_MAX_RUNS as labels in a call of ocel_eye_frame */
    while (run->end != OCEL_ROW_END) {
        const uint32_t root = ocel_frontier_root(lab, pool, run);

        if ((lab->live[root] < OCEL_LOST) || (run->head != OCEL_NO_CELL)) {
            const ocel_crack_pair_t pair = ocel_frontier_continue(
                lab, pool, root, run->start, (uint32_t)run->end - lab->reach, run->head);

            if (pair.tail != OCEL_NO_CELL) {
                ocel_crack_set_link(pool, run->tail, pair.tail);
            }
            run->head = (uint16_t)pair.head;
            run->tail = (uint16_t)pair.tail;
            lost = false;
        }
        run = ocel_frontier_after(lab, run);
    }
    return lost;
}

void ocel_sweep_repeat(ocel_labeller_t *lab, ocel_crack_pool_t *pool) {
    if (lab->repeats_lost == 0U) {
        lab->repeats_lost = repeat_runs(lab, pool) ? 1U : 0U;
    }
    lab->stats.runs += lab->runs;
    ocel_rows_add(&lab->repeats, lab->swept);
    lab->swept++;
}
