/* SPDX-License-Identifier: MIT
 *
 * Radial and decentering distortion: Brown, "Decentering distortion of lenses",
 * Photogrammetric Engineering 32 (1966); order and signs are OpenCV's.
 *
 * It is undone by Newton's method on its two equations.  The first step divides
 * by the radial factor alone (OpenCV's iteration, which is Newton's with another
 * Jacobian): a start from which no lens of practice overshoots.  That iteration by
 * itself is slow where a lens is strong and diverges farther out: k1 = -.35,
 * k2 = .12 at f = 300 px leave a seventh of a 640x480 image over 1/64 px after
 * twelve steps, Newton's method nothing after four.
 */
#include "lens.h"

#include <ocellus/config.h>

#include "int_math.h"
#include "q60.h"
#include "scale.h"

/* Where the radial map is tried for a fold: tangents of i / 64, i < 363, which is
 * up to 80 degrees. */
#define REACH_TRIPS 363U

/* 1/64 px as the product of a slope in Q40 and a focal length in Q16. */
#define TOLERANCE_Q56 ((uint64_t)0x4000000000000)

/* What a step takes: elements of the Jacobian within 64 and differences within 4, both
 * 2^30 here, and a determinant of 2^-16 or more. */
#define JOINED_MAX ((uint64_t)0x40000000)
#define DETERMINANT_MIN_Q48 ((int64_t)65536 * 65536)

/* Elements of a Jacobian, which is symmetric. */
enum { J_XX = 0, J_YY, J_XY, J_COUNT };

/* Where the lens puts a ray, and how that moves with the ray. */
typedef struct {
    int64_t xy_q40[2];
    int64_t j_q40[J_COUNT];
    int64_t factor_q40; /* the radial factor, and its derivative by r^2 */
    int64_t derivative_q40;
} bent_t;

/* a * b to 2^-35: |a| <= 32.2 and |b| < 2^20, the product within 2^22. */
static int64_t times_q40(int64_t a_q55, int64_t b_q40) {
    return ocel_shl64(ocel_mul_q60(a_q55, b_q40), 5U);
}

/* The radial factor 1 + k1 s + k2 s^2 + k3 s^3 and its derivative, s = r^2, both
 * by Horner.  With s <= 32.2 and coefficients within 16 the factor is below 2^19.1
 * and the derivative below 2^15.7. */
static void radial(const ocel_intrinsics_t *lens, int64_t s_q55, int64_t *factor_q40,
                   int64_t *derivative_q40) {
    const int32_t k_q24[3] = {lens->k2_q24, lens->k1_q24, 0x1000000};
    int64_t value = (int64_t)lens->k3_q24 * 65536;
    int64_t slope = 0;

    for (uint32_t i = 0U; i < 3U; i++) { /* bound: 3 */
        slope = times_q40(s_q55, slope) + value;
        value = times_q40(s_q55, value) + ((int64_t)k_q24[i] * 65536);
    }
    *factor_q40 = value;
    *derivative_q40 = slope;
}

/* The slope of the radial map r * factor along r is factor + 2 s derivative, below
 * 2^22. */
static bool rises(const ocel_intrinsics_t *lens, uint32_t trip) {
    const int64_t s_q55 = (int64_t)trip * (int64_t)trip * (int64_t)0x80000000000;
    int64_t factor_q40;
    int64_t derivative_q40;

    radial(lens, s_q55, &factor_q40, &derivative_q40);
    return (factor_q40 + (2 * times_q40(s_q55, derivative_q40))) > 0;
}

int64_t ocel_lens_reach_q56(const ocel_intrinsics_t *lens) {
    int64_t reach_q56 = OCEL_TAN2_80_Q56;
    uint32_t trip = 1U;

    while ((trip < REACH_TRIPS) && rises(lens, trip)) { /* bound: REACH_TRIPS = 363 */
        trip++;
    }
    if (trip < REACH_TRIPS) {
        const uint32_t last = trip - 1U;

        reach_q56 = (int64_t)last * (int64_t)last * (int64_t)0x100000000000;
    }
    return reach_q56;
}

/* x * v: |x| <= 5.7 and |v| < 2^20, the product within 2^22; to 2^-37. */
static int64_t times_slope_q40(int64_t x_q28, int64_t v_q40) {
    return ocel_shl64(ocel_mul_q60(ocel_shl64(x_q28, 29U), v_q40), 3U);
}

/* x^2 + y^2, at most 32.2. */
static int64_t square_q55(const int64_t xy_q28[2]) {
    return ocel_asr64((xy_q28[0] * xy_q28[0]) + (xy_q28[1] * xy_q28[1]), 1U);
}

/* The lens's radial part; apart from `bend`, which goes on from it, so that their frames
 * are not on the stack together. */
static void bend_radially(const ocel_intrinsics_t *lens, const int64_t xy_q28[2], bent_t *bent) {
    radial(lens, square_q55(xy_q28), &bent->factor_q40, &bent->derivative_q40);
}

/* With s = x^2 + y^2, l = p2 x + p1 y, f the radial factor and g = f + 2 l, the lens
 * is x' = g x + p2 s, y' = g y + p1 s, and its Jacobian
 *   g I + 2 f' (x, y)(x, y)' + 2 ((x, y)(p2, p1)' + (p2, p1)(x, y)').
 * Within 80 degrees: |l| <= 129, in Q52 below 2^59.1; g < 2^19.2; x' within 2^21.7;
 * x f' within 2^18.2 and the Jacobian within 2^22. */
