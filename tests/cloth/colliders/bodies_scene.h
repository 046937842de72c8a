#pragma once
// A sheet and a body that meets it.

#include <cmath>

#include "engine/vector.h"
#include "weft/weft.h"

namespace weft::test {

inline constexpr float body_step = 1.0f / 60;

/// A level sheet about the origin, and a ball or a box above it.
struct SheetAndBody {
    struct Setup {
        std::uint32_t side = 25;  ///< particles
        float length = 1;         ///< [m]
        ClothSettings cloth{};
        float mass = 1, radius = 0.12f;
        BodyState state{.position = {0, 0.3f, 0}};
        WorldSettings world{};
        bool box = false;
    };
    enum class Held { corners, border, free };

    explicit SheetAndBody(const Setup& setup, Held held)
        : setup_(setup), world(make_world(setup)), mass_of_body(setup.mass) {
        const float half = setup.length / 2;
        const auto mesh = make_sheet({.rows = setup.side,
                                      .columns = setup.side,
                                      .origin = {-half, 0, -half},
                                      .u = {setup.length, 0, 0},
                                      .v = {0, 0, setup.length}});
        cloth = world.add_cloth(*mesh, setup.cloth).value();
        pin(held);
        const float r = setup.radius;
        const float inertia = setup.box ? setup.mass * 8 * r * r / 12 : 0.4f * setup.mass * r * r;
        body =
            world.add_body({.mass = setup.mass, .inertia = {inertia, inertia, inertia}}, setup.state).value();
        Collider shape{.shape = Sphere{setup.state.position, r}};
        if (setup.box) shape.shape = Box{.center = setup.state.position, .half_extents = {r, r, r}};
        collider = world.add_collider(shape).value();
        EXPECT_TRUE(world.attach_collider(body, collider));
        inertia_ = inertia;
    }
    static World make_world(const Setup& setup) {
        WorldSettings settings = setup.world;
        settings.threads = 1;
        settings.wind.air_density = 0;
        return World::create(settings).value();
    }
    void pin(Held held) {
        const std::uint32_t n = setup_.side;
        std::vector<std::uint32_t> vertices;
        if (held == Held::corners) vertices = {0, n - 1, n * (n - 1), n * n - 1};
        for (std::uint32_t i = 0; held == Held::border && i < n * n; ++i)
            if (i / n == 0 || i / n == n - 1 || i % n == 0 || i % n == n - 1) vertices.push_back(i);
        EXPECT_TRUE(world.pin(cloth, vertices));
    }
    void steps(int count) {
        for (int k = 0; k < count; ++k) world.step(body_step);
    }
    [[nodiscard]] BodyState state() const { return world.body_state(body).value(); }
    [[nodiscard]] ClothView view() const { return world.cloth(cloth).value(); }

    struct Momentum {
        Eigen::Vector3d linear = Eigen::Vector3d::Zero(), angular = Eigen::Vector3d::Zero();
        double energy = 0;  ///< of motion [J]
        void add(double mass, const Vector3& x, const Vector3& v) {
            linear += mass * v.cast<double>();
            angular += mass * x.cast<double>().cross(v.cast<double>());
            energy += 0.5 * mass * v.cast<double>().squaredNorm();
        }
    };
    /// Of what is free.
    [[nodiscard]] Momentum momentum() const {
        Momentum sum;
        const ClothView now = view();
        for (std::size_t i = 0; i < now.positions.size(); ++i)
            if (now.positions[i].w > 0)
                sum.add(1 / static_cast<double>(now.positions[i].w), xyz(now.positions[i]),
                        xyz(now.velocities[i]));
        const BodyState b = state();
        sum.add(static_cast<double>(mass_of_body), to_vector(b.position), to_vector(b.velocity));
        const Eigen::Vector3d spin = to_vector(b.angular_velocity).cast<double>();
        sum.angular += static_cast<double>(inertia_) * spin;
        sum.energy += 0.5 * static_cast<double>(inertia_) * spin.squaredNorm();
        return sum;
    }
    [[nodiscard]] float fastest() const {
        float speed = to_vector(state().velocity).norm();
        for (const Vec4& v : view().velocities) speed = std::max(speed, xyz(v).norm());
        return speed;
    }
    /// The deepest that a particle is in the ball [m].
    [[nodiscard]] float deepest() const {
        float depth = -1;
        for (const Vec4& p : view().positions)
            depth = std::max(depth, setup_.radius - (xyz(p) - to_vector(state().position)).norm());
        return depth;
    }

  private:
    Setup setup_;
    float inertia_ = 0;

  public:
    World world;
    float mass_of_body;
    ClothId cloth;
    BodyId body;
    ColliderId collider;
};

}  // namespace weft::test
