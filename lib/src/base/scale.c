/* SPDX-License-Identifier: MIT */
#include "scale.h"

#include "int_math.h"

/* A call and not inline: on a 32-bit core a 64-bit shift by a variable is some
 * twenty instructions, and the fit has forty of them. */
int64_t ocel_scale_q60(int64_t value, int32_t e) {
    return (e >= 0) ? ocel_shl64(value, (uint32_t)e) : ocel_shift_round64(value, (uint32_t)(-e));
}
