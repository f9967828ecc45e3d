// SPDX-License-Identifier: MIT
//
// Where OpenGL 3.3 core comes from.  All drawing goes to framebuffer objects of
// the renderer's, so this is all that another source (EGL) would have to offer.
#ifndef OCELLUS_SIM_RENDER_CONTEXT_HPP
#define OCELLUS_SIM_RENDER_CONTEXT_HPP

#include <memory>

namespace sim {

class RenderContext {
  public:
    virtual ~RenderContext() = default;
    // Makes this the context of the GL calls that follow, in this thread.
    virtual void make_current() = 0;
};

// Draws on the CPU by OSMesa, in the calling thread only: processes are what
// runs in parallel here.  Pixels are then the same from run to run.
// std::runtime_error when there is none, or its GL does nothing.
std::unique_ptr<RenderContext> make_osmesa_context();

} // namespace sim

#endif
