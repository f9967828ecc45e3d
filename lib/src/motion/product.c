/* SPDX-License-Identifier: MIT
 *
 * A file of its own, so that the sum of seconds.c calls it: it is some sixty
 * instructions on a 32-bit core.
 */
#include "product.h"

#include "../base/int_math.h"
#include "../base/q60.h"
#include "../base/scale.h"

#define LARGEST OCEL_Q60_ONE

/* a is shifted up to its 61 bits first, so that the product, which drops the lower
 * 60 of its own, drops nothing of weight; it is below 2^62 whatever b is. */
int64_t ocel_times(int64_t a, int64_t b, int32_t e) {
    const int32_t n = (int32_t)ocel_clz64(ocel_abs64(a) | 1U) - 3;
    const int64_t product = ocel_mul_q60(ocel_shl64(a, (uint32_t)n), b);
    const int32_t shift = (e + 60) - n;
    const int32_t room = (shift < -2) ? 62 : (60 - shift);
    int64_t result;

    if ((ocel_abs64(product) >> (uint32_t)room) != 0U) {
        result = (product < 0) ? -LARGEST : LARGEST;
    } else {
        /* A product below 2^62 leaves nothing after a shift by 63. */
        result = (shift < -62) ? 0 : ocel_scale_q60(product, shift);
    }
    return result;
}
