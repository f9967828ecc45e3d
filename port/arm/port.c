/* SPDX-License-Identifier: MIT
 *
 * The port for Cortex-M: cycles by the DWT unit where it runs, else the SysTick
 * timer, its wraps counted by its interrupt.  QEMU's DWT stands still, so there
 * it is SysTick; with -icount shift=7 an instruction lasts 128 ns of its clock
 * (OCEL_PORT_SYSTICK_HZ), so ticks tell instructions to +-1.  The interrupt's own
 * instructions, about 5 in 5 million at 25 MHz, are in the count.
 *
 * Registers: Armv7-M Architecture Reference Manual (DDI 0403E), B3.3 and C1.8.
 */
#include <stdbool.h>

#include "port.h"
#include "semihost.h"

#ifndef OCEL_PORT_SYSTICK_HZ
#error "OCEL_PORT_SYSTICK_HZ: the board's SysTick clock"
#endif

enum { INSN_NS = 128, WRAP = 1 << 24 };

#define REGISTER(address) (*(volatile uint32_t *)(uintptr_t)(address))
#define SYST_CSR REGISTER(0xE000E010U)
#define SYST_RVR REGISTER(0xE000E014U)
#define SYST_CVR REGISTER(0xE000E018U)
#define ICSR REGISTER(0xE000ED04U)
#define DEMCR REGISTER(0xE000EDFCU)
#define DWT_CTRL REGISTER(0xE0001000U)
#define DWT_CYCCNT REGISTER(0xE0001004U)

static volatile uint32_t wraps;
static uint32_t last; /* DWT: the last reading, to see a wrap by */
static bool dwt;

void SysTick_Handler(void);
void SysTick_Handler(void) {
    wraps++;
}

/* The DWT counter: there is none on Armv6-M, and it may not move. */
static bool dwt_runs(void) {
#if defined(__ARM_ARCH_6M__)
    return false;
#else
    DEMCR |= 1U << 24; /* TRCENA */
    DWT_CYCCNT = 0U;
    DWT_CTRL |= 1U; /* CYCCNTENA */
    __asm__ volatile("nop\nnop\nnop\nnop");
    return DWT_CYCCNT != 0U;
#endif
}

ocel_port_counter_t ocel_port_start(void) {
    ocel_port_counter_t counter = {"cycles", 1U, 1U};
    dwt = dwt_runs();
    if (!dwt) {
        counter.unit = "insn";
        counter.mul = 1000000U;
        counter.div = (OCEL_PORT_SYSTICK_HZ / 1000U) * INSN_NS;
        SYST_RVR = WRAP - 1;
        SYST_CVR = 0U;
        SYST_CSR = 7U; /* the core's clock, interrupt, run */
    }
    return counter;
}

/* Read between two readings of the wraps that agree, with no wrap waiting. */
static uint64_t systick(void) {
    uint32_t high = 0U;
    uint32_t low = 0U;
    do {
        high = wraps;
        low = (uint32_t)(WRAP - 1) - SYST_CVR;
    } while ((high != wraps) || ((ICSR & (1U << 26)) != 0U));
    return ((uint64_t)high << 24) | low;
}

uint64_t ocel_port_ticks(void) {
    if (!dwt) {
        return systick();
    }
    const uint32_t now = DWT_CYCCNT; /* 2^32 cycles are 25 s at 168 MHz: read it within */
    wraps += (now < last) ? 1U : 0U;
    last = now;
    return ((uint64_t)wraps << 32) | now;
}

void ocel_port_write(const char *text) {
    (void)semihost(SEMIHOST_WRITE0, text);
}
