/* SPDX-License-Identifier: MIT
 *
 * A ball of 40 px radius of which a straight edge hides a part: radius and centre of the
 * outline, by the library's cone of rays, by ellipse fits of the whole visible boundary,
 * and by the paper's chain.  The oracle is the cone through the ball's own cracks, those
 * that the edge did not make.
 *
 *   accuracy_ball_occlusion [TABLE.txt [TRIALS [SEED]]]
 */
#include "ball_scene.h"
#include "ball_twin.h"
#include "fit_support.h"
#include "report.h"

enum { PAPER = 0, B2AC, LCSE, HYPER, ORACLE, TWIN, CONE, METHODS, SHARES = 6, PLACES = 2 };

static const char *const NAMES[METHODS] = {
    "paper: inner pixels", "b2ac", "lcse", "hyper", "oracle", "cone in double", "cone of rays"};
static const double SHARE[SHARES] = {0.05, 0.1, 0.2, 0.3, 0.4, 0.5};
static const char *const PLACE[PLACES] = {"within half a pixel of the axis",
                                          "anywhere in the image"};
static const double RADIUS_PX = 40.0;

/* The radius that is asked for: RMS and worst, %. */
static const double RMS_ASKED = 0.20;
static const double WORST = 0.5;

typedef struct {
    double centre; /* sums of squares: px */
    double radius; /* per cent */
    double worst;  /* of the radius */
    size_t answered;
    size_t not_ok;
    double apart; /* of the cone: its radius from the double's, per cent, sum of squares */
    double same;  /* of that, where as many cracks consented */
} cell_t;

static uint8_t mask[SCENE_PIXELS];
static ocel_eye_t eye;
static ocel_camera_t camera;

static void add(cell_t *cell, const ref_ellipse_t *e, const ref_ellipse_t *truth) {
    const double off = 100.0 * (sqrt((e->a * e->b) / (truth->a * truth->b)) - 1.0);
    const double centre = fit_centre_distance(e, truth);
    cell->centre += centre * centre;
    cell->radius += off * off;
    cell->worst = fmax(cell->worst, fabs(off));
    cell->answered++;
}

/* Its outline, when vouched for. */
static bool add_cone(cell_t *cell, ocel_status_t status, const ocel_cone_t *cone,
                     const ref_ellipse_t *truth, ref_ellipse_t *e) {
    ocel_ellipse_t outline;
    const bool ok = (status == OCEL_OK) && (ocel_cone_outline(&camera, cone, &outline) == OCEL_OK);
    if (ok) {
        *e = fit_to_double(&outline);
        add(cell, e, truth);
    } else {
        cell->not_ok++;
    }
    return ok;
}

/* The cone of the cracks that are the ball's: those clear of the edge. */
static void add_oracle(cell_t *cell, const scene_t *scene, const ocel_crack_t *cracks, size_t count,
                       const ref_ellipse_t *truth) {
    static ocel_crack_t own[OCEL_MAX_CRACKS];
    const scene_edge_t *edge = &scene->edge[0];
    size_t owned = 0;
    ocel_cone_t cone;
    ref_ellipse_t e;
    for (size_t i = 0; i < count; i++) {
        const double along = 0.5 * (edge->nx * cracks[i].x_hpx + edge->ny * cracks[i].y_hpx);
        if (along < edge->offset - 1.0) {
            own[owned] = cracks[i];
            owned++;
        }
    }
    const ocel_status_t status = ocel_cone_fit_cracks(&camera, own, owned, &cone);
    (void)add_cone(cell, (status == OCEL_PARTIAL) ? OCEL_OK : status, &cone, truth, &e);
}

static void run_trial(double share, bool anywhere, rng_t *rng, cell_t *cells) {
    static const ocel_fit_method_t methods[3] = {OCEL_FIT_B2AC, OCEL_FIT_LCSE, OCEL_FIT_HYPER};
    scene_t scene;
    ocel_detection_t detection;
    ocel_detection_t refitted;
    ref_ellipse_t e;
    ocel_cone_t cone;
    scene_ball_t ball;
    double p_mm[3];
    size_t count = 0;
    size_t inliers = 0;
    scene_occluded(&scene, RADIUS_PX, share, anywhere, rng);
    const ref_ellipse_t truth = scene_outline(&scene.ball);
    scene_draw(&scene, rng, mask);
    if (scene_paper(mask, &e, p_mm)) {
        add(&cells[PAPER], &e, &truth);
    }
    (void)scene_look(mask, &eye, &detection);
    for (int m = 0; m < 3; m++) {
        const ocel_fit_options_t options = fit_options(methods[m], OCEL_PERTURB_AUTO);
        refitted = detection;
        if (fit_has_ellipse(ocel_eye_refit(&eye, &options, &refitted))) {
            e = fit_to_double(&refitted.ellipse);
            add(&cells[B2AC + m], &e, &truth);
        }
    }
    const ocel_crack_t *cracks = ocel_eye_boundary(&eye, &count);
    add_oracle(&cells[ORACLE], &scene, cracks, count, &truth);
    const ocel_status_t status = ocel_eye_cone(&eye, &camera, &detection, &cone);
    const bool ok = add_cone(&cells[CONE], status, &cone, &truth, &e);
    if (scene_twin(cracks, count, &ball, &inliers)) {
        const ref_ellipse_t twin = scene_outline(&ball);
        add(&cells[TWIN], &twin, &truth);
        if (ok) {
            const double apart = 100.0 * (sqrt((e.a * e.b) / (twin.a * twin.b)) - 1.0);
            cells[CONE].apart += apart * apart;
            cells[CONE].same += (cone.inlier_count == inliers) ? apart * apart : 0.0;
        }
    }
}

