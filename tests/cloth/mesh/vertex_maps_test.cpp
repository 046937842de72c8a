// Data per vertex on its way to particles: seams, checks, and maps that are not given.

#include "cloth/mesh/cooking/vertex_maps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
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

TEST(VertexMaps, WithoutValuesEveryParticleGetsTheOther) {
    const SewnTube tube;
    const auto result = test::must(tube.remapped({.name = "Mesh::friction", .otherwise = 0.5f}));
    ASSERT_EQ(result.size(), tube.model.particle_count);
    for (const float value : result.span()) EXPECT_EQ(value, 0.5f);
}

TEST(VertexMaps, ErrorsNameMapVertexAndValue) {
    const auto refusal = [](const auto& spoil) {
        SewnTube tube;
        spoil(tube.values);
        const auto result = tube.remapped(tube.map(WhereWelded::mean));
        EXPECT_FALSE(result);
        return result ? std::string() : result.error().message;
    };
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_NE(refusal([](auto& v) { v.pop_back(); }).find("Mesh::stiffness has 39 values"),
              std::string::npos);
    EXPECT_NE(refusal([](auto& v) { v[5] = nan; }).find("Mesh::stiffness[5] is nan"), std::string::npos);
    EXPECT_NE(refusal([](auto& v) { v[39] = 2.5f; }).find("[39] is 2.5; it must be from 0 to 2"),
              std::string::npos);
    EXPECT_NE(refusal([](auto& v) { v[0] = -1; }).find("[0] is -1"), std::string::npos);
}

}  // namespace
}  // namespace weft
