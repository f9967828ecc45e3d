/* SPDX-License-Identifier: MIT
 *
 * Every limit of the library, in one place, each with its derivation.
 * Override a limit by defining it for the whole build (for example
 * -DOCEL_MAX_WIDTH=640): the limits size the contexts, so the library and its
 * callers must see the same values.  No limit changes a result: a frame that
 * fits two configurations gives the same bits in both.
 */
#ifndef OCELLUS_CONFIG_H
#define OCELLUS_CONFIG_H

/* Widest image, in pixels.  Sizes the labeller: about 24 bytes a column. */
#ifndef OCEL_MAX_WIDTH
#define OCEL_MAX_WIDTH 320
#endif

/* Tallest image, in pixels.  Costs no memory by itself; together with the
 * width it decides how wide the moment sums are (ocel_moment_t). */
#ifndef OCEL_MAX_HEIGHT
#define OCEL_MAX_HEIGHT 240
#endif

/* Cells of the boundary pool, 4 bytes each.  One cell holds one vertical crack
 * of a component that is still open, or of the best one so far; afterwards the
 * same cells hold the boundary points.  A disc of radius R costs 4 R cells
 * while it is labelled and 8 R points afterwards: 2048 cells hold any disc
 * that fits in 320x240 (R = 120: 480 cells, 960 points) four times over. */
#ifndef OCEL_MAX_CRACKS
#define OCEL_MAX_CRACKS 2048
#endif

/* Most runs in one row: every second pixel. */
#define OCEL_MAX_RUNS ((OCEL_MAX_WIDTH + 1) / 2)

/* Words of one row of the binary image, 32 pixels each, bit 0 leftmost. */
#define OCEL_ROW_WORDS ((OCEL_MAX_WIDTH + 31) / 32)

/* Most points that a fit accepts: the quartic sums of 2^14 points, normalised
 * to 26 bits, take 4*26 + 14 = 118 bits of the 127 there are. */
#define OCEL_MAX_FIT_POINTS 16384

/* Fewest points that determine an ellipse. */
#define OCEL_MIN_FIT_POINTS 5

/* Points must lie within +-16384 px: 2^30 in Q16, so that the difference of
 * two coordinates, and its double, fit in 32 bits. */
#define OCEL_MAX_COORDINATE_PX 16384

/* Steps that undo a lens's distortion (lens.c).  Four bring k1 = -.35, k2 = .12 at
 * f = 300 px within 1/64 px everywhere in 640x480, five to the last bit; the sixth is
 * for stronger ones. */
#define OCEL_UNDISTORT_STEPS 6

/* Cones through three points that the robust fit tries (cone_vote.c).  Half of a
 * ball's outline hidden by a straight edge leaves 61 % of the boundary on it: the
 * rule of the triples then has 10 hypotheses of 32 wholly there, and of points in any order
 * one set of 32 in 4000 has none. */
#define OCEL_CONE_HYPOTHESES 32

/* Entries of the RGB565 colour table: one bit a colour, 32 blues a word. */
#define OCEL_COLOUR_TABLE_WORDS 2048

#if (OCEL_MAX_WIDTH < 8) || (OCEL_MAX_WIDTH > 4096)
#error "OCEL_MAX_WIDTH must be 8..4096: half-pixel coordinates are 16-bit"
#endif
#if (OCEL_MAX_HEIGHT < 1) || (OCEL_MAX_HEIGHT > 4096)
#error "OCEL_MAX_HEIGHT must be 1..4096: half-pixel coordinates are 16-bit"
#endif
#if (OCEL_MAX_CRACKS < 64) || (OCEL_MAX_CRACKS > 65534)
#error "OCEL_MAX_CRACKS must be 64..65534: cells are linked by 16-bit indices"
#endif

#endif
