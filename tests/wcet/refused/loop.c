/* SPDX-License-Identifier: MIT
 *
 * To be refused: a loop without a bound.
 */
unsigned refused(const volatile unsigned *v, unsigned n);
unsigned refused(const volatile unsigned *v, unsigned n) {
    unsigned sum = 0U;
    for (unsigned i = 0U; i < n; i++) {
        sum += v[i];
    }
    return sum;
}
