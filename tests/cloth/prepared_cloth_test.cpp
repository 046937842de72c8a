// PreparedCloth, as a host uses it: made beside the frame, then taken over.

#include <gtest/gtest.h>

#include <future>
#include <utility>
#include <vector>

#include "weft/weft.h"

namespace weft::test {
namespace {

Mesh hung_sheet(float height) {
    return make_sheet(
               {.rows = 12, .columns = 11, .origin = {0, height, 0}, .u = {0.4f, 0, 0}, .v = {0, 0, 0.4f}})
        .value();
}

World windy_world() {
    WorldSettings settings;
    settings.threads = 1;
    settings.wind = {.velocity = {1, 0, 2}, .gust = 0.4f};
    settings.contact_reports = 32;
    World world = World::create(settings).value();
    EXPECT_TRUE(world.add_collider({.shape = Sphere{{0.2f, 0.3f, 0.2f}, 0.15f}}));
    return world;
}

ClothSettings with_contact(int number) {
    ClothSettings settings;
    if (number % 2 == 0) settings.self_collision = {.enabled = true, .method = SelfCollisionMethod::contact};
    settings.tethers.enabled = number % 3 == 0;
    return settings;
}

TEST(PreparedCloth, MovesAsByItsMeshWhereverItWasMade) {
    constexpr int count = 6;
    std::vector<std::future<Result<PreparedCloth>>> made;
    for (int k = 0; k < count; ++k)
        made.push_back(std::async(std::launch::async, [k] {
            return PreparedCloth::create(hung_sheet(0.5f + 0.1f * static_cast<float>(k)), with_contact(k));
        }));
    World by_mesh = windy_world(), prepared = windy_world();
    for (int k = 0; k < count; ++k) {
        const ClothId a =
            by_mesh.add_cloth(hung_sheet(0.5f + 0.1f * static_cast<float>(k)), with_contact(k)).value();
        PreparedCloth cloth = made[static_cast<std::size_t>(k)].get().value();
        ASSERT_TRUE(cloth.has_cloth());
        EXPECT_EQ(cloth.info()->particles, 132u);
        const ClothId b = prepared.add_cloth(std::move(cloth)).value();
        EXPECT_EQ(by_mesh.cloth_info(a).value(), prepared.cloth_info(b).value());
        ASSERT_TRUE(by_mesh.pin(a, 0));
        ASSERT_TRUE(prepared.pin(b, 0));
    }
    for (int step = 0; step < 40; ++step) {
        by_mesh.step(1.0f / 60);
        prepared.step(1.0f / 60);
        ASSERT_EQ(by_mesh.state_hash(), prepared.state_hash()) << "step " << step;
    }
}

TEST(PreparedCloth, IsTakenOverOnce) {
    World world = World::create().value();
    PreparedCloth cloth = PreparedCloth::create(hung_sheet(1)).value();
    ASSERT_TRUE(world.add_cloth(std::move(cloth)));
    EXPECT_FALSE(cloth.has_cloth());
    EXPECT_FALSE(cloth.info());
    const auto again = world.add_cloth(std::move(cloth));
    ASSERT_FALSE(again);
    EXPECT_NE(again.error().message.find("taken it over"), std::string::npos);
    world.step(1.0f / 60);
    EXPECT_EQ(world.report().cloths, 1u);
}

TEST(PreparedCloth, RefusesWhatAddClothRefuses) {
    const auto no_mesh = PreparedCloth::create({});
    ASSERT_FALSE(no_mesh);
    EXPECT_EQ(no_mesh.error().message, World::create()->add_cloth(Mesh{}).error().message);
    ClothSettings bad;
    bad.substeps = 0;
    EXPECT_FALSE(PreparedCloth::create(hung_sheet(1), bad));
}

}  // namespace
}  // namespace weft::test
