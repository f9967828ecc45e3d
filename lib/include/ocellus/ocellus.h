/* SPDX-License-Identifier: MIT
 *
 * ocellus: finds a ball in camera lines and fits its ellipse, in integers, in
 * bounded time and caller-owned memory.
 *
 * Conventions, said once:
 *  - Functions return ocel_status_t and write results through pointers; every
 *    status a function can return stands at the function with its cause.
 *  - A null pointer where one is required is OCEL_NULL_ARGUMENT, never a crash.
 *    Output parameters come last.  Inputs and outputs must not overlap.
 *  - Contexts are caller-owned structs without pointers inside: static, on a
 *    stack, copied, replayed.  The library has no state of its own, so any
 *    number of contexts may be used from any number of threads.
 *  - No heap, no recursion, no floating point, no I/O, no clock.  Every loop
 *    is bounded by a named constant or by the image.
 *  - Pixel (0,0) has its centre at (0,0), x right, y down.
 *  - The same input gives the same bits on every machine.
 */
#ifndef OCELLUS_OCELLUS_H
#define OCELLUS_OCELLUS_H

#include <ocellus/camera.h>
#include <ocellus/colour.h>
#include <ocellus/cone.h>
#include <ocellus/config.h>
#include <ocellus/eye.h>
#include <ocellus/fit.h>
#include <ocellus/gaze.h>
#include <ocellus/head.h>
#include <ocellus/label.h>
#include <ocellus/space.h>
#include <ocellus/sphere.h>
#include <ocellus/status.h>
#include <ocellus/stereo.h>
#include <ocellus/track.h>
#include <ocellus/tracker.h>
#include <ocellus/types.h>
#include <ocellus/version.h>

#endif
