#include "cloth/mesh/topology/topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "tests/cloth/meshes.h"

namespace weft {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinite = std::numeric_limits<float>::infinity();

std::uint32_t components(const Topology& topology) {
    return static_cast<std::uint32_t>(topology.component_offsets.size() - 1);
}

/// The message of the error that the mesh must give.
std::string refusal(const Mesh& mesh) {
    const auto topology = build_topology(mesh);
    EXPECT_FALSE(topology);
    if (topology) return "";
    EXPECT_EQ(topology.error().code, ErrorCode::invalid_mesh);
    return topology.error().message;
}

void expect_named(const std::string& message, std::initializer_list<const char*> parts) {
    for (const char* part : parts)
        EXPECT_NE(message.find(part), std::string::npos) << '"' << part << "\" in: " << message;
}

TEST(Topology, EulerCharacteristicComponentsAndBorders) {
    for (const test::NamedMesh& sample : test::sound_meshes()) {
        SCOPED_TRACE(sample.name);
        const Topology topology = test::must(build_topology(sample.mesh));
        const auto particles = static_cast<int>(topology.particle_count());
        const auto edges = static_cast<int>(topology.edges.size());
        const auto triangles = static_cast<int>(topology.triangles.size());
        EXPECT_EQ(particles - edges + triangles, sample.euler_characteristic);
        EXPECT_EQ(components(topology), static_cast<std::uint32_t>(sample.components));
        EXPECT_EQ(topology.border_edges > 0, sample.has_border);
        EXPECT_EQ(2 * topology.edges.size(), 3 * topology.triangles.size() + topology.border_edges);
        EXPECT_EQ(topology.dropped.size(), 0u);
        EXPECT_EQ(topology.loose_particles, 0u);
    }
}

TEST(Topology, SharedParticleJoinsComponentsThatShareNoEdge) {
    Mesh bow_tie;
    bow_tie.positions = {{-1, 0, 0}, {-1, 1, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
    bow_tie.triangles = {{0, 2, 1}, {2, 3, 4}};
    EXPECT_EQ(components(test::must(build_topology(bow_tie))), 1u);
}

TEST(Topology, WeldsSeamVerticesAndNumbersParticlesByFirstVertex) {
    const std::uint32_t rows = 5, columns = 12;
    const Mesh mesh = test::tube(rows, columns);
    const Topology topology = test::must(build_topology(mesh));
    EXPECT_EQ(mesh.positions.size(), rows * (columns + 1));
    EXPECT_EQ(topology.particle_count(), rows * columns);
    EXPECT_EQ(topology.border_edges, 2 * columns);
    EXPECT_TRUE(std::ranges::is_sorted(topology.first_vertices));
    for (std::uint32_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
        const std::uint32_t particle = topology.vertex_to_particle[vertex];
        EXPECT_LE(topology.first_vertices[particle], vertex);
        const Vec3& p = mesh.positions[vertex];
        const Vec3& q = mesh.positions[topology.first_vertices[particle]];
        EXPECT_TRUE(p.x == q.x && p.y == q.y && p.z == q.z);
    }
}

TEST(Topology, WeldComparesByValueAndNothingLess) {
    const float next = std::nextafter(1.0f, 2.0f);
    const std::vector<Vec3> positions{{0, 1, 0},    {1, 0, 0}, {-0.0f, 1, -0.0f},
                                      {next, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    EXPECT_EQ(weld(positions), (std::vector<std::uint32_t>{0, 1, 0, 2, 1, 0}));
}

/// A sheet of rows x columns vertices as a plain mesh; place(column, row) in space. Row 4 is its middle.
Mesh placed_sheet(std::uint32_t rows, std::uint32_t columns, const std::function<Vec3(float, float)>& place) {
    Mesh mesh = test::loose_sheet(rows, columns);
    mesh.texcoords.clear();
    for (std::uint32_t i = 0; i < rows * columns; ++i)
        mesh.positions[i] = place(float(i % columns), float(i / columns));
    return mesh;
}

TEST(Topology, LayersOfAFoldedSheetStayApart) {
    const Mesh folded = placed_sheet(9, 5, [](float c, float r) { return Vec3{c, 0, std::abs(r - 4)}; });
    EXPECT_EQ(test::must(build_topology(folded)).particle_count(), 45u);
    const Mesh pleated = placed_sheet(13, 5, [](float c, float r) {
        return Vec3{c, 0, r < 4 ? r : r < 8 ? 8 - r : r - 8};
    });
    EXPECT_EQ(test::must(build_topology(pleated)).particle_count(), 65u);
}

TEST(Topology, SheetsAtOnePlaceStayApart) {
    Mesh sheet = placed_sheet(5, 5, [](float c, float r) { return Vec3{c, 0.1f * r, r}; });
    const std::vector<Vec3> positions = sheet.positions;
    const std::vector<Triangle> triangles = sheet.triangles;
    for (std::uint32_t copy = 1; copy < 4; ++copy) {
        sheet.positions.insert(sheet.positions.end(), positions.begin(), positions.end());
        for (const auto& [a, b, c] : triangles)
            sheet.triangles.push_back({a + 25 * copy, b + 25 * copy, c + 25 * copy});
    }
    const Topology topology = test::must(build_topology(sheet));
    EXPECT_EQ(topology.particle_count(), 100u);
    EXPECT_TRUE(topology.dropped.empty());
}

TEST(Topology, SeamsAreWeldedHoweverTheSurfaceIsSplit) {
    Mesh soup;  // each triangle has vertices of its own
    const Mesh ball = test::sphere(1);
    for (const Triangle& t : ball.triangles) {
        const auto first = static_cast<std::uint32_t>(soup.positions.size());
        for (const std::uint32_t i : t) soup.positions.push_back(ball.positions[i]);
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    const Topology topology = test::must(build_topology(soup));
    EXPECT_EQ(topology.particle_count(), test::must(build_topology(ball)).particle_count());
    EXPECT_EQ(topology.border_edges, 0u);
}

TEST(Topology, TurnsTheSmallerPartAndLeavesWhatHasOneSide) {
    EXPECT_EQ(test::must(build_topology(test::sphere(1))).misoriented_edges, 0u);
    const Topology moebius = test::must(build_topology(test::moebius_strip(15)));
    EXPECT_EQ(moebius.misoriented_edges, 1u);
    EXPECT_TRUE(moebius.turned.empty());

    const Mesh fan = test::fan(5);
    for (const bool first : {false, true}) {
        Mesh mesh = fan;
        mesh.triangles.insert(mesh.triangles.begin(), {1, 1, 2});  // left out: numbers are the mesh's
        std::vector<std::uint32_t> wrong{3};
        if (first) wrong = {1, 2};
        for (const std::uint32_t t : wrong) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
        const Topology topology = test::must(build_topology(mesh));
        EXPECT_EQ(topology.misoriented_edges, 0u);
        EXPECT_EQ(topology.turned, wrong);
        for (std::size_t t = 0; t < 5; ++t) {
            const auto& [a, b, c] = topology.corners[t];
            const Vec3 &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
            const Vec3 &p0 = fan.positions[0], &q0 = fan.positions[1], &r0 = fan.positions[2];
            const auto up = [](const Vec3& u, const Vec3& v, const Vec3& w) {
                return (v.z - u.z) * (w.x - u.x) - (v.x - u.x) * (w.z - u.z) > 0;
            };
            EXPECT_EQ(up(p, q, r), up(p0, q0, r0)) << t;
            EXPECT_EQ(topology.corners[t], topology.triangles[t]);
        }
    }
}

TEST(Topology, OfEqualPartsTheFirstStays) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 1}};
    mesh.triangles = {{0, 1, 2}, {1, 2, 3}};
    EXPECT_EQ(test::must(build_topology(mesh)).turned, std::vector<std::uint32_t>{1});
}

TEST(Topology, DropsFacesWithoutAreaAndCountsThem) {
    Mesh mesh = test::fan(3);
    const std::size_t sound = mesh.triangles.size();
    mesh.positions.push_back({0, 0, 0});  // vertex 5, at vertex 0
    mesh.positions.push_back({3, 0, 0});  // 6, 7 and 8 on a line
    mesh.positions.push_back({4, 0, 0});
    mesh.positions.push_back({5, 0, 0});
    mesh.triangles.push_back({1, 1, 2});
    mesh.triangles.push_back({0, 5, 2});
    mesh.triangles.push_back({6, 7, 8});
    const Topology topology = test::must(build_topology(mesh));
    EXPECT_EQ(topology.dropped.size(), 3u);
    EXPECT_EQ(topology.triangles.size(), sound);
    EXPECT_EQ(topology.corners.size(), sound);
    EXPECT_EQ(topology.loose_particles, 3u);
}

TEST(Topology, PatternDecidesWhichFacesHaveAnArea) {
    Mesh mesh = test::loose_sheet(2, 3);
    mesh.pattern = mesh.texcoords;
    for (Vec3& p : mesh.positions) p = {p.x, 0, p.z * 1e-9f};  // folded flat in space; whole in the pattern
    EXPECT_EQ(test::must(build_topology(mesh)).dropped.size(), 0u);

    mesh.pattern[0] = mesh.pattern[1];
    EXPECT_EQ(test::must(build_topology(mesh)).dropped.size(), 1u);
}

TEST(Topology, ThinTrianglesAreKept) {
    Mesh mesh = test::fan(1);
    mesh.positions[2] = {0.5f, 1e-5f, 0};
    EXPECT_EQ(test::must(build_topology(mesh)).dropped.size(), 0u);
}

TEST(Topology, LeavesOutTheThirdTriangleOfAnEdge) {
    Mesh mesh = test::fan(2);  // triangles 0 1 2 and 0 2 3
    mesh.positions.push_back({0, 1, 0});
    mesh.triangles.push_back({1, 1, 2});  // so that the numbers of kept triangles differ from the mesh's
    mesh.triangles.push_back({0, 2, 4});
    mesh.triangles.push_back({0, 4, 3});  // has room, as the one before is out
    const Topology topology = test::must(build_topology(mesh));
    const std::vector<CookReport::Dropped> dropped{{2, DropReason::no_area}, {3, DropReason::crowded_edge}};
    EXPECT_EQ(topology.dropped, dropped);
    EXPECT_EQ(topology.sources, (std::vector<std::uint32_t>{0, 1, 4}));
    EXPECT_EQ(topology.triangles.size(), 3u);
    for (const Edge& edge : topology.edges) EXPECT_NE(edge.triangles[0], Edge::none);
}

TEST(Topology, LeavesOutTrianglesThatAreThereAlready) {
    Mesh mesh = test::fan(1);
    mesh.triangles.push_back({2, 1, 0});
    mesh.triangles.push_back({1, 2, 0});
    const Topology topology = test::must(build_topology(mesh));
    const std::vector<CookReport::Dropped> dropped{{1, DropReason::doubled}, {2, DropReason::doubled}};
    EXPECT_EQ(topology.dropped, dropped);
    EXPECT_EQ(topology.edges.size(), 3u);
    EXPECT_EQ(topology.border_edges, 3u);
}

TEST(Topology, RefusesPointsThatAreNotFinite) {
    Mesh mesh = test::fan(3);
    mesh.positions[2].y = nan;
    expect_named(refusal(mesh), {"positions[2]", "nan", "finite"});
    mesh.positions[2].y = -infinite;
    expect_named(refusal(mesh), {"positions[2]", "-inf"});
    mesh.positions[2].y = 3e5f;
    expect_named(refusal(mesh), {"positions[2]", "300000", "within 100000 m"});

    mesh = test::loose_sheet(2, 2);
    mesh.pattern = mesh.texcoords;
    mesh.pattern[3].x = infinite;
    expect_named(refusal(mesh), {"pattern[3]", "(inf, 1)", "finite"});
}

TEST(Topology, RefusesTextureCoordinatesThatAreNotFinite) {
    Mesh mesh = test::loose_sheet(2, 2);
    mesh.texcoords[1].y = nan;
    expect_named(refusal(mesh), {"texcoords[1]", "nan", "finite"});
}

TEST(Topology, LeavesOutMoreTrianglesAtAVertexThanSolversCanPrepare) {
    EXPECT_EQ(test::must(build_topology(test::fan(1024))).triangles.size(), 1024u);
    const Topology topology = test::must(build_topology(test::fan(1026)));
    EXPECT_EQ(topology.triangles.size(), 1024u);
    const std::vector<CookReport::Dropped> dropped{{1024, DropReason::crowded_vertex},
                                                   {1025, DropReason::crowded_vertex}};
    EXPECT_EQ(topology.dropped, dropped);
}

TEST(Topology, RefusesIndicesOutOfRange) {
    Mesh mesh = test::fan(3);
    mesh.triangles[1][2] = 99;
    expect_named(refusal(mesh), {"corner 2 of triangle 1", "vertex 99", "5 vertices"});
}

TEST(Topology, RefusesMeshesWithoutTriangles) {
    Mesh mesh = test::fan(3);
    mesh.triangles.clear();
    expect_named(refusal(mesh), {"5 vertices and no triangles", "at least one"});
    expect_named(refusal(Mesh{}), {"no triangles"});
    mesh.triangles.assign(4, {1, 1, 2});
    expect_named(refusal(mesh), {"all 4 triangles", "no area"});
}

TEST(Topology, RefusesArraysThatDoNotFit) {
    Mesh mesh = test::fan(3);
    mesh.pattern.resize(4);
    expect_named(refusal(mesh), {"pattern", "4 elements", "(5)"});
    mesh = test::fan(3);
    mesh.texcoords.resize(6);
    expect_named(refusal(mesh), {"texcoords", "6 elements", "(5)"});
    mesh = test::fan(3);
    mesh.rows = 2;
    mesh.columns = 3;
    expect_named(refusal(mesh), {"2 x 3 = 6", "5 vertices", "set both to 0"});
}

}  // namespace
}  // namespace weft
