/* SPDX-License-Identifier: MIT
 *
 * The integer operations that C leaves to the machine or to a helper library,
 * each in one place: right shifts of negatives, bit scans, 64-bit division,
 * the integer square root.
 */
#ifndef OCEL_INT_MATH_H
#define OCEL_INT_MATH_H

#include <stdint.h>

#include "word.h"

/* On the right shift of a negative value.
 *
 * C99 6.5.7 leaves it to the implementation, which has to document what it
 * does.  All that this library is built for (GCC, Clang, Arm Compiler, IAR;
 * two's complement, which intN_t demands) document the arithmetic shift: the
 * sign is copied in, so v >> n is floor(v / 2^n).  The portable spelling,
 * complementing negatives before and after, costs three instructions in the
 * innermost loops where the shift costs one.  So the library relies on the
 * shift, here and nowhere else, and an implementation that does otherwise
 * fails to compile: the array below would have a negative size. */
typedef char ocel_assert_arithmetic_shift_t[((-3 >> 1) == -2) ? 1 : -1];

/* floor(v / 2^n).  Any v; n 0..63. */
static inline int64_t ocel_asr64(int64_t v, uint32_t n) {
    return v >> n;
}

/* floor(v / 2^n).  Any v; n 0..31: where a register has 32 bits, half the instructions of
 * a shift by any number. */
static inline int64_t ocel_asr64_short(int64_t v, uint32_t n) {
#if OCEL_WORD_BITS == 64
    return v >> n;
#else
    const uint32_t high = (uint32_t)((uint64_t)v >> 32U);
    const uint32_t low = ((uint32_t)v >> n) | ((high << 1U) << (31U - n));

    return (int64_t)(((uint64_t)(uint32_t)((int32_t)high >> n) << 32U) | low);
#endif
}

/* floor(v / 2^n).  Any v; n 0..31. */
static inline int32_t ocel_asr32(int32_t v, uint32_t n) {
    return v >> n;
}

/* The int64_t with the same bits.  C99 6.3.1.3 leaves values above INT64_MAX
 * to the implementation; all those above document two's complement. */
static inline int64_t ocel_signed64(uint64_t v) {
    return (int64_t)v;
}

/* v * 2^n, n 0..63, for any v whose product fits.  (<< of a negative value is
 * undefined in C99; this is the same one instruction.) */
static inline int64_t ocel_shl64(int64_t v, uint32_t n) {
    return ocel_signed64((uint64_t)v << n);
}

/* v / 2^n to the nearest integer, halves towards +infinity: the error is in
 * (-1/2, 1/2].  n 0..62; v <= 2^63 - 1 - 2^(n-1), so that adding the half does
 * not overflow.  n = 0 gives v: the half, 2^n / 2, is then 0. */
static inline int64_t ocel_shift_round64(int64_t v, uint32_t n) {
    const int64_t half = ocel_signed64(((uint64_t)1U << n) >> 1U);

    return ocel_asr64(v + half, n);
}

/* -1 for v < 0, else 0.  Compilers make one shift of it. */
static inline int64_t ocel_sign64(int64_t v) {
    return -ocel_signed64((uint64_t)v >> 63U);
}

/* |v| as unsigned, so that INT64_MIN has one too: 2^63. */
static inline uint64_t ocel_abs64(int64_t v) {
    const uint64_t sign = (uint64_t)ocel_sign64(v);

    return ((uint64_t)v ^ sign) - sign;
}

/* Where the compiler has a 128-bit integer (64-bit processors), the exact
 * product of the solve, ocel_mul_q60, uses it.  Its portable twin gives the same
 * bits, and a test holds the two together. */
#if defined(__SIZEOF_INT128__)
__extension__ typedef __int128 ocel_int128_t;
#endif

/* Bit scans.  Where the processor has the instruction the compiler's builtin
 * is it; where it has not (ARMv6-M, RISC-V without Zbb) the builtin calls
 * libgcc, which the library may not, so the portable twin is used there and
 * with any other compiler.  Both give the same answers, 0 included. */
