/* SPDX-License-Identifier: MIT */
#include "fit_finish.h"

#include <string.h>

#include "../base/q60.h"
#include "arc.h"
#include "conic.h"
#include "ellipse.h"
#include "scatter.h"

/* From 27/32 of a turn (304 degrees) on an arc is vouched for without a second
 * opinion.  Below, B2AC's bias can make a short arc look as long as it says. */
#define TRUSTED_ARC_Q16 (27U * 2048U)

/* What a whole boundary of pixels may miss its ellipse by and be vouched for: half a
 * pixel (cracks of a clean disc: .24) and 1/64 of the semi-minor axis.  An edge with
 * noise of .5 px has .5 px; a disc of which an occluder hides 5 % has 1/28 of its
 * radius, 10 % 1/19. */
#define SHAPE_RMS_PX_Q16 32768U
#define SHAPE_RMS_SHIFT 6U

static bool is_trusted(const ocel_ellipse_t *ellipse, bool closed) {
    const uint32_t shape_rms = SHAPE_RMS_PX_Q16 + ((uint32_t)ellipse->b_px_q16 >> SHAPE_RMS_SHIFT);

    return closed ? (ellipse->rms_px_q16 <= shape_rms)
                  : (ellipse->arc_coverage_q16 >= TRUSTED_ARC_Q16);
}

ocel_status_t ocel_fit_finish(ocel_solution_t *solution, const ocel_source_t *source, bool closed,
                              ocel_ellipse_t *ellipse) {
    int64_t *const r = solution->q60;
    ocel_status_t status;

    r[OCEL_F_FORM_XX] = OCEL_Q60_ONE + r[OCEL_F_V];
    r[OCEL_F_FORM_YY] = OCEL_Q60_ONE - r[OCEL_F_V];
    status = ocel_ellipse_of_conic(r, ellipse);
    if (status == OCEL_OK) {
        uint32_t sectors = OCEL_SECTORS;

        ellipse->point_count = (uint32_t)source->count;
        if (!closed) {
            sectors = ocel_arc_sectors(source, r, ellipse);
        }
        ocel_arc_judge(sectors, ellipse);
        status = is_trusted(ellipse, closed) ? OCEL_OK : OCEL_PARTIAL;
    } else {
        (void)memset(ellipse, 0, sizeof(*ellipse));
    }
    return status;
}

ocel_status_t ocel_fit_direct(ocel_solution_t *solution, int64_t *eigenvalue_q60) {
    ocel_status_t status = OCEL_DEGENERATE;
    ocel_scatter_t scatter;

    *eigenvalue_q60 = 0;
    if (ocel_scatter_reduce(solution, &scatter)) {
        status = ocel_conic_b2ac(&scatter, solution, eigenvalue_q60);
    }
    return status;
}
