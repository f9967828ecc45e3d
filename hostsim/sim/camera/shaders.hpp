// SPDX-License-Identifier: MIT
//
// The GLSL programs.  A solid is drawn as the cube around it; ball and disc are
// found in the fragment shader by casting the pixel's ray, so that their
// outlines are exact and cost less than a fine mesh.
//
// Through a lens a cube's edges are curved, so there nothing is drawn but a
// triangle over the whole picture, and every pixel casts the ray that its place in
// the texture `rays` says: LENS is defined then.
#ifndef OCELLUS_SIM_SHADERS_HPP
#define OCELLUS_SIM_SHADERS_HPP

namespace sim {

constexpr const char *kVersion = "#version 330 core\n";
constexpr const char *kLensDefine = "#define LENS\n";

// `corner` is a corner of the cube +-1; v_point is it where it is, in the cube.
constexpr const char *kVertexShader = R"(
#ifdef LENS
void main() {
    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
#else
layout(location = 0) in vec3 corner;
layout(location = 1) in vec3 face_normal;
uniform mat4 clip_from_cube;
out vec3 v_point;
out vec3 v_normal;
void main() {
    v_point = corner;
    v_normal = face_normal;
    gl_Position = clip_from_cube * vec4(corner, 1.0);
}
#endif
)";

// hit(): where the ray from `eye` along `d` meets the surface, and the normal
// there, both in the cube's coordinates.
constexpr const char *kBoxHit = R"(
bool hit(vec3 eye, vec3 d, out vec3 point, out vec3 normal) {
    point = v_point;
    normal = v_normal;
    return true;
}
)";

// The last of the three faces through which the ray comes in, unless it has gone
// out by another before.
constexpr const char *kCastBoxHit = R"(
bool hit(vec3 eye, vec3 d, out vec3 point, out vec3 normal) {
    vec3 face = vec3(d.x < 0.0 ? 1.0 : -1.0, d.y < 0.0 ? 1.0 : -1.0, d.z < 0.0 ? 1.0 : -1.0);
    vec3 in_at = (face - eye) / d;
    vec3 out_at = (-face - eye) / d;
    float t = max(in_at.x, max(in_at.y, in_at.z));
    normal = t == in_at.x ? vec3(face.x, 0.0, 0.0)
                          : (t == in_at.y ? vec3(0.0, face.y, 0.0) : vec3(0.0, 0.0, face.z));
    point = eye + t * d;
    return t <= min(out_at.x, min(out_at.y, out_at.z));
}
)";

// The foot of the perpendicular from the centre onto the ray: no difference of
// large numbers, so the outline keeps its digits.
constexpr const char *kBallHit = R"(
#define SHINES
bool hit(vec3 eye, vec3 d, out vec3 point, out vec3 normal) {
    vec3 along = normalize(d);
    vec3 foot = eye - dot(eye, along) * along;
    float inside = 1.0 - dot(foot, foot);
    point = foot - sqrt(max(inside, 0.0)) * along;
    normal = point;
    return inside >= 0.0;
}
)";

// Its two faces x = +-1, then its rim y^2 + z^2 = 1.
constexpr const char *kDiscHit = R"(
#define SHINES
bool hit(vec3 eye, vec3 d, out vec3 point, out vec3 normal) {
    float face = eye.x > 0.0 ? 1.0 : -1.0;
    point = eye + d * ((face - eye.x) / d.x);
    normal = vec3(face, 0.0, 0.0);
    bool found = abs(eye.x) > 1.0 && dot(point.yz, point.yz) <= 1.0;
    if (!found) {
        vec2 along = normalize(d.yz);
        vec2 foot = eye.yz - dot(eye.yz, along) * along;
        float inside = 1.0 - dot(foot, foot);
        vec2 rim = foot - sqrt(max(inside, 0.0)) * along;
        point = eye + d * (dot(rim - eye.yz, along) / dot(d.yz, along));
        normal = vec3(0.0, rim);
        found = inside >= 0.0 && abs(point.x) <= 1.0;
    }
    return found;
}
)";

// What stands before hit() and after it.
// glare: strength of the highlight.  albedo.a: 1 takes the texture, which has
// the mean .5.  What is cast writes its depth, as the cube's is not the solid's; a
// ball and a disc have the highlight, a box is spared it.  The colour's A is 1 for
// the target.
constexpr const char *kFragmentShader = R"(
#ifdef LENS
uniform sampler2D rays;
uniform mat3 cube_from_cam;
#else
in vec3 v_point;
in vec3 v_normal;
#endif
uniform mat4 clip_from_cube;
uniform mat3 world_from_cube;
uniform vec3 eye;
uniform vec3 half_size;
uniform vec4 albedo;
uniform float ambient;
uniform float glare;
uniform float target;
uniform vec3 to_light;
uniform sampler2D pattern;
out vec4 colour;
)";

constexpr const char *kFragmentMain = R"(
vec2 pattern_place(vec3 point, vec3 normal) {
    vec3 at = point * half_size;
    vec3 side = abs(normal);
    if (side.x > side.y && side.x > side.z) {
        return at.yz;
    }
    return side.y > side.z ? at.xz : at.xy;
}
vec3 pixel_ray() {
#ifdef LENS
    return cube_from_cam * texelFetch(rays, ivec2(gl_FragCoord.xy), 0).xyz;
#else
    return v_point - eye;
#endif
}
void main() {
    vec3 point;
    vec3 cube_normal;
    vec3 d = pixel_ray();
#ifdef LENS
    if (d == vec3(0.0)) {
        discard;
    }
#endif
    if (!hit(eye, d, point, cube_normal)) {
        discard;
    }
    // A normal goes by the inverse scale.
    vec3 normal = normalize(world_from_cube * (cube_normal / (half_size * half_size)));
    float lit = max(dot(normal, to_light), 0.0);
    vec3 paint = albedo.rgb;
    if (albedo.a > 0.5) {
        paint *= 0.4 + 1.2 * texture(pattern, 0.25 * pattern_place(point, cube_normal)).rgb;
    }
    colour = vec4(paint * (ambient + (1.0 - ambient) * lit), target);
#ifdef SHINES
    vec3 ray = normalize(world_from_cube * d);
    float mirror = max(dot(reflect(ray, normal), to_light), 0.0);
    colour.rgb += glare * pow(mirror, 20.0);
#endif
#if defined(SHINES) || defined(LENS)
    vec4 clip = clip_from_cube * vec4(point, 1.0);
    gl_FragDepth = 0.5 * clip.z / clip.w + 0.5;
#endif
#ifdef LENS
    if (abs(clip.z) > clip.w) {
        discard; // behind the camera, or beyond what is drawn
    }
#endif
}
)";

} // namespace sim

#endif
