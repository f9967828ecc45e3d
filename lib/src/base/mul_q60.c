/* SPDX-License-Identifier: MIT
 *
 * Apart from q60.c, whose functions would each hold a copy of it.
 */
#include "q60.h"

int64_t ocel_mul_q60_by_parts(int64_t a, int64_t b) {
    const int32_t ah = (int32_t)ocel_asr64(a, 30U);
    const int32_t bh = (int32_t)ocel_asr64(b, 30U);
    const int32_t al = (int32_t)(a & 0x3FFFFFFF);
    const int32_t bl = (int32_t)(b & 0x3FFFFFFF);
    int64_t middle = (int64_t)(((uint64_t)(uint32_t)al * (uint32_t)bl) >> 30U);

    middle += (int64_t)ah * bl;
    middle += (int64_t)al * bh;
    return ((int64_t)ah * bh) + ocel_asr64(middle, 30U);
}
