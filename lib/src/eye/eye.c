/* SPDX-License-Identifier: MIT
 *
 * The eye: ties colour, labelling and fit together.  A whole frame is taken as
 * its lines, so that both ways are one.
 */
#include <ocellus/eye.h>

#include <string.h>

/* The eye's states: values that memory which was never initialised is unlikely
 * to hold. */
#define STATE_NONE 0U
#define STATE_READY 0x0E41U
#define STATE_LINES 0x0E42U

/* A disc of 16 pixels has a radius of 2.3 px: below that an ellipse says no more
 * than the blob's box does. */
#define DEFAULT_MIN_AREA 16U

/* The eye's own fit, ocel_fit_boundary, serves where the cracks' squared offsets
 * can only sum to less than 2^31 half pixels: up to 320x240 and beyond.  Under
 * larger limits, where no one counts bytes of code, the general one is linked. */
#define SIDE_HPX (2 * ((OCEL_MAX_WIDTH > OCEL_MAX_HEIGHT) ? OCEL_MAX_WIDTH : OCEL_MAX_HEIGHT))
#define EYE_IS_SMALL ((OCEL_MAX_CRACKS * SIDE_HPX * SIDE_HPX) < 0x80000000)

static ocel_status_t fit_direct(const ocel_crack_t *cracks, size_t count, bool closed,
                                ocel_ellipse_t *ellipse) {
#if EYE_IS_SMALL
    return ocel_fit_boundary(cracks, count, closed, ellipse);
#else
    const ocel_fit_options_t options = {OCEL_FIT_B2AC, OCEL_PERTURB_AUTO, closed};

    return ocel_fit_cracks(cracks, count, &options, ellipse);
#endif
}

static bool fits_limit(uint32_t side, uint32_t limit) {
    return (side > 0U) && (side <= limit);
}

ocel_status_t ocel_eye_init(ocel_eye_t *eye, const ocel_eye_config_t *config) {
    ocel_status_t status = OCEL_NULL_ARGUMENT;

    if (eye != NULL) {
        eye->state = STATE_NONE;
    }
    if ((eye != NULL) && (config != NULL)) {
        const ocel_connectivity_t connectivity =
            ((uint32_t)config->connectivity == 0U) ? OCEL_CONNECT_8 : config->connectivity;

        if ((!fits_limit(config->width, OCEL_MAX_WIDTH)) ||
            (!fits_limit(config->height, OCEL_MAX_HEIGHT))) {
            status = OCEL_BAD_SIZE;
        } else if ((connectivity != OCEL_CONNECT_8) && (connectivity != OCEL_CONNECT_4)) {
            status = OCEL_BAD_OPTION;
        } else {
            eye->config = *config;
            eye->config.connectivity = connectivity;
            if (config->min_area == 0U) {
                eye->config.min_area = DEFAULT_MIN_AREA;
            }
            eye->next_line = 0U;
            eye->boundary_first = 0U;
            eye->boundary_count = 0U;
            eye->state = STATE_READY;
            status = OCEL_OK;
        }
    }
    return status;
}

ocel_status_t ocel_eye_begin(ocel_eye_t *eye) {
    ocel_status_t status = OCEL_BAD_ORDER;

    if (eye == NULL) {
        status = OCEL_NULL_ARGUMENT;
    } else if ((eye->state == STATE_READY) || (eye->state == STATE_LINES)) {
        eye->next_line = 0U;
        eye->boundary_count = 0U;
        eye->state = STATE_LINES;
        status = ocel_label_begin(&eye->labeller, &eye->pool, eye->config.width, eye->config.height,
                                  eye->config.connectivity);
    } else {
        /* Not initialised. */
    }
    return status;
}

/* Takes the line as a row of bits; it must be the next one. */
static ocel_status_t take_row(ocel_eye_t *eye, const uint32_t *row) {
    eye->next_line++;
    return ocel_label_row(&eye->labeller, &eye->pool, row, NULL, NULL);
}

static bool is_next_line(const ocel_eye_t *eye, uint16_t y) {
    return (eye->state == STATE_LINES) && (y == eye->next_line) && (y < eye->config.height);
}

ocel_status_t ocel_eye_line(ocel_eye_t *eye, const ocel_colour_t *colour, uint16_t y,
                            const uint8_t *line, size_t line_bytes) {
    ocel_status_t status = OCEL_BAD_ORDER;

    if ((eye == NULL) || (colour == NULL) || (line == NULL)) {
        status = OCEL_NULL_ARGUMENT;
    } else if (is_next_line(eye, y)) {
        status = ocel_colour_row(colour, line, line_bytes, eye->config.width, eye->row);
        if (status == OCEL_OK) {
            status = take_row(eye, eye->row);
        }
    } else {
        /* The frame stays as it was. */
    }
    return status;
}

