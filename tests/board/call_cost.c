/* SPDX-License-Identifier: MIT
 *
 * Makes the calls of calls.h and prints a CSV line of each, after a first line that
 * says of what:
 *
 *   unit,insn                            or, with CALLS_STACK, unit,bytes
 *   function,input,units,count           function,input,units,bytes,<the call's name>
 *
 * Counted by the port's counter, and an empty call's count is taken off.  The bytes
 * of stack are those of the call's own frame too, which who reads them knows (the
 * compiler's frame sizes) and takes off.
 */
#include "calls.h"
#include "port.h"

void must(ocel_status_t status, const char *what) {
    if (status != OCEL_OK) {
        printf("call_cost: %s: %s\n", what, ocel_status_name(status));
        exit(1);
    }
}

/* ---- Measuring ---- */

#ifdef CALLS_STACK
/* No counter runs: its interrupt would have its frame on the same stack. */
static void start(void) {
    printf("unit,bytes\n");
}

void measure_call(const char *function, const char *input, long units, void (*call)(void),
                  const char *name) {
    printf("%s,%s,%ld,%lu,%s\n", function, input, units, (unsigned long)ocel_port_stack_of(call),
           name);
}
#else
static ocel_port_counter_t counter;
static uint64_t empty_ticks;

static uint64_t ticks_of(void (*call)(void)) {
    const uint64_t begin = ocel_port_ticks();
    call();
    return ocel_port_ticks() - begin;
}

static void nothing(void) {
}

static void start(void) {
    counter = ocel_port_start();
    (void)ticks_of(nothing);
    empty_ticks = ticks_of(nothing);
    printf("unit,%s\n", counter.unit);
}

void measure_call(const char *function, const char *input, long units, void (*call)(void),
                  const char *name) {
    const uint64_t ticks = ticks_of(call);
    const uint64_t more = (ticks > empty_ticks) ? (ticks - empty_ticks) : 0U;
    (void)name;
    printf("%s,%s,%ld,%llu\n", function, input, units,
           (unsigned long long)(more * counter.mul / counter.div));
}
#endif

/* ---- Frames ---- */

uint8_t frame[3 * PIXELS];
uint32_t rows[ROW_WORDS * FRAME_HEIGHT];
static uint8_t mask[PIXELS];
static uint8_t bgr[3 * PIXELS];

const ocel_colour_range_t range_rgb = {OCEL_SPACE_RGB,
                                       {FRAME_RANGE_R_LO, FRAME_RANGE_G_LO, FRAME_RANGE_B_LO},
                                       {FRAME_RANGE_R_HI, FRAME_RANGE_G_HI, FRAME_RANGE_B_HI}};

void to_format(ocel_format_t format) {
    for (size_t i = 0; i < PIXELS; i++) {
        const uint8_t *p = &bgr[3U * i];
        const unsigned v =
            ((unsigned)(p[2] >> 3) << 11) | ((unsigned)(p[1] >> 2) << 5) | (unsigned)(p[0] >> 3);
        switch (format) {
        case OCEL_FORMAT_RGB565:
            frame[2U * i] = (uint8_t)v;
            frame[2U * i + 1U] = (uint8_t)(v >> 8);
            break;
        case OCEL_FORMAT_YUYV: /* any values will do: the cost is a pixel's */
            frame[2U * i] = p[1];
            frame[2U * i + 1U] = p[((i & 1U) != 0U) ? 2 : 0];
            break;
        case OCEL_FORMAT_GRAY8:
            frame[i] = p[1];
            break;
        default:
            frame[3U * i] = p[(format == OCEL_FORMAT_BGR888) ? 0 : 2];
            frame[3U * i + 1U] = p[1];
            frame[3U * i + 2U] = p[(format == OCEL_FORMAT_BGR888) ? 2 : 0];
            break;
        }
    }
}

void draw(frame_kind_t kind) {
    frame_draw_bgr(kind, FRAME_WIDTH, FRAME_HEIGHT, SEED, mask, bgr);
    frame_mask_to_bits(mask, FRAME_WIDTH, FRAME_HEIGHT, rows);
}

int main(void) {
    start();
    measure_small();
    measure_colour();
    measure_label();
    measure_eye();
    measure_fits();
    measure_space();
    measure_head();
    return 0;
}
