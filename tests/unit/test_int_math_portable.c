/* SPDX-License-Identifier: MIT
 *
 * The same tests with the bit scans that need no instruction of the processor:
 * what Cortex-M0 and other compilers run.
 */
#define OCEL_PORTABLE_BITS 1
#include "test_int_math.c"
