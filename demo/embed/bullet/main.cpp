// A host whose rigid bodies are Bullet's: a box falls on a trampoline, bounces and comes to rest on it.

#include <btBulletDynamicsCommon.h>
#include <weft/weft.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

template <class T>
T need(weft::Result<T> result) {
    if (!result) std::fprintf(stderr, "%s\n", result.error().message.c_str()), std::exit(1);
    if constexpr (!std::is_void_v<T>) return *std::move(result);
}

weft::Vec3 to_weft(const btVector3& v) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}
btVector3 to_bullet(const weft::Vec3& v) {
    return {v.x, v.y, v.z};
}

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

  private:
    weft::World& world_;
    btRigidBody& body_;
    weft::BodyId id_;
};

}  // namespace

int main() {
    constexpr float dt = 1.0f / 60, mass = 3, half = 0.12f, height = 0.9f, side = 1.2f;

    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld bullet(&dispatcher, &broadphase, &solver, &configuration);
    bullet.setGravity({0, btScalar(-9.81), 0});
    btStaticPlaneShape ground_shape({0, 1, 0}, 0);
    btRigidBody ground(0, nullptr, &ground_shape);
    btBoxShape box_shape({half, half, half});
    btVector3 inertia;
    box_shape.calculateLocalInertia(mass, inertia);
    btRigidBody box(mass, nullptr, &box_shape, inertia);
    box.setWorldTransform(
        btTransform(btQuaternion(btScalar(0.13), 0, btScalar(0.1), btScalar(0.986)).normalized(),
                    {btScalar(0.03), height + btScalar(0.6), 0}));
    bullet.addRigidBody(&ground);
    bullet.addRigidBody(&box);

    weft::World world = need(weft::World::create());
    constexpr std::uint32_t n = 40;
    const weft::ClothId cloth = need(world.add_cloth(
        need(weft::make_sheet({.rows = n,
                               .columns = n,
                               .origin = {-side / 2, height, -side / 2},
                               .u = {side, 0, 0},
                               .v = {0, 0, side}})),
        {.fabric = {.areal_density = 0.3f, .warp = 6000, .weft = 6000, .shear = 1500}, .air_damping = 1}));
    std::vector<std::uint32_t> border;
    for (std::uint32_t v = 0; v < n * n; ++v)
        if (v % n == 0 || v % n == n - 1 || v / n == 0 || v / n == n - 1) border.push_back(v);
    need(world.pin(cloth, border));
    Bridge bridge(world, box, {.shape = weft::Box{.half_extents = {half, half, half}}, .friction = 0.5f});

    double lowest = 10, highest_after = 0, borne = 0;
    constexpr int steps = 900, last = 120;
    for (int step = 1; step <= steps; ++step) {
        bridge.before_step();
        world.step(dt);
        const weft::Vec3 impulse = bridge.after_step();
        bullet.stepSimulation(dt, 0);  // one step of exactly dt
        const double y = double(box.getWorldTransform().getOrigin().y());
        lowest = std::min(lowest, y);
        if (lowest < double(height) && y > lowest) highest_after = std::max(highest_after, y);
        if (step > steps - last) borne += double(impulse.y) / double(dt) / last;
        if (step % 60 == 0) std::printf("%2d s: the box is at %.3f m\n", step / 60, y);
    }
    const double weight = double(mass) * 9.81, rest = double(box.getWorldTransform().getOrigin().y());
    std::printf("lowest %.3f m, then up to %.3f m; at last the cloth bears %.2f N of %.2f N\n", lowest,
                highest_after, borne, weight);
    const bool holds = std::abs(borne - weight) < 0.05 * weight && rest > 0.5 &&
                       highest_after > lowest + 0.1 && highest_after < double(height) + 0.6;
    bullet.removeRigidBody(&box);
    bullet.removeRigidBody(&ground);
    return holds ? 0 : 1;
}
