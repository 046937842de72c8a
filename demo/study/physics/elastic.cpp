// Stretch, shear and the catenary: the membrane's stiffness, as a tensile tester would find it.

#include <cmath>

#include "demo/study/physics/experiment.h"
#include "demo/study/physics/known_answers.h"
#include "demo/study/physics/physics_table.h"

namespace weft::study {

namespace {

constexpr double density = 0.2;  // [kg/m^2]

Fabric membrane() {
    Fabric fabric;
    fabric.areal_density = static_cast<float>(density);
    fabric.warp = 400;
    fabric.weft = 200;
    fabric.shear = 80;
    fabric.bending = 0;
    return fabric;
}

/// A strip that hangs by one end lengthens by areal density * g * L^2 / (2 K).
Finding hung_strip(ForceModel model, std::uint32_t cells, bool along_warp) {
    const Strip strip = along_warp ? Strip{1, 0.25, cells} : Strip{0.25, 1, std::max(4u, cells / 4)};
    Experiment hung(strip_mesh(model, strip,
                               [&](Vec2 p) {
                                   return along_warp ? Vec3{p.y, -p.x, 0} : Vec3{p.x, -p.y, 0};
                               }),
                    made_of(model, membrane()));
    const auto below = [along_warp](Vec2 p) { return along_warp ? p.x : p.y; };
    hung.pin([&](Vec2 p) { return below(p) < 1e-6f; });
    hung.come_to_rest(5);
    const auto end = hung.vertices([&](Vec2 p) { return below(p) > 1 - 1e-6f; });
    const double longer = -static_cast<double>(hung.mean_place(end).y) - 1;
    const double measured = density * Experiment::gravity / (2 * longer);
    return along_warp ? finding("K warp", "N/m", measured, 400) : finding("K weft", "N/m", measured, 200);
}

/// A tall panel between two upright clamps sags by areal density * g * W^2 / (8 G) in its middle.
Finding sheared_panel(ForceModel model, std::uint32_t cells) {
    constexpr double width = 0.25, heavy = 100;
    Experiment panel(strip_mesh(model, {width, 6 * width, cells},
                                [](Vec2 p) {
                                    return Vec3{p.x, p.y, 0};
                                }),
                     made_of(model, membrane()), in_vacuum({0, static_cast<float>(-heavy), 0}));
    const auto near = [](float value, double place, double reach) {
        return std::abs(static_cast<double>(value) - place) < reach;
    };
    panel.pin([&](Vec2 p) { return near(p.x, 0, 1e-6) || near(p.x, width, 1e-6); });
    panel.come_to_rest(5);
    const auto middle =
        panel.vertices([&](Vec2 p) { return near(p.x, width / 2, 1e-6) && near(p.y, 3 * width, width / 2); });
    double rest = 0;
    for (const std::uint32_t vertex : middle) rest += static_cast<double>(panel.mesh().pattern[vertex].y);
    const double sag =
        rest / static_cast<double>(middle.size()) - static_cast<double>(panel.mean_place(middle).y);
    return finding("G", "N/m", density * heavy * width * width / (8 * sag), 80);
}

/// A chain of 1 m between points 0.6 m apart.
Finding catenary(ForceModel model, std::uint32_t cells) {
    constexpr float span = 0.6f;
    Fabric fabric = membrane();
    fabric.warp = fabric.weft = 10'000;
    fabric.shear = 1000;
    Experiment chain(strip_mesh(model, {1, 0.1, cells},
                                [](Vec2 p) {
                                    return Vec3{span * p.x, -0.8f * (0.5f - std::abs(p.x - 0.5f)), p.y};
                                }),
                     made_of(model, fabric));
    chain.pin([](Vec2 p) { return p.x < 1e-6f || p.x > 1 - 1e-6f; });
    chain.come_to_rest(4, 30, 1e-4f);
    const auto middle = chain.vertices([](Vec2 p) { return std::abs(p.x - 0.5f) < 1e-6f; });
    return finding("sag", "m", -static_cast<double>(chain.mean_place(middle).y),
                   catenary_sag(static_cast<double>(span), 1));
}

}  // namespace

std::vector<PhysicsTest> membrane_tests() {
    std::vector<PhysicsTest> tests;
    for (const ForceModel model : force_models) {
        for (const std::uint32_t cells : {16u, 32u}) {
            const bool quick = cells == 16;
            const auto add = [&](const char* name, auto measure) {
                tests.push_back(
                    {name, model, cells, quick, [=] { return std::vector<Finding>{measure(model, cells)}; }});
            };
            add("hung strip, warp", [](ForceModel m, std::uint32_t n) { return hung_strip(m, n, true); });
            add("hung strip, weft", [](ForceModel m, std::uint32_t n) { return hung_strip(m, n, false); });
            add("sheared panel", sheared_panel);
            add("catenary", catenary);
        }
    }
    return tests;
}

// A strip held at one end: lying, it bends (cantilever); upright, it gives way sideways (lateral buckling).

namespace {

constexpr double length = 0.2;  // [m]

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

/// A fabric of which a strip of this free length [m] has this ratio Gamma of weight to rigidity.
Fabric fabric_of(double gamma, double free_length, float warp, float shear) {
    Fabric fabric;
    fabric.areal_density = static_cast<float>(density);
    fabric.warp = fabric.weft = warp;
    fabric.shear = shear;
    fabric.bending = static_cast<float>(density * Experiment::gravity * std::pow(free_length, 3) / gamma);
    return fabric;
}

std::vector<Finding> cantilever(ForceModel model, std::uint32_t cells, double gamma) {
    const Clamp clamp(cells);
    Experiment strip(strip_mesh(model, {length, 0.05, cells},
                                [](Vec2 p) {
                                    return Vec3{p.x, 0, p.y};
                                }),
                     made_of(model, fabric_of(gamma, clamp.free_length(), 2000, 500)));
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
    // The strip is so stiff in its own plane that it does not bend there: K w^3 / 12 against B w.
    const Fabric fabric = fabric_of(gamma, clamp.free_length(), 2e4f, 8e3f);
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
