/* SPDX-License-Identifier: MIT */
#include <ocellus/cone.h>

#include <stdbool.h>
#include <string.h>

#include "../base/int_math.h"
#include "cone_frame.h"
#include "cone_refine.h"
#include "cone_samples.h"
#include "cone_sums.h"
#include "cone_vote.h"

static ocel_status_t check_fit(const ocel_camera_t *camera, bool present, size_t count,
                               const ocel_cone_t *cone) {
    ocel_status_t status = OCEL_OK;

    if ((camera == NULL) || (!present) || (cone == NULL)) {
        status = OCEL_NULL_ARGUMENT;
    } else if (!camera->ready) {
        status = OCEL_BAD_ORDER;
    } else if (count < (size_t)OCEL_MIN_FIT_POINTS) {
        status = OCEL_TOO_FEW_POINTS;
    } else if (count > (size_t)OCEL_MAX_FIT_POINTS) {
        status = OCEL_OVERFLOW;
    } else {
        /* fit */
    }
    return status;
}

static ocel_status_t guess_of(const ocel_cone_source_t *source, ocel_cone_guess_t *guess) {
    ocel_cone_place_t place;
    ocel_status_t status = ocel_cone_place(source, &place);

    if (status == OCEL_OK) {
        ocel_cone_samples_t samples;

        if (!ocel_cone_sample(source, &place, &samples)) {
            status = OCEL_OUT_OF_RANGE;
        } else {
            status = ocel_cone_elect(&samples, &place, guess) ? OCEL_OK : OCEL_DEGENERATE;
        }
    }
    return status;
}

/* Of the source camera and points are set. */
static ocel_status_t fit_cone(ocel_cone_source_t *source, size_t count, ocel_cone_t *cone) {
    const ocel_camera_t *camera = source->camera;
    ocel_status_t status =
        check_fit(camera, (source->points != NULL) || (source->cracks != NULL), count, cone);

    if (cone != NULL) {
        (void)memset(cone, 0, sizeof(*cone));
    }
    if (status == OCEL_OK) {
        ocel_cone_guess_t guess;

        source->count = (uint32_t)count;
        source->f_px_q16 = (int32_t)ocel_asr64(
            (int64_t)camera->intrinsics.fx_px_q16 + camera->intrinsics.fy_px_q16, 1U);
        source->plain = ocel_cone_is_plain(source);
        status = guess_of(source, &guess);
        if (status == OCEL_OK) {
            ocel_cone_sums_t sums;

            if (!ocel_cone_sum(source, &guess, &sums)) {
                status = OCEL_OUT_OF_RANGE;
            } else {
                cone->point_count = source->count;
                status = ocel_cone_refine(&sums, &guess, cone) ? OCEL_OK : OCEL_PARTIAL;
            }
        }
    }
    return status;
}

ocel_status_t ocel_cone_fit_points(const ocel_camera_t *camera, const ocel_point_t *points,
                                   size_t count, ocel_cone_t *cone) {
    ocel_cone_source_t source = {camera, points, NULL, 0U, false, 0};

    return fit_cone(&source, count, cone);
}

ocel_status_t ocel_cone_fit_cracks(const ocel_camera_t *camera, const ocel_crack_t *cracks,
                                   size_t count, ocel_cone_t *cone) {
    ocel_cone_source_t source = {camera, NULL, cracks, 0U, false, 0};

    return fit_cone(&source, count, cone);
}
