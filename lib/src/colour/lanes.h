/* SPDX-License-Identifier: MIT
 *
 * Several pixels in one machine word: loads, range tests and the gathering of
 * the answers, in portable C.  A lane is a byte of the word; no operation here
 * carries from one lane into the next, and each says why.
 */
#ifndef OCEL_LANES_H
#define OCEL_LANES_H

#include <stdint.h>

#include "../base/word.h"

#define OCEL_WORD_BYTES ((uint32_t)OCEL_WORD_BITS / 8U)

/* Pixels that are tested at once: a byte each. */
#define OCEL_GROUP OCEL_WORD_BYTES

/* Four bytes over and over. */
#if OCEL_WORD_BITS == 64
#define OCEL_REPEATED(v) ((uint64_t)(v) * UINT64_C(0x0000000100000001))
#else
#define OCEL_REPEATED(v) (v)
#endif

#define OCEL_LOW_BITS OCEL_REPEATED(0x01010101U)   /* bit 0 of each byte */
#define OCEL_LOW_SEVEN OCEL_REPEATED(0x7F7F7F7FU)  /* bits 6..0 */
#define OCEL_TOP_BITS OCEL_REPEATED(0x80808080U)   /* bit 7 */
#define OCEL_EVEN_BYTES OCEL_REPEATED(0x00FF00FFU) /* bytes 0, 2, ... */

/* Little-endian loads from any address.  Spelt in bytes, so that the machine's
 * own order and alignment do not matter; GCC and Clang make one load of it
 * where both allow. */
static inline uint32_t ocel_load16(const uint8_t *p) {
    return (uint32_t)p[0] | ((uint32_t)p[1] << 8U);
}

static inline uint32_t ocel_load32(const uint8_t *p) {
    return (uint32_t)p[0] | ((uint32_t)p[1] << 8U) | ((uint32_t)p[2] << 16U) |
           ((uint32_t)p[3] << 24U);
}

static inline ocel_word_t ocel_load_word(const uint8_t *p) {
#if OCEL_WORD_BITS == 64
    return (uint64_t)ocel_load32(p) | ((uint64_t)ocel_load32(&p[4]) << 32U);
#else
    return ocel_load32(p);
#endif
}

/* x rotated right by `bits`, below OCEL_WORD_BITS. */
static inline ocel_word_t ocel_rotate_right(ocel_word_t x, uint32_t bits) {
    return (x >> bits) |
           (x << (((uint32_t)OCEL_WORD_BITS - bits) & ((uint32_t)OCEL_WORD_BITS - 1U)));
}

/* A half-open range of byte values, begin <= v < end, 0 <= begin <= end <= 256.
 *
 * A lane has no room for a guard bit beside 8 bits, so v is tested by its upper
 * seven: v >= n exactly when floor(v/2) + (v & n & 1) >= ceil(n/2), which is
 * when the left side + 128 - ceil(n/2) reaches bit 7.  That sum is at most 255,
 * so nothing is carried on: for even n, 127 + 128; for odd n, ceil(n/2) >= 1,
 * 127 + 1 + 127.  And v is in range when it is at least begin and not at least
 * end; as begin <= end, the latter's negation is implied by the former's, so
 * the exclusive or of the two bits 7 says it: for all lanes at once. */
typedef struct {
    ocel_word_t begin;     /* 128 - ceil(begin / 2) in each byte */
    ocel_word_t end;       /* the same of end */
    ocel_word_t begin_odd; /* begin & 1 in each byte */
    ocel_word_t end_odd;
} ocel_lane_range_t;

/* Ranges are kept four bytes wide, in this order. */
enum { OCEL_LANES_BEGIN = 0, OCEL_LANES_END, OCEL_LANES_BEGIN_ODD, OCEL_LANES_END_ODD };

