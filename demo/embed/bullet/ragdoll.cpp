// A ragdoll of Bullet's falls in a skirt: pelvis, torso, thighs and shins, with joints of Bullet's. The skirt
// is sewn to the pelvis, lies on the legs, and pulls at both.

#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include "bridge.h"

namespace {

constexpr float dt = 1.0f / 60;
constexpr std::uint32_t rows = 20, columns = 48;  // vertices of the skirt, from the waist down and round it

weft::Mesh make_skirt() {
    weft::Mesh skirt;
    for (std::uint32_t v = 0; v < rows * columns; ++v) {
        const float down = static_cast<float>(v / columns) / (rows - 1);
        const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(v % columns) / columns;
        const float radius = 0.13f + 0.2f * down;
        skirt.positions.push_back({radius * std::sin(angle), 1.25f - 0.45f * down, radius * std::cos(angle)});
    }
    for (std::uint32_t a = 0; a < (rows - 1) * columns; ++a) {
        const std::uint32_t b = a % columns == columns - 1 ? a + 1 - columns : a + 1;
        skirt.triangles.push_back({a, a + columns, b});
        skirt.triangles.push_back({b, a + columns, b + columns});
    }
    return skirt;
}

/// A limb: a capsule about its body's origin, along y.
struct Limb {
    Limb(float mass, float radius, float length, const btVector3& at)
        : shape(btScalar(radius), btScalar(length)),
          capsule{{0, -length / 2, 0}, {0, length / 2, 0}, radius} {
        btVector3 inertia;
        shape.calculateLocalInertia(btScalar(mass), inertia);
        body.emplace(btScalar(mass), nullptr, &shape, inertia);
        body->setWorldTransform(btTransform(btQuaternion::getIdentity(), at));
        body->setFriction(btScalar(0.8));
        body->setDamping(0, btScalar(0.6));
    }
    btCapsuleShape shape;
    weft::Capsule capsule;
    std::optional<btRigidBody> body;
};

btTransform joint_at(const btRigidBody& body, const btVector3& place) {
    return body.getWorldTransform().inverse() * btTransform(btQuaternion::getIdentity(), place);
}

}  // namespace

