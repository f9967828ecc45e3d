/* SPDX-License-Identifier: MIT
 *
 * The corpus's frames, pixel by pixel and in integers, so that a board without
 * the memory for a frame draws it line by line.
 */
#ifndef BOARD_SCENE_H
#define BOARD_SCENE_H

#include <stdbool.h>
#include <stdint.h>

#include <ocellus/colour.h>

typedef enum {
    SCENE_PLAIN = 0,   /* one ball */
    SCENE_SALT,        /* the same and 5 % of all pixels */
    SCENE_CRESCENT,    /* a ball that another disc hides in part */
    SCENE_CLIPPED,     /* a ball over the left edge */
    SCENE_TWO,         /* two balls with holes in them */
    SCENE_EMPTY,       /* nothing */
    SCENE_LINE,        /* one row: no ellipse */
    SCENE_SMALL_KINDS, /* those up to here need few cells */
    SCENE_CHECKERBOARD = SCENE_SMALL_KINDS,
    SCENE_ISOLATED,
    SCENE_COMB,
    SCENE_RANDOM,
    SCENE_SPIRAL,
    SCENE_FULL,
    SCENE_KINDS
} scene_kind_t;

typedef struct {
    scene_kind_t kind;
    int32_t width;
    int32_t height;
    uint32_t seed;
} scene_t;

/* 32 random bits for a pixel (the finalizer of MurmurHash3, twice). */
static inline uint32_t scene_noise(uint32_t seed, int32_t x, int32_t y) {
    uint32_t v = seed * 0x9E3779B9U + (uint32_t)x * 0x85EBCA6BU + (uint32_t)y * 0xC2B2AE35U;
    for (uint32_t i = 0U; i < 2U; i++) {
        v = (v ^ (v >> 16U)) * 0x85EBCA6BU;
        v = (v ^ (v >> 13U)) * 0xC2B2AE35U;
        v ^= v >> 16U;
    }
    return v;
}

/* Sixteenths of a pixel. */
static inline bool scene_in_disc(int32_t x, int32_t y, int32_t cx_q4, int32_t cy_q4,
                                 int32_t radius_q4) {
    const int32_t dx = 16 * x - cx_q4;
    const int32_t dy = 16 * y - cy_q4;
    return dx * dx + dy * dy <= radius_q4 * radius_q4;
}

/* Rings two pixels apart, each cut and joined to the next: one long arm. */
static inline bool scene_spiral(const scene_t *scene, int32_t x, int32_t y) {
    const int32_t across = (x < scene->width - 1 - x) ? x : (scene->width - 1 - x);
    const int32_t down = (y < scene->height - 1 - y) ? y : (scene->height - 1 - y);
    const int32_t ring = (across < down) ? across : down;
    const bool cut = (x == ring) && (y == ring + 1);
    return ((ring % 2) == 0) != cut;
}

static inline bool scene_on(const scene_t *scene, int32_t x, int32_t y) {
    const int32_t w = scene->width;
    const int32_t h = scene->height;
    const uint32_t noise = scene_noise(scene->seed, x, y);
    const int32_t r = 2 * h; /* an eighth of the height */
    const bool ball = scene_in_disc(x, y, 9 * w + 5, 7 * h + 3, 2 * r + 7);
    switch (scene->kind) {
    case SCENE_PLAIN:
        return ball;
    case SCENE_SALT:
        return ball || ((noise % 20U) == 0U);
    case SCENE_CRESCENT:
        return ball && !scene_in_disc(x, y, 11 * w, 8 * h, 2 * r);
    case SCENE_CLIPPED:
        return scene_in_disc(x, y, w, 7 * h, 3 * r);
    case SCENE_TWO:
        return (ball && !scene_in_disc(x, y, 9 * w, 7 * h, r)) ||
               scene_in_disc(x, y, 3 * w, 12 * h, r);
    case SCENE_LINE:
        return (y == h / 2) && (x > w / 4) && (x < w / 2);
    case SCENE_CHECKERBOARD:
        return ((x + y) % 2) == 0;
    case SCENE_ISOLATED:
        return ((x % 2) == 0) && ((y % 2) == 0);
    case SCENE_COMB:
        return ((x % 2) == 0) || (y == h - 1);
    case SCENE_RANDOM:
        return (noise >> 31U) != 0U;
    case SCENE_SPIRAL:
        return scene_spiral(scene, x, y);
    case SCENE_FULL:
        return true;
    case SCENE_EMPTY:
    case SCENE_KINDS:
    default:
        return false;
    }
}

/* What is on is orange, what is off a greyish blue; a little noise on both.  The
 * first three are R, G, B, the others Y, U, V, drawn by themselves. */
static inline uint32_t scene_channel(const scene_t *scene, int32_t x, int32_t y, uint32_t channel) {
    static const uint8_t on[6] = {225, 105, 35, 133, 73, 194};
    static const uint8_t off[6] = {70, 90, 110, 86, 141, 116};
    const uint32_t noise = scene_noise(scene->seed ^ 0x5EEDU, x, y) >> (4U * channel);
    return (scene_on(scene, x, y) ? on[channel] : off[channel]) + (noise & 15U);
}

/* The ranges that find it: of R, G, B and of Y, U, V (or grey). */
#define SCENE_RANGE_RGB {OCEL_SPACE_RGB, {200, 60, 0}, {255, 150, 80}}
#define SCENE_RANGE_YUV {OCEL_SPACE_YUV, {120, 60, 180}, {160, 100, 220}}
#define SCENE_RANGE_GRAY {OCEL_SPACE_GRAY, {120, 0, 0}, {160, 0, 0}}

static inline void scene_pixel(const scene_t *scene, ocel_format_t format, int32_t x, int32_t y,
                               uint8_t *line) {
    uint32_t c[6];
    for (uint32_t k = 0U; k < 6U; k++) {
        c[k] = scene_channel(scene, x, y, k);
    }
    switch (format) {
    case OCEL_FORMAT_RGB565: {
        const uint32_t v = ((c[0] >> 3U) << 11U) | ((c[1] >> 2U) << 5U) | (c[2] >> 3U);
        line[2 * x] = (uint8_t)v;
        line[2 * x + 1] = (uint8_t)(v >> 8U);
        break;
    }
    case OCEL_FORMAT_RGB888:
    case OCEL_FORMAT_BGR888:
        line[3 * x] = (uint8_t)c[(format == OCEL_FORMAT_RGB888) ? 0 : 2];
        line[3 * x + 1] = (uint8_t)c[1];
        line[3 * x + 2] = (uint8_t)c[(format == OCEL_FORMAT_RGB888) ? 2 : 0];
        break;
    case OCEL_FORMAT_YUYV:
        line[2 * x] = (uint8_t)c[3];
        line[2 * x + 1] = (uint8_t)c[((x % 2) == 0) ? 4 : 5];
        break;
    case OCEL_FORMAT_GRAY8:
    default:
        line[x] = (uint8_t)c[3];
        break;
    }
}

static inline void scene_line(const scene_t *scene, ocel_format_t format, int32_t y,
                              uint8_t *line) {
    for (int32_t x = 0; x < scene->width; x++) {
        scene_pixel(scene, format, x, y, line);
    }
}

/* The same line as bits. */
static inline void scene_row(const scene_t *scene, int32_t y, uint32_t *row) {
    for (int32_t x = 0; x < scene->width; x++) {
        if ((x % 32) == 0) {
            row[x / 32] = 0U;
        }
        row[x / 32] |= (scene_on(scene, x, y) ? 1U : 0U) << ((uint32_t)x % 32U);
    }
}

#endif