static void bend(const ocel_intrinsics_t *lens, const int64_t xy_q28[2], bent_t *bent) {
    const int32_t p_q24[2] = {lens->p2_q24, lens->p1_q24};
    const int64_t s_q55 = square_q55(xy_q28);
    const int64_t g_q40 =
        bent->factor_q40 + ocel_asr64((xy_q28[0] * p_q24[0]) + (xy_q28[1] * p_q24[1]), 11U);
    int64_t turned_q40 = 0;

    for (uint32_t i = 0U; i < 2U; i++) { /* bound: 2 */
        const int64_t x_q28 = xy_q28[i];

        turned_q40 = times_slope_q40(x_q28, bent->derivative_q40);
        bent->xy_q40[i] =
            times_slope_q40(x_q28, g_q40) + times_q40(s_q55, (int64_t)p_q24[i] * 65536);
        bent->j_q40[i] =
            g_q40 + (2 * times_slope_q40(x_q28, turned_q40)) + ocel_asr64(x_q28 * p_q24[i], 10U);
    }
    bent->j_q40[J_XY] = (2 * times_slope_q40(xy_q28[0], turned_q40)) +
                        ocel_asr64((xy_q28[0] * p_q24[1]) + (xy_q28[1] * p_q24[0]), 11U);
}

void ocel_lens_bend(const ocel_intrinsics_t *lens, const int64_t xy_q28[2], int64_t bent_q40[2]) {
    bent_t bent;

    bend_radially(lens, xy_q28, &bent);
    bend(lens, xy_q28, &bent);
    bent_q40[0] = bent.xy_q40[0];
    bent_q40[1] = bent.xy_q40[1];
}

/* One step: xy += J^-1 d, d the difference that is left.  The last bits of J only
 * decide how fast the steps converge, so it is taken in Q24, within 64; d in Q28,
 * within 4.  A product of two is below 2^60, their sums below 2^61; the determinant in
 * Q48 is det / 2^12 in Q60, and with its inverse y 2^e, e <= 28,
 *   J^-1 d = adj(J) d * y * 2^(e - 12),
 * from Q52 to Q28 a right shift by 8 or more.  A larger difference or a determinant
 * below 2^-16, at a fold, is given up. */
static bool step(const bent_t *bent, const int32_t target_q28[2], int64_t xy_q28[2]) {
    int32_t j_q24[J_COUNT]; /* these two of no use unless `joined` is small */
    int32_t d_q28[2];
    uint64_t joined = 0U;
    bool good;

    for (uint32_t i = 0U; i < (uint32_t)J_COUNT; i++) { /* bound: J_COUNT = 3 */
        const int64_t j = ocel_asr64(bent->j_q40[i], 16U);

        j_q24[i] = (int32_t)(uint32_t)j;
        joined |= ocel_abs64(j);
    }
    for (uint32_t i = 0U; i < 2U; i++) { /* bound: 2 */
        const int64_t d = target_q28[i] - ocel_shift_round64(bent->xy_q40[i], 12U);

        d_q28[i] = (int32_t)(uint32_t)d;
        joined |= ocel_abs64(d);
    }
    good = joined < JOINED_MAX;
    if (good) {
        const int64_t determinant_q48 =
            ((int64_t)j_q24[J_XX] * j_q24[J_YY]) - ((int64_t)j_q24[J_XY] * j_q24[J_XY]);
        uint32_t y_q31;
        int32_t e;

        ocel_recip_short(ocel_abs64(determinant_q48), &y_q31, &e);
        good = determinant_q48 >= DETERMINANT_MIN_Q48;
        for (uint32_t i = 0U; good && (i < 2U); i++) { /* bound: 2 */
            const int64_t product_q52 =
                ((int64_t)j_q24[1U - i] * d_q28[i]) - ((int64_t)j_q24[J_XY] * d_q28[1U - i]);

            xy_q28[i] +=
                ocel_scale_q60(ocel_mul_q60(product_q52, (int64_t)y_q31 * 0x20000000), e - 36);
        }
    }
    return good && ocel_lens_within(xy_q28, OCEL_TAN2_80_Q56);
}

/* Within 1/64 px: below 2^31 the product by a focal length is below 2^61, from there
 * on it is over 1/64 px for the shortest, 16 px. */
static bool came_back(const ocel_intrinsics_t *lens, const bent_t *bent,
                      const int32_t target_q28[2]) {
    const int32_t focal_px_q16[2] = {lens->fx_px_q16, lens->fy_px_q16};
    bool back = true;

    for (uint32_t i = 0U; i < 2U; i++) { /* bound: 2 */
        const uint64_t off_q40 = ocel_abs64(bent->xy_q40[i] - ocel_shl64(target_q28[i], 12U));

        back = back && (off_q40 < 0x80000000U) &&
               ((off_q40 * (uint64_t)focal_px_q16[i]) <= TOLERANCE_Q56);
    }
    return back;
}

bool ocel_lens_unbend(const ocel_intrinsics_t *lens, int64_t xy_q28[2]) {
    const int32_t target_q28[2] = {(int32_t)xy_q28[0], (int32_t)xy_q28[1]};
    bool good = ocel_lens_within(xy_q28, OCEL_TAN2_80_Q56); /* so target fits */
    bent_t bent;

    /* bound: OCEL_UNDISTORT_STEPS */
    for (uint32_t i = 0U; good && (i < (uint32_t)OCEL_UNDISTORT_STEPS); i++) {
        bend_radially(lens, xy_q28, &bent);
        bend(lens, xy_q28, &bent);
        if (i == 0U) { /* the radial factor alone */
            bent.j_q40[J_XX] = bent.factor_q40;
            bent.j_q40[J_YY] = bent.factor_q40;
            bent.j_q40[J_XY] = 0;
        }
        good = step(&bent, target_q28, xy_q28);
    }
    if (good) {
        bend_radially(lens, xy_q28, &bent);
        bend(lens, xy_q28, &bent);
        good = came_back(lens, &bent, target_q28);
    }
    return good;
}
