/* SPDX-License-Identifier: MIT
 *
 * Labelling: one pass over the rows, one chain of cracks for each boundary.
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
 *   C's last parent                     its tail is linked to C's right edge; if
 *                                       C was not its last child, the next one
 *                                       links it again, to its own right edge
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
 * A child takes its parent's place in the frontier; a second child makes a place
 * and a second parent gives its own up.  What is still needed of a parent whose
 * place is taken, how far it reaches and its tail, the sweep holds: that can
 * only be the parent of the run finished last.
 *
 * When the pool is exhausted the component that asked is lost: it goes on
 * without cells, and so does what it is merged with.  A chain that it had is
 * given back when the run that holds its head is come upon next.
 */
#include <ocellus/label.h>

#include "component.h"
#include "crack.h"
#include "int_math.h"
#include "run.h"

/* No label: ends the lists of free and of merged labels. */
#define NO_LABEL 0x7FFFU

/* The label of a run that is a component by itself so far.  It has neither a
 * label nor sums nor cells until it meets a child: most of what noise consists
 * of never does. */
#define NEWBORN 0x7FFEU

/* Flag in live[]: at a root, the boundary is lost (the count itself is at most
 * OCEL_MAX_RUNS + 1 <= 2049); set at labels merged away, too, so that one test
 * finds whatever is out of the ordinary.  Also in a mark, which is a root with
 * the flag of its component. */
#define LOST 0x8000U

/* The place in the frontier that is before its first run and after its last. */
#define LIST_END 0U

/* The labeller's states: values that memory which was never initialised is
 * unlikely to hold. */
#define STATE_NONE 0U
#define STATE_ROWS 0x0CE1U
#define STATE_ENDED 0x0CE2U
#define STATE_UNROLLED 0x0CE3U

/* Where components that end are reported; blob is null when nobody asks. */
typedef struct {
    ocel_blob_t *blob;
    size_t count;
} ended_list_t;

/* Where the sweep stands in the row. */
typedef struct {
    uint32_t prev;        /* the run finished last, or LIST_END */
    uint32_t mark;        /* its component, when it has a parent */
    uint32_t reach_end;   /* its last parent touches runs that start before; 0: no parent */
    uint32_t parent_tail; /* that parent's tail, unless lost */
    uint32_t right;       /* the cell for the right edge of the run in hand, or OCEL_NO_CELL */
    ocel_component_t *sums;
} sweep_t;

/* ---- Labels: union-find ---- */

/* The root of a label, halving the way to it (Tarjan and van Leeuwen, "Worst-case
 * analysis of set union algorithms", 1984).  Merged labels are resolved at the
 * end of each row, so there is a way only within a row. */
static uint32_t find_root(ocel_labeller_t *lab, uint32_t label) {
    uint32_t at = label;

    while (lab->parent[at] != at) { /* bound: OCEL_MAX_LABELS */
        lab->parent[at] = lab->parent[lab->parent[at]];
        at = lab->parent[at];
    }
    return at;
}

static inline uint32_t root_of(ocel_labeller_t *lab, uint32_t label) {
    return (lab->parent[label] == label) ? label : find_root(lab, label);
}

static inline uint32_t mark_of(const ocel_labeller_t *lab, uint32_t root) {
    return root | (lab->live[root] & LOST);
}

/* A new label with one run; labeller.h proves that there is one. */
static inline uint32_t take_label(ocel_labeller_t *lab) {
    uint32_t label = lab->free_label;

    if (label != NO_LABEL) {
        lab->free_label = lab->parent[label];
    } else {
        label = lab->stats.labels_max;
        lab->stats.labels_max++;
    }
    lab->parent[label] = (uint16_t)label;
    lab->live[label] = 1U;
    return label;
}

static inline void give_label(ocel_labeller_t *lab, uint32_t label) {
    lab->parent[label] = lab->free_label;
    lab->free_label = (uint16_t)label;
}

/* Merges two components, the one with fewer runs in the frontier into the other;
 * lost if one was.  Returns the root. */
