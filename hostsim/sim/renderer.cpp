// SPDX-License-Identifier: MIT
#include "renderer.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "gl.hpp"
#include "random.hpp"
#include "shaders.hpp"

namespace sim {

namespace {

using Mat4 = cv::Matx44d;

// What is drawn lies between these, SMU.
constexpr double kNear = 0.05;
constexpr double kFar = 60.0;

constexpr int kPatternSize = 256;

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

// The grid of samples as a camera: its nodes 0, k, 2k ... are the pixels' edges.
Intrinsics sample_grid(const Intrinsics &camera, int k) {
    if (k == 1) {
        return camera;
    }
    return {camera.fx * k,         camera.fy * k,        (camera.cx + 0.5) * k,
            (camera.cy + 0.5) * k, camera.width * k + 1, camera.height * k + 1};
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
Mat4 view(const Intrinsics &camera, const Pose &X_world_cam) {
    const Pose X_cam_world = inverse(X_world_cam);
    return projection(camera) * gl_from_camera() * matrix_of(X_cam_world.r, X_cam_world.p);
}

Mat3 scaled(const Mat3 &r, const Vec3 &half_size) {
    return r * Mat3::diag(half_size);
}

unsigned compile(unsigned kind, const std::string &text) {
    const unsigned shader = glCreateShader(kind);
    const char *const source = text.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    int good = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (good == 0) {
        char message[1024] = "";
        glGetShaderInfoLog(shader, sizeof message, nullptr, message);
        throw std::runtime_error(std::string("a shader does not compile: ") + message);
    }
    return shader;
}

unsigned linked_program(const char *hit) {
    const unsigned program = glCreateProgram();
    const unsigned vertex = compile(GL_VERTEX_SHADER, std::string(kVersion) + kVertexShader);
    const unsigned fragment =
        compile(GL_FRAGMENT_SHADER, std::string(kVersion) + kFragmentShader + hit + kFragmentMain);
    glAttachShader(program, vertex);
    glAttachShader(program, fragment);
    glLinkProgram(program);
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    return program;
}

// Six faces of two triangles; each vertex a corner and its face's normal.
std::vector<float> cube_vertices() {
    constexpr int kCorners[6][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}};
    std::vector<float> vertices;
    for (int axis = 0; axis < 3; ++axis) {
        for (int side = -1; side <= 1; side += 2) {
            for (const auto &corner : kCorners) {
                float vertex[6] = {};
                vertex[axis] = vertex[3 + axis] = static_cast<float>(side);
                // Anticlockwise as seen from outside.
                vertex[(axis + 1) % 3] = static_cast<float>(corner[0] * side);
                vertex[(axis + 2) % 3] = static_cast<float>(corner[1]);
                vertices.insert(vertices.end(), vertex, vertex + 6);
            }
        }
    }
    return vertices;
}

// Grey noise of mean .5 in squares of 1, 2, 4 ... 32 texels, the larger the
// stronger.
std::vector<std::uint8_t> pattern_texels() {
    std::vector<double> sum(kPatternSize * kPatternSize, 0.0);
    for (int octave = 0; octave < 6; ++octave) {
        const int cells = kPatternSize >> octave;
        Random random(static_cast<std::uint64_t>(octave));
        std::vector<double> value(static_cast<std::size_t>(cells) *
                                  static_cast<std::size_t>(cells));
        for (double &cell : value) {
            cell = random.uniform(-1, 1);
        }
        for (int i = 0; i < kPatternSize * kPatternSize; ++i) {
            const int cell = (i / kPatternSize >> octave) * cells + (i % kPatternSize >> octave);
            sum[static_cast<std::size_t>(i)] +=
                value[static_cast<std::size_t>(cell)] * (octave + 1);
        }
    }
    std::vector<std::uint8_t> texels(sum.size());
    for (std::size_t i = 0; i < sum.size(); ++i) {
        texels[i] = static_cast<std::uint8_t>(std::lround(127.5 + 127.4 * sum[i] / 21.0));
    }
    return texels;
}

} // namespace

// One program, and the places of its uniforms.
class Renderer::Program {
  public:
    explicit Program(const char *hit) : program_(linked_program(hit)) {
    }
    ~Program() {
        glDeleteProgram(program_);
    }
    Program(const Program &) = delete;
    Program &operator=(const Program &) = delete;

