/* SPDX-License-Identifier: MIT
 *
 * A bouncing ball before an iCub's two eyes, hidden for .3 s at any phase: the tracker
 * with the head at rest, and the head following.  Measured are rendered masks, through
 * the eye, the cone of rays and stereo; and, for many more trials, positions drawn with
 * such noise: by each eye with its own, then their mean.
 *
 *   accuracy_tracking [TABLE.txt [TRIALS [SEED]]]
 */
#include <string.h>

#include <ocellus/ocellus.h>

#include "ball_scene.h"
#include "report.h"
#include "rng.h"

enum { AXES = 3, EYES = OCEL_EYE_COUNT };

#define TURN 4294967296.0
#define DEGREES(v) ((double)(v) / TURN * 360.0)
#define Q30 1073741824.0

/* Millimetres and seconds; the library's u is the micrometre. */
static const double GRAVITY = 9810.0;
static const double RESTITUTION = 0.8;
static const double HIDDEN_S = 0.3;
static const double CENTRE_SIGMA_PX = 0.05;
static const double RADIUS_SIGMA = 0.001;

/* The root frame of the iCub: x back, y right, z up. */
typedef struct {
    double p[AXES];
    double v[AXES];
    double floor; /* where its centre bounces */
    double t;
    double bounced_at; /* when it last did */
} ball_t;

/* Free flight until it bounces.  Dropped from h it bounces for 9 sqrt(2 h / g), 2.4 s from
 * 350 mm; no run is longer. */
static void ball_advance(ball_t *ball, double dt) {
    double rest = dt;
    while (rest > 0.0) {
        const double height = ball->p[2] - ball->floor;
        const double down =
            (ball->v[2] + sqrt(fmax(0.0, ball->v[2] * ball->v[2] + 2.0 * GRAVITY * height))) /
            GRAVITY;
        const double step = fmin(rest, down);
        for (int i = 0; i < AXES; i++) {
            ball->p[i] += ball->v[i] * step;
        }
        ball->p[2] -= GRAVITY * step * step / 2.0;
        ball->v[2] -= GRAVITY * step;
        rest -= step;
        if (rest > 0.0) {
            ball->p[2] = ball->floor;
            ball->v[2] = -RESTITUTION * ball->v[2];
            ball->bounced_at = ball->t + dt - rest;
        }
    }
    ball->t += dt;
}

/* .5 to 1 m in front of the eyes, dropped from 350 mm over where it bounces. */
static ball_t ball_random(rng_t *rng) {
    const double distance = rng_uniform(rng, 500.0, 1000.0);
    ball_t ball = {{-distance - 60.0, rng_uniform(rng, -80.0, 80.0), 341.0 + 175.0},
                   {rng_uniform(rng, -100.0, 100.0), rng_uniform(rng, -100.0, 100.0), 0.0},
                   341.0 - 175.0,
                   0.0,
                   0.0};
    ball_advance(&ball, rng_uniform(rng, 0.0, 0.3));
    return ball;
}

/* Carried round a circle of 150 mm radius in 2 s, upright before the eyes. */
static void carry(ball_t *ball, double dt) {
    const double rate = 3.14159265358979;
    ball->t += dt;
    ball->p[0] = -760.0;
    ball->p[1] = 150.0 * cos(rate * ball->t);
    ball->p[2] = 341.0 + 150.0 * sin(rate * ball->t);
}

/* ---- What the eyes measure ---- */

typedef struct {
    ocel_estimate_t fix;
    bool seen;    /* there is one */
    bool in_view; /* in truth: one eye at least has the whole ball in its image */
} view_t;

/* The ball in an eye's frame, mm; whether its whole outline is in the image. */
static bool in_view(const ocel_pose_t *X, const double p[AXES], double d[AXES]) {
    for (int k = 0; k < AXES; k++) {
        d[k] = 0.0;
        for (int i = 0; i < AXES; i++) {
            d[k] += (p[i] - X->p_u[i] / 1000.0) * X->r_q30[i][k] / Q30;
        }
    }
    const double margin = (d[2] > 1.0) ? SCENE_F_PX * SCENE_RADIUS_MM / d[2] : 0.0;
    return (d[2] > SCENE_RADIUS_MM) && (SCENE_F_PX * fabs(d[0]) / d[2] < 160.0 - margin) &&
           (SCENE_F_PX * fabs(d[1]) / d[2] < 120.0 - margin);
}

