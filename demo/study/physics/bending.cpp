// A strip held at one end: lying, it bends (cantilever); upright, it gives way sideways (lateral buckling).

#include <cmath>

#include "demo/study/physics/experiment.h"
#include "demo/study/physics/known_answers.h"
#include "demo/study/physics/physics_test.h"

namespace weft::study {

namespace {

constexpr double density = 0.2, length = 0.2;  // [kg/m^2], [m]

/// Two columns are pinned. The bend between pinned and free cells is concentrated at the last pinned column.
/// Half of that bend is the clamp's, so that the strip begins half a cell before the last pinned particles.
struct Clamp {
    double last, begins;  ///< [m]
    explicit Clamp(std::uint32_t cells) : last(length / cells), begins(0.5 * last) {}
    [[nodiscard]] double free_length() const { return length - begins; }
    void hold(Experiment& strip) const {
        strip.pin([end = static_cast<float>(last * 1.001)](Vec2 p) { return p.x < end; });
    }
};

std::vector<std::uint32_t> free_end(const Experiment& strip) {
    return strip.vertices([](Vec2 p) { return p.x > static_cast<float>(length) * 0.9999f; });
}

double rigidity(double gamma, double free_length) {
    return density * Experiment::gravity * std::pow(free_length, 3) / gamma;
}

std::vector<Finding> cantilever(ForceModel model, std::uint32_t cells, double gamma) {
    const Clamp clamp(cells);
    Fabric fabric;
    fabric.areal_density = static_cast<float>(density);
    fabric.warp = fabric.weft = 2000;
    fabric.shear = 500;
    fabric.bending = static_cast<float>(rigidity(gamma, clamp.free_length()));
    Experiment strip(strip_mesh(model, {length, 0.05, cells},
                                [](Vec2 p) {
                                    return Vec3{p.x, 0, p.y};
                                }),
                     made_of(model, fabric));
    clamp.hold(strip);
    strip.come_to_rest(10);
    const Vec3 end = strip.mean_place(free_end(strip));
    const HangingStrip measured{-static_cast<double>(end.y) / clamp.free_length(),
                                (static_cast<double>(end.x) - clamp.begins) / clamp.free_length()};
    const HangingStrip known = heavy_elastica(gamma);
    return {finding("drop", "lengths", measured.drop, known.drop),
            finding("chord", "degrees", measured.chord_degrees(), known.chord_degrees())};
}

/// Sideways deflection of the upright strip's end after a temporary push [m].
double gives_way(ForceModel model, std::uint32_t cells, double gamma) {
    const Clamp clamp(cells);
    Fabric fabric;
    fabric.areal_density = static_cast<float>(density);
    // The strip is so stiff in its own plane that it does not bend there: K w^3 / 12 against B w.
    fabric.warp = fabric.weft = 2e4f;
    fabric.shear = 8e3f;
    fabric.bending = static_cast<float>(rigidity(gamma, clamp.free_length()));
    Experiment strip(strip_mesh(model, {length, length / 8, cells},
                                [](Vec2 p) {
                                    return Vec3{p.x, p.y, 0};
                                }),
                     made_of(model, fabric), in_vacuum({0, -9.81f, 0.02f}));
    strip.change([](ClothSettings& settings) { settings.air_damping = 2; });
    clamp.hold(strip);
    strip.run(1);
    strip.change_world([](WorldSettings& settings) { settings.gravity.z = 0; });
    strip.run(9);
    return std::abs(static_cast<double>(strip.mean_place(free_end(strip)).z));
}

Finding lateral_buckling(ForceModel model, std::uint32_t cells) {
    double low = 5, high = 60;
    while (high / low > 1.01) {
        const double middle = std::sqrt(low * high);
        (gives_way(model, cells, middle) > 0.05 * length ? high : low) = middle;
    }
    return finding("Gamma", "", std::sqrt(low * high), lateral_buckling_gamma());
}

}  // namespace

std::vector<PhysicsTest> bending_tests() {
    std::vector<PhysicsTest> tests;
    for (const ForceModel model : force_models) {
        for (const std::uint32_t cells : {8u, 16u, 32u, 64u}) {
            for (const double gamma : {1.0, 5.0, 8.0042, 10.0}) {
                const std::string label =
                    gamma == 8.0042 ? "41.5 degrees" : "Gamma " + std::to_string(std::lround(gamma));
                tests.push_back({"cantilever, " + label, model, cells, cells == 16,
                                 [=] { return cantilever(model, cells, gamma); }});
            }
        }
    }
    for (const ForceModel model : force_models)
        for (const std::uint32_t cells : {16u, 32u})
            tests.push_back({"lateral buckling", model, cells, cells == 16,
                             [=] { return std::vector<Finding>{lateral_buckling(model, cells)}; }});
    return tests;
}

}  // namespace weft::study
