/* SPDX-License-Identifier: MIT
 *
 * Frames, plain and adversarial: through the labeller with every component's sums,
 * and through the eye in every format, with every method of fitting.
 */
#include <string.h>

#include "corpus.h"
#include "scene.h"

enum { WIDTH = 320, HEIGHT = 240, ROW_WORDS = WIDTH / 32, FORMATS = 5, METHODS = 3 };

static ocel_labeller_t labeller;
static ocel_crack_pool_t pool;
static ocel_blob_t ended[OCEL_MAX_RUNS];
static ocel_eye_t eye;
static ocel_colour_t colour;
static ocel_colour_table_t table;
static uint8_t line[3 * WIDTH];

/* ---- Labelling ---- */

static void hash_ended(hash_t *h, size_t count) {
    for (size_t i = 0U; i < count; i++) {
        int32_t cx = 0;
        int32_t cy = 0;
        ocel_blob_centroid(&ended[i], &cx, &cy);
        hash_blob(h, &ended[i]);
        hash_i32(h, cx);
        hash_i32(h, cy);
    }
}

static void label(hash_t *h, const scene_t *scene, ocel_connectivity_t connectivity) {
    const ocel_crack_t *cracks = NULL;
    ocel_blob_t largest;
    size_t count = 0U;
    size_t stride = 0U;

    memset(&largest, 0, sizeof(largest));
    hash_enum(h, ocel_label_begin(&labeller, &pool, (uint16_t)scene->width, (uint16_t)scene->height,
                                  connectivity));
    for (int32_t y = 0; y < scene->height; y++) {
        uint32_t row[ROW_WORDS];
        scene_row(scene, y, row);
        hash_enum(h, ocel_label_row(&labeller, &pool, row, ended, &count));
        hash_ended(h, count);
    }
    hash_enum(h, ocel_label_end(&labeller, &pool, ended, &count, &largest));
    hash_ended(h, count);
    hash_blob(h, &largest);
    const ocel_label_stats_t stats = ocel_label_stats(&labeller);
    hash_stats(h, &stats);
    count = 0U;
    hash_enum(h, ocel_label_boundary(&labeller, &pool, &cracks, &count, &stride));
    hash_cracks(h, cracks, count);
    hash_u32(h, (uint32_t)stride);
}

void corpus_label(hash_t *h) {
    static const int32_t size[3][2] = {{WIDTH, HEIGHT}, {97, 61}, {1, HEIGHT}};
    for (int32_t kind = 0; kind < (int32_t)SCENE_KINDS; kind++) {
        for (int32_t i = 0; i < 3; i++) {
            const scene_t scene = {(scene_kind_t)kind, size[i][0], size[i][1], 1984U};
            label(h, &scene, OCEL_CONNECT_8);
            label(h, &scene, OCEL_CONNECT_4);
        }
    }
}

/* ---- The eye ---- */

static const ocel_colour_range_t range_rgb = SCENE_RANGE_RGB;
static const ocel_colour_range_t range_yuv = SCENE_RANGE_YUV;
static const ocel_colour_range_t range_gray = SCENE_RANGE_GRAY;

static const ocel_colour_range_t *range_of(ocel_format_t format) {
    switch (format) {
    case OCEL_FORMAT_YUYV:
        return &range_yuv;
    case OCEL_FORMAT_GRAY8:
        return &range_gray;
    default:
        return &range_rgb;
    }
}

static void refit(hash_t *h, const ocel_detection_t *detection) {
    for (int32_t method = 0; method < METHODS; method++) {
        ocel_detection_t again = *detection;
        ocel_fit_options_t options;
        options.method = (ocel_fit_method_t)method;
        options.perturb = OCEL_PERTURB_ALWAYS;
        options.closed = false;
        hash_enum(h, ocel_eye_refit(&eye, &options, &again));
        hash_detection(h, &again);
    }
}

static void look(hash_t *h, scene_kind_t kind, ocel_format_t format, uint32_t min_area) {
    const scene_t scene = {kind, WIDTH, HEIGHT, 2012U};
    const size_t line_bytes = ocel_colour_line_bytes(format, WIDTH);
    ocel_eye_config_t config;
    ocel_detection_t detection;
    size_t count = 0U;

    memset(&config, 0, sizeof(config));
    memset(&detection, 0, sizeof(detection));
    config.width = WIDTH;
    config.height = HEIGHT;
    config.min_area = min_area;
    hash_enum(h, ocel_eye_init(&eye, &config));
    hash_enum(h, ocel_eye_begin(&eye));
    for (int32_t y = 0; y < HEIGHT; y++) {
        scene_line(&scene, format, y, line);
        hash_enum(h, ocel_eye_line(&eye, &colour, (uint16_t)y, line, line_bytes));
    }
    hash_enum(h, ocel_eye_end(&eye, &detection));
    hash_detection(h, &detection);
    const ocel_crack_t *const cracks = ocel_eye_boundary(&eye, &count);
    hash_cracks(h, cracks, count);
    refit(h, &detection);
}

/* Lines of four repeated: a whole frame from one place in memory. */
static void whole_frame(hash_t *h, ocel_format_t format) {
    const scene_t scene = {SCENE_SALT, WIDTH, 4, 5U};
    static uint8_t frame[4 * 3 * WIDTH];
    const size_t stride = ocel_colour_line_bytes(format, WIDTH);
    ocel_eye_config_t config;
    ocel_detection_t detection;

    memset(&config, 0, sizeof(config));
    memset(&detection, 0, sizeof(detection));
    config.width = WIDTH;
    config.height = 4;
    config.connectivity = OCEL_CONNECT_4;
    hash_enum(h, ocel_eye_init(&eye, &config));
    for (int32_t y = 0; y < 4; y++) {
        scene_line(&scene, format, y, &frame[(size_t)y * stride]);
    }
    hash_enum(h, ocel_eye_frame(&eye, &colour, frame, stride, &detection));
    hash_detection(h, &detection);
    hash_enum(h, ocel_eye_frame(&eye, &colour, frame, stride - 1U, &detection));
}

void corpus_eye(hash_t *h) {
    for (int32_t f = 0; f < FORMATS; f++) {
        const ocel_format_t format = (ocel_format_t)f;
        hash_enum(h, ocel_colour_compile(&colour, range_of(format), format,
                                         (format == OCEL_FORMAT_RGB565) ? &table : NULL));
        look(h, SCENE_PLAIN, format, 0U);
        look(h, SCENE_SALT, format, 0U);
        whole_frame(h, format);
        if (format == OCEL_FORMAT_GRAY8) {
            for (int32_t kind = 0; kind < (int32_t)SCENE_KINDS; kind++) {
                look(h, (scene_kind_t)kind, format, 1U);
            }
        }
    }
}
