/* SPDX-License-Identifier: MIT
 *
 * The row that is held.
 */
#include "rows.h"

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

#include "run.h"
#include "specks.h"
#include "sweep.h"

/* Sweeps over the row that was held above, as it is. */
static void sweep_asked(ocel_labeller_t *lab, ocel_crack_pool_t *pool, ocel_ended_t *ended) {
    lab->above = (uint16_t)ocel_specks_row(lab, 1U);
    ocel_sweep_row(lab, pool, NULL, ended);
}

/* Takes a row whose first word with a pixel is `first` or beyond; past its words, or
 * null, it has none. */
static void hold_row(ocel_labeller_t *lab, ocel_crack_pool_t *pool, const uint32_t *row,
                     uint32_t first, ocel_ended_t *ended) {
    const bool is_held = lab->swept != lab->next_row;
    const bool is_empty = first == ocel_run_words(lab->width);
    ocel_bit_row_t *const to = &lab->rows[ocel_specks_row(lab, is_held ? 2U : 1U)];

    if (is_empty) {
        (void)memset(to, 0, sizeof(*to));
    } else {
        ocel_run_copy(to, row, lab->width, first);
    }
    if (is_held) {
        ocel_specks_sweep(lab, pool);
    }
    lab->held_empty = is_empty ? 1U : 0U;
    if ((ended->blob != NULL) || (row == NULL)) {
        /* at most: 1 in a call of ocel_label_row or ocel_label_end; 0 in a call of ocel_eye_row;
         * 0 in a call of ocel_eye_line; 1 in a call of ocel_eye_frame */
        sweep_asked(lab, pool, ended);
    }
}

/* One empty row after another is only counted: the place of the row held is empty. */
void ocel_rows_take(ocel_labeller_t *lab, ocel_crack_pool_t *pool, const uint32_t *row,
                    ocel_ended_t *ended) {
    const uint32_t words = ocel_run_words(lab->width);
    const uint32_t first = (row != NULL) ? ocel_run_first(row, lab->width) : words;
    const bool is_idle = (lab->held_empty != 0U) && (lab->swept != lab->next_row) &&
                         (lab->first_run == lab->last_run);

    if (is_idle && (first == words) && (row != NULL) && (ended->blob == NULL)) {
        lab->swept++;
    } else {
        hold_row(lab, pool, row, first, ended);
    }
}
