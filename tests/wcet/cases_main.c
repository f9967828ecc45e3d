/* SPDX-License-Identifier: MIT
 *
 * Calls each case with what takes it longest, and copies of every length and alignment
 * between marks.
 */
#include <stddef.h>
#include <string.h>

#include "cases.h"

void case_mark(void);
int main(void);

static volatile uint32_t values[PLACES];
static uint8_t from[COPIED + 8];
static uint8_t to[COPIED + 8];
static void *(*volatile copy)(void *to, const void *from, size_t n) = memcpy;
static void *(*volatile set)(void *to, int value, size_t n) = memset;
volatile uint32_t case_result;

__attribute__((noinline)) void case_mark(void) {
    __asm__ volatile("" ::: "memory");
}

/* Two marks a copy: tests/wcet/check_cases.py knows the order. */
static void copy_all(void) {
    for (size_t n = 0U; n <= (size_t)COPIED; n++) {
        for (size_t shift = 0U; shift < 16U; shift++) {
            case_mark();
            (void)copy(&to[shift % 4U], &from[shift / 4U], n);
            case_mark();
            (void)set(&to[shift % 4U], (int)shift, n);
            case_mark();
        }
    }
}

static void divide_all(void) {
    for (uint32_t a = 0U; a < 33U; a++) {
        for (uint32_t b = 0U; b < 33U; b++) {
            const uint32_t num = 0xFFFFFFFFU >> (a % 32U);
            const uint32_t den = (0xFFFFFFFFU >> (b % 32U)) - ((b > 31U) ? 0xFFFFFFFEU : 0U);
            case_result += case_divide(num, den) + case_divide(num - a, den);
        }
    }
}

int main(void) {
    case_result += case_straight(1U, 2U) + case_branch(1U) + case_branch(1000U);
    case_result += case_loop(values) + case_nested(values) + case_triangle(values);
    case_result += case_early_exit(values, 7U) + case_calls(values) + case_bits(0xFFFFFFFFU);
    case_result += case_shared(values, 0U) + case_shared(values, PLACES);
    for (uint32_t i = 0U; i < (uint32_t)PLACES; i++) {
        values[i] = i + 100U;
    }
    case_result += case_rare(values) + case_wrong(values, PLACES);
    case_result += case_counter(values) + case_through(values);
    divide_all();
    copy_all();
    return 0;
}
