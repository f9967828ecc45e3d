/* SPDX-License-Identifier: MIT */
#include "seconds.h"

#include "int_math.h"
#include "q60.h"
#include "scale.h"

#define LARGEST OCEL_Q60_ONE

/* a is shifted up to 60 bits first, so that the product, which drops its lower
 * 60, drops nothing of weight; the product is within 2^60 then (2^61 2^61 / 2^60
 * halved by |a| 2^n < 2^61), so it fits whatever b is. */
int64_t ocel_times(int64_t a, int64_t b, int32_t e) {
    const int32_t n = (int32_t)ocel_clz64(ocel_abs64(a) | 1U) - 3;
    const int64_t product = ocel_mul_q60(ocel_shl64(a, (uint32_t)n), b);
    const int32_t shift = (e + 60) - n;
    int64_t result;

    if ((shift > 0) && ((ocel_abs64(product) >> (uint32_t)(60 - shift)) != 0U)) {
        result = (product < 0) ? -LARGEST : LARGEST;
    } else {
        /* Below 2^-62 there is nothing left but the rounding of an LSB. */
        result = ocel_scale_q60(product, (shift < -62) ? -62 : shift);
    }
    return result;
}

int64_t ocel_clamp64(int64_t v, int64_t limit) {
    int64_t result = v;

    if (v > limit) {
        result = limit;
    } else if (v < -limit) {
        result = -limit;
    } else {
        result = v;
    }
    return result;
}

void ocel_add_product(int64_t *sum, int64_t a, int64_t b_q47) {
    *sum = ocel_clamp64(*sum + ocel_times(a, b_q47, -OCEL_SECONDS_BITS), LARGEST);
}
