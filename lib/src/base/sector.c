/* SPDX-License-Identifier: MIT */
#include "sector.h"

uint32_t ocel_sectors_covered(uint32_t hit, uint32_t gap) {
    uint32_t covered = 0U;
    uint32_t empty = ocel_clz32(hit); /* before sector 0, the turn being closed */
    uint32_t i;

    for (i = 0U; i < OCEL_SECTORS; i++) { /* bound: OCEL_SECTORS = 32 */
        if ((hit & ((uint32_t)1U << i)) != 0U) {
            covered += 1U + ((empty <= gap) ? empty : 0U);
            empty = 0U;
        } else {
            empty++;
        }
    }
    return covered;
}
