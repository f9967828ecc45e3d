/* SPDX-License-Identifier: MIT
 *
 * The frontier's runs and the components that they belong to.
 */
#include "frontier.h"

#include <stdbool.h>

#include "component.h"
#include "crack.h"

/* ---- Labels: sets of those that have met in this row ---- */

/* Labels given a new root for a union, over a row.  The smaller set goes to the larger one,
 * so that a label's set doubles each time: a set of m takes m - 1 unions and at most
 * m / 2 * log2(m) moves. */
#if OCEL_MAX_LABELS <= 240
#define MOVES 4
#else
#define MOVES 6
#endif

/* A new label with one run; labeller.h proves that there is one. */
static inline uint32_t take_label(ocel_labeller_t *lab) {
    uint32_t label = lab->free_label;

    if (label != OCEL_NO_LABEL) {
        lab->free_label = lab->live[label];
    } else {
        label = lab->stats.labels_max;
        lab->stats.labels_max++;
    }
    lab->root[label] = (uint16_t)label;
    lab->peer[label] = (uint16_t)label;
    lab->live[label] = 1U;
    return label;
}

static inline void give_label(ocel_labeller_t *lab, uint32_t label) {
    lab->live[label] = lab->free_label;
    lab->free_label = (uint16_t)label;
}

/* Labels in the set of a root.  Of two or more the first behind the root has no sums of
 * its own any more: where its area was is their number. */
static inline uint32_t set_size(const ocel_labeller_t *lab, uint32_t root) {
    const uint32_t first = lab->peer[root];

    return (first == root) ? 1U : lab->component[first].area;
}

/* Gives the labels of the set of `part` the other root, and its ring to that one's. */
static inline void move_set(ocel_labeller_t *lab, uint32_t root, uint32_t part) {
    uint32_t label = part;
    uint32_t last;

    do { /* bound: OCEL_MAX_LABELS; MOVES a time in a call of ocel_sweep_row */
        lab->root[label] = (uint16_t)root;
        last = label;
        label = lab->peer[label];
    } while (label != part);
    lab->peer[last] = lab->peer[root];
    lab->peer[root] = (uint16_t)part;
}

uint32_t ocel_frontier_unite(ocel_labeller_t *lab, uint32_t a, uint32_t b) {
    const uint32_t live_a = lab->live[a] & ~OCEL_LOST;
    const uint32_t live_b = lab->live[b] & ~OCEL_LOST;
    const uint32_t lost = (lab->live[a] | lab->live[b]) & OCEL_LOST;
    const uint32_t size_a = set_size(lab, a);
    const uint32_t size_b = set_size(lab, b);
    const uint32_t root = (size_a >= size_b) ? a : b;
    const uint32_t part = (size_a >= size_b) ? b : a;

    ocel_component_merge(&lab->component[root], &lab->component[part]);
    move_set(lab, root, part);
    lab->component[part].area = size_a + size_b;
    lab->live[root] = (uint16_t)((live_a + live_b) | lost);
    lab->live[part] = lab->merged_label;
    lab->merged_label = (uint16_t)part;
    lab->stats.unions++;
    return root;
}

void ocel_frontier_release(ocel_labeller_t *lab) {
    const uint32_t newest = lab->merged_label;
    uint32_t label = newest;
    uint32_t oldest = OCEL_NO_LABEL;

    while (label != OCEL_NO_LABEL) { /* bound: OCEL_MAX_LABELS */
        const uint32_t root = lab->root[label];

        lab->peer[root] = (uint16_t)root;
        oldest = label;
        label = lab->live[label];
    }
    if (oldest != OCEL_NO_LABEL) {
        lab->live[oldest] = lab->free_label;
        lab->free_label = (uint16_t)newest;
        lab->merged_label = OCEL_NO_LABEL;
    }
}

/* ---- Runs ---- */

void ocel_frontier_set(ocel_labeller_t *lab, const ocel_run_t *first, ocel_run_t *last) {
    const ptrdiff_t first_run = first - lab->frontier;
    const ptrdiff_t last_run = last - lab->frontier;

    last->start = OCEL_ROW_END;
    last->end = OCEL_ROW_END;
    last->label = OCEL_NO_LABEL;
    lab->first_run = (uint16_t)first_run;
    lab->last_run = (uint16_t)last_run;
}

void ocel_frontier_lose(ocel_labeller_t *lab, ocel_crack_pool_t *pool, uint32_t root,
                        uint32_t chain) {
    /* at most: 1; 2 * OCEL_MAX_HEIGHT * OCEL_MAX_RUNS as taken in a call of ocel_eye_frame */
    lab->live[root] |= OCEL_LOST;
    /* at most: 1; OCEL_MAX_RUNS as losses in a call of ocel_sweep_row or ocel_sweep_repeat;
     * 2 * OCEL_MAX_HEIGHT * OCEL_MAX_RUNS as taken in a call of ocel_eye_frame */
    ocel_crack_give_from(pool, &lab->ledger, chain);
}

