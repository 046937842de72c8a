// Coulomb friction: a sheet that slides down a slope, and a strip that slips round a cylinder.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "demo/must.h"
#include "demo/study/physics/experiment.h"
#include "demo/study/physics/known_answers.h"
#include "demo/study/physics/physics_table.h"

namespace weft::study {

namespace {

void add(Experiment& cloth, const Collider& collider) {
    must(cloth.world().add_collider(collider));
}

/// Mean speed down the slope, 1 s after the sheet was laid there [m/s].
double speed_down(ForceModel model, std::uint32_t cells, double angle, double friction) {
    const auto s = static_cast<float>(std::sin(angle)), c = static_cast<float>(std::cos(angle));
    const Vec3 normal{s, c, 0}, down{c, -s, 0};
    ClothSettings settings = made_of(model, Fabric{});
    const float above = settings.thickness;
    Experiment cloth(
        strip_mesh(model, {0.3, 0.3, cells},
                   [&](Vec2 p) {
                       return Vec3{p.x * down.x + above * normal.x, p.x * down.y + above * normal.y, p.y};
                   }),
        settings);
    add(cloth, {.shape = Plane{normal, 0}, .friction = static_cast<float>(friction)});
    cloth.run(1);
    double speed = 0;
    const auto all = cloth.vertices([](Vec2) { return true; });
    for (const std::uint32_t vertex : all) {
        const Vec3 v = cloth.velocity(vertex);
        speed += static_cast<double>(v.x * down.x + v.y * down.y);
    }
    return speed / static_cast<double>(all.size());
}

std::vector<Finding> slope(ForceModel model, std::uint32_t cells) {
    constexpr double friction = 0.4, steep = 0.6;
    double low = 0.1, high = 0.8;
    while (high - low > 2e-3) {
        const double middle = (low + high) / 2;
        (speed_down(model, cells, middle, friction) > 0.01 ? high : low) = middle;
    }
    return {finding("slides from tan", "", std::tan((low + high) / 2), friction),
            finding("speed after 1 s at 34 degrees", "m/s", speed_down(model, cells, steep, friction),
                    slope_acceleration(steep, friction, Experiment::gravity))};
}

/// A strip over a cylinder of 5 cm radius, with 20 cm on one side and 30 cm on the other.
struct Capstan {
    static constexpr double cylinder = 0.05, shorter = 0.2, longer = 0.3;

    explicit Capstan(const ClothSettings& settings)
        : radius(cylinder + static_cast<double>(settings.thickness)), arc(std::numbers::pi * radius) {}

    /// Position of a point of the pattern, whose x runs along the strip from its shorter end.
    [[nodiscard]] Vec3 place(Vec2 p) const {
        const double along = static_cast<double>(p.x), up = along - shorter, down = up - arc;
        const double angle = std::clamp(up, 0.0, arc) / radius;
        const double below = up < 0 ? up : down > 0 ? -down : 0;
        return {static_cast<float>(-radius * std::cos(angle)),
                static_cast<float>(radius * std::sin(angle) + below), p.y};
    }

    double radius, arc;
};

bool slips(ForceModel model, std::uint32_t cells, double friction) {
    Fabric fabric;
    fabric.warp = fabric.weft = 4000;
    fabric.shear = 1000;
    fabric.bending = 1e-6f;
    const ClothSettings settings = made_of(model, fabric);
    const Capstan capstan(settings);
    Experiment strip(strip_mesh(model, {Capstan::shorter + capstan.arc + Capstan::longer, 0.05, cells},
                                [&](Vec2 p) { return capstan.place(p); }),
                     settings);
    add(strip, {.shape = Capsule{{0, 0, -1}, {0, 0, 1}, static_cast<float>(Capstan::cylinder)},
                .friction = static_cast<float>(friction)});
    const auto end = strip.vertices([](Vec2 p) { return p.x < 1e-6f; });
    // High friction holds the strip at first, so that it begins with the theory's lengths.
    constexpr float held = 100;
    strip.change([](ClothSettings& each) { each.friction = held; });
    strip.come_to_rest(10, 3, 1e-4f);
    strip.change([](ClothSettings& each) {
        each.friction = 1;
        each.air_damping = 2;
    });
    strip.run(0.5);
    const double before = static_cast<double>(strip.mean_place(end).y);
    strip.run(1);
    return static_cast<double>(strip.mean_place(end).y) - before > 0.002;
}

Finding capstan(ForceModel model, std::uint32_t cells) {
    double low = 0.01, high = 0.6;
    while (high - low > 1e-3) {
        const double middle = (low + high) / 2;
        (slips(model, cells, middle) ? low : high) = middle;
    }
    const Capstan set_up{ClothSettings{}};
    return finding("friction that holds", "", (low + high) / 2,
                   capstan_friction(Capstan::shorter, Capstan::longer, set_up.radius));
}

}  // namespace

std::vector<PhysicsTest> contact_tests() {
    std::vector<PhysicsTest> tests;
    for (const ForceModel model : force_models) {
        for (const std::uint32_t cells : {16u, 32u})
            tests.push_back({"slope", model, cells, cells == 16, [=] { return slope(model, cells); }});
        for (const std::uint32_t cells : {40u, 80u})
            tests.push_back({"capstan", model, cells, cells == 40,
                             [=] { return std::vector<Finding>{capstan(model, cells)}; }});
    }
    return tests;
}

}  // namespace weft::study
