// A host whose rigid bodies are Bullet's: a box falls on a trampoline, bounces and comes to rest on it.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "bridge.h"

int main() {
    constexpr float dt = 1.0f / 60, mass = 3, half = 0.12f, height = 0.9f, side = 1.2f;

    BulletWorld of_bullet;
    btDiscreteDynamicsWorld& bullet = of_bullet.world;
    btBoxShape box_shape({half, half, half});
    btVector3 inertia;
    box_shape.calculateLocalInertia(mass, inertia);
    btRigidBody box(mass, nullptr, &box_shape, inertia);
    box.setWorldTransform(
        btTransform(btQuaternion(btScalar(0.13), 0, btScalar(0.1), btScalar(0.986)).normalized(),
                    {btScalar(0.03), height + btScalar(0.6), 0}));
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
    return holds ? 0 : 1;
}
