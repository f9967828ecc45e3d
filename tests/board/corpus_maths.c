/* SPDX-License-Identifier: MIT
 *
 * The library's arithmetic, which everything else stands on.  The host's tests
 * hold it to references in long double and 128-bit integers; equal bits carry
 * that over to platforms that have neither.
 */
#include "base/int_math.h"
#include "base/q60.h"
#include "base/trig.h"
#include "corpus.h"
#include "fit/perturb.h"
#include "rng.h"

enum { TRIALS = 4000 };

/* All magnitudes, edges among them: words of noise, of ones and of one bit. */
static uint64_t any_u64(rng_t *rng) {
    const uint32_t shift = rng_below(rng, 64U);
    const uint64_t noise = rng_u64(rng) >> shift;
    switch (rng_below(rng, 4U)) {
    case 0U:
        return (uint64_t)1U << shift;
    case 1U:
        return UINT64_MAX >> shift;
    default:
        return noise;
    }
}

static int64_t any_i64(rng_t *rng, uint32_t bits) {
    const int64_t v = (int64_t)(any_u64(rng) >> (64U - bits));
    return ((rng_u32(rng) & 1U) != 0U) ? -v : v;
}

static void integers(hash_t *h, rng_t *rng) {
    for (uint32_t i = 0U; i < (uint32_t)TRIALS; i++) {
        const uint64_t a = any_u64(rng);
        const uint64_t b = any_u64(rng);
        const int64_t v = any_i64(rng, 62U);
        const uint32_t n = rng_below(rng, 32U);
        hash_u64(h, ocel_udiv64(a, b));
        hash_u32(h, ocel_isqrt64(a));
        hash_u32(h, ocel_ceil_log2(a));
        hash_u32(h, ocel_recip32((uint32_t)b | 0x80000000U));
        hash_u32(h, ocel_clz64(a) + (ocel_clz32((uint32_t)b) << 8U) +
                        (ocel_ctz32((uint32_t)b) << 16U));
        hash_i64(h, ocel_asr64(v, n));
        hash_i32(h, ocel_asr32((int32_t)ocel_asr64(v, 31U), n));
        hash_i64(h, ocel_shift_round64(v, n));
    }
}

static void fixed_point(hash_t *h, rng_t *rng) {
    for (uint32_t i = 0U; i < (uint32_t)TRIALS; i++) {
        const uint64_t p = any_u64(rng);
        const int64_t a = any_i64(rng, 61U);
        const int64_t b = any_i64(rng, 61U);
        int64_t y = 0;
        uint32_t y_short = 0U;
        int32_t e = 0;
        hash_i64(h, ocel_mul_q60(a, b));
        ocel_recip_q60(p, &y, &e);
        hash_i64(h, y);
        hash_i32(h, e);
        ocel_rsqrt_q60(p, &y, &e);
        hash_i64(h, y);
        hash_i32(h, e);
        ocel_recip_short(p, &y_short, &e);
        hash_u32(h, y_short);
        hash_i32(h, e);
        hash_i64(h, ocel_sqrt_q60(p >> 2U));
    }
}

static void angles(hash_t *h, rng_t *rng) {
    for (uint32_t i = 0U; i < (uint32_t)TRIALS; i++) {
        int64_t magnitude = 0;
        uint32_t turn = 0U;
        int32_t sine = 0;
        int32_t cosine = 0;
        int32_t x = (int32_t)any_i64(rng, 26U);
        int32_t y = (int32_t)any_i64(rng, 26U);
        ocel_polar(any_i64(rng, 60U), y, &magnitude, &turn);
        hash_i64(h, magnitude);
        hash_u32(h, turn);
        ocel_sincos(rng_u32(rng), &sine, &cosine);
        hash_i32(h, sine);
        hash_i32(h, cosine);
        ocel_perturb_point(&x, &y);
        hash_i32(h, x);
        hash_i32(h, y);
    }
}

void corpus_maths(hash_t *h) {
    rng_t rng = rng_seed(20110601U);
    integers(h, &rng);
    fixed_point(h, &rng);
    angles(h, &rng);
}
