/* SPDX-License-Identifier: MIT
 *
 * Firmware in the loop: reads a recording of the simulator's (hostsim/sim/recording.hpp)
 * from the folder it is run in, through semihosting on a board, takes each frame line by
 * line as a camera's interrupt would hand it in, and writes answers_replay.csv, which is
 * to be the recording's answers.csv.  Prints what each frame took, by the port's counter:
 *
 *   unit,<what is counted>
 *   frame,<left: to the ellipse>,<to the sphere>,<right: ...>,<...>,<poses and ball>
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "port.h"
#include "trials/answers.h"

enum { VERSION = 1, TITLE = 8192, KEYS = 3, INTRINSICS = 9 };

static ocel_colour_table_t table;
static ocel_colour_t colour;
static ocel_camera_t camera;
static ocel_eye_config_t config;
static int32_t radius_u;
static ocel_eye_t eyes[OCEL_EYE_COUNT];
static pair_answer_t answer;
static uint8_t line[2 * OCEL_MAX_WIDTH];
static ocel_port_counter_t counter;

static void fail(const char *what) {
    printf("replay: %s; record again: ocellus-sim run SCENARIO --out DIR --record DIR\n", what);
    exit(1);
}

static void must(ocel_status_t status, const char *what) {
    if (status != OCEL_OK) {
        printf("%s: %s\n", what, ocel_status_name(status));
        fail("the library refuses what the manifest says");
    }
}

static FILE *opened(const char *name, const char *mode) {
    FILE *const file = fopen(name, mode);
    if (file == NULL) {
        printf("%s: ", name);
        fail("no such file in this folder, or it cannot be opened");
    }
    return file;
}

/* ---- The manifest ---- */

static void read_numbers(FILE *file, const char *name, int count, int32_t *v) {
    char found[32] = "";
    int read = fscanf(file, "%31s", found);
    for (int i = 0; i < count; i++) {
        long value = 0;
        read += fscanf(file, "%ld", &value);
        v[i] = (int32_t)value;
    }
    if ((read != count + 1) || (strcmp(found, name) != 0)) {
        printf("manifest.txt: '%s', expected '%s' and %d numbers: ", found, name, count);
        fail("not a manifest of this version");
    }
}

static void compile_colour(const int32_t *v) {
    ocel_colour_range_t range;
    range.space = (ocel_space_t)v[0];
    for (int i = 0; i < 3; i++) {
        range.lo[i] = (uint16_t)v[1 + i];
        range.hi[i] = (uint16_t)v[4 + i];
    }
    must(ocel_colour_compile(&colour, &range, OCEL_FORMAT_RGB565, &table), "colour");
}

static void ready_camera(const int32_t *v) {
    ocel_intrinsics_t in;
    memset(&in, 0, sizeof(in));
    in.fx_px_q16 = v[0];
    in.fy_px_q16 = v[1];
    in.cx_px_q16 = v[2];
    in.cy_px_q16 = v[3];
    in.k1_q24 = v[4];
    in.k2_q24 = v[5];
    in.p1_q24 = v[6];
    in.p2_q24 = v[7];
    in.k3_q24 = v[8];
    in.width = config.width;
    in.height = config.height;
    must(ocel_camera_init(&camera, &in), "camera");
}

static void read_manifest(void) {
    FILE *const file = opened("manifest.txt", "r");
    int32_t v[INTRINSICS];
    read_numbers(file, "version", 1, v);
    if (v[0] != VERSION) {
        fail("manifest.txt is of another version");
    }
    read_numbers(file, "width", 1, v);
    config.width = (uint16_t)v[0];
    read_numbers(file, "height", 1, v);
    config.height = (uint16_t)v[0];
    read_numbers(file, "colour", 7, v);
    compile_colour(v);
    read_numbers(file, "min_area", 1, v);
    config.min_area = (uint32_t)v[0];
    read_numbers(file, "radius_u", 1, &radius_u);
    read_numbers(file, "intrinsics", INTRINSICS, v);
    ready_camera(v);
    for (int side = 0; side < OCEL_EYE_COUNT; side++) {
        must(ocel_eye_init(&eyes[side], &config), "eye");
    }
    (void)fclose(file);
}

/* ---- A pair of frames ---- */

static uint64_t spent; /* of the frame in hand: reading the file is not in it */
static uint64_t empty; /* what two readings of the counter take by themselves */

static uint64_t begun(void) {
    return ocel_port_ticks();
}

