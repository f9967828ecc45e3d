/* SPDX-License-Identifier: MIT
 *
 * Polar coordinates by CORDIC (Volder, "The CORDIC trigonometric computing
 * technique", IRE Trans. EC-8, 1959), sine and cosine by a polynomial on an
 * eighth of a turn.
 */
#include "trig.h"

#include "int_math.h"
#include "q60.h"
#include "scale.h"
#include "scale_all.h"

/* Micro-rotations by atan(2^-i).  14 of them leave an angle of at most
 * atan(2^-13), so small that a division finishes it (finish_vector): a 32-trip
 * CORDIC of the same accuracy costs twice as much. */
#define CORDIC_TRIPS 14U

/* The product of cos(atan(2^-i)), i 0..13: 0.60725..., the lengthening of a
 * vector by the micro-rotations, inverted. */
#define CORDIC_GAIN_Q60 ((int64_t)700114969246117569)

/* 1 / (2 pi) * 2^34: radians to turns. */
#define TURN_PER_RADIAN_Q34 ((int64_t)2734261102)

/* v if sign is 0, -v if it is -1.  |v| < 2^63. */
static int64_t negate_if(int64_t v, int64_t sign) {
    return (v ^ sign) - sign;
}

/* A vector on its way to the +x axis, and the angle it has turned so far. */
typedef struct {
    int64_t x;
    int64_t y;
    int64_t turn_q48;
} cordic_t;

/* Turns v, x >= 0, towards the +x axis: |y| <= 2^-13 x + 32 afterwards.
 * x, |y| < 2^59 in, so with the gain 1.6468 every value stays below
 * 1.6468 * sqrt(2) * 2^59 < 2^60.3.  The floor of each shift costs up to 1 LSB
 * in x and in y, 28 altogether: below 2^-53 of a vector of 2^58. */
static void cordic_vector(cordic_t *v) {
    /* atan(2^-i), 2^48 = a turn. */
    static const int64_t cordic_turn_q48[CORDIC_TRIPS] = {
        35184372088832, 20770547670515, 10974586953444, 5570871696862, 2796246208089,
        1399486241028,  699913886760,   349978300884,   174991820497,  87496244017,
        43748163730,    21874087080,    10937044192,    5468522177};
    int64_t x = v->x;
    int64_t y = v->y;
    int64_t turn_q48 = 0;

    for (uint32_t i = 0U; i < CORDIC_TRIPS; i++) { /* bound: CORDIC_TRIPS = 14 */
        const int64_t dx = ocel_asr64_short(y, i);
        const int64_t dy = ocel_asr64_short(x, i);

        if (y >= 0) {
            x += dx;
            y -= dy;
            turn_q48 += cordic_turn_q48[i];
        } else {
            x -= dx;
            y += dy;
            turn_q48 -= cordic_turn_q48[i];
        }
    }
    v->x = x;
    v->y = y;
    v->turn_q48 = turn_q48;
}

/* The angle that is left, t = y / x, |t| <= 2^-13 + 2^-53, in one step:
 *   atan(t) = t        but for t^3 / 3   < 2^-40 rad, 2^-43 turn
 *   hypot   = x + y t / 2 but for t^4 / 8 < 2^-55 of it
 * x is in [2^58, 2^60.3], so e is 0..2.  y / 2^17 is below 2^30.4, times the
 * inverse, at most 2^31: 2^61.4; t in Q43 is below 2^30.1. */
static void finish_vector(cordic_t *v) {
    const int64_t y_short = ocel_asr64(v->y, 17U);
    uint32_t inverse_q31;
    int32_t e;
    int32_t down;
    int64_t t_q43;

    ocel_recip_short((uint64_t)v->x, &inverse_q31, &e);
    down = 31 - e;
    t_q43 = ocel_asr64_short(y_short * (int64_t)inverse_q31, (uint32_t)down);
    v->x += ocel_asr64(y_short * t_q43, 43U - 17U + 1U);
    v->turn_q48 += ocel_asr64(t_q43 * TURN_PER_RADIAN_Q34, 43U + 34U - 48U);
}

