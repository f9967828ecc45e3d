/* SPDX-License-Identifier: MIT */
#include "scale.h"

#if OCEL_WORD_BITS != 64
int64_t ocel_scale_q60(int64_t value, int32_t e) {
    return ocel_scale_here(value, e);
}
#endif
