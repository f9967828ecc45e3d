/* SPDX-License-Identifier: MIT
 *
 * Points exactly on an ellipse, rounded to the input format, over a seeded
 * hundred thousand ellipses and arcs: does the fit always answer, and how far
 * is it from the long double reference on the same rounded points?
 *
 *   accuracy_exact_arcs [TABLE.txt [CASES [SEED]]]
 */
#include "fit_support.h"
#include "report.h"
#include "rng.h"

enum { MIN_POINTS = 20, MAX_POINTS = 500, BINS = 5 };

static const double BIN_FROM_DEG[BINS + 1] = {60.0, 90.0, 120.0, 180.0, 270.0, 360.0};

typedef struct {
    ref_ellipse_t ellipse;
    double first; /* eccentric angle of the first point */
    double arc_deg;
    size_t count;
} case_t;

typedef struct {
    double *centre;  /* against the reference, px */
    double *axes;    /* the larger of both semi-axes' errors, px */
    size_t answered; /* cases with an ellipse on both sides */
    size_t cases;
    size_t not_ok;
    size_t strict_failed;
    size_t reference_failed;
    double to_truth; /* worst centre error against the unrounded ellipse, ours */
    case_t worst;
    double worst_error;
} bin_t;

static case_t draw_case(rng_t *rng) {
    case_t c;
    const double p = rng_log_uniform(rng, 5.0, 200.0);
    const double q = rng_log_uniform(rng, 5.0, 200.0);
    c.ellipse.a = fmax(p, q);
    c.ellipse.b = fmin(p, q);
    c.ellipse.cx = rng_uniform(rng, 0.0, 639.0);
    c.ellipse.cy = rng_uniform(rng, 0.0, 479.0);
    c.ellipse.angle = rng_uniform(rng, 0.0, FIT_PI);
    c.first = rng_uniform(rng, 0.0, 2.0 * FIT_PI);
    c.arc_deg = rng_uniform(rng, 60.0, 360.0);
    c.count = (size_t)rng_between(rng, MIN_POINTS, MAX_POINTS);
    return c;
}

/* Equal steps of the eccentric angle. */
static void place_points(const case_t *c, ref_point_t *points) {
    const double step = c->arc_deg * FIT_PI / 180.0 / (double)c->count;
    for (size_t i = 0; i < c->count; i++) {
        points[i] = ref_ellipse_point(&c->ellipse, c->first + step * (double)i);
    }
}

static bin_t *bin_of(bin_t *bins, double arc_deg) {
    int at = 0;
    while ((at < BINS - 1) && (arc_deg >= BIN_FROM_DEG[at + 1])) {
        at++;
    }
    return &bins[at];
}

static void run_case(const case_t *c, bin_t *bin) {
    static ref_point_t points[MAX_POINTS];
    static ocel_point_t fixed[MAX_POINTS];
    const ocel_fit_options_t options = fit_options(OCEL_FIT_B2AC, OCEL_PERTURB_AUTO);
    ocel_ellipse_t answer;
    ref_ellipse_t reference;
    ref_ellipse_t strict;
    place_points(c, points);
    bin->strict_failed += ref_fit_b2ac_strict(points, c->count, &strict) ? 0U : 1U;
    fit_round_points(points, fixed, c->count);
    const ocel_status_t status = ocel_fit_points(fixed, c->count, &options, &answer);
    const bool has_reference = ref_fit(REF_B2AC, points, c->count, &reference);
    bin->cases++;
    bin->not_ok += (status == OCEL_OK) ? 0U : 1U;
    bin->reference_failed += has_reference ? 0U : 1U;
    if (fit_has_ellipse(status) && has_reference) {
        const ref_ellipse_t ours = fit_to_double(&answer);
        const double centre = fit_centre_distance(&ours, &reference);
        const double axes = fit_axes_distance(&ours, &reference);
        bin->centre[bin->answered] = centre;
        bin->axes[bin->answered] = axes;
        bin->answered++;
        bin->to_truth = fmax(bin->to_truth, fit_centre_distance(&ours, &c->ellipse));
        if (fmax(centre, axes) > bin->worst_error) {
            bin->worst_error = fmax(centre, axes);
            bin->worst = *c;
        }
    }
}

static void print_bin(report_t *report, int b, bin_t *bin) {
    report_line(report, "%3.0f-%3.0f %7zu %6zu %6.1f%% |", BIN_FROM_DEG[b], BIN_FROM_DEG[b + 1],
                bin->cases, bin->not_ok, 100.0 * (double)bin->strict_failed / (double)bin->cases);
    double *const both[2] = {bin->centre, bin->axes};
    for (int k = 0; k < 2; k++) {
        report_line(report, " %.1e %.1e %.1e %.1e |",
                    report_percentile(both[k], bin->answered, 0.50),
                    report_percentile(both[k], bin->answered, 0.99),
                    report_percentile(both[k], bin->answered, 0.999),
                    report_percentile(both[k], bin->answered, 1.0));
    }
    report_line(report, " %.1e | a %.1f b %.1f n %zu arc %.1f\n", bin->to_truth,
                bin->worst.ellipse.a, bin->worst.ellipse.b, bin->worst.count, bin->worst.arc_deg);
}

int main(int argc, char **argv) {
    report_t report = report_open(argc, argv);
    const size_t cases = (argc > 2) ? strtoul(argv[2], NULL, 10) : 100000UL;
    const unsigned long long seed = (argc > 3) ? strtoull(argv[3], NULL, 10) : 20100517ULL;
    bin_t bins[BINS] = {{0}};
    rng_t rng = rng_seed(seed);
    for (int b = 0; b < BINS; b++) {
        bins[b].centre = calloc(cases, sizeof(double));
        bins[b].axes = calloc(cases, sizeof(double));
        if ((bins[b].centre == NULL) || (bins[b].axes == NULL)) {
            return 2;
        }
    }
    for (size_t i = 0; i < cases; i++) {
        const case_t c = draw_case(&rng);
        run_case(&c, bin_of(bins, c.arc_deg));
    }
    report_line(
        &report,
        "Exact points on ellipses, semi-axes 5..200 px each, n 20..500, rounded to Q16;\n"
        "%zu cases, seed %llu.  Error in px against the long double reference on the same\n"
        "rounded points: median, 99 %%, 99.9 %%, worst.  strict: the textbook's 6x6 B2AC in\n"
        "double finds no ellipse, on the points before rounding.\n\n",
        cases, seed);
    report_line(&report, "arc deg   cases not ok  strict | centre p50    p99   p99.9     max | "
                         "axes p50      p99   p99.9     max | to truth | worst case\n");
    double wide = 0.0;
    double medium = 0.0;
    size_t not_ok = 0;
    for (int b = 0; b < BINS; b++) {
        print_bin(&report, b, &bins[b]);
        not_ok += bins[b].not_ok + bins[b].reference_failed;
        if (BIN_FROM_DEG[b] >= 180.0) {
            wide = fmax(wide, bins[b].worst_error);
        } else if (BIN_FROM_DEG[b] >= 90.0) {
            medium = fmax(medium, bins[b].worst_error);
        }
        free(bins[b].centre);
        free(bins[b].axes);
    }
    report_line(&report, "\n");
    report_claim(&report, "cases without status ok", (double)not_ok, 0.0);
    report_claim(&report, "worst error of centre and semi-axes, arcs >= 180 deg, px", wide, 1e-4);
    report_claim(&report, "worst error of centre and semi-axes, arcs >= 90 deg, px", medium, 0.01);
    return report_close(&report);
}
