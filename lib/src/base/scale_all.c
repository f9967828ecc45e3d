/* SPDX-License-Identifier: MIT
 *
 * Apart from scale.c, whose function the compiler would copy into these.
 */
#include "scale_all.h"

#include "int_math.h"
#include "scale.h"

void ocel_scale_all(int64_t *v, uint32_t count, int32_t e) {
    /* bound: OCEL_MAX_VECTOR; 2 each time in a call of ocel_polar */
    for (uint32_t i = 0U; i < count; i++) {
        v[i] = ocel_scale_q60(v[i], e);
    }
}

int32_t ocel_normalise(int64_t *v, uint32_t count, int32_t bits) {
    const int32_t e = ocel_bits_of(v, count) - bits;

    ocel_scale_all(v, count, -e);
    return e;
}
