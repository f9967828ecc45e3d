/* SPDX-License-Identifier: MIT */
#include <ocellus/fit.h>

#include <stdbool.h>
#include <string.h>

#include "fit_finish.h"
#include "hyper.h"
#include "moments.h"

/* The paper perturbs "only in the case of not stable numerical solution".  Here
 * that is: the eigenvalue is below 2^-34 of the reduced matrix's trace, so the
 * points are on the conic to about 2^-17 of their spread.  Towards that limit
 * the eigenvalue of the textbook's 6x6 problem drowns in rounding, and its
 * sign, by which the textbook selects, becomes an accident.  Boundaries of
 * pixels are above: their residual, .23 px, is 2^-13 of the widest image. */
#define UNSTABLE_Q60 ((int64_t)0x4000000)

/* The second opinion on a short arc.  Under 11/32 of a turn (124 degrees) the
 * unbiased fit's centre must be expected within 1/20 of its semi-minor axis; the
 * two centres must agree within twice that.  (test_fit.c prints how many noisy
 * arcs pass, and how many of them are wrong.) */
#define SHORT_ARC_Q16 (11U * 2048U)
#define VOUCHED_FRACTION 20U

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

/* Moments of the points as they are: by exact sums where those fit. */
static ocel_status_t moments_of(const ocel_source_t *source, ocel_solution_t *solution) {
    ocel_status_t status = OCEL_OK;
    bool exact = false;

    if (source->points == NULL) {
        exact = ocel_moments_of_cracks(source->cracks, source->count, solution);
    }
    if (!exact) {
        /* Not in the eye, unless it is large: there the squares sum to less than 2^31. */
        /* at most: 2 in a call of ocel_fit_points or ocel_fit_cracks;
         * 2 * ((OCEL_MAX_CRACKS * (OCEL_MAX_WIDTH * OCEL_MAX_WIDTH +
         * OCEL_MAX_HEIGHT * OCEL_MAX_HEIGHT)) / 536870912) in a call of ocel_eye_refit */
        status = ocel_moments_of_source(source, false, solution);
    }
    return status;
}

/* B2AC, and when `auto_perturb` whether its solution is unstable. */
static ocel_status_t direct(const ocel_source_t *source, bool auto_perturb,
                            ocel_solution_t *solution, bool *unstable) {
    int64_t eigenvalue = 0;
    ocel_status_t status = moments_of(source, solution);

    if (status == OCEL_OK) {
        status = ocel_fit_direct(solution, &eigenvalue);
        *unstable = auto_perturb && (eigenvalue < UNSTABLE_Q60);
    }
    return status;
}

/* The LCSE step: the same fit on points perturbed in Maini's frame. */
static ocel_status_t perturbed(const ocel_source_t *source, ocel_solution_t *solution) {
    int64_t eigenvalue;
    ocel_status_t status = ocel_moments_of_source(source, true, solution);

    if (status == OCEL_OK) {
        status = ocel_fit_direct(solution, &eigenvalue);
    }
    return status;
}

static ocel_status_t hyper(const ocel_source_t *source, ocel_solution_t *solution) {
    ocel_status_t status = moments_of(source, solution);

    if (status == OCEL_OK) {
        status = ocel_conic_hyper(solution);
    }
    return status;
}

static ocel_status_t fit(const ocel_source_t *source, const ocel_fit_options_t *options,
                         ocel_ellipse_t *ellipse) {
    const bool lcse = options->method == OCEL_FIT_LCSE;
    bool perturb = lcse && (options->perturb == OCEL_PERTURB_ALWAYS);
    ocel_status_t status = OCEL_OK;
    ocel_solution_t solution;

    if (options->method == OCEL_FIT_HYPER) {
        status = hyper(source, &solution);
    } else if (!perturb) {
        status =
            direct(source, lcse && (options->perturb == OCEL_PERTURB_AUTO), &solution, &perturb);
    } else {
        /* always */
    }
    if (perturb) {
        /* The second opinion perturbs nothing. */
        /* at most: 1 in a call of ocel_fit_points or ocel_fit_cracks or ocel_eye_refit */
        status = perturbed(source, &solution);
    }
    if (status == OCEL_OK) {
        status = ocel_fit_finish(&solution, source, options->closed, ellipse);
    }
    if ((status == OCEL_OK) || (status == OCEL_PARTIAL)) {
        ellipse->method = options->method;
        ellipse->perturbed = perturb;
    }
    return status;
}

/* Whether two centres are within a tolerance that is below 2^31. */
static bool near(const ocel_ellipse_t *one, const ocel_ellipse_t *other, uint32_t tolerance_q16) {
    const int64_t dx = (int64_t)one->cx_px_q16 - other->cx_px_q16;
    const int64_t dy = (int64_t)one->cy_px_q16 - other->cy_px_q16;
    const int64_t limit = tolerance_q16;
    bool is_near = (dx <= limit) && (dx >= -limit) && (dy <= limit) && (dy >= -limit);

    if (is_near) {
        is_near = ((dx * dx) + (dy * dy)) <= (limit * limit);
    }
    return is_near;
}

/* A short arc is vouched for when the fit with the bias and the one without
 * agree: on such arcs B2AC flattens the ellipse until its own arc looks long,
 * and hyper scatters.  `ellipse` is the one, the other is made here. */
static bool second_opinion(const ocel_source_t *source, const ocel_ellipse_t *ellipse) {
    const bool is_hyper = ellipse->method == OCEL_FIT_HYPER;
    const ocel_fit_options_t options = {is_hyper ? OCEL_FIT_B2AC : OCEL_FIT_HYPER,
                                        OCEL_PERTURB_NEVER, false};
    ocel_ellipse_t other = {0};
    const ocel_status_t status = fit(source, &options, &other);
    const ocel_ellipse_t *const unbiased = is_hyper ? ellipse : &other;
    const uint32_t allowed = (uint32_t)unbiased->b_px_q16 / VOUCHED_FRACTION;
    const uint32_t sigma = unbiased->centre_sigma_px_q16;
    bool agreed = false;

    if (((status == OCEL_OK) || (status == OCEL_PARTIAL)) &&
        ((unbiased->arc_coverage_q16 >= SHORT_ARC_Q16) || (sigma <= allowed))) {
        agreed = near(ellipse, &other, 2U * allowed);
    }
    return agreed;
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
        if ((status == OCEL_PARTIAL) && (!chosen->closed) && second_opinion(source, ellipse)) {
            status = OCEL_OK;
        }
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
