// A cloth that is pulled from under a plate.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/cloth/colliders/bodies_scene.h"

namespace weft::test {
namespace {

constexpr float radius = 0.12f;

/// A plate of that half height on a cloth on a table.
struct SetTable {
    static constexpr std::uint32_t rows = 33, columns = 49;

    SetTable(bool is_round, float half)
        : world(World::create({.threads = 1}).value()),
          cloth(world
                    .add_cloth(*make_sheet({.rows = rows,
                                            .columns = columns,
                                            .origin = {-0.6f, 0.004f, -0.4f},
                                            .u = {1.2f, 0, 0},
                                            .v = {0, 0, 0.8f}}))
                    .value()) {
        EXPECT_TRUE(world.add_collider(
            {.shape = Box{.center = {0, -0.05f, 0}, .half_extents = {0.6f, 0.05f, 0.4f}}}));
        const Vec3 at{0.1f, 0.02f + half, 0};
        Collider collider{.shape = Box{.center = at, .half_extents = {radius, half, radius}},
                          .friction = 0.3f};
        if (is_round) {
            constexpr int corners = 24;
            std::vector<Vec3> points;
            for (int k = 0; k < corners; ++k) {
                const float angle = 6.2831853f * static_cast<float>(k) / corners;
                for (const float y : {-half, half})
                    points.push_back({radius * std::cos(angle), y, radius * std::sin(angle)});
            }
            collider.shape = PlacedShape{world.add_shape(ConvexHull{.points = points}).value(), at};
        }
        plate =
            world.add_body({.mass = 0.6f, .inertia = {2.2e-3f, 4.3e-3f, 2.2e-3f}}, {.position = at}).value();
        EXPECT_TRUE(world.attach_collider(plate, world.add_collider(collider).value()));
        for (int k = 0; k < 120; ++k) world.step(body_step);
    }

    World world;
    ClothId cloth;
    BodyId plate;
};

// By Coulomb's law the plate gets to some 0.9 m/s. It was thrown up by 5 to 12 cm, at up to 4.5 m/s.
TEST(Tablecloth, IsPulledFromUnderAPlate) {
    for (const bool is_round : {true, false})
        for (const float half : {0.01f, 0.05f})
            for (const float speed : {5.0f, 8.0f}) {
                SetTable table(is_round, half);
                const BodyState before = table.world.body_state(table.plate).value();
                std::vector<std::uint32_t> border;
                std::vector<Vec3> places;
                const ClothView& view = *table.world.cloth(table.cloth);
                for (std::uint32_t row = 0; row < SetTable::rows; ++row) {
                    border.push_back((row + 1) * SetTable::columns - 1);
                    places.push_back(to_vec3(xyz(view.positions[view.vertex_to_particle[border.back()]])));
                }
                ASSERT_TRUE(table.world.pin(table.cloth, border));
                float pulls = 0, fastest = 0, highest = -1;
                for (float way = 0; way < 1.6f; way += pulls * body_step) {
                    pulls = std::min(speed, pulls + 20 * body_step);
                    for (Vec3& place : places) place.x += pulls * body_step;
                    ASSERT_TRUE(table.world.move_pins(table.cloth, border, places));
                    table.world.step(body_step);
                    const BodyState now = table.world.body_state(table.plate).value();
                    fastest = std::max(fastest, std::abs(now.velocity.x));
                    highest = std::max(highest, now.position.y);
                }
                const std::string which = std::string(is_round ? "disc" : "box") + " of half height " +
                                          std::to_string(half) + ", pulled at " + std::to_string(speed);
                EXPECT_LT(fastest, 2.2f) << which;
                EXPECT_LT(highest, before.position.y + 2e-3f) << which;
            }
}

}  // namespace
}  // namespace weft::test
