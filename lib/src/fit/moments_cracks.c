/* SPDX-License-Identifier: MIT
 *
 * Moments of boundary cracks: exact sums in half pixels, in one pass.
 */
#include "../base/int_math.h"
#include "../base/scale.h"
#include "../base/word.h"
#include "moments.h"

/* Sums of squares below 2^31 make every square so, and every quartic sum at most
 * their product, 2^62.  A disc of radius R sums to 16 R^3: R < 512 px. */
#define SQUARES_MAX ((int64_t)2147483648)

/* A product of two offsets, in a machine word, and one of two of those: of factors that
 * are seen to be 32 bits a 32-bit core makes a product and its sum in one instruction,
 * where a 64-bit one would take two more to make them 32 bits. */
#if OCEL_WORD_BITS == 64
typedef int64_t word_t;

static inline word_t times(word_t a, word_t b) {
    return a * b;
}

static inline uint64_t product(word_t a, word_t b) {
    return (uint64_t)a * (uint64_t)b;
}
#else
typedef int32_t word_t;

/* The low 32 bits: exact where |a * b| < 2^31. */
static inline word_t times(word_t a, word_t b) {
    return (word_t)((uint32_t)a * (uint32_t)b);
}

static inline uint64_t product(word_t a, word_t b) {
    return (uint64_t)((int64_t)a * b);
}
#endif

/* Sums of u^i v^j, u and v the offsets from (x0, y0), |.| < 2^16: sums of the first
 * order are below 2^30; squares below 2^32 and their sums, which are exact, below 2^46.
 * Where those are below SQUARES_MAX, so is every square and the sum of u v, and the
 * other products are below 2^62; where not, the caller refuses the rest, which is taken
 * modulo 2^32 and 2^64, so nothing overflows. */
static void sum_cracks(const ocel_crack_t *cracks, size_t count, word_t x0, word_t y0,
                       int64_t *sum) {
    word_t s_x = 0;
    word_t s_y = 0;
    ocel_word_t s_xy = 0U;
    uint64_t s_xx = 0U;
    uint64_t s_yy = 0U;
    uint64_t s_xxx = 0U;
    uint64_t s_xxy = 0U;
    uint64_t s_xyy = 0U;
    uint64_t s_yyy = 0U;
    uint64_t s_xxxx = 0U;
    uint64_t s_xxxy = 0U;
    uint64_t s_xxyy = 0U;
    uint64_t s_xyyy = 0U;
    uint64_t s_yyyy = 0U;
    const ocel_crack_t *crack = cracks;
    size_t left = count;

    /* bound: OCEL_MAX_FIT_POINTS; OCEL_MAX_CRACKS each time in a call of ocel_eye_end or
     * ocel_eye_refit */
    do {
        const word_t x = crack->x_hpx - x0;
        const word_t y = crack->y_hpx - y0;
        const word_t xx = times(x, x);
        const word_t xy = times(x, y);
        const word_t yy = times(y, y);

        s_x += x;
        s_y += y;
        s_xy += (ocel_word_t)xy;
        s_xx += (ocel_word_t)xx;
        s_yy += (ocel_word_t)yy;
        s_xxx += product(xx, x);
        s_xxy += product(xx, y);
        s_xyy += product(yy, x);
        s_yyy += product(yy, y);
        s_xxxx += product(xx, xx);
        s_xxxy += product(xx, xy);
        s_xxyy += product(xx, yy);
        s_xyyy += product(xy, yy);
        s_yyyy += product(yy, yy);
        crack++;
        left--;
    } while (left > 0U);
    sum[OCEL_M_1] = (int64_t)count;
    sum[OCEL_M_X] = s_x;
    sum[OCEL_M_Y] = s_y;
    sum[OCEL_M_XX] = (int64_t)s_xx;
    sum[OCEL_M_XY] = (word_t)s_xy;
    sum[OCEL_M_YY] = (int64_t)s_yy;
    sum[OCEL_M_XXX] = (int64_t)s_xxx;
    sum[OCEL_M_XXY] = (int64_t)s_xxy;
    sum[OCEL_M_XYY] = (int64_t)s_xyy;
    sum[OCEL_M_YYY] = (int64_t)s_yyy;
    sum[OCEL_M_XXXX] = (int64_t)s_xxxx;
    sum[OCEL_M_XXXY] = (int64_t)s_xxxy;
    sum[OCEL_M_XXYY] = (int64_t)s_xxyy;
    sum[OCEL_M_XYYY] = (int64_t)s_xyyy;
    sum[OCEL_M_YYYY] = (int64_t)s_yyyy;
}

/* The frame of a box whose half-sides are 2^ex and 2^ey Q17 px: exact. */
static void frame_of_powers(ocel_solution_t *solution, uint32_t ex, uint32_t ey) {
    const uint32_t larger = (ex > ey) ? ex : ey;

    solution->q60[OCEL_F_SCALE_LOG2] = (int64_t)larger + 1; /* so that G is at most 1/2 */
    solution->q60[OCEL_F_G11] = ocel_scale_q60(1, 59 - (int32_t)(larger - ex));
    solution->q60[OCEL_F_G21] = 0;
    solution->q60[OCEL_F_G22] = ocel_scale_q60(1, 59 - (int32_t)(larger - ey));
}

/* The scale exponent of one axis: the least e with sum_4 <= 2^(4 e + en), so
 * that the mean fourth power is at most 1 and with it, by Hoelder's inequality,
 * every mixed moment. */
static uint32_t exponent(int64_t sum_4, uint32_t en) {
    const uint32_t bits = ocel_ceil_log2((uint64_t)sum_4 + 1U);

    return (bits > en) ? (((bits - en) + 3U) / 4U) : 0U;
}

bool ocel_moments_of_cracks(const ocel_crack_t *cracks, size_t count, ocel_solution_t *solution) {
    const ocel_crack_t *const first = &cracks[0];
    const ocel_crack_t *const middle = &cracks[count / 2U];
    const int32_t x0 = ocel_asr32((int32_t)first->x_hpx + middle->x_hpx, 1U);
    const int32_t y0 = ocel_asr32((int32_t)first->y_hpx + middle->y_hpx, 1U);
    int64_t *const sum = &solution->q60[OCEL_F_MOMENTS];
    bool exact;

    sum_cracks(cracks, count, x0, y0, sum);
    exact = (sum[OCEL_M_XX] < SQUARES_MAX) && (sum[OCEL_M_YY] < SQUARES_MAX);
    if (exact) {
        const uint32_t en = ocel_ceil_log2(count);
        const uint32_t ex = exponent(sum[OCEL_M_XXXX], en);
        const uint32_t ey = exponent(sum[OCEL_M_YYYY], en);
        int64_t *moment = sum;

        /* Of each order those from x^n to y^n: the order of OCEL_M_*. */
        for (uint32_t order = 0U; order <= 4U; order++) { /* bound: 5 */
            uint32_t down = (ex * order) + en;            /* <= 65 */

            for (uint32_t j = 0U; j <= order; j++) { /* bound: 5 */
                *moment = ocel_scale_q60(*moment, 60 - (int32_t)down);
                down = (down + ey) - ex;
                moment++;
            }
        }
        solution->q60[OCEL_F_X0_Q24] = (int64_t)x0 * (int64_t)0x800000;
        solution->q60[OCEL_F_Y0_Q24] = (int64_t)y0 * (int64_t)0x800000;
        frame_of_powers(solution, ex + 16U, ey + 16U);
    }
    return exact;
}
