/* SPDX-License-Identifier: MIT
 *
 * From the reset to main on any Cortex-M, and back to whoever started it: the
 * vector table, the memory's first contents, the painted stack, the exit code.
 * A fault ends the program with exit code 70 and says which fault and where.
 *
 * With OCEL_PORT_STDIO the C library's stdio is readied and closed too (newlib,
 * rdimon.specs); without, main gets nothing but memory.
 */
#include <stdint.h>

#include "port.h"
#include "semihost.h"

#ifndef OCEL_PORT_STDIO
#define OCEL_PORT_STDIO 1
#endif

enum { FAULT_EXIT_CODE = 70, PAINT_WORD = 0x5AFE57AC, SYSTEM_VECTORS = 15 };

/* From board.ld. */
extern uint32_t ocel_data_begin[];
extern uint32_t ocel_data_end[];
extern const uint32_t ocel_data_load[];
extern uint32_t ocel_bss_begin[];
extern uint32_t ocel_bss_end[];
extern uint32_t ocel_stack_limit[];
extern uint32_t ocel_stack_top[];
typedef void (*initializer_t)(void);
extern const initializer_t ocel_init_begin[];
extern const initializer_t ocel_init_end[];

int main(void);
void ocel_reset(void);
void ocel_fault(const uint32_t *stacked);
void SysTick_Handler(void);

#if OCEL_PORT_STDIO
#include <stdlib.h>
void initialise_monitor_handles(void);
#endif

/* ---- Faults ---- */

static void write_hex(const char *name, uint32_t value) {
    char text[11] = "0x";
    for (uint32_t i = 0U; i < 8U; i++) {
        text[2U + i] = "0123456789abcdef"[(value >> (28U - 4U * i)) & 15U];
    }
    text[10] = '\0';
    ocel_port_write(name);
    ocel_port_write(text);
}

/* The frame that the core stacks: r0-r3, r12, lr, pc, xpsr. */
void ocel_fault(const uint32_t *stacked) {
    uint32_t vector = 0U;
    __asm__ volatile("mrs %0, ipsr" : "=r"(vector));
    write_hex("\nfault: vector ", vector);
    write_hex(" pc ", stacked[6]);
    write_hex(" lr ", stacked[5]);
    ocel_port_write("\n");
    semihost_exit(FAULT_EXIT_CODE);
}

__attribute__((naked)) static void fault(void) {
    __asm__ volatile("mrs r0, msp\n"
                     "bl ocel_fault\n"
                     "b .");
}

/* Who counts the timer's wraps (port.c) has a handler of this name. */
__attribute__((weak)) void SysTick_Handler(void) {
    fault();
}

typedef struct {
    uint32_t *stack_top;
    void (*handler[SYSTEM_VECTORS])(void);
} vectors_t;

__attribute__((section(".vectors"), used)) static const vectors_t vectors = {
    ocel_stack_top,
    {ocel_reset, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault,
     fault, SysTick_Handler}};

/* ---- Reset ---- */

/* Up to a little below the stack pointer. */
static void paint_stack(void) {
    uintptr_t sp = 0U;
    __asm__ volatile("mov %0, sp" : "=r"(sp));
    for (volatile uint32_t *at = ocel_stack_limit; (uintptr_t)at < (sp - 32U); at++) {
        *at = PAINT_WORD;
    }
}

uint32_t ocel_port_stack_used(void) {
    const uint32_t *at = ocel_stack_limit;
    while ((at < ocel_stack_top) && (*at == (uint32_t)PAINT_WORD)) {
        at++;
    }
    return (uint32_t)(ocel_stack_top - at) * (uint32_t)sizeof(*at);
}

/* In assembly, so that the paint begins where call() does.  Registers: r1 the place,
 * r2 the paint, r3 where the stack stands; r4 keeps it aligned. */
__attribute__((naked)) uint32_t ocel_port_stack_of(void (*call)(void)) {
    (void)call;
    __asm__ volatile(".syntax unified\n"
                     "push {r4, lr}\n"
                     "ldr r1, =ocel_stack_limit\n"
                     "ldr r2, =%c0\n"
                     "mov r3, sp\n"
                     "1: str r2, [r1]\n"
                     "adds r1, #4\n"
                     "cmp r1, r3\n"
                     "blo 1b\n"
                     "blx r0\n"
                     "ldr r1, =ocel_stack_limit\n"
                     "ldr r2, =%c0\n"
                     "mov r3, sp\n"
                     "2: ldr r0, [r1]\n"
                     "cmp r0, r2\n"
                     "bne 3f\n"
                     "adds r1, #4\n"
                     "cmp r1, r3\n"
                     "blo 2b\n"
                     "3: subs r0, r3, r1\n"
                     "pop {r4, pc}\n"
                     ".ltorg"
                     :
                     : "i"(PAINT_WORD));
}

void ocel_reset(void) {
    const uint32_t *from = ocel_data_load;
    for (uint32_t *to = ocel_data_begin; to < ocel_data_end; to++) {
        *to = *from;
        from++;
    }
    for (uint32_t *to = ocel_bss_begin; to < ocel_bss_end; to++) {
        *to = 0U;
    }
    paint_stack();
#if OCEL_PORT_STDIO
    initialise_monitor_handles();
#endif
    for (const initializer_t *init = ocel_init_begin; init < ocel_init_end; init++) {
        (*init)();
    }
    const int code = main();
#if OCEL_PORT_STDIO
    exit(code);
#else
    semihost_exit((uint32_t)code);
#endif
}

/* The C library's own initializers want these two; there is nothing in them. */
void _init(void);
void _fini(void);
void _init(void) {
}
void _fini(void) {
}
