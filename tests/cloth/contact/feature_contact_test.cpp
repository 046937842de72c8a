// Cloth that meets itself and other cloth by contact, as a host sees it: nothing passes through.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "crossing_count.h"
#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"
#include "weft/weft.h"

namespace weft::test::feature_contact {
namespace {

WorldSettings still_air(int threads = 1, Vec3 gravity = {0, -9.81f, 0}) {
    WorldSettings settings;
    settings.gravity = gravity;
    settings.wind.air_density = 0;
    settings.threads = threads;
    return settings;
}

ClothSettings with_contact() {
    ClothSettings settings;
    settings.self_collision = {.method = SelfCollisionMethod::contact};
    return settings;
}

std::vector<std::uint32_t> border_of(std::uint32_t side) {
    std::vector<std::uint32_t> border;
    for (std::uint32_t i = 0; i < side; ++i)
        border.insert(border.end(), {i, side * (side - 1) + i, side * i, side * i + side - 1});
    return border;
}

float mean_height(const World& world, ClothId id) {
    float sum = 0;
    const ClothView view = world.cloth(id).value();
    for (const Vec4& x : view.positions) sum += x.y;
    return sum / static_cast<float>(view.positions.size());
}

/// Sheets above one another, the lowest held at its border.
struct Stack {
    explicit Stack(int count, const ClothSettings& settings = with_contact(), int threads = 1,
                   float apart = 0.05f)
        : world(World::create(still_air(threads)).value()) {
        for (int k = 0; k < count; ++k)
            cloths.push_back(
                world
                    .add_cloth(turned_sheet(apart * static_cast<float>(k), 0.3f * static_cast<float>(k)),
                               settings)
                    .value());
        EXPECT_TRUE(world.pin(cloths[0], border_of(13)));
    }
    [[nodiscard]] std::vector<Vec4> positions() const {
        std::vector<Vec4> all;
        for (const ClothId id : cloths) {
            const ClothView view = world.cloth(id).value();
            all.insert(all.end(), view.positions.begin(), view.positions.end());
        }
        return all;
    }

