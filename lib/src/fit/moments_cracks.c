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

/* Powers of x and of y in each moment, in the order of OCEL_M_*. */
static const uint8_t power_x[OCEL_M_COUNT] = {0, 1, 0, 2, 1, 0, 3, 2, 1, 0, 4, 3, 2, 1, 0};
static const uint8_t power_y[OCEL_M_COUNT] = {0, 0, 1, 0, 1, 2, 0, 1, 2, 3, 0, 1, 2, 3, 4};

/* v as 32 bits, so that a 32-bit core multiplies in one instruction; exact for
 * |v| < 2^31, and a sum with another v is refused. */
static inline int64_t low_word(int64_t v) {
    return (int32_t)v;
}

/* An offset as it is subtracted: in a machine word, or the other kind of machine takes
 * two instructions more for each. */
#if OCEL_WORD_BITS == 64
typedef int64_t offset_t;
#else
typedef int32_t offset_t;
#endif

/* Sums of u^i v^j, u and v the offsets from (x0, y0), |.| < 2^16: |sums| of the first
 * order are below 2^30.  The products are below 2^62; the sums are taken modulo 2^64,
 * so nothing overflows here, and the caller asks the second-order ones, which are
 * exact, whether the others are.  (Of factors that are seen to be 32 bits a 32-bit
 * core makes a product and its sum in one instruction.) */
static void sum_cracks(const ocel_crack_t *cracks, size_t count, offset_t x0, offset_t y0,
                       int64_t *sum) {
    offset_t s_x = 0;
    offset_t s_y = 0;
    uint64_t s_xx = 0U;
    uint64_t s_xy = 0U;
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
    size_t i;

    /* bound: OCEL_MAX_FIT_POINTS; OCEL_MAX_CRACKS each time in a call of ocel_eye_end or
     * ocel_eye_refit */
    for (i = 0U; i < count; i++) {
        const int64_t x = low_word((offset_t)cracks[i].x_hpx - x0);
        const int64_t y = low_word((offset_t)cracks[i].y_hpx - y0);
        const int64_t xx = x * x;
        const int64_t yy = y * y;
        const int64_t xx_32 = low_word(xx);
        const int64_t xy_32 = low_word(x * y);
        const int64_t yy_32 = low_word(yy);

        s_x += (offset_t)x;
        s_y += (offset_t)y;
        s_xx += (uint64_t)xx;
        s_xy += (uint64_t)(x * y);
        s_yy += (uint64_t)yy;
        s_xxx += (uint64_t)(xx_32 * x);
        s_xxy += (uint64_t)(xx_32 * y);
        s_xyy += (uint64_t)(yy_32 * x);
        s_yyy += (uint64_t)(yy_32 * y);
        s_xxxx += (uint64_t)(xx_32 * xx_32);
        s_xxxy += (uint64_t)(xx_32 * xy_32);
        s_xxyy += (uint64_t)(xx_32 * yy_32);
        s_xyyy += (uint64_t)(xy_32 * yy_32);
        s_yyyy += (uint64_t)(yy_32 * yy_32);
    }
    sum[OCEL_M_1] = (int64_t)count;
    sum[OCEL_M_X] = s_x;
    sum[OCEL_M_Y] = s_y;
    sum[OCEL_M_XX] = (int64_t)s_xx;
    sum[OCEL_M_XY] = (int64_t)s_xy;
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
static void frame_of_powers(ocel_frame_t *frame, uint32_t ex, uint32_t ey) {
    const uint32_t larger = (ex > ey) ? ex : ey;

    frame->scale_log2 = (int32_t)larger + 1; /* so that G is at most 1/2 */
    frame->g11_q60 = ocel_shl64(1, 59U - (larger - ex));
    frame->g21_q60 = 0;
    frame->g22_q60 = ocel_shl64(1, 59U - (larger - ey));
}

/* The scale exponent of one axis: the least e with sum_4 <= 2^(4 e + en), so
 * that the mean fourth power is at most 1 and with it, by Hoelder's inequality,
 * every mixed moment. */
static uint32_t exponent(uint64_t sum_4, uint32_t en) {
    const uint32_t bits = 64U - ocel_clz64(sum_4);

    return (bits > en) ? (((bits - en) + 3U) / 4U) : 0U;
}

bool ocel_moments_of_cracks(const ocel_crack_t *cracks, size_t count, ocel_moments_t *moments,
                            ocel_frame_t *frame) {
    const ocel_crack_t *const first = &cracks[0];
    const ocel_crack_t *const middle = &cracks[count / 2U];
    const int32_t x0 = ocel_asr32((int32_t)first->x_hpx + middle->x_hpx, 1U);
    const int32_t y0 = ocel_asr32((int32_t)first->y_hpx + middle->y_hpx, 1U);
    const uint32_t en = ocel_ceil_log2(count);
    int64_t *const sum = moments->m_q60;
    bool exact;

    sum_cracks(cracks, count, x0, y0, sum);
    exact = (sum[OCEL_M_XX] < SQUARES_MAX) && (sum[OCEL_M_YY] < SQUARES_MAX);
    if (exact) {
        const uint32_t ex = exponent((uint64_t)sum[OCEL_M_XXXX], en);
        const uint32_t ey = exponent((uint64_t)sum[OCEL_M_YYYY], en);
        uint32_t i;

        for (i = 0U; i < (uint32_t)OCEL_M_COUNT; i++) { /* bound: OCEL_M_COUNT */
            const uint32_t down = (ex * power_x[i]) + (ey * power_y[i]) + en; /* <= 65 */

            sum[i] = ocel_scale_q60(sum[i], 60 - (int32_t)down);
        }
        frame->x0_px_q24 = (int64_t)x0 * (int64_t)0x800000;
        frame->y0_px_q24 = (int64_t)y0 * (int64_t)0x800000;
        frame_of_powers(frame, ex + 16U, ey + 16U);
    }
    return exact;
}
