// Cloth over a round table: the drape coefficient of Cusick's tester (1965), which the mesh must not change.

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "demo/learn/drape.h"
#include "demo/study/physics/experiment.h"
#include "demo/study/physics/physics_table.h"

namespace weft::study {

namespace {

using std::numbers::pi;

constexpr double table_radius = 0.09, disc_radius = 0.15;  // radii [m]

struct Drape {
    double coefficient;  ///< share of the ring beyond the table that still shades the floor
    int folds;           ///< the strongest wave of the rim's distance from the axis
    std::uint32_t vertices;
};

/// The strongest wave of the rim's distance from the axis. `rim`: vertices evenly spread in angle.
int strongest_wave(const Experiment& cloth, const std::vector<std::uint32_t>& rim) {
    double most = 0;
    int best = 0;
    for (int wave = 2; wave <= 24; ++wave) {
        std::complex<double> sum = 0;
        for (const std::uint32_t vertex : rim) {
            const Vec2 q = cloth.mesh().pattern[vertex];
            const Vec3 p = cloth.at(vertex);
            sum += static_cast<double>(std::hypot(p.x, p.z)) *
                   std::polar(1.0, wave * std::atan2(static_cast<double>(q.y), static_cast<double>(q.x)));
        }
        if (std::abs(sum) > most) {
            most = std::abs(sum);
            best = wave;
        }
    }
    return best;
}

Vec3 almost_flat(Vec2 p) {
    std::uint32_t bits = 0;
    for (const float each : {p.x, p.y})
        bits = bits * 7919u + static_cast<std::uint32_t>(std::lround(each * 1e5f));
    return {p.x, std::hypot(p.x, p.y) < 0.091f ? 0 : 2e-4f * noise(bits), p.y};
}

/// Drapes a mesh over a table of 18 cm diameter. Bumps of 0.2 mm decide where folds begin; rounding would
/// without them.
Drape hang(Mesh mesh, const ClothSettings& settings, double flat_area,
           const std::function<bool(Vec2)>& is_rim) {
    for (std::size_t i = 0; i < mesh.pattern.size(); ++i) mesh.positions[i] = almost_flat(mesh.pattern[i]);
    Experiment cloth(mesh, settings);
    cloth.pin([](Vec2 p) { return std::hypot(p.x, p.y) < static_cast<float>(table_radius) * 1.0001f; });
    cloth.change([](ClothSettings& each) { each.air_damping = 1; });
    cloth.run(2);
    cloth.come_to_rest(3, 18, 1e-3f);
    const auto shadow = static_cast<double>(demo::shadow_area(mesh, *cloth.world().cloth(cloth.cloth())));
    const double table_area = pi * table_radius * table_radius;
    return {(shadow - table_area) / (flat_area - table_area), strongest_wave(cloth, cloth.vertices(is_rim)),
            static_cast<std::uint32_t>(mesh.pattern.size())};
}

Drape drape_of(ForceModel model, double bending, std::uint32_t rings) {
    Fabric fabric;
    fabric.areal_density = 0.2f;
    fabric.bending = static_cast<float>(bending);
    const ClothSettings settings = made_of(model, fabric);
    if (model != ForceModel::sheet) {
        // Area of the regular polygon that the rim is.
        const double corners = 6 * rings,
                     flat = 0.5 * corners * disc_radius * disc_radius * std::sin(2 * pi / corners);
        return hang(demo::drape_disc(static_cast<float>(disc_radius), rings, {}), settings, flat,
                    [](Vec2 p) { return std::hypot(p.x, p.y) > static_cast<float>(disc_radius) * 0.9999f; });
    }
    // A square of the disc's area, since sheets are rectangles.
    const double side = disc_radius * std::sqrt(pi);
    const std::uint32_t cells = static_cast<std::uint32_t>(std::lround(std::sqrt(3.0) * rings));
    Mesh mesh = strip_mesh(model, {side, side, cells}, [](Vec2) { return Vec3{}; });
    const auto half = static_cast<float>(side / 2);
    for (Vec2& p : mesh.pattern) p = {p.x - half, p.y - half};
    return hang(std::move(mesh), settings, side * side,
                [half](Vec2 p) { return std::max(std::abs(p.x), std::abs(p.y)) > half * 0.9999f; });
}

/// The known value is that of the finest resolution, plus or minus 0.05.
std::vector<Finding> resolutions(ForceModel model, double bending, const std::vector<std::uint32_t>& rings) {
    std::vector<Drape> drapes;
    for (const std::uint32_t each : rings) drapes.push_back(drape_of(model, bending, each));
    std::vector<Finding> findings;
    for (const Drape& drape : drapes) {
        const double finest = drapes.back().coefficient;
        findings.push_back(
            {"drape coefficient", "", drape.coefficient, finest - 0.05, finest + 0.05, drape.vertices});
        findings.push_back(
            {.quantity = "folds", .unit = "", .measured = 1.0 * drape.folds, .cells = drape.vertices});
    }
    return findings;
}

}  // namespace

std::vector<PhysicsTest> drape_tests() {
    std::vector<PhysicsTest> tests;
    for (const ForceModel model : force_models) {
        for (const auto& [name, bending] :
             {std::pair("Cusick, B = 1e-5 N m", 1e-5), {"Cusick, B = 1e-4 N m", 1e-4}}) {
            tests.push_back({name, model, 45, false, [=, b = bending] {
                                 return resolutions(model, b, {15, 20, 30, 45});
                             }});
            tests.push_back({std::string(name) + ", coarse", model, 20, true, [=, b = bending] {
                                 return resolutions(model, b, {15, 20});
                             }});
        }
    }
    return tests;
}

}  // namespace weft::study