/* begin0 and end0 for bytes 0 and 1, begin1 and end1 for bytes 2 and 3. */
static inline void ocel_lanes_set(uint32_t lanes[4], uint32_t begin0, uint32_t end0,
                                  uint32_t begin1, uint32_t end1) {
    const uint32_t low = 0x00000101U;
    const uint32_t high = 0x01010000U;

    lanes[OCEL_LANES_BEGIN] =
        0x80808080U - ((low * ((begin0 + 1U) >> 1U)) + (high * ((begin1 + 1U) >> 1U)));
    lanes[OCEL_LANES_END] =
        0x80808080U - ((low * ((end0 + 1U) >> 1U)) + (high * ((end1 + 1U) >> 1U)));
    lanes[OCEL_LANES_BEGIN_ODD] = (low * (begin0 & 1U)) + (high * (begin1 & 1U));
    lanes[OCEL_LANES_END_ODD] = (low * (end0 & 1U)) + (high * (end1 & 1U));
}

static inline ocel_lane_range_t ocel_lane_range(const uint32_t lanes[4]) {
    const ocel_lane_range_t range = {
        OCEL_REPEATED(lanes[OCEL_LANES_BEGIN]), OCEL_REPEATED(lanes[OCEL_LANES_END]),
        OCEL_REPEATED(lanes[OCEL_LANES_BEGIN_ODD]), OCEL_REPEATED(lanes[OCEL_LANES_END_ODD])};

    return range;
}

/* Bit 7 of each byte says whether the byte is in range; the others say nothing. */
static inline ocel_word_t ocel_lanes_in(ocel_word_t bytes, const ocel_lane_range_t *range) {
    const ocel_word_t half = (bytes >> 1U) & OCEL_LOW_SEVEN;

    return (half + range->begin + (bytes & range->begin_odd)) ^
           (half + range->end + (bytes & range->end_odd));
}

/* The same from half = floor(v/2) alone, and so with one level more at an end
 * that is odd: it never denies a byte in range.  The odd bits make the begin
 * floor(begin/2); half + begin + begin_odd <= 127 + 128. */
static inline ocel_word_t ocel_lanes_may_be_in(ocel_word_t half, const ocel_lane_range_t *range) {
    return (half + (range->begin + range->begin_odd)) ^ (half + range->end);
}

/* The order in which pixels stand in a word, as the multiplier that gathers bit
 * 0 of each byte into the word's top byte (64 bits) or top four bits (32),
 * pixel k to bit k of them: byte p, which holds pixel k, has the term
 * 2^(T + k - 8p), T = 56 or 28.  Byte p meets the term of another byte q, of
 * pixel j, at T + j - 8 (q - p).  With q > p that is below bit T, and different
 * for different (q - p, j), so nothing is carried; with q < p it is beyond the
 * word. */
#if OCEL_WORD_BITS == 64
#define OCEL_ORDER_PLAIN UINT64_C(0x0102040810204080)     /* pixel k in byte k */
#define OCEL_ORDER_BY_THREES UINT64_C(0x0108400210800420) /* pixel k in byte 3k mod 8 */
#define OCEL_ORDER_EVEN_ODD UINT64_C(0x0110022004400880)  /* bytes 0 2 4 6, then 1 3 5 7 */
#define OCEL_GATHER_SHIFT 56U
#else
#define OCEL_ORDER_PLAIN UINT32_C(0x10204080)
#define OCEL_ORDER_BY_THREES UINT32_C(0x10804020) /* pixel k in byte 3k mod 4 */
#define OCEL_ORDER_EVEN_ODD UINT32_C(0x10402080)  /* bytes 0 2, then 1 3 */
#define OCEL_GATHER_SHIFT 28U
#endif

/* Bits 7 of the bytes of flags, gathered: pixel k in bit k. */
static inline uint32_t ocel_gather(ocel_word_t flags, ocel_word_t order) {
    return (uint32_t)((((flags >> 7U) & OCEL_LOW_BITS) * order) >> OCEL_GATHER_SHIFT);
}

#endif
