/* SPDX-License-Identifier: MIT */
#include <ocellus/gaze.h>

/* Degrees as fractions of a turn. */
#define DEGREES_Q32(d) ((int32_t)((d) * 11930464))
#define DEGREES_Q24(d) ((int32_t)((d) * 46603))

/* An iCub's neck reaches 60 degrees a second and its eyes 180; accelerations are what
 * its controllers take without complaint, from motion of minimum jerk over .5 and .1 s. */
#define NECK_SPEED DEGREES_Q32(60)
#define EYE_SPEED (DEGREES_Q32(180) - 1)
#define NECK_ACCELERATION DEGREES_Q24(400)
#define EYE_ACCELERATION DEGREES_Q24(3000)

#define CONFIG(version_sign)                                                                       \
    {{1, 1, 1, 1, (version_sign), 1},                                                              \
     50000U,                                                                                       \
     {NECK_SPEED, NECK_SPEED, NECK_SPEED, EYE_SPEED, EYE_SPEED, EYE_SPEED},                        \
     {NECK_ACCELERATION, NECK_ACCELERATION, NECK_ACCELERATION, EYE_ACCELERATION, EYE_ACCELERATION, \
      EYE_ACCELERATION},                                                                           \
     DEGREES_Q32(40),                                                                              \
     DEGREES_Q32(1) / 50,                                                                          \
     8 * 65536,                                                                                    \
     16 * 65536,                                                                                   \
     DEGREES_Q32(2),                                                                               \
     2 * 65536}

const ocel_gaze_config_t ocel_gaze_paper = CONFIG(1);
const ocel_gaze_config_t ocel_gaze_icub = CONFIG(-1);
