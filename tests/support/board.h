/* SPDX-License-Identifier: MIT
 *
 * What changes when a test runs on an emulated board without an FPU.  The rule:
 * every test runs everywhere; only the number of random trials and of steps
 * through exhaustive lists is smaller there, by TEST_TRIALS and TEST_STEP, and
 * bounds are as wide as the platform's own reference is uncertain.  (And what the
 * tests call 512x512 is 384x384: the references' arrays in 16 MB.)
 *
 * OCEL_TEST_REDUCED is the divisor, 1 on the host; a board's tests print it.
 */
#ifndef SUPPORT_BOARD_H
#define SUPPORT_BOARD_H

#include <float.h>

#ifndef OCEL_TEST_REDUCED
#define OCEL_TEST_REDUCED 1
#endif

/* n trials, or the reduced share of them, but not fewer than `least` (<= n), which
 * is what a statistical claim takes. */
#define TEST_TRIALS_AT_LEAST(least, n)                                                             \
    (((n) / OCEL_TEST_REDUCED >= (least)) ? ((n) / OCEL_TEST_REDUCED) : (least))

/* The same where any number will do: 8 at least, for the cases of `trial % 8`. */
#define TEST_TRIALS(n) TEST_TRIALS_AT_LEAST(8, n)

/* The step through all values of a range: 1, or on a board an odd number, so that
 * no bit stands still. */
#define TEST_STEP ((OCEL_TEST_REDUCED == 1) ? 1 : (2 * OCEL_TEST_REDUCED + 1))

/* log2 of what a reference in long double may be off by itself, relatively: long
 * double is double on Arm, and a result takes a few roundings. */
#define TEST_REFERENCE_LOG2 ((LDBL_MANT_DIG >= 64) ? -61 : -50)

#endif
