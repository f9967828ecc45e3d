/* SPDX-License-Identifier: MIT
 *
 * The standard frames: what every measurement of this repository is made on.
 * A mask is drawn first (0 or 1 a pixel), then painted: mask pixels in the
 * ball's colour, the rest a soft grey-blue gradient, both with a little sensor
 * noise.  FRAME_RANGE_* separates the two exactly, so the mask is also the
 * truth for what colour thresholding must find.
 */
#ifndef SUPPORT_FRAMES_H
#define SUPPORT_FRAMES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "rng.h"

enum { FRAME_WIDTH = 320, FRAME_HEIGHT = 240 };

/* The ball's colour and the range that finds it (both ends included).  Painted
 * values stay within +-12 of the colour; the background's red stays under 140. */
enum { FRAME_BALL_R = 225, FRAME_BALL_G = 105, FRAME_BALL_B = 35 };
enum { FRAME_RANGE_R_LO = 200, FRAME_RANGE_R_HI = 255 };
enum { FRAME_RANGE_G_LO = 60, FRAME_RANGE_G_HI = 150 };
enum { FRAME_RANGE_B_LO = 0, FRAME_RANGE_B_HI = 80 };

/* The ball of the plain and the salted frame. */
#define FRAME_BALL_CX 171.3
#define FRAME_BALL_CY 112.6
#define FRAME_BALL_RADIUS 40.0

typedef enum {
    FRAME_PLAIN = 0,    /* one ball */
    FRAME_SALT,         /* the same, and 5 % of all pixels set, anywhere */
    FRAME_CHECKERBOARD, /* every second pixel, rows alternating: most runs, all 8-connected */
    FRAME_ISOLATED,     /* every second pixel of every second row: most components */
    FRAME_COMB,         /* every second column, joined by the bottom row: latest unions */
    FRAME_RANDOM,       /* half of all pixels */
    FRAME_EMPTY,        /* nothing of the colour */
    FRAME_KINDS
} frame_kind_t;

static inline const char *frame_name(frame_kind_t kind) {
    static const char *const names[FRAME_KINDS] = {"plain", "salt",   "checkerboard", "isolated",
                                                   "comb",  "random", "empty"};
    return (kind < FRAME_KINDS) ? names[kind] : "unknown";
}

/* Finds a frame by name; false when there is none of that name. */
static inline bool frame_by_name(const char *name, frame_kind_t *kind) {
    for (int k = 0; k < (int)FRAME_KINDS; k++) {
        if (strcmp(name, frame_name((frame_kind_t)k)) == 0) {
            *kind = (frame_kind_t)k;
            return true;
        }
    }
    return false;
}

/* Sets the pixels whose centres lie in the disc; clears nothing. */
static inline void frame_add_disc(uint8_t *mask, int width, int height, double cx, double cy,
                                  double radius) {
    const int x_first = (int)fmax(0.0, floor(cx - radius));
    const int x_last = (int)fmin(width - 1.0, ceil(cx + radius));
    const int y_first = (int)fmax(0.0, floor(cy - radius));
    const int y_last = (int)fmin(height - 1.0, ceil(cy + radius));
    for (int y = y_first; y <= y_last; y++) {
        for (int x = x_first; x <= x_last; x++) {
            const double dx = x - cx;
            const double dy = y - cy;
            if (dx * dx + dy * dy <= radius * radius) {
                mask[(size_t)y * (size_t)width + (size_t)x] = 1U;
            }
        }
    }
}

/* Draws the mask of a frame, width * height bytes of 0 or 1.  The ball stands at
 * FRAME_BALL_* whatever the size. */
static inline void frame_mask(frame_kind_t kind, int width, int height, uint64_t seed,
                              uint8_t *mask) {
    rng_t rng = rng_seed(seed);
    memset(mask, 0, (size_t)width * (size_t)height);
    if ((kind == FRAME_PLAIN) || (kind == FRAME_SALT)) {
        frame_add_disc(mask, width, height, FRAME_BALL_CX, FRAME_BALL_CY, FRAME_BALL_RADIUS);
    }
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            bool on = false;
            switch (kind) {
            case FRAME_SALT:
                on = rng_below(&rng, 20U) == 0U;
                break;
            case FRAME_CHECKERBOARD:
                on = ((x + y) % 2) == 0;
                break;
            case FRAME_ISOLATED:
                on = ((x % 2) == 0) && ((y % 2) == 0);
                break;
            case FRAME_COMB:
                on = ((x % 2) == 0) || (y == height - 1);
                break;
            case FRAME_RANDOM:
                on = (rng_u32(&rng) >> 31) != 0U;
                break;
            case FRAME_PLAIN:
            case FRAME_EMPTY:
            case FRAME_KINDS:
            default:
                break;
            }
            if (on) {
                mask[(size_t)y * (size_t)width + (size_t)x] = 1U;
            }
        }
    }
}

static inline uint8_t frame_noisy(rng_t *rng, int value) {
    return (uint8_t)(value + rng_between(rng, -6, 6));
}

/* Paints a mask as BGR, 3 * width * height bytes. */
static inline void frame_paint_bgr(const uint8_t *mask, int width, int height, uint64_t seed,
                                   uint8_t *bgr) {
    rng_t rng = rng_seed(seed ^ 0x5041494E54ULL);
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            const size_t at = (size_t)y * (size_t)width + (size_t)x;
            const int ramp_x = (60 * x) / width;
            const int ramp_y = (40 * y) / height;
            const bool ball = mask[at] != 0U;
            const int shade = ball ? ((ramp_x + ramp_y) % 13) - 6 : 0;
            bgr[3U * at] = frame_noisy(&rng, ball ? FRAME_BALL_B + shade : 90 + ramp_y + ramp_x);
            bgr[3U * at + 1U] =
                frame_noisy(&rng, ball ? FRAME_BALL_G + shade : 70 + ramp_x + ramp_y / 2);
            bgr[3U * at + 2U] = frame_noisy(&rng, ball ? FRAME_BALL_R + shade : 50 + ramp_x);
        }
    }
}

/* A whole standard frame as BGR; the mask (width * height bytes) is kept beside it. */
static inline void frame_draw_bgr(frame_kind_t kind, int width, int height, uint64_t seed,
                                  uint8_t *mask, uint8_t *bgr) {
    frame_mask(kind, width, height, seed, mask);
    frame_paint_bgr(mask, width, height, seed, bgr);
}

/* BGR to the camera's other layouts. */
static inline void frame_bgr_to_rgb565(const uint8_t *bgr, size_t pixels, uint8_t *rgb565) {
    for (size_t i = 0; i < pixels; i++) {
        const unsigned v = ((unsigned)(bgr[3U * i + 2U] >> 3) << 11) |
                           ((unsigned)(bgr[3U * i + 1U] >> 2) << 5) | (unsigned)(bgr[3U * i] >> 3);
        rgb565[2U * i] = (uint8_t)(v & 0xFFU);
        rgb565[2U * i + 1U] = (uint8_t)(v >> 8);
    }
}

/* A mask to the library's bit rows: words_per_row = (width + 31) / 32. */
static inline void frame_mask_to_bits(const uint8_t *mask, int width, int height, uint32_t *rows) {
    const size_t words = ((size_t)width + 31U) / 32U;
    memset(rows, 0, words * (size_t)height * sizeof(uint32_t));
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            if (mask[(size_t)y * (size_t)width + (size_t)x] != 0U) {
                rows[(size_t)y * words + (size_t)x / 32U] |= (uint32_t)1U << ((unsigned)x % 32U);
            }
        }
    }
}

#endif
