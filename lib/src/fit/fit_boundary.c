/* SPDX-License-Identifier: MIT
 *
 * The eye's own fit: B2AC on a blob's boundary.  It stands apart from fit.c so
 * that a firmware that needs no other links no other.
 */
#include <string.h>

#include <ocellus/fit.h>

#include "fit_finish.h"

ocel_status_t ocel_fit_boundary(const ocel_crack_t *cracks, size_t count, bool closed,
                                ocel_ellipse_t *ellipse) {
    const ocel_source_t source = {NULL, cracks, count};
    ocel_status_t status = OCEL_OK;

    if (ellipse != NULL) {
        (void)memset(ellipse, 0, sizeof(*ellipse));
    }
    if ((cracks == NULL) || (ellipse == NULL)) {
        status = OCEL_NULL_ARGUMENT;
    } else if (count < (size_t)OCEL_MIN_FIT_POINTS) {
        status = OCEL_TOO_FEW_POINTS;
    } else if (count > (size_t)OCEL_MAX_FIT_POINTS) {
        status = OCEL_OVERFLOW;
    } else {
        ocel_solution_t solution;
        int64_t eigenvalue;

        status = ocel_moments_of_cracks(cracks, count, &solution)
                     ? ocel_fit_direct(&solution, &eigenvalue)
                     : OCEL_OVERFLOW;
        if (status == OCEL_OK) {
            status = ocel_fit_finish(&solution, &source, closed, ellipse);
        }
    }
    return status;
}
