/* SPDX-License-Identifier: MIT
 *
 * Clean disc masks: a pixel is set when its centre lies in the disc, the centre
 * is a random sub-pixel position.  The library's chain (labeller, crack
 * midpoints, fit) beside the paper's (inner boundary pixels, B2AC in long
 * double).
 *
 *   accuracy_disc_masks [TABLE.txt [TRIALS [SEED]]]
 */
#include <string.h>

#include "fit_support.h"
#include "frames.h"
#include "report.h"
#include "rng.h"

enum { SIDE = 240, MAX_POINTS = OCEL_MAX_CRACKS, METHODS = 4 };

static const double RADII[] = {5.0, 20.0, 40.0, 100.0};
static const char *const NAMES[METHODS] = {"paper: inner pixels", "b2ac", "lcse", "hyper"};

typedef struct {
    double squares;
    double radius;
    size_t answered;
    size_t perturbed;
} column_t;

static uint8_t mask[SIDE * SIDE];
static ocel_labeller_t labeller;
static ocel_crack_pool_t pool;

/* The mask through the labeller; the boundary of its only blob. */
static size_t boundary_of_mask(const ocel_crack_t **cracks) {
    static uint32_t rows[SIDE * ((SIDE + 31) / 32)];
    const size_t words = (SIDE + 31) / 32;
    size_t count = 0;
    size_t stride = 0;
    frame_mask_to_bits(mask, SIDE, SIDE, rows);
    ocel_status_t status = ocel_label_begin(&labeller, &pool, SIDE, SIDE, OCEL_CONNECT_8);
    for (size_t y = 0; (y < SIDE) && (status == OCEL_OK); y++) {
        status = ocel_label_row(&labeller, &pool, &rows[y * words], NULL, NULL);
    }
    if (status == OCEL_OK) {
        status = ocel_label_end(&labeller, &pool, NULL, NULL, NULL);
    }
    if (status == OCEL_OK) {
        status = ocel_label_boundary(&labeller, &pool, cracks, &count, &stride);
    }
    if ((status != OCEL_OK) || (stride != 1U)) {
        (void)fprintf(stderr, "labelling: %s, stride %zu\n", ocel_status_name(status), stride);
        exit(1);
    }
    return count;
}

/* The inside pixels with an outside one beside them: what the paper, and OpenCV's
 * contours, call the boundary. */
static size_t inner_pixels(ref_point_t *points) {
    size_t count = 0;
    for (int y = 1; y < SIDE - 1; y++) {
        for (int x = 1; x < SIDE - 1; x++) {
            const uint8_t *p = &mask[y * SIDE + x];
            if ((p[0] != 0U) &&
                ((p[-1] == 0U) || (p[1] == 0U) || (p[-SIDE] == 0U) || (p[SIDE] == 0U))) {
                points[count].x = x;
                points[count].y = y;
                count++;
            }
        }
    }
    return count;
}

static void add(column_t *column, const ref_ellipse_t *e, double cx, double cy, double radius) {
    column->squares += (e->cx - cx) * (e->cx - cx) + (e->cy - cy) * (e->cy - cy);
    column->radius += sqrt(e->a * e->b) - radius;
    column->answered++;
}

static void run_trial(double radius, rng_t *rng, column_t *columns) {
    static const ocel_fit_method_t methods[METHODS - 1] = {OCEL_FIT_B2AC, OCEL_FIT_LCSE,
                                                           OCEL_FIT_HYPER};
    static ref_point_t points[MAX_POINTS];
    const double cx = SIDE / 2 + rng_uniform(rng, -0.5, 0.5);
    const double cy = SIDE / 2 + rng_uniform(rng, -0.5, 0.5);
    const ocel_crack_t *cracks = NULL;
    ref_ellipse_t e;
    memset(mask, 0, sizeof(mask));
    frame_add_disc(mask, SIDE, SIDE, cx, cy, radius);
    if (ref_fit(REF_B2AC, points, inner_pixels(points), &e)) {
        add(&columns[0], &e, cx, cy, radius);
    }
    const size_t count = boundary_of_mask(&cracks);
    for (int m = 1; m < METHODS; m++) {
        ocel_fit_options_t options = fit_options(methods[m - 1], OCEL_PERTURB_AUTO);
        ocel_ellipse_t answer;
        options.closed = true;
        if (ocel_fit_cracks(cracks, count, &options, &answer) == OCEL_OK) {
            e = fit_to_double(&answer);
            add(&columns[m], &e, cx, cy, radius);
            columns[m].perturbed += answer.perturbed ? 1U : 0U;
        }
    }
}

int main(int argc, char **argv) {
    report_t report = report_open(argc, argv);
    const size_t trials = (argc > 2) ? strtoul(argv[2], NULL, 10) : 6000UL;
    const unsigned long long seed = (argc > 3) ? strtoull(argv[3], NULL, 10) : 1998ULL;
    rng_t rng = rng_seed(seed);
    double bias = 0.0;
    double centre = 0.0;
    size_t unanswered = 0;
    report_line(
        &report,
        "Clean disc masks, random sub-pixel centre, %zu trials each, seed %llu: RMS error of\n"
        "the centre and mean error of the radius, px.\n\n",
        trials, seed);
    report_line(&report, "%-20s", "");
    for (size_t r = 0; r < 4U; r++) {
        report_line(&report, " | R = %-12.0f", RADII[r]);
    }
    report_line(&report, "\n");
    column_t columns[4][METHODS];
    memset(columns, 0, sizeof(columns));
    for (size_t r = 0; r < 4U; r++) {
        for (size_t trial = 0; trial < trials; trial++) {
            run_trial(RADII[r], &rng, columns[r]);
        }
    }
    for (int m = 0; m < METHODS; m++) {
        report_line(&report, "%-20s", NAMES[m]);
        for (size_t r = 0; r < 4U; r++) {
            const column_t *c = &columns[r][m];
            const double rms = sqrt(c->squares / (double)c->answered);
            const double off = c->radius / (double)c->answered;
            report_line(&report, " | %.4f  %+.4f ", rms, off);
            unanswered += trials - c->answered;
            if ((m > 0) && (RADII[r] == 40.0)) {
                bias = fmax(bias, fabs(off));
                centre = fmax(centre, rms);
            }
        }
        report_line(&report, "\n");
    }
    report_line(&report, "\nLCSE perturbed %zu, %zu, %zu, %zu of them.\n\n",
                columns[0][2].perturbed, columns[1][2].perturbed, columns[2][2].perturbed,
                columns[3][2].perturbed);
    report_claim(&report, "masks without status ok", (double)unanswered, 0.0);
    report_claim(&report, "R = 40, worst |radius bias| of the library's methods, px", bias, 0.005);
    report_claim(&report, "R = 40, worst centre RMS of the library's methods, px", centre, 0.034);
    return report_close(&report);
}