int main() {
    BulletWorld of_bullet;
    btDiscreteDynamicsWorld& bullet = of_bullet.world;

    const auto point = [](double x, double y) { return btVector3(btScalar(x), btScalar(y), 0); };
    std::array<Limb, 6> limbs{
        Limb(9, 0.13f, 0.02f, point(0, 1.15)),       Limb(22, 0.12f, 0.3f, point(0, 1.5)),
        Limb(7, 0.06f, 0.3f, point(-0.08, 0.9)),     Limb(7, 0.06f, 0.3f, point(0.08, 0.9)),
        Limb(3.5f, 0.045f, 0.3f, point(-0.08, 0.5)), Limb(3.5f, 0.045f, 0.3f, point(0.08, 0.5))};
    for (Limb& limb : limbs) bullet.addRigidBody(&*limb.body);
    std::vector<std::unique_ptr<btConeTwistConstraint>> joints;
    const auto join = [&](std::size_t a, std::size_t b, const btVector3& at, double swing) {
        btRigidBody &upper = *limbs[a].body, &lower = *limbs[b].body;
        joints.push_back(
            std::make_unique<btConeTwistConstraint>(upper, lower, joint_at(upper, at), joint_at(lower, at)));
        joints.back()->setLimit(btScalar(swing), btScalar(swing), btScalar(0.3));
        bullet.addConstraint(joints.back().get(), true);
    };
    join(0, 1, point(0, 1.28), 0.5);
    join(0, 2, point(-0.08, 1.07), 1);
    join(0, 3, point(0.08, 1.07), 1);
    join(2, 4, point(-0.08, 0.7), 0.8);
    join(3, 5, point(0.08, 0.7), 0.8);
    for (Limb& limb : limbs) limb.body->setAngularVelocity({btScalar(0.8), 0, btScalar(0.5)});

    weft::World world = need(weft::World::create());
    constexpr std::uint32_t of_limbs = 1, of_ground = 2;  // Bullet has bodies stand on its own ground
    need(world.add_collider({.shape = weft::Plane{}, .friction = 0.6f, .layers = of_ground}));
    const weft::Mesh mesh = make_skirt();
    const weft::ClothId skirt =
        need(world.add_cloth(mesh, {.fabric = need(weft::Fabric::named("cotton")),
                                    .self_collision = {.method = weft::SelfCollisionMethod::contact}}));
    std::vector<Bridge> bridges;
    for (Limb& limb : limbs) {
        bridges.emplace_back(world, *limb.body,
                             weft::Collider{.shape = limb.capsule, .friction = 0.4f, .layers = of_limbs});
        bridges.back().before_step();
    }
    std::vector<std::uint32_t> waist;
    for (std::uint32_t column = 0; column < columns; ++column) waist.push_back(column);
    need(world.attach(bridges.front().id(), skirt, waist));

    // Returns the momentum of limbs and skirt along y [N s], and their kinetic energy [J].
    const auto motion = [&] {
        std::array<double, 2> sum{};
        for (const Limb& limb : limbs) {
            const double m = double(limb.body->getMass());
            sum[0] += m * double(limb.body->getLinearVelocity().y());
            sum[1] += 0.5 * m * double(limb.body->getLinearVelocity().length2());
        }
        const weft::ClothView& view = need(world.cloth(skirt));
        for (std::size_t i = 0; i < view.positions.size(); ++i) {
            if (!(view.positions[i].w > 0)) continue;
            const weft::Vec4& v = view.velocities[i];
            const double m = 1 / double(view.positions[i].w);
            sum[0] += m * double(v.y);
            sum[1] += 0.5 * m * double(v.x * v.x + v.y * v.y + v.z * v.z);
        }
        return sum;
    };
    double mass = double(need(world.cloth_info(skirt)).mass), in_flight = 0, lowest = 1, at_last = 0;
    for (const Limb& limb : limbs) mass += double(limb.body->getMass());
    std::uint32_t crossings = 0;
    constexpr int steps = 600, flight = 12;
    for (int step = 1; step <= steps; ++step) {
        for (Bridge& bridge : bridges) bridge.before_step();
        world.step(dt);
        for (Bridge& bridge : bridges) bridge.after_step();
        bullet.stepSimulation(dt, 0);
        if (step == flight) in_flight = motion()[0];
        crossings += world.report().crossings;
        // A limb that Bullet lets into the ground presses the skirt down as far.
        double ground_at = 0;
        for (const Limb& limb : limbs) {
            btVector3 lower, upper;
            limb.body->getAabb(lower, upper);
            ground_at = std::min(ground_at, double(lower.y()));
        }
        lowest = std::min(lowest, double(need(world.cloth(skirt)).bounds.lower.y) - ground_at);
        if (step > steps - 60) at_last = std::max(at_last, motion()[1]);
        if (step % 60 == 0)
            std::printf("%2d s: the pelvis is at %.3f m, the hem at %.3f m\n", step / 60,
                        double(limbs[0].body->getWorldTransform().getOrigin().y()),
                        double(need(world.cloth(skirt)).bounds.lower.y));
    }
    const double expected = -mass * 9.81 * flight * double(dt);
    std::printf(
        "momentum in flight %.2f N s of %.2f N s; lowest %.3f m over the ground or a limb in it; at last "
        "%.4f J; %u crossings\n",
        in_flight, expected, lowest, at_last, crossings);
    const bool holds = std::abs(in_flight - expected) < 0.02 * std::abs(expected) && lowest > -0.01 &&
                       at_last < 0.05 && crossings == 0;
    for (const auto& joint : joints) bullet.removeConstraint(joint.get());
    for (Limb& limb : limbs) bullet.removeRigidBody(&*limb.body);
    return holds ? 0 : 1;
}
