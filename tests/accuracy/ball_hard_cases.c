/* SPDX-License-Identifier: MIT
 *
 * What goes wrong on a robot's table: two occluders, round ones, the image's edge, a
 * second ball touching, noise, a covered camera, things that are no balls.  Per case how
 * often each status came and how far the answers were off; never `ok` with an error of
 * more than 5 % of the range.
 *
 *   accuracy_ball_hard_cases [TABLE.txt [TRIALS [SEED]]]
 */
#include "ball_scene.h"
#include "report.h"

typedef enum {
    WHOLE = 0,
    ONE_EDGE,  /* a straight edge hides `share` */
    TWO_EDGES, /* each hides `share` */
    DISC,      /* a disc of `size` times the outline's radius hides `share` */
    BORDER,    /* `share` of it is outside the image */
    TOUCHING,  /* another ball, its outline `size` times as large */
    EDGE_NOISE,
    SALT,
    /* Nothing to be vouched for from here on. */
    WHOLLY_HIDDEN,
    COVERED_DARK,
    COVERED_BRIGHT,
    SQUARE,
    THIN_RECTANGLE,
    L_SHAPE,
    TRIANGLE,
    LONG_ELLIPSE,
    KINDS
} kind_t;

typedef struct {
    const char *name;
    kind_t kind;
    double size; /* or the noise: px, share */
    double share;
} case_t;

static const case_t CASES[] = {
    {"whole", WHOLE, 0.0, 0.0},
    {"straight edge 20 %", ONE_EDGE, 0.0, 0.2},
    {"straight edge 50 %", ONE_EDGE, 0.0, 0.5},
    {"straight edge 60 %", ONE_EDGE, 0.0, 0.6},
    {"straight edge 70 %", ONE_EDGE, 0.0, 0.7},
    {"straight edge 80 %", ONE_EDGE, 0.0, 0.8},
    {"straight edge 90 %", ONE_EDGE, 0.0, 0.9},
    {"two edges, each 10 %", TWO_EDGES, 0.0, 0.1},
    {"two edges, each 20 %", TWO_EDGES, 0.0, 0.2},
    {"two edges, each 30 %", TWO_EDGES, 0.0, 0.3},
    {"disc 0.5 R, 10 %", DISC, 0.5, 0.1},
    {"disc 0.5 R, 20 %", DISC, 0.5, 0.2},
    {"disc 1 R, 10 %", DISC, 1.0, 0.1},
    {"disc 1 R, 30 %", DISC, 1.0, 0.3},
    {"disc 1 R, 50 %", DISC, 1.0, 0.5},
    {"disc 1 R, 60 %", DISC, 1.0, 0.6},
    {"disc 2 R, 10 %", DISC, 2.0, 0.1},
    {"disc 2 R, 30 %", DISC, 2.0, 0.3},
    {"disc 2 R, 50 %", DISC, 2.0, 0.5},
    {"disc 2 R, 60 %", DISC, 2.0, 0.6},
    {"image's edge 10 %", BORDER, 0.0, 0.1},
    {"image's edge 20 %", BORDER, 0.0, 0.2},
    {"image's edge 30 %", BORDER, 0.0, 0.3},
    {"image's edge 40 %", BORDER, 0.0, 0.4},
    {"image's edge 50 %", BORDER, 0.0, 0.5},
    {"image's edge 60 %", BORDER, 0.0, 0.6},
    {"second ball, 0.3 R", TOUCHING, 0.3, 0.0},
    {"second ball, 0.6 R", TOUCHING, 0.6, 0.0},
    {"second ball, 1 R", TOUCHING, 1.0, 0.0},
    {"second ball, 1.5 R", TOUCHING, 1.5, 0.0},
    {"edge noise 0.25 px", EDGE_NOISE, 0.25, 0.0},
    {"edge noise 0.5 px", EDGE_NOISE, 0.5, 0.0},
    {"edge noise 1 px", EDGE_NOISE, 1.0, 0.0},
    {"salt 1 %", SALT, 0.01, 0.0},
    {"salt 5 %", SALT, 0.05, 0.0},
    {"wholly hidden", WHOLLY_HIDDEN, 0.0, 0.0},
    {"camera covered", COVERED_DARK, 0.0, 0.0},
    {"all of the colour", COVERED_BRIGHT, 0.0, 0.0},
    {"square", SQUARE, 0.0, 0.0},
    {"rectangle 8:1", THIN_RECTANGLE, 0.0, 0.0},
    {"L", L_SHAPE, 0.0, 0.0},
    {"triangle", TRIANGLE, 0.0, 0.0},
    {"ellipse 3:2", LONG_ELLIPSE, 0.0, 0.0},
};

