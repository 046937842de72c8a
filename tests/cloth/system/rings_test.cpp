// Rings of springs, on meshes of every kind: also those whose edges have more than two triangles.

#include "cloth/fabric/springs/rings.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "spring_scene.h"
#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"

namespace weft::test {
namespace {

/// Strips of triangles that share the particles along one line.
Mesh book(std::uint32_t pages) {
    constexpr std::uint32_t length = 9;
    Mesh mesh;
    for (std::uint32_t k = 0; k < length; ++k) mesh.positions.push_back({0, 0, 0.1f * static_cast<float>(k)});
    for (std::uint32_t page = 0; page < pages; ++page) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        const float angle = 6.2831853f * static_cast<float>(page) / static_cast<float>(pages);
        for (std::uint32_t k = 0; k < length; ++k)
            mesh.positions.push_back(
                {0.1f * std::cos(angle), 0.1f * std::sin(angle), 0.1f * static_cast<float>(k)});
        for (std::uint32_t k = 0; k + 1 < length; ++k) {
            mesh.triangles.push_back({k, k + 1, first + k});
            mesh.triangles.push_back({k + 1, first + k + 1, first + k});
        }
    }
    return mesh;
}

/// Cones of so many triangles each, about one particle; an open one lacks its last triangle.
Mesh cones(std::span<const std::uint32_t> sides, bool last_is_open) {
    Mesh mesh;
    mesh.positions.push_back({0, 0, 0});
    for (std::size_t c = 0; c < sides.size(); ++c) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        const float height = 0.1f * static_cast<float>(c + 1) * (c % 2 == 0 ? 1.0f : -1.0f);
        for (std::uint32_t k = 0; k < sides[c]; ++k) {
            const float angle = 6.2831853f * static_cast<float>(k) / static_cast<float>(sides[c]);
            mesh.positions.push_back({0.1f * std::cos(angle), height, 0.1f * std::sin(angle)});
        }
        const bool is_open = last_is_open && c + 1 == sides.size();
        for (std::uint32_t k = 0; k + (is_open ? 1 : 0) < sides[c]; ++k)
            mesh.triangles.push_back({0, first + k, first + (k + 1) % sides[c]});
    }
    return mesh;
}

Mesh twice_each(Mesh mesh) {
    const std::vector<Triangle> triangles = mesh.triangles;
    for (const Triangle& t : triangles) mesh.triangles.push_back({t[0], t[2], t[1]});
    return mesh;
}

/// Triangles between any of a few particles.
Mesh soup(std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> place(-0.2f, 0.2f);
    Mesh mesh;
    for (int k = 0; k < 14; ++k) mesh.positions.push_back({place(random), place(random), place(random)});
    for (int k = 0; k < 40; ++k) {
        Triangle t{};
        do
            for (std::uint32_t& corner : t) corner = static_cast<std::uint32_t>(random() % 14);
        while (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]);
        mesh.triangles.push_back(t);
    }
    return mesh;
}

std::vector<NamedMesh> odd_meshes() {
    std::vector<NamedMesh> meshes;
    for (const std::uint32_t pages : {3u, 4u, 5u})
        meshes.push_back({"book of " + std::to_string(pages), book(pages)});
    const std::uint32_t two[] = {5, 6}, three[] = {4, 5, 7};
    meshes.push_back({"two cones", cones(two, false)});
    meshes.push_back({"a cone and a fan", cones(two, true)});
    meshes.push_back({"three cones", cones(three, false)});
    meshes.push_back({"each triangle twice", twice_each(loose_sheet(4, 5))});
    for (std::uint32_t seed = 1; seed <= 20; ++seed)
        meshes.push_back({"soup " + std::to_string(seed), soup(seed)});
    return meshes;
}

std::vector<NamedMesh> all_meshes() {
    std::vector<NamedMesh> meshes = sound_meshes();
    for (NamedMesh& mesh : meshes) mesh.mesh.rows = mesh.mesh.columns = 0;
    for (NamedMesh& mesh : odd_meshes()) meshes.push_back(std::move(mesh));
    return meshes;
}