/* A direction off by CENTRE_SIGMA_PX along two perpendiculars, a range off by RADIUS_SIGMA. */
static void measure_one(const ocel_pose_t *X, const double d[AXES], rng_t *rng, double p[AXES],
                        double cov[AXES][AXES]) {
    const double range = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    const double across = CENTRE_SIGMA_PX / SCENE_F_PX * range;
    const double along = RADIUS_SIGMA * range;
    double unit[AXES];
    double noise[AXES];
    double radial = 0.0;
    for (int i = 0; i < AXES; i++) {
        unit[i] = 0.0;
        for (int k = 0; k < AXES; k++) {
            unit[i] += X->r_q30[i][k] / Q30 * d[k] / range;
        }
        noise[i] = across * rng_gauss(rng);
        radial += noise[i] * unit[i];
    }
    const double stretch = along * rng_gauss(rng) - radial;
    for (int i = 0; i < AXES; i++) {
        p[i] = X->p_u[i] / 1000.0 + range * unit[i] + noise[i] + stretch * unit[i];
        for (int j = 0; j < AXES; j++) {
            cov[i][j] = (along * along - across * across) * unit[i] * unit[j] +
                        ((i == j) ? across * across : 0.0);
        }
    }
}

/* The mean of what the eyes measure that see it. */
static view_t measure_drawn(const ocel_pose_t X[EYES], const ball_t *ball, rng_t *rng) {
    static const int ENTRY[AXES][AXES] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
    view_t view;
    double sum[AXES] = {0.0};
    double sums[AXES][AXES] = {{0.0}};
    int count = 0;
    memset(&view, 0, sizeof(view));
    for (int eye = 0; eye < EYES; eye++) {
        double d[AXES];
        double p[AXES];
        double cov[AXES][AXES];
        if (!in_view(&X[eye], ball->p, d)) {
            continue;
        }
        measure_one(&X[eye], d, rng, p, cov);
        count++;
        for (int i = 0; i < AXES; i++) {
            sum[i] += p[i];
            for (int j = 0; j < AXES; j++) {
                sums[i][j] += cov[i][j];
            }
        }
    }
    view.seen = count > 0;
    view.in_view = view.seen;
    for (int i = 0; view.seen && (i < AXES); i++) {
        view.fix.p_root_u[i] = (int32_t)lround(1000.0 * sum[i] / count);
        for (int j = i; j < AXES; j++) {
            view.fix.cov_root_u2[ENTRY[i][j]] =
                (int64_t)llround(1e6 * sums[i][j] / ((double)count * count));
        }
    }
    return view;
}

/* One eye's image through the library: false when it vouches for no ball. */
static bool find_cone(const double d[AXES], bool hidden, rng_t *rng, ocel_cone_t *cone) {
    static uint8_t mask[SCENE_PIXELS];
    static ocel_eye_t eye;
    static ocel_camera_t camera;
    scene_t scene;
    ocel_detection_t detection;
    memset(&scene, 0, sizeof(scene));
    memcpy(scene.ball.centre, d, sizeof(scene.ball.centre));
    scene.ball.radius = hidden ? 0.0 : SCENE_RADIUS_MM;
    scene_camera(&camera);
    scene_draw(&scene, rng, mask);
    (void)scene_look(mask, &eye, &detection);
    return ocel_eye_cone(&eye, &camera, &detection, cone) == OCEL_OK;
}

/* Both eyes' images through the library. */
static view_t measure_rendered(const ocel_pose_t X[EYES], const ball_t *ball, bool hidden,
                               rng_t *rng) {
    ocel_cone_t cone[EYES];
    bool found[EYES];
    ocel_ball_t answer;
    view_t view;
    memset(&view, 0, sizeof(view));
    for (int eye = 0; eye < EYES; eye++) {
        double d[AXES];
        view.in_view = in_view(&X[eye], ball->p, d) || view.in_view;
        found[eye] = find_cone(d, hidden, rng, &cone[eye]);
    }
    view.seen = ocel_stereo_ball(found[0] ? &cone[0] : NULL, found[1] ? &cone[1] : NULL, X, 35000,
                                 &answer) == OCEL_OK;
    view.fix = answer.best;
    return view;
}

