/* SPDX-License-Identifier: MIT
 *
 * A TCG plugin for QEMU: what the program executes between marks and in each call
 * of a function, by tables that wcet/observe.py writes.  QEMU's packages have no
 * header for plugins, so what is used of the interface (QEMU 7.2,
 * docs/devel/tcg-plugins, version 1) is declared here.
 *
 * arguments: table=FILE out=FILE
 *
 * The table, a line each, addresses and costs in decimal:
 *   I address is_call typ max taken_typ taken_max    an instruction
 *   F address name                                   a function to watch
 *   M address                                        a place that is a mark
 * The answer:
 *   M insn typ max                    each arrival at a mark: all counted so far
 *   F name calls insn typ max         the most that one call took, each by itself
 *   B address end executions taken    a block
 */
#include <inttypes.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- QEMU's side ---- */

typedef uint64_t qemu_plugin_id_t;
struct qemu_plugin_tb;
struct qemu_plugin_insn;
typedef struct qemu_info_t qemu_info_t;
typedef void (*tb_trans_cb_t)(qemu_plugin_id_t id, struct qemu_plugin_tb *tb);
typedef void (*exec_cb_t)(unsigned int vcpu, void *data);
typedef void (*exit_cb_t)(qemu_plugin_id_t id, void *data);

void qemu_plugin_register_vcpu_tb_trans_cb(qemu_plugin_id_t id, tb_trans_cb_t cb);
void qemu_plugin_register_vcpu_tb_exec_cb(struct qemu_plugin_tb *tb, exec_cb_t cb, int flags,
                                          void *data);
void qemu_plugin_register_atexit_cb(qemu_plugin_id_t id, exit_cb_t cb, void *data);
size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *tb);
uint64_t qemu_plugin_tb_vaddr(const struct qemu_plugin_tb *tb);
struct qemu_plugin_insn *qemu_plugin_tb_get_insn(const struct qemu_plugin_tb *tb, size_t index);
uint64_t qemu_plugin_insn_vaddr(const struct qemu_plugin_insn *insn);
size_t qemu_plugin_insn_size(const struct qemu_plugin_insn *insn);

extern __attribute__((visibility("default"))) int qemu_plugin_version;
int qemu_plugin_version = 1;

/* ---- The tables ---- */

enum { COUNTERS = 3, CODE_BYTES = 1 << 22, FUNCTIONS = 512, DEPTH = 64, NAME = 64 };

typedef struct {
    uint64_t of[COUNTERS]; /* instructions, cycles typ, cycles max */
} counts_t;

typedef struct {
    uint8_t cost[2];
    uint8_t taken[2];
    bool known;
    bool is_call;
    bool is_mark;
    uint16_t function; /* that begins here, and 1; 0: none */
} place_t;

typedef struct {
    char name[NAME];
    uint64_t calls;
    counts_t most;
} function_t;

typedef struct block {
    struct block *next;
    uint64_t begin;
    uint64_t end;
    uint64_t executions;
    uint64_t times_taken;
    counts_t cost;
    counts_t taken;
    const place_t *first;
    const place_t *last;
} block_t;

typedef struct {
    uint16_t function;
    uint64_t back; /* where it returns to */
    counts_t begin;
} call_t;

static place_t *places; /* one for every two bytes of code, from address 0 */
static function_t functions[FUNCTIONS];
static uint16_t function_count;
static block_t *blocks;
static block_t *before; /* the block executed last */
static counts_t now;
static call_t stack[DEPTH];
static int depth;
static FILE *out;

static const place_t nothing;

static place_t *place_at(uint64_t address) {
    return (address < CODE_BYTES) ? &places[address / 2U] : NULL;
}

static void fail(const char *why, const char *what) {
    (void)fprintf(stderr, "profile: %s %s\n", why, what);
    exit(1);
}

static void read_line(const char *line) {
    char name[NAME] = "";
    uint64_t address = 0;
    int v[5] = {0};
    if (sscanf(line, "I %" SCNu64 " %d %d %d %d %d", &address, &v[0], &v[1], &v[2], &v[3], &v[4]) ==
            6 &&
        place_at(address) != NULL) {
        place_t *place = place_at(address);
        place->known = true;
        place->is_call = v[0] != 0;
        for (int k = 0; k < 2; k++) {
            place->cost[k] = (uint8_t)v[1 + k];
            place->taken[k] = (uint8_t)v[3 + k];
        }
    } else if (sscanf(line, "F %" SCNu64 " %63s", &address, name) == 2 &&
               place_at(address) != NULL && function_count < FUNCTIONS - 1) {
        memcpy(functions[function_count].name, name, NAME);
        place_at(address)->function = ++function_count;
    } else if (sscanf(line, "M %" SCNu64, &address) == 1 && place_at(address) != NULL) {
        place_at(address)->is_mark = true;
    } else {
        fail("bad line in the table:", line);
    }
}

