/* SPDX-License-Identifier: MIT
 *
 * Colour: one camera line in, one row of bits out.  A range of colours is
 * compiled once into what makes the pixel test fast, then applied line by line.
 */
#ifndef OCELLUS_COLOUR_H
#define OCELLUS_COLOUR_H

#include <stddef.h>
#include <stdint.h>

#include <ocellus/config.h>
#include <ocellus/status.h>
#include <ocellus/types.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How a camera line is laid out in memory. */
typedef enum {
    OCEL_FORMAT_RGB565 = 0, /* 2 bytes a pixel, little-endian: R 15..11, G 10..5, B 4..0 */
    OCEL_FORMAT_RGB888,     /* 3 bytes: R, G, B */
    OCEL_FORMAT_BGR888,     /* 3 bytes: B, G, R (OpenCV's order) */
    OCEL_FORMAT_YUYV,       /* 2 bytes: Y0 U Y1 V for two pixels; an even width */
    OCEL_FORMAT_GRAY8       /* 1 byte */
} ocel_format_t;

/* What is tested, exactly:
 *   RGB   RGB565 is widened to 8 bits by repeating a channel's upper bits; YUYV is
 *         converted by the full-range BT.601 formulas (JFIF, ITU-T T.871) in Q16,
 *         rounded to the nearest integer and clipped.
 *   HSV   of R, G, B without rounding: V is the largest, S = 255 (V - smallest) / V,
 *         H in [0, 360) by the usual hexagon; H is 0 when R = G = B, S when V = 0.
 *   YUV   as YUYV has them; of R, G, B by the weights 77 150 29, -43 -85 128 and
 *         128 -107 -21 over 256, to the nearest integer, U and V offset by 128.
 *   grey  the Y of YUV. */
typedef enum {
    OCEL_SPACE_RGB = 0, /* R, G, B, 0..255 */
    OCEL_SPACE_HSV,     /* H 0..360 degrees, S and V 0..255 */
    OCEL_SPACE_YUV,     /* Y, U, V, 0..255, full-range BT.601 (JFIF) */
    OCEL_SPACE_GRAY     /* grey in channel 0, 0..255 */
} ocel_space_t;

/* A range of colours, both ends included: lo[k] <= channel k <= hi[k].  Hue may
 * wrap: lo[0] > hi[0] means lo..360 and 0..hi.  Grey uses channel 0 only. */
typedef struct {
    ocel_space_t space;
    uint16_t lo[3];
    uint16_t hi[3];
} ocel_colour_range_t;

/* One bit for each RGB565 colour, set when it is in range: bit (p & 31) of word
 * (p >> 5) for the pixel p.  8 KB and 4 bytes, caller-owned; may be made once and be
 * const.
 *   least     a pixel with, or below, the least red, green and blue in range
 *   headroom  the same of what the greatest lack of the channel's top
 * Both may be 0, as if black and white were in range: the bits of a row are the same
 * then, but more pixels are looked up. */
typedef struct {
    uint32_t word[OCEL_COLOUR_TABLE_WORDS];
    uint16_t least;
    uint16_t headroom;
} ocel_colour_table_t;

/* A compiled range.  Opaque: read it through the functions below. */
typedef struct {
    ocel_colour_range_t range; /* grey as Y, U and V */
    ocel_format_t format;
    const ocel_colour_table_t *table; /* RGB565 only; null elsewhere */
    uint32_t lanes[3][4];             /* bounds of bytes, as the line tests take them */
    uint8_t at[3];                    /* which byte of the pixel each is for */
    uint8_t exact;                    /* 1: the bounds are the range */
    uint16_t state;
} ocel_colour_t;

/* Bytes of one line of `width` pixels in `format`; 0 for an unknown format. */
size_t ocel_colour_line_bytes(ocel_format_t format, uint16_t width);

/* Compiles `range` for lines in `format`.
 *   colour  out; on failure it is left unusable (every row then says BAD_FORMAT).
 *   range   lo and hi within the space's stated values, lo <= hi except for hue.
 *   table   RGB565: caller-owned, filled here (65536 colour tests, once), must
 *           outlive `colour`; null elsewhere.
 * OCEL_NULL_ARGUMENT  colour or range is null, or table is null with RGB565
 * OCEL_BAD_FORMAT     format is none of the enumeration
 * OCEL_BAD_OPTION     space is none of the enumeration, or a bound out of range */
