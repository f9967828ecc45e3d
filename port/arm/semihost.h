/* SPDX-License-Identifier: MIT
 *
 * A word to the debugger or the emulator: Arm's semihosting, "Semihosting for
 * AArch32 and AArch64", release 2.0.
 */
#ifndef OCELLUS_PORT_SEMIHOST_H
#define OCELLUS_PORT_SEMIHOST_H

#include <stdint.h>

enum { SEMIHOST_WRITE0 = 0x04, SEMIHOST_EXIT_EXTENDED = 0x20, SEMIHOST_APPLICATION_EXIT = 0x20026 };

static inline uintptr_t semihost(uintptr_t operation, const void *argument) {
    register uintptr_t r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

static inline void semihost_exit(uint32_t code) {
    const uint32_t block[2] = {SEMIHOST_APPLICATION_EXIT, code};
    (void)semihost(SEMIHOST_EXIT_EXTENDED, block);
}

#endif
