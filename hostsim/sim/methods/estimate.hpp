// SPDX-License-Identifier: MIT
//
// From what both eyes found to a place in the world and a radius.
#ifndef OCELLUS_SIM_ESTIMATE_HPP
#define OCELLUS_SIM_ESTIMATE_HPP

#include <array>
#include <optional>

#include "methods/methods.hpp"
#include "world/paper_head.hpp"

namespace sim {

// The head at the moment of the frames: what the encoders read and where the
// cameras truly are.
struct HeadReading {
    JointAngles joints;
    std::array<Pose, kSides> X_world_cam;
};

using Outlines = std::array<Outline, kSides>;

// Each is absent where it does not exist.
struct Estimate {
    ocel_status_t status = OCEL_NOT_SEEN;
    std::optional<Vec3> p_world;    // where the two rays meet; for the sphere, the library's best
    std::optional<Vec3> p_encoder;  // the paper's: eq. 14 and its chain, from the joints alone
    std::optional<Vec3> p_residual; // its exact form, with what the images still show off middle
    std::optional<double> radius;   // SMU
};

// `radius` is the target's, which the sphere's estimate makes use of.
Estimate estimate(const Outlines &outlines, const HeadReading &head, const Intrinsics &camera,
                  double radius);

// The radius of an outline whose centre is at p_cam: r_px depth / f; of a cone,
// range times sine.
double radius_at(const Outline &outline, const Intrinsics &camera, const Vec3 &p_cam);

// Where two rays come closest, half-way between them; nothing when they are
// parallel or part.
std::optional<Vec3> meeting_point(const Vec3 &p_a, const Vec3 &d_a, const Vec3 &p_b,
                                  const Vec3 &d_b);

} // namespace sim

#endif
