/* SPDX-License-Identifier: MIT
 *
 * The corpus and the inputs that are meant to take long, one after the other.
 */
#include "corpus.h"
#include "worst.h"

int main(void) {
    static void (*const groups[])(hash_t *h) = {
        corpus_small,  corpus_maths,   corpus_colour, corpus_teach, corpus_label,
        corpus_eye,    corpus_fit,     corpus_camera, corpus_cone,  corpus_head,
        corpus_stereo, corpus_tracker, corpus_gaze};
    hash_t h = HASH_BEGIN;

    for (size_t i = 0U; i < sizeof(groups) / sizeof(groups[0]); i++) {
        groups[i](&h);
    }
    worst_frames();
    worst_colours();
    worst_fits();
    (void)ocel_status_name(OCEL_OVERFLOW);
    return 0;
}