void ocel_polar(int64_t x, int64_t y, int64_t *magnitude, uint32_t *turn_q32) {
    if ((x == 0) && (y == 0)) {
        *magnitude = 0;
        *turn_q32 = 0U;
    } else {
        /* The larger coordinate goes to [2^58, 2^59): small vectors are then
         * as exact as large ones. */
        int64_t xy[2] = {x, y};
        const int32_t down = ocel_normalise(xy, 2U, 59);
        /* CORDIC reaches +-99.9 degrees: the left half plane is turned by half
         * a turn first. */
        const int64_t flip = ocel_sign64(x);
        const uint32_t half_turn = (uint32_t)flip & 0x80000000U;
        cordic_t v = {negate_if(xy[0], flip), negate_if(xy[1], flip), 0};

        cordic_vector(&v);
        finish_vector(&v);
        *magnitude = ocel_scale_q60(ocel_mul_q60(v.x, CORDIC_GAIN_Q60), down);
        *turn_q32 =
            (uint32_t)((uint64_t)ocel_shift_round64(v.turn_q48, 16U) & 0xFFFFFFFFU) + half_turn;
    }
}

/* Minimax polynomials in s = w^2, w in [-1, 1], the angle in eighths of a
 * turn: sin(pi/4 w) / w to 3.4e-12 and cos(pi/4 w) to 4.7e-11; here their
 * first coefficients, the others in ocel_sincos. */
#define SIN_FIRST_Q32 ((int64_t)3373259426)
#define COS_FIRST_Q32 ((int64_t)4294967296)
#define EIGHTH_TURN_Q32 0x20000000U

/* c[0] s + c[1] s^2 + c[2] s^3 + c[3] s^4 in Q32, s_q31 in [0, 2^31].  Each
 * partial sum is below 0.31 in magnitude, so it fits in 32 bits and its
 * product by s in 62.  Roundings: half an LSB of Q32 each, four of them. */
static int64_t even_polynomial(const int32_t c[4], int64_t s_q31) {
    int64_t sum_q32 = c[3];

    sum_q32 = c[2] + ocel_shift_round64(sum_q32 * s_q31, 31U);
    sum_q32 = c[1] + ocel_shift_round64(sum_q32 * s_q31, 31U);
    sum_q32 = c[0] + ocel_shift_round64(sum_q32 * s_q31, 31U);
    return ocel_shift_round64(sum_q32 * s_q31, 31U);
}

void ocel_sincos(uint32_t turn_q32, int32_t *sin_q30, int32_t *cos_q30) {
    static const int32_t sin_coefficient_q32[4] = {-346799333, 10696157, -157077, 1327};
    static const int32_t cos_coefficient_q32[4] = {-1324675869, 68093808, -1399896, 15160};
    /* The nearest quarter turn, and what is left: [-2^29, 2^29), an eighth. */
    const uint32_t shifted = turn_q32 + EIGHTH_TURN_Q32;
    const uint32_t quarter = shifted >> 30U;
    const uint32_t within = shifted & 0x3FFFFFFFU;
    const int64_t w_q29 = (int64_t)within - (int64_t)EIGHTH_TURN_Q32;
    const int64_t s_q31 = ocel_asr64(w_q29 * w_q29, 27U);
    const int64_t ratio_q32 = SIN_FIRST_Q32 + even_polynomial(sin_coefficient_q32, s_q31);
    const int32_t sine = (int32_t)ocel_shift_round64(w_q29 * ratio_q32, 31U);
    const int64_t cosine_q32 = COS_FIRST_Q32 + even_polynomial(cos_coefficient_q32, s_q31);
    const int32_t cosine = (int32_t)ocel_shift_round64(cosine_q32, 2U);

    /* sin(x + q 90) and cos(x + q 90): odd quarters swap the two. */
    const int32_t sin_size = ((quarter & 1U) != 0U) ? cosine : sine;
    const int32_t cos_size = ((quarter & 1U) != 0U) ? sine : cosine;

    *sin_q30 = ((quarter & 2U) != 0U) ? -sin_size : sin_size;
    *cos_q30 = (((quarter + 1U) & 2U) != 0U) ? -cos_size : cos_size;
}
