// What becomes of a mesh that is cut, and which edges a blade and a pull choose.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <set>

#include "tests/cloth/meshes.h"
#include "weft/weft.h"

namespace weft::test {
namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

ClothInfo cooked(const Mesh& mesh) {
    return must(CookedCloth::create(mesh)).info();
}

std::vector<std::uint32_t> particles_of(const Mesh& mesh) {
    World world = must(World::create({.threads = 1}));
    const auto map = world.cloth(must(world.add_cloth(mesh)))->vertex_to_particle;
    return {map.begin(), map.end()};
}

Pair in_order(std::uint32_t a, std::uint32_t b) {
    return std::minmax(a, b);
}

/// Edges by particles, and the triangles at each.
std::map<Pair, std::vector<std::uint32_t>> edges_of(const Mesh& mesh,
                                                    const std::vector<std::uint32_t>& particles) {
    std::map<Pair, std::vector<std::uint32_t>> edges;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            edges[in_order(particles[mesh.triangles[t][k]], particles[mesh.triangles[t][(k + 1) % 3]])]
                .push_back(t);
    return edges;
}

/// Along column `column` of a sheet, from row `from` to row `to`.
std::vector<MeshEdge> along_column(const Mesh& mesh, std::uint32_t column, std::uint32_t from,
                                   std::uint32_t to) {
    std::vector<MeshEdge> edges;
    for (std::uint32_t row = from; row < to; ++row)
        edges.push_back({row * mesh.columns + column, (row + 1) * mesh.columns + column});
    return edges;
}

TEST(CutMesh, FromBorderToBorderTakesThePartsOffEachOther) {
    const Mesh mesh = must(make_sheet({.rows = 5, .columns = 7}));
    const MeshCut cut = must(cut_mesh(mesh, along_column(mesh, 3, 0, 4)));
    EXPECT_EQ(cut.added_particles, 5u);
    const ClothInfo before = cooked(mesh), after = cooked(cut.mesh);
    EXPECT_EQ(after.components, 2u);
    EXPECT_EQ(after.particles, before.particles + 5);
    EXPECT_EQ(after.border_edges, before.border_edges + 2 * 4);
    EXPECT_EQ(after.triangles, before.triangles);
    EXPECT_NEAR(after.mass, before.mass, 1e-6f * before.mass);
    EXPECT_EQ(after.dropped_triangles + after.turned_triangles + after.loose_particles, 0u);
}

TEST(CutMesh, LeavesTheEndsOfACutWhole) {
    const Mesh mesh = must(make_sheet({.rows = 7, .columns = 7}));
    const MeshCut from_border = must(cut_mesh(mesh, along_column(mesh, 3, 0, 4)));
    EXPECT_EQ(from_border.added_particles, 4u) << "all but the end within";
    EXPECT_EQ(cooked(from_border.mesh).components, 1u);
    const MeshCut slit = must(cut_mesh(mesh, along_column(mesh, 3, 1, 5)));
    EXPECT_EQ(slit.added_particles, 3u) << "all but both ends";
    EXPECT_EQ(cooked(slit.mesh).components, 1u);
}

TEST(CutMesh, IsTheSameMeshWhereNothingParts) {
    const Mesh mesh = must(make_sheet({.rows = 5, .columns = 5}));
    const std::vector<MeshEdge> border = {{0, 1}}, inner = along_column(mesh, 2, 1, 2);
    for (const auto& edges : {std::vector<MeshEdge>(), border, inner}) {
        const MeshCut cut = must(cut_mesh(mesh, edges));
        EXPECT_EQ(cut.added_particles, 0u);
        EXPECT_EQ(cut.mesh.rows, mesh.rows) << "still a grid";
        EXPECT_EQ(cut.mesh.triangles, mesh.triangles);
        EXPECT_TRUE(cut.mesh.welds.empty());
        std::vector<std::uint32_t> same(mesh.positions.size());
        std::iota(same.begin(), same.end(), 0u);
        EXPECT_EQ(cut.from, same);
    }
}

/// The corners (triangle, particle) that hang together by edges that were not cut, counted by spreading.
std::size_t fans_of(const Mesh& mesh, const std::vector<std::uint32_t>& particles,
                    const std::set<Pair>& cut) {
    std::map<Pair, std::set<Pair>> joined;  // (triangle, particle) to the same
    std::set<std::uint32_t> touched;
    for (const auto& [edge, triangles] : edges_of(mesh, particles)) {
        for (const std::uint32_t p : {edge.first, edge.second}) {
            for (const std::uint32_t t : triangles) joined[{t, p}];
            if (triangles.size() < 2) continue;
            if (cut.contains(edge)) {
                touched.insert(p);
                continue;
            }
            joined[{triangles[0], p}].insert({triangles[1], p});
            joined[{triangles[1], p}].insert({triangles[0], p});
        }
    }
    std::size_t count = 0;
    std::set<Pair> seen;
    std::set<std::uint32_t> whole;
    for (const auto& [corner, others] : joined) {
        if (!touched.contains(corner.second)) {
            count += whole.insert(corner.second).second ? 1 : 0;
            continue;
        }
        if (!seen.insert(corner).second) continue;
        ++count;
        std::vector<Pair> left{corner};
        while (!left.empty()) {
            const Pair at = left.back();
            left.pop_back();
            for (const Pair& other : joined[at])
                if (seen.insert(other).second) left.push_back(other);
        }
    }
    return count;
}

/// Edges drawn at random, as the mesh's triangles name them.
std::vector<MeshEdge> drawn_edges(const Mesh& mesh, double part, std::mt19937& random) {
    std::vector<MeshEdge> edges;
    std::bernoulli_distribution is_drawn(part);
    for (const Triangle& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            if (is_drawn(random)) edges.push_back({t[k], t[(k + 1) % 3]});
    return edges;
}

TEST(CutMesh, MakesAParticleOfEachFanOfAnyMesh) {
    std::mt19937 random(3);
    for (const NamedMesh& sample : sound_meshes()) {
        SCOPED_TRACE(sample.name);
        const std::vector<std::uint32_t> particles = particles_of(sample.mesh);
        for (const double part : {0.05, 0.3, 1.0}) {
            const std::vector<MeshEdge> edges = drawn_edges(sample.mesh, part, random);
            std::set<Pair> by_particles;
            for (const auto& [a, b] : edges) by_particles.insert(in_order(particles[a], particles[b]));
            const MeshCut cut = must(cut_mesh(sample.mesh, edges));
            const ClothInfo before = cooked(sample.mesh), after = cooked(cut.mesh);
            EXPECT_EQ(after.particles, fans_of(sample.mesh, particles, by_particles));
            EXPECT_EQ(after.particles, before.particles + cut.added_particles);
            EXPECT_EQ(after.triangles, before.triangles);
            EXPECT_NEAR(after.mass, before.mass, 1e-5f * before.mass);
            if (part == 1.0) {
                EXPECT_EQ(after.components, after.triangles);
            }
            // Each corner lies where it did, in space, in the pattern and in the picture.
            ASSERT_EQ(cut.mesh.triangles.size(), sample.mesh.triangles.size());
            ASSERT_EQ(cut.from.size(), cut.mesh.positions.size());
            for (std::size_t t = 0; t < cut.mesh.triangles.size(); ++t)
                for (std::size_t k = 0; k < 3; ++k)
                    EXPECT_EQ(cut.from[cut.mesh.triangles[t][k]], sample.mesh.triangles[t][k]);
            for (std::size_t v = 0; v < cut.from.size(); ++v) {
                const std::uint32_t of = cut.from[v];
                EXPECT_EQ(cut.mesh.positions[v].x, sample.mesh.positions[of].x);
                if (v < sample.mesh.positions.size()) {
                    EXPECT_EQ(of, v);
                }
                if (!sample.mesh.texcoords.empty()) {
                    EXPECT_EQ(cut.mesh.texcoords[v].x, sample.mesh.texcoords[of].x);
                }
            }
        }
    }
}

TEST(CutMesh, GoesOnFromACut) {
    const Mesh mesh = must(make_sheet({.rows = 6, .columns = 6}));
    const MeshCut half = must(cut_mesh(mesh, along_column(mesh, 2, 0, 3)));
    const MeshCut whole = must(cut_mesh(half.mesh, along_column(mesh, 2, 3, 5)));
    EXPECT_EQ(whole.added_particles, 3u);
    EXPECT_EQ(cooked(whole.mesh).components, 2u);
    EXPECT_EQ(cooked(must(cut_mesh(mesh, along_column(mesh, 2, 0, 5))).mesh), cooked(whole.mesh));
}

TEST(CutMesh, KeepsSeamsTogetherThatItDoesNotCut) {
    const Mesh mesh = tube(5, 8);
    const std::vector<std::uint32_t> particles = particles_of(mesh);
    // Around the tube, across its seam.
    std::vector<MeshEdge> around;
    for (std::uint32_t k = 0; k < 8; ++k) around.push_back({2 * 9 + k, 2 * 9 + k + 1});
    const MeshCut cut = must(cut_mesh(mesh, around));
    EXPECT_EQ(cut.added_particles, 8u);
    EXPECT_EQ(cooked(cut.mesh).components, 2u);
    EXPECT_EQ(cooked(cut.mesh).welded_vertices, 5u + 1u) << "the seam is at both sides of the cut";
}

TEST(CutMesh, TakesAVertexOfNoTriangleAlong) {
    Mesh mesh = must(make_sheet({.rows = 3, .columns = 3}));
    mesh.rows = mesh.columns = 0;
    // Vertex 0 lies where the last one does, and no triangle has it.
    mesh.positions.insert(mesh.positions.begin(), mesh.positions[4]);
    mesh.texcoords.insert(mesh.texcoords.begin(), mesh.texcoords[4]);
    for (Triangle& t : mesh.triangles)
        for (std::uint32_t& v : t) ++v;
    const std::vector<MeshEdge> across = {{4, 5}, {0, 6}};
    const MeshCut cut = must(cut_mesh(mesh, across));
    EXPECT_EQ(cut.added_particles, 3u);
    EXPECT_EQ(cooked(cut.mesh).loose_particles, 0u);
    EXPECT_EQ(cooked(cut.mesh).components, 2u);
}

template <class T>
void expect_says(const Result<T>& answer, const std::string& what) {
    ASSERT_FALSE(answer);
    EXPECT_NE(answer.error().message.find(what), std::string::npos) << answer.error().message;
}

TEST(CutMesh, RefusesByName) {
    const Mesh mesh = must(make_sheet({.rows = 3, .columns = 3}));
    expect_says(cut_mesh(mesh, std::vector<MeshEdge>{{0, 8}}), "from vertex 0 to vertex 8");
    expect_says(cut_mesh(mesh, std::vector<MeshEdge>{{0, 1}, {3, 9}}), "edge 1 ends at vertex 9");
    expect_says(cut_mesh({}, {}), "triangles");
    const auto with_welds = [&](std::vector<std::uint32_t> welds) {
        Mesh other = mesh;
        other.welds = std::move(welds);
        return CookedCloth::create(other);
    };
    expect_says(with_welds({0, 1}), "Mesh::welds has 2 elements");
    expect_says(with_welds({0, 1, 2, 3, 4, 5, 6, 8, 8}), "Mesh::welds[7] is 8");
    expect_says(with_welds({0, 0, 1, 3, 4, 5, 6, 7, 8}), "Mesh::welds makes vertex 1");
    expect_says(with_welds({0, 1, 2, 3, 4, 5, 6, 7, 7}), "vertex 8 one with vertex 7");
}

// Across a sheet of 1 m about the origin, y up, by a blade that is drawn down through it.
Blade across(float x0, float z0, float x1, float z1) {
    return {{x0, 1, z0}, {x0, -1, z0}, {x1, 1, z1}, {x1, -1, z1}};
}

std::vector<MeshEdge> cut_by(const Mesh& mesh, const Blade& blade, CutStroke& stroke) {
    return must(edges_along(mesh, mesh.positions, blade, stroke));
}

std::set<Pair> as_set(const std::vector<MeshEdge>& edges) {
    std::set<Pair> set;
    for (const auto& [a, b] : edges) set.insert(in_order(a, b));
    return set;
}

TEST(EdgesAlong, ABladeThroughAndThroughPartsTheCloth) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> at(-0.4f, 0.4f);
    const Mesh mesh = must(make_sheet({.rows = 17, .columns = 17}));
    for (int k = 0; k < 50; ++k) {
        CutStroke stroke;
        const auto edges = cut_by(mesh, across(at(random), -0.7f, at(random), 0.7f), stroke);
        EXPECT_EQ(cooked(must(cut_mesh(mesh, edges)).mesh).components, 2u) << "cut " << k;
        EXPECT_TRUE(stroke.ends.empty());
    }
    // Along a column, through every vertex of it.
    CutStroke stroke;
    EXPECT_EQ(cooked(must(cut_mesh(mesh, cut_by(mesh, across(0, -0.7f, 0, 0.7f), stroke))).mesh).components,
              2u);
}

TEST(EdgesAlong, ABladeHalfThroughLeavesItInOnePiece) {
    const Mesh mesh = must(make_sheet({.rows = 17, .columns = 17}));
    CutStroke stroke;
    const MeshCut cut = must(cut_mesh(mesh, cut_by(mesh, across(0.03f, -0.7f, 0.1f, 0.1f), stroke)));
    EXPECT_GT(cut.added_particles, 5u);
    EXPECT_EQ(cooked(cut.mesh).components, 1u);
    EXPECT_FALSE(stroke.ends.empty());
}

TEST(EdgesAlong, SaysNothingOfABladeThatMisses) {
    const Mesh mesh = must(make_sheet({.rows = 5, .columns = 5}));
    CutStroke stroke;
    EXPECT_TRUE(cut_by(mesh, across(0.6f, -1, 0.6f, 1), stroke).empty());
    const Blade above{{0, 1, -1}, {0, 0.1f, -1}, {0, 1, 1}, {0, 0.1f, 1}};
    EXPECT_TRUE(cut_by(mesh, above, stroke).empty());
    const Blade still = {{0, 1, 0}, {0, -1, 0}, {0, 1, 0}, {0, -1, 0}};
    EXPECT_TRUE(cut_by(mesh, still, stroke).empty());
    EXPECT_TRUE(stroke.edges.empty() && stroke.ends.empty());
}

// As a pointer draws it over a picture: all blades meet in the eye.
TEST(EdgesAlong, ManyShortBladesCutAsOneLongOne) {
    const Mesh mesh = loose_sheet(17, 17);
    const Vec3 eye{0.1f, 2, 0.2f};
    const auto under = [](float s) { return Vec3{0.15f * s, -1, -1.5f + 3 * s}; };
    CutStroke once, bit_by_bit;
    const auto edges = cut_by(mesh, {eye, under(0), eye, under(1)}, once);
    std::vector<MeshEdge> last;
    Mesh now = mesh;
    constexpr int parts = 100;
    for (int k = 0; k < parts; ++k) {
        const Blade blade{eye, under(static_cast<float>(k) / parts), eye,
                          under(static_cast<float>(k + 1) / parts)};
        const auto more = must(edges_along(now, now.positions, blade, bit_by_bit));
        if (more.empty()) continue;
        EXPECT_GE(more.size(), last.size());
        last = more;
        now = must(cut_mesh(now, more)).mesh;  // while it is drawn
    }
    EXPECT_EQ(cooked(now).components, 2u);
    EXPECT_EQ(cooked(now), cooked(must(cut_mesh(mesh, edges)).mesh));
    EXPECT_EQ(now.positions.size(), must(cut_mesh(mesh, edges)).mesh.positions.size());
}

TEST(EdgesAlong, GoesThroughAllLayers) {
    const Mesh one = loose_sheet(9, 9), mesh = joined(one, one, {0.01f, 0.1f, 0});
    CutStroke stroke;
    EXPECT_EQ(cooked(must(cut_mesh(mesh, cut_by(mesh, across(0.07f, -1, 0.02f, 1), stroke))).mesh).components,
              4u);
}

TEST(EdgesAlong, RefusesByName) {
    const Mesh mesh = must(make_sheet({.rows = 3, .columns = 3}));
    CutStroke stroke;
    expect_says(edges_along(mesh, std::span(mesh.positions).first(8), across(0, -1, 0, 1), stroke),
                "8 positions");
    Blade blade = across(0, -1, 0, 1);
    blade.is_b.y = NAN;
    expect_says(edges_along(mesh, mesh.positions, blade, stroke), "blade");
    std::vector<Vec3> lost = mesh.positions;
    lost[4].x = INFINITY;
    expect_says(edges_along(mesh, lost, across(0, -1, 0, 1), stroke), "vertex 4");
    EXPECT_TRUE(stroke.edges.empty());
}

TEST(EdgesToTear, OpensAcrossThePull) {
    const Mesh mesh = loose_sheet(7, 7);
    // Pulled along x in the middle: it opens along z there, by two edges at one particle.
    const std::uint32_t middle = 3 * 7 + 3;
    const std::vector<StrainedEdge> strained = {{middle, middle + 1, 0.5f}};
    const MeshCut cut = must(cut_mesh(mesh, must(edges_to_tear(mesh, mesh.positions, strained))));
    EXPECT_EQ(cut.added_particles, 1u);
    for (const Pair& edge : as_set(must(edges_to_tear(mesh, mesh.positions, strained)))) {
        const Vec3 &a = mesh.positions[edge.first], &b = mesh.positions[edge.second];
        EXPECT_GT(std::abs(a.z - b.z), 0.9f * std::abs(a.x - b.x)) << "across, as far as triangles let it";
    }
    EXPECT_TRUE(must(edges_to_tear(mesh, mesh.positions, {})).empty());
}

// From the end of a slit it goes on, rather than beginning anew beside it.
TEST(EdgesToTear, RunsOnFromACut) {
    const Mesh mesh = must(make_sheet({.rows = 7, .columns = 7}));
    const MeshCut slit = must(cut_mesh(mesh, along_column(mesh, 3, 0, 3)));
    const std::uint32_t tip = 3 * 7 + 3;
    for (const StrainedEdge edge : {StrainedEdge{tip, tip + 1, 1}, StrainedEdge{tip + 1, tip, 1}}) {
        const auto edges = must(edges_to_tear(slit.mesh, slit.mesh.positions, {&edge, 1}));
        ASSERT_EQ(edges.size(), 1u);
        EXPECT_TRUE(edges[0][0] == tip || edges[0][1] == tip);
        EXPECT_EQ(must(cut_mesh(slit.mesh, edges)).added_particles, 1u);
    }
}

}  // namespace
}  // namespace weft::test
