/* SPDX-License-Identifier: MIT
 *
 * The port for a hosted system: nanoseconds by the system's clock.
 */
#include <stdio.h>
#include <time.h>

#include "port.h"

ocel_port_counter_t ocel_port_start(void) {
    const ocel_port_counter_t counter = {"ns", 1U, 1U};
    return counter;
}

uint64_t ocel_port_ticks(void) {
    struct timespec now;
    (void)timespec_get(&now, TIME_UTC);
    return ((uint64_t)now.tv_sec * 1000000000U) + (uint64_t)now.tv_nsec;
}

void ocel_port_write(const char *text) {
    (void)fputs(text, stdout);
}

uint32_t ocel_port_stack_used(void) {
    return 0U;
}

uint32_t ocel_port_stack_of(void (*call)(void)) {
    call();
    return 0U;
}
