/* SPDX-License-Identifier: MIT
 *
 * Labelling: the interface.  sweep.c tells how it is done.
 */
#include <ocellus/label.h>

#include <stddef.h>
#include <string.h>

#include "../base/int_math.h"
#include "component.h"
#include "crack.h"
#include "frontier.h"
#include "rows.h"

/* The labeller's states: values that memory which was never initialised is
 * unlikely to hold. */
#define STATE_NONE 0U
#define STATE_ROWS 0x0CE1U
#define STATE_ENDED 0x0CE2U
#define STATE_UNROLLED 0x0CE3U

/* ---- The interface ---- */

static bool is_side(uint32_t side, uint32_t limit) {
    return (side > 0U) && (side <= limit);
}

ocel_status_t ocel_label_begin(ocel_labeller_t *labeller, ocel_crack_pool_t *pool, uint16_t width,
                               uint16_t height, ocel_connectivity_t connectivity) {
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
        /* All that is single, and the rows: nothing yet. */
        (void)memset(labeller, 0, offsetof(ocel_labeller_t, frontier));
        ocel_frontier_set(labeller, labeller->frontier, labeller->frontier);
        labeller->root[OCEL_NEWBORN] = OCEL_NEWBORN;
        labeller->free_label = OCEL_NO_LABEL;
        labeller->merged_label = OCEL_NO_LABEL;
        labeller->ledger.free = OCEL_NO_CELL;
        labeller->best_head = OCEL_NO_CELL;
        labeller->width = width;
        labeller->height = height;
        labeller->reach = (connectivity == OCEL_CONNECT_8) ? 1U : 0U;
        labeller->state = STATE_ROWS;
    }
    return status;
}

ocel_status_t ocel_label_row(ocel_labeller_t *labeller, ocel_crack_pool_t *pool,
                             const uint32_t *row, ocel_blob_t *ended, size_t *ended_count) {
    ocel_ended_t list = {ended, 0U};
    ocel_status_t status = OCEL_OK;

    if ((labeller == NULL) || (pool == NULL) || (row == NULL) ||
        ((ended != NULL) && (ended_count == NULL))) {
        status = OCEL_NULL_ARGUMENT;
    } else if ((labeller->state != STATE_ROWS) || (labeller->next_row == labeller->height)) {
        status = OCEL_BAD_ORDER;
    } else {
        ocel_rows_take(labeller, pool, row, &list);
        labeller->next_row++;
        if (ended_count != NULL) {
            *ended_count = list.count;
        }
    }
    return status;
}

ocel_status_t ocel_label_end(ocel_labeller_t *labeller, ocel_crack_pool_t *pool, ocel_blob_t *ended,
                             size_t *ended_count, ocel_blob_t *largest) {
    ocel_ended_t list = {ended, 0U};
    ocel_status_t status = OCEL_OK;

    if ((labeller == NULL) || (pool == NULL) || ((ended != NULL) && (ended_count == NULL))) {
        status = OCEL_NULL_ARGUMENT;
    } else if ((labeller->state != STATE_ROWS) || (labeller->next_row != labeller->height)) {
        status = OCEL_BAD_ORDER;
    } else {
        ocel_rows_take(labeller, pool, NULL, &list);
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
