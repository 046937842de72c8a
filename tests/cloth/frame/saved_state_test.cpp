// The state is all that a step goes on from: a copy of it put back, and nothing else, gives the same bytes;
// and no history of settings shows.

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "tests/cloth/fixtures.h"

namespace weft::test {
namespace {

struct SavedCase {
    std::string name;
    ClothSettings settings;
    bool grid = true;
};

std::vector<SavedCase> saved_cases() {
    std::vector<SavedCase> result;
    const auto add = [&](const char* name, const Method& method, const auto& change) {
        SavedCase made{.name = name, .settings = {}};
        made.settings.method = method;
        change(made);
        result.push_back(made);
    };
    const auto plain = [](SavedCase&) {};
    const auto bdf2 = [](SavedCase& c) { c.settings.time_scheme = TimeScheme::bdf2; };
    const auto mesh = [](SavedCase& c) { c.grid = false; };
    const auto all = [](SavedCase& c) {
        c.settings.time_scheme = TimeScheme::bdf2;
        c.settings.tethers.enabled = true;
        c.settings.self_collision.method = SelfCollisionMethod::contact;
        c.settings.substeps = 2;
    };
    const auto elements = [](SavedCase& c) {
        c.settings.finite_elements.enabled = true;
        c.settings.finite_elements.dihedral = true;
    };
    add("Multilevel", Multilevel{}, plain);
    add("MultilevelMesh", Multilevel{}, mesh);
    add("MultilevelAll", Multilevel{}, all);
    add("MultilevelElements", Multilevel{}, elements);
    add("MultilevelContact", Multilevel{},
        [](SavedCase& c) { c.settings.self_collision = {.method = SelfCollisionMethod::contact}; });
    add("Jacobi", Jacobi{}, plain);
    add("Chebyshev", Chebyshev{}, bdf2);
    add("ConjugateGradient", ConjugateGradient{}, bdf2);
    add("Xpbd", Xpbd{}, plain);
    add("Fibres", Fibres{}, plain);
    add("SymplecticEuler", SymplecticEuler{}, [](SavedCase& c) { c.settings.substeps = 64; });
    return result;
}

/// A sheet in gusty wind that is lowered onto a turning capsule and a rough plane.
struct SavedScene {
    explicit SavedScene(const SavedCase& of) : simulation(world_settings()) {
        Mesh mesh = make_sheet({.rows = 14,
                                .columns = 15,
                                .origin = {-0.3f, 0.62f, 0},
                                .u = {0.6f, 0, 0},
                                .v = {0, -0.6f, 0}})
                        .value();
        if (!of.grid) mesh.rows = mesh.columns = 0;
        auto made = std::make_unique<Cloth>(cook(mesh).value(), of.settings);
        cloth = made.get();
        simulation.prepare(*cloth);
        simulation.add(std::move(made));
        for (const Collider& collider :
             {Collider{Plane{}, 0.6f},
              Collider{Capsule{{-0.3f, 0.1f, 0.1f}, {0.3f, 0.1f, 0.1f}, 0.08f}, 0.4f}})
            simulation.state.colliders.insert({collider, collider});
        simulation.expect_colliders(2);
        for (const std::uint32_t v : {0u, 14u}) cloth->pin(cloth->model.vertex_to_particle[v]);
    }
    static WorldSettings world_settings() {
        WorldSettings settings;
        settings.wind.velocity = {1, 0, 3};
        settings.wind.gust = 0.5f;
        settings.threads = 1;
        return settings;
    }
    void run(int steps) {
        for (int k = 0; k < steps; ++k) {
            for (Pin& pin : cloth->state.pins) pin.target += Vector3(0, -0.015f, 0.004f);
            simulation.step(1.0f / 60);
        }
    }
    void restore(const ClothState& saved) {
        cloth->prepare_restore(saved.pins);
        cloth->state = saved;
        cloth->commit_restore();
    }
    /// Every byte that may change.
    [[nodiscard]] std::vector<std::byte> bytes() const {
        std::vector<std::byte> all;
        const auto append = [&](auto part) {
            const auto raw = std::as_bytes(part);
            all.insert(all.end(), raw.begin(), raw.end());
        };
        for_each_part(std::as_const(simulation.state), append);
        for_each_part(std::as_const(cloth->state), append);
        return all;
    }

