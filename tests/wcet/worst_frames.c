/* SPDX-License-Identifier: MIT
 *
 * Frames that keep the labeller busy.
 */
#include <string.h>

#include <ocellus/ocellus.h>

#include "scene.h"
#include "worst.h"

enum { WIDTH = OCEL_MAX_WIDTH, HEIGHT = OCEL_MAX_HEIGHT, ROW_WORDS = OCEL_ROW_WORDS };

static uint32_t rows[HEIGHT][ROW_WORDS];
static uint8_t frame[HEIGHT][3 * WIDTH];
static ocel_eye_t eye;
static ocel_labeller_t labeller;
static ocel_crack_pool_t pool;
static ocel_blob_t ended[OCEL_MAX_RUNS];
static ocel_colour_t colour;
static ocel_colour_table_t table;
static const ocel_crack_t *cracks;
static size_t count;

static void set(int32_t x, int32_t y) {
    rows[y][x / 32] |= (uint32_t)1U << ((uint32_t)x % 32U);
}

/* ---- Masks ---- */

typedef bool (*mask_t)(int32_t x, int32_t y);

static void draw(mask_t on) {
    memset(rows, 0, sizeof(rows));
    for (int32_t y = 0; y < HEIGHT; y++) {
        for (int32_t x = 0; x < WIDTH; x++) {
            if (on(x, y)) {
                set(x, y);
            }
        }
    }
}

/* Teeth that are joined from the middle outwards, by one more each row: the most
 * unions there can be, and each of components that are whole columns. */
static bool is_tree(int32_t x, int32_t y) {
    const int32_t level = HEIGHT - 1 - y;
    const int32_t period = (level < 8) ? (2 << level) : 512;
    return ((x % 2) == 0) || ((level < 8) && ((x % period) < (period / 2)));
}

/* A comb whose teeth end one after the other, and one that begins so. */
static bool is_staircase(int32_t x, int32_t y) {
    return ((x % 2) == 0) && (x >= y);
}

static bool is_growing(int32_t x, int32_t y) {
    return ((x % 2) == 0) && (x <= y);
}

/* Teeth joined by every fourth row, the row after cutting them apart again. */
static bool is_ladder(int32_t x, int32_t y) {
    return ((y % 4) == 3) || (((x % 2) == 0) && ((y % 4) != 0));
}

/* Holes of two pixels, so that none is filled as a speck. */
static bool is_mesh(int32_t x, int32_t y) {
    return ((x % 2) == 0) || ((y % 3) == 0);
}

/* Runs of two with one between, each row by one to the right: every run meets two. */
static bool is_brick(int32_t x, int32_t y) {
    return ((x + y) % 3) != 0;
}

static bool is_diagonal(int32_t x, int32_t y) {
    return ((x + y) % 2) == 0;
}

/* Specks and their opposite in turn. */
static bool is_specks(int32_t x, int32_t y) {
    return ((x % 2) == 0) && ((y % 2) == 0);
}

static bool is_holes(int32_t x, int32_t y) {
    return ((x % 2) == 1) || ((y % 2) == 1);
}

/* The pool fills with teeth, is lost, and all ends at once. */
static bool is_cliff(int32_t x, int32_t y) {
    return ((x % 2) == 0) && (y < (HEIGHT / 2));
}

/* One boundary that goes up and down as often as the pool has cells for. */
static bool is_meander(int32_t x, int32_t y) {
    const int32_t teeth = OCEL_MAX_CRACKS / (2 * 24);
    const bool tooth = ((x % 4) < 2) && (x < (4 * teeth)) && (y >= 100) && (y < 122);
    return tooth || ((y >= 122) && (y < 124) && (x < (4 * teeth)));
}

/* Every second row, joined at an end: the longest boundary there is. */
static bool is_lines(int32_t x, int32_t y) {
    return ((y % 2) == 0) || (x == 0);
}

/* Every second column, and in the last row of each band the others: all that began
 * are joined at once, after none, some, or more rows than the pool has cells for. */
static bool is_band(int32_t x, int32_t y, int32_t rows_of_band) {
    const int32_t row = y % (rows_of_band + 2);
    return (row < rows_of_band) ? ((x % 2) == 0) : ((row == rows_of_band) && ((x % 2) == 1));
}

static bool is_band_of_one(int32_t x, int32_t y) {
    return is_band(x, y, 1);
}

static bool is_band_of_three(int32_t x, int32_t y) {
    return is_band(x, y, 3);
}

static bool is_band_of_nine(int32_t x, int32_t y) {
    return is_band(x, y, 9);
}

/* Pairs with one column between, cut apart and joined in turn. */
static bool is_pairs(int32_t x, int32_t y) {
    return ((y % 4) < 2) ? ((x % 3) != 0) : (((y % 4) == 2) && ((x % 3) != 1));
}

/* Few rows, as wide as can be: cracks along the rows. */
static bool is_wide(int32_t x, int32_t y) {
    const int32_t lap = y % 4;
    return (lap == 0) || (lap == 1) || ((lap == 2) && (x > 1)) || ((lap == 3) && (x < 2));
}

