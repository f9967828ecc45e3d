/* SPDX-License-Identifier: MIT
 *
 * The heads.  Sources: the paper's Tables 1 and 2 as facts of geometry (HZO = 3.01
 * the neck's height, EXO = 0.36, EZO = 3.50 the eyes' height above the floor, so
 * EZO - HZO = 0.49, EYD = 0.35, SMU); the iCub's published chain from the waist to
 * the eyes, versions 1 and 2, its torso's joints at 0.
 */
#include <ocellus/head.h>

#define ONE_Q30 ((int32_t)0x40000000)
#define QUARTER ((int32_t)0x40000000)

/* Whole degrees, |d| <= 100, rounded away from 0, so that the limit itself, however
 * the caller rounds it, is within: 2^32 / 360 is 11930464.7. */
#define DEGREES(d) ((int32_t)((d) * 11930465))

#define FIXED ((uint8_t)OCEL_JOINT_COUNT)

/* In the order of ocel_joint_t: pitch, roll, yaw, tilt, version, vergence.  The eyes'
 * vergence is limited by their pan. */
#define ICUB_MIN {DEGREES(-40), DEGREES(-70), DEGREES(-55), DEGREES(-35), DEGREES(-50), 0}
#define ICUB_MAX {DEGREES(30), DEGREES(60), DEGREES(55), DEGREES(15), DEGREES(50), DEGREES(100)}

/* Table 2 with d of L4 for the baseline and L5's d0 left to the target; the sixth link
 * turns the end's axes (x forward, y left, z up) into the camera's. */
const ocel_head_model_t ocel_head_paper = {
    {{{ONE_Q30, 0, 0}, {0, ONE_Q30, 0}, {0, 0, ONE_Q30}}, {0, 0, 0}},
    {{0, 3010000, 0, QUARTER, 0, FIXED, 0, 0},
     {0, 0, 0, -QUARTER, 0, (uint8_t)OCEL_NECK_PITCH, 1, 0},
     {360000, 490000, 0, QUARTER, 0, (uint8_t)OCEL_NECK_YAW, 1, 0},
     {0, 0, 175000, -QUARTER, 0, (uint8_t)OCEL_EYES_TILT, 1, 0},
     {0, 0, 0, 0, 0, (uint8_t)OCEL_EYES_VERSION, 1, 1},
     {0, 0, 0, -QUARTER, -QUARTER, FIXED, 0, 0},
     {0, 0, 0, 0, 0, FIXED, 0, 0},
     {0, 0, 0, 0, 0, FIXED, 0, 0}},
    6U,
    {DEGREES(-40), 0, DEGREES(-55), DEGREES(-35), DEGREES(-50), 0},
    {DEGREES(30), 0, DEGREES(55), DEGREES(15), DEGREES(50), DEGREES(100)},
    DEGREES(50)};

/* H0 = [0 -1 0; 0 0 -1; 1 0 0]: the base's x is up, its y forward, its z left. */
#define ICUB_BASE {{{0, -ONE_Q30, 0}, {0, 0, -ONE_Q30}, {ONE_Q30, 0, 0}}, {0, 0, 0}}

/* The eyes' baseline is 68 mm; the end's axes are the camera's already. */
#define ICUB_EYES                                                                                  \
    {0, 0, 34000, -QUARTER, 0, (uint8_t)OCEL_EYES_TILT, 1, 0},                                     \
        {0, 0, 0, QUARTER, -QUARTER, (uint8_t)OCEL_EYES_VERSION, 1, -1}

const ocel_head_model_t ocel_head_icub_v1 = {
    ICUB_BASE,
    {{32000, 0, 0, QUARTER, 0, FIXED, 0, 0},
     {0, -5500, 0, QUARTER, -QUARTER, FIXED, 0, 0},
     {2310, -193300, 0, -QUARTER, -QUARTER, FIXED, 0, 0},
     {33000, 0, 0, QUARTER, QUARTER, (uint8_t)OCEL_NECK_PITCH, 1, 0},
     {0, 1000, 0, -QUARTER, -QUARTER, (uint8_t)OCEL_NECK_ROLL, 1, 0},
     {-54000, 82500, 0, -QUARTER, QUARTER, (uint8_t)OCEL_NECK_YAW, 1, 0},
     ICUB_EYES},
    8U,
    ICUB_MIN,
    ICUB_MAX,
    DEGREES(50)};

const ocel_head_model_t ocel_head_icub_v2 = {
    ICUB_BASE,
    {{32000, 0, 0, QUARTER, 0, FIXED, 0, 0},
     {0, -5500, 0, QUARTER, -QUARTER, FIXED, 0, 0},
     {0, -223300, 0, -QUARTER, -QUARTER, FIXED, 0, 0},
     {9500, 0, 0, QUARTER, QUARTER, (uint8_t)OCEL_NECK_PITCH, 1, 0},
     {0, 0, 0, -QUARTER, -QUARTER, (uint8_t)OCEL_NECK_ROLL, 1, 0},
     {-50900, 82050, 0, -QUARTER, QUARTER, (uint8_t)OCEL_NECK_YAW, 1, 0},
     ICUB_EYES},
    8U,
    ICUB_MIN,
    ICUB_MAX,
    DEGREES(50)};