static uint32_t unite(ocel_labeller_t *lab, uint32_t a, uint32_t b) {
    const uint32_t live_a = lab->live[a] & ~LOST;
    const uint32_t live_b = lab->live[b] & ~LOST;
    const uint32_t lost = (lab->live[a] | lab->live[b]) & LOST;
    const uint32_t root = (live_a >= live_b) ? a : b;
    const uint32_t part = (live_a >= live_b) ? b : a;

    ocel_component_merge(&lab->component[root], &lab->component[part]);
    lab->live[root] = (uint16_t)((live_a + live_b) | lost);
    lab->parent[part] = (uint16_t)root;
    lab->live[part] = (uint16_t)(lab->merged_label | LOST);
    lab->merged_label = (uint16_t)part;
    lab->stats.unions++;
    return root;
}

/* At the row's end: gives every run its root, then frees the merged labels. */
static void release_merged(ocel_labeller_t *lab) {
    ocel_frontier_t *f = &lab->frontier;
    uint32_t run = f->next[LIST_END];
    uint32_t label = lab->merged_label;

    while (run != LIST_END) { /* bound: OCEL_MAX_RUNS */
        if (f->label[run] != NEWBORN) {
            f->label[run] = (uint16_t)root_of(lab, f->label[run]);
        }
        run = f->next[run];
    }
    while (label != NO_LABEL) { /* bound: OCEL_MAX_LABELS */
        const uint32_t next = lab->live[label] & ~LOST;

        give_label(lab, label);
        label = next;
    }
    lab->merged_label = NO_LABEL;
}

/* ---- Places in the frontier ---- */

/* A place for a run, after `prev`; labeller.h proves that there is one. */
static inline uint32_t insert_run(ocel_labeller_t *lab, uint32_t prev) {
    ocel_frontier_t *f = &lab->frontier;
    uint32_t run = lab->free_run;

    if (run != LIST_END) {
        lab->free_run = f->next[run];
    } else {
        run = lab->fresh_run;
        lab->fresh_run++;
    }
    f->next[run] = f->next[prev];
    f->next[prev] = (uint16_t)run;
    return run;
}

/* Frees the place `run`, which is the one after `prev`. */
static inline void remove_run(ocel_labeller_t *lab, uint32_t prev, uint32_t run) {
    ocel_frontier_t *f = &lab->frontier;

    f->next[prev] = f->next[run];
    f->next[run] = lab->free_run;
    lab->free_run = (uint16_t)run;
}

/* ---- Runs of the row above that end ---- */

/* The component has ended above the row in hand.  Its boundary goes from head to
 * tail; head is OCEL_NO_CELL when it is lost. */
static void end_component(ocel_labeller_t *lab, ocel_crack_pool_t *pool, uint32_t root,
                          uint32_t head, uint32_t tail, ended_list_t *ended) {
    const ocel_component_t *component = &lab->component[root];
    const uint32_t bottom = lab->next_row - 1U;

    lab->stats.components++;
    if (ended->blob != NULL) {
        ocel_component_blob(component, bottom, lab->width, lab->height, &ended->blob[ended->count]);
        ended->count++;
    }
    if (ocel_component_beats(component, &lab->best)) {
        if (lab->best_head != OCEL_NO_CELL) {
            ocel_crack_give(pool, &lab->ledger, lab->best_head, lab->best_tail);
        }
        lab->best = *component;
        lab->best_bottom = (uint16_t)bottom;
        lab->best_head = (uint16_t)head;
        lab->best_tail = (uint16_t)tail;
    } else if (head != OCEL_NO_CELL) {
        ocel_crack_give(pool, &lab->ledger, head, tail);
    } else {
        /* Neither the largest nor with anything to give back. */
    }
    give_label(lab, root);
}

/* The newborn run of the row above in the place `run` gets what a component has:
 * a label, its sums and its edges; lost at once when there are no cells. */
static void settle_newborn(ocel_labeller_t *lab, ocel_crack_pool_t *pool, uint32_t run) {
    ocel_frontier_t *f = &lab->frontier;
    const uint32_t start = f->start[run];
    const uint32_t end = (uint32_t)f->end[run] - lab->reach;
    const uint32_t root = take_label(lab);
    const ocel_crack_pair_t pair = ocel_crack_take_pair(pool, &lab->ledger);

    if (pair.head != OCEL_NO_CELL) {
        ocel_crack_set_left(pool, pair.head, start);
        ocel_crack_set_right(pool, pair.tail, end);
    } else {
        lab->live[root] |= LOST;
    }
    f->label[run] = (uint16_t)root;
    f->head[run] = (uint16_t)pair.head;
    f->tail[run] = (uint16_t)pair.tail;
    ocel_component_start(&lab->component[root], start, end, (uint32_t)lab->next_row - 1U);
}