/* Fingers from the left edge: as many boundary points as cells, and few of these for the
 * chain itself. */
static bool is_fingers(int32_t x, int32_t y) {
    const int32_t points = OCEL_MAX_CRACKS - 64;
    const int32_t fingers = points / (2 * WIDTH);
    const bool between = (y >= 20) && (y <= (20 + (2 * fingers)));
    return between && ((x < 2) || (((y % 2) == 0) && (x < (points / (2 * (fingers + 1))))));
}

static bool is_everything(int32_t x, int32_t y) {
    (void)x;
    (void)y;
    return true;
}

static const mask_t masks[] = {is_tree,         is_staircase, is_growing,     is_ladder,
                               is_mesh,         is_brick,     is_diagonal,    is_specks,
                               is_holes,        is_cliff,     is_meander,     is_wide,
                               is_lines,        is_fingers,   is_band_of_one, is_band_of_three,
                               is_band_of_nine, is_pairs,     is_everything};

/* ---- Through the library ---- */

/* Asks what has ended at every row, at none, or at every second one: then the row that
 * was held and the one that is asked about are swept together. */
static void label(ocel_connectivity_t connectivity, int32_t ask_from, int32_t ask_step) {
    ocel_blob_t largest;
    size_t ended_count = 0U;

    (void)ocel_label_begin(&labeller, &pool, WIDTH, HEIGHT, connectivity);
    for (int32_t y = 0; y < HEIGHT; y++) {
        const bool ask = (y >= ask_from) && (((y - ask_from) % ask_step) == 0);
        (void)ocel_label_row(&labeller, &pool, rows[y], ask ? ended : NULL, &ended_count);
    }
    (void)ocel_label_end(&labeller, &pool, ended, &ended_count, &largest);
    (void)ocel_label_boundary(&labeller, &pool, &cracks, &count, NULL);
}

static void paint(void) {
    static const uint8_t on[3] = {225U, 105U, 35U};
    static const uint8_t off[3] = {205U, 90U, 110U}; /* only one channel tells them apart */
    for (int32_t y = 0; y < HEIGHT; y++) {
        for (int32_t x = 0; x < WIDTH; x++) {
            const uint32_t bit = (rows[y][x / 32] >> ((uint32_t)x % 32U)) & 1U;
            memcpy(&frame[y][3 * x], (bit != 0U) ? on : off, 3U);
        }
    }
}

static void look(ocel_connectivity_t connectivity) {
    const ocel_fit_options_t again = {OCEL_FIT_LCSE, OCEL_PERTURB_ALWAYS, false};
    ocel_eye_config_t config;
    ocel_detection_t detection;

    memset(&config, 0, sizeof(config));
    config.width = WIDTH;
    config.height = HEIGHT;
    config.min_area = 1U;
    config.connectivity = connectivity;
    (void)ocel_eye_init(&eye, &config);
    (void)ocel_eye_frame(&eye, &colour, &frame[0][0], sizeof(frame[0]), &detection);
    (void)ocel_eye_refit(&eye, &again, &detection);
}

/* A lens's rays take the longest. */
static void look_through_lens(void) {
    static const ocel_intrinsics_t lens = {
        277 * 65536, 277 * 65536, 160 * 65536, 120 * 65536, -1677722, 335544,
        16777,       -8389,       0,           0,           0};
    ocel_camera_t camera;
    ocel_detection_t detection;
    ocel_cone_t cone;

    (void)ocel_camera_init(&camera, &lens);
    (void)ocel_eye_frame(&eye, &colour, &frame[0][0], sizeof(frame[0]), &detection);
    (void)ocel_eye_cone(&eye, &camera, &detection, &cone);
}

static void scene(scene_kind_t kind) {
    const scene_t drawn = {kind, WIDTH, HEIGHT, 71U};
    for (int32_t y = 0; y < HEIGHT; y++) {
        scene_row(&drawn, y, rows[y]);
    }
}

static void take(bool painted) {
    label(OCEL_CONNECT_8, HEIGHT, 1);
    label(OCEL_CONNECT_4, HEIGHT, 1);
    label(OCEL_CONNECT_8, 0, 1);
    label(OCEL_CONNECT_8, 0, 2);
    label(OCEL_CONNECT_8, 1, 2);
    label(OCEL_CONNECT_4, 1, 2);
    if (painted) {
        paint();
        look(OCEL_CONNECT_8);
        look(OCEL_CONNECT_4);
    }
}

void worst_frames(void) {
    static const ocel_colour_range_t range = SCENE_RANGE_RGB;

    (void)ocel_colour_compile(&colour, &range, OCEL_FORMAT_RGB888, &table);
    for (size_t i = 0U; i < sizeof(masks) / sizeof(masks[0]); i++) {
        draw(masks[i]);
        take(true);
        if (masks[i] == is_fingers) {
            look_through_lens();
        }
    }
    scene(SCENE_SALT);
    take(true);
    scene(SCENE_RANDOM);
    take(true);
    scene(SCENE_SPIRAL);
    take(true);
}
