/* SPDX-License-Identifier: MIT
 *
 * 160x120 frames through the eye, in formats that take no 8 KB table in RAM, and
 * in RGB565 by a table that is const.  Nothing here depends on the limits of the
 * build, so a board with 16 KB says the same as a host with the largest.
 */
#include <string.h>

#include "corpus.h"
#include "scene.h"

enum { WIDTH = 160, HEIGHT = 120 };

/* The range 200-255, 60-150, 0-80 of RGB565, as the library widens a channel: of
 * word w the red is w / 64, the green w % 64, the bits are the blues. */
#define WIDE5(v) (((v) << 3U) | ((v) >> 2U))
#define WIDE6(v) (((v) << 2U) | ((v) >> 4U))
#define WORD(w)                                                                                    \
    (((WIDE5((w) / 64U) >= 200U) && (WIDE6((w) % 64U) >= 60U) && (WIDE6((w) % 64U) <= 150U))       \
         ? 0x3FFU                                                                                  \
         : 0U)
#define WORDS4(w) WORD(w), WORD((w) + 1U), WORD((w) + 2U), WORD((w) + 3U)
#define WORDS16(w) WORDS4(w), WORDS4((w) + 4U), WORDS4((w) + 8U), WORDS4((w) + 12U)
#define WORDS64(w) WORDS16(w), WORDS16((w) + 16U), WORDS16((w) + 32U), WORDS16((w) + 48U)
#define WORDS256(w) WORDS64(w), WORDS64((w) + 64U), WORDS64((w) + 128U), WORDS64((w) + 192U)

/* Reds from 25, greens from 15 to 37, blues to 9. */
static const ocel_colour_table_t orange = {{WORDS256(0U), WORDS256(256U), WORDS256(512U),
                                            WORDS256(768U), WORDS256(1024U), WORDS256(1280U),
                                            WORDS256(1536U), WORDS256(1792U)},
                                           (25U << 11U) | (15U << 5U),
                                           ((63U - 37U) << 5U) | (31U - 9U)};

static ocel_eye_t eye;
static ocel_colour_t colour;
static uint8_t line[2 * WIDTH];

static ocel_status_t take_line(ocel_format_t format, int32_t y) {
    if (format == OCEL_FORMAT_RGB565) {
        uint32_t row[WIDTH / 32];
        const ocel_status_t status = ocel_colour_table_row(&orange, line, sizeof(line), WIDTH, row);
        return (status == OCEL_OK) ? ocel_eye_row(&eye, (uint16_t)y, row) : status;
    }
    return ocel_eye_line(&eye, &colour, (uint16_t)y, line, sizeof(line));
}

static void look(hash_t *h, scene_kind_t kind, ocel_format_t format,
                 const ocel_colour_range_t *range) {
    const scene_t scene = {kind, WIDTH, HEIGHT, 160U};
    ocel_eye_config_t config;
    ocel_detection_t detection;
    size_t count = 0U;

    memset(&config, 0, sizeof(config));
    config.width = WIDTH;
    config.height = HEIGHT;
    memset(&detection, 0, sizeof(detection));
    if (format != OCEL_FORMAT_RGB565) {
        hash_enum(h, ocel_colour_compile(&colour, range, format, NULL));
    }
    hash_enum(h, ocel_eye_init(&eye, &config));
    hash_enum(h, ocel_eye_begin(&eye));
    for (int32_t y = 0; y < HEIGHT; y++) {
        scene_line(&scene, format, y, line);
        hash_enum(h, take_line(format, y));
    }
    hash_enum(h, ocel_eye_end(&eye, &detection));
    hash_detection(h, &detection);
    const ocel_crack_t *const cracks = ocel_eye_boundary(&eye, &count);
    hash_cracks(h, cracks, count);
}

void corpus_small(hash_t *h) {
    static const ocel_colour_range_t yuv = SCENE_RANGE_YUV;
    static const ocel_colour_range_t gray = SCENE_RANGE_GRAY;
    for (int32_t kind = 0; kind < (int32_t)SCENE_SMALL_KINDS; kind++) {
        look(h, (scene_kind_t)kind, OCEL_FORMAT_RGB565, NULL);
        look(h, (scene_kind_t)kind, OCEL_FORMAT_YUYV, &yuv);
        look(h, (scene_kind_t)kind, OCEL_FORMAT_GRAY8, &gray);
    }
}
