// What every method must do, whatever it is: measure what it leaves of the step's equation by one figure,
// come to rest where the cloth hangs, land, recover, and know which settings it was made for.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>

#include "cloth/instance/make_solver.h"
#include "cloth/solver/step_residual.h"
#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"

namespace weft::test {
namespace {

struct SteppedMethod {
    const char* name;
    Method method;
    int substeps = 1;
};

std::vector<SteppedMethod> all_methods() {
    return {{"Multilevel", Multilevel{}},
            {"Jacobi", Jacobi{}},
            {"Chebyshev", Chebyshev{}},
            {"ConjugateGradient", ConjugateGradient{}},
            {"Xpbd", Xpbd{}, 8},
            {"Fibres", Fibres{}, 4},
            {"SymplecticEuler", SymplecticEuler{}, 64}};
}

ClothSettings settings_of(const SteppedMethod& method) {
    ClothSettings settings;
    settings.method = method.method;
    settings.substeps = method.substeps;
    return settings;
}

class EachMethod : public testing::TestWithParam<SteppedMethod> {};
INSTANTIATE_TEST_SUITE_P(, EachMethod, testing::ValuesIn(all_methods()),
                         [](const auto& info) { return std::string(info.param.name); });

/// The residual of one step of a crumpled cloth, of which two corners are pinned.
float residual_of_a_step(const Method& method, bool elements = false, bool bends = true) {
    Cloth cloth = crumpled(sheet(9, 8), 0.01f, 100);
    ClothSettings settings = cloth.settings;
    settings.method = method;
    settings.finite_elements = {.enabled = elements};
    if (elements) settings.fabric = {.warp = 100, .weft = 100, .shear = 30};
    if (!bends) settings.fabric.bending = 0;
    cloth.apply(settings);
    cloth.pin(0);
    cloth.pin(7);
    Parallel serial(1);
    Profiler profiler(stage_names);
    cloth.solver->lay_out_alone();
    return cloth.solver
        ->solve({.parallel = serial,
                 .profiler = profiler,
                 .model = cloth.model,
                 .settings = cloth.settings,
                 .equation = equation_of(cloth, h),
                 .velocities = cloth.scratch_velocities.span()})
        .residual;
}

TEST(Residual, IsNothingWhereTheEquationIsSolved) {
    for (const bool elements : {false, true})
        EXPECT_LT(residual_of_a_step(Multilevel{.passes = 300}, elements), 1e-3f) << elements;
    EXPECT_LT(residual_of_a_step(Xpbd{3000}, false, false), 0.02f);
    EXPECT_LT(residual_of_a_step(Fibres{3000}, false, false), 0.02f);
}

TEST(Residual, IsTheSameForMethodsThatFindTheSameStep) {
    const float converged = residual_of_a_step(ConjugateGradient{400});
    EXPECT_NEAR(residual_of_a_step(Chebyshev{2000}), converged, 0.02f * converged);
    EXPECT_NEAR(residual_of_a_step(Jacobi{6001}), converged, 0.02f * converged);
}

TEST(Residual, IsSmallOnGarmentsThatHang) {
    const char* data = std::getenv("WEFT_DATA");
    if (data == nullptr) GTEST_SKIP() << "set WEFT_DATA to the folder of test data, which has garments/*.obj";
    for (const char* name : {"skirt-coarse", "tshirt-iso", "dress-victor-iso-draped"}) {
        const Mesh mesh =
            load_obj(std::filesystem::path(data) / "garments" / (std::string(name) + ".obj")).value();
        World world = World::create(vacuum({0, -9.81f, 0})).value();
        const ClothId id = world.add_cloth(mesh).value();
        const ClothView view = world.cloth(id).value();
        for (std::uint32_t v = 0; v < view.vertex_to_particle.size(); ++v) {
            const float top = view.bounds.upper.y;
            if (view.positions[view.vertex_to_particle[v]].y > top - 0.01f) {
                ASSERT_TRUE(world.pin(id, v));
            }
        }
        // A garment's start is no state of rest, and a fold that snaps leaves much for a step.
        float sum = 0;
        int high = 0;
        for (int frame = 0; frame < 60; ++frame) {
            const float residual = world.step(h).residual;
            sum += residual;
            high += residual > 0.5f;
        }
        EXPECT_LT(sum / 60, 0.6f) << name;
        EXPECT_LE(high, 16) << name;
        EXPECT_LT(world.report().residual, 0.6f) << name;
    }
}

float height_of(const World& world, ClothId id) {
    double sum = 0;
    const auto positions = world.cloth(id)->positions;
    for (const Vec4& x : positions) sum += static_cast<double>(x.y);
    return static_cast<float>(sum / static_cast<double>(positions.size()));
}

/// The mean height of a sheet that has hung by two corners for 10 s, and how fast it still moves.
std::pair<float, float> hung(float damping) {
    World world = World::create(vacuum({0, -9.81f, 0})).value();
    ClothSettings settings;
    settings.fabric.damping = damping;
    settings.air_damping = 1;
    const ClothId id = world.add_cloth(sheet(24, 24), settings).value();
    EXPECT_TRUE(world.pin(id, 0) && world.pin(id, 23));
    for (int frame = 0; frame < 600; ++frame) world.step(h);
    return {height_of(world, id), world.report().peak_speed};
}

TEST(SpringDamping, DoesNotChangeWhereClothHangsHoweverStiff) {
    const auto [expected, unrest] = hung(0);
    EXPECT_LT(unrest, 0.1f);
    for (const float damping : {2e-4f, 0.01f, 0.1f}) {
        const auto [height, speed] = hung(damping);
        EXPECT_NEAR(height, expected, 5e-3f) << damping << " s";
        EXPECT_LT(speed, 0.1f) << damping << " s";
    }
}

TEST_P(EachMethod, LandsFlatOnAPlaneAndStaysThere) {
    for (const float height : {0.5f, 1.0f}) {
        World world = World::create(vacuum({0, -9.81f, 0})).value();
        Mesh mesh = sheet(32, 32);
        for (Vec3& x : mesh.positions) x.y += height;
        ClothSettings settings = settings_of(GetParam());
        if (std::holds_alternative<SymplecticEuler>(settings.method))
            settings.fabric = {.warp = 40, .weft = 40, .shear = 10, .bending = 0};
        const ClothId id = world.add_cloth(mesh, settings).value();
        ASSERT_TRUE(world.add_collider({.shape = Plane{}}));
        float up = 0;
        for (int frame = 0; frame < 90; ++frame) {
            world.step(h);
            const ClothView view = world.cloth(id).value();
            for (const Vec4& v : view.velocities) up = std::max(up, v.y);
        }
        EXPECT_LT(up, 0.5f) << "from " << height << " m: it landed at " << std::sqrt(2 * 9.81f * height);
        EXPECT_NEAR(height_of(world, id), 0.005f, 0.01f);
    }
}

TEST_P(EachMethod, PiecesFallFreelyBesideOneThatLies) {
    World world = World::create(vacuum({0, -9.81f, 0})).value();
    Mesh lying = loose_sheet(9, 9), falling = loose_sheet(8, 8);
    for (Vec3& x : lying.positions) x.y = 0.005f;
    for (Vec3& x : falling.positions) x.y = 0;
    ClothSettings settings = settings_of(GetParam());
    settings.air_damping = 0;
    const ClothId id = world.add_cloth(joined(lying, falling, {3, 20, 0}), settings).value();
    ASSERT_TRUE(world.add_collider({.shape = Plane{}}));
    for (int frame = 0; frame < 60; ++frame) world.step(h);
    const ClothView cloth = world.cloth(id).value();
    int above = 0;
    for (std::size_t i = 0; i < cloth.positions.size(); ++i) {
        if (cloth.positions[i].y < 5) continue;
        ++above;
        EXPECT_NEAR(cloth.velocities[i].y, -9.81f, 0.02f);
    }
    EXPECT_EQ(above, 64);
}

TEST_P(EachMethod, GoesOnAfterAStateThatIsNotFinite) {
    for (const bool in_positions : {false, true}) {
        Simulation simulation(vacuum({0, -9.81f, 0}));
        ClothSettings settings = settings_of(GetParam());
        if (std::holds_alternative<SymplecticEuler>(settings.method))
            settings.fabric = {.warp = 40, .weft = 40, .shear = 10, .bending = 0};
        auto made = std::make_unique<Cloth>(cook(loose_sheet(9, 9)).value(), settings);
        Cloth& cloth = *made;
        cloth.pin(0);
        simulation.prepare(cloth);
        simulation.add(std::move(made));
        for (int frame = 0; frame < 5; ++frame) simulation.step(h);
        ASSERT_EQ(simulation.report.restored_cloths, 0u);
        const std::vector<Vec4> sound(cloth.state.positions.data(),
                                      cloth.state.positions.data() + cloth.state.size());
        constexpr float nan = std::numeric_limits<float>::quiet_NaN();
        for (Vec4& row : (in_positions ? cloth.state.positions : cloth.state.velocities).span())
            set_xyz(row, {nan, nan, nan});
        simulation.step(h);
        EXPECT_EQ(simulation.report.restored_cloths, 1u);
        if (in_positions) std::ranges::copy(sound, cloth.state.positions.data());
        std::ranges::fill(cloth.state.velocities.span(), Vec4{});
        const float before = cloth.state.positions[80].y;
        for (int frame = 0; frame < 20; ++frame) {
            simulation.step(h);
            ASSERT_EQ(simulation.report.restored_cloths, 0u) << frame;
        }
        EXPECT_LT(cloth.state.positions[80].y, before - 0.1f) << "it falls on";
    }
}

// What a solver keeps of pins and settings that have gone shows in bytes.
TEST_P(EachMethod, DoesNotDependOnThePathThatSettingsAndPinsTook) {
    const auto run = [&](bool detour) {
        World world = World::create(vacuum({0, -9.81f, 0})).value();
        ClothSettings settings = settings_of(GetParam());
        settings.fabric = {.warp = 40, .weft = 40, .shear = 10, .bending = 2e-5f};
        ClothSettings other = settings;
        other.fabric = {
            .areal_density = 0.4f, .warp = 60, .weft = 60, .shear = 0, .bending = 4e-5f, .damping = 0};
        if (auto* fibres = std::get_if<Fibres>(&other.method)) fibres->horizontal = Fibres::SetSolver::ldlt;
        const ClothId id = world.add_cloth(sheet(20, 17), detour ? other : settings).value();
        const auto reset = [&](ClothId cloth) {  // a step's traces in the state are not the solver's
            EXPECT_TRUE(world.set_cloth_settings(cloth, settings));
        };
        if (detour) {
            EXPECT_TRUE(world.pin(id, 40) && world.pin(id, 200));
            reset(id);
            EXPECT_TRUE(world.unpin(id, 200));
        } else {
            EXPECT_TRUE(world.pin(id, 40));
        }
        for (int frame = 0; frame < 5; ++frame) world.step(h);
        return world.state_hash();
    };
    EXPECT_EQ(run(true), run(false));
}

TEST_P(EachMethod, ServesWhatItWasMadeForAlone) {
    const Cloth cloth(cook(sheet(6, 6)).value(), settings_of(GetParam()));
    for (const SteppedMethod& other : all_methods())
        EXPECT_EQ(cloth.solver->serves(settings_of(other)), std::string(other.name) == GetParam().name);
    ClothSettings settings = cloth.settings;
    settings.friction = 0.3f;
    settings.substeps = 3;
    settings.fabric.areal_density = 1;
    EXPECT_TRUE(cloth.solver->serves(settings));
    const bool positional =
        std::holds_alternative<Xpbd>(settings.method) || std::holds_alternative<Fibres>(settings.method);
    settings.finite_elements.dihedral = true;
    EXPECT_TRUE(cloth.solver->serves(settings)) << "finite elements are off";
    settings.finite_elements.enabled = true;
    EXPECT_EQ(cloth.solver->serves(settings), positional);
}

TEST_P(EachMethod, OfElementsServesTheKindOfElementsThatItWasMadeFor) {
    ClothSettings settings = settings_of(GetParam());
    settings.finite_elements.enabled = true;
    settings.fabric.bending = 1e-5f;
    const bool positional =
        std::holds_alternative<Xpbd>(settings.method) || std::holds_alternative<Fibres>(settings.method);
    const Cloth cloth(cook(sheet(6, 6)).value(), settings);
    ASSERT_TRUE(cloth.solver->serves(settings));
    void (*const changes[])(ClothSettings&) = {
        [](ClothSettings& s) { s.finite_elements.enabled = false; },
        [](ClothSettings& s) { s.fabric.bending = 0; },
        [](ClothSettings& s) { s.finite_elements.dihedral = !s.finite_elements.dihedral; },
        [](ClothSettings& s) { s.finite_elements.consistent_mass = !s.finite_elements.consistent_mass; }};
    for (std::size_t k = 0; k < std::size(changes); ++k) {
        ClothSettings changed = settings;
        changes[k](changed);
        EXPECT_EQ(cloth.solver->serves(changed), positional) << "change " << k;
    }
    settings.fabric.bending = 2e-5f;
    EXPECT_TRUE(cloth.solver->serves(settings)) << "another rigidity is read at each step";
}

}  // namespace
}  // namespace weft::test