enum { CASE_COUNT = (int)(sizeof(CASES) / sizeof(CASES[0])) };

/* Statuses in the table's columns; the last is all the others. */
enum { STATUSES = 6 };
static const ocel_status_t STATUS[STATUSES - 1] = {OCEL_OK, OCEL_PARTIAL, OCEL_CLIPPED,
                                                   OCEL_NOT_SEEN, OCEL_DEGENERATE};

typedef struct {
    size_t count[STATUSES];
    double squares; /* of the ok answers' errors over the range */
    double worst;
    double estimates; /* the same for partial and clipped ones */
    size_t estimated;
    double honesty; /* sum of error^T covariance^-1 error / 3 */
} row_t;

static uint8_t mask[SCENE_PIXELS];
static ocel_eye_t eye;
static ocel_camera_t camera;

/* ---- Scenes ---- */

/* A ball at 300 to 800 mm, wholly in the image. */
static scene_ball_t draw_ball(rng_t *rng) {
    scene_ball_t ball;
    ref_ellipse_t outline;
    do {
        ball =
            scene_ball_at(rng_uniform(rng, 0.0, SCENE_WIDTH), rng_uniform(rng, 0.0, SCENE_HEIGHT),
                          rng_uniform(rng, 300.0, 800.0), SCENE_RADIUS_MM);
        outline = scene_outline(&ball);
    } while (!scene_is_inside(&outline, 1.0));
    return ball;
}

/* Another ball of the same radius beside the first, nearer or further so that its
 * outline is `size` times as large; they overlap by up to a fifth of the smaller. */
static void add_touching(scene_t *scene, double size, rng_t *rng) {
    const double range = scene_norm(scene->ball.centre) / size;
    const double angle = rng_uniform(rng, 0.0, 2.0 * SCENE_PI);
    const ref_ellipse_t e = scene_outline(&scene->ball);
    const double radius = sqrt(e.a * e.b);
    const double overlap = fmin(1.0, size) * rng_uniform(rng, 0.0, 0.4);
    const double away = radius * (1.0 + size - overlap);
    scene->other =
        scene_ball_at(e.cx + away * cos(angle), e.cy + away * sin(angle), range, SCENE_RADIUS_MM);
}

/* A disc over all of the ball. */
static void cover(scene_t *scene) {
    const ref_ellipse_t e = scene_outline(&scene->ball);
    scene->disc.x = e.cx;
    scene->disc.y = e.cy;
    scene->disc.radius = e.a + 1.0;
}

static void hide(scene_t *scene, const case_t *c, rng_t *rng) {
    const double angle = rng_uniform(rng, 0.0, 2.0 * SCENE_PI);
    switch (c->kind) {
    case TWO_EDGES:
        scene_add_edge(scene, rng_uniform(rng, 0.0, 2.0 * SCENE_PI), c->share);
        scene_add_edge(scene, angle, c->share);
        break;
    case ONE_EDGE:
        scene_add_edge(scene, angle, c->share);
        break;
    case DISC:
        scene_set_disc(scene, angle, c->share, c->size);
        break;
    case WHOLLY_HIDDEN:
        cover(scene);
        break;
    case BORDER: {
        const int side = rng_between(rng, 0, 3);
        const double size = ((side % 2) == 0) ? SCENE_HEIGHT : SCENE_WIDTH;
        scene_move_to_border(&scene->ball, side, rng_uniform(rng, 0.25, 0.75) * size, c->share);
        break;
    }
    case TOUCHING:
        add_touching(scene, c->size, rng);
        break;
    default:
        break;
    }
}

/* ---- Things that are no balls ---- */

/* Whether (u, v), in the thing's own axes, lies in it; it is about `r` large. */
static bool in_thing(kind_t kind, double u, double v, double r) {
    bool in = false;
    switch (kind) {
    case SQUARE:
        in = (fabs(u) <= r) && (fabs(v) <= r);
        break;
    case THIN_RECTANGLE:
        in = (fabs(u) <= 2.0 * r) && (fabs(v) <= 0.25 * r);
        break;
    case L_SHAPE:
        in = (fabs(u) <= r) && (fabs(v) <= r) && ((u <= -0.2 * r) || (v <= -0.2 * r));
        break;
    case TRIANGLE:
        in = (v >= -0.5 * r) && (fabs(u) * sqrt(3.0) + v <= r);
        break;
    case LONG_ELLIPSE:
        in = u * u / 1.5 + v * v * 1.5 <= r * r;
        break;
    default:
        in = kind == COVERED_BRIGHT;
        break;
    }
    return in;
}

