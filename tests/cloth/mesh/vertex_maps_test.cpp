// Data per vertex on its way to particles: seams, checks, and maps that are not given.

#include "cloth/mesh/cooking/vertex_maps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "cloth/mesh/cook.h"
#include "tests/cloth/meshes.h"

namespace weft {
namespace {

/// A tube whose seam has two vertices at each of its particles, and a value for each vertex.
struct SewnTube {
    ClothModel model = test::must(cook(test::tube(4, 9)));
    std::vector<float> values = [&] {
        std::vector<float> result(model.vertex_to_particle.size());
        for (std::size_t i = 0; i < result.size(); ++i) result[i] = 0.25f * static_cast<float>(i % 7);
        return result;
    }();

    [[nodiscard]] VertexMap map(WhereWelded rule) const {
        return {.name = "Mesh::stiffness", .values = values, .least = 0, .greatest = 2, .where_welded = rule};
    }
    [[nodiscard]] Result<AlignedBuffer<float>> remapped(const VertexMap& map) const {
        return remap_to_particles(map, model.vertex_to_particle, model.particle_count);
    }
    [[nodiscard]] std::vector<float> values_at(std::uint32_t particle) const {
        std::vector<float> result;
        for (std::size_t i = 0; i < values.size(); ++i)
            if (model.vertex_to_particle[i] == particle) result.push_back(values[i]);
        return result;
    }
};

TEST(VertexMaps, ParticlesGetTheirVerticesValuesAndSeamsTheStatedRule) {
    const SewnTube tube;
    const auto mean = test::must(tube.remapped(tube.map(WhereWelded::mean))),
               least = test::must(tube.remapped(tube.map(WhereWelded::least))),
               greatest = test::must(tube.remapped(tube.map(WhereWelded::greatest)));
    int disagreeing = 0;
    for (std::uint32_t p = 0; p < tube.model.particle_count; ++p) {
        const std::vector<float> values = tube.values_at(p);
        ASSERT_FALSE(values.empty());
        EXPECT_EQ(least[p], std::ranges::min(values));
        EXPECT_EQ(greatest[p], std::ranges::max(values));
        EXPECT_FLOAT_EQ(mean[p], values.size() == 2 ? 0.5f * (values[0] + values[1]) : values[0]);
        disagreeing += least[p] != greatest[p];
    }
    EXPECT_GE(disagreeing, 3) << "the seam must put the rule to the test";
}

}  // namespace
}  // namespace weft
