/* SPDX-License-Identifier: MIT
 *
 * To be refused: a recursion.
 */
unsigned refused(const volatile unsigned *v, unsigned n);
unsigned refused(const volatile unsigned *v, unsigned n) {
    return (n < 2U) ? n : ((refused(v, n - 1U) * v[n]) ^ refused(v, n - 2U));
}
