#include "cloth/mesh/cook.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <utility>

#include "engine/vector.h"
#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"

namespace weft {
namespace {

struct HalfEdge {
    std::uint32_t neighbour;
    float rest_length;
    SpringKind kind;
};

std::vector<HalfEdge> row(const ClothModel& cloth, std::uint32_t particle) {
    std::vector<HalfEdge> result;
    for (std::uint32_t e = cloth.spring_offsets[particle]; e < cloth.spring_offsets[particle + 1]; ++e)
        result.push_back({cloth.neighbours[e], cloth.rest_lengths[e], cloth.kinds[e]});
    return result;
}

/// Of `from`, towards `to`.
std::optional<HalfEdge> half_edge(const ClothModel& cloth, std::uint32_t from, std::uint32_t to) {
    const std::vector<HalfEdge> edges = row(cloth, from);
    const auto at = std::ranges::find(edges, to, &HalfEdge::neighbour);
    return at == edges.end() ? std::nullopt : std::optional(*at);
}

/// Between the particles of two vertices.
std::optional<HalfEdge> spring(const ClothModel& cloth, std::uint32_t from, std::uint32_t to) {
    return half_edge(cloth, cloth.vertex_to_particle[from], cloth.vertex_to_particle[to]);
}

/// By Heron's formula in double precision.
double surface_area(const Mesh& mesh) {
    double total = 0;
    for (const auto& [i, j, k] : mesh.triangles) {
        const Eigen::Vector3d p = to_vector(mesh.positions[i]).cast<double>();
        const Eigen::Vector3d q = to_vector(mesh.positions[j]).cast<double>();
        const Eigen::Vector3d r = to_vector(mesh.positions[k]).cast<double>();
        const double a = (q - p).norm(), b = (r - q).norm(), c = (p - r).norm(), s = (a + b + c) / 2;
        total += std::sqrt(s * (s - a) * (s - b) * (s - c));
    }
    return total;
}

TEST(Cook, RestAreasSumToTheSurface) {
    for (const test::NamedMesh& sample : test::sound_meshes()) {
        SCOPED_TRACE(sample.name);
        const double expected = surface_area(sample.mesh);
        EXPECT_NEAR(test::total_rest_area(test::must(cook(sample.mesh))), expected, 1e-6 * expected);
    }
}

TEST(Cook, WithoutPatternEverySpringIsAtRest) {
    for (const test::NamedMesh& sample : test::sound_meshes()) {
        SCOPED_TRACE(sample.name);
        const ClothModel cloth = test::must(cook(sample.mesh));
        for (std::uint32_t i = 0; i < cloth.particle_count; ++i)
            for (const HalfEdge& edge : row(cloth, i)) {
                const float apart = (xyz(cloth.positions[edge.neighbour]) - xyz(cloth.positions[i])).norm();
                if (edge.kind == SpringKind::bending)  // over what is bent the way is longer
                    EXPECT_GE(edge.rest_length, 0.99999f * apart);
                else
                    EXPECT_FLOAT_EQ(edge.rest_length, apart);
            }
    }
}

TEST(Cook, InfoCountsWhatIsThere) {
    for (const test::NamedMesh& sample : test::sound_meshes()) {
        SCOPED_TRACE(sample.name);
        const ClothModel cloth = test::must(cook(sample.mesh));
        const ClothInfo& info = cloth.info;
        EXPECT_EQ(info.vertices, sample.mesh.positions.size());
        EXPECT_EQ(info.particles, cloth.particle_count);
        EXPECT_EQ(info.triangles, cloth.triangles.size());
        EXPECT_EQ(info.components, static_cast<std::uint32_t>(sample.components));
        EXPECT_EQ(cloth.component_offsets.size(), info.components + 1);
        std::map<SpringKind, std::uint32_t> half_edges;
        double structural_length = 0;
        for (std::uint32_t e = 0; e < cloth.kinds.size(); ++e) {
            ++half_edges[cloth.kinds[e]];
            if (cloth.kinds[e] == SpringKind::structural)
                structural_length += static_cast<double>(cloth.rest_lengths[e]);
        }
        EXPECT_EQ(2 * info.structural_springs, half_edges[SpringKind::structural]);
        EXPECT_EQ(2 * info.shear_springs, half_edges[SpringKind::shear]);
        EXPECT_FLOAT_EQ(info.mean_edge,
                        static_cast<float>(structural_length / half_edges[SpringKind::structural]));
    }
}

/// Two panels of one triangle each, sewn along the edge of vertices 0 and 1; the second panel's seam is
/// `gather` times as long as the first's. In space the cloth is folded.
Mesh sewn_panels(float gather) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0.5f, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0.5f, 0.8f, 0.6f}};
    mesh.triangles = {{0, 1, 2}, {4, 3, 5}};
    mesh.pattern = {{0, 0}, {1, 0}, {0.5f, 1}, {10, 7}, {10, 7 + gather}, {12, 7 + gather / 2}};
    return mesh;
}

