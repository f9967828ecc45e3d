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
#include <ocellus/labeller.h>
#include <ocellus/status.h>
#include <ocellus/types.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum { OCEL_CONNECT_8 = 8, OCEL_CONNECT_4 = 4 } ocel_connectivity_t;

/* Starts a frame of width x height.
 * OCEL_NULL_ARGUMENT  labeller or pool is null
 * OCEL_BAD_SIZE       a side is 0 or over its limit
 * OCEL_BAD_OPTION     connectivity is none of the enumeration */
ocel_status_t ocel_label_begin(ocel_labeller_t *labeller, ocel_crack_pool_t *pool, uint16_t width,
                               uint16_t height, ocel_connectivity_t connectivity);

/* Takes the next row, top to bottom.
 *   row    (width + 31) / 32 words, bit x%32 of word x/32 is pixel x; bits past
 *          the width are ignored.
 *   ended  components that ended above this row, in the order in which their last
 *          runs stand; null when only the largest matters.  Room for
 *          OCEL_MAX_RUNS: each had a run in the row above.
 *   ended_count  out, may be null only when ended is null.
 * OCEL_NULL_ARGUMENT  labeller, pool or row is null, or ended without a count
 * OCEL_BAD_ORDER      no frame begun, or all its rows are in */
ocel_status_t ocel_label_row(ocel_labeller_t *labeller, ocel_crack_pool_t *pool,
                             const uint32_t *row, ocel_blob_t *ended, size_t *ended_count);

/* Ends the frame: closes what is open and gives the largest component, ties to
 * the one whose first pixel comes first in raster order.  A frame ends once.
 *   ended, ended_count  as in ocel_label_row.
 *   largest             out; may be null.
 * OCEL_OK             there is a largest component
 * OCEL_NOT_SEEN       no pixel was set
 * OCEL_NULL_ARGUMENT  labeller or pool is null, or ended without a count
 * OCEL_BAD_ORDER      rows are missing */
ocel_status_t ocel_label_end(ocel_labeller_t *labeller, ocel_crack_pool_t *pool, ocel_blob_t *ended,
                             size_t *ended_count, ocel_blob_t *largest);

/* Operation counts and high-water marks of the frame in hand or just ended.  While
 * rows are coming they may lack the last one: it is held until the next one
 * (DESIGN.md, "Specks"). */
ocel_label_stats_t ocel_label_stats(const ocel_labeller_t *labeller);

/* A blob's centroid; zero for an empty blob.  |error| <= half an LSB. */
void ocel_blob_centroid(const ocel_blob_t *blob, int32_t *cx_px_q16, int32_t *cy_px_q16);

/* The outer boundary of the largest component, as crack midpoints in order,
 * clockwise on the screen, from the left edge of its lowest row's last run.
 * Of its N cracks, V of them vertical, every stride-th is given, from the first;
 * stride is the smallest for which ceil(N / stride) points are at most
 * OCEL_MAX_CRACKS - V (the V wait in the pool while the points are written) and
 * at most OCEL_MAX_FIT_POINTS.
 *   cracks  out: points into the pool, valid until the next ocel_label_begin.
 *   count   out
 *   stride  out, may be null: 1 when every crack is there.
 * Once a frame, after ocel_label_end: it reuses the pool in place.
 * OCEL_OK             the boundary is there
 * OCEL_NOT_SEEN       the frame had no component
 * OCEL_OVERFLOW       the pool ran out while this component was open, or V equals
 *                     OCEL_MAX_CRACKS: its sums are right, its boundary is lost
 * OCEL_NULL_ARGUMENT, OCEL_BAD_ORDER */
ocel_status_t ocel_label_boundary(ocel_labeller_t *labeller, ocel_crack_pool_t *pool,
                                  const ocel_crack_t **cracks, size_t *count, size_t *stride);

#ifdef __cplusplus
}
#endif

#endif
