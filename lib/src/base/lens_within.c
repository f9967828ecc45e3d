/* SPDX-License-Identifier: MIT
 *
 * Apart from lens.c, whose steps would each hold a copy of it.
 */
#include "lens.h"

/* |v| <= tan 80 by one comparison: what is below -tan 80 wraps to beyond the span. */
static bool is_seen(int64_t v_q28) {
    return ((uint64_t)v_q28 + (uint64_t)OCEL_TAN_80_Q28) <= (2U * (uint64_t)OCEL_TAN_80_Q28);
}

/* The squares are taken only of slopes within 80 degrees, which makes each 2^61.1 at
 * most. */
bool ocel_lens_within(const int64_t xy_q28[2], int64_t reach_q56) {
    bool within = is_seen(xy_q28[0]) && is_seen(xy_q28[1]);

    if (within) {
        const int32_t x_q28 = (int32_t)xy_q28[0];
        const int32_t y_q28 = (int32_t)xy_q28[1];

        within = (((int64_t)x_q28 * x_q28) + ((int64_t)y_q28 * y_q28)) <= reach_q56;
    }
    return within;
}
