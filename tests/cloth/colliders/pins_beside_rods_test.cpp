// Rods that come near pins: an edge beside a pin cannot give way, and its other end is not to go by a lever.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "engine/vector.h"
#include "weft/weft.h"

namespace weft::test {
namespace {

constexpr float seconds_of_step = 1.0f / 60;

/// How far a particle goes at most in one of the steps [m].
class FarthestWay {
  public:
    FarthestWay(World& world, ClothId cloth) : world_(world), cloth_(cloth) {}
    void step() {
        const auto before = world_.cloth(cloth_).value().positions;
        const std::vector<Vec4> were(before.begin(), before.end());
        world_.step(seconds_of_step);
        const ClothView view = world_.cloth(cloth_).value();
        for (std::size_t i = 0; i < were.size(); ++i)
            way_ = std::max(way_, (xyz(view.positions[i]) - xyz(were[i])).norm());
    }
    [[nodiscard]] float way() const { return way_; }

  private:
    World& world_;
    ClothId cloth_;
    float way_ = 0;
};

/// A rod in any direction, at this place.
Collider rod_at(const Vector3& at, const Vector3& half, float radius) {
    return {.shape = Capsule{to_vec3(Vector3(at - half)), to_vec3(Vector3(at + half)), radius}};
}

// An edge beside a pin cannot give way. The other end went by a lever, kilometres in a step.
TEST(ThinColliders, ARodThatGoesByPinsThrowsNothing) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> uniform(-1, 1);
    const auto vector = [&](float x, float y, float z) {
        return Vector3(x * uniform(random), y * uniform(random), z * uniform(random));
    };
    for (const float speed : {0.2f, 1.0f, 3.0f})
        for (int trial = 0; trial < 8; ++trial) {
            World world = World::create({.threads = 1}).value();
            const Mesh mesh =
                make_sheet({.rows = 13, .columns = 13, .origin = {-0.5f, 0, 0}, .v = {0, -1, 0}}).value();
            const ClothId cloth = world.add_cloth(mesh).value();
            for (std::uint32_t i = 0; i < 13; ++i) ASSERT_TRUE(world.pin(cloth, i));
            const float radius = 0.0225f + 0.0175f * uniform(random);
            const Vector3 half = 0.2f * (vector(1, 1, 0.3f) + Vector3(0.1f, 0, 0)).normalized();
            Vector3 at = vector(0.4f, 0.1f, 0) + Vector3(0, 0, 0.15f);
            const Vector3 way =
                speed * seconds_of_step * (vector(0.3f, 0.3f, 0) - Vector3(0, 0, 1)).normalized();
            const ColliderId rod = world.add_collider(rod_at(at, half, radius)).value();
            FarthestWay farthest(world, cloth);
            for (float gone = 0; gone < 0.3f; gone += way.norm()) {
                at += way;
                ASSERT_TRUE(world.move_collider(rod, rod_at(at, half, radius)));
                farthest.step();
            }
            EXPECT_LT(farthest.way(), 0.5f) << trial << " at " << speed << " m/s";
        }
}

TEST(ThinColliders, APinThatIsCarriedOntoARodThrowsNothing) {
    std::mt19937 random(12);
    std::uniform_real_distribution<float> uniform(-1, 1);
    for (const float speed : {0.2f, 1.0f, 3.0f})
        for (int trial = 0; trial < 8; ++trial) {
            World world = World::create({.threads = 1}).value();
            const Mesh mesh =
                make_sheet(
                    {.rows = 13, .columns = 13, .origin = {-0.5f, 0, -0.5f}, .u = {1, 0, 0}, .v = {0, 0, 1}})
                    .value();
            const ClothId cloth = world.add_cloth(mesh).value();
            const std::uint32_t pin = 14 + 13 * static_cast<std::uint32_t>(trial) + 3;
            ASSERT_TRUE(world.pin(cloth, pin));
            Vector3 at = xyz(world.cloth(cloth).value().positions[pin]);
            const Vector3 half = 0.3f * Vector3(uniform(random), 0.2f * uniform(random), 1).normalized();
            const Vector3 below(0.02f * uniform(random), -0.08f, 0.02f * uniform(random));
            const float radius = 0.0175f + 0.0125f * uniform(random);
            ASSERT_TRUE(world.add_collider(rod_at(at + below, half, radius)));
            FarthestWay farthest(world, cloth);
            for (float gone = 0; gone < 0.2f; gone += speed * seconds_of_step) {
                at.y() -= speed * seconds_of_step;
                ASSERT_TRUE(world.move_pin(cloth, pin, to_vec3(at)));
                farthest.step();
            }
            EXPECT_LT(farthest.way(), 0.5f) << trial << " at " << speed << " m/s";
        }
}

}  // namespace
}  // namespace weft::test
