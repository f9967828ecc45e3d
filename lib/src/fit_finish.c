/* SPDX-License-Identifier: MIT */
#include "fit_finish.h"

#include <string.h>

#include "arc.h"
#include "ellipse.h"

/* An arc under 11/32 of a turn (124 degrees) is vouched for only when the
 * centre is expected within 1/20 of the semi-minor axis. */
#define SHORT_ARC_Q16 (11U * 2048U)
#define VOUCHED_FRACTION 20U

static bool vouched(const ocel_ellipse_t *ellipse) {
    return (ellipse->arc_coverage_q16 >= SHORT_ARC_Q16) ||
           (ellipse->centre_sigma_px_q16 <= ((uint32_t)ellipse->b_px_q16 / VOUCHED_FRACTION));
}

ocel_status_t ocel_fit_finish(const ocel_solution_t *solution, const ocel_source_t *source,
                              bool closed, ocel_ellipse_t *ellipse) {
    ocel_status_t status =
        ocel_ellipse_of_conic(&solution->conic, &solution->spread, &solution->frame, ellipse);

    if (status == OCEL_OK) {
        uint32_t sectors = OCEL_ARC_SECTORS;

        ellipse->point_count = (uint32_t)source->count;
        if (!closed) {
            sectors = ocel_arc_sectors(source, &solution->conic, &solution->frame, ellipse);
        }
        ocel_arc_judge(sectors, ellipse);
        status = vouched(ellipse) ? OCEL_OK : OCEL_PARTIAL;
    } else {
        (void)memset(ellipse, 0, sizeof(*ellipse));
    }
    return status;
}

ocel_status_t ocel_fit_direct(const ocel_moments_t *moments, ocel_solution_t *solution,
                              int64_t *eigenvalue_q60) {
    ocel_status_t status = OCEL_DEGENERATE;
    ocel_scatter_t scatter;

    *eigenvalue_q60 = 0;
    solution->frame = moments->frame;
    if (ocel_scatter_reduce(moments, &scatter, &solution->spread)) {
        status = ocel_conic_b2ac(&scatter, &solution->conic, eigenvalue_q60);
    }
    return status;
}
