/* SPDX-License-Identifier: MIT
 *
 * Another fit of the boundary that the eye holds.
 */
#include <ocellus/eye.h>

/* Known beforehand, so that the detection itself can take the fit's result: a
 * second ellipse would be 40 bytes of stack. */
static bool is_known(const ocel_fit_options_t *options) {
    return ((uint32_t)options->method <= (uint32_t)OCEL_FIT_HYPER) &&
           ((uint32_t)options->perturb <= (uint32_t)OCEL_PERTURB_NEVER);
}

static ocel_status_t refit(const ocel_crack_t *cracks, size_t count,
                           const ocel_fit_options_t *options, ocel_detection_t *detection) {
    const bool closed = !detection->blob.touches_edge;
    const ocel_fit_options_t settings = {options->method, options->perturb, closed};
    ocel_status_t status = ocel_fit_cracks(cracks, count, &settings, &detection->ellipse);

    detection->has_ellipse = (status == OCEL_OK) || (status == OCEL_PARTIAL);
    if (!closed) {
        status = OCEL_CLIPPED;
    }
    detection->status = status;
    return status;
}

ocel_status_t ocel_eye_refit(const ocel_eye_t *eye, const ocel_fit_options_t *options,
                             ocel_detection_t *detection) {
    size_t count = 0U;
    const ocel_crack_t *cracks = ocel_eye_boundary(eye, &count);
    ocel_status_t status = OCEL_BAD_ORDER;

    if ((eye == NULL) || (options == NULL) || (detection == NULL)) {
        status = OCEL_NULL_ARGUMENT;
    } else if (!is_known(options)) {
        status = OCEL_BAD_OPTION;
    } else if (cracks != NULL) {
        status = refit(cracks, count, options, detection);
    } else {
        /* There is no boundary. */
    }
    return status;
}
