/* SPDX-License-Identifier: MIT */
#include <ocellus/fit.h>

#include <stdbool.h>
#include <string.h>

#include "arc.h"
#include "conic.h"
#include "ellipse.h"
#include "hyper.h"
#include "int_math.h"
#include "moments.h"
#include "q60.h"
#include "scatter.h"

/* The paper perturbs "only in the case of not stable numerical solution".  Here
 * that is: the eigenvalue is below 2^-34 of the reduced matrix's trace, so the
 * points are on the conic to about 2^-17 of their spread.  Towards that limit
 * the eigenvalue of the textbook's 6x6 problem drowns in rounding, and its
 * sign, by which the textbook selects, becomes an accident.  Boundaries of
 * pixels are above: their residual, .23 px, is 2^-13 of the widest image. */
#define UNSTABLE_Q60 ((int64_t)1 << 26)

/* An arc under 11/32 of a turn (124 degrees) is vouched for only when the
 * centre is expected within 1/20 of the semi-minor axis. */
#define SHORT_ARC_Q16 (11U * 2048U)
#define VOUCHED_FRACTION 20U

/* Cracks are summed exactly without a shear when the points are not a tilted
 * sliver: the variance of y given x is at least 2^-4 of that of y. */
#define SLIVER_BITS 4U

static ocel_status_t check(bool present, size_t count, const ocel_fit_options_t *options,
                           const ocel_ellipse_t *ellipse) {
    ocel_status_t status = OCEL_OK;

    if ((!present) || (ellipse == NULL)) {
        status = OCEL_NULL_ARGUMENT;
    } else if ((options->method > OCEL_FIT_HYPER) || (options->perturb > OCEL_PERTURB_NEVER)) {
        status = OCEL_BAD_OPTION;
    } else if (count < (size_t)OCEL_MIN_FIT_POINTS) {
        status = OCEL_TOO_FEW_POINTS;
    } else if (count > (size_t)OCEL_MAX_FIT_POINTS) {
        status = OCEL_OVERFLOW;
    } else {
        /* fit */
    }
    return status;
}

/* The fast path: cracks that are no tilted sliver. */
static bool scatter_of_cracks(const ocel_source_t *source, ocel_moments_t *moments,
                              ocel_scatter_t *scatter) {
    bool served = ocel_moments_of_cracks(source->cracks, source->count, moments);

    if (served) {
        served = ocel_scatter_reduce(moments, scatter);
    }
    if (served) {
        const int64_t root = scatter->a_q60[OCEL_S_Y][OCEL_S_Y];

        served = ocel_mul_q60(root, root) >= ocel_asr64(scatter->covariance_yy_q60, SLIVER_BITS);
    }
    return served;
}

/* Moments and reduced scatter matrix of the points as they are. */
static ocel_status_t scatter_of(const ocel_source_t *source, ocel_moments_t *moments,
                                ocel_scatter_t *scatter) {
    ocel_status_t status = OCEL_OK;
    bool served = false;

    if (source->points == NULL) {
        served = scatter_of_cracks(source, moments, scatter);
    }
    if (!served) {
        status = ocel_moments_of_source(source, false, moments);
        if ((status == OCEL_OK) && (!ocel_scatter_reduce(moments, scatter))) {
            status = OCEL_DEGENERATE;
        }
    }
    return status;
}

/* The LCSE step: the same fit on points perturbed in Maini's frame. */
static ocel_status_t perturbed_conic(const ocel_source_t *source, ocel_moments_t *moments,
                                     ocel_scatter_t *scatter, ocel_conic_t *conic) {
    int64_t eigenvalue;
    ocel_status_t status = ocel_moments_of_source(source, true, moments);

    if (status == OCEL_OK) {
        status = ocel_scatter_reduce(moments, scatter)
                     ? ocel_conic_b2ac(scatter, conic, &eigenvalue)
                     : OCEL_DEGENERATE;
    }
    return status;
}

static ocel_status_t direct_conic(const ocel_source_t *source, const ocel_fit_options_t *options,
                                  ocel_moments_t *moments, ocel_scatter_t *scatter,
                                  ocel_conic_t *conic, bool *perturbed) {
    const bool always =
        (options->method == OCEL_FIT_LCSE) && (options->perturb == OCEL_PERTURB_ALWAYS);
    const bool when_unstable =
        (options->method == OCEL_FIT_LCSE) && (options->perturb == OCEL_PERTURB_AUTO);
    int64_t eigenvalue = 0;
    ocel_status_t status = OCEL_OK;

    *perturbed = always;
    if (!always) {
        status = scatter_of(source, moments, scatter);
        if (status == OCEL_OK) {
            status = (options->method == OCEL_FIT_HYPER)
                         ? ocel_conic_hyper(moments, scatter, conic)
                         : ocel_conic_b2ac(scatter, conic, &eigenvalue);
            *perturbed = when_unstable && (eigenvalue < UNSTABLE_Q60);
        }
    }
    if (*perturbed) {
        status = perturbed_conic(source, moments, scatter, conic);
    }
    return status;
}

static bool vouched(const ocel_ellipse_t *ellipse) {
    return (ellipse->arc_coverage_q16 >= SHORT_ARC_Q16) ||
           (ellipse->centre_sigma_px_q16 <= ((uint32_t)ellipse->b_px_q16 / VOUCHED_FRACTION));
}

static ocel_status_t fit(const ocel_source_t *source, const ocel_fit_options_t *options,
                         ocel_ellipse_t *ellipse) {
    ocel_moments_t moments;
    ocel_scatter_t scatter;
    ocel_conic_t conic;
    ocel_status_t status =
        direct_conic(source, options, &moments, &scatter, &conic, &ellipse->perturbed);

    if (status == OCEL_OK) {
        status = ocel_ellipse_of_conic(&conic, &scatter, &moments.frame, ellipse);
    }
    if (status == OCEL_OK) {
        ellipse->method = options->method;
        ellipse->point_count = (uint32_t)source->count;
        ocel_arc_judge(options->closed ? OCEL_ARC_SECTORS
                                       : ocel_arc_sectors(source, &conic, &moments.frame, ellipse),
                       ellipse);
        status = vouched(ellipse) ? OCEL_OK : OCEL_PARTIAL;
    } else {
        (void)memset(ellipse, 0, sizeof(*ellipse));
    }
    return status;
}

static ocel_status_t checked_fit(const ocel_source_t *source, bool present,
                                 const ocel_fit_options_t *options, ocel_ellipse_t *ellipse) {
    static const ocel_fit_options_t defaults = {OCEL_FIT_B2AC, OCEL_PERTURB_AUTO, false};
    const ocel_fit_options_t *const chosen = (options != NULL) ? options : &defaults;
    ocel_status_t status = check(present, source->count, chosen, ellipse);

    if (ellipse != NULL) {
        (void)memset(ellipse, 0, sizeof(*ellipse));
    }
    if (status == OCEL_OK) {
        status = fit(source, chosen, ellipse);
    }
    return status;
}

ocel_status_t ocel_fit_points(const ocel_point_t *points, size_t count,
                              const ocel_fit_options_t *options, ocel_ellipse_t *ellipse) {
    const ocel_source_t source = {points, NULL, count};

    return checked_fit(&source, points != NULL, options, ellipse);
}

ocel_status_t ocel_fit_cracks(const ocel_crack_t *cracks, size_t count,
                              const ocel_fit_options_t *options, ocel_ellipse_t *ellipse) {
    const ocel_source_t source = {NULL, cracks, count};

    return checked_fit(&source, cracks != NULL, options, ellipse);
}
