/* SPDX-License-Identifier: MIT */
#include "seconds.h"

#include "../base/q60.h"

int64_t ocel_clamp64(int64_t v, int64_t limit) {
    const int64_t low = (v < -limit) ? -limit : v;

    return (low > limit) ? limit : low;
}

void ocel_add_product(int64_t *sum, int64_t a, int64_t b_q47) {
    *sum = ocel_clamp64(*sum + ocel_times(a, b_q47, -OCEL_SECONDS_BITS), OCEL_Q60_ONE);
}
