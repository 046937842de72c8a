// What a collider is besides its shape: its thickness, how cloth bounces off it, which cloths meet it, and
// whether it only tells of them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "engine/vector.h"
#include "tests/cloth/fixtures.h"
#include "weft/weft.h"

namespace weft::test {
namespace {

constexpr Vec3 pull{0, -9.81f, 0};

/// Level, its middle above the origin.
Mesh level_sheet(float height, std::uint32_t side = 9, float size = 0.4f) {
    return make_sheet({.rows = side,
                       .columns = side,
                       .origin = {-0.5f * size, height, -0.5f * size},
                       .u = {size, 0, 0},
                       .v = {0, 0, size}})
        .value();
}

float mean_height(const World& world, ClothId id) {
    const ClothView view = world.cloth(id).value();
    float sum = 0;
    for (const Vec4& p : view.positions) sum += p.y;
    return sum / static_cast<float>(view.positions.size());
}

float peak_speed(const World& world, ClothId id) {
    float peak = 0;
    const ClothView view = world.cloth(id).value();
    for (const Vec4& v : view.velocities) peak = std::max(peak, xyz(v).norm());
    return peak;
}

std::vector<Vec4> motion_of(const World& world, ClothId id) {
    const ClothView view = world.cloth(id).value();
    std::vector<Vec4> all(view.positions.begin(), view.positions.end());
    all.insert(all.end(), view.velocities.begin(), view.velocities.end());
    return all;
}

// Bouncing.

struct Bounce {
    float height = 0;  ///< of its first flight [m]
    float speed = 0;   ///< in the end [m/s]
};
/// A level sheet falls by half a metre.
Bounce drop(ClothSettings settings, const Collider& ground) {
    constexpr float fall = 0.5f, step = 1.0f / 240;
    settings.air_damping = 0;
    World world = World::create(vacuum(pull)).value();
    const ClothId id = world.add_cloth(level_sheet(settings.thickness + fall), settings).value();
    EXPECT_TRUE(world.add_collider(ground));
    Bounce bounce;
    bool has_hit = false, has_left = false;
    float before = 0;
    for (int k = 0; k < 1200; ++k) {
        world.step(step);
        const float now = mean_height(world, id) - settings.thickness;
        has_hit |= now < 0.03f;
        has_left |= has_hit && now > before;
        if (has_left && now < before) break;
        if (has_left) bounce.height = std::max(bounce.height, now);
        before = now;
    }
    for (int k = 0; k < 1200; ++k) world.step(step);
    bounce.speed = peak_speed(world, id);
    return bounce;
}

TEST(ColliderSurfaces, ClothBouncesByTheSquareOfTheRestitution) {
    const Collider plain{.shape = Plane{}}, elastic{.shape = Plane{}, .restitution = 0.6f};
    const std::vector<Method> methods{Multilevel{}, ConjugateGradient{}, Xpbd{}, SymplecticEuler{}};
    for (const Method& method : methods) {
        for (const TimeScheme scheme : {TimeScheme::of_method, TimeScheme::backward_euler}) {
            ClothSettings settings;
            settings.method = method;
            settings.time_scheme = scheme;
            if (std::holds_alternative<SymplecticEuler>(method)) settings.substeps = 16;
            const std::string of =
                std::to_string(method.index()) + (scheme == TimeScheme::of_method ? "" : " BE");
            const Bounce bounce = drop(settings, elastic);
            EXPECT_NEAR(bounce.height, 0.36f * 0.5f, 0.015f) << of;
            EXPECT_LT(bounce.speed, 2e-3f) << "it comes to rest: " << of;
            EXPECT_LT(drop(settings, plain).height, 1e-3f) << of;
        }
    }
}

TEST(ColliderSurfaces, TheGreaterRestitutionCounts) {
    ClothSettings bouncy;
    bouncy.restitution = 0.5f;
    EXPECT_NEAR(drop(bouncy, {.shape = Plane{}, .restitution = 0.2f}).height, 0.25f * 0.5f, 0.015f);
    EXPECT_NEAR(drop(bouncy, {.shape = Plane{}, .restitution = 0.7f}).height, 0.49f * 0.5f, 0.02f);
}

// Thickness.

TEST(ColliderSurfaces, ItsThicknessIsAddedToTheCloths) {
    for (const Method& method : {Method(Multilevel{}), Method(Xpbd{})}) {
        World world = World::create(vacuum(pull)).value();
        ClothSettings settings;
        settings.method = method;
        settings.thickness = 0.004f;
        const ClothId id = world.add_cloth(level_sheet(0.05f), settings).value();
        Collider ground{.shape = Plane{}, .thickness = 0.02f};
        const ColliderId plane = world.add_collider(ground).value();
        for (int k = 0; k < 60; ++k) world.step(h);
        EXPECT_NEAR(mean_height(world, id), 0.024f, 3e-4f) << method.index();

        ground.thickness = 0.04f;
        ASSERT_TRUE(world.move_collider(plane, ground));
        world.step(h);
        EXPECT_FLOAT_EQ(world.collider(plane)->thickness, 0.04f);
        for (int k = 0; k < 60; ++k) world.step(h);
        EXPECT_NEAR(mean_height(world, id), 0.044f, 5e-4f) << method.index();
    }
}

// Layers.

ClothSettings of_mask(std::uint32_t mask, bool with_contact = false) {
    ClothSettings settings;
    settings.collider_mask = mask;
    if (with_contact) settings.self_collision = {.method = SelfCollisionMethod::contact, .layers = 1};
    return settings;
}

TEST(ColliderSurfaces, ClothMeetsColliderOfItsMaskAndNoOther) {
    for (const ColliderResponse response : {ColliderResponse::contact, ColliderResponse::velocity_filter})
        for (const Method& method : {Method(Multilevel{}), Method(Xpbd{})}) {
            World world = World::create(vacuum(pull)).value();
            ClothSettings settings = of_mask(0b101);
            settings.method = method;
            settings.collider_response = response;
            const ClothId meets = world.add_cloth(level_sheet(0.05f), settings).value();
            settings.collider_mask = 0b010;
            const ClothId falls = world.add_cloth(level_sheet(0.06f), settings).value();
            ASSERT_TRUE(world.add_collider({.shape = Plane{}, .layers = 0b100}));
            for (int k = 0; k < 60; ++k) world.step(h);
            EXPECT_GT(mean_height(world, meets), -0.03f);
            EXPECT_LT(mean_height(world, falls), -1);
        }
}

// Two that hang together in one equation, of which each has ground of its own.
TEST(ColliderSurfaces, ClothsOfAGroupHaveTheirOwnMasks) {
    World world = World::create(vacuum(pull)).value();
    const ClothId lower = world.add_cloth(level_sheet(0.05f), of_mask(0b01, true)).value();
    const ClothId upper = world.add_cloth(level_sheet(0.2f), of_mask(0b10, true)).value();
    ASSERT_TRUE(world.add_collider({.shape = Plane{}, .layers = 0b01}));
    ASSERT_TRUE(world.add_collider({.shape = Plane{{0, 1, 0}, 0.15f}, .layers = 0b10}));
    for (int k = 0; k < 90; ++k) world.step(h);
    EXPECT_NEAR(mean_height(world, lower), 0.005f, 1e-3f)
        << "it does not meet the upper ground, far above it";
    EXPECT_NEAR(mean_height(world, upper), 0.155f, 1e-3f);
    ClothSettings changed = of_mask(0b01, true);
    ASSERT_TRUE(world.set_cloth_settings(upper, changed));
    for (int k = 0; k < 120; ++k) world.step(h);
    EXPECT_LT(mean_height(world, upper), 0.05f) << "it lies on the other now";
    EXPECT_GT(mean_height(world, upper), mean_height(world, lower));
}

TEST(ColliderSurfaces, MaskOfNothingTakesNoMemory) {
    World without = World::create(vacuum(pull)).value(), with = World::create(vacuum(pull)).value();
    ASSERT_TRUE(with.add_collider({.shape = Plane{}}));
    const std::uint64_t none = without.measure_cloth(level_sheet(1))->bytes;
    const std::uint64_t any = with.measure_cloth(level_sheet(1), of_mask(1))->bytes;
    const std::uint64_t masked = with.measure_cloth(level_sheet(1), of_mask(0))->bytes;
    EXPECT_GT(any, masked + 81 * 60);
    EXPECT_LE(masked, none + 96 * 16 + 128 * 17)
        << "where parts of a step begin, the order of triangles, and which are near";
}

// Triggers.

struct Watched {
    std::vector<Vec4> motion;
    std::vector<Contact> contacts;
};
/// A sheet falls onto a ball through whatever there is.
Watched fall_through(const std::vector<Collider>& others, const ClothSettings& settings = {},
                     int threads = 1) {
    WorldSettings of_world = vacuum(pull);
    of_world.contact_reports = 4096;
    of_world.threads = threads;
    World world = World::create(of_world).value();
    const ClothId id = world.add_cloth(level_sheet(0.3f, 33), settings).value();
    EXPECT_TRUE(world.add_collider({.shape = Sphere{{0, 0, 0}, 0.15f}}));
    for (const Collider& other : others) EXPECT_TRUE(world.add_collider(other));
    Watched watched;
    for (int k = 0; k < 24; ++k) {
        world.step(h);
        for (const Contact& c : world.contacts()) watched.contacts.push_back(c);
        const std::vector<Vec4> now = motion_of(world, id);
        watched.motion.insert(watched.motion.end(), now.begin(), now.end());
    }
    return watched;
}

bool is_of_trigger(const Contact& c) {
    return to_vector(c.impulse).isZero(0);
}

TEST(ColliderSurfaces, TriggerChangesNoByteAndTells) {
    const Collider trigger{.shape = Box{{0, 0.2f, 0}, {}, {0.05f, 0.04f, 0.05f}}, .is_trigger = true};
    for (const Method& method : {Method(Multilevel{}), Method(Xpbd{})}) {
        ClothSettings settings;
        settings.method = method;
        const Watched alone = fall_through({}, settings);
        const Watched with = fall_through({trigger, trigger}, settings);
        EXPECT_TRUE(same_bytes(alone.motion, with.motion)) << method.index();
        EXPECT_EQ(std::ranges::count_if(alone.contacts, is_of_trigger), 0);
        const auto told = std::ranges::count_if(with.contacts, is_of_trigger);
        EXPECT_GT(told, 6) << "in two boxes, step for step";
        EXPECT_EQ(told % 2, 0);
        EXPECT_EQ(with.contacts.size() - static_cast<std::size_t>(told), alone.contacts.size());
    }
}

TEST(ColliderSurfaces, TriggerTellsOfTheDeepestParticle) {
    constexpr float top = 0.24f;
    const Collider trigger{.shape = Box{{0, 0.2f, 0}, {}, {0.05f, top - 0.2f, 0.05f}}, .is_trigger = true};
    WorldSettings of_world = vacuum(pull);
    of_world.contact_reports = 16;
    World world = World::create(of_world).value();
    const ClothId id = world.add_cloth(level_sheet(0.3f, 33)).value();
    const ColliderId box = world.add_collider(trigger).value();
    bool was_in = false;
    for (int k = 0; k < 12; ++k) {
        world.step(h);
        const float height = mean_height(world, id);
        const bool is_in = height < top + 0.005f && height > 0.16f - 0.005f;
        ASSERT_EQ(world.contacts().size(), is_in ? 1u : 0u) << height;
        was_in |= is_in;
        if (!is_in) continue;
        const Contact c = world.contacts()[0];
        EXPECT_EQ(c.cloth, id);
        EXPECT_EQ(c.collider, box);
        const Vec4 p = world.cloth(id)->positions[c.particle];
        EXPECT_LT(std::max(std::abs(p.x), std::abs(p.z)), 0.055f) << "it is one that is inside";
        EXPECT_NEAR(to_vector(c.normal).norm(), 1, 1e-5f);
    }
    EXPECT_TRUE(was_in);
}

// 3 mm over a trigger: in it by the cloth's thickness, 5 mm, and not by a fifth of that.
TEST(ColliderSurfaces, TriggerGoesByTheMapOfThickness) {
    for (const bool is_thin : {false, true}) {
        WorldSettings of_world = vacuum();
        of_world.contact_reports = 16;
        World world = World::create(of_world).value();
        const ClothId id = world.add_cloth(level_sheet(0.203f, 5)).value();
        ASSERT_TRUE(world.set_map(id, Map::thickness, std::vector<float>(25, is_thin ? 0.2f : 1.0f)));
        ASSERT_TRUE(world.add_collider({.shape = Plane{{0, 1, 0}, 0.2f}, .is_trigger = true}));
        world.step(h);
        EXPECT_EQ(world.contacts().size(), is_thin ? 0u : 1u);
    }
}

TEST(ColliderSurfaces, ATriggerThatIsSwitchedHoldsCloth) {
    World world = World::create(vacuum(pull)).value();
    const ClothId id = world.add_cloth(level_sheet(0.3f)).value();
    Collider ground{.shape = Plane{}, .is_trigger = true};
    const ColliderId plane = world.add_collider(ground).value();
    world.step(h);
    ground.is_trigger = false;
    ASSERT_TRUE(world.move_collider(plane, ground));
    for (int k = 0; k < 60; ++k) world.step(h);
    EXPECT_NEAR(mean_height(world, id), 0.005f, 5e-4f);
    ground.is_trigger = true;
    ASSERT_TRUE(world.place_collider(plane, ground));
    for (int k = 0; k < 60; ++k) world.step(h);
    EXPECT_LT(mean_height(world, id), -1);
}

TEST(ColliderSurfaces, TriggersThatAMaskLeavesOutAreNotTold) {
    const Collider trigger{.shape = Plane{{0, 1, 0}, 1}, .layers = 2, .is_trigger = true};
    ClothSettings settings;
    settings.collider_mask = 1;
    const Watched watched = fall_through({trigger}, settings);
    EXPECT_EQ(std::ranges::count_if(watched.contacts, is_of_trigger), 0);
    EXPECT_GT(watched.contacts.size(), 0u) << "of the ball";
}

TEST(ColliderSurfaces, TriggersAreToldAlikeByAnyThreads) {
    const Collider trigger{.shape = Sphere{{0.1f, 0.2f, 0.05f}, 0.2f}, .is_trigger = true};
    const Watched one = fall_through({trigger}), two = fall_through({trigger}, {}, 2);
    ASSERT_EQ(one.contacts.size(), two.contacts.size());
    for (std::size_t k = 0; k < one.contacts.size(); ++k)
        ASSERT_EQ(one.contacts[k].particle, two.contacts[k].particle) << k;
}

// What comes in, and what is kept.

TEST(ColliderSurfaces, ErrorsNameTheValue) {
    World world = World::create().value();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto refused = [&](const Collider& collider, const std::string& name) {
        const auto added = world.add_collider(collider);
        ASSERT_FALSE(added);
        EXPECT_NE(added.error().message.find(name), std::string::npos) << added.error().message;
    };
    for (const float bad : {-0.1f, 10.1f, nan}) refused({.thickness = bad}, "Collider::thickness");
    for (const float bad : {-0.1f, 1.01f, nan}) refused({.restitution = bad}, "Collider::restitution");
    ClothSettings settings;
    settings.restitution = 1.5f;
    const auto added = world.add_cloth(level_sheet(1), settings);
    ASSERT_FALSE(added);
    EXPECT_NE(added.error().message.find("ClothSettings::restitution is 1.5"), std::string::npos);
}

TEST(ColliderSurfaces, AreSavedAndHashed) {
    World world = World::create(vacuum(pull)).value();
    const ClothId id = world.add_cloth(level_sheet(0.05f)).value();
    const Collider first{.shape = Plane{}, .thickness = 0.01f, .restitution = 0.5f, .layers = 6};
    const ColliderId plane = world.add_collider(first).value();
    const std::uint64_t hash = world.state_hash();
    std::vector<std::byte> saved(world.save_size());
    ASSERT_TRUE(world.save(saved));
    const std::vector<std::function<void(Collider&)>> changes{
        [](Collider& c) { c.thickness = 0.02f; }, [](Collider& c) { c.restitution = 0.1f; },
        [](Collider& c) { c.layers = 1; }, [](Collider& c) { c.is_trigger = true; }};
    for (const auto& change : changes) {
        Collider other = first;
        change(other);
        ASSERT_TRUE(world.place_collider(plane, other));
        EXPECT_NE(world.state_hash(), hash);
        for (int k = 0; k < 30; ++k) world.step(h);
        ASSERT_TRUE(world.restore(saved));
        EXPECT_EQ(world.state_hash(), hash);
        const Collider now = world.collider(plane).value();
        EXPECT_EQ(now.thickness, first.thickness);
        EXPECT_EQ(now.restitution, first.restitution);
        EXPECT_EQ(now.layers, first.layers);
        EXPECT_EQ(now.is_trigger, first.is_trigger);
    }
    for (int k = 0; k < 60; ++k) world.step(h);
    EXPECT_NEAR(mean_height(world, id), 0.015f, 1e-3f);
}

}  // namespace
}  // namespace weft::test
