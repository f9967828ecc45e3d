/* SPDX-License-Identifier: MIT
 *
 * Another fit of the boundary that the eye holds.
 */
#include <ocellus/eye.h>

ocel_status_t ocel_eye_refit(const ocel_eye_t *eye, const ocel_fit_options_t *options,
                             ocel_detection_t *detection) {
    const ocel_crack_t *cracks;
    size_t count = 0U;
    ocel_fit_options_t full;
    ocel_status_t status;

    if ((eye == NULL) || (options == NULL) || (detection == NULL)) {
        return OCEL_NULL_ARGUMENT;
    }
    cracks = ocel_eye_boundary(eye, &count);
    if (cracks == NULL) {
        return OCEL_BAD_ORDER;
    }
    if (((uint32_t)options->method > (uint32_t)OCEL_FIT_HYPER) ||
        ((uint32_t)options->perturb > (uint32_t)OCEL_PERTURB_NEVER)) {
        return OCEL_BAD_OPTION;
    }
    full = *options;
    full.closed = !detection->blob.touches_edge;
    status = ocel_fit_cracks(cracks, count, &full, &detection->ellipse);
    detection->has_ellipse = (status == OCEL_OK) || (status == OCEL_PARTIAL);
    if (detection->blob.touches_edge) {
        status = OCEL_CLIPPED;
    }
    detection->status = status;
    return status;
}
