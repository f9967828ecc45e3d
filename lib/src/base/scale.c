/* SPDX-License-Identifier: MIT */
#include "scale.h"

#include "int_math.h"

/* A call and not inline: on a 32-bit core a 64-bit shift by a variable is some
 * twenty instructions, and the fit has forty of them.  The right shift is by one less,
 * then by one with its rounding: floor((floor(v / 2^(n-1)) + 1) / 2), which is
 * floor(v / 2^n + 1/2), by one shift that varies. */
int64_t ocel_scale_q60(int64_t value, int32_t e) {
    return (e >= 0) ? ocel_shl64(value, (uint32_t)e)
                    : ocel_asr64(ocel_asr64(value, (uint32_t)(-1 - e)) + 1, 1U);
}
