// SPDX-License-Identifier: MIT
//
// One GLSL program, and its uniforms by name.
#ifndef OCELLUS_SIM_RENDERER_PROGRAM_HPP
#define OCELLUS_SIM_RENDERER_PROGRAM_HPP

#include "camera/drawing.hpp"

namespace sim {

using Mat4 = cv::Matx44d;

class Program {
  public:
    // For solids of a shape; with `lens` the rays come from a texture instead of
    // from the cube's corners.  std::runtime_error when it does not compile.
    Program(Shape shape, bool lens);
    ~Program();
    Program(const Program &) = delete;
    Program &operator=(const Program &) = delete;

    void use() const;
    void set(const char *name, int value) const;
    void set(const char *name, double value) const;
    void set(const char *name, const Vec3 &v) const;
    void set(const char *name, const Vec3 &v, double w) const;
    void set(const char *name, const Mat3 &m) const;
    void set(const char *name, const Mat4 &m) const;

  private:
    int place(const char *name) const;
    unsigned program_;
};

} // namespace sim

#endif
