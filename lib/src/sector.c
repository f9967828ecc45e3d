/* SPDX-License-Identifier: MIT */
#include "sector.h"

#include <stdbool.h>

uint32_t ocel_sectors_covered(uint32_t hit, uint32_t gap) {
    uint32_t covered = 0U;
    uint32_t empty = 0U;
    bool started = false;
    uint32_t i;

    for (i = 0U; i < (2U * OCEL_SECTORS); i++) { /* bound: two turns */
        if ((hit & (1U << (i % OCEL_SECTORS))) != 0U) {
            if (started && (i >= OCEL_SECTORS) && (empty <= gap)) {
                covered += empty;
            }
            covered += (i >= OCEL_SECTORS) ? 1U : 0U;
            empty = 0U;
            started = true;
        } else {
            empty++;
        }
    }
    return covered;
}