#ifndef OCEL_PORTABLE_BITS
#if !defined(__GNUC__) || defined(__ARM_ARCH_6M__) || defined(__riscv)
#define OCEL_PORTABLE_BITS 1
#else
#define OCEL_PORTABLE_BITS 0
#endif
#endif

/* Leading zeros by halving: five compares, no loop, no table. */
static inline uint32_t ocel_clz32_portable(uint32_t v) {
    uint32_t rest = v;
    uint32_t top = 0U; /* index of the highest set bit, as far as known */
    uint32_t step;

    step = (rest > 0xFFFFU) ? 16U : 0U;
    rest >>= step;
    top += step;
    step = (rest > 0xFFU) ? 8U : 0U;
    rest >>= step;
    top += step;
    step = (rest > 0xFU) ? 4U : 0U;
    rest >>= step;
    top += step;
    step = (rest > 0x3U) ? 2U : 0U;
    rest >>= step;
    top += step;
    /* rest is 0..3 now: 0 only when v is 0. */
    step = (rest > 0x1U) ? 1U : 0U;
    rest >>= step;
    top += step;
    return 32U - (top + rest);
}

/* Leading zeros of v, 0..32; 32 for v = 0. */
static inline uint32_t ocel_clz32(uint32_t v) {
#if OCEL_PORTABLE_BITS
    return ocel_clz32_portable(v);
#else
    return (v == 0U) ? 32U : (uint32_t)__builtin_clz(v);
#endif
}

/* Leading zeros of v, 0..64; 64 for v = 0. */
static inline uint32_t ocel_clz64(uint64_t v) {
#if OCEL_PORTABLE_BITS
    const uint32_t high = (uint32_t)(v >> 32U);

    return (high != 0U) ? ocel_clz32_portable(high) : (32U + ocel_clz32_portable((uint32_t)v));
#else
    return (v == 0U) ? 64U : (uint32_t)__builtin_clzll(v);
#endif
}

/* Trailing zeros of v, 0..32; 32 for v = 0. */
static inline uint32_t ocel_ctz32(uint32_t v) {
#if OCEL_PORTABLE_BITS
    /* The lowest set bit alone, then its index. */
    return (v == 0U) ? 32U : (31U - ocel_clz32_portable(v & (0U - v)));
#else
    return (v == 0U) ? 32U : (uint32_t)__builtin_ctz(v);
#endif
}

/* 1 / m in Q31, for m in Q31: m_q31 in [2^31, 2^32) is [1, 2), the result in
 * [2^30, 2^31] is [1/2, 1].  Relative error below 2^-29 for any m whose upper
 * 32 bits are m_q31. */
uint32_t ocel_recip32(uint32_t m_q31);

/* floor(num / den), any operands, in three trips whatever they are; den = 0
 * gives UINT64_MAX.  (C's own 64-bit division calls a helper on 32-bit
 * processors, whose time depends on the operands.) */
uint64_t ocel_udiv64(uint64_t num, uint64_t den);

/* floor(sqrt(v)) in 32 trips.  Any v; the result is below 2^32. */
uint32_t ocel_isqrt64(uint64_t v);

/* Numbers that are taken together, at most. */
#define OCEL_MAX_VECTOR 6

/* The bits of the largest of so many numbers, 1..OCEL_MAX_VECTOR: the least n, 0..64,
 * with every |v[i]| < 2^n. */
static inline int32_t ocel_bits_of_here(const int64_t *v, uint32_t count) {
    uint64_t all = 0U;
    uint32_t i = 0U;

    do { /* bound: OCEL_MAX_VECTOR; 2 each time in a call of ocel_polar */
        all |= ocel_abs64(v[i]);
        i++;
    } while (i < count);
    return 64 - (int32_t)ocel_clz64(all);
}
#if OCEL_WORD_BITS == 64
static inline int32_t ocel_bits_of(const int64_t *v, uint32_t count) {
    return ocel_bits_of_here(v, count);
}
#else
int32_t ocel_bits_of(const int64_t *v, uint32_t count);
#endif

/* The least e with 2^e >= n; n >= 1, 0 gives 0. */
uint32_t ocel_ceil_log2(uint64_t n);

#endif
