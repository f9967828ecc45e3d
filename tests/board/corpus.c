/* SPDX-License-Identifier: MIT
 *
 * Runs the corpus's groups and says a hash for each and one for all.  Built with
 * CORPUS_SMALL it is the group that 16 KB of RAM hold, and the stack it took.
 */
#include "corpus.h"
#include "port.h"

typedef struct {
    const char *name;
    void (*run)(hash_t *h);
} group_t;

static const group_t groups[] = {
    {"small", corpus_small},
#ifndef CORPUS_SMALL
    {"maths", corpus_maths},   {"colour", corpus_colour},   {"teach", corpus_teach},
    {"label", corpus_label},   {"eye", corpus_eye},         {"fit", corpus_fit},
    {"camera", corpus_camera}, {"cone", corpus_cone},       {"head", corpus_head},
    {"stereo", corpus_stereo}, {"tracker", corpus_tracker}, {"gaze", corpus_gaze},
#endif
};

static void say(const char *name, hash_t h) {
    char text[19] = " ";
    for (uint32_t i = 0U; i < 16U; i++) {
        text[1U + i] = "0123456789abcdef"[(h >> (60U - 4U * i)) & 15U];
    }
    text[17] = '\n';
    text[18] = '\0';
    ocel_port_write(name);
    ocel_port_write(text);
}

int main(void) {
    hash_t all = HASH_BEGIN;
    for (size_t i = 0U; i < sizeof(groups) / sizeof(groups[0]); i++) {
        hash_t h = HASH_BEGIN;
        groups[i].run(&h);
        hash_u64(&all, h);
        say(groups[i].name, h);
    }
#ifdef CORPUS_SMALL
    say("stack", ocel_port_stack_used());
#else
    say("all", all);
#endif
    return 0;
}
