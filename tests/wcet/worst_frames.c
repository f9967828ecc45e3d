/* SPDX-License-Identifier: MIT
 *
 * Frames that keep the labeller busy.
 */
#include <string.h>

#include <ocellus/ocellus.h>

#include "worst.h"

enum { WIDTH = OCEL_MAX_WIDTH, HEIGHT = OCEL_MAX_HEIGHT, ROW_WORDS = OCEL_ROW_WORDS };

static uint32_t rows[HEIGHT][ROW_WORDS];
static uint8_t frame[HEIGHT][2 * WIDTH];
static ocel_eye_t eye;
static ocel_labeller_t labeller;
static ocel_crack_pool_t pool;
static ocel_blob_t ended[OCEL_MAX_RUNS];
static ocel_colour_t colour;
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

/* A comb whose teeth end one after the other. */
static bool is_staircase(int32_t x, int32_t y) {
    return ((x % 2) == 0) && (x >= y);
}

/* Teeth joined by every fourth row, the row after cutting them apart again. */
static bool is_ladder(int32_t x, int32_t y) {
    return ((y % 4) == 3) || (((x % 2) == 0) && ((y % 4) != 0));
}

/* The pool fills with teeth, is lost, and all ends at once. */
static bool is_cliff(int32_t x, int32_t y) {
    return ((x % 2) == 0) && (y < (HEIGHT / 2));
}

/* Every second column, and in the last row of each band the others: all that began
 * are joined at once, after none or some rows. */
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

/* Fingers from the left edge: as many boundary points as cells, and few of these for the
 * chain itself. */
static bool is_fingers(int32_t x, int32_t y) {
    const int32_t points = OCEL_MAX_CRACKS - 64;
    const int32_t fingers = points / (2 * WIDTH);
    const bool between = (y >= 20) && (y <= (20 + (2 * fingers)));
    return between && ((x < 2) || (((y % 2) == 0) && (x < (points / (2 * (fingers + 1))))));
}

/* ---- Masks: one row as long as can be ----
 *
 * In most rows of them every second pixel is set, RUNS in all.  A row of runs that were
 * born in the row above is the longest: each of those gets a label, sums and cells, and
 * where the row is by one to the right each run joins two of them.  While a frame's cells
 * are new they take longer to get, too.
 *
 * Before that row there may be a comb, of which a stem is left at the right: its outline
 * is one chain, as long as the cells allow that the row itself takes.  So they run out just
 * before the stem, whose component is lost then, and all of the chain is given back. */

enum { RUNS = WIDTH / 2, STEM = WIDTH - 2, TOOTH_ROWS = 7 };

/* The comb over the row `foot`, in which only its stem is left; with this and the rows above
 * it has `cells` cells. */
static bool is_comb(int32_t x, int32_t y, int32_t foot, int32_t cells) {
    const int32_t rows_of_two = (cells / 2) - 1; /* without the comb's back */
    const int32_t teeth = (rows_of_two - 2) / TOOTH_ROWS;
    const int32_t back = foot - (rows_of_two - (teeth * TOOTH_ROWS));
    const bool tooth = (y < back) && (y >= (back - TOOTH_ROWS));
    return (tooth && ((x % 2) == 0) && (x < (2 * teeth))) || (y == back) ||
           ((y > back) && (y <= foot) && (x == STEM));
}

/* Rows from `first` on: every second pixel but the first one, and again with it, so that it
 * is not the same row; and beside these. */
static bool is_straight(int32_t x, int32_t y, int32_t first) {
    return ((x % 2) == 0) && (((y == first) && (x > 0)) || (y == (first + 1)));
}

/* All born, all joined. */
static bool is_shifted(int32_t x, int32_t y) {
    const int32_t foot = 20;
    const int32_t taken = (2 * (RUNS - 1)) + (2 * (RUNS - 3));
    return is_comb(x, y, foot, OCEL_MAX_CRACKS - taken) || ((y == foot) && ((x % 2) == 0)) ||
           ((y == (foot + 1)) && ((x % 2) == 1));
}

/* All born and gone on by themselves, and with the row after, asked about, joined. */
static bool is_straight_then_shifted(int32_t x, int32_t y) {
    const int32_t foot = 20;
    const int32_t taken = (4 * (RUNS - 2)) + 4 + (2 * (RUNS - 3));
    return is_comb(x, y, foot, OCEL_MAX_CRACKS - taken) || is_straight(x, y, foot) ||
           ((y == (foot + 2)) && ((x % 2) == 1));
}

