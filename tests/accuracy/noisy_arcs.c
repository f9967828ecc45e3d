/* SPDX-License-Identifier: MIT
 *
 * Noisy arcs: RMS error of the centre over the Kanatani-Cramer-Rao bound, which
 * no unbiased estimator beats, for the library's methods and the reference's.
 *
 *   accuracy_noisy_arcs [TABLE.txt [TRIALS [SEED]]]
 */
#include "fit_support.h"
#include "report.h"
#include "rng.h"

enum { MAX_POINTS = 400, OURS = 2, THEIRS = 3, COLUMNS = OURS + THEIRS };

typedef struct {
    double a;
    double b;
    double middle_deg; /* eccentric angle of the middle of the arc */
    double arc_deg;
    size_t count;
    double sigma;
    bool claimed;
} arc_t;

static const arc_t ARCS[] = {
    {40, 40, 0, 120, 100, 0.3, true},   {50, 50, 0, 120, 100, 0.3, true},
    {60, 60, 0, 120, 100, 0.3, true},   {100, 100, 0, 120, 100, 0.3, true},
    {100, 70, 0, 120, 100, 0.3, true},  {100, 70, 45, 120, 100, 0.3, true},
    {100, 70, 90, 120, 100, 0.3, true}, {50, 50, 0, 120, 400, 0.3, true},
    {50, 50, 0, 180, 100, 0.3, true},   {50, 50, 0, 360, 100, 0.3, true},
    {100, 100, 0, 90, 100, 0.3, false},
};

typedef struct {
    double squares;
    double error_x; /* sums, along the arc's bisector */
    double error_y;
    size_t answered;
} column_t;

static void add(column_t *column, const ref_ellipse_t *answer, const ref_ellipse_t *truth) {
    const double dx = answer->cx - truth->cx;
    const double dy = answer->cy - truth->cy;
    column->squares += dx * dx + dy * dy;
    column->error_x += dx;
    column->error_y += dy;
    column->answered++;
}

/* One noisy sample of the arc through every method. */
static void run_trial(const arc_t *arc, const ref_ellipse_t *truth, const double *t, rng_t *rng,
                      column_t *columns) {
    static const ocel_fit_method_t ours[OURS] = {OCEL_FIT_B2AC, OCEL_FIT_HYPER};
    static const ref_method_t theirs[THEIRS] = {REF_B2AC, REF_HYPER_SEMI, REF_HYPER};
    static ref_point_t points[MAX_POINTS];
    static ocel_point_t fixed[MAX_POINTS];
    for (size_t i = 0; i < arc->count; i++) {
        points[i] = ref_ellipse_point(truth, t[i]);
        points[i].x += arc->sigma * rng_gauss(rng);
        points[i].y += arc->sigma * rng_gauss(rng);
    }
    fit_round_points(points, fixed, arc->count);
    for (int k = 0; k < OURS; k++) {
        const ocel_fit_options_t options = fit_options(ours[k], OCEL_PERTURB_AUTO);
        ocel_ellipse_t answer;
        if (fit_has_ellipse(ocel_fit_points(fixed, arc->count, &options, &answer))) {
            const ref_ellipse_t e = fit_to_double(&answer);
            add(&columns[k], &e, truth);
        }
    }
    for (int k = 0; k < THEIRS; k++) {
        ref_ellipse_t e;
        if (ref_fit(theirs[k], points, arc->count, &e)) {
            add(&columns[OURS + k], &e, truth);
        }
    }
}

static double run_arc(report_t *report, const arc_t *arc, size_t trials, rng_t *rng) {
    double t[MAX_POINTS];
    column_t columns[COLUMNS] = {{0.0, 0.0, 0.0, 0}};
    /* The frame turns with the trial's angle, so no direction is favoured. */
    ref_ellipse_t truth = {160.0, 120.0, arc->a, arc->b, 0.0};
    const double middle = arc->middle_deg * FIT_PI / 180.0;
    const double span = arc->arc_deg * FIT_PI / 180.0;
    const double steps = (arc->arc_deg < 360.0) ? (double)(arc->count - 1U) : (double)arc->count;
    for (size_t i = 0; i < arc->count; i++) {
        t[i] = middle + span * ((double)i / steps - 0.5);
    }
    const double bound = ref_kcr_centre(&truth, t, arc->count, arc->sigma);
    for (size_t trial = 0; trial < trials; trial++) {
        truth.angle = rng_uniform(rng, 0.0, FIT_PI);
        run_trial(arc, &truth, t, rng, columns);
    }
    report_line(report, "%3.0f x %3.0f %4.0f %4.0f %4zu %.1f %7.3f |", arc->a, arc->b,
                arc->middle_deg, arc->arc_deg, arc->count, arc->sigma, bound);
    double hyper = 0.0;
    for (int k = 0; k < COLUMNS; k++) {
        const column_t *c = &columns[k];
        const double ratio = sqrt(c->squares / (double)c->answered) / bound;
        report_line(report, " %6.3f", ratio);
        if (c->answered < trials) {
            report_line(report, " (%zu)", trials - c->answered);
        }
        hyper = (k == 1) ? ((c->answered < trials) ? INFINITY : ratio) : hyper;
    }
    report_line(report, "%s\n", arc->claimed ? "" : "   (no claim)");
    return arc->claimed ? hyper : 0.0;
}

int main(int argc, char **argv) {
    report_t report = report_open(argc, argv);
    const size_t trials = (argc > 2) ? strtoul(argv[2], NULL, 10) : 4000UL;
    const unsigned long long seed = (argc > 3) ? strtoull(argv[3], NULL, 10) : 2011ULL;
    rng_t rng = rng_seed(seed);
    double worst = 0.0;
    report_line(
        &report,
        "Noisy arcs: RMS error of the centre / Kanatani-Cramer-Rao bound; %zu trials each,\n"
        "seed %llu.  Standard error of a ratio: about %.3f.  In brackets: trials without an\n"
        "ellipse.  middle: eccentric angle of the arc's middle.\n\n",
        trials, seed, 1.0 / sqrt(2.0 * (double)trials));
    report_line(&report,
                "                                         | library        | long double\n"
                "semi-axes middle arc    n  sig  KCR px |   b2ac  hyper |   b2ac   semi   full\n");
    for (size_t i = 0; i < sizeof(ARCS) / sizeof(ARCS[0]); i++) {
        worst = fmax(worst, run_arc(&report, &ARCS[i], trials, &rng));
    }
    report_line(&report, "\n");
    report_claim(&report, "worst hyper RMS / KCR", worst, 1.10);
    return report_close(&report);
}
