/* SPDX-License-Identifier: MIT
 *
 * Forward kinematics of the three heads beside the published chains in double
 * precision: both eyes, joints anywhere within their limits.  The arm's length is
 * from the root to the farthest eye among the trials.
 *
 *   accuracy_head_kinematics [TABLE.txt [TRIALS [SEED]]]
 */
#include "head_reference.h"
#include "report.h"
#include "rng.h"

#define UNITS 1e6 /* u in a metre, or an SMU */

typedef struct {
    double arm_u;
    double squares; /* of the position's error, u */
    double worst_u;
    double worst_axis; /* of an axis, as a vector */
    size_t poses;
    size_t refused;
} figures_t;

static void add_eye(figures_t *f, const ref_matrix_t *truth, const ocel_pose_t *pose) {
    double arm = 0.0;
    double off = 0.0;
    for (int i = 0; i < 3; i++) {
        const double p = truth->m[i][3] * UNITS;
        arm += p * p;
        off += (pose->p_u[i] - p) * (pose->p_u[i] - p);
    }
    for (int j = 0; j < 3; j++) {
        double turn = 0.0;
        for (int i = 0; i < 3; i++) {
            const double d = ldexp(pose->r_q30[i][j], -30) - truth->m[i][j];
            turn += d * d;
        }
        f->worst_axis = fmax(f->worst_axis, sqrt(turn));
    }
    f->arm_u = fmax(f->arm_u, sqrt(arm));
    f->squares += off;
    f->worst_u = fmax(f->worst_u, sqrt(off));
    f->poses++;
}

static void run_trial(int head, rng_t *rng, figures_t *f) {
    const ocel_head_model_t *model = REF_HEAD_MODELS[head];
    int32_t joints[OCEL_JOINT_COUNT];
    double deg[OCEL_JOINT_COUNT];
    ocel_pose_t eyes[OCEL_EYE_COUNT];
    for (int j = 0; j < OCEL_JOINT_COUNT; j++) {
        joints[j] = rng_between(rng, model->min_q32[j], model->max_q32[j]);
    }
    /* What of the pan's range the version leaves. */
    joints[OCEL_EYES_VERGENCE] =
        rng_between(rng, 0, 2 * (model->max_pan_q32 - abs(joints[OCEL_EYES_VERSION])));
    for (int j = 0; j < OCEL_JOINT_COUNT; j++) {
        deg[j] = joints[j] / REF_TURN_Q32 * 360.0;
    }
    if (ocel_head_forward(model, joints, eyes) != OCEL_OK) {
        f->refused++;
    } else {
        for (int eye = 0; eye < OCEL_EYE_COUNT; eye++) {
            const ref_matrix_t truth = ref_head_eye(head, deg, (eye == OCEL_LEFT) ? -1.0 : 1.0);
            add_eye(f, &truth, &eyes[eye]);
        }
    }
}

int main(int argc, char **argv) {
    report_t report = report_open(argc, argv);
    const size_t trials = (argc > 2) ? strtoul(argv[2], NULL, 10) : 100000UL;
    const unsigned long long seed = (argc > 3) ? strtoull(argv[3], NULL, 10) : 2011ULL;
    rng_t rng = rng_seed(seed);
    double worst = 0.0;
    double axis = 0.0;
    size_t refused = 0;
    report_line(&report,
                "Forward kinematics to both eyes, %zu random poses each, seed %llu, beside double\n"
                "precision.  u is a micrometre, for the paper's head 1e-6 SMU.\n\n",
                trials, seed);
    report_line(&report, "%-8s | %9s | %19s | %13s | %s\n", "head", "arm, u",
                "error of position, u", "of the arm", "of an axis");
    report_line(&report, "%-8s | %9s | %9s %10s | %13s | %s\n", "", "", "RMS", "worst", "worst",
                "worst, rad");
    for (int head = 0; head < REF_HEADS; head++) {
        figures_t f = {0};
        for (size_t trial = 0; trial < trials; trial++) {
            run_trial(head, &rng, &f);
        }
        report_line(&report, "%-8s | %9.0f | %9.3f %10.3f | %13.2e | %.1e\n", REF_HEAD_NAMES[head],
                    f.arm_u, sqrt(f.squares / (double)f.poses), f.worst_u, f.worst_u / f.arm_u,
                    f.worst_axis);
        worst = fmax(worst, f.worst_u / f.arm_u);
        axis = fmax(axis, f.worst_axis);
        refused += f.refused;
    }
    report_line(&report, "\n");
    report_claim(&report, "poses refused", (double)refused, 0.0);
    report_claim(&report, "worst error of a position, of the arm's length", worst, 1e-5);
    report_claim(&report, "worst error of an axis, rad", axis, ldexp(1.0, -26));
    return report_close(&report);
}