/// Free particles, so that what W and the coupling leave out shows in sums.
SpringScene free_scene(const Mesh& mesh, float stiffening) {
    SpringScene scene = make_scene(mesh, 400, LinearisedAbout::iterate);
    scene.settings.fabric.stiffening = stiffening;
    for (std::uint32_t i = 0; i < scene.size(); ++i) scene.positions[i].w = 100;
    return scene;
}

TEST(Rings, ForcesAreThoseOfTheScalarStatementOnOddMeshes) {
    Parallel serial(1);
    for (const float stiffening : {0.0f, 30.0f}) {
        for (const NamedMesh& named : odd_meshes()) {
            SCOPED_TRACE(named.name);
            const SpringScene scene = free_scene(named.mesh, stiffening);
            const SpringReference reference(scene);
            SpringSystem system(scene.model, stiffening > 0);
            AlignedBuffer<Vec4> residual(scene.size());
            system.residual(serial, scene.equation(), scene.velocities.span(), residual.span());
            system.linearise(serial, scene.equation(), scene.velocities.span(), scene.about);
            for (std::uint32_t i = 0; i < scene.size(); ++i) {
                const double scale = 1e-5 * reference.scale(i);
                EXPECT_LE((xyz(residual[i]).cast<double>() - reference.b[i]).norm(), scale) << i;
                EXPECT_LE((xyz(system.right_side()[i]).cast<double>() - reference.b[i]).norm(), scale) << i;
            }
        }
    }
}

TEST(Rings, CoupledProductIsSymmetricAndKeepsMomentum) {
    Parallel serial(1);
    for (const float stiffening : {0.0f, 30.0f}) {
        for (const NamedMesh& named : all_meshes()) {
            SCOPED_TRACE(named.name);
            SpringScene scene = free_scene(named.mesh, stiffening);
            SpringSystem system(scene.model, stiffening > 0);
            system.linearise(serial, scene.equation(), scene.velocities.span(), scene.about);
            const std::uint32_t n = scene.size();
            const AlignedBuffer<Vec4> x = random_rows(n, 1, 5), y = random_rows(n, 1, 6);
            AlignedBuffer<Vec4> of_x(n), of_y(n);
            const double xx = system.multiply_coupled(serial, {}, x.span(), of_x.span()).x_wx;
            const double yy = system.multiply_coupled(serial, {}, y.span(), of_y.span()).x_wx;
            const double xy = flat(x.span()).dot(flat(of_y.span())),
                         yx = flat(y.span()).dot(flat(of_x.span()));
            EXPECT_NEAR(xy, yx, 1e-5 * (std::abs(xx) + std::abs(yy)));
            Eigen::Vector3d sum = Eigen::Vector3d::Zero(), of_mass = Eigen::Vector3d::Zero();
            double size = 0;
            for (std::uint32_t i = 0; i < n; ++i) {
                sum += xyz(of_x[i]).cast<double>();
                of_mass += static_cast<double>(system.right_side()[i].w) * xyz(x[i]).cast<double>();
                size += static_cast<double>(xyz(of_x[i]).norm());
            }
            EXPECT_LE((sum - of_mass).norm(), 1e-6 * size);
        }
    }
}

// Sheets of few rows, which tiles would not serve, are in rings, too.
TEST(Rings, OfASheetOfFewRowsPullAsTheScalarStatementHasIt) {
    Parallel serial(1);
    for (const float stiffening : {0.0f, 30.0f}) {
        for (const LinearisedAbout about : {LinearisedAbout::base, LinearisedAbout::iterate}) {
            SpringScene scene = make_scene(sheet(7, 600), 400, about);
            scene.settings.fabric.stiffening = stiffening;
            ASSERT_TRUE(diagonals_of(scene.model).empty());
            SpringReference reference(scene);
            SpringSystem system(scene.model, stiffening > 0);
            system.linearise(serial, scene.equation(), scene.velocities.span(), about);
            reference.take_blocks(system);
            for (std::uint32_t i = 0; i < scene.size(); ++i)
                EXPECT_LE((xyz(system.right_side()[i]).cast<double>() - reference.b[i]).norm(),
                          1.2e-5 * reference.scale(i))
                    << i;
        }
    }
}

}  // namespace
}  // namespace weft::test