static void ended(uint64_t begin) {
    const uint64_t ticks = ocel_port_ticks() - begin;
    spent += (ticks > empty) ? (ticks - empty) : 0U;
}

static void count_empty(void) {
    for (int i = 0; i < 2; i++) { /* the second is as all that follow */
        empty = 0U;
        spent = 0U;
        ended(begun());
        empty = spent;
    }
}

static void print_spent(void) {
    printf(",%llu", (unsigned long long)(spent * counter.mul / counter.div));
}

static void take_line(FILE *frames, ocel_eye_t *eye, uint16_t y) {
    const size_t bytes = ocel_colour_line_bytes(OCEL_FORMAT_RGB565, config.width);
    if (fread(line, 1U, bytes, frames) != bytes) {
        fail("frames.rgb565 is shorter than pairs.csv says");
    }
    const uint64_t begin = begun();
    const ocel_status_t status = ocel_eye_line(eye, &colour, y, line, bytes);
    ended(begin);
    must(status, "line");
}

static void take_frame(FILE *frames, int side) {
    ocel_eye_t *const eye = &eyes[side];
    eye_answer_t *const out = &answer.eye[side];
    spent = 0U;
    uint64_t begin = begun();
    must(ocel_eye_begin(eye), "begin");
    ended(begin);
    for (uint16_t y = 0U; y < config.height; y++) {
        take_line(frames, eye, y);
    }
    begin = begun();
    (void)ocel_eye_end(eye, &out->detection);
    ended(begin);
    print_spent();
    begin = begun();
    answer_to_sphere(eye, &camera, radius_u, out);
    ended(begin);
    print_spent();
}

static void take_pair(FILE *frames, const int32_t *joints_q32) {
    printf("frame");
    for (int side = 0; side < OCEL_EYE_COUNT; side++) {
        take_frame(frames, side);
    }
    spent = 0U;
    const uint64_t begin = begun();
    answer_ball(joints_q32, radius_u, &answer);
    ended(begin);
    print_spent();
    printf("\n");
}

/* ---- The answers ---- */

static void put_title(void *to, const char *part, const char *name, int index, int64_t value) {
    (void)value;
    (void)fprintf(to, ",%s.%s", part, name);
    if (index >= 0) {
        (void)fprintf(to, "[%d]", index);
    }
}

static void put_value(void *to, const char *part, const char *name, int index, int64_t value) {
    (void)part;
    (void)name;
    (void)index;
    (void)fprintf(to, ",%lld", (long long)value);
}

static void write_titles(FILE *answers) {
    const answer_sink_t titles = {put_title, answers};
    (void)fprintf(answers, "point,trial,frame");
    put_pair(&titles, &answer);
    (void)fprintf(answers, "\n");
}

static void write_answer(FILE *answers, const long *keys) {
    const answer_sink_t values = {put_value, answers};
    (void)fprintf(answers, "%ld,%ld,%ld", keys[0], keys[1], keys[2]);
    put_pair(&values, &answer);
    (void)fprintf(answers, "\n");
}

static bool read_pair(FILE *pairs, long *keys, int32_t *joints_q32) {
    int read = fscanf(pairs, "%ld,%ld,%ld", &keys[0], &keys[1], &keys[2]);
    if (read < 1) {
        return false;
    }
    for (int i = 0; i < OCEL_JOINT_COUNT; i++) {
        long value = 0;
        read += fscanf(pairs, ",%ld", &value);
        joints_q32[i] = (int32_t)value;
    }
    if (read != KEYS + OCEL_JOINT_COUNT) {
        fail("pairs.csv has a row that is no pair's");
    }
    return true;
}

static void replay(void) {
    static char title[TITLE];
    FILE *const frames = opened("frames.rgb565", "rb");
    FILE *const pairs = opened("pairs.csv", "r");
    FILE *const answers = opened("answers_replay.csv", "w");
    long keys[KEYS] = {0, 0, 0};
    int32_t joints_q32[OCEL_JOINT_COUNT];
    if (fgets(title, TITLE, pairs) == NULL) {
        fail("pairs.csv is empty");
    }
    write_titles(answers);
    while (read_pair(pairs, keys, joints_q32)) { /* bound: the file's rows */
        take_pair(frames, joints_q32);
        write_answer(answers, keys);
    }
    (void)fclose(frames);
    (void)fclose(pairs);
    if (fclose(answers) != 0) {
        fail("answers_replay.csv cannot be written");
    }
}

int main(void) {
    counter = ocel_port_start();
    count_empty();
    printf("unit,%s\n", counter.unit);
    read_manifest();
    replay();
    return 0;
}
