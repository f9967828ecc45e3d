// SPDX-License-Identifier: MIT
//
// The robot's head in Bullet: five joints with velocity motors and limits, of
// the paper's lengths.
#ifndef OCELLUS_SIM_HEAD_HPP
#define OCELLUS_SIM_HEAD_HPP

#include <btBulletDynamicsCommon.h>

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointLimitConstraint.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointMotor.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <array>
#include <memory>

#include "world/paper_head.hpp"

namespace sim {

struct JointLimits {
    double low; // radians
    double high;
};

// The iCub's: pitch -40..30, yaw +-55, tilt -35..15, pan +-50 degrees.
JointLimits joint_limits(Joint joint);

class Head {
  public:
    // Adds itself to `world`, which must outlive it.  `step` of the simulation,
    // s: the motors' impulses are their torques times it.
    Head(btMultiBodyDynamicsWorld &world, double step);
    ~Head();
    Head(const Head &) = delete;
    Head &operator=(const Head &) = delete;

    // The speed that the joint's motor goes for, rad/s.
    void set_speed(Joint joint, double speed);

    // What the encoders read.
    JointAngles angles() const;

    // Puts the joints there at once, at rest.
    void place(const JointAngles &angles);

    // Where an eye is.
    Pose X_world_eye(Side side) const;
    // Where its camera is.
    Pose X_world_cam(Side side) const;

  private:
    void add_link(Joint joint);
    void add_collider(Joint joint);
    void add_motor(Joint joint, double step);

    btMultiBodyDynamicsWorld &world_;
    btMultiBody body_;
    btSphereShape shape_;
    std::array<std::unique_ptr<btMultiBodyLinkCollider>, kJointCount> colliders_;
    std::array<std::unique_ptr<btMultiBodyJointMotor>, kJointCount> motors_;
    std::array<std::unique_ptr<btMultiBodyJointLimitConstraint>, kJointCount> limits_;
};

} // namespace sim

#endif