TEST(Cook, PatternUnfoldsAcrossASeam) {
    const ClothModel cloth = test::must(cook(sewn_panels(1)));
    ASSERT_EQ(cloth.particle_count, 4u);
    EXPECT_FLOAT_EQ(spring(cloth, 0, 1)->rest_length, 1);
    EXPECT_FLOAT_EQ(spring(cloth, 0, 2)->rest_length, std::sqrt(1.25f));
    EXPECT_FLOAT_EQ(spring(cloth, 0, 5)->rest_length, std::sqrt(4.25f));
    EXPECT_FLOAT_EQ(spring(cloth, 2, 5)->rest_length, 3);  // 1 m to the seam and 2 m beyond, laid flat
    EXPECT_FLOAT_EQ(static_cast<float>(test::total_rest_area(cloth)), 0.5f + 1.0f);
    EXPECT_FLOAT_EQ(cloth.rest_area[cloth.vertex_to_particle[2]], 0.5f / 3);
}

TEST(Cook, SeamOfUnequalPanelsTakesTheMeanLength) {
    const ClothModel cloth = test::must(cook(sewn_panels(1.5f)));
    EXPECT_FLOAT_EQ(spring(cloth, 0, 1)->rest_length, 1.25f);
    // Each panel's apex lies at its own angle about the seam's end, and as far from it.
    const double angle = std::atan2(1, 0.5) + std::atan2(2, 0.75);
    const double between = 1.25 + 4.5625 - 2 * std::sqrt(1.25 * 4.5625) * std::cos(angle);
    EXPECT_NEAR(spring(cloth, 2, 5)->rest_length, std::sqrt(between), 1e-6);
}

TEST(Cook, PatternOfAFlatSheetGivesTheSameClothAsTheSheet) {
    Mesh flat = test::loose_sheet(5, 8);
    const ClothModel expected = test::must(cook(flat));
    flat.pattern = flat.texcoords;
    for (Vec3& p : flat.positions)
        p = {p.x, 0.3f * std::sin(9 * p.x), 0.5f * p.z};  // rippled and squeezed in space
    const ClothModel cloth = test::must(cook(flat));
    ASSERT_EQ(cloth.neighbours.size(), expected.neighbours.size());
    for (std::uint32_t e = 0; e < cloth.neighbours.size(); ++e) {
        EXPECT_EQ(cloth.neighbours[e], expected.neighbours[e]);
        EXPECT_NEAR(cloth.rest_lengths[e], expected.rest_lengths[e], 1e-6);
    }
    for (std::uint32_t i = 0; i < cloth.particle_count; ++i)
        EXPECT_NEAR(cloth.rest_area[i], expected.rest_area[i], 1e-7);
}

TEST(Cook, UnrolledTubeIsWeldedAndKeepsItsCircumference) {
    const std::uint32_t rows = 3, columns = 24;
    Mesh tube = test::tube(rows, columns);
    tube.pattern = tube.texcoords;
    const ClothModel cloth = test::must(cook(tube));
    EXPECT_EQ(cloth.info.vertices - cloth.info.particles, rows);
    const float turn = tube.texcoords[1].x;
    for (std::uint32_t column = 0; column < columns; ++column)
        EXPECT_NEAR(spring(cloth, column, (column + 1) % columns)->rest_length, turn, 1e-6);
    EXPECT_NEAR(test::total_rest_area(cloth), 2 * columns * static_cast<double>(turn), 1e-5);
}

TEST(Cook, LooseParticlesHaveNoAreaAndNoSprings) {
    Mesh mesh = test::fan(4);
    mesh.positions.push_back({7, 7, 7});
    const ClothModel cloth = test::must(cook(mesh));
    EXPECT_EQ(cloth.info.loose_particles, 1u);
    EXPECT_EQ(cloth.info.components, 2u);
    EXPECT_EQ(cloth.rest_area[6], 0);
    EXPECT_TRUE(row(cloth, 6).empty());
    EXPECT_EQ(cloth.positions[6].x, 7);
}

