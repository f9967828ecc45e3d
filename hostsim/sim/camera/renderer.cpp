// SPDX-License-Identifier: MIT
#include "camera/renderer.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "camera/gl.hpp"

namespace sim {

namespace {

// What is drawn lies between these, SMU.
constexpr double kNear = 0.05;
constexpr double kFar = 60.0;

struct Light {
    double ambient;
    double glare;
};

Light light_of(Lighting lighting) {
    switch (lighting) {
    case Lighting::kSoft:
        return {0.6, 0.0};
    case Lighting::kHarsh:
        return {0.15, 0.6};
    case Lighting::kFlat:
    default:
        return {1.0, 0.0};
    }
}

// From pinhole intrinsics to OpenGL's clip space.  Its x and y run from -1 to 1
// between the outer edges of the border pixels, hence the halves; y up, z back.
Mat4 projection(const Intrinsics &camera) {
    Mat4 p = Mat4::zeros();
    p(0, 0) = 2.0 * camera.fx / camera.width;
    p(0, 2) = 1.0 - 2.0 * (camera.cx + 0.5) / camera.width;
    p(1, 1) = 2.0 * camera.fy / camera.height;
    p(1, 2) = 2.0 * (camera.cy + 0.5) / camera.height - 1.0;
    p(2, 2) = -(kFar + kNear) / (kFar - kNear);
    p(2, 3) = -2.0 * kFar * kNear / (kFar - kNear);
    p(3, 2) = -1.0;
    return p;
}

Mat4 matrix_of(const Mat3 &r, const Vec3 &p) {
    return {r(0, 0), r(0, 1), r(0, 2), p[0], r(1, 0), r(1, 1), r(1, 2), p[1],
            r(2, 0), r(2, 1), r(2, 2), p[2], 0,       0,       0,       1};
}

// OpenGL's camera looks along -z with y up.
Mat4 gl_from_camera() {
    return matrix_of(Mat3(1, 0, 0, 0, -1, 0, 0, 0, -1), Vec3());
}

// From the world to clip space.
Mat4 clip_from_world(const Intrinsics &camera, const Pose &X_world_cam) {
    const Pose X_cam_world = inverse(X_world_cam);
    return projection(camera) * gl_from_camera() * matrix_of(X_cam_world.r, X_cam_world.p);
}

// Between which tangents of x (axis 0) or y (1) a camera sees a cube.
struct Tangents {
    double low[2];
    double high[2];
};

// Nothing when the cube reaches behind what is near, and may be seen anywhere.
std::optional<Tangents> tangents_of(const Pose &X_cam_cube, const Vec3 &half_size) {
    Tangents tangents{{1e9, 1e9}, {-1e9, -1e9}};
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 p_cube((corner & 1) != 0 ? half_size[0] : -half_size[0],
                          (corner & 2) != 0 ? half_size[1] : -half_size[1],
                          (corner & 4) != 0 ? half_size[2] : -half_size[2]);
        const Vec3 p_cam = X_cam_cube * p_cube;
        if (p_cam[2] < kNear) {
            return std::nullopt;
        }
        for (int axis = 0; axis < 2; ++axis) {
            const double tangent = p_cam[axis] / p_cam[2];
            tangents.low[axis] = std::min(tangents.low[axis], tangent);
            tangents.high[axis] = std::max(tangents.high[axis], tangent);
        }
    }
    return tangents;
}

Span common(const Span &a, const Span &b) {
    return {std::max(a.first, b.first), std::min(a.last, b.last)};
}

void scissor(const Span &columns, const Span &rows) {
    glScissor(columns.first, rows.first, std::max(columns.last - columns.first, 0),
              std::max(rows.last - rows.first, 0));
}

unsigned new_texture() {
    unsigned texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    return texture;
}

} // namespace

struct Renderer::Pass {
    Mat4 clip_from_world;
    Pose X_world_cam;
    Light light;
    Span rows; // as OpenGL counts them, from the bottom
};

