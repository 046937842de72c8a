// Memory for the steps of all cloths of a World, while they come and go.

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
    settings.self_collision = {.method = method};
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

std::uint64_t described(const World& world, const std::string& what) {
    const std::string text = world.describe(DescriptionFormat::json).value();
    const std::size_t at = text.find("\"" + what + "\":");
    EXPECT_NE(at, std::string::npos);
    return std::strtoull(text.c_str() + at + what.size() + 3, nullptr, 10);
}
/// All that the World has.
std::uint64_t bytes_of(const World& world) {
    return described(world, "bytes");
}

TEST(RoomForCloths, IsWhatEachOfThemTakesAlone) {
    World world = serial_world();
    const std::uint64_t of_none = bytes_of(world),
                        of_one = world.measure_cloth(square(1), in_contact())->bytes;
    for (std::size_t n = 1; n < 8; ++n) {  // then some is kept to spare
        ASSERT_TRUE(world.add_cloth(square(n), in_contact()));
        EXPECT_EQ(bytes_of(world), of_none + n * of_one) << n;
        EXPECT_EQ(described(world, "bytes_to_spare"), 0u) << n;
    }
}

TEST(RoomForCloths, IsMadeAnewOnlyNowAndThen) {
    World world = serial_world();
    int made = 0;
    std::uint64_t left = 0, of_all = 0;
    for (std::size_t n = 1; n <= 40; ++n) {
        const ClothId id = world.add_cloth(square(n), in_contact()).value();
        of_all += world.cloth_info(id)->bytes;
        const std::uint64_t now = described(world, "bytes_to_spare");
        made += left == 0 || now > left ? 1 : 0;
        EXPECT_LE(8 * now, of_all) << n;
        left = now;
    }
    EXPECT_LT(made, 25);
}

TEST(RoomForCloths, DoesForOthersThanItWasMadeFor) {
    // Larger cloths, and cloths with impact zones, where room was made for small ones without.
    World world = serial_world();
    std::vector<ClothId> cloths;
    for (std::size_t n = 0; n < 17; ++n) cloths.push_back(world.add_cloth(square(n), in_contact()).value());
    for (const std::size_t gone : {3u, 4u}) ASSERT_TRUE(world.remove_cloth(cloths[gone]));
    const std::uint64_t to_spare = described(world, "bytes_to_spare");
    ASSERT_TRUE(world.add_cloth(square(3, 7), in_contact()));
    EXPECT_LT(described(world, "bytes_to_spare"), to_spare) << "it has the place of two";
    const std::uint64_t of_small = bytes_of(world);
    ASSERT_TRUE(world.add_cloth(square(4, 40), in_contact()));
    const std::uint64_t of_large = bytes_of(world);
    EXPECT_GT(of_large, of_small);
    ASSERT_TRUE(world.set_cloth_settings(cloths[0], in_contact(SelfCollisionMethod::impact_zones)));
    EXPECT_GT(bytes_of(world), of_large);
    for (int k = 0; k < 3; ++k) world.step(h);
    EXPECT_EQ(world.report().restored_cloths, 0u);
    for (const ClothId id : cloths) static_cast<void>(world.remove_cloth(id));
    for (int k = 0; k < 3; ++k) world.step(h);
    EXPECT_EQ(world.report().restored_cloths, 0u);
}

TEST(RoomForCloths, ThatIsSpareChangesNothing) {
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
