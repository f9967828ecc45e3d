/* SPDX-License-Identifier: MIT
 *
 * A result is a status first.  Only OCEL_OK is vouched for; OCEL_PARTIAL and
 * OCEL_CLIPPED may carry an estimate; every other status carries none.
 */
#ifndef OCELLUS_STATUS_H
#define OCELLUS_STATUS_H

#ifdef __cplusplus
extern "C" {
#endif

typedef enum {
    /* Answers about the scene or the data. */
    OCEL_OK = 0,         /* the library vouches for the answer */
    OCEL_PARTIAL,        /* an estimate, not vouched for: too short an arc, say */
    OCEL_CLIPPED,        /* cut by the image's edge: an estimate, not vouched for */
    OCEL_NOT_SEEN,       /* no pixel of the colour, or none large enough */
    OCEL_TOO_FEW_POINTS, /* fewer than OCEL_MIN_FIT_POINTS */
    OCEL_DEGENERATE,     /* collinear or coincident points, or no unique conic */
    OCEL_NOT_AN_ELLIPSE, /* the best conic is a parabola, a hyperbola or endless */
    OCEL_OVERFLOW,       /* a stated capacity was exceeded; nothing was truncated */
    OCEL_OUT_OF_RANGE,   /* a coordinate or a result outside its stated range */
    /* Mistakes of the caller. */
    OCEL_NULL_ARGUMENT, /* a required pointer is null */
    OCEL_BAD_SIZE,      /* an image or rectangle that is empty or over a limit */
    OCEL_BAD_STRIDE,    /* a line or stride shorter than its pixels */
    OCEL_BAD_FORMAT,    /* an unknown pixel format, or one that cannot serve here */
    OCEL_BAD_OPTION,    /* an option or a colour bound outside its stated values */
    OCEL_BAD_ORDER      /* a call out of order: a line skipped, repeated or missing */
} ocel_status_t;

/* The status's name as the command line prints it ("ok", "not_seen", ...);
 * "unknown" for a value that is none.  Never null. */
const char *ocel_status_name(ocel_status_t status);

#ifdef __cplusplus
}
#endif

#endif
