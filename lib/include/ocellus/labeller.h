/* SPDX-License-Identifier: MIT
 *
 * The labeller's memory: what one frame's labelling keeps, with the derivation
 * of every size.  The types are complete so that the caller can own them;
 * label.h has the functions that read them.
 *
 * The sweep goes over a row from left to right.  Left of it stand the runs of
 * this row that are finished, right of it the runs of the row above that wait
 * for their children: the frontier.  It is a queue in a ring of places: a run is
 * taken from its front when the sweep comes upon it and put at its back when it
 * is finished.
 */
#ifndef OCELLUS_LABELLER_H
#define OCELLUS_LABELLER_H

#include <stdint.h>

#include <ocellus/config.h>
#include <ocellus/types.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Sums of x^2 over a whole frame: width^3 / 3 * height.  32 bits hold them up
 * to 320x240 (2.61e9); a larger configuration takes 64. */
#if ((OCEL_MAX_WIDTH <= 320) && (OCEL_MAX_HEIGHT <= 240))
typedef uint32_t ocel_moment_t;
#else
typedef uint64_t ocel_moment_t;
#endif

/* Labels in use at once: at most as many as a row has runs.
 *
 * A run that touches none above has no label; it gets one when a run of the next
 * row touches it, or when it ends and is the largest component so far.  A label
 * is in use from then until its component has ended or, when it was merged into
 * another, until the end of that row.  So while row y is swept every label in use
 * had a run of its own in row y - 1 when the sweep began, or belongs to the one
 * run of that row that is just getting it: different labels, different runs. */
#define OCEL_MAX_LABELS OCEL_MAX_RUNS

/* Places in the frontier: the runs of this row up to the sweep, and the runs
 * above that none of them touches, C being the run in hand.  Their starts are
 * columns of which no two are neighbours: those of one row are two apart, and a
 * run of this row is one or more columns from any above that it does not touch.
 * Only with 4-connectivity may C and the first run waiting be neighbours: the
 * columns up to C's start are two apart, and those right of it are, which makes
 * (i + 1) / 2 + (j + 1) / 2 with i + j <= width, at most OCEL_MAX_RUNS + 1; and
 * the place that ends the row above. */
#define OCEL_FRONTIER_RUNS (OCEL_MAX_RUNS + 2)

/* A run of the frontier. */
typedef struct {
    uint16_t label;
    uint16_t start; /* the first pixel */
    uint16_t head;  /* pool cell of its left edge: a chain begins there */
    uint16_t end;   /* it touches runs below that start before this */
    uint16_t tail;  /* pool cell of its right edge: a chain ends there */
} ocel_run_t;

/* The pixels of a row: bit x%32 of word 1 + x/32 is pixel x.  One word before
 * them and two behind have none. */
typedef struct {
    uint32_t word[OCEL_ROW_WORDS + 3];
    uint16_t first; /* all pixels that are set have first <= x/32 < end; */
    uint16_t end;   /* 0 when none is */
} ocel_bit_row_t;

/* The sums of a component.  32 bytes at 320x240. */
typedef struct {
    ocel_moment_t sum_x;
    ocel_moment_t sum_y;
    ocel_moment_t sum_xx;
    ocel_moment_t sum_xy;
    ocel_moment_t sum_yy;
    uint32_t area;
    uint32_t first; /* its first pixel in raster order: row * 65536 + column */
    uint16_t left;  /* its columns */
    uint16_t end;   /* one past the last */
} ocel_component_t;

/* Rows that have the same runs. */
typedef struct {
    ocel_moment_t count;
    ocel_moment_t sum_y;
    ocel_moment_t sum_yy;
} ocel_rows_t;

/* High-water marks and operation counts of one frame: what the bounds above are
 * checked against. */
typedef struct {
    uint32_t runs;       /* of the rows swept so far, <= height * OCEL_MAX_RUNS */
    uint32_t unions;     /* <= runs: every union ends a label, every label has a first run */
    uint32_t components; /* that have ended */
    uint16_t labels_max; /* <= OCEL_MAX_LABELS */
    uint16_t cracks_max; /* <= OCEL_MAX_CRACKS */
} ocel_label_stats_t;

/* The free cells of the boundary pool: a list, and the cells never used yet. */
typedef struct {
    uint16_t free;  /* first of the list */
    uint16_t fresh; /* cells used so far: those from here on were never used */
} ocel_crack_ledger_t;

/* The boundary pool.  While a frame is labelled a cell is a vertical crack of a
 * chain: x_hpx holds its column and side, y_hpx the link to the next cell
 * (crack.h).  Afterwards the cells hold the winner's boundary, in order. */
typedef struct {
    ocel_crack_t cells[OCEL_MAX_CRACKS];
} ocel_crack_pool_t;

/* One frame's labelling.  No pointers inside: it may be copied, with its pool,
 * while a frame is in hand, and the copy goes on by itself.  (What is single
 * stands first: small offsets make small instructions.) */
typedef struct {
    uint16_t width;
    uint16_t height;
    uint16_t next_row;   /* rows taken */
    uint16_t swept;      /* of them swept: all, or all but the last, which is held */
    uint16_t above;      /* which of `rows` was swept last; the next one is held */
    uint16_t held_empty; /* 1 when the row that is held has no pixel */
    uint16_t state;
    uint16_t reach;        /* 1: 8-connected, 0: 4-connected */
    uint16_t first_run;    /* the frontier's first place */
    uint16_t last_run;     /* and its last, which ends the row */
    uint16_t runs;         /* in it, of the row swept last */
    uint16_t repeats_lost; /* 1: a further one need not be looked at, all of it is lost */
    uint16_t free_label;
    uint16_t merged_label; /* labels merged away in this row, linked through live */
    uint16_t best_bottom;  /* of the largest: its last row */
    uint16_t best_head;    /* and its boundary's first and last cell */
    uint16_t best_tail;
    ocel_crack_ledger_t ledger;
    ocel_label_stats_t stats;
    ocel_component_t best; /* the largest that has ended, when its area is not 0 */
    ocel_rows_t repeats;   /* rows swept last that were as the one above and are not in the sums */
    ocel_bit_row_t rows[3];
    ocel_run_t frontier[OCEL_FRONTIER_RUNS];
    uint16_t root[OCEL_MAX_LABELS + 1]; /* of a label's component; that of none: none */
    uint16_t peer[OCEL_MAX_LABELS];     /* the labels merged in this row, a ring for each root */
    uint16_t live[OCEL_MAX_LABELS];     /* root: its runs in the frontier, and a flag (frontier.h);
                                         * merged away or free: the next such label */
    ocel_component_t component[OCEL_MAX_LABELS];
} ocel_labeller_t;

#ifdef __cplusplus
}
#endif

#endif