    World world;
    std::vector<ClothId> cloths;
};

TEST(ClothOnCloth, StaysOnItInItsOrderAndCrossesNothing) {
    Stack stack(3);
    bool any_meet = false;
    for (int k = 0; k < 90; ++k) {
        stack.world.step(h);
        ASSERT_EQ(crossings(stack.world, stack.cloths), 0) << "in step " << k;
        any_meet |= stack.world.report().self_contacts > 0;
    }
    EXPECT_TRUE(any_meet);
    EXPECT_GT(mean_height(stack.world, stack.cloths[1]), mean_height(stack.world, stack.cloths[0]));
    EXPECT_GT(mean_height(stack.world, stack.cloths[2]), mean_height(stack.world, stack.cloths[1]));
}

TEST(ClothOnCloth, FallsThroughWhereContactIsOffOrMasked) {
    ClothSettings masked = with_contact();
    masked.self_collision.mask = 2;
    for (const ClothSettings& settings : {ClothSettings{}, masked}) {
        Stack stack(2, settings);
        for (int k = 0; k < 60; ++k) stack.world.step(h);
        EXPECT_LT(mean_height(stack.world, stack.cloths[1]), -1);
    }
}

TEST(ClothOnCloth, MeetsWhenOnlyOneOfItsLayersIsInTheOthersMask) {
    ClothSettings one = with_contact(), other = with_contact();
    one.self_collision.layers = 6;
    other.self_collision.mask = 2;
    World world = World::create(still_air()).value();
    const ClothId below = world.add_cloth(turned_sheet(0), one).value();
    const ClothId above = world.add_cloth(turned_sheet(0.05f, 0.3f), other).value();
    ASSERT_TRUE(world.pin(below, border_of(13)));
    for (int k = 0; k < 60; ++k) world.step(h);
    EXPECT_GT(mean_height(world, above), mean_height(world, below));
}

/// Ten sheets within a millimetre, kept 5 cm apart: far more pairs than the list has room for.
World crowd(bool with_contact, bool with_zones, int threads) {
    World world = World::create(still_air(threads)).value();
    EXPECT_TRUE(world.add_collider({.shape = Plane{}}));
    for (std::uint32_t k = 0; k < 10; ++k) {
        const float height = 0.01f + 1e-4f * static_cast<float>(k), shift = 1e-3f * static_cast<float>(k);
        const Mesh mesh =
            make_sheet(
                {.rows = 6, .columns = 6, .origin = {shift, height, 0}, .u = {0.1f, 0, 0}, .v = {0, 0, 0.1f}})
                .value();
        ClothSettings cloth;
        cloth.method = Xpbd{.iterations = 10};
        cloth.substeps = 2;
        const bool by_zones = with_zones && (!with_contact || k % 2 == 0);
        cloth.self_collision = {
            .method = by_zones ? SelfCollisionMethod::impact_zones : SelfCollisionMethod::contact,
            .distance = 0.05f};
        EXPECT_TRUE(world.add_cloth(mesh, cloth));
    }
    return world;
}

// The search ends when its threads learn that the list is full, and takes a crowd that was met before in
// another order: neither may show.
TEST(ClothOnCloth, ACrowdGivesTheSameBytesOnAnyThreadsAndWhenItIsPutBack) {
    for (const auto& [contact, zones] : {std::pair(true, false), {false, true}, {true, true}}) {
        SCOPED_TRACE(testing::Message() << contact << zones);
        World world = crowd(contact, zones, 1), on_threads = crowd(contact, zones, 3);
        std::vector<std::byte> saved(world.save_size());
        for (int k = 0; k < 12; ++k) {
            if (k == 6) {
                ASSERT_TRUE(world.save(saved));
            }
            world.step(h);
            on_threads.step(h);
            EXPECT_TRUE(has(world.report().flags, StepFlags::contacts_dropped));
            ASSERT_EQ(on_threads.state_hash(), world.state_hash()) << k;
        }
        World put_back = crowd(contact, zones, 2);
        ASSERT_TRUE(put_back.restore(saved));
        for (int k = 6; k < 12; ++k) put_back.step(h);
        EXPECT_EQ(put_back.state_hash(), world.state_hash());
    }
}

TEST(ClothOnCloth, FarClothDoesNotNotice) {
    const auto far_cloth_after = [](bool alone) {
        World world = World::create(still_air()).value();
        const ClothId far = world.add_cloth(turned_sheet(5), with_contact()).value();
        if (!alone) {
            const ClothId held = world.add_cloth(turned_sheet(0), with_contact()).value();
            EXPECT_TRUE(world.pin(held, border_of(13)));
            EXPECT_TRUE(world.add_cloth(turned_sheet(0.02f, 0.3f), with_contact()));
        }
        for (int k = 0; k < 20; ++k) world.step(h);
        const ClothView view = world.cloth(far).value();
        return std::vector<Vec4>(view.positions.begin(), view.positions.end());
    };
    EXPECT_TRUE(same_bytes(far_cloth_after(true), far_cloth_after(false)));
}

TEST(ClothOnCloth, KeepsTheMomentumOfBoth) {
    World world = World::create(still_air(1, {})).value();
    ClothSettings settings = with_contact();
    settings.air_damping = 0;
    const std::array cloths{world.add_cloth(turned_sheet(0), settings).value(),
                            world.add_cloth(turned_sheet(0.06f, 0.3f), settings).value()};
    // A push of gravity makes the upper one fall, then there is none.
    ASSERT_TRUE(world.pin(cloths[0], border_of(13)));
    WorldSettings pull = still_air();
    ASSERT_TRUE(world.set_settings(pull));
    world.step(h);
    ASSERT_TRUE(world.set_settings(still_air(1, {})));
    ASSERT_TRUE(world.unpin(cloths[0], border_of(13)));
    const auto momentum = [&] {
        double sum = 0;
        for (const ClothId id : cloths) {
            const ClothView view = world.cloth(id).value();
            for (std::size_t i = 0; i < view.velocities.size(); ++i)
                sum += static_cast<double>(view.velocities[i].y / view.positions[i].w);
        }
        return sum;
    };
    for (int k = 0; k < 12; ++k) world.step(h);  // BDF2 goes on with what a push was for some steps
    const double before = momentum();
    ASSERT_LT(before, 0);
    ASSERT_EQ(world.report().self_contacts, 0u);
    for (int k = 0; k < 60; ++k) world.step(h);
    EXPECT_NEAR(momentum(), before, 1e-4 * std::abs(before));
    EXPECT_EQ(crossings(world, cloths), 0);
}

/// A sheet folded in two, its halves `apart`, that falls onto the ground.
struct Packet {
    explicit Packet(const ClothSettings& settings, float apart = 0.02f)
        : world(World::create(still_air()).value()) {
        Mesh mesh = make_sheet({.rows = 9, .columns = 25, .origin = {}, .u = {0.6f, 0, 0}, .v = {0, 0, 0.2f}})
                        .value();
        for (Vec3& x : mesh.positions) {
            const float beyond = x.x - 0.3f, length = 0.5f * 3.14159265f * apart;
            const float turn = std::clamp(beyond / length + 0.5f, 0.0f, 1.0f) * 3.14159265f;
            const float flat = std::max(std::abs(beyond) - 0.5f * length, 0.0f);
            x = {0.3f - flat + 0.5f * apart * std::sin(turn), 0.1f + 0.5f * apart * (1 - std::cos(turn)),
                 x.z + 0.02f * x.x};
        }
        cloth = world.add_cloth(mesh, settings).value();
        EXPECT_TRUE(world.add_collider({Plane{{0, 1, 0}, 0}}));
    }
    World world;
    ClothId cloth;
};

TEST(FoldedCloth, CrossesNothingByAnyMethod) {
    const std::vector<std::pair<const char*, Method>> methods{{"Multilevel", Multilevel{}},
                                                              {"Jacobi", Jacobi{}},
                                                              {"Chebyshev", Chebyshev{}},
                                                              {"ConjugateGradient", ConjugateGradient{}},
                                                              {"Xpbd", Xpbd{}},
                                                              {"Fibres", Fibres{}}};
    for (const auto& [name, method] : methods) {
        ClothSettings settings = with_contact();
        settings.method = method;
        Packet packet(settings);
        ASSERT_EQ(crossings(packet.world, std::span(&packet.cloth, 1)), 0);
        for (int k = 0; k < 60; ++k) {
            packet.world.step(h);
            ASSERT_EQ(crossings(packet.world, std::span(&packet.cloth, 1)), 0) << name << " in step " << k;
        }
        EXPECT_FALSE(has(packet.world.report().flags, StepFlags::state_restored)) << name;
    }
}

TEST(FoldedCloth, CrossesNothingWithSubstepsAndElements) {
    for (const bool elements : {false, true}) {
        for (const int substeps : {1, 3}) {
            ClothSettings settings = with_contact();
            settings.finite_elements.enabled = elements;
            settings.substeps = substeps;
            Packet packet(settings);
            for (int k = 0; k < 40; ++k) packet.world.step(h);
            EXPECT_EQ(crossings(packet.world, std::span(&packet.cloth, 1)), 0) << elements << substeps;
        }
    }
}

TEST(FoldedCloth, FallsAsOneThatDoesNotTouchItself) {
    Packet packet(with_contact(), 0.004f);
    const float before = mean_height(packet.world, packet.cloth);
    for (int k = 0; k < 6; ++k) packet.world.step(h);
    const float fallen = before - mean_height(packet.world, packet.cloth), t = 6 * h;
    EXPECT_NEAR(fallen, 0.5f * 9.81f * t * t, 0.1f * fallen);
}

/// A sheet of 0.3 m on a larger one that is held everywhere and falls along x by so much.
struct Slope {
    static constexpr std::uint32_t side = 13;
    static constexpr float edge = 0.3f / (side - 1);

