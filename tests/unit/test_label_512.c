/* SPDX-License-Identifier: MIT
 *
 * The tests of test_label.c under limits of 512x512 px (sums of 64 bits): the
 * build links the library made so.  Every second pixel of every second row is
 * OpenCV's case of 65536 components.
 */
#include "test_label.c"