/* All born and gone on by themselves, and ended by the frame. */
static bool is_straight_to_end(int32_t x, int32_t y) {
    const int32_t foot = HEIGHT - 2;
    return is_comb(x, y, foot, OCEL_MAX_CRACKS - (4 * (RUNS - 2))) || is_straight(x, y, foot);
}

/* ---- Masks: a frame as long as can be ---- */

/* 4-connected, pairs of rows that touch no other: in the first all of the pair above ends
 * and all is born, in the second, which is not quite the same, all goes on by itself.  Over
 * them a boundary of as many points as can be. */
static bool is_in_pairs(int32_t x, int32_t y) {
    const int32_t first = 12;
    const int32_t odd = (y / 2) % 2;
    const bool in_pair = ((x % 2) == odd) || (((y % 2) == 1) && (x == (5 + odd)));
    return (y < first) ? is_fingers(x, y + 18) : in_pair;
}

/* Every second row, joined at the left: the longest boundary there is. */
static bool is_lines(int32_t x, int32_t y) {
    return ((y % 2) == 0) || (x == 0);
}

/* Over a frame's end that is long by itself. */
static bool is_lines_to_end(int32_t x, int32_t y) {
    return (y < (HEIGHT - 3)) ? is_lines(x, y) : is_straight(x, y, HEIGHT - 2);
}

/* With teeth over as many columns as there are cells for. */
static bool is_lines_and_teeth(int32_t x, int32_t y) {
    const int32_t tooth_rows = 16;
    const int32_t columns = (OCEL_MAX_CRACKS - (2 * HEIGHT) - 8) / tooth_rows;
    return ((y < tooth_rows) && (x < columns)) ? ((x % 2) == 0) : is_lines(x, y);
}

static const mask_t masks[] = {is_tree,
                               is_staircase,
                               is_ladder,
                               is_cliff,
                               is_band_of_one,
                               is_band_of_three,
                               is_fingers,
                               is_shifted,
                               is_straight_then_shifted,
                               is_straight_to_end,
                               is_in_pairs,
                               is_lines_to_end,
                               is_lines_and_teeth};

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

/* Colours whose hue is looked at last: in the range and not, by their Y. */
static void paint(void) {
    for (int32_t y = 0; y < HEIGHT; y++) {
        for (int32_t x = 0; x < WIDTH; x++) {
            const uint32_t bit = (rows[y][x / 32] >> ((uint32_t)x % 32U)) & 1U;
            frame[y][2 * x] = (bit != 0U) ? 17U : 1U;
            frame[y][2 * x + 1] = ((x % 2) == 0) ? 72U : 125U;
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

/* Line by line and row by row: what the calls take by themselves. */
static void look_on(void) {
    ocel_detection_t detection;

    (void)ocel_eye_begin(&eye);
    for (uint16_t y = 0U; y < (uint16_t)HEIGHT; y++) {
        (void)ocel_eye_line(&eye, &colour, y, frame[y], sizeof(frame[y]));
    }
    (void)ocel_eye_begin(&eye);
    for (uint16_t y = 0U; y < (uint16_t)HEIGHT; y++) {
        (void)ocel_eye_row(&eye, y, rows[y]);
    }
    (void)ocel_eye_end(&eye, &detection);
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

static void take(void) {
    label(OCEL_CONNECT_8, HEIGHT, 1);
    label(OCEL_CONNECT_4, HEIGHT, 1);
    label(OCEL_CONNECT_8, 0, 1);
    label(OCEL_CONNECT_8, 0, 2);
    label(OCEL_CONNECT_8, 1, 2);
    label(OCEL_CONNECT_4, 1, 2);
    paint();
    look(OCEL_CONNECT_8);
    look_on();
    look(OCEL_CONNECT_4);
}

void worst_frames(void) {
    static const ocel_colour_range_t range = {OCEL_SPACE_HSV, {97, 30, 11}, {116, 255, 222}};

    (void)ocel_colour_compile(&colour, &range, OCEL_FORMAT_YUYV, NULL);
    for (size_t i = 0U; i < sizeof(masks) / sizeof(masks[0]); i++) {
        draw(masks[i]);
        take();
        if (masks[i] == is_fingers) {
            look_through_lens();
        }
    }
}