/* ---- Figures ---- */

typedef struct {
    double squares;
    double worst;
    size_t count;
} error_t;

static void add(error_t *error, double value) {
    error->squares += value * value;
    error->worst = fmax(error->worst, value);
    error->count++;
}

static double rms(const error_t *error) {
    return sqrt(error->squares / (double)error->count);
}

static double distance_of(const int32_t p_u[AXES], const ball_t *ball) {
    double square = 0.0;
    for (int i = 0; i < AXES; i++) {
        const double e = p_u[i] / 1000.0 - ball->p[i];
        square += e * e;
    }
    return sqrt(square);
}

typedef struct {
    error_t measured;     /* what the tracker is given, mm */
    error_t seen;         /* what it tells */
    error_t in_flight;    /* at the end of a gap, without a bounce or one just before it */
    error_t bounced;      /* with one */
    size_t within;        /* guesses at that end within 4 deviations on every axis */
    size_t guesses;       /* of so many */
    size_t ok_hidden;     /* frames */
    size_t refused;       /* frames outside the gate, the ball in view */
    size_t seen_frames;   /* of so many */
    int worst_acquire;    /* frames until a measurement is taken again */
    int worst_lost;       /* most frames in a row that are refused */
    error_t gaze_seen;    /* the ball off an eye's axis, degrees */
    error_t gaze_guessed; /* while it is hidden */
    size_t out_of_view;   /* frames in which no eye could see the ball */
} tally_t;

static ocel_tracker_config_t tracker_config(bool gravity) {
    ocel_tracker_config_t config = {500000U, 8000000, 3000000, 4U * 65536U, 5000, {0, 0, 0}};
    config.acceleration_root_u_s2[2] = gravity ? -9810000 : 0;
    return config;
}

static void check_guess(tally_t *tally, const ocel_track_t *track, const ball_t *ball,
                        bool bounced) {
    static const int DIAGONAL[AXES] = {OCEL_XX, OCEL_YY, OCEL_ZZ};
    bool within = track->state == OCEL_TRACK_GUESSED;
    for (int i = 0; i < AXES; i++) {
        const double e = fabs(track->p_root_u[i] / 1000.0 - ball->p[i]);
        within = within && (e <= 4.0 * sqrt((double)track->cov_root_u2[DIAGONAL[i]]) / 1000.0);
    }
    add(bounced ? &tally->bounced : &tally->in_flight, distance_of(track->p_root_u, ball));
    tally->within += within ? 1U : 0U;
    tally->guesses++;
}

/* What became of a trial, frame by frame, for the tally. */
typedef struct {
    double seen_at; /* when it was last in view */
    int waiting;    /* frames since it is in view again, none taken yet; -1: taken */
    int refused;    /* in a row */
} course_t;

static void take_down(tally_t *tally, course_t *course, ocel_status_t status, bool hidden,
                      const view_t *view, const ocel_track_t *track, const ball_t *ball) {
    if (hidden) {
        tally->ok_hidden += (status == OCEL_OK) ? 1U : 0U;
        course->waiting = 0;
        course->refused = 0;
    } else if (view->in_view) {
        tally->seen_frames++;
        course->refused = (status == OCEL_OK) ? 0 : (course->refused + 1);
        tally->refused += (status == OCEL_OK) ? 0U : 1U;
        tally->worst_lost =
            (course->refused > tally->worst_lost) ? course->refused : tally->worst_lost;
        if (course->waiting >= 0) {
            course->waiting++;
            tally->worst_acquire =
                (course->waiting > tally->worst_acquire) ? course->waiting : tally->worst_acquire;
        }
        if (status == OCEL_OK) {
            course->waiting = -1;
            add(&tally->seen, distance_of(track->p_root_u, ball));
            add(&tally->measured, distance_of(view->fix.p_root_u, ball));
        }
    } else {
        tally->out_of_view++;
        course->refused = 0;
    }
    course->seen_at = hidden ? course->seen_at : ball->t;
}

/* ---- The head at rest ---- */

/* When to hide it so that the gap lies in one flight: .105 s after it next bounces, which
 * is 3 frames at 30 Hz, and .02 s or more before it bounces again. */
