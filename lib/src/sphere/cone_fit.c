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

/* What a cone must show to be vouched for (cone.h tells it in words; DESIGN.md what
 * it was tried on). */
#define INLIERS_MIN_OF 2U      /* more than one of 2 points consents */
#define OUTSIDE_MAX_OF 25U     /* one of 25 points is outside */
#define SECTORS_MIN 8U         /* a quarter of the turn is seen */
#define RMS_PX_Q16 9830U       /* .15 px, */
#define RMS_SECTOR_PX_Q16 721U /* and .011 px for each sector seen */

/* .01^2 in Q60: the range is expected within 1 %. */
#define RANGE_SIGMA2_MAX_Q60 ((int64_t)115292150460685)

static bool is_vouched(const ocel_cone_t *cone, const ocel_cone_evidence_t *evidence) {
    return ((cone->inlier_count * INLIERS_MIN_OF) > cone->point_count) &&
           ((evidence->outside * OUTSIDE_MAX_OF) <= cone->point_count) &&
           (evidence->sectors >= SECTORS_MIN) && (!evidence->bent) &&
           (evidence->range_sigma2_q60 <= RANGE_SIGMA2_MAX_Q60) &&
           (cone->rms_px_q16 <= (RMS_PX_Q16 + (RMS_SECTOR_PX_Q16 * evidence->sectors)));
}

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

static ocel_status_t fit_cone(const ocel_camera_t *camera, const ocel_point_t *points,
                              const ocel_crack_t *cracks, size_t count, ocel_cone_t *cone) {
    ocel_status_t status = check_fit(camera, (points != NULL) || (cracks != NULL), count, cone);

    if (cone != NULL) {
        (void)memset(cone, 0, sizeof(*cone));
    }
    if (status == OCEL_OK) {
        ocel_cone_source_t source = {camera,
                                     points,
                                     cracks,
                                     (uint32_t)count,
                                     false,
                                     (int32_t)ocel_asr64((int64_t)camera->intrinsics.fx_px_q16 +
                                                             camera->intrinsics.fy_px_q16,
                                                         1U)};
        ocel_cone_guess_t guess;

        source.plain = ocel_cone_is_plain(&source);
        status = guess_of(&source, &guess);
        if (status == OCEL_OK) {
            ocel_cone_sums_t sums;
            ocel_cone_evidence_t evidence;

            if (!ocel_cone_sum(&source, &guess, &sums)) {
                status = OCEL_OUT_OF_RANGE;
            } else {
                ocel_cone_refine(&sums, &guess, cone, &evidence);
                cone->point_count = source.count;
                status = is_vouched(cone, &evidence) ? OCEL_OK : OCEL_PARTIAL;
            }
        }
    }
    return status;
}

ocel_status_t ocel_cone_fit_points(const ocel_camera_t *camera, const ocel_point_t *points,
                                   size_t count, ocel_cone_t *cone) {
    return fit_cone(camera, points, NULL, count, cone);
}

ocel_status_t ocel_cone_fit_cracks(const ocel_camera_t *camera, const ocel_crack_t *cracks,
                                   size_t count, ocel_cone_t *cone) {
    return fit_cone(camera, NULL, cracks, count, cone);
}