TEST(Cook, DroppedFacesLeaveNoTrace) {
    Mesh mesh = test::loose_sheet(4, 4);
    const ClothModel expected = test::must(cook(mesh));
    mesh.triangles.insert(mesh.triangles.begin() + 3, {2, 2, 9});
    const ClothModel cloth = test::must(cook(mesh));
    EXPECT_EQ(cloth.info.dropped_triangles, 1u);
    EXPECT_TRUE(std::ranges::equal(cloth.triangles, expected.triangles));
    EXPECT_TRUE(std::ranges::equal(cloth.neighbours.span(), expected.neighbours.span()));
}

TEST(Cook, RefusesAGridWithHolesOrCoincidingParticles) {
    Mesh grid = test::must(make_sheet({.rows = 3, .columns = 4}));
    grid.triangles.pop_back();
    auto cooked = cook(grid);
    ASSERT_FALSE(cooked);
    EXPECT_NE(cooked.error().message.find("12 triangles of some area, not 11"), std::string::npos)
        << cooked.error().message;

    grid = test::must(make_sheet({.rows = 3, .columns = 4}));
    grid.positions[5] = grid.positions[6];
    cooked = cook(grid);
    ASSERT_FALSE(cooked);
    EXPECT_EQ(cooked.error().code, ErrorCode::invalid_mesh);
    EXPECT_NE(cooked.error().message.find("12 vertices at only 11 different positions"), std::string::npos)
        << cooked.error().message;
}

TEST(Cook, AGridMayBeCutAlongAnyDiagonalsAndWoundEitherWay) {
    Mesh grid = test::must(make_sheet({.rows = 4, .columns = 5}));
    const ClothModel expected = test::must(cook(grid));
    std::ranges::reverse(grid.triangles);
    for (Triangle& triangle : grid.triangles) std::swap(triangle[0], triangle[2]);
    EXPECT_TRUE(std::ranges::equal(test::must(cook(grid)).neighbours.span(), expected.neighbours.span()));
    EXPECT_TRUE(cook(test::evenly_cut({.rows = 4, .columns = 5})));
    EXPECT_TRUE(cook(test::evenly_cut({.rows = 5, .columns = 2})));
}

TEST(Cook, RefusesAGridOfAnotherNumbering) {
    const auto refusal = [](const Mesh& mesh) {
        const auto cooked = cook(mesh);
        EXPECT_FALSE(cooked);
        return cooked ? std::string() : cooked.error().message;
    };
    const Mesh grid = test::must(make_sheet({.rows = 4, .columns = 6}));

    Mesh transposed = grid;
    std::swap(transposed.rows, transposed.columns);
    EXPECT_NE(refusal(transposed).find("is not one of them; set both to 0"), std::string::npos);

    Mesh swapped = grid;  // two vertices change numbers, and the triangles know it
    std::swap(swapped.positions[3], swapped.positions[20]);
    for (Triangle& triangle : swapped.triangles)
        for (std::uint32_t& vertex : triangle) vertex = vertex == 3 ? 20 : vertex == 20 ? 3 : vertex;
    EXPECT_NE(refusal(swapped).find("(row, column) at row * columns + column"), std::string::npos);

    // Both triangles of a cell leave out neighbouring corners: they overlap, and part of it stays open.
    Mesh overlapping = grid;
    overlapping.triangles[0] = {0, 6, 1};
    overlapping.triangles[1] = {0, 6, 7};
    EXPECT_NE(refusal(overlapping).find("vertices 0, 6 and 7 is not one of them"), std::string::npos)
        << refusal(overlapping);

    Mesh line = test::fan(1);
    line.rows = 1;
    line.columns = 3;
    EXPECT_NE(refusal(line).find("at least 2"), std::string::npos);
}

TEST(Cook, PassesTheMeshsErrorsOn) {
    Mesh mesh = test::fan(3);
    mesh.triangles[0][0] = 70;
    const auto cooked = cook(mesh);
    ASSERT_FALSE(cooked);
    EXPECT_NE(cooked.error().message.find("vertex 70"), std::string::npos);
}

}  // namespace
}  // namespace weft
