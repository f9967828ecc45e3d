/* SPDX-License-Identifier: MIT
 *
 * The corpus: inputs, plain and hostile, through every public function, and a hash
 * of every result.  Integers only, no files, no C library but memset: the same
 * program on the host and on a board must say the same.
 *
 * A group is a function that feeds results to a hash.  To add one: write
 * `void corpus_<name>(hash_t *h)`, declare it here, list it in corpus.c, and run
 * `tools/check_bits.sh --update`.
 */
#ifndef BOARD_CORPUS_H
#define BOARD_CORPUS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <ocellus/ocellus.h>

/* FNV-1a, 64 bits (Fowler, Noll, Vo). */
typedef uint64_t hash_t;
#define HASH_BEGIN ((hash_t)0xCBF29CE484222325ULL)

static inline void hash_bits(hash_t *h, uint64_t v, uint32_t bytes) {
    for (uint32_t i = 0U; i < bytes; i++) {
        *h = (*h ^ ((v >> (8U * i)) & 0xFFU)) * 0x100000001B3ULL;
    }
}

/* Every number goes in by its value, in 4 or 8 bytes, whatever its type's size. */
static inline void hash_u32(hash_t *h, uint32_t v) {
    hash_bits(h, v, 4U);
}

static inline void hash_i32(hash_t *h, int32_t v) {
    hash_bits(h, (uint32_t)v, 4U);
}

static inline void hash_u64(hash_t *h, uint64_t v) {
    hash_bits(h, v, 8U);
}

static inline void hash_i64(hash_t *h, int64_t v) {
    hash_bits(h, (uint64_t)v, 8U);
}

/* Statuses, methods and the like: an enumeration's size is the compiler's choice. */
#define hash_enum(h, v) hash_u32((h), (uint32_t)(v))

void hash_i32s(hash_t *h, const int32_t *v, size_t count);
void hash_i64s(hash_t *h, const int64_t *v, size_t count);
void hash_words(hash_t *h, const uint32_t *v, size_t count);
void hash_blob(hash_t *h, const ocel_blob_t *blob);
void hash_stats(hash_t *h, const ocel_label_stats_t *stats);
void hash_ellipse(hash_t *h, const ocel_ellipse_t *ellipse);
void hash_cracks(hash_t *h, const ocel_crack_t *cracks, size_t count);
void hash_detection(hash_t *h, const ocel_detection_t *detection);

/* ---- The groups ---- */

void corpus_maths(hash_t *h);
void corpus_small(hash_t *h); /* 160x120 and 1024 cells: the microbit's 16 KB hold it */
void corpus_colour(hash_t *h);
void corpus_teach(hash_t *h);
void corpus_label(hash_t *h);
void corpus_eye(hash_t *h);
void corpus_fit(hash_t *h);
void corpus_camera(hash_t *h);
void corpus_cone(hash_t *h);
void corpus_head(hash_t *h);
void corpus_stereo(hash_t *h);
void corpus_tracker(hash_t *h);
void corpus_gaze(hash_t *h);

#endif