    void use() const {
        glUseProgram(program_);
    }
    void set(const char *name, double value) const {
        glUniform1f(place(name), static_cast<float>(value));
    }
    void set(const char *name, const Vec3 &v) const {
        const cv::Vec3f f = v;
        glUniform3fv(place(name), 1, f.val);
    }
    void set(const char *name, const Vec3 &v, double w) const {
        const cv::Vec4f f(static_cast<float>(v[0]), static_cast<float>(v[1]),
                          static_cast<float>(v[2]), static_cast<float>(w));
        glUniform4fv(place(name), 1, f.val);
    }
    void set(const char *name, const Mat3 &m) const {
        const cv::Matx33f f = m;
        glUniformMatrix3fv(place(name), 1, GL_TRUE, f.val);
    }
    void set(const char *name, const Mat4 &m) const {
        const cv::Matx44f f = m;
        glUniformMatrix4fv(place(name), 1, GL_TRUE, f.val);
    }

  private:
    int place(const char *name) const {
        return glGetUniformLocation(program_, name);
    }
    unsigned program_;
};

struct Renderer::Pass {
    Mat4 clip_from_world;
    Vec3 eye_world;
    Light light;
    bool mask; // the target white, all else black
};

Renderer::Renderer(const Intrinsics &camera, int supersampling)
    : camera_(camera), supersampling_(supersampling), drawn_(sample_grid(camera, supersampling)),
      width_(drawn_.width), height_(drawn_.height), context_(make_osmesa_context()),
      pixels_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * 4) {
    for (const char *hit : {kBoxHit, kBallHit, kDiscHit}) {
        programs_.push_back(std::make_unique<Program>(hit));
    }
    make_cube();
    make_pattern();
    make_target();
}

Renderer::~Renderer() {
    context_->make_current();
    programs_.clear();
    glDeleteTextures(1, &pattern_);
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

void Renderer::make_pattern() {
    const std::vector<std::uint8_t> texels = pattern_texels();
    const int swizzle[] = {GL_RED, GL_RED, GL_RED, GL_ONE};
    glGenTextures(1, &pattern_);
    glBindTexture(GL_TEXTURE_2D, pattern_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, kPatternSize, kPatternSize, 0, GL_RED, GL_UNSIGNED_BYTE,
                 texels.data());
    glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_RGBA, swizzle);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glGenerateMipmap(GL_TEXTURE_2D);
}

void Renderer::make_target() {
    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    const auto attach = [this](unsigned &buffer, unsigned format, unsigned point) {
        glGenRenderbuffers(1, &buffer);
        glBindRenderbuffer(GL_RENDERBUFFER, buffer);
        glRenderbufferStorage(GL_RENDERBUFFER, format, width_, height_);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, buffer);
    };
    attach(colours_, GL_RGBA8, GL_COLOR_ATTACHMENT0);
    attach(depths_, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw std::runtime_error("OpenGL refuses a framebuffer of " + std::to_string(width_) +
                                 " x " + std::to_string(height_));
    }
    glViewport(0, 0, width_, height_);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
}

void Renderer::draw_solid(const Solid &solid, const Pass &pass) {
    const Program &program = *programs_[static_cast<std::size_t>(solid.shape)];
    const Mat3 world_from_cube = scaled(solid.X_world_solid.r, solid.half_size);
    const Vec3 eye = inverse(solid.X_world_solid) * pass.eye_world;
    const double white = solid.is_target ? 1.0 : 0.0;
    const bool textured = solid.textured && !pass.mask;
    program.use();
    program.set("clip_from_cube",
                pass.clip_from_world * matrix_of(world_from_cube, solid.X_world_solid.p));
    program.set("world_from_cube", world_from_cube);
    program.set("half_size", solid.half_size);
    program.set("eye", Vec3(eye[0] / solid.half_size[0], eye[1] / solid.half_size[1],
                            eye[2] / solid.half_size[2]));
    program.set("albedo", pass.mask ? Vec3(white, white, white) : solid.colour, textured ? 1 : 0);
    program.set("ambient", pass.light.ambient);
    program.set("glare", pass.light.glare);
    program.set("to_light", cv::normalize(Vec3(-0.5, 0.5, 0.8)));
    glDrawArrays(GL_TRIANGLES, 0, 36);
}

