/* SPDX-License-Identifier: MIT
 *
 * Formulas as tables: on a 32-bit core a product of two 64-bit numbers is some twenty
 * bytes of code to call for and three to write down, and a fit takes a hundred of them.
 */
#ifndef OCELLUS_TERMS_H
#define OCELLUS_TERMS_H

#include <stdint.h>

/* r[a] * r[b], added to the sum so far. */
typedef struct {
    uint8_t to; /* where the sum goes when this is its last term, and the flags below */
    uint8_t a;
    uint8_t b;
} ocel_term_t;

/* The sum goes on with the next term: place 0 is for what no sum is. */
#define OCEL_GOES_ON 0x00U
#define OCEL_MINUS 0x40U /* the product is subtracted */
#define OCEL_LAST 0x80U  /* the last term of the table */
#define OCEL_PLACE 0x3FU /* what is not a flag */

/* The longest table. */
#define OCEL_MAX_TERMS 40

/* Evaluates the sums of a table, in its order, on numbers in Q60: each |r[a]|, |r[b]| is
 * below 2 and each partial sum below 8.  A product is floored (ocel_mul_q60), so a sum of
 * n is off by less than n LSB. */
void ocel_sum_terms(int64_t *r_q60, const ocel_term_t *terms);

#endif
