/* SPDX-License-Identifier: MIT
 *
 * The tests of test_boundary.c with a pool of 65534 cells, which holds more
 * points than a fit takes: the build links the library made so.
 */
#include "test_boundary.c"