void Renderer::draw(const Drawing &drawing, const Pass &pass) {
    context_->make_current();
    const cv::Vec3f clear = pass.mask ? Vec3() : drawing.clear_colour;
    glClearColor(clear[0], clear[1], clear[2], 1.0F);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (const Solid &solid : drawing.solids) {
        draw_solid(solid, pass);
    }
    read_pixels();
}

void Renderer::read_pixels() {
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, pixels_.data());
    if (glGetError() != GL_NO_ERROR) {
        throw std::runtime_error("OpenGL reports an error after drawing");
    }
}

// By the trapezoid rule the samples on a pixel's border count half.
unsigned Renderer::weight(std::size_t sample) const {
    const auto k = static_cast<std::size_t>(supersampling_);
    return k == 1 || sample == 0 || sample == k ? 1U : 2U;
}

// Pixels to the mean over their area, to the nearest level, top row first.
cli::Image Renderer::averaged() const {
    const auto k = static_cast<std::size_t>(supersampling_);
    const std::size_t last = k == 1 ? 0 : k; // sample of a pixel, along a side
    const auto total = static_cast<unsigned>(k == 1 ? 1 : 4 * k * k);
    const auto bottom = static_cast<std::size_t>(height_) - 1;
    cli::Image image;
    image.width = static_cast<std::uint32_t>(camera_.width);
    image.height = static_cast<std::uint32_t>(camera_.height);
    image.channels = 3;
    image.pixels.resize(image.row_bytes() * image.height);
    std::vector<unsigned> sum(image.row_bytes());
    for (std::size_t y = 0; y < image.height; ++y) {
        std::fill(sum.begin(), sum.end(), 0U);
        for (std::size_t sample = 0; sample <= last; ++sample) {
            add_line(bottom - (y * k + sample), weight(sample), sum);
        }
        for (std::size_t i = 0; i < sum.size(); ++i) {
            image.row(y)[i] = static_cast<std::uint8_t>((sum[i] + total / 2) / total);
        }
    }
    return image;
}

// Adds a line of samples to a line of pixels.
void Renderer::add_line(std::size_t line, unsigned line_weight, std::vector<unsigned> &sum) const {
    const auto k = static_cast<std::size_t>(supersampling_);
    const std::size_t last = k == 1 ? 0 : k;
    const std::uint8_t *first = pixels_.data() + line * static_cast<std::size_t>(width_) * 4;
    for (std::size_t i = 0; i < sum.size(); i += 3, first += 4 * k) {
        for (std::size_t sample = 0; sample <= last; ++sample) {
            const unsigned share = line_weight * weight(sample);
            sum[i] += share * first[4 * sample];
            sum[i + 1] += share * first[4 * sample + 1];
            sum[i + 2] += share * first[4 * sample + 2];
        }
    }
}

cli::Image Renderer::picture(const Drawing &drawing, const Pose &X_world_cam) {
    draw(drawing, {view(drawn_, X_world_cam), X_world_cam.p, light_of(drawing.lighting), false});
    return averaged();
}

double Renderer::target_area(const Drawing &drawing, const Pose &X_world_cam) {
    draw(drawing, {view(drawn_, X_world_cam), X_world_cam.p, light_of(Lighting::kFlat), true});
    std::size_t count = 0;
    for (std::size_t i = 0; i < pixels_.size(); i += 4) {
        count += pixels_[i] > 127 ? 1U : 0U;
    }
    return static_cast<double>(count) / (supersampling_ * supersampling_);
}

} // namespace sim
