/* SPDX-License-Identifier: MIT
 *
 * The pixels of a row are added to their components.
 */
#include "sums.h"

#include <stddef.h>

#include "../base/int_math.h"
#include "component.h"
#include "frontier.h"

/* Column of the lowest bit, which is taken; there must be one. */
static inline uint32_t take_column(uint32_t *bits, uint32_t base) {
    const uint32_t column = base + ocel_ctz32(*bits);

    *bits &= *bits - 1U;
    return column;
}

/* The filled holes of a row, from left to right. */
typedef struct {
    const uint32_t *word;
    uint32_t bits;   /* of the word: those not yet come upon */
    uint32_t base;   /* the column of its bit 0 */
    uint32_t column; /* of the hole in hand */
} hole_scan_t;

static inline void next_hole(hole_scan_t *scan) {
    /* bound: OCEL_ROW_WORDS; OCEL_ROW_WORDS in a call of ocel_sweep_row */
    while (scan->bits == 0U) {
        scan->word++;
        scan->bits = *scan->word;
        scan->base += 32U;
    }
    scan->column = take_column(&scan->bits, scan->base);
}

void ocel_sums_add_row(ocel_labeller_t *lab, const uint32_t *holes) {
    const uint32_t reach = lab->reach;
    hole_scan_t scan = {holes, 0U, 0U, OCEL_ROW_END};
    ocel_run_t *run = &lab->frontier[lab->first_run];

    if (holes != NULL) {
        scan.base = 32U * lab->rows[lab->above].first;
        scan.bits = holes[0];
        next_hole(&scan);
    }
    while (run->label != OCEL_NO_LABEL) { /* bound: OCEL_MAX_RUNS */
        const uint32_t label = run->label;

        if (label == OCEL_NEWBORN) {
            run = ocel_frontier_after(lab, run);
        } else {
            const uint32_t left = run->start;
            const uint32_t root = lab->root[label];
            ocel_row_sums_t sums = {0U, 0U, 0U};
            uint32_t end;

            /* bound: OCEL_MAX_RUNS in all rounds of the outer loop;
             * OCEL_MAX_RUNS as places in a call of ocel_sweep_row;
             * OCEL_MAX_RUNS as places in a call of ocel_label_end;
             * OCEL_MAX_HEIGHT * OCEL_MAX_RUNS as places in a call of ocel_eye_frame;
             * OCEL_MAX_HEIGHT * OCEL_MAX_RUNS as lives in a call of ocel_eye_frame */
            do {
                end = (uint32_t)run->end - reach;
                ocel_row_sums_add(&sums, run->start, end);
                /* bound: OCEL_MAX_RUNS; OCEL_MAX_RUNS as places in a call of ocel_sweep_row;
                 * OCEL_MAX_RUNS as places in a call of ocel_label_end;
                 * OCEL_MAX_HEIGHT * OCEL_MAX_RUNS as places in a call of ocel_eye_frame;
                 * OCEL_MAX_HEIGHT * OCEL_MAX_RUNS as lives in a call of ocel_eye_frame */
                while (scan.column < end) {
                    ocel_row_sums_drop(&sums, scan.column);
                    next_hole(&scan);
                }
                run->label = (uint16_t)root;
                run = ocel_frontier_after(lab, run);
            } while (run->label == label);
            /* at most: OCEL_MAX_RUNS as heirs in a call of ocel_sweep_row;
             * OCEL_MAX_RUNS in a call of ocel_label_end;
             * OCEL_MAX_RUNS + OCEL_MAX_RUNS / 2 as joins in a call of ocel_sweep_row;
             * OCEL_MAX_HEIGHT * OCEL_MAX_RUNS as sums in a call of ocel_eye_frame */
            ocel_component_add(&lab->component[root], &sums, left, end, lab->swept);
        }
    }
}

void ocel_sums_add_repeats(ocel_labeller_t *lab) {
    const ocel_rows_t none = {0U, 0U, 0U};
    ocel_run_t *run = &lab->frontier[lab->first_run];

    /* bound: OCEL_MAX_RUNS; OCEL_MAX_RUNS as olds in a call of ocel_sweep_row;
     * 3 * OCEL_MAX_RUNS as born in a call of ocel_label_row;
     * 2 * OCEL_MAX_RUNS as born in a call of ocel_label_end;
     * OCEL_MAX_HEIGHT * OCEL_MAX_RUNS as places in a call of ocel_eye_frame;
     * OCEL_MAX_HEIGHT * OCEL_MAX_RUNS as lives in a call of ocel_eye_frame;
     * OCEL_MAX_HEIGHT * OCEL_MAX_RUNS as sums in a call of ocel_eye_frame */
    while (run->label != OCEL_NO_LABEL) {
        ocel_component_repeat(&lab->component[run->label], run->start,
                              (uint32_t)run->end - lab->reach, &lab->repeats);
        run = ocel_frontier_after(lab, run);
    }
    lab->repeats = none;
}
