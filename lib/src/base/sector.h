/* SPDX-License-Identifier: MIT
 *
 * The turn in 32 sectors: how much of an outline its points cover.
 */
#ifndef OCELLUS_SECTOR_H
#define OCELLUS_SECTOR_H

#include <stdbool.h>
#include <stdint.h>

#include "int_math.h"

/* Sectors into which the turn is divided, from +x towards +y. */
#define OCEL_SECTORS 32U

/* tan of 1/32, 2/32 and 3/32 of a turn, Q16. */
#define OCEL_TAN_1_Q16 13036U
#define OCEL_TAN_2_Q16 27146U
#define OCEL_TAN_3_Q16 43790U

/* The sector, 0..31, of a direction; |x|, |y| <= 2^31.  An eighth of a turn is
 * counted from the nearer axis; each fold mirrors the count. */
static inline uint32_t ocel_sector_of(int64_t x, int64_t y) {
    const uint32_t ax = (uint32_t)ocel_abs64(x);
    const uint32_t ay = (uint32_t)ocel_abs64(y);
    const uint32_t large = (ax < ay) ? ay : ax;
    const uint64_t small_q16 = (uint64_t)((ax < ay) ? ax : ay) * 65536U;
    const uint32_t fold =
        ((ax < ay) ? 7U : 0U) ^ ((uint32_t)ocel_sign64(x) & 15U) ^ ((uint32_t)ocel_sign64(y) & 31U);
    uint32_t sector = 0U;

    sector += (small_q16 >= ((uint64_t)large * OCEL_TAN_1_Q16)) ? 1U : 0U;
    sector += (small_q16 >= ((uint64_t)large * OCEL_TAN_2_Q16)) ? 1U : 0U;
    sector += (small_q16 >= ((uint64_t)large * OCEL_TAN_3_Q16)) ? 1U : 0U;
    return sector ^ fold;
}

/* Sectors covered, 0..32: those whose bit is set in `hit` and the gaps between
 * them that are no longer than `gap`, which so few points may leave in a covered
 * arc. */
uint32_t ocel_sectors_covered(uint32_t hit, uint32_t gap);

#endif