    Simulation simulation;
    Cloth* cloth;
};

class SavedState : public testing::TestWithParam<SavedCase> {};
INSTANTIATE_TEST_SUITE_P(, SavedState, testing::ValuesIn(saved_cases()),
                         [](const auto& info) { return info.param.name; });

TEST_P(SavedState, PutBackGoesOnWithTheSameBytes) {
    SavedScene scene(GetParam());
    scene.run(25);
    ASSERT_GT(scene.simulation.report.collider_contacts, 0u);
    const WorldState world = scene.simulation.state;
    const ClothState cloth = scene.cloth->state;
    scene.run(15);
    const std::vector<std::byte> expected = scene.bytes();

    scene.run(5);  // what is left of other steps must not show
    scene.cloth->unpin(scene.cloth->state.pins.front().particle);
    scene.cloth->pin(40);
    scene.run(5);
    scene.simulation.state = world;
    scene.restore(cloth);
    scene.run(15);
    EXPECT_TRUE(scene.bytes() == expected);
}

TEST_P(SavedState, GoesOnInAnotherWorld) {
    SavedScene scene(GetParam()), other(GetParam());
    scene.run(25);
    other.run(3);
    other.simulation.state = scene.simulation.state;
    other.restore(scene.cloth->state);
    scene.run(10);
    other.run(10);
    EXPECT_TRUE(scene.bytes() == other.bytes());
}

TEST_P(SavedState, IsReadBackPartByPart) {
    SavedScene scene(GetParam());
    scene.run(25);
    const std::vector<std::byte> written = scene.bytes();
    ClothState blank = scene.cloth->state;
    for (Vec4& x : blank.positions.span()) x = {};
    std::size_t at = 0;
    for_each_part(std::as_const(scene.simulation.state), [&](auto part) { at += part.size_bytes(); });
    for_each_part(blank, [&](auto part) {
        std::memcpy(part.data(), written.data() + at, part.size_bytes());
        at += part.size_bytes();
    });
    EXPECT_EQ(at, written.size());
    scene.run(5);
    const std::vector<std::byte> expected = scene.bytes();
    SavedScene other(GetParam());
    other.run(25);
    other.restore(blank);
    other.run(5);
    EXPECT_TRUE(other.bytes() == expected);
}

/// Settings that differ in all that a solver may be made from.
std::vector<ClothSettings> detours(const ClothSettings& from) {
    std::vector<ClothSettings> result;
    const auto add = [&](const auto& change) { change(result.emplace_back(from)); };
    add([](ClothSettings& s) { s.fabric.warp *= 100; });
    add([](ClothSettings& s) { s.fabric.shear = 0; });
    add([](ClothSettings& s) { s.fabric.bending = 1e-3f; });
    add([](ClothSettings& s) { s.fabric.areal_density *= 7; });
    add([](ClothSettings& s) { s.fabric.damping = 0.01f; });
    add([](ClothSettings& s) { s.method = Jacobi{}; });
    add([](ClothSettings& s) {
        s.method = Xpbd{};
        s.finite_elements = {};
    });
    add([](ClothSettings& s) {
        s.method = Fibres{.shear = Fibres::SetSolver::ldlt};
        s.finite_elements = {};
    });
    add([](ClothSettings& s) { s.method = Multilevel{.passes = 7}; });
    add([](ClothSettings& s) { s.tethers.enabled = !s.tethers.enabled; });
    return result;
}

TEST_P(SavedState, NoHistoryOfSettingsShows) {
    SavedScene plain(GetParam());
    plain.run(5);
    const WorldState world = plain.simulation.state;
    const ClothState cloth = plain.cloth->state;
    plain.run(5);
    const std::vector<std::byte> expected = plain.bytes();
    const std::vector<ClothSettings> ways = detours(GetParam().settings);
    for (std::size_t k = 0; k < ways.size(); ++k) {
        SavedScene scene(GetParam());
        scene.simulation.apply(*scene.cloth, ways[k]);
        scene.run(2);
        scene.simulation.apply(*scene.cloth, GetParam().settings);
        scene.simulation.state = world;
        scene.restore(cloth);
        scene.run(5);
        EXPECT_TRUE(scene.bytes() == expected) << "detour " << k;
    }
}

TEST(StateOfCloth, SaysHowStepsAreTaken) {
    ClothState state(4);
    state.tangles = AlignedBuffer<TangleMemory>(4);
    const auto bytes = [&] {
        std::vector<std::byte> all;
        for_each_part(std::as_const(state), [&](auto part) {
            const auto more = std::as_bytes(std::span(part));
            all.insert(all.end(), more.begin(), more.end());
        });
        return all;
    };
    const std::vector<std::byte> before = bytes();
    state.halved = 3;
    EXPECT_NE(bytes(), before);
}

}  // namespace
}  // namespace weft::test