static double after_bounce(const ball_t *ball) {
    ball_t later = *ball;
    while (later.bounced_at <= ball->bounced_at) {
        ball_advance(&later, 0.001);
    }
    return later.bounced_at - ball->t + 0.105;
}

/* in_flight: hidden between two bounces, else at any phase. */
static void run_still(tally_t *tally, double fps, bool gravity, bool rendered, bool in_flight,
                      rng_t *rng) {
    static const int32_t AHEAD[OCEL_JOINT_COUNT] = {0};
    const ocel_tracker_config_t config = tracker_config(gravity);
    const double any = rng_uniform(rng, 0.2, 1.0);
    ball_t ball = ball_random(rng);
    const double hide_at = in_flight ? after_bounce(&ball) : any;
    ocel_pose_t X[EYES];
    ocel_tracker_t tracker;
    ocel_track_t track;
    course_t course = {0.0, -1, 0};
    (void)ocel_tracker_init(&tracker, &config);
    (void)ocel_head_forward(&ocel_head_icub_v1, AHEAD, X);
    for (int frame = 0; frame < (int)(1.5 * fps); frame++) {
        const double t = frame / fps;
        const bool hidden = (t >= hide_at) && (t < hide_at + HIDDEN_S);
        view_t view =
            rendered ? measure_rendered(X, &ball, hidden, rng) : measure_drawn(X, &ball, rng);
        const bool ends = hidden && (t + 1.0 / fps >= hide_at + HIDDEN_S);
        view.seen = view.seen && (rendered || !hidden);
        const ocel_status_t status =
            ocel_tracker_update(&tracker, llround(t * 1e6), view.seen ? &view.fix : NULL, &track);
        take_down(tally, &course, status, hidden, &view, &track, &ball);
        if (ends) {
            check_guess(tally, &track, &ball, ball.bounced_at > course.seen_at - 3.0 / fps);
        }
        ball_advance(&ball, 1.0 / fps);
    }
}

/* ---- The head following ---- */

enum { LATEST = 0, TRACKED, AHEAD_OF_TIME, FEEDS };
static const char *const FEED[FEEDS] = {"what the eyes see", "the track", "the track in 1/8 s"};

/* A guess is followed while it is this sharp: beyond, the ball may be anywhere in the
 * image already, and is best waited for. */
static const double SHARP_U = 100000.0;

/* The directions in which the eyes would see a point. */
static void errors_of(const ocel_pose_t X[EYES], const int32_t p_u[AXES],
                      ocel_gaze_error_t errors[EYES]) {
    for (int eye = 0; eye < EYES; eye++) {
        int32_t d_cam[AXES];
        for (int k = 0; k < AXES; k++) {
            double sum = 0.0;
            for (int i = 0; i < AXES; i++) {
                sum += ((double)p_u[i] - X[eye].p_u[i]) * X[eye].r_q30[i][k] / Q30;
            }
            d_cam[k] = (int32_t)lround(sum);
        }
        (void)ocel_gaze_error(d_cam, &errors[eye]);
    }
}

/* What the gaze is told: the measurement, or the track, or where the track will be. */
static void feed(int which, const ocel_tracker_t *tracker, const view_t *view,
                 const ocel_track_t *track, int64_t time_us, const ocel_pose_t X[EYES],
                 ocel_gaze_error_t errors[EYES]) {
    memset(errors, 0, EYES * sizeof(errors[0]));
    if (which == LATEST) {
        if (view->seen) {
            errors_of(X, view->fix.p_root_u, errors);
        }
    } else {
        ocel_track_t told = *track;
        if (which == AHEAD_OF_TIME) {
            ocel_tracker_t later = *tracker;
            (void)ocel_tracker_update(&later, time_us + 125000, NULL, &told);
        }
        const double variance = (double)track->cov_root_u2[OCEL_ZZ];
        if ((told.state != OCEL_TRACK_LOST) && (sqrt(variance) < SHARP_U)) {
            errors_of(X, told.p_root_u, errors);
        }
    }
}

static void add_gaze(error_t *error, const ocel_pose_t X[EYES], const ball_t *ball) {
    for (int eye = 0; eye < EYES; eye++) {
        double d[AXES];
        (void)in_view(&X[eye], ball->p, d);
        add(error, atan2(hypot(d[0], d[1]), d[2]) * 57.29577951308232);
    }
}

