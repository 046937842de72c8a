// The order of particles in memory: a permutation that changes where things lie and nothing else.

#include "cloth/mesh/cooking/ordering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "cloth/equation/sparse/stencil.h"
#include "cloth/mesh/cook.h"
#include "engine/vector.h"
#include "tests/cloth/meshes.h"
#include "weft/weft.h"

namespace weft {
namespace {

/// The same surface; vertex i becomes vertex numbers[i].
Mesh with_vertices(const Mesh& mesh, std::span<const std::uint32_t> numbers) {
    Mesh result = mesh;
    for (std::uint32_t i = 0; i < numbers.size(); ++i) {
        result.positions[numbers[i]] = mesh.positions[i];
        if (!mesh.pattern.empty()) result.pattern[numbers[i]] = mesh.pattern[i];
        if (!mesh.texcoords.empty()) result.texcoords[numbers[i]] = mesh.texcoords[i];
    }
    for (Triangle& triangle : result.triangles)
        for (std::uint32_t& vertex : triangle) vertex = numbers[vertex];
    return result;
}

std::vector<std::uint32_t> shuffled(std::vector<std::uint32_t> numbers, unsigned seed) {
    std::shuffle(numbers.begin(), numbers.end(), std::mt19937(seed));
    return numbers;
}

TEST(Ordering, RenumberingKeepsTheSurface) {
    for (const test::NamedMesh& named : test::sound_meshes()) {
        const Topology before = test::must(build_topology(named.mesh));
        Topology after = before;
        const std::vector<std::uint32_t> order = memory_order(before);
        renumber(after, order);
        ASSERT_EQ(after.edges.size(), before.edges.size());
        EXPECT_TRUE(std::ranges::is_sorted(after.edges, {}, &Edge::particles)) << named.name;
        for (std::size_t t = 0; t < before.triangles.size(); ++t)
            for (std::size_t corner = 0; corner < 3; ++corner) {
                EXPECT_EQ(order[after.triangles[t][corner]], before.triangles[t][corner]) << named.name;
                EXPECT_EQ(after.vertex_to_particle[after.corners[t][corner]], after.triangles[t][corner]);
            }
        for (const Edge& edge : after.edges) {
            EXPECT_LT(edge.particles[0], edge.particles[1]);
            for (std::size_t side = 0; side < (edge.is_border() ? 1u : 2u); ++side) {
                const Triangle& triangle = after.triangles[edge.triangles[side]];
                for (const std::uint32_t i : {edge.particles[0], edge.particles[1], edge.opposites[side]})
                    EXPECT_NE(std::ranges::find(triangle, i), triangle.end()) << named.name;
            }
        }
        for (std::uint32_t i = 0; i < after.particle_count(); ++i)
            EXPECT_EQ(after.vertex_to_particle[after.first_vertices[i]], i) << named.name;
        EXPECT_EQ(after.component_offsets.size(), before.component_offsets.size()) << named.name;
    }
}

// What a mesh's order may change is the order of sums, and with it the rounding; and where multigrid takes
// its nodes, so the comparison is of converged steps.
TEST(Ordering, AStepDoesNotDependOnIt) {
    const Mesh mesh = test::loose_sheet(24, 24);
    const auto moved = [&](const std::vector<std::uint32_t>& numbers) {
        ClothSettings settings;
        settings.method = Multilevel{.passes = 30};
        World world = test::must(World::create());
        const ClothId cloth = test::must(world.add_cloth(with_vertices(mesh, numbers), settings));
        for (const std::uint32_t corner : {0u, 23u}) EXPECT_TRUE(world.pin(cloth, numbers[corner]));
        for (int step = 0; step < 5; ++step) world.step(1.0f / 60);
        const ClothView view = test::must(world.cloth(cloth));
        std::vector<Vector3> result;
        for (const std::uint32_t number : numbers)
            result.push_back(xyz(view.positions[view.vertex_to_particle[number]]));
        return result;
    };
    std::vector<std::uint32_t> as_it_is(mesh.positions.size());
    std::iota(as_it_is.begin(), as_it_is.end(), 0u);
    const std::vector<Vector3> expected = moved(as_it_is), found = moved(shuffled(as_it_is, 4));
    float farthest = 0, largest_motion = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        farthest = std::max(farthest, (found[i] - expected[i]).norm());
        largest_motion = std::max(largest_motion, (expected[i] - to_vector(mesh.positions[i])).norm());
    }
    EXPECT_GT(largest_motion, 0.02f);
    EXPECT_LT(farthest, 1e-3f * largest_motion);
}

}  // namespace
}  // namespace weft