static inline void settle(ocel_labeller_t *lab, ocel_crack_pool_t *pool, uint32_t run) {
    if (lab->frontier.label[run] == NEWBORN) {
        settle_newborn(lab, pool, run);
    }
}

/* The run in the place `run` has no child: its component ends with it, or its
 * two edges are linked. */
static void end_run(ocel_labeller_t *lab, ocel_crack_pool_t *pool, uint32_t run,
                    ended_list_t *ended) {
    const ocel_frontier_t *f = &lab->frontier;
    const uint32_t root = root_of(lab, f->label[run]);
    const uint32_t tail = f->tail[run];
    uint32_t head = f->head[run];

    lab->live[root]--;
    if ((lab->live[root] & LOST) != 0U) {
        ocel_crack_give_from(pool, &lab->ledger, head);
        head = OCEL_NO_CELL;
    }
    if ((lab->live[root] & ~LOST) == 0U) {
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
static inline bool is_noise(const ocel_labeller_t *lab, uint32_t run, const ended_list_t *ended) {
    const ocel_frontier_t *f = &lab->frontier;

    return (f->label[run] == NEWBORN) && (ended->blob == NULL) &&
           (((uint32_t)f->end[run] - lab->reach - f->start[run]) <= lab->best.area);
}

/* The run after `prev` has no child: it leaves the frontier. */
static inline void retire_run(ocel_labeller_t *lab, ocel_crack_pool_t *pool, uint32_t prev,
                              ended_list_t *ended) {
    const uint32_t run = lab->frontier.next[prev];

    if (is_noise(lab, run, ended)) {
        lab->stats.components++;
    } else {
        settle(lab, pool, run);
        end_run(lab, pool, run, ended);
    }
    remove_run(lab, prev, run);
}

/* ---- The left edge of the run in hand ---- */

/* Takes the cells of a run's two edges, links the left one, at column start, to
 * the cell `after`, and leaves them in head[run] and tail[run].  If the
 * component is lost, or there are no two cells and so it is lost now, both are
 * OCEL_NO_CELL. */
static void take_edges(ocel_labeller_t *lab, ocel_crack_pool_t *pool, uint32_t run, uint32_t start,
                       uint32_t after) {
    ocel_frontier_t *f = &lab->frontier;
    const uint32_t root = f->label[run];
    ocel_crack_pair_t pair = {OCEL_NO_CELL, OCEL_NO_CELL};

    if (lab->live[root] < LOST) {
        pair = ocel_crack_take_pair(pool, &lab->ledger);
        if (pair.head != OCEL_NO_CELL) {
            ocel_crack_set_left(pool, pair.head, start);
            ocel_crack_set_link(pool, pair.head, after);
        } else {
            lab->live[root] |= LOST;
        }
    }
    f->head[run] = (uint16_t)pair.head;
    f->tail[run] = (uint16_t)pair.tail;
}

/* The gap between two parents of the run in hand closes: that in the place
 * `right`, which has no child yet, and the one before, of the component `root`
 * and with the tail `tail`.  Returns the mark of the component of both. */
static uint32_t close_gap(ocel_labeller_t *lab, ocel_crack_pool_t *pool, uint32_t root,
                          uint32_t tail, uint32_t right) {
    const uint32_t head = lab->frontier.head[right];
    const uint32_t other = root_of(lab, lab->frontier.label[right]);
    const uint32_t both = (root == other) ? root : unite(lab, root, other);

    if (lab->live[both] >= LOST) {
        ocel_crack_give_from(pool, &lab->ledger, head);
    } else if (root == other) {
        ocel_crack_give(pool, &lab->ledger, head, tail);
    } else {
        ocel_crack_set_link(pool, tail, head);
    }
    return mark_of(lab, both);
}

static inline void set_component(ocel_labeller_t *lab, sweep_t *s, uint32_t mark) {
    s->mark = mark;
    s->sums = &lab->component[mark & ~LOST];
}

/* The label of the run in the place `run` was merged away or its component is
 * lost: sets that right, and gives the run's chain back if so.  Returns the
 * mark. */
static uint32_t resolve_label(ocel_labeller_t *lab, ocel_crack_pool_t *pool, uint32_t run) {
    ocel_frontier_t *f = &lab->frontier;
    const uint32_t root = root_of(lab, f->label[run]);
    const uint32_t mark = mark_of(lab, root);

    f->label[run] = (uint16_t)root;
    if (mark >= LOST) {
        ocel_crack_give_from(pool, &lab->ledger, f->head[run]);
        f->head[run] = OCEL_NO_CELL;
    }
    return mark;
}

/* The mark of the run in the place `run`, by the short way where there is one:
 * neither merged nor lost, or lost and without a chain by now. */
static inline uint32_t current_mark(ocel_labeller_t *lab, ocel_crack_pool_t *pool, uint32_t run) {
    uint32_t mark = lab->frontier.label[run];

    if (lab->live[mark] >= LOST) {
        if ((lab->parent[mark] == mark) && (lab->frontier.head[run] == OCEL_NO_CELL)) {
            mark |= LOST;
        } else {
            mark = resolve_label(lab, pool, run);
        }
    }
    return mark;
}

/* The run in hand, from column start, is the first child of the run in the place
 * `run`, which it takes. */
static inline void first_child(ocel_labeller_t *lab, ocel_crack_pool_t *pool, sweep_t *s,
                               uint32_t run, uint32_t start) {
    ocel_frontier_t *f = &lab->frontier;
    uint32_t mark;

    settle(lab, pool, run);
    mark = current_mark(lab, pool, run);
    s->right = OCEL_NO_CELL;
    s->reach_end = f->end[run];
    s->parent_tail = f->tail[run];
    if (mark < LOST) {
        const ocel_crack_pair_t pair = ocel_crack_take_pair(pool, &lab->ledger);

        if (pair.head != OCEL_NO_CELL) {
            ocel_crack_set_left(pool, pair.head, start);
            ocel_crack_set_link(pool, pair.head, f->head[run]);
            f->head[run] = (uint16_t)pair.head;
            s->right = pair.tail;
        } else {
            lab->live[mark] |= LOST;
            mark = resolve_label(lab, pool, run);
        }
    }
    set_component(lab, s, mark);
}

/* The parent of `prev` splits, and the run in hand, from column start, has no
 * other: it gets a place of its own, which is returned. */
static uint32_t split_off(ocel_labeller_t *lab, ocel_crack_pool_t *pool, uint32_t prev,
                          uint32_t start) {
    ocel_frontier_t *f = &lab->frontier;
    const uint32_t run = insert_run(lab, prev);

    f->label[run] = f->label[prev];
    lab->live[f->label[run]]++;
    take_edges(lab, pool, run, start, f->tail[prev]);
    return run;
}

/* The parent of `prev`, with the tail `parent_tail`, splits, and the run in hand
 * has the next parent too, in the place `run`, which it takes. */
static void split_and_close(ocel_labeller_t *lab, ocel_crack_pool_t *pool, uint32_t prev,
                            uint32_t parent_tail, uint32_t run, uint32_t start) {
    ocel_frontier_t *f = &lab->frontier;
    const uint32_t mark = close_gap(lab, pool, f->label[prev], parent_tail, run);

    f->label[run] = (uint16_t)(mark & ~LOST);
    take_edges(lab, pool, run, start, f->tail[prev]);
    if ((mark < LOST) && (f->head[run] == OCEL_NO_CELL)) {
        /* Lost only now: the right edge of prev is in no chain any more. */
        ocel_crack_give(pool, &lab->ledger, f->tail[prev], f->tail[prev]);
    }
}

/* The same where the gap was a hole: its cells serve again at once.  The chain
 * from head[run] to the parent's tail has two cells or more. */
static inline void split_and_close_hole(ocel_labeller_t *lab, ocel_crack_pool_t *pool, sweep_t *s,
                                        uint32_t run, uint32_t start) {
    const ocel_frontier_t *f = &lab->frontier;
    const uint32_t head = f->head[run];

    ocel_crack_set_link(pool, s->parent_tail, lab->ledger.free);
    s->right = ocel_crack_link(pool, head);
    lab->ledger.free = (uint16_t)ocel_crack_link(pool, s->right);
    ocel_crack_set_left(pool, head, start);
    ocel_crack_set_link(pool, head, f->tail[s->prev]);
}

/* The run in hand, from column start, is one more child of the parent of `prev`.
 * Returns its place; `run` is the one after prev. */
static inline uint32_t next_child(ocel_labeller_t *lab, ocel_crack_pool_t *pool, sweep_t *s,
                                  uint32_t run, uint32_t start, uint32_t touch_end) {
    const ocel_frontier_t *f = &lab->frontier;
    uint32_t place = run;

    if (f->start[run] >= touch_end) {
        place = split_off(lab, pool, s->prev, start);
        s->right = f->tail[place];
        s->mark = mark_of(lab, f->label[place]);
    } else {
        uint32_t tail = f->tail[run];

        if (f->label[run] == s->mark) {
            split_and_close_hole(lab, pool, s, run, start);
        } else {
            settle(lab, pool, run);
            tail = f->tail[run];
            split_and_close(lab, pool, s->prev, s->parent_tail, run, start);
            s->right = f->tail[run];
            set_component(lab, s, mark_of(lab, f->label[run]));
        }
        s->reach_end = f->end[run];
        s->parent_tail = tail;
    }
    return place;
}

/* ---- The rest of the run in hand ---- */

/* The run after the place `run` is one more parent of the run in hand, behind
 * that with the tail `tail`: it gives up its place, which is returned and not
 * yet used again. */
static uint32_t absorb_parent(ocel_labeller_t *lab, ocel_crack_pool_t *pool, uint32_t run,
                              uint32_t tail) {
    ocel_frontier_t *f = &lab->frontier;
    const uint32_t parent = f->next[run];
    uint32_t root;

    settle(lab, pool, parent);
    root = close_gap(lab, pool, f->label[run], tail, parent) & ~LOST;
    f->label[run] = (uint16_t)root;
    lab->live[root]--;
    remove_run(lab, run, parent);
    return parent;
}

/* Absorbs all further parents of the run in hand, in the place `run`.  Where it
 * does not reach beyond its last parent there is none, and no need to look. */
static inline void absorb_parents(ocel_labeller_t *lab, ocel_crack_pool_t *pool, sweep_t *s,
                                  uint32_t run, uint32_t touch_end) {
    const ocel_frontier_t *f = &lab->frontier;

    /* bound: OCEL_MAX_RUNS */
    while ((touch_end > s->reach_end) && (f->start[f->next[run]] < touch_end)) {
        const uint32_t parent = absorb_parent(lab, pool, run, s->parent_tail);

        s->reach_end = f->end[parent];
        s->parent_tail = f->tail[parent];
        set_component(lab, s, mark_of(lab, f->label[run]));
        if ((s->mark >= LOST) && (s->right != OCEL_NO_CELL)) {
            ocel_crack_give(pool, &lab->ledger, s->right, s->right);
            s->right = OCEL_NO_CELL;
        }
    }
}

/* Writes the run in hand into its place and links its right edge. */
static inline void finish_run(ocel_labeller_t *lab, ocel_crack_pool_t *pool, sweep_t *s,
                              uint32_t run, const ocel_run_scan_t *scan, uint32_t touch_end) {
    ocel_frontier_t *f = &lab->frontier;

    if (s->right != OCEL_NO_CELL) {
        ocel_crack_set_right(pool, s->right, scan->end);
        ocel_crack_set_link(pool, s->right, OCEL_NO_CELL);
        ocel_crack_set_link(pool, s->parent_tail, s->right);
    }
    f->tail[run] = (uint16_t)s->right;
    f->start[run] = (uint16_t)scan->start;
    f->end[run] = (uint16_t)touch_end;
    ocel_component_add(s->sums, scan->start, scan->end, lab->next_row);
    s->prev = run;
}

/* The run in hand has no parent: a component is born, after prev. */
static inline void begin_component(ocel_labeller_t *lab, sweep_t *s, const ocel_run_scan_t *scan,
                                   uint32_t touch_end) {
    ocel_frontier_t *f = &lab->frontier;
    const uint32_t run = insert_run(lab, s->prev);

    f->start[run] = (uint16_t)scan->start;
    f->end[run] = (uint16_t)touch_end;
    f->label[run] = NEWBORN;
    s->prev = run;
    s->reach_end = 0U;
}

/* ---- The sweep ---- */

/* Takes the run that the scan has found, or retires what is left of the row
 * above when it has found none; true when it had found one. */
static inline bool sweep_run(ocel_labeller_t *lab, ocel_crack_pool_t *pool, sweep_t *s,
                             const ocel_run_scan_t *scan, ended_list_t *ended) {
    const ocel_frontier_t *f = &lab->frontier;
    const uint32_t touch_end = scan->end + lab->reach;
    uint32_t run = f->next[s->prev];
    bool has_parent = true;

    if (scan->start < s->reach_end) {
        run = next_child(lab, pool, s, run, scan->start, touch_end);
    } else {
        while (f->end[run] <= scan->start) { /* bound: OCEL_MAX_RUNS */
            retire_run(lab, pool, s->prev, ended);
            run = f->next[s->prev];
        }
        has_parent = f->start[run] < touch_end;
        if (has_parent) {
            first_child(lab, pool, s, run, scan->start);
        }
    }
    if (has_parent) {
        absorb_parents(lab, pool, s, run, touch_end);
        finish_run(lab, pool, s, run, scan, touch_end);
    } else if (scan->start != OCEL_RUN_NONE) {
        begin_component(lab, s, scan, touch_end);
    } else {
        /* The row is done: the list's end touches nothing. */
    }
    return scan->start != OCEL_RUN_NONE;
}

/* Sweeps over a row of `width` pixels; of none when the frame has ended. */
static void sweep_row(ocel_labeller_t *lab, ocel_crack_pool_t *pool, const uint32_t *row,
                      uint32_t width, ended_list_t *ended) {
    ocel_run_scan_t scan = ocel_run_scan(row, width);
    sweep_t s = {LIST_END, LOST, 0U, OCEL_NO_CELL, OCEL_NO_CELL, &lab->component[0]};
    uint32_t runs = 0U;
    bool more = true;

    do {
        ocel_run_next(&scan);
        more = sweep_run(lab, pool, &s, &scan, ended);
        runs++;
    } while (more); /* bound: OCEL_MAX_RUNS + 1 */
    lab->stats.runs += runs - 1U;
    if (lab->merged_label != NO_LABEL) {
        release_merged(lab);
    }
}

/* ---- The interface ---- */

static bool is_side(uint32_t side, uint32_t limit) {
    return (side > 0U) && (side <= limit);
}

ocel_status_t ocel_label_begin(ocel_labeller_t *labeller, ocel_crack_pool_t *pool, uint16_t width,
                               uint16_t height, ocel_connectivity_t connectivity) {
    const ocel_label_stats_t none = {0U, 0U, 0U, 0U, 0U};
    ocel_status_t status = OCEL_OK;

    if ((labeller == NULL) || (pool == NULL)) {
        status = OCEL_NULL_ARGUMENT;
    } else if ((!is_side(width, OCEL_MAX_WIDTH)) || (!is_side(height, OCEL_MAX_HEIGHT))) {
        labeller->state = STATE_NONE;
        status = OCEL_BAD_SIZE;
    } else if ((connectivity != OCEL_CONNECT_8) && (connectivity != OCEL_CONNECT_4)) {
        labeller->state = STATE_NONE;
        status = OCEL_BAD_OPTION;
    } else {
        labeller->frontier.start[LIST_END] = 0xFFFFU;
        labeller->frontier.end[LIST_END] = 0xFFFFU;
        labeller->frontier.next[LIST_END] = LIST_END;
        labeller->free_run = LIST_END;
        labeller->fresh_run = LIST_END + 1U;
        labeller->free_label = NO_LABEL;
        labeller->merged_label = NO_LABEL;
        labeller->ledger.free = OCEL_NO_CELL;
        labeller->ledger.fresh = 0U;
        labeller->best.area = 0U;
        labeller->best.first = 0U;
        labeller->best_head = OCEL_NO_CELL;
        labeller->stats = none;
        labeller->width = width;
        labeller->height = height;
        labeller->next_row = 0U;
        labeller->reach = (connectivity == OCEL_CONNECT_8) ? 1U : 0U;
        labeller->state = STATE_ROWS;
    }
    return status;
}

ocel_status_t ocel_label_row(ocel_labeller_t *labeller, ocel_crack_pool_t *pool,
                             const uint32_t *row, ocel_blob_t *ended, size_t *ended_count) {
    ended_list_t list = {ended, 0U};
    ocel_status_t status = OCEL_OK;

    if ((labeller == NULL) || (pool == NULL) || (row == NULL) ||
        ((ended != NULL) && (ended_count == NULL))) {
        status = OCEL_NULL_ARGUMENT;
    } else if ((labeller->state != STATE_ROWS) || (labeller->next_row == labeller->height)) {
        status = OCEL_BAD_ORDER;
    } else {
        if ((labeller->frontier.next[LIST_END] != LIST_END) ||
            (!ocel_run_row_is_empty(row, labeller->width))) {
            sweep_row(labeller, pool, row, labeller->width, &list);
        }
        labeller->next_row++;
        if (ended_count != NULL) {
            *ended_count = list.count;
        }
    }
    return status;
}

ocel_status_t ocel_label_end(ocel_labeller_t *labeller, ocel_crack_pool_t *pool, ocel_blob_t *ended,
                             size_t *ended_count, ocel_blob_t *largest) {
    ended_list_t list = {ended, 0U};
    ocel_status_t status = OCEL_OK;

    if ((labeller == NULL) || (pool == NULL) || ((ended != NULL) && (ended_count == NULL))) {
        status = OCEL_NULL_ARGUMENT;
    } else if ((labeller->state != STATE_ROWS) || (labeller->next_row != labeller->height)) {
        status = OCEL_BAD_ORDER;
    } else {
        sweep_row(labeller, pool, NULL, 0U, &list);
        labeller->state = STATE_ENDED;
        if (ended_count != NULL) {
            *ended_count = list.count;
        }
        if (labeller->best.area == 0U) {
            status = OCEL_NOT_SEEN;
        } else if (largest != NULL) {
            ocel_component_blob(&labeller->best, labeller->best_bottom, labeller->width,
                                labeller->height, largest);
        } else {
            /* Nobody asks which. */
        }
    }
    return status;
}

ocel_label_stats_t ocel_label_stats(const ocel_labeller_t *labeller) {
    ocel_label_stats_t stats = {0U, 0U, 0U, 0U, 0U};

    if (labeller != NULL) {
        stats = labeller->stats;
        stats.cracks_max = labeller->ledger.fresh;
    }
    return stats;
}

/* sum / area in Q16 to the nearest.  sum < 2^12 * area, so the result is below
 * 2^28; area <= 2^24, so sum * 2^16 + area / 2 < 2^53. */
static int32_t mean_q16(uint64_t sum, uint32_t area) {
    const uint64_t half = (uint64_t)area >> 1U;

    return (int32_t)ocel_udiv64((sum << 16U) + half, area);
}

void ocel_blob_centroid(const ocel_blob_t *blob, int32_t *cx_px_q16, int32_t *cy_px_q16) {
    if ((cx_px_q16 != NULL) && (cy_px_q16 != NULL)) {
        *cx_px_q16 = 0;
        *cy_px_q16 = 0;
        if ((blob != NULL) && (blob->area != 0U)) {
            *cx_px_q16 = mean_q16(blob->sum_x, blob->area);
            *cy_px_q16 = mean_q16(blob->sum_y, blob->area);
        }
    }
}

ocel_status_t ocel_label_boundary(ocel_labeller_t *labeller, ocel_crack_pool_t *pool,
                                  const ocel_crack_t **cracks, size_t *count, size_t *stride) {
    ocel_crack_points_t points = {0U, 0U, 0U};
    ocel_status_t status = OCEL_OK;

    if ((labeller == NULL) || (pool == NULL) || (cracks == NULL) || (count == NULL)) {
        status = OCEL_NULL_ARGUMENT;
    } else {
        if (labeller->state != STATE_ENDED) {
            status = OCEL_BAD_ORDER;
        } else if (labeller->best.area == 0U) {
            status = OCEL_NOT_SEEN;
        } else if (labeller->best_head == OCEL_NO_CELL) {
            status = OCEL_OVERFLOW;
        } else {
            points = ocel_crack_unroll(pool, &labeller->ledger, labeller->best_head,
                                       labeller->best_bottom);
            labeller->state = STATE_UNROLLED;
            status = (points.stride != 0U) ? OCEL_OK : OCEL_OVERFLOW;
        }
        *cracks = &pool->cells[points.first];
        *count = points.count;
        if (stride != NULL) {
            *stride = points.stride;
        }
    }
    return status;
}
