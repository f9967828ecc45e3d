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

void ocel_rows_take(ocel_labeller_t *lab, ocel_crack_pool_t *pool, const uint32_t *row,
                    ocel_ended_t *ended) {
    const bool is_held = lab->swept != lab->next_row;
    ocel_bit_row_t *const to = &lab->rows[ocel_specks_row(lab, is_held ? 2U : 1U)];
    bool is_empty = true;

    if (row != NULL) {
        is_empty = ocel_run_copy(to, row, lab->width) == 0U;
    } else {
        (void)memset(to, 0, sizeof(*to));
    }
    if (is_held) {
        if (is_empty && (lab->held_empty != 0U) && (lab->first_run == lab->last_run)) {
            lab->swept++;
        } else {
            ocel_specks_sweep(lab, pool);
        }
    }
    lab->held_empty = is_empty ? 1U : 0U;
    if ((ended->blob != NULL) || (row == NULL)) {
        lab->above = (uint16_t)ocel_specks_row(lab, 1U);
        ocel_sweep_row(lab, pool, lab->rows[lab->above].word, NULL, ended);
    }
}
