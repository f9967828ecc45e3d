// SPDX-License-Identifier: MIT
//
// OpenGL as OSMesa exports it: no loader, no window system.  Never link libGL
// beside it: its functions would be found first and do nothing.
#ifndef OCELLUS_SIM_GL_HPP
#define OCELLUS_SIM_GL_HPP

#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>

#include <GL/glext.h>

#endif
