// SPDX-License-Identifier: MIT
#include "world/head.hpp"

#include "geometry/frames.hpp"

namespace sim {

namespace {

// A joint: what it hangs on, where in that link, and the axis it turns about.
struct Link {
    int parent;
    Vec3 place; // in the parent's axes, which are the world's when all joints are 0
    Vec3 axis;
    double mass;   // kg
    double torque; // the motor's largest, in kg SMU^2/s^2
    double low;    // degrees
    double high;
};

// Up is positive: about -y.  Left is positive: about z.
const Link kLinks[kJointCount] = {
    {-1, {0, 0, kNeckHeight}, {0, -1, 0}, 0.5, 400, -40, 30},
    {kNeckPitch, {0, 0, 0}, {0, 0, 1}, 1.0, 400, -55, 55},
    {kNeckYaw, {kEyeForward, 0, kEyeRise}, {0, -1, 0}, 0.1, 40, -35, 15},
    {kEyesTilt, {0, kEyeDistance / 2, 0}, {0, 0, 1}, 0.05, 20, -50, 50},
    {kEyesTilt, {0, -kEyeDistance / 2, 0}, {0, 0, 1}, 0.05, 20, -50, 50}};

// The links' inertia as balls of this radius, SMU.
constexpr double kLinkRadius = 0.15;

btVector3 ball_inertia(double mass) {
    const double moment = 0.4 * mass * kLinkRadius * kLinkRadius;
    return {moment, moment, moment};
}

} // namespace

JointLimits joint_limits(Joint joint) {
    return {radians(kLinks[joint].low), radians(kLinks[joint].high)};
}

Head::Head(btMultiBodyDynamicsWorld &world, double step)
    : world_(world), body_(kJointCount, 0.0, btVector3(0, 0, 0), true, false), shape_(kLinkRadius) {
    for (int joint = 0; joint < kJointCount; ++joint) {
        add_link(static_cast<Joint>(joint));
    }
    body_.finalizeMultiDof();
    body_.setLinearDamping(0.0);
    body_.setAngularDamping(0.0);
    world_.addMultiBody(&body_);
    for (int joint = 0; joint < kJointCount; ++joint) {
        add_collider(static_cast<Joint>(joint));
        add_motor(static_cast<Joint>(joint), step);
    }
    place({});
}

Head::~Head() {
    for (int joint = 0; joint < kJointCount; ++joint) {
        const auto index = static_cast<std::size_t>(joint);
        world_.removeMultiBodyConstraint(motors_[index].get());
        world_.removeMultiBodyConstraint(limits_[index].get());
        world_.removeCollisionObject(colliders_[index].get());
    }
    world_.removeMultiBody(&body_);
}

void Head::add_link(Joint joint) {
    const Link &link = kLinks[joint];
    body_.setupRevolute(joint, link.mass, ball_inertia(link.mass), link.parent,
                        btQuaternion::getIdentity(), bullet_vector(link.axis),
                        bullet_vector(link.place), btVector3(0, 0, 0), true);
}

// A link without a collider has no motor and no limit: Bullet leaves both out
// silently.  The mask 0 lets it touch nothing.
void Head::add_collider(Joint joint) {
    auto &collider = colliders_[static_cast<std::size_t>(joint)];
    collider = std::make_unique<btMultiBodyLinkCollider>(&body_, joint);
    collider->setCollisionShape(&shape_);
    world_.addCollisionObject(collider.get(), btBroadphaseProxy::DefaultFilter, 0);
    body_.getLink(joint).m_collider = collider.get();
}

void Head::add_motor(Joint joint, double step) {
    const auto index = static_cast<std::size_t>(joint);
    const JointLimits range = joint_limits(joint);
    motors_[index] =
        std::make_unique<btMultiBodyJointMotor>(&body_, joint, 0.0, kLinks[joint].torque * step);
    limits_[index] =
        std::make_unique<btMultiBodyJointLimitConstraint>(&body_, joint, range.low, range.high);
    world_.addMultiBodyConstraint(motors_[index].get());
    world_.addMultiBodyConstraint(limits_[index].get());
    motors_[index]->finalizeMultiDof();
    limits_[index]->finalizeMultiDof();
}

void Head::set_speed(Joint joint, double speed) {
    motors_[static_cast<std::size_t>(joint)]->setVelocityTarget(speed);
}

JointAngles Head::angles() const {
    JointAngles angles{};
    for (int joint = 0; joint < kJointCount; ++joint) {
        angles[static_cast<std::size_t>(joint)] = body_.getJointPos(joint);
    }
    return angles;
}

void Head::place(const JointAngles &angles) {
    for (int joint = 0; joint < kJointCount; ++joint) {
        body_.setJointPos(joint, angles[static_cast<std::size_t>(joint)]);
        body_.setJointVel(joint, 0.0);
    }
    btAlignedObjectArray<btQuaternion> turns;
    btAlignedObjectArray<btVector3> places;
    body_.forwardKinematics(turns, places);
    body_.updateCollisionObjectWorldTransforms(turns, places);
}

// From the joints as they are: the transforms that Bullet keeps are a step old.
Pose Head::X_world_eye(Side side) const {
    const int link = side == kLeft ? kLeftPan : kRightPan;
    const btVector3 centre = body_.localPosToWorld(link, btVector3(0, 0, 0));
    Pose pose;
    pose.p = world_vector(centre);
    for (int axis = 0; axis < 3; ++axis) {
        btVector3 unit(0, 0, 0);
        unit[axis] = 1.0;
        const Vec3 column = world_vector(body_.localDirToWorld(link, unit));
        for (int row = 0; row < 3; ++row) {
            pose.r(row, axis) = column[row];
        }
    }
    return pose;
}

Pose Head::X_world_cam(Side side) const {
    return X_world_eye(side) * camera_in_eye();
}

} // namespace sim
