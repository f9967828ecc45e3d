// SPDX-License-Identifier: MIT
#include "camera/render_context.hpp"

#include <array>
#include <cstdlib>
#include <stdexcept>

#include "camera/gl.hpp"

namespace sim {

namespace {

constexpr int kAttributes[] = {OSMESA_FORMAT,
                               OSMESA_RGBA,
                               OSMESA_DEPTH_BITS,
                               0,
                               OSMESA_PROFILE,
                               OSMESA_CORE_PROFILE,
                               OSMESA_CONTEXT_MAJOR_VERSION,
                               3,
                               OSMESA_CONTEXT_MINOR_VERSION,
                               3,
                               0};

class OsmesaContext : public RenderContext {
  public:
    OsmesaContext() {
        // llvmpipe would start a thread for each core.
        ::setenv("LP_NUM_THREADS", "0", 1);
        context_ = OSMesaCreateContextAttribs(kAttributes, nullptr);
        if (context_ == nullptr) {
            throw std::runtime_error("OSMesa gives no OpenGL 3.3 core context");
        }
        make_current();
        // With libGL linked before libOSMesa every call is an empty stub.
        if (glGetString(GL_VERSION) == nullptr) {
            throw std::runtime_error("OpenGL does nothing here: is libGL linked?");
        }
    }
    ~OsmesaContext() override {
        OSMesaDestroyContext(context_);
    }
    OsmesaContext(const OsmesaContext &) = delete;
    OsmesaContext &operator=(const OsmesaContext &) = delete;

    void make_current() override {
        if (OSMesaMakeCurrent(context_, buffer_.data(), GL_UNSIGNED_BYTE, 1, 1) != GL_TRUE) {
            throw std::runtime_error("OSMesa does not take its context");
        }
    }

  private:
    OSMesaContext context_;
    // OSMesa wants a buffer of its own, though nothing is drawn there.
    std::array<unsigned char, 4> buffer_{};
};

} // namespace

std::unique_ptr<RenderContext> make_osmesa_context() {
    return std::make_unique<OsmesaContext>();
}

} // namespace sim
