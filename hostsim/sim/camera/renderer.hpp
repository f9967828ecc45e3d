// SPDX-License-Identifier: MIT
//
// Draws what a camera sees: pinhole or lens, at once or as its shutter goes.
#ifndef OCELLUS_SIM_RENDERER_HPP
#define OCELLUS_SIM_RENDERER_HPP

#include <memory>
#include <optional>
#include <vector>

#include "camera/render_context.hpp"
#include "camera/renderer_program.hpp"
#include "camera/renderer_samples.hpp"
#include "camera/renderer_shapes.hpp"
#include "camera/shutter.hpp"

namespace sim {

class Renderer {
  public:
    // supersampling: 1, 2 or 4 (renderer_samples.hpp).
    Renderer(const Intrinsics &camera, int supersampling, const Shutter &shutter = {});
    ~Renderer();
    Renderer(const Renderer &) = delete;
    Renderer &operator=(const Renderer &) = delete;

    const Intrinsics &camera() const {
        return camera_;
    }
    const Shutter &shutter() const {
        return shutter_;
    }

    // The picture in R, G, B of what stands still.
    cli::Image picture(const Drawing &drawing, const Pose &X_world_cam);

    // The picture of what moves: each line of samples at its own time, and the mean
    // of the shutter's subframes.
    cli::Image picture(const Motion &motion);

    // The area of the target that the last picture shows, px; 0: not in view.
    double seen_area() const {
        return seen_area_;
    }

    // The same of what stands still, without a picture of it.
    double target_area(const Drawing &drawing, const Pose &X_world_cam);

  private:
    struct Pass; // what is the same for all solids of a drawing

    void draw(const View &view, Span rows);
    void draw_subframe(const Motion &motion, double offset);
    void draw_solid(const Solid &solid, const Pass &pass);
    void draw_through_lens(const Solid &solid, const Pass &pass, const Mat3 &world_from_cube);
    void make_cube();
    void make_target();
    void make_pattern();
    void make_rays();
    void read_samples();
    cli::Image summed();

    Intrinsics camera_;
    Shutter shutter_;
    Intrinsics drawn_; // the grid of samples
    std::unique_ptr<RenderContext> context_;
    std::vector<std::unique_ptr<Program>> programs_; // by Shape
    std::optional<RayBounds> columns_;               // with a lens
    std::optional<RayBounds> rows_;
    unsigned vertices_ = 0;
    unsigned cube_ = 0;
    unsigned framebuffer_ = 0;
    unsigned colours_ = 0;
    unsigned depths_ = 0;
    unsigned pattern_ = 0;
    unsigned rays_ = 0;
    Samples samples_; // of the last drawing
    SampleSum sum_;
    double seen_area_ = 0.0;
};

} // namespace sim

#endif
