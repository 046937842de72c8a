// The first step after a change allocates no more than any other: what a change needs is made by the call
// that makes it.

#include <gtest/gtest.h>

#include <variant>
#include <vector>

#include "tests/guarantees/allocation_count.h"
#include "tests/guarantees/method_cases.h"

namespace weft::test {
namespace {

constexpr float dt = 1.0f / 60;

struct Hung {
    explicit Hung(const MethodCase& of) : world(World::create(settings_of(of)).value()) {
        cloth = world.add_cloth(LoweredSheet::mesh(of.grid, side), of.cloth).value();
    }
    static WorldSettings settings_of(const MethodCase& of) {
        WorldSettings settings = of.world;
        settings.threads = 1;  // oneTBB's own threads allocate when they like
        return settings;
    }
    std::uint64_t allocations_of_a_step() {
        const std::uint64_t before = allocation_count();
        world.step(dt);
        return allocation_count() - before;
    }
    static constexpr std::uint32_t side = 20;
    World world;
    ClothId cloth;
};

class FirstStep : public testing::TestWithParam<MethodCase> {};
INSTANTIATE_TEST_SUITE_P(Methods, FirstStep, testing::ValuesIn(method_cases()),
                         [](const auto& info) { return info.param.name; });

TEST_P(FirstStep, AllocatesNothingAfterAnyChange) {
    Hung hung(GetParam());
    World& world = hung.world;
    const ClothSettings settings = GetParam().cloth;
    EXPECT_EQ(hung.allocations_of_a_step(), 0u) << "the very first";

    std::vector<std::uint32_t> border;
    for (std::uint32_t i = 0; i < Hung::side; ++i)
        for (const std::uint32_t v : {i, (Hung::side - 1) * Hung::side + i, i * Hung::side})
            border.push_back(v);
    ASSERT_TRUE(world.pin(hung.cloth, border));
    EXPECT_EQ(hung.allocations_of_a_step(), 0u) << "many pins";
    ASSERT_TRUE(world.unpin(hung.cloth, 5));
    EXPECT_EQ(hung.allocations_of_a_step(), 0u) << "a pin less";

    const ColliderId ground = world.add_collider({.shape = Plane{}}).value();
    EXPECT_EQ(hung.allocations_of_a_step(), 0u) << "the first collider";
    ASSERT_TRUE(world.add_collider({.shape = Sphere{{0, 0.3f, 0}, 0.2f}}));
    EXPECT_EQ(hung.allocations_of_a_step(), 0u) << "another collider, which is met";
    ASSERT_TRUE(world.remove_collider(ground));
    EXPECT_EQ(hung.allocations_of_a_step(), 0u) << "a collider less";

    // To every case from the first, on a sheet and on a mesh; from each of the others to one of every method.
    const bool is_first = GetParam().name == "multilevel" || GetParam().name == "multilevel_mesh";
    std::size_t last = std::variant_npos;
    for (const MethodCase& other : method_cases()) {
        if (!is_first && other.cloth.method.index() == last) continue;
        last = other.cloth.method.index();
        ASSERT_TRUE(world.set_cloth_settings(hung.cloth, other.cloth));
        ASSERT_EQ(hung.allocations_of_a_step(), 0u) << "the method " << other.name;
    }
    ASSERT_TRUE(world.set_cloth_settings(hung.cloth, settings));
    EXPECT_EQ(hung.allocations_of_a_step(), 0u) << "back again";

    WorldSettings windy = world.settings();
    windy.wind = {.velocity = {0, 0, 4}, .gust = 0.4f};
    ASSERT_TRUE(world.set_settings(windy));
    EXPECT_EQ(hung.allocations_of_a_step(), 0u) << "gusts";
    const ClothId other = world.add_cloth(LoweredSheet::mesh(true, 12), settings).value();
    EXPECT_EQ(hung.allocations_of_a_step(), 0u) << "another cloth";
    ASSERT_TRUE(world.remove_cloth(other));
    EXPECT_EQ(hung.allocations_of_a_step(), 0u) << "a cloth less";
}

TEST(SetClothSettings, OfFrictionMakesNothingAnew) {
    Hung hung({.name = "", .cloth = {}, .world = {}});
    std::vector<std::uint32_t> half;
    for (std::uint32_t v = 0; v < Hung::side * Hung::side; v += 2) half.push_back(v);
    ASSERT_TRUE(hung.world.pin(hung.cloth, half));
    hung.world.step(dt);
    ClothSettings settings = hung.world.cloth_settings(hung.cloth).value();
    settings.friction = 0.3f;
    settings.thickness = 0.01f;
    settings.air_damping = 1;
    // Its checks make texts of what is allowed; nothing grows with the cloth or its pins.
    const std::uint64_t before = allocation_count();
    const std::int64_t bytes = allocated_bytes();
    ASSERT_TRUE(hung.world.set_cloth_settings(hung.cloth, settings));
    EXPECT_LT(allocation_count() - before, 40u);
    EXPECT_EQ(allocated_bytes(), bytes);
    EXPECT_EQ(hung.allocations_of_a_step(), 0u);
}

}  // namespace
}  // namespace weft::test
