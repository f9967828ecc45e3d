// SPDX-License-Identifier: MIT
//
// The physics of one trial: the head, a ball, the floor.  Bullet's results
// depend on what a world has been through, so each trial makes its own.
#ifndef OCELLUS_SIM_WORLD_HPP
#define OCELLUS_SIM_WORLD_HPP

#include "world/head.hpp"

namespace sim {

// 9.81 m/s^2, with 1 SMU = .194 m as the eyes' distance and the ball say.
constexpr double kGravity = 9.81 / 0.194; // SMU/s^2

constexpr double kStep = 0.001; // s

struct BallBody {
    double radius = 0.17; // SMU
    double mass = 0.05;   // kg; 0: it is held where it is
    double bounce = 0.8;  // share of its speed that a bounce leaves
    Vec3 p_world;
};

class World {
  public:
    explicit World(const BallBody &ball);
    ~World();
    World(const World &) = delete;
    World &operator=(const World &) = delete;

    // Goes on by a whole number of steps of kStep.
    void advance(int steps);

    Head &head() {
        return *head_;
    }
    Vec3 ball_place() const;

    // Holds the ball against gravity; lets it go with that velocity, SMU/s.
    void hold_ball();
    void release_ball(const Vec3 &v_world);

  private:
    void add_body(btRigidBody &body, double bounce);

    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    btDbvtBroadphase broadphase_;
    btMultiBodyConstraintSolver solver_;
    btMultiBodyDynamicsWorld world_;
    btStaticPlaneShape floor_shape_;
    btSphereShape ball_shape_;
    std::unique_ptr<btRigidBody> floor_;
    std::unique_ptr<btRigidBody> ball_;
    std::unique_ptr<Head> head_;
};

} // namespace sim

#endif
