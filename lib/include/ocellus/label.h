/* SPDX-License-Identifier: MIT
 *
 * Labelling: rows of bits in, connected components out, in one pass and with
 * memory that grows with the width only.  The outer boundary of every open
 * component is kept as a chain of cracks (DESIGN.md, "One pass, one chain"), so
 * that the winner's is there when the frame ends.
 */
#ifndef OCELLUS_LABEL_H
#define OCELLUS_LABEL_H

#include <stddef.h>
#include <stdint.h>

#include <ocellus/config.h>
#include <ocellus/status.h>
#include <ocellus/types.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum { OCEL_CONNECT_8 = 8, OCEL_CONNECT_4 = 4 } ocel_connectivity_t;

/* Sums of x^2 over a whole frame: width^3 / 3 * height.  32 bits hold them up
 * to 320x240 (2.61e9); a larger configuration takes 64. */
#if ((OCEL_MAX_WIDTH <= 320) && (OCEL_MAX_HEIGHT <= 240))
#define OCEL_MOMENT_BITS 32
typedef uint32_t ocel_moment_t;
#else
#define OCEL_MOMENT_BITS 64
typedef uint64_t ocel_moment_t;
#endif

/* Labels alive at once.  A label is held by a pending run of the row above or
 * was made by a run of this row that touches none above; such runs hold
 * columns of which no two are neighbours, plus the one run in hand. */
#define OCEL_MAX_LABELS (OCEL_MAX_RUNS + 2)

/* Runs alive at once: those of the row above right of the sweep and those of
 * this row left of it, plus the two in hand. */
#define OCEL_RING_RUNS (OCEL_MAX_RUNS + 4)

/* A component that is still open.  Opaque. */
typedef struct {
    ocel_moment_t sum_x;
    ocel_moment_t sum_y;
    ocel_moment_t sum_xx;
    ocel_moment_t sum_xy;
    ocel_moment_t sum_yy;
    uint32_t area;
    uint16_t left;
    uint16_t right;
    uint16_t top;
    uint16_t first_x;
    uint16_t parent;    /* union-find: itself when a root; next free when free */
    uint16_t live_runs; /* runs in the ring that belong to it; flag in the top bit */
} ocel_label_t;

/* A run in hand.  Opaque. */
typedef struct {
    uint16_t x0;
    uint16_t x1;
    uint16_t label;
    uint16_t head;      /* chain cell of its left edge */
    uint16_t tail;      /* chain cell of its right edge */
    uint16_t head_mate; /* the ring run that holds the other end of head's chain */
} ocel_run_t;

/* High-water marks and operation counts of one frame: what the bounds of
 * DESIGN.md are checked against. */
typedef struct {
    uint32_t runs;        /* <= height * OCEL_MAX_RUNS */
    uint32_t unions;      /* <= runs */
    uint16_t labels_max;  /* <= OCEL_MAX_LABELS */
    uint16_t cracks_max;  /* <= OCEL_MAX_CRACKS */
    uint32_t components;
} ocel_label_stats_t;

/* One frame's labelling.  Caller-owned, no pointers inside: it may be copied
 * while a frame is in hand, and the copy goes on by itself.  Opaque: read it
 * through the functions below. */
typedef struct {
    ocel_label_t label[OCEL_MAX_LABELS];
    ocel_run_t run[OCEL_RING_RUNS];
    ocel_label_t best;      /* the largest component so far, when best_area > 0 */
    ocel_label_stats_t stats;
    uint16_t width;
    uint16_t height;
    uint16_t next_row;
    uint16_t state;
    uint16_t reach;         /* 1 for 8-connected, 0 for 4-connected */
    uint16_t first_run;     /* ring: the first pending run of the row above */
    uint16_t pending_runs;  /* ring: how many of them */
    uint16_t free_label;
    uint16_t free_crack;
    uint16_t best_chain;
    uint16_t labels_in_use;
    uint16_t cracks_in_use;
} ocel_labeller_t;

/* The boundary pool: chains of vertical cracks while a frame is labelled, the
 * winner's boundary points in order afterwards.  Caller-owned; opaque. */
typedef struct {
    uint32_t cell[OCEL_MAX_CRACKS];
} ocel_crack_pool_t;

/* Starts a frame of width x height.
 * OCEL_NULL_ARGUMENT  labeller or pool is null
 * OCEL_BAD_SIZE       a side is 0 or over its limit
 * OCEL_BAD_OPTION     connectivity is none of the enumeration */
ocel_status_t ocel_label_begin(ocel_labeller_t *labeller, ocel_crack_pool_t *pool, uint16_t width,
                               uint16_t height, ocel_connectivity_t connectivity);

/* Takes the next row, top to bottom.
 *   row    (width + 31) / 32 words, bit x%32 of word x/32 is pixel x; bits past
 *          the width are ignored.
 *   ended  components that ended above this row, in no particular order; null
 *          when only the largest matters.  Room for OCEL_MAX_RUNS + 1.
 *   ended_count  out, may be null only when ended is null.
 * OCEL_NULL_ARGUMENT  labeller, pool or row is null, or ended without a count
 * OCEL_BAD_ORDER      no frame begun, or all its rows are in */
ocel_status_t ocel_label_row(ocel_labeller_t *labeller, ocel_crack_pool_t *pool,
                             const uint32_t *row, ocel_blob_t *ended, size_t *ended_count);

/* Ends the frame: closes what is open and gives the largest component, ties to
 * the one whose first pixel comes first in raster order.
 *   ended, ended_count  as in ocel_label_row.
 *   largest             out; may be null.
 * OCEL_OK             there is a largest component
 * OCEL_NOT_SEEN       no pixel was set
 * OCEL_NULL_ARGUMENT  labeller or pool is null, or ended without a count
 * OCEL_BAD_ORDER      rows are missing */
ocel_status_t ocel_label_end(ocel_labeller_t *labeller, ocel_crack_pool_t *pool,
                             ocel_blob_t *ended, size_t *ended_count, ocel_blob_t *largest);

/* Operation counts and high-water marks of the frame in hand or just ended. */
ocel_label_stats_t ocel_label_stats(const ocel_labeller_t *labeller);

/* A blob's centroid; zero for an empty blob.  |error| <= half an LSB. */
void ocel_blob_centroid(const ocel_blob_t *blob, int32_t *cx_px_q16, int32_t *cy_px_q16);

/* The outer boundary of the largest component, as crack midpoints in order,
 * clockwise on the screen, from the left edge of its lowest row's last run.
 * When it has more cracks than fit, every stride-th is given, from the first.
 *   cracks  out: points into the pool, valid until the next ocel_label_begin.
 *   count   out
 *   stride  out, may be null: 1 when every crack is there.
 * Call once a frame, after ocel_label_end: it reuses the pool in place.
 * OCEL_OK             the boundary is there
 * OCEL_NOT_SEEN       the frame had no component
 * OCEL_OVERFLOW       the pool ran out while this component was open: its sums
 *                     are right, its boundary is lost
 * OCEL_NULL_ARGUMENT, OCEL_BAD_ORDER */
ocel_status_t ocel_label_boundary(ocel_labeller_t *labeller, ocel_crack_pool_t *pool,
                                  const ocel_crack_t **cracks, size_t *count, size_t *stride);

#ifdef __cplusplus
}
#endif

#endif