Renderer::Renderer(const Intrinsics &camera, int supersampling, const Shutter &shutter)
    : camera_(camera), shutter_(shutter), drawn_(sample_grid(camera, supersampling)),
      context_(make_osmesa_context()), samples_(static_cast<std::size_t>(drawn_.width) *
                                                static_cast<std::size_t>(drawn_.height) * 4),
      sum_(camera, supersampling) {
    for (const Shape shape : {Shape::kBox, Shape::kBall, Shape::kDisc}) {
        programs_.push_back(std::make_unique<Program>(shape, camera.lens.bends()));
    }
    make_cube();
    if (camera.lens.bends()) {
        make_rays();
    }
    make_pattern();
    make_target();
}

Renderer::~Renderer() {
    context_->make_current();
    programs_.clear();
    glDeleteTextures(1, &pattern_);
    glDeleteTextures(1, &rays_);
    glDeleteRenderbuffers(1, &colours_);
    glDeleteRenderbuffers(1, &depths_);
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteBuffers(1, &cube_);
    glDeleteVertexArrays(1, &vertices_);
}

void Renderer::make_cube() {
    const std::vector<float> data = cube_vertices();
    glGenVertexArrays(1, &vertices_);
    glBindVertexArray(vertices_);
    glGenBuffers(1, &cube_);
    glBindBuffer(GL_ARRAY_BUFFER, cube_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(data.size() * sizeof(float)), data.data(),
                 GL_STATIC_DRAW);
    for (unsigned attribute = 0; attribute < 2; ++attribute) {
        const std::uintptr_t offset = attribute * 3 * sizeof(float);
        glEnableVertexAttribArray(attribute);
        glVertexAttribPointer(attribute, 3, GL_FLOAT, GL_FALSE, 6 * sizeof(float),
                              reinterpret_cast<const void *>(offset));
    }
}

// Texture unit 0, where it stays.
void Renderer::make_pattern() {
    const std::vector<std::uint8_t> texels = pattern_texels();
    const int swizzle[] = {GL_RED, GL_RED, GL_RED, GL_ONE};
    glActiveTexture(GL_TEXTURE0);
    pattern_ = new_texture();
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, kPatternSize, kPatternSize, 0, GL_RED, GL_UNSIGNED_BYTE,
                 texels.data());
    glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_RGBA, swizzle);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glGenerateMipmap(GL_TEXTURE_2D);
}

// Texture unit 1.
void Renderer::make_rays() {
    const std::vector<float> texels = ray_texels(drawn_);
    glActiveTexture(GL_TEXTURE1);
    rays_ = new_texture();
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, drawn_.width, drawn_.height, 0, GL_RGB, GL_FLOAT,
                 texels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    columns_.emplace(texels, drawn_.width, drawn_.height, 0);
    rows_.emplace(texels, drawn_.width, drawn_.height, 1);
}

void Renderer::make_target() {
    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    const auto attach = [this](unsigned &buffer, unsigned format, unsigned point) {
        glGenRenderbuffers(1, &buffer);
        glBindRenderbuffer(GL_RENDERBUFFER, buffer);
        glRenderbufferStorage(GL_RENDERBUFFER, format, drawn_.width, drawn_.height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, buffer);
    };
    attach(colours_, GL_RGBA8, GL_COLOR_ATTACHMENT0);
    attach(depths_, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw std::runtime_error("OpenGL refuses a framebuffer of " + std::to_string(drawn_.width) +
                                 " x " + std::to_string(drawn_.height));
    }
    glViewport(0, 0, drawn_.width, drawn_.height);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
}