static void run_following(tally_t *tally, double fps, int which, bool carried, rng_t *rng) {
    const ocel_tracker_config_t config = tracker_config(!carried);
    const double settled = carried ? 1.0 : 0.4; /* the bouncing one does not last */
    const double hide_at = settled + rng_uniform(rng, 0.2, 0.7);
    ball_t ball = ball_random(rng);
    double q[OCEL_JOINT_COUNT] = {0.0};
    if (carried) {
        ball.t = rng_uniform(rng, 0.0, 2.0);
        carry(&ball, 0.0);
    }
    ocel_tracker_t tracker;
    ocel_gaze_t gaze;
    course_t course = {0.0, -1, 0};
    (void)ocel_tracker_init(&tracker, &config);
    (void)ocel_gaze_init(&gaze, &ocel_head_icub_v1, &ocel_gaze_icub);
    for (int frame = 0; frame < (int)((settled + 1.2) * fps); frame++) {
        const double t = frame / fps;
        const int64_t time_us = llround(t * 1e6);
        const bool hidden = (t >= hide_at) && (t < hide_at + HIDDEN_S);
        int32_t joints[OCEL_JOINT_COUNT];
        int32_t command[OCEL_JOINT_COUNT];
        ocel_pose_t X[EYES];
        ocel_track_t track;
        ocel_gaze_error_t errors[EYES];
        for (int i = 0; i < OCEL_JOINT_COUNT; i++) {
            joints[i] = (int32_t)lround(q[i]);
        }
        if (ocel_head_forward(&ocel_head_icub_v1, joints, X) != OCEL_OK) {
            (void)fprintf(stderr, "a joint is beyond its limit\n");
            exit(1);
        }
        view_t view = measure_drawn(X, &ball, rng);
        view.seen = view.seen && !hidden;
        const ocel_status_t status =
            ocel_tracker_update(&tracker, time_us, view.seen ? &view.fix : NULL, &track);
        take_down(tally, &course, status, hidden, &view, &track, &ball);
        if (t >= settled) {
            add_gaze(hidden ? &tally->gaze_guessed : &tally->gaze_seen, X, &ball);
        }
        feed(which, &tracker, &view, &track, time_us, X, errors);
        (void)ocel_gaze_update(&gaze, time_us, errors, joints, command);
        for (int i = 0; i < OCEL_JOINT_COUNT; i++) {
            q[i] += command[i] / fps;
        }
        if (carried) {
            carry(&ball, 1.0 / fps);
        } else {
            ball_advance(&ball, 1.0 / fps);
        }
    }
}

/* ---- The tables ---- */

static void merge(tally_t *all, const tally_t *part) {
    all->ok_hidden += part->ok_hidden;
    all->worst_acquire =
        (part->worst_acquire > all->worst_acquire) ? part->worst_acquire : all->worst_acquire;
    all->worst_lost = (part->worst_lost > all->worst_lost) ? part->worst_lost : all->worst_lost;
    all->within += part->within;
    all->guesses += part->guesses;
}

static const double FPS[2] = {30.0, 60.0};

/* Two rows; `last` is then what that of 60 Hz tells. */
static void rows_still(report_t *report, size_t trials, bool gravity, bool rendered, rng_t *rng,
                       tally_t *all, tally_t *last) {
    for (int k = 0; k < 2; k++) {
        memset(last, 0, sizeof(*last));
        for (size_t trial = 0; trial < trials; trial++) {
            run_still(last, FPS[k], gravity, rendered, (trial % 2U) == 0U, rng);
        }
        report_line(
            report, "%-8s | %2.0f Hz, gravity %-7s | %8.2f %8.2f | %9.0f %8.0f | %6.2f %% | %d\n",
            rendered ? "rendered" : "drawn", FPS[k], gravity ? "known" : "unknown",
            rms(&last->measured), rms(&last->seen), rms(&last->in_flight), rms(&last->bounced),
            100.0 * (double)last->refused / (double)last->seen_frames, last->worst_acquire);
        merge(all, last);
    }
}

