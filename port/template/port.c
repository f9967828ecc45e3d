/* SPDX-License-Identifier: MIT
 *
 * The port to copy: as it stands it compiles everywhere, counts nothing and
 * writes nowhere, so the corpus runs but says its hashes to nobody.  Fill in, in
 * this order: the text, the counter, the stack.
 */
#include "port.h"

/* A UART's data register, say: wait until it is free, then store. */
static void put(char c) {
    (void)c;
}

void ocel_port_write(const char *text) {
    for (const char *at = text; *at != '\0'; at++) {
        put(*at);
    }
}

/* Start a free-running counter and say what it counts.  A counter of fewer than
 * 64 bits needs its wraps counted, by an interrupt (arm/port.c) or because it is
 * read often enough. */
ocel_port_counter_t ocel_port_start(void) {
    const ocel_port_counter_t counter = {"cycles", 1U, 1U};
    return counter;
}

uint64_t ocel_port_ticks(void) {
    return 0U;
}

/* Paint the stack in the startup, below the stack pointer, and look here how far
 * down the paint is gone. */
uint32_t ocel_port_stack_used(void) {
    return 0U;
}

/* Paint it below the stack pointer, without a frame of one's own between, as
 * arm/startup.c does. */
uint32_t ocel_port_stack_of(void (*call)(void)) {
    call();
    return 0U;
}