static void draw_thing(kind_t kind, rng_t *rng) {
    const double r = rng_uniform(rng, 10.0, 40.0);
    const double cx = rng_uniform(rng, 2.1 * r, SCENE_WIDTH - 2.1 * r);
    const double cy = rng_uniform(rng, 2.1 * r, SCENE_HEIGHT - 2.1 * r);
    const double angle = rng_uniform(rng, 0.0, SCENE_PI);
    for (int y = 0; y < SCENE_HEIGHT; y++) {
        for (int x = 0; x < SCENE_WIDTH; x++) {
            const double u = (x - cx) * cos(angle) + (y - cy) * sin(angle);
            const double v = (y - cy) * cos(angle) - (x - cx) * sin(angle);
            mask[y * SCENE_WIDTH + x] = in_thing(kind, u, v, r) ? 1U : 0U;
        }
    }
}

/* ---- Answers ---- */

static double off(const double p[3], const scene_ball_t *ball) {
    const double d[3] = {p[0] - ball->centre[0], p[1] - ball->centre[1], p[2] - ball->centre[2]};
    return scene_norm(d) / scene_norm(ball->centre);
}

/* error^T covariance^-1 error / 3, by Cramer's rule. */
static double honesty(const double p[3], const scene_ball_t *ball, const ocel_sphere_t *sphere) {
    static const int at[3][3] = {
        {OCEL_XX, OCEL_XY, OCEL_XZ}, {OCEL_XY, OCEL_YY, OCEL_YZ}, {OCEL_XZ, OCEL_YZ, OCEL_ZZ}};
    double det = 0.0;
    double sum = 0.0;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            const int r = (i + 1) % 3;
            const int s = (i + 2) % 3;
            const int t = (j + 1) % 3;
            const int u = (j + 2) % 3;
            const double cofactor =
                (double)sphere->cov_cam_u2[at[r][t]] * (double)sphere->cov_cam_u2[at[s][u]] -
                (double)sphere->cov_cam_u2[at[r][u]] * (double)sphere->cov_cam_u2[at[s][t]];
            sum += cofactor * (p[i] - ball->centre[i]) * (p[j] - ball->centre[j]);
            det += (i == 0) ? (double)sphere->cov_cam_u2[at[i][j]] * cofactor : 0.0;
        }
    }
    return sum * SCENE_U_PER_MM * SCENE_U_PER_MM / det / 3.0;
}

/* With two balls in sight either is right: nothing tells which was meant. */
static const scene_ball_t *nearest(const scene_t *scene, const double p[3]) {
    const bool other =
        (scene->other.radius > 0.0) && (off(p, &scene->other) < off(p, &scene->ball));
    return other ? &scene->other : &scene->ball;
}

static void add_answer(row_t *row, const scene_t *scene, ocel_status_t status,
                       const ocel_cone_t *cone) {
    ocel_sphere_t sphere;
    double p_mm[3];
    int column = 0;
    while ((column < STATUSES - 1) && (STATUS[column] != status)) {
        column++;
    }
    row->count[column]++;
    if ((scene->ball.radius > 0.0) && scene_place(cone, &sphere, p_mm)) {
        const scene_ball_t *ball = nearest(scene, p_mm);
        const double error = off(p_mm, ball);
        if (status == OCEL_OK) {
            row->squares += error * error;
            row->worst = fmax(row->worst, error);
            row->honesty += honesty(p_mm, ball, &sphere);
        } else {
            row->estimates += error * error;
            row->estimated++;
        }
    }
}

static void run_trial(const case_t *c, rng_t *rng, row_t *row) {
    scene_t scene;
    ocel_detection_t detection;
    ocel_cone_t cone;
    memset(&scene, 0, sizeof(scene));
    if (c->kind < COVERED_DARK) {
        scene.ball = draw_ball(rng);
        hide(&scene, c, rng);
        scene.edge_noise_px = (c->kind == EDGE_NOISE) ? c->size : 0.0;
        scene.salt = (c->kind == SALT) ? c->size : 0.0;
        scene_draw(&scene, rng, mask);
    } else {
        draw_thing(c->kind, rng);
    }
    (void)scene_look(mask, &eye, &detection);
    const ocel_status_t status = ocel_eye_cone(&eye, &camera, &detection, &cone);
    add_answer(row, &scene, status, &cone);
}

