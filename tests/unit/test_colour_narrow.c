/* SPDX-License-Identifier: MIT
 *
 * The tests of test_colour.c on the line tests for 32-bit machines: the build
 * sets OCEL_WORD_BITS=32 and compiles row16.c and row24.c into this program, so
 * that they stand before the library's own.
 */
#include "test_colour.c"