void Renderer::draw_solid(const Solid &solid, const Pass &pass) {
    const Program &program = *programs_[static_cast<std::size_t>(solid.shape)];
    const Mat3 world_from_cube = solid.X_world_solid.r * Mat3::diag(solid.half_size);
    const Vec3 eye = inverse(solid.X_world_solid) * pass.X_world_cam.p;
    program.use();
    program.set("clip_from_cube",
                pass.clip_from_world * matrix_of(world_from_cube, solid.X_world_solid.p));
    program.set("world_from_cube", world_from_cube);
    program.set("half_size", solid.half_size);
    program.set("eye", Vec3(eye[0] / solid.half_size[0], eye[1] / solid.half_size[1],
                            eye[2] / solid.half_size[2]));
    program.set("albedo", solid.colour, solid.textured ? 1 : 0);
    program.set("target", solid.is_target ? 1.0 : 0.0);
    program.set("ambient", pass.light.ambient);
    program.set("glare", pass.light.glare);
    program.set("to_light", cv::normalize(Vec3(-0.5, 0.5, 0.8)));
    if (columns_) {
        draw_through_lens(solid, pass, world_from_cube);
    } else {
        glDrawArrays(GL_TRIANGLES, 0, 36);
    }
}

// Only where it may be seen: a ray is cast for every sample that is drawn to.
void Renderer::draw_through_lens(const Solid &solid, const Pass &pass,
                                 const Mat3 &world_from_cube) {
    const auto seen = tangents_of(inverse(pass.X_world_cam) * solid.X_world_solid, solid.half_size);
    Span columns{0, drawn_.width};
    Span rows = pass.rows;
    if (seen) {
        columns = columns_->within(seen->low[0], seen->high[0]);
        rows = common(rows, rows_->within(seen->low[1], seen->high[1]));
    }
    const Program &program = *programs_[static_cast<std::size_t>(solid.shape)];
    program.set("cube_from_cam", world_from_cube.inv() * pass.X_world_cam.r);
    program.set("rays", 1);
    scissor(columns, rows);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

// `rows` of samples as a picture counts them, from the top.  A whole picture
// without a lens is spared the scissors, which cost a tenth.
void Renderer::draw(const View &view, Span rows) {
    const Pass pass{clip_from_world(drawn_, view.X_world_cam),
                    view.X_world_cam,
                    light_of(view.drawing.lighting),
                    {drawn_.height - rows.last, drawn_.height - rows.first}};
    const cv::Vec3f clear = view.drawing.clear_colour;
    if (rows.last - rows.first < drawn_.height || columns_) {
        glEnable(GL_SCISSOR_TEST);
        scissor({0, drawn_.width}, pass.rows);
    }
    glClearColor(clear[0], clear[1], clear[2], 0.0F);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (const Solid &solid : view.drawing.solids) {
        draw_solid(solid, pass);
    }
}

// Every line of samples at its own time, `offset` within the exposure.
void Renderer::draw_subframe(const Motion &motion, double offset) {
    if (shutter_.readout == 0.0) {
        draw(motion(offset), {0, drawn_.height});
        return;
    }
    for (int row = 0; row < drawn_.height; ++row) {
        const double share = (row + 0.5) / drawn_.height - 0.5;
        draw(motion(offset + share * shutter_.readout), {row, row + 1});
    }
}

void Renderer::read_samples() {
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, drawn_.width, drawn_.height, GL_RGBA, GL_UNSIGNED_BYTE, samples_.data());
    if (glGetError() != GL_NO_ERROR) {
        throw std::runtime_error("OpenGL reports an error after drawing");
    }
}

cli::Image Renderer::picture(const Drawing &drawing, const Pose &X_world_cam) {
    context_->make_current();
    sum_.clear();
    draw({drawing, X_world_cam}, {0, drawn_.height});
    read_samples();
    sum_.add(samples_);
    return summed();
}

cli::Image Renderer::picture(const Motion &motion) {
    context_->make_current();
    sum_.clear();
    for (int i = 0; i < shutter_.subframes; ++i) {
        const double share = (i + 0.5) / shutter_.subframes - 0.5;
        draw_subframe(motion, share * shutter_.exposure);
        read_samples();
        sum_.add(samples_);
    }
    return summed();
}

cli::Image Renderer::summed() {
    seen_area_ = sum_.target_area();
    return sum_.picture();
}

double Renderer::target_area(const Drawing &drawing, const Pose &X_world_cam) {
    context_->make_current();
    draw({drawing, X_world_cam}, {0, drawn_.height});
    read_samples();
    return sum_.target_area_of(samples_);
}

} // namespace sim
