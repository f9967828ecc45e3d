/* SPDX-License-Identifier: MIT
 *
 * To be refused: a copy of which nobody says how long it may be.
 */
#include <string.h>

void refused(char *to, const char *from, unsigned n);
void refused(char *to, const char *from, unsigned n) {
    (void)memcpy(to, from, n);
    to[0] = 'a';
}