static double rms(double squares, const cell_t *cell) {
    return sqrt(squares / (double)cell->answered);
}

static void print_place(report_t *report, const char *place, cell_t cells[SHARES][METHODS]) {
    report_line(report, "The ball %s:\n%-20s", place, "hidden");
    for (int s = 0; s < SHARES; s++) {
        report_line(report, " | %13.0f %%", 100.0 * SHARE[s]);
    }
    report_line(report, "\n");
    for (int m = 0; m < METHODS; m++) {
        report_line(report, "%-20s", NAMES[m]);
        for (int s = 0; s < SHARES; s++) {
            const cell_t *c = &cells[s][m];
            report_line(report, " | %5.*f %5.*f %3.*f", (m < ORACLE) ? 2 : 3, rms(c->radius, c),
                        (m < ORACLE) ? 2 : 3, rms(c->centre, c), (m < ORACLE) ? 0 : 1, c->worst);
        }
        report_line(report, "\n");
    }
    report_line(report, "\n");
}

static void claim(report_t *report, const char *place, cell_t cells[SHARES][METHODS]) {
    double centre = 0.0;
    double radius = 0.0;
    double worst = 0.0;
    double squares = 0.0;
    double apart = 0.0;
    double same = 0.0;
    double ratio = 0.0;
    size_t not_ok = 0;
    for (int s = 0; s < SHARES; s++) {
        const cell_t *c = &cells[s][CONE];
        const cell_t *twin = &cells[s][TWIN];
        centre = fmax(centre, rms(c->centre, c));
        radius = fmax(radius, rms(c->radius, c));
        worst = fmax(worst, c->worst);
        squares += c->radius;
        apart += c->apart;
        same += c->same;
        ratio = fmax(ratio, rms(c->radius, c) / rms(twin->radius, twin));
        not_ok += c->not_ok;
    }
    report_line(report, "The ball %s:\n", place);
    report_claim(report, "radius RMS, worst share, %", radius, RMS_ASKED);
    report_claim(report, "radius, worst of all, %", worst, WORST);
    report_claim(report, "centre RMS, worst share, px", centre, 0.10);
    report_claim(report, "radius RMS in fixed point over double's, worst", ratio, 1.02);
    report_claim(report, "radius, fixed point from double, the same cracks, share of the error",
                 sqrt(same / squares), 0.02);
    report_line(report,
                "the same of all masks, a sample or crack on a gate's very edge or not: %.4f\n",
                sqrt(apart / squares));
    report_claim(report, "masks without status ok", (double)not_ok, 0.0);
}

int main(int argc, char **argv) {
    report_t report = report_open(argc, argv);
    const size_t trials = (argc > 2) ? strtoul(argv[2], NULL, 10) : 500UL;
    const unsigned long long seed = (argc > 3) ? strtoull(argv[3], NULL, 10) : 1998ULL;
    rng_t rng = rng_seed(seed);
    static cell_t cells[PLACES][SHARES][METHODS];
    scene_camera(&camera);
    report_line(
        &report,
        "A ball of 40 px radius, an edge at any angle hiding a share of its area, sub-pixel\n"
        "places; %zu trials each, seed %llu: RMS error of the radius, %%, of the centre, px, and\n"
        "the worst of the radius, %%.\n\n",
        trials, seed);
    for (int p = 0; p < PLACES; p++) {
        for (int s = 0; s < SHARES; s++) {
            for (size_t trial = 0; trial < trials; trial++) {
                run_trial(SHARE[s], p != 0, &rng, cells[p][s]);
            }
        }
        print_place(&report, PLACE[p], cells[p]);
    }
    for (int p = 0; p < PLACES; p++) {
        claim(&report, PLACE[p], cells[p]);
    }
    return report_close(&report);
}
