/* SPDX-License-Identifier: MIT
 *
 * Results into the hash, member by member: padding bytes are nobody's.
 */
#include "corpus.h"

void hash_i32s(hash_t *h, const int32_t *v, size_t count) {
    for (size_t i = 0U; i < count; i++) {
        hash_i32(h, v[i]);
    }
}

void hash_i64s(hash_t *h, const int64_t *v, size_t count) {
    for (size_t i = 0U; i < count; i++) {
        hash_i64(h, v[i]);
    }
}

void hash_words(hash_t *h, const uint32_t *v, size_t count) {
    for (size_t i = 0U; i < count; i++) {
        hash_u32(h, v[i]);
    }
}

void hash_blob(hash_t *h, const ocel_blob_t *blob) {
    hash_u32(h, blob->box.left);
    hash_u32(h, blob->box.top);
    hash_u32(h, blob->box.width);
    hash_u32(h, blob->box.height);
    hash_u32(h, blob->first_x);
    hash_u32(h, blob->touches_edge ? 1U : 0U);
    hash_u32(h, blob->area);
    hash_u64(h, blob->sum_x);
    hash_u64(h, blob->sum_y);
    hash_u64(h, blob->sum_xx);
    hash_u64(h, blob->sum_xy);
    hash_u64(h, blob->sum_yy);
}

void hash_stats(hash_t *h, const ocel_label_stats_t *stats) {
    hash_u32(h, stats->runs);
    hash_u32(h, stats->unions);
    hash_u32(h, stats->components);
    hash_u32(h, stats->labels_max);
    hash_u32(h, stats->cracks_max);
}

void hash_ellipse(hash_t *h, const ocel_ellipse_t *ellipse) {
    hash_i32(h, ellipse->cx_px_q16);
    hash_i32(h, ellipse->cy_px_q16);
    hash_i32(h, ellipse->a_px_q16);
    hash_i32(h, ellipse->b_px_q16);
    hash_u32(h, ellipse->angle_turn_q32);
    hash_u32(h, ellipse->rms_px_q16);
    hash_u32(h, ellipse->centre_sigma_px_q16);
    hash_u32(h, ellipse->arc_coverage_q16);
    hash_u32(h, ellipse->point_count);
    hash_enum(h, ellipse->method);
    hash_u32(h, ellipse->perturbed ? 1U : 0U);
}

void hash_cracks(hash_t *h, const ocel_crack_t *cracks, size_t count) {
    hash_u32(h, (uint32_t)count);
    for (size_t i = 0U; i < count; i++) {
        hash_i32(h, cracks[i].x_hpx);
        hash_i32(h, cracks[i].y_hpx);
    }
}

void hash_detection(hash_t *h, const ocel_detection_t *detection) {
    hash_enum(h, detection->status);
    hash_blob(h, &detection->blob);
    hash_ellipse(h, &detection->ellipse);
    hash_u32(h, detection->has_ellipse ? 1U : 0U);
    hash_u32(h, detection->boundary_count);
    hash_u32(h, detection->boundary_stride);
    hash_stats(h, &detection->stats);
}
