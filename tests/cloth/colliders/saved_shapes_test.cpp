// Deformed shapes are of the state: they are hashed, saved and put back.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "engine/vector.h"
#include "tests/cloth/fixtures.h"
#include "tests/collision/colliders/solids.h"
#include "weft/weft.h"

namespace weft::test {
namespace {

struct Ground {
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};
Ground ground_of(std::uint32_t side) {
    Ground made;
    for (std::uint32_t r = 0; r < side; ++r)
        for (std::uint32_t c = 0; c < side; ++c)
            made.vertices.push_back(
                {0.2f * static_cast<float>(c) - 0.4f, 0, 0.2f * static_cast<float>(r) - 0.4f});
    for (std::uint32_t r = 0; r + 1 < side; ++r)
        for (std::uint32_t c = 0; c + 1 < side; ++c) {
            const std::uint32_t a = r * side + c, b = a + side;
            made.triangles.push_back({a, b, b + 1});
            made.triangles.push_back({a, b + 1, a + 1});
        }
    return made;
}

/// A sheet on ground that can be raised.
struct OnGround {
    explicit OnGround(std::uint32_t side = 5, std::size_t shapes = 1) : ground(ground_of(side)) {
        const Mesh mesh = make_sheet({.rows = 9,
                                      .columns = 9,
                                      .origin = {-0.2f, 0.02f, -0.2f},
                                      .u = {0.4f, 0, 0},
                                      .v = {0, 0, 0.4f}})
                              .value();
        id = world.add_cloth(mesh).value();
        for (std::size_t k = 0; k < shapes; ++k)
            shape = world
                        .add_shape(TriangleMesh{
                            .vertices = ground.vertices, .triangles = ground.triangles, .closed = false})
                        .value();
        EXPECT_TRUE(world.add_collider({.shape = PlacedShape{.shape = shape}}));
    }
    void raise_to(float height) {
        std::vector<Vec3> to = ground.vertices;
        for (Vec3& v : to) v.y = height + 0.01f * v.x;
        ASSERT_TRUE(world.deform_shape(shape, to));
    }
    /// By no more than its thickness in a step: a sheet has another side.
    void lift(float from, float to) {
        const int steps = static_cast<int>(std::ceil((to - from) / 0.003f));
        for (int k = 1; k <= steps; ++k) {
            raise_to(from + (to - from) * static_cast<float>(k) / static_cast<float>(steps));
            world.step(h);
        }
    }
    void run(int steps) {
        for (int k = 0; k < steps; ++k) world.step(h);
    }
    [[nodiscard]] std::vector<std::byte> save() const {
        std::vector<std::byte> bytes(world.save_size());
        EXPECT_TRUE(world.save(bytes));
        return bytes;
    }
    [[nodiscard]] float height() const { return world.cloth(id)->positions[40].y; }

    Ground ground;
    World world = World::create(vacuum({0, -9.81f, 0})).value();
    ClothId id;
    ShapeId shape;
};

TEST(SavedShapes, DeformedGroundIsPutBack) {
    OnGround scene;
    scene.run(30);
    scene.lift(0, 0.01f);
    scene.run(10);
    const std::uint64_t hash = scene.world.state_hash();
    const std::vector<std::byte> saved = scene.save();
    scene.run(30);
    const std::uint64_t later = scene.world.state_hash();
    scene.raise_to(0.05f);
    EXPECT_NE(scene.world.state_hash(), later) << "it is hashed";
    scene.run(30);
    ASSERT_TRUE(scene.world.restore(saved));
    EXPECT_EQ(scene.world.state_hash(), hash);
    scene.run(30);
    EXPECT_EQ(scene.world.state_hash(), later);
    EXPECT_NEAR(scene.height(), 0.015f, 1e-3f);
}

// Between the call and the step it pushes with the speed with which it gets there.
TEST(SavedShapes, DeformationThatHasNotBeenSteppedYetIsPutBack) {
    OnGround scene;
    scene.run(30);
    scene.raise_to(0.004f);
    const std::vector<std::byte> saved = scene.save();
    scene.run(1);
    const std::uint64_t later = scene.world.state_hash();
    const float speed = scene.world.cloth(scene.id)->velocities[40].y;
    EXPECT_GT(speed, 0.2f);
    scene.run(20);
    ASSERT_TRUE(scene.world.restore(saved));
    scene.run(1);
    EXPECT_EQ(scene.world.state_hash(), later);
}

TEST(SavedShapes, WorldMadeLaterTakesThem) {
    OnGround first, second;
    first.run(5);
    const std::vector<std::byte> plain = first.save();
    first.lift(0, 0.02f);
    first.run(20);
    const std::vector<std::byte> raised = first.save();
    EXPECT_GT(raised.size(), plain.size()) << "what has not been deformed takes no room";
    ASSERT_TRUE(second.world.restore(raised));
    EXPECT_EQ(second.world.state_hash(), first.world.state_hash());
    first.run(20);
    second.run(20);
    EXPECT_EQ(second.world.state_hash(), first.world.state_hash());
    ASSERT_TRUE(second.world.restore(plain));
    second.run(60);
    EXPECT_NEAR(second.height(), 0.005f, 1e-3f) << "the ground is as it was made";
}

TEST(SavedShapes, OtherShapesAreRefused) {
    OnGround scene;
    scene.raise_to(0.02f);
    const std::vector<std::byte> saved = scene.save();
    OnGround larger(6), more(5, 2);
    for (auto& [other, what] : {std::pair{&larger, "25 vertices"}, std::pair{&more, "1 shapes"}}) {
        const std::uint64_t before = other->world.state_hash();
        const auto restored = other->world.restore(saved);
        ASSERT_FALSE(restored);
        EXPECT_NE(restored.error().message.find(what), std::string::npos) << restored.error().message;
        EXPECT_EQ(other->world.state_hash(), before);
    }
}

}  // namespace
}  // namespace weft::test