ocel_status_t ocel_eye_row(ocel_eye_t *eye, uint16_t y, const uint32_t *row) {
    ocel_status_t status = OCEL_BAD_ORDER;

    if ((eye == NULL) || (row == NULL)) {
        status = OCEL_NULL_ARGUMENT;
    } else if (is_next_line(eye, y)) {
        status = take_row(eye, row);
    } else {
        /* The frame stays as it was. */
    }
    return status;
}

/* True when the crack lies between the image and its outside. */
static bool is_on_edge(const ocel_eye_t *eye, ocel_crack_t crack) {
    const int32_t right_hpx = (2 * (int32_t)eye->config.width) - 1;
    const int32_t below_hpx = (2 * (int32_t)eye->config.height) - 1;

    return (crack.x_hpx < 0) || (crack.y_hpx < 0) || (crack.x_hpx == right_hpx) ||
           (crack.y_hpx == below_hpx);
}

/* Leaves out the boundary's cracks on the image's edge; the others keep their
 * order. */
static void drop_edge_cracks(ocel_eye_t *eye) {
    const uint32_t first = eye->boundary_first;
    uint32_t kept = 0U;

    for (uint32_t i = 0U; i < eye->boundary_count; i++) { /* bound: OCEL_MAX_CRACKS */
        const ocel_crack_t crack = eye->pool.cells[first + i];

        if (!is_on_edge(eye, crack)) {
            eye->pool.cells[first + kept] = crack;
            kept++;
        }
    }
    eye->boundary_count = (uint16_t)kept;
}

/* Gets the boundary of the blob and fits it. */
static ocel_status_t fit_blob(ocel_eye_t *eye, ocel_detection_t *detection) {
    const ocel_crack_t *cracks = NULL;
    const bool closed = !detection->blob.touches_edge;
    size_t count = 0U;
    size_t stride = 1U;
    ocel_status_t status =
        ocel_label_boundary(&eye->labeller, &eye->pool, &cracks, &count, &stride);

    if (status == OCEL_OK) {
        const ptrdiff_t first = cracks - eye->pool.cells;

        eye->boundary_first = (uint16_t)first;
        eye->boundary_count = (uint16_t)count;
        if (!closed) {
            drop_edge_cracks(eye);
        }
        detection->boundary_count = eye->boundary_count;
        detection->boundary_stride = (uint32_t)stride;
        status = fit_direct(cracks, eye->boundary_count, closed, &detection->ellipse);
        detection->has_ellipse = (status == OCEL_OK) || (status == OCEL_PARTIAL);
        if (!closed) {
            status = OCEL_CLIPPED;
        }
    }
    return status;
}

ocel_status_t ocel_eye_end(ocel_eye_t *eye, ocel_detection_t *detection) {
    ocel_status_t status = OCEL_BAD_ORDER;

    if ((eye == NULL) || (detection == NULL)) {
        status = OCEL_NULL_ARGUMENT;
    } else {
        (void)memset(detection, 0, sizeof(*detection));
        if (eye->state == STATE_LINES) {
            eye->state = STATE_READY;
            status = ocel_label_end(&eye->labeller, &eye->pool, NULL, NULL, &detection->blob);
            detection->stats = ocel_label_stats(&eye->labeller);
        }
        if ((status == OCEL_OK) && (detection->blob.area >= eye->config.min_area)) {
            status = fit_blob(eye, detection);
        } else if (status == OCEL_OK) {
            (void)memset(&detection->blob, 0, sizeof(detection->blob));
            status = OCEL_NOT_SEEN;
        } else {
            /* Nothing was seen, or lines are missing. */
        }
        detection->status = status;
    }
    return status;
}

const ocel_crack_t *ocel_eye_boundary(const ocel_eye_t *eye, size_t *count) {
    const ocel_crack_t *cracks = NULL;
    size_t cracks_count = 0U;

    if ((eye != NULL) && (eye->state == STATE_READY) && (eye->boundary_count != 0U)) {
        cracks = &eye->pool.cells[eye->boundary_first];
        cracks_count = eye->boundary_count;
    }
    if (count != NULL) {
        *count = cracks_count;
    }
    return cracks;
}

ocel_status_t ocel_eye_frame(ocel_eye_t *eye, const ocel_colour_t *colour, const uint8_t *frame,
                             size_t stride_bytes, ocel_detection_t *detection) {
    ocel_status_t status;

    if ((eye == NULL) || (colour == NULL) || (frame == NULL) || (detection == NULL)) {
        status = OCEL_NULL_ARGUMENT;
    } else {
        (void)memset(detection, 0, sizeof(*detection));
        status = ocel_eye_begin(eye);
        /* bound: OCEL_MAX_HEIGHT */
        for (uint16_t y = 0U; (status == OCEL_OK) && (y < eye->config.height); y++) {
            status = ocel_eye_line(eye, colour, y, &frame[(size_t)y * stride_bytes], stride_bytes);
        }
        if (status == OCEL_OK) {
            status = ocel_eye_end(eye, detection);
        }
        detection->status = status;
    }
    return status;
}
