// Memory for contact between all cloths of a World, while they come and go.

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "tests/cloth/fixtures.h"
#include "weft/weft.h"

namespace weft::test::room {
namespace {

ClothSettings in_contact(SelfCollisionMethod method = SelfCollisionMethod::contact) {
    ClothSettings settings;
    settings.self_collision = {.enabled = true, .method = method};
    return settings;
}

/// Squares over each other, a hand apart.
Mesh square(std::size_t number, std::uint32_t side = 6) {
    const auto n = static_cast<float>(number);
    return make_sheet({.rows = side,
                       .columns = side,
                       .origin = {0.01f * n, 0.02f * n, 0},
                       .u = {0.2f, 0, 0},
                       .v = {0, 0, 0.2f}})
        .value();
}

World serial_world() {
    WorldSettings settings;
    settings.threads = 1;
    return World::create(settings).value();
}

std::uint64_t bytes_between(const World& world) {
    const std::string text = world.describe(DescriptionFormat::json).value();
    const std::string name = "\"bytes_between_cloths\":";
    const std::size_t at = text.find(name);
    EXPECT_NE(at, std::string::npos);
    return std::strtoull(text.c_str() + at + name.size(), nullptr, 10);
}

TEST(RoomBetweenCloths, IsMadeAnewOnlyNowAndThen) {
    World world = serial_world();
    int made = 0;
    std::uint64_t bytes = 0;
    for (std::size_t n = 1; n <= 40; ++n) {
        ASSERT_TRUE(world.add_cloth(square(n), in_contact()));
        const std::uint64_t now = bytes_between(world);
        EXPECT_EQ(now == 0, n < 2) << n;
        EXPECT_GE(now, bytes);
        made += now != bytes ? 1 : 0;
        bytes = now;
    }
    EXPECT_LT(made, 25);
    // No more than an eighth is spare.
    World other = serial_world();
    for (std::size_t n = 1; n <= 45; ++n) ASSERT_TRUE(other.add_cloth(square(n), in_contact()));
    EXPECT_LE(bytes, bytes_between(other));
}

TEST(RoomBetweenCloths, DoesForOthersThanItWasMadeFor) {
    // Larger cloths, and cloths with impact zones, where room was made for small ones without.
    World world = serial_world();
    std::vector<ClothId> cloths;
    for (std::size_t n = 0; n < 17; ++n) cloths.push_back(world.add_cloth(square(n), in_contact()).value());
    const std::uint64_t of_small = bytes_between(world);
    for (const std::size_t gone : {3u, 4u}) ASSERT_TRUE(world.remove_cloth(cloths[gone]));
    ASSERT_TRUE(world.add_cloth(square(3, 7), in_contact()));
    EXPECT_EQ(bytes_between(world), of_small) << "it has the place of two";
    ASSERT_TRUE(world.add_cloth(square(4, 40), in_contact()));
    EXPECT_GT(bytes_between(world), of_small);
    const std::uint64_t of_large = bytes_between(world);
    ASSERT_TRUE(world.set_cloth_settings(cloths[0], in_contact(SelfCollisionMethod::impact_zones)));
    EXPECT_GT(bytes_between(world), of_large);
    for (int k = 0; k < 3; ++k) world.step(h);
    EXPECT_EQ(world.report().restored_cloths, 0u);
    for (const ClothId id : cloths) static_cast<void>(world.remove_cloth(id));
    for (int k = 0; k < 3; ++k) world.step(h);
    EXPECT_EQ(world.report().restored_cloths, 0u);
}

TEST(RoomBetweenCloths, ThatIsSpareChangesNothing) {
    // Two cloths that meet, alone, and where many others have been.
    const auto fall = [](std::size_t others) {
        World world = serial_world();
        std::vector<ClothId> gone;
        for (std::size_t n = 0; n < 2; ++n) EXPECT_TRUE(world.add_cloth(square(n), in_contact()));
        for (std::size_t n = 0; n < others; ++n)
            gone.push_back(world.add_cloth(square(n + 50), in_contact()).value());
        for (const ClothId id : gone) EXPECT_TRUE(world.remove_cloth(id));
        EXPECT_TRUE(world.add_collider({.shape = Sphere{{0.1f, -0.2f, 0.1f}, 0.15f}}));
        for (int k = 0; k < 20; ++k) world.step(h);
        EXPECT_GT(world.report().self_contacts, 0u);
        return world.state_hash();
    };
    EXPECT_EQ(fall(0), fall(30));
}

}  // namespace
}  // namespace weft::test::room