/* ---- The table ---- */

static void print_error(report_t *report, double squares, size_t count) {
    if (count > 0U) {
        report_line(report, " %8.3f", 100.0 * sqrt(squares / (double)count));
    } else {
        report_line(report, " %8s", "");
    }
}

static void print_row(report_t *report, const case_t *c, const row_t *row) {
    const double ok = (double)row->count[0];
    report_line(report, "%-21s", c->name);
    for (int k = 0; k < STATUSES; k++) {
        if (row->count[k] > 0U) {
            report_line(report, " %7zu", row->count[k]);
        } else {
            report_line(report, " %7s", "");
        }
    }
    print_error(report, row->squares, row->count[0]);
    print_error(report, row->worst * row->worst * ok, row->count[0]);
    if (row->count[0] > 0U) {
        report_line(report, " %7.2f", row->honesty / ok);
    } else {
        report_line(report, " %7s", "");
    }
    print_error(report, row->estimates, row->estimated);
    report_line(report, "\n");
}

/* A mean of fewer answers says nothing. */
#define FEWEST 20U

typedef struct {
    double worst;      /* of the ok answers */
    double least_true; /* smallest and largest mean honesty of a case */
    double most_true;
    size_t false_ok; /* of things that are no balls, and of no ball at all */
    size_t phantoms; /* covered or wholly hidden, and not `not_seen` */
} summary_t;

static void summarise(summary_t *summary, const case_t *c, const row_t *row) {
    if (c->kind >= WHOLLY_HIDDEN) {
        summary->false_ok += row->count[0];
        if (c->kind <= COVERED_DARK) {
            summary->phantoms +=
                row->count[0] + row->count[1] + row->count[2] + row->count[4] + row->count[5];
        }
    } else {
        summary->worst = fmax(summary->worst, row->worst);
        if (row->count[0] >= FEWEST) {
            const double mean = row->honesty / (double)row->count[0];
            summary->least_true = fmin(summary->least_true, mean);
            summary->most_true = fmax(summary->most_true, mean);
        }
    }
}

int main(int argc, char **argv) {
    report_t report = report_open(argc, argv);
    const size_t trials = (argc > 2) ? strtoul(argv[2], NULL, 10) : 300UL;
    const unsigned long long seed = (argc > 3) ? strtoull(argv[3], NULL, 10) : 1998ULL;
    rng_t rng = rng_seed(seed);
    static row_t rows[CASE_COUNT];
    summary_t summary = {0.0, INFINITY, 0.0, 0, 0};
    scene_camera(&camera);
    report_line(
        &report,
        "Balls of 35 mm at 300 to 800 mm, anywhere in an image of 320x240, f = 277 px; %zu\n"
        "trials each, seed %llu: how often each status, the error of the ok answers in %% of\n"
        "the range (RMS, worst), mean error^T covariance^-1 error / 3, and the RMS error of\n"
        "the estimates that are partial or clipped.  A share is one of the outline's area.\n\n",
        trials, seed);
    report_line(&report, "%-21s %7s %7s %7s %7s %7s %7s %8s %8s %7s %8s\n", "", "ok", "partial",
                "clipped", "notseen", "degen.", "other", "RMS %", "worst %", "cov", "not ok %");
    for (int i = 0; i < CASE_COUNT; i++) {
        for (size_t trial = 0; trial < trials; trial++) {
            run_trial(&CASES[i], &rng, &rows[i]);
        }
        print_row(&report, &CASES[i], &rows[i]);
        summarise(&summary, &CASES[i], &rows[i]);
    }
    report_line(&report, "\n");
    report_claim(&report, "ok with an error of more than 5 % of the range: worst, %",
                 100.0 * summary.worst, 5.0);
    report_claim(&report, "ok without a ball", (double)summary.false_ok, 0.0);
    report_claim(&report, "covered or wholly hidden and not not_seen", (double)summary.phantoms,
                 0.0);
    report_claim(&report, "error^T covariance^-1 error / 3, largest mean of a case",
                 summary.most_true, 3.0);
    report_claim(&report, "its reciprocal, largest", 1.0 / summary.least_true, 1.0 / 0.3);
    return report_close(&report);
}
