// Scratch that groups of cloths take of what the World has, which is laid out for each cloth alone.

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "cloth/instance/cloth.h"
#include "cloth/instance/group.h"
#include "tests/cloth/fixtures.h"
#include "tests/must.h"
#include "weft/weft.h"

namespace weft::test {
namespace {

std::size_t bytes_of(std::span<const ContactCloth> bodies) {
    Scratch scratch;
    Group group;
    group.lay_out(scratch, bodies.size());
    group.contact.lay_out(scratch, bodies, nullptr);
    return scratch.bytes();
}

TEST(GroupScratch, OfAGroupIsNoMoreThanOfItsClothsAlone) {
    std::mt19937 random(3);
    std::vector<ContactMesh> meshes;
    for (const std::uint32_t side : {2u, 3u, 5u, 9u, 16u, 17u, 33u, 64u, 90u}) {
        const Mesh mesh = must(make_sheet({.rows = side, .columns = side + 1}));
        std::vector<Vec4> positions;
        for (const Vec3& p : mesh.positions) positions.push_back({p.x, p.y, p.z, 1});
        meshes.emplace_back(positions, mesh.triangles);
    }
    for (int k = 0; k < 200; ++k) {
        std::vector<ContactCloth> group(1 + random() % 20);
        std::size_t alone = 0;
        for (ContactCloth& body : group) {
            body.mesh = &meshes[random() % meshes.size()];
            body.by_zones = random() % 2 == 0;
            alone += scratch_bytes(body.mesh, body.by_zones);
        }
        EXPECT_LE(bytes_of(group), alone) << group.size() << " cloths";
    }
}

// A box sweeps one sheet into another, which was too far off to be of its group when the step began.
TEST(GroupScratch, ClothByZonesThatStraysIntoAnotherGroupIsParted) {
    WorldSettings still;
    still.gravity = {};
    still.wind.air_density = 0;
    still.threads = 1;
    World world = must(World::create(still));
    ClothSettings settings;
    settings.self_collision = {.method = SelfCollisionMethod::impact_zones};
    std::vector<ClothId> sheets;
    for (const float y : {0.0f, 0.06f})
        sheets.push_back(must(world.add_cloth(
            must(make_sheet(
                {.rows = 12, .columns = 12, .origin = {0, y, 0}, .u = {0.3f, 0, 0}, .v = {0, 0, 0.3f}})),
            settings)));
    const auto box = [](float y) {
        return Collider{.shape = Box{.center = {0.15f, y, 0.15f}, .half_extents = {0.3f, 0.05f, 0.3f}}};
    };
    const ColliderId below = must(world.add_collider(box(-0.06f)));
    world.step(1.0f / 60);
    ASSERT_TRUE(world.move_collider(below, box(0.04f)));
    world.step(1.0f / 60);
    EXPECT_GT(world.cloth(sheets[0])->bounds.upper.y, 0.05f) << "it was to be swept along";
    EXPECT_EQ(world.report().restored_cloths, 0u);
    for (int k = 0; k < 10; ++k) world.step(1.0f / 60);
    EXPECT_LT(world.cloth(sheets[0])->bounds.upper.y, world.cloth(sheets[1])->bounds.upper.y + 0.02f);
}

}  // namespace
}  // namespace weft::test
