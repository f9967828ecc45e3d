/* SPDX-License-Identifier: MIT
 *
 * The version: its only home.  CMake and the command line read it from here.
 */
#ifndef OCELLUS_VERSION_H
#define OCELLUS_VERSION_H

#define OCEL_VERSION_MAJOR 0
#define OCEL_VERSION_MINOR 1
#define OCEL_VERSION_PATCH 0
#define OCEL_VERSION_STRING "0.1.0"

#endif