static void read_table(const char *path) {
    char line[256];
    FILE *file = fopen(path, "r");
    if (file == NULL) {
        fail("cannot read", path);
    }
    while (fgets(line, sizeof(line), file) != NULL) {
        read_line(line);
    }
    (void)fclose(file);
}

/* ---- Counting ---- */

static void add(counts_t *to, const counts_t *from) {
    for (int k = 0; k < COUNTERS; k++) {
        to->of[k] += from->of[k];
    }
}

static void leave_call(void) {
    const call_t *call = &stack[--depth];
    function_t *function = &functions[call->function - 1];
    function->calls++;
    for (int k = 0; k < COUNTERS; k++) {
        const uint64_t took = now.of[k] - call->begin.of[k];
        if (took > function->most.of[k]) {
            function->most.of[k] = took;
        }
    }
}

/* A function is entered by a call, or by a jump from the end of another, which then
 * returns where that one would have. */
static void enter_call(const block_t *block) {
    const bool is_call = (before != NULL) && before->last->is_call;
    if (depth == DEPTH || (!is_call && depth == 0)) {
        return;
    }
    stack[depth].back = is_call ? before->end : stack[depth - 1].back;
    stack[depth].function = block->first->function;
    stack[depth].begin = now;
    depth++;
}

static void on_block(unsigned int vcpu, void *data) {
    block_t *block = data;
    (void)vcpu;
    if (before != NULL && before->end != block->begin) {
        before->times_taken++;
        add(&now, &before->taken);
    }
    while (depth > 0 && stack[depth - 1].back == block->begin) {
        leave_call();
    }
    if (block->first->is_mark) {
        (void)fprintf(out, "M %" PRIu64 " %" PRIu64 " %" PRIu64 "\n", now.of[0], now.of[1],
                      now.of[2]);
    }
    if (block->first->function != 0) {
        enter_call(block);
    }
    block->executions++;
    add(&now, &block->cost);
    before = block;
}

static void on_translation(qemu_plugin_id_t id, struct qemu_plugin_tb *tb) {
    const size_t count = qemu_plugin_tb_n_insns(tb);
    block_t *block = calloc(1, sizeof(*block));
    (void)id;
    block->begin = qemu_plugin_tb_vaddr(tb);
    block->first = block->last = &nothing;
    for (size_t i = 0; i < count; i++) {
        const struct qemu_plugin_insn *insn = qemu_plugin_tb_get_insn(tb, i);
        const uint64_t address = qemu_plugin_insn_vaddr(insn);
        const place_t *place = place_at(address);
        if (place == NULL) {
            place = &nothing;
        }
        block->end = address + qemu_plugin_insn_size(insn);
        block->last = place;
        block->first = (i == 0) ? place : block->first;
        block->cost.of[0] += place->known ? 1U : 0U;
        for (int k = 0; k < 2; k++) {
            block->cost.of[1 + k] += place->cost[k];
            block->taken.of[1 + k] = place->taken[k]; /* the last one's */
        }
    }
    block->next = blocks;
    blocks = block;
    qemu_plugin_register_vcpu_tb_exec_cb(tb, on_block, 0, block);
}

static void at_exit(qemu_plugin_id_t id, void *data) {
    (void)id;
    (void)data;
    for (uint16_t i = 0; i < function_count; i++) {
        const function_t *f = &functions[i];
        (void)fprintf(out, "F %s %" PRIu64 " %" PRIu64 " %" PRIu64 " %" PRIu64 "\n", f->name,
                      f->calls, f->most.of[0], f->most.of[1], f->most.of[2]);
    }
    for (const block_t *b = blocks; b != NULL; b = b->next) {
        if (b->executions != 0U) {
            (void)fprintf(out, "B %" PRIu64 " %" PRIu64 " %" PRIu64 " %" PRIu64 "\n", b->begin,
                          b->end, b->executions, b->times_taken);
        }
    }
    (void)fclose(out);
}

__attribute__((visibility("default"))) int
qemu_plugin_install(qemu_plugin_id_t id, const qemu_info_t *info, int argc, char **argv);

int qemu_plugin_install(qemu_plugin_id_t id, const qemu_info_t *info, int argc, char **argv) {
    (void)info;
    places = calloc(CODE_BYTES / 2, sizeof(*places));
    for (int i = 0; i < argc; i++) {
        if (strncmp(argv[i], "table=", 6) == 0) {
            read_table(argv[i] + 6);
        } else if (strncmp(argv[i], "out=", 4) == 0) {
            out = fopen(argv[i] + 4, "w");
        }
    }
    if (out == NULL) {
        fail("cannot write", "out=FILE");
    }
    qemu_plugin_register_vcpu_tb_trans_cb(id, on_translation);
    qemu_plugin_register_atexit_cb(id, at_exit, NULL);
    return 0;
}
