/* SPDX-License-Identifier: MIT
 *
 * Colour and teaching: every space with every format, wild ranges and wild lines.
 */
#include <string.h>

#include "corpus.h"
#include "rng.h"
#include "scene.h"

enum { SPACES = 4, FORMATS = 5, RANGES = 12, WIDTH = 320, ROW_WORDS = WIDTH / 32 };

static ocel_colour_table_t table;
static ocel_teach_t teach;
static uint8_t line[3 * WIDTH];

static ocel_colour_range_t any_range(rng_t *rng, uint32_t space) {
    ocel_colour_range_t range;
    memset(&range, 0, sizeof(range));
    range.space = (ocel_space_t)space;
    for (uint32_t k = 0U; k < 3U; k++) {
        const bool hue = (space == (uint32_t)OCEL_SPACE_HSV) && (k == 0U);
        const uint32_t p = rng_below(rng, hue ? 361U : 256U);
        const uint32_t q = rng_below(rng, hue ? 361U : 256U);
        const bool keep = hue || (p <= q);
        range.lo[k] = (uint16_t)(keep ? p : q);
        range.hi[k] = (uint16_t)(keep ? q : p);
    }
    return range;
}

static void wild_line(rng_t *rng) {
    for (uint32_t i = 0U; i < sizeof(line); i++) {
        line[i] = (uint8_t)rng_u32(rng);
    }
}

static void rows(hash_t *h, const ocel_colour_t *colour, rng_t *rng) {
    static const uint16_t widths[] = {2, 8, 30, 32, 34, 64, 118, WIDTH};
    for (uint32_t i = 0U; i < sizeof(widths) / sizeof(widths[0]); i++) {
        uint32_t row[ROW_WORDS] = {0U};
        wild_line(rng);
        hash_enum(h, ocel_colour_row(colour, line, sizeof(line), widths[i], row));
        hash_words(h, row, ROW_WORDS);
    }
}

static void hostile(hash_t *h) {
    const ocel_colour_range_t good = SCENE_RANGE_RGB;
    ocel_colour_range_t bad = good;
    ocel_colour_t colour;
    uint32_t row[ROW_WORDS];
    memset(&colour, 0, sizeof(colour));
    hash_enum(h, ocel_colour_row(&colour, line, sizeof(line), 8U, row));
    hash_enum(h, ocel_colour_compile(NULL, &good, OCEL_FORMAT_GRAY8, NULL));
    hash_enum(h, ocel_colour_compile(&colour, &good, OCEL_FORMAT_RGB565, NULL));
    hash_enum(h, ocel_colour_compile(&colour, &good, (ocel_format_t)9, NULL));
    bad.lo[1] = 151U;
    hash_enum(h, ocel_colour_compile(&colour, &bad, OCEL_FORMAT_RGB888, NULL));
    hash_enum(h, ocel_colour_compile(&colour, &good, OCEL_FORMAT_YUYV, NULL));
    hash_enum(h, ocel_colour_row(&colour, line, sizeof(line), 7U, row));
    hash_enum(h, ocel_colour_row(&colour, line, 15U, 8U, row));
    hash_enum(h, ocel_colour_row(&colour, line, sizeof(line), 0U, row));
}

void corpus_colour(hash_t *h) {
    rng_t rng = rng_seed(19310921U);
    for (uint32_t space = 0U; space < (uint32_t)SPACES; space++) {
        for (uint32_t format = 0U; format < (uint32_t)FORMATS; format++) {
            const bool tabled = format == (uint32_t)OCEL_FORMAT_RGB565;
            for (uint32_t i = 0U; i < (tabled ? 1U : (uint32_t)RANGES); i++) {
                const ocel_colour_range_t range = any_range(&rng, space);
                ocel_colour_t colour;
                hash_enum(h, ocel_colour_compile(&colour, &range, (ocel_format_t)format,
                                                 tabled ? &table : NULL));
                rows(h, &colour, &rng);
            }
            hash_u32(h, (uint32_t)ocel_colour_line_bytes((ocel_format_t)format, WIDTH));
        }
        hash_words(h, table.word, OCEL_COLOUR_TABLE_WORDS);
    }
    hostile(h);
}

static void learn(hash_t *h, rng_t *rng, uint32_t space, uint32_t format, bool wild) {
    const scene_t scene = {SCENE_PLAIN, WIDTH, 240, 7U};
    ocel_colour_range_t range;
    memset(&range, 0, sizeof(range));
    hash_enum(h, ocel_teach_begin(&teach, (ocel_space_t)space, (ocel_format_t)format));
    for (int32_t y = 100; y < 104; y++) {
        if (wild) {
            wild_line(rng);
        } else {
            scene_line(&scene, (ocel_format_t)format, y, line);
        }
        hash_enum(h, ocel_teach_line(&teach, line, sizeof(line), 170U, 40U));
        hash_enum(h, ocel_teach_line(&teach, line, 90U, 170U, 40U));
    }
    hash_enum(h, ocel_teach_end(&teach, &range));
    hash_enum(h, range.space);
    for (uint32_t k = 0U; k < 3U; k++) {
        hash_u32(h, range.lo[k]);
        hash_u32(h, range.hi[k]);
    }
}

void corpus_teach(hash_t *h) {
    rng_t rng = rng_seed(19310922U);
    for (uint32_t space = 0U; space < (uint32_t)SPACES; space++) {
        for (uint32_t format = 0U; format < (uint32_t)FORMATS; format++) {
            learn(h, &rng, space, format, false);
            learn(h, &rng, space, format, true);
        }
    }
}
