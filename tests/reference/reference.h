/* SPDX-License-Identifier: MIT
 *
 * The truth that the fixed-point fit is measured against: the same estimators
 * in long double, by other means (symmetric Jacobi, no cubic), and the bound that
 * no estimator beats.  Tests only.  Against the same code with 113-bit numbers the
 * fits of points with semi-axes 5..200 px differ by less than 1e-8 px on arcs of 60
 * degrees, 1e-10 px from 180 degrees on.
 */
#ifndef REFERENCE_REFERENCE_H
#define REFERENCE_REFERENCE_H

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef long double ref_real_t;

typedef struct {
    double x;
    double y;
} ref_point_t;

/* Semi-axes a >= b; angle of the major axis from +x towards +y, radians, [0, pi). */
typedef struct {
    double cx;
    double cy;
    double a;
    double b;
    double angle;
} ref_ellipse_t;

/* A x^2 + 2B xy + C y^2 + 2D x + 2E y + F in normalised coordinates
 * u = (x - mean_x) / scale; RMS distance of the points from their mean is 1. */
typedef struct {
    ref_real_t theta[6];
    ref_real_t mean_x;
    ref_real_t mean_y;
    ref_real_t scale;
} ref_conic_t;

typedef enum {
    REF_B2AC = 0,       /* Fitzgibbon, Pilu, Fisher 1999, by the 3x3 reduction of Halir and
                           Flusser 1998: minimise the algebraic distance, AC - B^2 = 1 */
    REF_TAUBIN,         /* Taubin 1991 */
    REF_TAUBIN_SHIFTED, /* Taubin's, the constant moved so that mean F = lambda (A + C): equal to
                           semi-hyper to first order of lambda */
    REF_HYPER_SEMI,     /* Kanatani, Rangarajan 2011: N = N_T + 2 S[xi_c e^T] */
    REF_HYPER,          /* the same with the 1/N terms */
    REF_METHODS
} ref_method_t;

const char *ref_method_name(ref_method_t method);

/* The conic that the method gives; false when the points are collinear, coincident
 * or fewer than five, or when B2AC has no ellipse. */
bool ref_fit_conic(ref_method_t method, const ref_point_t *points, size_t count,
                   ref_conic_t *conic);

/* Centre, semi-axes and angle; false when the conic is no real ellipse. */
bool ref_conic_ellipse(const ref_conic_t *conic, ref_ellipse_t *ellipse);

/* Both in one. */
bool ref_fit(ref_method_t method, const ref_point_t *points, size_t count, ref_ellipse_t *ellipse);

/* The LCSE perturbation (Greggio et al. 2011, eqs. 11-13) of all points: Maini's map
 * of their box to [-1, 1]^2, rho + 0.001 sin(2 pi 1000 theta) with theta rounded
 * to 2^-32 of a turn, and back.  Where theta is near 0 the perturbation jumps, so
 * points within 1e-6 of the +x axis of that frame are no test of anything. */
void ref_lcse_perturb(const ref_point_t *points, size_t count, ref_point_t *perturbed);

/* Taubin's approximation of the RMS distance of the points from the conic:
 * sqrt(sum F^2 / sum |grad F|^2), pixels. */
double ref_rms(const ref_conic_t *conic, const ref_point_t *points, size_t count);

/* B2AC as its textbooks print it, in double: eigenvalues of S^-1 C for the 6x6
 * scatter matrix S of the normalised points, "the one positive eigenvalue".
 * false when there is none, or more than one: on points that lie exactly on an
 * ellipse that eigenvalue is 1/0 and its sign is the sign of a rounding error. */
bool ref_fit_b2ac_strict(const ref_point_t *points, size_t count, ref_ellipse_t *ellipse);

/* A point of the ellipse at eccentric angle t. */
ref_point_t ref_ellipse_point(const ref_ellipse_t *ellipse, double t);

/* The Kanatani-Cramer-Rao bound on the RMS error of the centre, for points at the
 * eccentric angles t[0 .. count-1] of the ellipse, each with independent normal
 * noise of sigma in x and in y: sqrt(trace) of the centre's block of the inverse
 * Fisher matrix, to which each point adds along the ellipse's normal only. */
double ref_kcr_centre(const ref_ellipse_t *ellipse, const double *t, size_t count, double sigma);

/* Eigenvalues and eigenvectors of a symmetric n x n matrix, n <= 6, by cyclic
 * Jacobi: value[k] belongs to column k of vector.  The matrix is destroyed. */
void ref_jacobi(int n, ref_real_t matrix[6][6], ref_real_t value[6], ref_real_t vector[6][6]);

#ifdef __cplusplus
}
#endif

#endif