/* seen: RMS off the axis, of [which] at 60 Hz. */
static void table_following(report_t *report, size_t trials, bool carried, rng_t *rng, tally_t *all,
                            double seen[FEEDS]) {
    for (int which = 0; which < FEEDS; which++) {
        report_line(report, "%-8s | %-18s", carried ? "carried" : "bouncing", FEED[which]);
        for (int k = 0; k < 2; k++) {
            static tally_t tally;
            memset(&tally, 0, sizeof(tally));
            for (size_t trial = 0; trial < trials; trial++) {
                run_following(&tally, FPS[k], which, carried, rng);
            }
            report_line(report, " | %5.2f %5.1f %6.2f  %5.1f %%", rms(&tally.gaze_seen),
                        tally.gaze_seen.worst, rms(&tally.gaze_guessed),
                        100.0 * (double)tally.out_of_view /
                            (double)(tally.out_of_view + tally.seen_frames));
            merge(all, &tally);
            seen[which] = rms(&tally.gaze_seen);
        }
        report_line(report, "\n");
    }
}

int main(int argc, char **argv) {
    report_t report = report_open(argc, argv);
    const size_t trials = (argc > 2) ? strtoul(argv[2], NULL, 10) : 400UL;
    const unsigned long long seed = (argc > 3) ? strtoull(argv[3], NULL, 10) : 2011ULL;
    rng_t rng = rng_seed(seed);
    static tally_t all;
    static tally_t known;
    static tally_t masks;
    double bouncing[FEEDS];
    double carried[FEEDS];
    const size_t renderings = 1U + trials / 10U;
    report_line(
        &report,
        "A ball of 35 mm radius that bounces (restitution .8) .5 to 1 m before two eyes of\n"
        "f = 277 px, 68 mm apart; hidden for .3 s, at any phase or between bounces.  Rendered: "
        "masks, through the\n"
        "library, %zu trials each; drawn: centres to .05 px and radii to .1 %%, %zu trials;\n"
        "seed %llu.  RMS errors, mm: of what is measured and of the track, and of the guess after\n"
        ".3 s, in flight and with a bounce then or just before; frames refused by the gate; "
        "frames\n"
        "until the ball is taken again, at worst.\n\n",
        renderings, trials, seed);
    report_line(&report,
                "%-8s | %-22s | measured, tracked | in flight, bounced | refused | again\n", "",
                "");
    rows_still(&report, renderings, true, true, &rng, &all, &masks);
    rows_still(&report, trials, false, false, &rng, &all, &known);
    rows_still(&report, trials, true, false, &rng, &all, &known);
    report_line(
        &report,
        "\nThe head, an iCub's, follows: degrees off the eyes' axes, RMS and worst while in view,\n"
        "RMS while hidden; frames in which neither eye has the whole ball in its image.\n\n"
        "%-8s | %-18s | %-27s | %s\n",
        "the ball", "the gaze is told", "30 Hz", "60 Hz");
    table_following(&report, trials, false, &rng, &all, bouncing);
    table_following(&report, trials, true, &rng, &all, carried);
    report_line(&report, "\n");
    report_claim(&report, "frames with status ok while the ball is hidden", (double)all.ok_hidden,
                 0.0);
    report_claim(&report, "frames until it is taken again, worst", all.worst_acquire, 2.0);
    report_claim(&report, "refused frames in a row, worst", all.worst_lost, 1.0);
    report_claim(&report, "position RMS while seen over the measurement's, 60 Hz, gravity known",
                 rms(&known.seen) / rms(&known.measured), 1.0);
    report_claim(&report, "the same, rendered", rms(&masks.seen) / rms(&masks.measured), 1.0);
    report_claim(&report, "guess RMS after .3 s in flight, 60 Hz, gravity known, mm",
                 rms(&known.in_flight), 30.0);
    report_claim(&report, "the same, rendered", rms(&masks.in_flight), 60.0);
    report_claim(&report, "share of guesses beyond 4 deviations",
                 1.0 - (double)all.within / (double)all.guesses, 0.02);
    report_claim(&report, "off the axes, bouncing, the track, 60 Hz, degrees", bouncing[TRACKED],
                 5.0);
    report_claim(&report, "off the axes, carried, the track in 1/8 s, 60 Hz, degrees",
                 carried[AHEAD_OF_TIME], 3.0);
    return report_close(&report);
}
