// SPDX-License-Identifier: MIT
//
// Draws what a pinhole camera sees.  `supersampling` 1 takes one sample in each
// pixel's middle: the hard edges of the iCub simulator.  2 and 4 average a pixel's
// area by the trapezoid rule, on a grid of samples that has the pixels' corners:
// so it has their middles as well, and a pixel that an edge halves is not always
// taken for one side, which would make every ball .1 px larger.
#ifndef OCELLUS_SIM_RENDERER_HPP
#define OCELLUS_SIM_RENDERER_HPP

#include <cstdint>
#include <memory>
#include <vector>

#include "drawing.hpp"
#include "image.hpp"
#include "intrinsics.hpp"
#include "render_context.hpp"

namespace sim {

class Renderer {
  public:
    // supersampling: 1, 2 or 4.
    Renderer(const Intrinsics &camera, int supersampling);
    ~Renderer();
    Renderer(const Renderer &) = delete;
    Renderer &operator=(const Renderer &) = delete;

    const Intrinsics &camera() const {
        return camera_;
    }

    // The picture in R, G, B.
    cli::Image picture(const Drawing &drawing, const Pose &X_world_cam);

    // The area of the target that the camera sees, px: it is counted before
    // averaging, so in steps of 1 / supersampling^2.
    double target_area(const Drawing &drawing, const Pose &X_world_cam);

  private:
    class Program;
    struct Pass; // what is the same for all solids of a picture

    void draw(const Drawing &drawing, const Pass &pass);
    void draw_solid(const Solid &solid, const Pass &pass);
    void make_cube();
    void make_target();
    void make_pattern();
    void read_pixels();
    void add_line(std::size_t line, unsigned weight, std::vector<unsigned> &sum) const;
    unsigned weight(std::size_t sample) const;
    cli::Image averaged() const;

    Intrinsics camera_;
    int supersampling_;
    Intrinsics drawn_; // of the grid of samples
    int width_;        // of that grid
    int height_;
    std::unique_ptr<RenderContext> context_;
    std::vector<std::unique_ptr<Program>> programs_; // by Shape
    unsigned vertices_ = 0;
    unsigned cube_ = 0;
    unsigned framebuffer_ = 0;
    unsigned colours_ = 0;
    unsigned depths_ = 0;
    unsigned pattern_ = 0;
    std::vector<std::uint8_t> pixels_; // as drawn: R, G, B, A, bottom row first
};

} // namespace sim

#endif