uint32_t ocel_frontier_settle(ocel_labeller_t *lab, ocel_crack_pool_t *pool, ocel_run_t *run) {
    const uint32_t end = (uint32_t)run->end - lab->reach;
    const uint32_t root = take_label(lab);
    const ocel_crack_pair_t pair = ocel_frontier_take_edges(lab, pool, run->start, end);

    if (pair.head == OCEL_NO_CELL) {
        /* at most: 1; OCEL_MAX_RUNS as losses in a call of ocel_sweep_row or ocel_sweep_repeat */
        lab->live[root] |= OCEL_LOST;
    }

    /* at most: 1; OCEL_MAX_RUNS as olds in a call of ocel_sweep_row;
     * 3 * OCEL_MAX_RUNS as born in a call of ocel_label_row;
     * 2 * OCEL_MAX_RUNS as born in a call of ocel_label_end;
     * OCEL_MAX_HEIGHT * OCEL_MAX_RUNS as runs in a call of ocel_eye_frame;
     * OCEL_MAX_HEIGHT * OCEL_MAX_RUNS as places in a call of ocel_eye_frame;
     * OCEL_MAX_HEIGHT * OCEL_MAX_RUNS as sums in a call of ocel_eye_frame;
     * OCEL_MAX_RUNS as absorbed in a call of ocel_label_row through sweep_asked;
     * OCEL_MAX_RUNS as next in a call of ocel_label_row through sweep_asked;
     * 2 * OCEL_MAX_RUNS as absorbed in a call of ocel_label_end;
     * OCEL_MAX_HEIGHT * OCEL_MAX_RUNS as absorbed in a call of ocel_eye_frame */
    run->label = (uint16_t)root;
    run->head = (uint16_t)pair.head;
    run->tail = (uint16_t)pair.tail;
    ocel_component_start(&lab->component[root], run->start, end, (uint32_t)lab->swept - 1U);
    return root;
}

/* The component has ended above the row in hand.  Its boundary goes from head to
 * tail; head is OCEL_NO_CELL when it is lost. */
static void end_component(ocel_labeller_t *lab, ocel_crack_pool_t *pool, uint32_t root,
                          uint32_t head, uint32_t tail, ocel_ended_t *ended) {
    const ocel_component_t *component = &lab->component[root];
    const uint32_t bottom = lab->swept - 1U;
    ocel_crack_pair_t given = {head, tail}; /* the boundary that is not the largest's */

    lab->stats.components++;
    if (ended->blob != NULL) {
        /* at most: 1; 0 in a call of ocel_eye_row or ocel_eye_line or ocel_eye_frame or
         * ocel_eye_end */
        ocel_component_blob(component, bottom, lab->width, lab->height, &ended->blob[ended->count]);
        ended->count++;
    }
    if (ocel_component_beats(component, &lab->best)) {
        given.head = lab->best_head;
        given.tail = lab->best_tail;
        lab->best = *component;
        lab->best_bottom = (uint16_t)bottom;
        lab->best_head = (uint16_t)head;
        lab->best_tail = (uint16_t)tail;
    }
    if (given.head != OCEL_NO_CELL) {
        ocel_crack_give(pool, &lab->ledger, given.head, given.tail);
    }
    give_label(lab, root);
}

/* A run above has no child: its component ends with it, or its two edges are
 * linked. */
static void end_run(ocel_labeller_t *lab, ocel_crack_pool_t *pool, ocel_run_t *run,
                    ocel_ended_t *ended) {
    const uint32_t root = ocel_frontier_root(lab, pool, run);
    const uint32_t live = (uint32_t)lab->live[root] - 1U;
    const uint32_t tail = run->tail;
    uint32_t head = run->head;

    lab->live[root] = (uint16_t)live;
    if (live >= OCEL_LOST) {
        ocel_crack_give_from(pool, &lab->ledger, head);
        head = OCEL_NO_CELL;
    }
    if ((live & ~OCEL_LOST) == 0U) {
        /* at most: 1; OCEL_MAX_HEIGHT * OCEL_MAX_RUNS as labels in a call of ocel_eye_frame;
         * OCEL_MAX_HEIGHT * OCEL_MAX_RUNS as lives in a call of ocel_eye_frame;
         * OCEL_MAX_RUNS as labels in a call of ocel_sweep_row;
         * 2 * OCEL_MAX_RUNS as labels in a call of ocel_label_row;
         * 2 * OCEL_MAX_RUNS as labels in a call of ocel_label_end */
        end_component(lab, pool, root, head, tail, ended);
    } else if (head != OCEL_NO_CELL) {
        ocel_crack_set_link(pool, tail, head);
    } else {
        /* Lost: there is nothing to link. */
    }
}

/* True when a newborn run can end without having been anything: nobody asks for
 * it, and it is no larger than the best, which then came before it in raster
 * order: what has ended by now has a run before it in the row above or higher. */
static inline bool is_noise(const ocel_labeller_t *lab, const ocel_run_t *run,
                            const ocel_ended_t *ended) {
    return (run->label == OCEL_NEWBORN) && (ended->blob == NULL) &&
           (((uint32_t)run->end - lab->reach - run->start) <= lab->best.area);
}

ocel_run_t *ocel_frontier_end(ocel_labeller_t *lab, ocel_crack_pool_t *pool, ocel_run_t *run,
                              uint32_t start, ocel_ended_t *ended) {
    ocel_run_t *at = run;

    /* bound: OCEL_MAX_RUNS; OCEL_MAX_RUNS as parents in a call of ocel_sweep_row;
     * OCEL_MAX_RUNS as columns in a call of ocel_sweep_row;
     * OCEL_MAX_RUNS as heirs in a call of ocel_sweep_row;
     * (OCEL_MAX_HEIGHT + 1) * OCEL_MAX_RUNS as fates in a call of ocel_eye_frame */
    do {
        if (is_noise(lab, at, ended)) {
            lab->stats.components++;
        } else {
            end_run(lab, pool, at, ended);
        }
        at = ocel_frontier_after(lab, at);
    } while (at->end <= start);
    return at;
}
