/* SPDX-License-Identifier: MIT
 *
 * The product that tracker and gaze are made of.
 */
#ifndef OCEL_PRODUCT_H
#define OCEL_PRODUCT_H

#include <stdint.h>

/* a * b * 2^e, within +-2^60: what is larger becomes that.  |a|, |b| < 2^61,
 * -120 <= e <= 0.  Error: half an LSB, and what two LSB of b would make. */
int64_t ocel_times(int64_t a, int64_t b, int32_t e);

#endif
