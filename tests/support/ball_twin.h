/* SPDX-License-Identifier: MIT
 *
 * The library's cone fit in double on a scene's cracks: what fixed point costs.
 */
#ifndef SUPPORT_BALL_TWIN_H
#define SUPPORT_BALL_TWIN_H

#include "ball_scene.h"
#include "fit_support.h"
#include "reference/cone_reference.h"

/* The ball that it gives and how many cracks consented; false when it is not vouched for. */
static inline bool scene_twin(const ocel_crack_t *cracks, size_t count, scene_ball_t *ball,
                              size_t *inliers) {
    static ref_point_t points[OCEL_MAX_CRACKS];
    const ref_camera_t camera = {SCENE_F_PX, SCENE_F_PX, SCENE_CX_PX, SCENE_CY_PX};
    ref_cone_t cone;
    fit_cracks_to_points(cracks, count, points);
    const bool found = ref_cone_fit(&camera, points, count, true, &cone) && cone.vouched;
    ball->radius = SCENE_RADIUS_MM;
    *inliers = found ? cone.inliers : 0U;
    for (int i = 0; (i < 3) && found; i++) {
        ball->centre[i] = SCENE_RADIUS_MM / cone.sine * cone.axis[i];
    }
    return found;
}

#endif
