// Normals, air forces and gusts against one triangle and one place at a time. tests/targets compares vector
// widths.

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <random>

#include "cloth/air/gusts.h"
#include "cloth/air/surface.h"
#include "hwy/targets.h"
#include "tests/cloth/fixtures.h"
#include "tests/cloth/material/plate_force.h"
#include "tests/cloth/meshes.h"
#include "value_noise.h"

namespace weft::test {
namespace {

constexpr Wind breeze{
    .velocity = {3, 0.5f, -1}, .gust = 0.3f, .air_density = 1.2f, .drag = 1.1f, .lift = 0.7f};

/// A cloth that moves in gusty air, some of its triangles without an area.
struct Scene {
    explicit Scene(const Mesh& mesh) : cloth(crumpled(mesh, 0.02f, 10)), air(cloth.model.particle_count) {
        std::mt19937 random(3);
        std::normal_distribution<float> component(0, 3);
        for (Vec4& v : air.span()) v = {component(random), component(random), component(random), 0};
        const auto collapse = [&](std::uint32_t from, std::uint32_t onto) {
            set_xyz(cloth.state.positions[from], xyz(cloth.state.positions[onto]));
        };
        for (std::size_t t = 0; t < cloth.model.triangles.size(); t += 37)
            for (const std::uint32_t k : {1u, 2u})
                collapse(cloth.model.triangles[t][k], cloth.model.triangles[t][0]);
    }
    [[nodiscard]] Vector3 doubled_area_normal(const Triangle& t) const {
        const auto x = [&](std::uint32_t k) { return xyz(cloth.state.positions[t[k]]); };
        return (x(1) - x(0)).cross(x(2) - x(0));
    }
    void compute(Parallel& parallel, bool gusts) {
        cloth.surface.compute_normals(parallel, cloth.state.positions.span(), cloth.state.normals.span());
        cloth.take_air(cloth.make_air(true, false));
        cloth.surface.compute_air_forces(parallel,
                                         {.wind = &breeze,
                                          .air_velocities = gusts ? air.span() : std::span<Vec4>(),
                                          .positions = cloth.state.positions.span(),
                                          .velocities = cloth.state.velocities.span(),
                                          .from_velocities = cloth.state.velocities.span()},
                                         true, cloth.air.forces.span());
    }

