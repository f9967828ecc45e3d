/* SPDX-License-Identifier: MIT
 *
 * Numbers that are scaled together.
 */
#ifndef OCELLUS_SCALE_ALL_H
#define OCELLUS_SCALE_ALL_H

#include <stdint.h>

/* v[i] * 2^e, as ocel_scale_q60 has it; count 1..OCEL_MAX_VECTOR. */
void ocel_scale_all(int64_t *v, uint32_t count, int32_t e);

/* Brings the largest of them, which is not 0, to `bits` bits; returns by how many it was
 * shifted down, so that the numbers were v[i] * 2^that. */
int32_t ocel_normalise(int64_t *v, uint32_t count, int32_t bits);

#endif
