/* SPDX-License-Identifier: MIT
 *
 * Small functions whose worst case is known, for the tests of tools/wcet.py.
 */
#ifndef WCET_CASES_H
#define WCET_CASES_H

#include <stdint.h>

enum { TEN = 10, ROWS = 4, COLUMNS = 5, SIDE = 8, PLACES = 16, COPIED = 70 };

uint32_t case_straight(uint32_t a, uint32_t b);
uint32_t case_branch(uint32_t a);
uint32_t case_loop(const volatile uint32_t *v);
uint32_t case_nested(const volatile uint32_t *v);
uint32_t case_triangle(const volatile uint32_t *v);
uint32_t case_early_exit(const volatile uint32_t *v, uint32_t wanted);
uint32_t case_callee(uint32_t a);
uint32_t case_calls(const volatile uint32_t *v);
uint32_t case_bits(uint32_t bits);
uint32_t case_shared(const volatile uint32_t *v, uint32_t lefts);
uint32_t case_rare(const volatile uint32_t *v);
uint32_t case_counter(const volatile uint32_t *v);
uint32_t case_sum(const volatile uint32_t *v, uint32_t n);
uint32_t case_many(const volatile uint32_t *v);
uint32_t case_few(const volatile uint32_t *v);
uint32_t case_through(const volatile uint32_t *v);
uint32_t case_divide(uint32_t a, uint32_t b);
uint32_t case_wrong(const volatile uint32_t *v, uint32_t count);

#endif
