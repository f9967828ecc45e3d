/* SPDX-License-Identifier: MIT
 *
 * The cone through the boundary that the eye holds.
 */
#include <ocellus/eye.h>

#include <string.h>

/* A blob that the image's edge cuts, and whose rest does not suffice.  (A point out of
 * range stays that: the camera is not the frame's.) */
static ocel_status_t as_clipped(ocel_status_t status) {
    const bool unsure =
        (status == OCEL_PARTIAL) || (status == OCEL_DEGENERATE) || (status == OCEL_TOO_FEW_POINTS);

    return unsure ? OCEL_CLIPPED : status;
}

/* The cone of a frame in which something was seen. */
static ocel_status_t cone_of_boundary(const ocel_eye_t *eye, const ocel_camera_t *camera,
                                      const ocel_detection_t *detection, ocel_cone_t *cone) {
    size_t count = 0U;
    const ocel_crack_t *cracks = ocel_eye_boundary(eye, &count);
    ocel_status_t status = OCEL_BAD_ORDER;

    if (cracks != NULL) {
        status = ocel_cone_fit_cracks(camera, cracks, count, cone);
        if (detection->blob.touches_edge) {
            status = as_clipped(status);
        }
    } else if ((detection->status == OCEL_CLIPPED) && (detection->boundary_count == 0U)) {
        status = OCEL_CLIPPED; /* the image is full of it */
    } else {
        /* There is no boundary. */
    }
    return status;
}

ocel_status_t ocel_eye_cone(const ocel_eye_t *eye, const ocel_camera_t *camera,
                            const ocel_detection_t *detection, ocel_cone_t *cone) {
    ocel_status_t status = OCEL_NULL_ARGUMENT;

    if (cone != NULL) {
        (void)memset(cone, 0, sizeof(*cone));
    }
    if ((eye != NULL) && (camera != NULL) && (detection != NULL) && (cone != NULL)) {
        status = detection->status;
        if ((status != OCEL_NOT_SEEN) && (status != OCEL_OVERFLOW)) {
            status = cone_of_boundary(eye, camera, detection, cone);
        }
    }
    return status;
}
