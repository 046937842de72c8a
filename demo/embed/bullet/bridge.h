#pragma once
// Bodies of Bullet's that cloth moves, and that move cloth.

#include <btBulletDynamicsCommon.h>
#include <weft/weft.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

template <class T>
T need(weft::Result<T> result) {
    if (!result) std::fprintf(stderr, "%s\n", result.error().message.c_str()), std::exit(1);
    if constexpr (!std::is_void_v<T>) return *std::move(result);
}

inline weft::Vec3 to_weft(const btVector3& v) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}
inline btVector3 to_bullet(const weft::Vec3& v) {
    return {v.x, v.y, v.z};
}

// A world of Bullet's with a level ground, in gravity. The world's end looks at its bodies, so that the
// ground stands before it, and hosts take their own bodies out.
struct BulletWorld {
    BulletWorld() {
        world.setGravity({0, btScalar(-9.81), 0});
        world.addRigidBody(&ground);
    }
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btStaticPlaneShape ground_shape{{0, 1, 0}, 0};
    btRigidBody ground{0, nullptr, &ground_shape};
    btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
};

// The bridge: Bullet moves a body, and Weft tells it what the cloth gave. Both know of gravity, so that
// Weft's equation of cloth and body is whole; Bullet's integration then repeats the motion that Weft
// expected.
class Bridge {
  public:
    Bridge(weft::World& world, btRigidBody& body, weft::Collider shape) : world_(world), body_(body) {
        const btVector3 inertia = body.getLocalInertia();
        id_ = need(world.add_body({.mass = static_cast<float>(body.getMass()), .inertia = to_weft(inertia)}));
        need(world.attach_collider(id_, need(world.add_collider(shape))));  // at the body's place: the origin
        body.setActivationState(DISABLE_DEACTIVATION);                      // cloth would not wake it
    }
    void before_step() {
        const btTransform& at = body_.getWorldTransform();
        const btQuaternion q = at.getRotation();
        need(world_.set_body_state(id_, {.position = to_weft(at.getOrigin()),
                                         .rotation = {static_cast<float>(q.x()), static_cast<float>(q.y()),
                                                      static_cast<float>(q.z()), static_cast<float>(q.w())},
                                         .velocity = to_weft(body_.getLinearVelocity()),
                                         .angular_velocity = to_weft(body_.getAngularVelocity())}));
    }
    // Returns the impulse [N s].
    weft::Vec3 after_step() {
        const auto all = world_.body_impulses();
        const auto own = std::ranges::find(all, id_, &weft::BodyImpulse::body);
        if (own == all.end()) return {};
        body_.applyCentralImpulse(to_bullet(own->linear));
        body_.applyTorqueImpulse(to_bullet(own->angular));
        return own->linear;
    }

    weft::BodyId id() const { return id_; }

  private:
    weft::World& world_;
    btRigidBody& body_;
    weft::BodyId id_;
};
