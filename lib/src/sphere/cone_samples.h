/* SPDX-License-Identifier: MIT
 *
 * Samples of the points as unit vectors, in a frame that looks at the points:
 * (u, v, 1 - e), u and v in units of h and e of h^2 (cone_plane.h).
 */
#ifndef OCELLUS_CONE_SAMPLES_H
#define OCELLUS_CONE_SAMPLES_H

#include <stdbool.h>
#include <stdint.h>

#include "cone_frame.h"

/* |u|, |v| <= 3, e <= 4. */
typedef struct {
    int16_t u_q13[OCEL_CONE_SAMPLES];
    int16_t v_q13[OCEL_CONE_SAMPLES];
    int32_t e_q25[OCEL_CONE_SAMPLES];
} ocel_cone_samples_t;

/* False when the camera refuses a sample. */
bool ocel_cone_sample(const ocel_cone_source_t *source, const ocel_cone_place_t *place,
                      ocel_cone_samples_t *samples);

#endif
