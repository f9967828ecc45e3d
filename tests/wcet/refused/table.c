/* SPDX-License-Identifier: MIT
 *
 * To be refused: a jump to a computed place (GNU C's computed goto).
 */
unsigned refused(unsigned n);
unsigned refused(unsigned n) {
    static const void *const places[] = {&&one, &&two, &&three};
    __extension__({ goto *places[n % 3U]; });
one:
    return n * 7U;
two:
    return n ^ 55U;
three:
    return n + 1U;
}