    Slope(float angle, float friction) : Slope(angle, friction, friction) {}
    Slope(float angle, float friction_below, float friction)
        : down(std::cos(angle), -std::sin(angle), 0), up(std::sin(angle), std::cos(angle), 0) {
        ClothSettings settings = with_contact();
        settings.self_collision.friction = friction_below;
        settings.air_damping = 0;
        const auto lying = [&](float height, float length, std::uint32_t particles) {
            const Eigen::Vector3f at = height * up - 0.5f * length * down, along = length * down;
            return make_sheet({.rows = particles,
                               .columns = particles,
                               .origin = {at.x(), at.y(), -0.5f * length},
                               .u = {along.x(), along.y(), along.z()},
                               .v = {0, 0, length}})
                .value();
        };
        const ClothId below = world.add_cloth(lying(0, 20 * edge, 21), settings).value();
        for (std::uint32_t i = 0; i < 21 * 21; ++i) EXPECT_TRUE(world.pin(below, i));
        settings.self_collision.friction = friction;
        cloth = world.add_cloth(lying(0.31f * edge, 0.3f, side), settings).value();
        cloths = {below, cloth};
    }
    [[nodiscard]] float mean(const Eigen::Vector3f& direction) const {
        float sum = 0;
        const ClothView view = world.cloth(cloth).value();
        for (const Vec4& x : view.positions) sum += direction.dot(Eigen::Vector3f(x.x, x.y, x.z));
        return sum / static_cast<float>(view.positions.size());
    }

