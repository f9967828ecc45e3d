/* SPDX-License-Identifier: MIT
 *
 * The tests of test_boundary.c with a pool of 64 cells, for frames of at most
 * 64x64 px: the build links the library made so.
 */
#include "test_boundary.c"
