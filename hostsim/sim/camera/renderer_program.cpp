// SPDX-License-Identifier: MIT
#include "camera/renderer_program.hpp"

#include <stdexcept>
#include <string>

#include "camera/gl.hpp"
#include "camera/shaders.hpp"

namespace sim {

namespace {

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

const char *hit_of(Shape shape, bool lens) {
    switch (shape) {
    case Shape::kBall:
        return kBallHit;
    case Shape::kDisc:
        return kDiscHit;
    case Shape::kBox:
    default:
        return lens ? kCastBoxHit : kBoxHit;
    }
}

unsigned linked_program(Shape shape, bool lens) {
    const std::string head = std::string(kVersion) + (lens ? kLensDefine : "");
    const unsigned program = glCreateProgram();
    const unsigned vertex = compile(GL_VERTEX_SHADER, head + kVertexShader);
    const unsigned fragment =
        compile(GL_FRAGMENT_SHADER, head + kFragmentShader + hit_of(shape, lens) + kFragmentMain);
    glAttachShader(program, vertex);
    glAttachShader(program, fragment);
    glLinkProgram(program);
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    return program;
}

} // namespace

Program::Program(Shape shape, bool lens) : program_(linked_program(shape, lens)) {
}

Program::~Program() {
    glDeleteProgram(program_);
}

void Program::use() const {
    glUseProgram(program_);
}

void Program::set(const char *name, int value) const {
    glUniform1i(place(name), value);
}

void Program::set(const char *name, double value) const {
    glUniform1f(place(name), static_cast<float>(value));
}

void Program::set(const char *name, const Vec3 &v) const {
    const cv::Vec3f f = v;
    glUniform3fv(place(name), 1, f.val);
}

void Program::set(const char *name, const Vec3 &v, double w) const {
    const cv::Vec4f f(static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2]),
                      static_cast<float>(w));
    glUniform4fv(place(name), 1, f.val);
}

void Program::set(const char *name, const Mat3 &m) const {
    const cv::Matx33f f = m;
    glUniformMatrix3fv(place(name), 1, GL_TRUE, f.val);
}

void Program::set(const char *name, const Mat4 &m) const {
    const cv::Matx44f f = m;
    glUniformMatrix4fv(place(name), 1, GL_TRUE, f.val);
}

int Program::place(const char *name) const {
    return glGetUniformLocation(program_, name);
}

} // namespace sim
