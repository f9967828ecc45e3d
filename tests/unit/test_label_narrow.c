/* SPDX-License-Identifier: MIT
 *
 * The labelling tests with words of 32 bits, as on a microcontroller, wherever
 * rows are taken a machine word at a time.
 */
#include "test_label.c"
