/* SPDX-License-Identifier: MIT
 *
 * A row of bits, read as runs: the columns where a bit differs from its left
 * neighbour are alternately the start of a run and the column past its end.
 * Words without such a column are passed over whole.
 */
#ifndef OCEL_RUN_H
#define OCEL_RUN_H

#include <stdbool.h>
#include <stdint.h>

#include <ocellus/config.h>

#include "int_math.h"

/* The start of the run that is none: right of every column and of every reach. */
#define OCEL_RUN_NONE 0xFFFEU

typedef struct {
    const uint32_t *row;
    uint32_t words;     /* of the row, 1 .. OCEL_ROW_WORDS */
    uint32_t last_mask; /* the bits of the last word that are pixels */
    uint32_t width;
    uint32_t next;  /* the word to be read next */
    uint32_t edges; /* of the word read last: edges not yet taken */
    uint32_t carry; /* its bit 31 */
    uint32_t base;  /* the column of its bit 0 */
    uint32_t start; /* the run in hand: its first pixel, or OCEL_RUN_NONE */
    uint32_t end;   /* one past its last */
} ocel_run_scan_t;

/* Words of a row of `width` pixels, and which bits of the last one are pixels. */
static inline uint32_t ocel_run_words(uint32_t width) {
    return (width + 31U) >> 5U;
}

static inline uint32_t ocel_run_last_mask(uint32_t width) {
    return 0xFFFFFFFFU >> ((0U - width) & 31U);
}

/* Readies the scan of a row.  width 0 .. OCEL_MAX_WIDTH; with 0 there is no row
 * and no run. */
static inline ocel_run_scan_t ocel_run_scan(const uint32_t *row, uint32_t width) {
    ocel_run_scan_t scan = {row, 0U, 0U, width, 0U, 0U, 0U, 0U, 0U, 0U};

    scan.words = ocel_run_words(width);
    scan.last_mask = ocel_run_last_mask(width);
    return scan;
}

/* The first word from `next` on that is not empty, four at a time where there
 * are four, or the row's last, whose upper bits may be anything. */
static inline uint32_t ocel_run_pass_empty(const uint32_t *row, uint32_t words, uint32_t from) {
    uint32_t next = from;

    /* bound: OCEL_ROW_WORDS / 4 */
    while (((next + 4U) < words) &&
           ((row[next] | row[next + 1U] | row[next + 2U] | row[next + 3U]) == 0U)) {
        next += 4U;
    }
    /* bound: OCEL_ROW_WORDS */
    while (((next + 1U) < words) && (row[next] == 0U)) {
        next++;
    }
    return next;
}

/* True when no pixel of the row is set; width >= 1. */
static inline bool ocel_run_row_is_empty(const uint32_t *row, uint32_t width) {
    const uint32_t words = ocel_run_words(width);
    const uint32_t next = ocel_run_pass_empty(row, words, 0U);

    return ((next + 1U) == words) && ((row[next] & ocel_run_last_mask(width)) == 0U);
}

/* Reads the next word; there must be one. */
static inline void ocel_run_read(ocel_run_scan_t *scan) {
    uint32_t word = scan->row[scan->next];

    scan->base = scan->next << 5U;
    scan->next++;
    if (scan->next == scan->words) {
        word &= scan->last_mask;
    }
    scan->edges = word ^ ((word << 1U) | scan->carry);
    scan->carry = word >> 31U;
}

/* Takes the lowest edge; there must be one. */
static inline uint32_t ocel_run_take(ocel_run_scan_t *scan) {
    const uint32_t column = scan->base + ocel_ctz32(scan->edges);

    scan->edges &= scan->edges - 1U;
    return column;
}

/* Finds the next run; its start is OCEL_RUN_NONE when the row has no more. */
static inline void ocel_run_next(ocel_run_scan_t *scan) {
    bool found = true;

    while ((scan->edges == 0U) && found) { /* bound: OCEL_ROW_WORDS */
        scan->next = ocel_run_pass_empty(scan->row, scan->words, scan->next);
        found = scan->next < scan->words;
        if (found) {
            ocel_run_read(scan);
        }
    }
    if (found) {
        scan->start = ocel_run_take(scan);
        while ((scan->edges == 0U) && (scan->next < scan->words)) { /* bound: OCEL_ROW_WORDS */
            ocel_run_read(scan);
        }
        scan->end = (scan->edges != 0U) ? ocel_run_take(scan) : scan->width;
    } else {
        scan->start = OCEL_RUN_NONE;
    }
}

#endif
