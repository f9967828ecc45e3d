/* SPDX-License-Identifier: MIT
 *
 * What the tests, the corpus and the reports of this repository ask of a platform.
 * The library asks nothing: a firmware needs no port (README.md).
 */
#ifndef OCELLUS_PORT_H
#define OCELLUS_PORT_H

#include <stdint.h>

/* What the counter counts: `unit` is "insn", "cycles" or "ns", and
 * ticks * mul / div is a number of them. */
typedef struct {
    const char *unit;
    uint32_t mul;
    uint32_t div;
} ocel_port_counter_t;

/* Readies the counter; once, before the first reading. */
ocel_port_counter_t ocel_port_start(void);

/* Reads the counter.  It never goes back and does not wrap within a run. */
uint64_t ocel_port_ticks(void);

/* Writes a text, as it is, to wherever the platform's texts go. */
void ocel_port_write(const char *text);

/* The most stack that was in use since the reset, in bytes, of a stack that the
 * startup painted; 0 where nobody painted it. */
uint32_t ocel_port_stack_used(void);

/* Runs call() on a stack that is painted for it, and says how many bytes of it were
 * used, to the word; 0 where nobody can tell.  No interrupt may have its frame there:
 * before ocel_port_start(), say. */
uint32_t ocel_port_stack_of(void (*call)(void));

#endif