ocel_status_t ocel_colour_compile(ocel_colour_t *colour, const ocel_colour_range_t *range,
                                  ocel_format_t format, ocel_colour_table_t *table);

/* Tests one line.
 *   line        line_bytes readable bytes, any alignment.
 *   line_bytes  >= ocel_colour_line_bytes(format, width).
 *   row         out: bit x%32 of word x/32 is pixel x; bits past width are 0;
 *               (width + 31) / 32 words are written.
 * OCEL_NULL_ARGUMENT  a pointer is null
 * OCEL_BAD_SIZE       width is 0 or over OCEL_MAX_WIDTH, or odd with YUYV
 * OCEL_BAD_STRIDE     line_bytes too small
 * OCEL_BAD_FORMAT     colour was not compiled */
ocel_status_t ocel_colour_row(const ocel_colour_t *colour, const uint8_t *line, size_t line_bytes,
                              uint16_t width, uint32_t *row);

/* Tests one RGB565 line by a table alone, which may be const and made elsewhere:
 * all that a firmware links for colour then.  The bits of ocel_colour_row; line,
 * line_bytes, width and row as there.
 * OCEL_NULL_ARGUMENT, OCEL_BAD_SIZE, OCEL_BAD_STRIDE  as there */
ocel_status_t ocel_colour_table_row(const ocel_colour_table_t *table, const uint8_t *line,
                                    size_t line_bytes, uint16_t width, uint32_t *row);

/* ---- Teaching: the range that covers a rectangle's pixels ---- */

/* Counts while the taught rectangle is read: caller-owned, about 5.1 KB.  Opaque. */
typedef struct {
    uint32_t count[3][256];   /* per channel; hue in steps of 360/256 degrees, by chroma */
    uint32_t hueless[2][256]; /* HSV: S and V of the pixels that carry no hue */
    uint32_t pixels;          /* all that were added */
    uint32_t hueless_pixels;
    ocel_space_t space;
    ocel_format_t format;
    uint16_t state;
} ocel_teach_t;

/* Starts teaching a range in `space` from lines in `format`.
 * OCEL_NULL_ARGUMENT  teach is null
 * OCEL_BAD_FORMAT     format is none of the enumeration
 * OCEL_BAD_OPTION     space is none of the enumeration */
ocel_status_t ocel_teach_begin(ocel_teach_t *teach, ocel_space_t space, ocel_format_t format);

/* Adds pixels first_x .. first_x + count - 1 of one line.
 * OCEL_NULL_ARGUMENT  a pointer is null
 * OCEL_BAD_ORDER      teaching was not begun
 * OCEL_BAD_SIZE       count is 0, or first_x + count over OCEL_MAX_WIDTH
 * OCEL_BAD_STRIDE     the line has fewer bytes than that
 * OCEL_OVERFLOW       more than 2^24 pixels in all; these were not added */
ocel_status_t ocel_teach_line(ocel_teach_t *teach, const uint8_t *line, size_t line_bytes,
                              uint16_t first_x, uint16_t count);

/* The range learnt, fit for ocel_colour_compile: per channel the middle 96 % of
 * the pixels, each end moved out by a quarter of the width or by a margin,
 * whichever is more, within the space.  The margins: 8 of 255 for R, G, B, Y and
 * grey, 4 for U and V, 16 for S and V, 4 degrees for H.
 *
 * Hue is the shortest arc that holds 96 %, a pixel counting as much as it has
 * chroma (largest less smallest channel).  Pixels with a chroma under 8 carry no
 * hue: the noise of a camera turns it anyhow.  They are left out as highlights
 * and shadows when they are at most half of all and the others' chroma is 16 or
 * more in the mean; or when they are at most 1/32.  Otherwise the object is grey,
 * all pixels count, and the range holds every hue.
 * OCEL_NULL_ARGUMENT   a pointer is null
 * OCEL_BAD_ORDER       teaching was not begun
 * OCEL_TOO_FEW_POINTS  fewer than 16 pixels were added
 * `range` is written for OCEL_OK only. */
ocel_status_t ocel_teach_end(const ocel_teach_t *teach, ocel_colour_range_t *range);

#ifdef __cplusplus
}
#endif

#endif
