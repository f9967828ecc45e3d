/* SPDX-License-Identifier: MIT */
#include "terms.h"

#include "q60.h"

void ocel_sum_terms(int64_t *r_q60, const ocel_term_t *terms) {
    const ocel_term_t *term = terms;
    int64_t sum = 0;
    uint32_t flags;

    do { /* bound: OCEL_MAX_TERMS */
        const int64_t product = ocel_mul_q60(r_q60[term->a], r_q60[term->b]);
        uint32_t to;

        flags = term->to;
        to = flags & OCEL_PLACE;
        sum += ((flags & OCEL_MINUS) != 0U) ? -product : product;
        if (to != OCEL_GOES_ON) {
            r_q60[to] = sum;
            sum = 0;
        }
        term++;
    } while ((flags & OCEL_LAST) == 0U);
}