    Eigen::Vector3f down, up;
    World world = World::create(still_air()).value();
    ClothId cloth;
    std::array<ClothId, 2> cloths;
};

TEST(ClothOnCloth, RestsOnASlopeOfClothThatIsHeldEverywhere) {
    Slope slope(0.349f, 0.5f);  // 20 degrees
    for (int k = 0; k < 120; ++k) slope.world.step(h);
    EXPECT_GT(slope.mean(slope.up), 0.25f * Slope::edge);
    EXPECT_LT(rms_speed(*slope.world.cloth(slope.cloth)), 2e-3);
    const float before = slope.mean(slope.down);
    for (int k = 0; k < 60; ++k) slope.world.step(h);
    EXPECT_NEAR(slope.mean(slope.down), before, 1e-4f);  // 1 mm in 10 s
    EXPECT_EQ(crossings(slope.world, slope.cloths), 0);
}

// How far one sheet gets, any rounding changes by some 4 %, as it catches on what is uneven: hence means of
// many slopes that differ by next to nothing.
float mean_way(float friction_below, float friction, int steps) {
    constexpr int slopes = 8;
    float sum = 0;
    for (int k = 0; k < slopes; ++k) {
        Slope slope(0.611f + 1e-5f * static_cast<float>(k), friction_below, friction);  // 35 degrees
        const float before = slope.mean(slope.down);
        for (int n = 0; n < steps; ++n) slope.world.step(h);
        sum += slope.mean(slope.down) - before;
    }
    return sum / slopes;
}

// By Coulomb's law: what landing takes of its speed, and the air, are what is missing.
TEST(ClothOnCloth, SlidesDownASlopeOfClothThatIsHeldEverywhere) {
    constexpr float angle = 0.611f;
    constexpr int steps = 20;
    for (const float friction : {0.0f, 0.1f, 0.3f, 0.5f}) {
        const float seconds = steps * h;
        const float way = 0.5f * 9.81f * (std::sin(angle) - friction * std::cos(angle)) * seconds * seconds;
        const float part = mean_way(friction, friction, steps) / way;
        EXPECT_GT(part, friction > 0 ? 0.64f : 0.9f) << friction;
        EXPECT_LT(part, 1) << friction;
    }
}

// A friction of 0.31 changes the way by a tenth.
TEST(ClothOnCloth, RubsByTheGeometricMeanOfBothFrictions) {
    constexpr int steps = 20;
    const float expected = mean_way(0.3f, 0.3f, steps);
    EXPECT_NEAR(mean_way(0.1f, 0.9f, steps), expected, 0.03f * expected);
    EXPECT_NEAR(mean_way(0.9f, 0.1f, steps), expected, 0.03f * expected);
}

// Particles within the distance along the cloth are no layers.
TEST(FoldedCloth, AtRestStaysAtRestWhateverTheDistance) {
    const Mesh mesh = make_sheet({.rows = 13, .columns = 13, .u = {0.3f, 0, 0}, .v = {0, 0, 0.3f}}).value();
    for (const float edges : {0.75f, 1.6f, 2.1f, 3.3f}) {
        World world = World::create(still_air(1, {})).value();
        ClothSettings settings = with_contact();
        settings.self_collision.distance = edges * 0.3f / 12;
        const ClothId cloth = world.add_cloth(mesh, settings).value();
        for (int k = 0; k < 20; ++k) world.step(h);
        const ClothView view = world.cloth(cloth).value();
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            const Vec4& x = view.positions[view.vertex_to_particle[v]];
            ASSERT_LT((xyz(x) - to_vector(mesh.positions[v])).norm(), 1e-5f) << edges << " edges, " << v;
        }
    }
}

// Which features touch is found in each pass: by three passes of three iterations most of them went on.
TEST(ClothOnCloth, ComesToRestOnASheetThatIsHungByItsCorners) {
    for (const std::uint32_t side : {9u, 17u}) {
        World world = World::create({.threads = 1}).value();
        const auto add = [&](float height) {
            const Mesh mesh = make_sheet({.rows = side,
                                          .columns = side,
                                          .origin = {-0.15f, height, -0.15f},
                                          .u = {0.3f, 0, 0},
                                          .v = {0, 0, 0.3f}})
                                  .value();
            return world.add_cloth(mesh, with_contact()).value();
        };
        const ClothId below = add(0.5f);
        for (const std::uint32_t corner : {0u, side - 1, side * (side - 1), side * side - 1})
            ASSERT_TRUE(world.pin(below, corner));
        for (int k = 0; k < 300; ++k) world.step(h);
        const ClothId cloth = add(0.55f);
        for (int k = 0; k < 600; ++k) world.step(h);
        EXPECT_LT(rms_speed(*world.cloth(cloth)), 2e-3) << side;
        EXPECT_EQ(crossings(world, std::array{below, cloth}), 0) << side;
    }
}

TEST(ClothOnCloth, ComesToRestOnTheGround) {
    World world = World::create(still_air()).value();
    ASSERT_TRUE(world.add_collider({Plane{{0, 1, 0}, -0.02f}}));
    const std::array cloths{world.add_cloth(turned_sheet(0), with_contact()).value(),
                            world.add_cloth(turned_sheet(0.02f, 0.3f), with_contact()).value()};
    for (int k = 0; k < 600; ++k) world.step(h);
    for (const ClothId id : cloths) EXPECT_LT(rms_speed(*world.cloth(id)), 2e-3);
    EXPECT_GT(mean_height(world, cloths[1]), mean_height(world, cloths[0]) + 5e-3f);
    EXPECT_EQ(crossings(world, cloths), 0);
}

TEST(FoldedCloth, StopsAPinThatWouldGoThroughItAndSaysSo) {
    Stack stack(2);
    ASSERT_TRUE(stack.world.pin(stack.cloths[1], 84));
    for (int k = 0; k < 20; ++k) stack.world.step(h);
    StepFlags flags = StepFlags::none;
    float lag = 0;
    for (int k = 0; k < 20; ++k) {
        ASSERT_TRUE(stack.world.move_pin(stack.cloths[1], 84, {0, -0.05f * static_cast<float>(k), 0}));
        const StepReport& report = stack.world.step(h);
        flags = flags | report.flags;
        lag = std::max(lag, report.pin_lag);
        ASSERT_EQ(crossings(stack.world, stack.cloths), 0) << "in step " << k;
    }
    EXPECT_TRUE(has(flags, StepFlags::pins_stopped));
    EXPECT_GT(lag, 0.01f);
}

TEST(FoldedCloth, HasNoCrossingHoweverFastItIsThrown) {
    for (const float speed : {5.0f, 50.0f}) {
        World world = World::create(still_air(1, {})).value();
        const std::array cloths{world.add_cloth(turned_sheet(0), with_contact()).value(),
                                world.add_cloth(turned_sheet(0.5f, 0.4f), with_contact()).value()};
        ASSERT_TRUE(world.pin(cloths[0], border_of(13)));
        ASSERT_TRUE(world.pin(cloths[1], border_of(13)));
        for (int k = 0; k < 12; ++k) {
            for (const std::uint32_t i : border_of(13)) {
                const Vec4 x = world.cloth(cloths[1]).value().positions[i];
                ASSERT_TRUE(world.move_pin(cloths[1], i, {x.x, x.y - speed * h, x.z}));
            }
            world.step(h);
            ASSERT_EQ(crossings(world, cloths), 0) << speed << " m/s, step " << k;
        }
    }
}

// Each cloth says so of its own pins, whichever of them was solved first.
TEST(ClothOnCloth, APinThatIsStoppedLagsAsFarAsIsSaid) {
    for (const float speed : {1.0f, 5.0f, 50.0f})
        for (const bool moved_first : {false, true}) {
            World world = World::create(still_air(1, {})).value();
            const float heights[] = {moved_first ? 0.2f : 0.0f, moved_first ? 0.0f : 0.2f};
            const std::array cloths{world.add_cloth(turned_sheet(heights[0]), with_contact()).value(),
                                    world.add_cloth(turned_sheet(heights[1], 0.4f), with_contact()).value()};
            for (const ClothId id : cloths) ASSERT_TRUE(world.pin(id, border_of(13)));
            const ClothId still = cloths[moved_first ? 1 : 0], moved = cloths[moved_first ? 0 : 1];
            float most = 0;
            for (int k = 0; k < 16; ++k) {
                std::vector<Vec3> targets;
                for (const std::uint32_t i : border_of(13)) {
                    const Vec4 x = world.cloth(moved)->positions[i];
                    targets.push_back({x.x, x.y - speed * h, x.z});
                }
                ASSERT_TRUE(world.move_pins(moved, border_of(13), targets));
                const StepReport& report = world.step(h);
                float lag = 0;
                for (std::size_t p = 0; p < targets.size(); ++p)
                    lag = std::max(
                        lag, (xyz(world.cloth(moved)->positions[border_of(13)[p]]) - to_vector(targets[p]))
                                 .norm());
                EXPECT_FLOAT_EQ(world.cloth_report(moved)->pin_lag, lag) << speed << ", step " << k;
                EXPECT_EQ(has(world.cloth_report(moved)->flags, StepFlags::pins_stopped), lag > 0);
                EXPECT_EQ(report.pin_lag,
                          std::max(world.cloth_report(moved)->pin_lag, world.cloth_report(still)->pin_lag));
                most = std::max(most, lag);
            }
            EXPECT_GT(most, 0.1f * speed * h) << speed;
        }
}

TEST(ContactSettings, CanBeSwitchedAtAnyTimeAndCostNothingWhenOff) {
    World world = World::create(still_air()).value();
    const std::array cloths{world.add_cloth(turned_sheet(0), with_contact()).value(),
                            world.add_cloth(turned_sheet(0.03f, 0.3f), with_contact()).value()};
    const std::uint64_t bytes_with = world.cloth_info(cloths[0])->bytes;
    ClothSettings off = with_contact();
    off.self_collision.method = SelfCollisionMethod::off;
    ASSERT_TRUE(world.set_cloth_settings(cloths[0], off));
    EXPECT_LT(world.cloth_info(cloths[0])->bytes, bytes_with);
    const ClothId plain = world.add_cloth(turned_sheet(2), off).value();
    EXPECT_EQ(world.cloth_info(cloths[0])->bytes, world.cloth_info(plain)->bytes);
    for (int k = 0; k < 5; ++k) world.step(h);
    ASSERT_TRUE(world.set_cloth_settings(cloths[0], with_contact()));
    ClothSettings avoidance = with_contact();
    avoidance.self_collision.method = SelfCollisionMethod::avoidance;
    for (int k = 0; k < 5; ++k) world.step(h);
    ASSERT_TRUE(world.set_cloth_settings(cloths[1], avoidance));
    for (int k = 0; k < 5; ++k) world.step(h);
    ASSERT_TRUE(world.remove_cloth(cloths[0]));
    for (int k = 0; k < 5; ++k) world.step(h);
    EXPECT_FALSE(has(world.report().flags, StepFlags::state_restored));
}

}  // namespace
}  // namespace weft::test::feature_contact
