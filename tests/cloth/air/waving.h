#pragma once
// Cloths in motion and their levels, for tests of multigrid.

#include <cmath>
#include <memory>
#include <span>

#include "cloth/solver/levels/multigrid.h"
#include "cloth/solver/make_system.h"
#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"

namespace weft::test {

inline ClothSettings stiff(float stretch = 400) {
    ClothSettings settings;
    settings.fabric = {.areal_density = 0.2f,
                       .warp = stretch,
                       .weft = stretch,
                       .shear = 0.25f * stretch,
                       .bending = 5e-8f * stretch};
    return settings;
}

/// A cloth of game stiffness, out of its plane and moving smoothly.
inline Cloth waving(const Mesh& mesh, std::span<const std::uint32_t> pins,
                    const ClothSettings& settings = stiff()) {
    Cloth cloth(cook(mesh).value(), settings);
    for (std::uint32_t i = 0; i < cloth.state.size(); ++i) {
        Vec4& x = cloth.state.positions[i];
        cloth.state.velocities[i] = {0.3f * std::sin(5 * x.z), -1 + 0.5f * std::cos(4 * x.x), 0.2f * x.x, 0};
        x.y += 0.02f * std::sin(9 * x.x + 4 * x.z);
        x.x += 0.01f * std::sin(7 * x.z);
    }
    for (const std::uint32_t pin : pins) cloth.pin(pin);
    return cloth;
}

/// A cloth's system about where inertia leads, and its levels.
struct Levels {
    explicit Levels(const Cloth& cloth) : system(make_system(cloth.model, cloth.settings)) {
        system->linearise(serial, equation_of(cloth, h), cloth.state.velocities.span(),
                          LinearisedAbout::iterate);
        multigrid = std::make_unique<Multigrid>(serial, *system, cloth.state.positions.span());
        multigrid->build(serial);
    }
    explicit Levels(Cloth&&) = delete;  // it is referred to
    Parallel serial{1};
    std::unique_ptr<ImplicitSystem> system;
    std::unique_ptr<Multigrid> multigrid;
};

/// `count` meshes side by side in one.
inline Mesh many(const Mesh& one, std::uint32_t count) {
    Mesh result;
    const auto n = static_cast<std::uint32_t>(one.positions.size());
    for (std::uint32_t k = 0; k < count; ++k) {
        for (const Vec3& x : one.positions)
            result.positions.push_back({x.x + 2.0f * static_cast<float>(k), x.y, x.z});
        for (const Triangle& t : one.triangles)
            result.triangles.push_back({t[0] + k * n, t[1] + k * n, t[2] + k * n});
    }
    return result;
}

}  // namespace weft::test
