/* SPDX-License-Identifier: MIT
 *
 * A board's test says, before it begins, how much it was reduced.
 */
#include <stdio.h>

#include "board.h"

__attribute__((constructor)) static void announce(void) {
    printf("on a board: one random trial in %d (tests/support/board.h)\n", OCEL_TEST_REDUCED);
}
