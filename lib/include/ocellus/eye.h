/* SPDX-License-Identifier: MIT
 *
 * The eye: camera lines in, the ball's ellipse out, in one call or line by
 * line.  Both ways give the same bits.
 */
#ifndef OCELLUS_EYE_H
#define OCELLUS_EYE_H

#include <stddef.h>
#include <stdint.h>

#include <ocellus/colour.h>
#include <ocellus/cone.h>
#include <ocellus/fit.h>
#include <ocellus/label.h>
#include <ocellus/status.h>
#include <ocellus/types.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What to look for.  Zero it, then set width and height: the zeros of the other
 * members are their defaults. */
typedef struct {
    uint16_t width; /* of the frames, px */
    uint16_t height;
    uint32_t min_area;                /* px: smaller blobs are OCEL_NOT_SEEN; 0 means 16 */
    ocel_connectivity_t connectivity; /* 0 means OCEL_CONNECT_8 */
} ocel_eye_config_t;

/* What was found. */
typedef struct {
    ocel_status_t status;
    ocel_blob_t blob;         /* zero when status is NOT_SEEN or a caller's mistake */
    ocel_ellipse_t ellipse;   /* zero unless has_ellipse */
    bool has_ellipse;         /* always with OK and PARTIAL, perhaps with CLIPPED */
    uint32_t boundary_count;  /* cracks that were fitted */
    uint32_t boundary_stride; /* 1: every crack of the boundary; label.h tells the rule */
    ocel_label_stats_t stats;
} ocel_detection_t;

/* The context: labelling state and boundary pool.  Caller-owned, static or on
 * a stack; it may be copied between two calls.  Opaque. */
typedef struct {
    ocel_eye_config_t config; /* defaults filled in */
    ocel_labeller_t labeller;
    ocel_crack_pool_t pool;
    uint32_t row[OCEL_ROW_WORDS]; /* the line in hand */
    uint16_t next_line;
    uint16_t state;
    uint16_t boundary_first; /* pool cells that hold the boundary */
    uint16_t boundary_count;
} ocel_eye_t;

/* Checks the configuration and readies the context.
 * OCEL_NULL_ARGUMENT  eye or config is null
 * OCEL_BAD_SIZE       a side is 0 or over its limit
 * OCEL_BAD_OPTION     connectivity is none of its values */
ocel_status_t ocel_eye_init(ocel_eye_t *eye, const ocel_eye_config_t *config);

/* Starts a frame, whatever became of the last one.
 * OCEL_NULL_ARGUMENT, OCEL_BAD_ORDER (not initialised) */
ocel_status_t ocel_eye_begin(ocel_eye_t *eye);

/* Takes line y; the lines come in order, 0 first.
 * OCEL_NULL_ARGUMENT  a pointer is null
 * OCEL_BAD_ORDER      no frame begun, or y is not the next line; the frame
 *                     stays as it was, so the right line may follow
 * OCEL_BAD_SIZE       an odd width with YUYV
 * OCEL_BAD_STRIDE     line_bytes too small
 * OCEL_BAD_FORMAT     colour was not compiled */
ocel_status_t ocel_eye_line(ocel_eye_t *eye, const ocel_colour_t *colour, uint16_t y,
                            const uint8_t *line, size_t line_bytes);

/* The same for a row that is binary already (label.h tells its layout).
 * OCEL_NULL_ARGUMENT, OCEL_BAD_ORDER */
ocel_status_t ocel_eye_row(ocel_eye_t *eye, uint16_t y, const uint32_t *row);

/* Ends the frame, finds its largest blob and fits its boundary (B2AC).  Where
 * the blob is cut by the image's edge the cracks on the edge are not the ball's:
 * they are left out.  The return value equals detection->status.
 * OCEL_OK             blob and ellipse
 * OCEL_PARTIAL        blob and ellipse, but the boundary is no ellipse's (fit.h): the ball
 *                     is hidden in part, say
 * OCEL_CLIPPED        the blob is cut by the image's edge; an ellipse through
 *                     what is inside, when has_ellipse
 * OCEL_NOT_SEEN       no blob of at least min_area pixels
 * OCEL_OVERFLOW       the boundary exceeded the pool; the blob is right
 * OCEL_DEGENERATE, OCEL_NOT_AN_ELLIPSE, OCEL_TOO_FEW_POINTS, OCEL_OUT_OF_RANGE
 *                     the blob has no ellipse (a line of pixels, say)
 * OCEL_BAD_ORDER      lines are missing: the frame is given up
 * OCEL_NULL_ARGUMENT  a pointer is null */
ocel_status_t ocel_eye_end(ocel_eye_t *eye, ocel_detection_t *detection);

/* The boundary that ocel_eye_end fitted, for drawing or a fit of one's own;
 * valid until the next ocel_eye_begin.  Null, and *count 0, when there is none;
 * count may be null. */
const ocel_crack_t *ocel_eye_boundary(const ocel_eye_t *eye, size_t *count);

/* Fits the boundary of the last ocel_eye_end again, by another method; apart
 * from ocel_eye_end so that who does not call it does not link it.
 *   options    options->closed is not read: the eye knows.
 *   detection  of that ocel_eye_end; its ellipse and status are renewed.
 * OCEL_OK, OCEL_PARTIAL, OCEL_CLIPPED, OCEL_DEGENERATE, OCEL_NOT_AN_ELLIPSE,
 * OCEL_TOO_FEW_POINTS, OCEL_OUT_OF_RANGE  as there
 * OCEL_BAD_OPTION     as in ocel_fit_cracks; detection stays as it was
 * OCEL_BAD_ORDER      there is no boundary; detection stays as it was
 * OCEL_NULL_ARGUMENT  a pointer is null */
ocel_status_t ocel_eye_refit(const ocel_eye_t *eye, const ocel_fit_options_t *options,
                             ocel_detection_t *detection);

/* Fits the cone of rays to the boundary of the last ocel_eye_end (cone.h): robust
 * to what hides a part of the ball, and placed by ocel_sphere_of_cone.  A blob cut
 * by the image's edge is OCEL_CLIPPED unless the cone is vouched for.
 *   detection  of that ocel_eye_end; only read.
 *   cone       out; written for OCEL_OK, OCEL_PARTIAL and OCEL_CLIPPED, zeroed otherwise.
 * OCEL_OK, OCEL_PARTIAL, OCEL_DEGENERATE, OCEL_TOO_FEW_POINTS, OCEL_OUT_OF_RANGE
 *                     as in ocel_cone_fit_cracks
 * OCEL_CLIPPED        cut by the image's edge and not vouched for: an estimate, or
 *                     none, a cone of zeros (the image is full of the colour, say)
 * OCEL_NOT_SEEN, OCEL_OVERFLOW  as the detection
 * OCEL_BAD_ORDER      no boundary, or the camera was not initialised
 * OCEL_NULL_ARGUMENT  a pointer is null */
ocel_status_t ocel_eye_cone(const ocel_eye_t *eye, const ocel_camera_t *camera,
                            const ocel_detection_t *detection, ocel_cone_t *cone);

/* A whole frame: begin, every line, end.
 *   stride_bytes  from one line to the next, >= ocel_colour_line_bytes().
 * Statuses of the three. */
ocel_status_t ocel_eye_frame(ocel_eye_t *eye, const ocel_colour_t *colour, const uint8_t *frame,
                             size_t stride_bytes, ocel_detection_t *detection);

#ifdef __cplusplus
}
#endif

#endif
