/* SPDX-License-Identifier: MIT
 *
 * Each function's loops have their bounds beside them; the last one's is wrong.
 */
#include "cases.h"

uint32_t case_straight(uint32_t a, uint32_t b) {
    return ((a ^ b) * 77U) + (a >> 3U);
}

uint32_t case_branch(uint32_t a) {
    uint32_t v = a;
    if (a > 100U) {
        v = (a * a) ^ (a >> 5U) ^ (a * 31U);
    }
    return v + 1U;
}

uint32_t case_loop(const volatile uint32_t *v) {
    uint32_t sum = 0U;
    for (uint32_t i = 0U; i < (uint32_t)TEN; i++) { /* bound: TEN = 10 */
        sum += v[i] * i;
    }
    return sum;
}

uint32_t case_nested(const volatile uint32_t *v) {
    uint32_t sum = 0U;
    for (uint32_t y = 0U; y < (uint32_t)ROWS; y++) {        /* bound: ROWS */
        for (uint32_t x = 0U; x < (uint32_t)COLUMNS; x++) { /* bound: COLUMNS */
            sum = (sum << 1U) + v[x] + (v[y] ^ sum);
        }
    }
    return sum;
}

uint32_t case_triangle(const volatile uint32_t *v) {
    uint32_t sum = 0U;
    for (uint32_t y = 0U; y < (uint32_t)SIDE; y++) { /* bound: SIDE */
        /* bound: SIDE * (SIDE - 1) / 2 in all rounds of the outer loop */
        for (uint32_t x = 0U; x < y; x++) {
            sum = (sum >> 1U) + (v[x] ^ v[y]);
        }
    }
    return sum;
}

uint32_t case_early_exit(const volatile uint32_t *v, uint32_t wanted) {
    uint32_t at = 0U;
    while ((at < (uint32_t)PLACES) && (v[at] != wanted)) { /* bound: PLACES */
        at++;
    }
    return at;
}

__attribute__((noinline)) uint32_t case_callee(uint32_t a) {
    uint32_t rest = a;
    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 */
        rest = (rest >> 7U) ^ (rest * 5U);
    }
    return rest;
}

uint32_t case_calls(const volatile uint32_t *v) {
    uint32_t sum = 0U;
    for (uint32_t i = 0U; i < (uint32_t)TEN; i++) { /* bound: TEN */
        sum += case_callee(v[i]);
    }
    return sum;
}

uint32_t case_bits(uint32_t bits) {
    uint32_t count = 0U;
    for (uint32_t rest = bits; rest != 0U; rest &= rest - 1U) { /* bound: 32 bits */
        count += 3U;
    }
    return count;
}

/* A window whose two ends move PLACES times in all. */
uint32_t case_shared(const volatile uint32_t *v, uint32_t lefts) {
    uint32_t sum = 0U;
    uint32_t i = 0U;
    uint32_t k = 0U;
    /* bound: PLACES; PLACES as moves in a call of case_shared */
    while (i < lefts) {
        sum += v[i] ^ sum;
        i++;
    }
    /* bound: PLACES; PLACES as moves in a call of case_shared */
    while ((i + k) < (uint32_t)PLACES) {
        sum = (sum >> 3U) + (v[k] * 9U);
        k++;
    }
    return sum;
}

/* Something long that happens twice at most. */
uint32_t case_rare(const volatile uint32_t *v) {
    uint32_t sum = 0U;
    uint32_t left = 2U;
    for (uint32_t i = 0U; i < (uint32_t)PLACES; i++) { /* bound: PLACES */
        if ((v[i] != 0U) && (left > 0U)) {
            /* at most: 2 */
            sum += case_callee(sum);
            left--;
        }
    }
    return sum;
}

/* A binary counter: bits that change, two each time in the mean. */
uint32_t case_counter(const volatile uint32_t *v) {
    uint32_t sum = 0U;
    uint32_t count = 0U;
    for (uint32_t i = 0U; i < (uint32_t)PLACES; i++) { /* bound: PLACES */
        uint32_t bit = 1U;
        do { /* bound: 5 bits; 2 a time in a call of case_counter */
            sum = (sum >> 1U) ^ v[bit & 7U];
            count ^= bit;
            bit <<= 1U;
        } while ((count & (bit >> 1U)) == 0U);
    }
    return sum;
}

__attribute__((noinline)) uint32_t case_sum(const volatile uint32_t *v, uint32_t n) {
    uint32_t sum = 0U;
    /* bound: PLACES; 2 in a call of case_through through case_few */
    for (uint32_t i = 0U; i < n; i++) {
        sum = (sum >> 2U) ^ v[i];
    }
    return sum;
}

__attribute__((noinline)) uint32_t case_many(const volatile uint32_t *v) {
    return case_sum(v, (uint32_t)PLACES) + 1U;
}

__attribute__((noinline)) uint32_t case_few(const volatile uint32_t *v) {
    return case_sum(v, 2U) + 3U;
}

/* The same loop, longer one way than the other. */
uint32_t case_through(const volatile uint32_t *v) {
    return case_many(v) ^ case_few(v);
}

uint32_t case_divide(uint32_t a, uint32_t b) {
    return a / b;
}

uint32_t case_wrong(const volatile uint32_t *v, uint32_t count) {
    uint32_t sum = 0U;
    for (uint32_t i = 0U; i < count; i++) { /* bound: TEN */
        sum += v[i];
    }
    return sum;
}