    Cloth cloth;
    AlignedBuffer<Vec4> air;
};

std::vector<NamedMesh> meshes() {
    std::vector<NamedMesh> all = sound_meshes();
    all.push_back({"sheet", sheet(31, 40)});
    all.push_back({"whole groups", sheet(8, 32)});
    all.push_back({"narrow sheet", sheet(40, 2)});
    all.push_back({"a group's columns", sheet(40, 16)});
    all.push_back({"a far corner in whole groups", sheet(20, 31)});
    all.push_back({"sheet cut evenly", evenly_cut({.rows = 9, .columns = 21})});
    all.push_back({"sheet as a mesh", loose_sheet(31, 40)});
    all.push_back({"one triangle", fan(1)});
    if (const char* data = std::getenv("WEFT_DATA"))
        all.push_back(
            {"garment", must(load_obj(std::filesystem::path(data) / "garments" / "tshirt-iso-m.obj"))});
    return all;
}

class AirKernels : public testing::TestWithParam<std::int64_t> {
  protected:
    void SetUp() override { hwy::SetSupportedTargetsForTest(GetParam()); }
    void TearDown() override { hwy::SetSupportedTargetsForTest(0); }
    Parallel serial{1};
};

TEST_P(AirKernels, ForcesAreAThirdOfEachTrianglesForce) {
    for (const NamedMesh& named : meshes()) {
        for (const bool gusts : {false, true}) {
            SCOPED_TRACE(named.name + (gusts ? ", gusts" : ""));
            Scene scene(named.mesh);
            scene.compute(serial, gusts);
            const Cloth& cloth = scene.cloth;
            const std::uint32_t n = cloth.model.particle_count;
            std::vector<Eigen::Vector4d> expected(n, Eigen::Vector4d::Zero());
            std::vector<double> sizes(n, 0);
            for (const Triangle& t : cloth.model.triangles) {
                Vector3 u = Vector3::Zero();
                for (const std::uint32_t i : t)
                    u += (gusts ? xyz(scene.air[i]) : to_vector(breeze.velocity)) -
                         xyz(cloth.state.velocities[i]);
                const PlateForce plate = plate_force(u / 3, 0.5f * scene.doubled_area_normal(t), breeze);
                for (const std::uint32_t i : t) {
                    expected[i].head<3>() += plate.force.cast<double>() / 3;
                    expected[i].w() += static_cast<double>(plate.slope) / 3;
                    sizes[i] += static_cast<double>(plate.force.norm() + plate.slope) / 3;
                }
            }
            for (std::uint32_t i = 0; i < n; ++i)
                EXPECT_LE((load(cloth.air.forces[i]).cast<double>() - expected[i]).norm(),
                          3e-6 * sizes[i] + 1e-12)
                    << "particle " << i;
        }
    }
}

TEST_P(AirKernels, ForcesAreHandedOnAlongTheirSlope) {
    for (const NamedMesh& named : meshes()) {
        SCOPED_TRACE(named.name);
        Scene scene(named.mesh);
        scene.compute(serial, false);
        Cloth& cloth = scene.cloth;
        AlignedBuffer<Vec4> from(cloth.model.particle_count), forces(cloth.model.particle_count);
        for (std::uint32_t i = 0; i < from.size(); ++i)
            from[i] = to_vec4(Vector3(0.1f * static_cast<float>(i % 7), -0.3f, 0.2f), 0);
        cloth.surface.compute_air_forces(serial,
                                         {.wind = &breeze,
                                          .air_velocities = {},
                                          .positions = cloth.state.positions.span(),
                                          .velocities = cloth.state.velocities.span(),
                                          .from_velocities = from.span()},
                                         false, forces.span());
        for (std::uint32_t i = 0; i < from.size(); ++i) {
            const Vec4 &there = cloth.air.forces[i], &here = forces[i];
            EXPECT_EQ(here.w, there.w);
            const Vector3 since = xyz(cloth.state.velocities[i]) - xyz(from[i]);
            const Vector3 expected = xyz(there) + there.w * since;
            EXPECT_LE((xyz(here) - expected).norm(), 1e-6f * (xyz(there).norm() + there.w * since.norm()))
                << "particle " << i;
        }
    }
}

TEST_P(AirKernels, NormalsAreMeansByArea) {
    for (const NamedMesh& named : meshes()) {
        SCOPED_TRACE(named.name);
        Scene scene(named.mesh);
        scene.compute(serial, false);
        const Cloth& cloth = scene.cloth;
        const std::uint32_t n = cloth.model.particle_count;
        std::vector<Eigen::Vector3d> sums(n, Eigen::Vector3d::Zero());
        std::vector<double> sizes(n, 0);
        for (const Triangle& t : cloth.model.triangles) {
            const Eigen::Vector3d normal = scene.doubled_area_normal(t).cast<double>();
            const float longest =
                std::max((xyz(cloth.state.positions[t[1]]) - xyz(cloth.state.positions[t[0]])).norm(),
                         (xyz(cloth.state.positions[t[2]]) - xyz(cloth.state.positions[t[0]])).norm());
            for (const std::uint32_t i : t) {
                sums[i] += normal;
                sizes[i] += static_cast<double>(longest * longest);
            }
        }
        for (std::uint32_t i = 0; i < n; ++i) {
            const Eigen::Vector3d found = xyz(cloth.state.normals[i]).cast<double>();
            if (sums[i].norm() == 0) {
                EXPECT_EQ(found, Eigen::Vector3d(0, 1, 0)) << "particle " << i;
            } else {
                EXPECT_NEAR(found.norm(), 1, 1e-6);
                EXPECT_LE((sums[i].norm() * found - sums[i]).norm(), 1e-6 * sizes[i]) << "particle " << i;
            }
            EXPECT_EQ(cloth.state.normals[i].w, 0);
        }
    }
}

TEST_P(AirKernels, GustsAreTheNoiseAsItIsDefined) {
    Cloth cloth(cook(sheet(23, 29)).value(), {});
    std::mt19937 random(8);
    std::uniform_real_distribution<float> place(-30, 30);
    for (Vec4& x : cloth.state.positions.span()) x = {place(random), place(random), place(random), 5};
    cloth.state.positions[7] = {0, -1, 2, 0};  // on lattice planes
    const WindField field({.velocity = {4, 1, 0}, .gust = 0.5f, .gust_length = 1, .seed = 9}, {}, 0);
    AlignedBuffer<Vec4> air(cloth.state.size());
    field.sample(serial, cloth.state.positions.span(), air.span());
    for (std::uint32_t i = 0; i < cloth.state.size(); ++i) {
        const Vector3 expected = gusty_velocity(field, xyz(cloth.state.positions[i]));
        EXPECT_LE((xyz(air[i]) - expected).norm(), 3e-4f * field.amplitude) << "particle " << i;
        EXPECT_EQ(air[i].w, 0);
    }
}

INSTANTIATE_TEST_SUITE_P(Targets, AirKernels, testing::ValuesIn(hwy::SupportedAndGeneratedTargets()),
                         [](const auto& info) { return std::string(hwy::TargetName(info.param)); });

// What the air of a step's first substep rests on: whatever has happened to the cloth, the last step left the
// normals of the positions at which the next one begins.
TEST(Normals, AreThoseOfThePresentPositionsWheneverAStepBegins) {
    WorldSettings settings;
    settings.threads = 1;
    settings.wind = breeze;
    Simulation simulation(settings);
    const ClothId id = simulation.add(std::make_unique<Cloth>(cook(sheet(9, 11)).value(), ClothSettings()));
    Cloth& cloth = **simulation.cloths.find(id);
    simulation.prepare(cloth);
    const auto expect_current = [&](const char* when) {
        AlignedBuffer<Vec4> fresh(cloth.state.size());
        Surface(cloth.model).compute_normals(simulation.parallel, cloth.state.positions.span(), fresh.span());
        EXPECT_EQ(std::memcmp(fresh.data(), cloth.state.normals.data(), fresh.bytes()), 0) << when;
    };
    const auto step = [&](const char* when) {
        expect_current(when);
        simulation.step(1.0f / 60);
    };
    step("before the first step");
    cloth.pin(3);
    cloth.state.pins[0].target += Vector3(0.1f, 0.2f, 0);
    step("with a pin that moves");
    settings.substeps = 3;
    simulation.apply(settings);
    step("with substeps");
    settings.wind.air_density = 0;
    simulation.apply(settings);
    step("without air");
    settings.wind.air_density = 1;
    simulation.apply(settings);
    cloth.unpin(3);
    cloth.state.velocities[7].x = std::numeric_limits<float>::quiet_NaN();
    step("with a state that is not finite");
    EXPECT_EQ(simulation.report.restored_cloths, 1u);
    step("when it is restored");
    expect_current("at last");
}

void update_normals(Cloth& cloth) {
    Parallel serial(1);
    cloth.surface.compute_normals(serial, cloth.state.positions.span(), cloth.state.normals.span());
}

TEST(Normals, OfASphereAreRadial) {
    Cloth cloth(cook(sphere(3)).value(), {});
    update_normals(cloth);
    for (std::uint32_t i = 0; i < cloth.state.size(); ++i) {
        const Vector3 radial = xyz(cloth.state.positions[i]).normalized();
        EXPECT_GT(xyz(cloth.state.normals[i]).dot(radial), 0.999f) << "particle " << i;
        EXPECT_NEAR(xyz(cloth.state.normals[i]).norm(), 1, 1e-6f);
    }
}

TEST(Normals, OfACollapsedClothAreStillUnitVectors) {
    Cloth cloth(cook(sheet(4, 4)).value(), {});
    for (Vec4& x : cloth.state.positions.span()) x = {1, 2, 3, x.w};
    update_normals(cloth);
    for (const Vec4& n : cloth.state.normals.span()) EXPECT_EQ(xyz(n), Vector3(0, 1, 0));
}

}  // namespace
}  // namespace weft::test
