// SPDX-License-Identifier: MIT
#include "world/world.hpp"

#include "geometry/frames.hpp"

namespace sim {

namespace {

std::unique_ptr<btRigidBody> make_body(double mass, btCollisionShape &shape, const Vec3 &p_world) {
    btVector3 inertia(0, 0, 0);
    if (mass > 0.0) {
        shape.calculateLocalInertia(mass, inertia);
    }
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &shape, inertia);
    info.m_startWorldTransform.setOrigin(bullet_vector(p_world));
    return std::make_unique<btRigidBody>(info);
}

} // namespace

World::World(const BallBody &ball)
    : dispatcher_(&configuration_), world_(&dispatcher_, &broadphase_, &solver_, &configuration_),
      floor_shape_(btVector3(0, 0, 1), 0.0), ball_shape_(ball.radius),
      floor_(make_body(0.0, floor_shape_, Vec3())),
      ball_(make_body(ball.mass, ball_shape_, ball.p_world)) {
    world_.setGravity(btVector3(0, 0, -kGravity));
    // What has gone into the floor is put back without a push, which would make a
    // bounce higher.
    world_.getSolverInfo().m_splitImpulsePenetrationThreshold = 0.0;
    add_body(*floor_, 1.0);
    add_body(*ball_, ball.bounce);
    head_ = std::make_unique<Head>(world_, kStep);
}

World::~World() {
    head_.reset();
    world_.removeRigidBody(ball_.get());
    world_.removeRigidBody(floor_.get());
}

// The bounce of a contact is the product of the two bodies'.
void World::add_body(btRigidBody &body, double bounce) {
    body.setRestitution(bounce);
    body.setDamping(0.0, 0.0);
    // A contact is one that touches: Bullet would brake a body before it does, and
    // the bounce be of what speed is left.
    body.setContactProcessingThreshold(0.0);
    body.setActivationState(DISABLE_DEACTIVATION);
    world_.addRigidBody(&body);
}

void World::advance(int steps) {
    for (int i = 0; i < steps; ++i) {
        world_.stepSimulation(kStep, 0);
    }
}

void World::hold_ball() {
    ball_->setGravity(btVector3(0, 0, 0));
    ball_->setLinearVelocity(btVector3(0, 0, 0));
}

void World::release_ball(const Vec3 &v_world) {
    ball_->setGravity(world_.getGravity());
    ball_->setLinearVelocity(bullet_vector(v_world));
}

Vec3 World::ball_place() const {
    return world_vector(ball_->getWorldTransform().getOrigin());
}

} // namespace sim
