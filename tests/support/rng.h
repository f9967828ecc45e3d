/* SPDX-License-Identifier: MIT
 *
 * Random numbers for tests and benches: xorshift64* (Vigna, "An experimental
 * exploration of Marsaglia's xorshift generators, scrambled", 2016).  A seed
 * gives the same sequence on every machine; print it beside a failure.
 */
#ifndef SUPPORT_RNG_H
#define SUPPORT_RNG_H

#include <math.h>
#include <stdint.h>

typedef struct {
    uint64_t state; /* never 0 */
} rng_t;

/* Any seed; neighbouring seeds give unrelated sequences (splitmix64 step). */
static inline rng_t rng_seed(uint64_t seed) {
    uint64_t z = seed + 0x9E3779B97F4A7C15ULL;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    z ^= z >> 31;
    rng_t rng = {(z == 0U) ? 1U : z};
    return rng;
}

static inline uint64_t rng_u64(rng_t *rng) {
    rng->state ^= rng->state >> 12;
    rng->state ^= rng->state << 25;
    rng->state ^= rng->state >> 27;
    return rng->state * 0x2545F4914F6CDD1DULL;
}

static inline uint32_t rng_u32(rng_t *rng) {
    return (uint32_t)(rng_u64(rng) >> 32);
}

/* Uniform in 0 .. bound - 1; bound > 0.  Biased by less than bound / 2^32. */
static inline uint32_t rng_below(rng_t *rng, uint32_t bound) {
    return (uint32_t)(((uint64_t)rng_u32(rng) * bound) >> 32);
}

/* Uniform in lo .. hi, both included. */
static inline int32_t rng_between(rng_t *rng, int32_t lo, int32_t hi) {
    return (int32_t)(lo + (int64_t)rng_below(rng, (uint32_t)((int64_t)hi - lo + 1)));
}

/* Uniform in [0, 1), 53 bits. */
static inline double rng_unit(rng_t *rng) {
    return (double)(rng_u64(rng) >> 11) * (1.0 / 9007199254740992.0);
}

static inline double rng_uniform(rng_t *rng, double lo, double hi) {
    return lo + (hi - lo) * rng_unit(rng);
}

/* Log-uniform in [lo, hi), 0 < lo. */
static inline double rng_log_uniform(rng_t *rng, double lo, double hi) {
    return lo * exp(rng_unit(rng) * log(hi / lo));
}

/* Normal, mean 0, variance 1 (Marsaglia's polar method, one of the pair). */
static inline double rng_gauss(rng_t *rng) {
    double u = 0.0;
    double v = 0.0;
    double s = 0.0;
    do {
        u = 2.0 * rng_unit(rng) - 1.0;
        v = 2.0 * rng_unit(rng) - 1.0;
        s = u * u + v * v;
    } while ((s >= 1.0) || (s == 0.0));
    return u * sqrt(-2.0 * log(s) / s);
}

/* Fisher-Yates over indices 0 .. count - 1. */
static inline void rng_shuffle(rng_t *rng, uint32_t *index, uint32_t count) {
    for (uint32_t i = 0; i < count; i++) {
        index[i] = i;
    }
    for (uint32_t i = count; i > 1U; i--) {
        const uint32_t j = rng_below(rng, i);
        const uint32_t swap = index[i - 1U];
        index[i - 1U] = index[j];
        index[j] = swap;
    }
}

#endif
