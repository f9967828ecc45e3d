/* SPDX-License-Identifier: MIT
 *
 * To be refused: a call through a pointer.
 */
unsigned refused(unsigned (*f)(unsigned), unsigned n);
unsigned refused(unsigned (*f)(unsigned), unsigned n) {
    return f(n) + 1U;
}
