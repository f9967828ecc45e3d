/* SPDX-License-Identifier: MIT
 *
 * RGB565 lines by a table alone.  Apart from colour.c, so that a firmware whose
 * table is const links neither the other formats nor the compiling.
 */
#include <string.h>

#include <ocellus/colour.h>

#include "lanes.h"
#include "row16.h"

#define GROUP 16U
#define PIXEL_BYTES 2U

/* The last, incomplete group's bits.  count 1..15. */
static uint32_t tail_bits(const ocel_colour_table_t *table, const uint8_t *pixels, uint32_t count) {
    uint32_t bits = 0U;

    for (uint32_t k = 0U; k < count; k++) { /* bound: GROUP - 1 */
        const uint32_t p = ocel_load16(&pixels[k * PIXEL_BYTES]);

        bits |= ((table->word[p >> 5U] >> (p & 31U)) & 1U) << k;
    }
    return bits;
}

ocel_status_t ocel_colour_table_row(const ocel_colour_table_t *table, const uint8_t *line,
                                    size_t line_bytes, uint16_t width, uint32_t *row) {
    ocel_status_t status = OCEL_OK;

    if ((table == NULL) || (line == NULL) || (row == NULL)) {
        status = OCEL_NULL_ARGUMENT;
    } else if ((width == 0U) || (width > (uint16_t)OCEL_MAX_WIDTH)) {
        status = OCEL_BAD_SIZE;
    } else if (line_bytes < ((size_t)width * PIXEL_BYTES)) {
        status = OCEL_BAD_STRIDE;
    } else {
        const uint32_t tail = (uint32_t)width % GROUP;
        const uint32_t whole = (uint32_t)width - tail;
        const ocel_row16_table_t colours = {table->word, table->least, table->headroom};

        /* bytes: 4 * OCEL_ROW_WORDS */
        (void)memset(row, 0, (((size_t)width + 31U) / 32U) * sizeof(row[0]));
        ocel_row16_table(&colours, line, whole, row);
        if (tail > 0U) {
            row[whole / 32U] |= tail_bits(table, &line[(size_t)whole * PIXEL_BYTES], tail)
                                << (whole % 32U);
        }
    }
    return status;
}
