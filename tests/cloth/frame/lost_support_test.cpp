// Sleeping cloth wakes in the step in which what held it leaves, however it leaves.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "weft/weft.h"

namespace weft::test::lost_support {
namespace {

constexpr float h = 1.0f / 60;
constexpr std::uint32_t sleeper_side = 13;

World make_world() {
    WorldSettings settings;
    settings.threads = 1;
    settings.wind.air_density = 0;
    return World::create(settings).value();
}

ClothSettings that_sleeps(bool contact = false) {
    ClothSettings settings;
    settings.air_damping = 4;
    settings.sleep_speed = 0.01f;
    if (contact) settings.self_collision = {.method = SelfCollisionMethod::contact};
    return settings;
}

ClothId add_sheet(World& world, float height, const ClothSettings& settings, float size = 0.3f) {
    const Mesh mesh = make_sheet({.rows = sleeper_side,
                                  .columns = sleeper_side,
                                  .origin = {-size / 2, height, -size / 2},
                                  .u = {size, 0, 0},
                                  .v = {0, 0, size}})
                          .value();
    return world.add_cloth(mesh, settings).value();
}

bool falls_asleep(World& world, ClothId cloth) {
    for (int i = 0; i < 1500 && !world.is_asleep(cloth).value(); ++i) world.step(h);
    return world.is_asleep(cloth).value();
}

float height_of(const World& world, ClothId cloth) {
    return world.cloth(cloth)->bounds.upper.y;
}

Box slab(float y, float angle = 0, Vec3 half = {0.4f, 0.1f, 0.4f}) {
    return {.center = {0, y, 0},
            .rotation = {0, 0, std::sin(angle / 2), std::cos(angle / 2)},
            .half_extents = half};
}

/// A closed box as a mesh.
TriangleMesh mesh_of_slab(std::vector<Vec3>& vertices, std::vector<Triangle>& triangles, float top) {
    vertices.clear();
    for (const float y : {-0.2f, top})
        for (const float z : {-0.4f, 0.4f})
            for (const float x : {-0.4f, 0.4f}) vertices.push_back({x, y, z});
    triangles = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                 {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
    return {.vertices = vertices, .triangles = triangles};
}

struct Way {
    std::string name;
    Collider from, to;
};

/// A collider that bears cloth at y = 0, and where it goes in one step.
std::vector<Way> ways() {
    const Capsule bar{{-0.3f, -0.1f, 0}, {0.3f, -0.1f, 0}, 0.1f};
    const auto at = [](auto shape) { return Collider{.shape = shape}; };
    std::vector<Way> all{
        {"box down, fast", at(slab(-0.1f)), at(slab(-0.15f))},
        {"box down, beyond the greatest speed", at(slab(-0.1f)), at(slab(-30))},
        {"box aside", at(slab(-0.1f)), at(Box{.center = {1, -0.1f, 0}, .half_extents = {0.4f, 0.1f, 0.4f}})},
        {"box turned upright", at(slab(-0.1f, 0, {0.1f, 0.1f, 0.4f})),
         at(slab(-0.4f, 1.5f, {0.1f, 0.1f, 0.4f}))},
        {"box made flat", at(slab(-0.1f)), at(slab(-0.1f, 0, {0.4f, 0.01f, 0.4f}))},
        {"box made narrow", at(slab(-0.1f)), at(slab(-0.1f, 0, {0.01f, 0.1f, 0.01f}))},
        {"plane down", at(Plane{}), at(Plane{.offset = -0.05f})},
        {"plane far down", at(Plane{}), at(Plane{.offset = -20})},
        {"plane tilted", at(Plane{}), at(Plane{.normal = {1, 0, 0}, .offset = -3})},
        {"ball made small", at(Sphere{{0, -0.2f, 0}, 0.2f}), at(Sphere{{0, -0.2f, 0}, 0.05f})},
        {"ball down", at(Sphere{{0, -0.2f, 0}, 0.2f}), at(Sphere{{0, -0.6f, 0}, 0.2f})},
        {"bar down", at(bar), at(Capsule{{-0.3f, -0.5f, 0}, {0.3f, -0.5f, 0}, 0.1f})},
        {"bar turned", at(bar), at(Capsule{{0, -0.9f, 0}, {0, -0.3f, 0}, 0.1f})},
        {"cone down", at(TaperedCapsule{{-0.3f, -0.1f, 0}, {0.3f, -0.1f, 0}, 0.1f, 0.09f}),
         at(TaperedCapsule{{-0.3f, -0.3f, 0}, {0.3f, -0.3f, 0}, 0.1f, 0.09f})},
    };
    const Collider ground{.shape = Plane{}};
    Collider changed = ground;
    changed.is_trigger = true;
    all.push_back({"a trigger from now on", ground, changed});
    changed = ground;
    changed.layers = 2;
    all.push_back({"on another layer", ground, changed});
    Collider thick = ground;
    thick.thickness = 0.02f;
    all.push_back({"thinner", thick, ground});
    changed.shape = Plane{.offset = -5};
    all.push_back({"on another layer and away", ground, changed});
    return all;
}

/// On colliders that bear no sheet for good it is pinned in the middle of two edges until it sleeps.
void expect_wakes(const Way& way, bool placed, int calls) {
    SCOPED_TRACE(way.name + (placed ? ", placed" : ", moved") + (calls > 1 ? " by two calls" : ""));
    World world = make_world();
    ClothSettings settings = that_sleeps();
    settings.collider_mask = 1;
    const ClothId cloth = add_sheet(world, way.from.thickness + settings.thickness, settings);
    const ColliderId collider = world.add_collider(way.from).value();
    ASSERT_TRUE(falls_asleep(world, cloth));
    const float before = height_of(world, cloth);
    if (calls > 1) {
        Collider away = way.from;
        std::visit([&](auto& shape) { shape = std::get<std::decay_t<decltype(shape)>>(way.to.shape); },
                   away.shape);
        ASSERT_TRUE(world.move_collider(collider, away));
    }
    ASSERT_TRUE(placed ? world.place_collider(collider, way.to) : world.move_collider(collider, way.to));
    world.step(h);
    EXPECT_FALSE(world.is_asleep(cloth).value());
    for (int i = 0; i < 40; ++i) world.step(h);
    const ClothView& view = *world.cloth(cloth);
    EXPECT_LT(view.bounds.lower.y, before - 0.01f);
}

TEST(LostSupport, WakesByColliderThatLeaves) {
    for (const Way& way : ways())
        for (const bool placed : {false, true}) expect_wakes(way, placed, 1);
}

TEST(LostSupport, WakesByColliderThatIsMovedByTwoCallsInOneStep) {
    for (const Way& way : ways()) expect_wakes(way, false, 2);
}

TEST(LostSupport, GoesAlongWithASlowPlatform) {
    for (const float speed : {0.002f, 0.1f, 1.0f}) {
        World world = make_world();
        const ClothId cloth = add_sheet(world, 0.005f, that_sleeps());
        const ColliderId box = world.add_collider({.shape = slab(-0.1f)}).value();
        ASSERT_TRUE(falls_asleep(world, cloth));
        float y = 0;
        for (int i = 0; i < 120; ++i) {
            y -= speed * h;
            ASSERT_TRUE(world.move_collider(box, {.shape = slab(y - 0.1f)}));
            world.step(h);
        }
        EXPECT_NEAR(height_of(world, cloth), y + 0.005f, 5e-3f) << speed;
        EXPECT_TRUE(falls_asleep(world, cloth));
    }
}

TEST(LostSupport, SleepsOnWhereNothingThatHoldsItLeaves) {
    World world = make_world();
    const ClothId cloth = add_sheet(world, 0.005f, that_sleeps());
    ASSERT_TRUE(world.add_collider({.shape = slab(-0.1f)}));
    const ColliderId other = world.add_collider({.shape = slab(-0.5f)}).value();
    ASSERT_TRUE(falls_asleep(world, cloth));
    ASSERT_TRUE(world.move_collider(other, {.shape = slab(-1)}));
    world.step(h);
    ASSERT_TRUE(world.place_collider(other, {.shape = slab(-3)}));
    world.step(h);
    ASSERT_TRUE(world.remove_collider(other));
    world.step(h);
    EXPECT_TRUE(world.is_asleep(cloth).value());
}

TEST(LostSupport, WakesByAShapeThatIsDeformed) {
    for (const float top : {-0.02f, -0.19f}) {
        World world = make_world();
        const ClothId cloth = add_sheet(world, 0.005f, that_sleeps());
        std::vector<Vec3> vertices;
        std::vector<Triangle> triangles;
        const ShapeId shape = world.add_shape(mesh_of_slab(vertices, triangles, 0)).value();
        ASSERT_TRUE(world.add_collider({.shape = PlacedShape{.shape = shape}}));
        ASSERT_TRUE(falls_asleep(world, cloth));
        mesh_of_slab(vertices, triangles, top);
        ASSERT_TRUE(world.deform_shape(shape, vertices));
        world.step(h);
        EXPECT_FALSE(world.is_asleep(cloth).value());
        for (int i = 0; i < 60; ++i) world.step(h);
        EXPECT_NEAR(height_of(world, cloth), top + 0.005f, 6e-3f);
    }
}

/// Whether cloth that has just come to rest, but does not sleep yet, stays awake when its support goes.
TEST(LostSupport, ClothThatIsAboutToSleepFalls) {
    World world = make_world();
    ClothSettings settings = that_sleeps();
    settings.sleep_speed = 0.5f;
    const ClothId cloth = add_sheet(world, 0.005f, settings);
    const ColliderId box = world.add_collider({.shape = slab(-0.1f)}).value();
    for (int i = 0; i < 29; ++i) world.step(h);
    ASSERT_FALSE(world.is_asleep(cloth).value());
    ASSERT_TRUE(world.remove_collider(box));
    for (int i = 0; i < 60; ++i) world.step(h);
    EXPECT_LT(height_of(world, cloth), -1);
}

struct Stack {
    Stack() : world(make_world()) {
        lower = add_sheet(world, 0.02f, that_sleeps(true));
        upper = add_sheet(world, 0.05f, that_sleeps(true), 0.28f);
        std::vector<std::uint32_t> border;
        for (std::uint32_t i = 0; i < sleeper_side * sleeper_side; ++i)
            if (i / sleeper_side == 0 || i / sleeper_side == sleeper_side - 1 || i % sleeper_side == 0 ||
                i % sleeper_side == sleeper_side - 1)
                border.push_back(i);
        EXPECT_TRUE(world.pin(lower, border));
        EXPECT_TRUE(falls_asleep(world, upper));
    }
    void expect_falls(const char* name) {
        world.step(h);
        EXPECT_FALSE(world.is_asleep(upper).value()) << name;
        for (int i = 0; i < 40; ++i) world.step(h);
        EXPECT_LT(height_of(world, upper), -0.1f) << name;
    }
    World world;
    ClothId lower, upper;
};

TEST(LostSupport, WakesByClothBelowThatLeaves) {
    const auto with = [](const char* name, const std::function<void(World&, ClothId)>& change) {
        Stack stack;
        change(stack.world, stack.lower);
        stack.expect_falls(name);
    };
    const auto set = [](const auto& edit) {
        return [edit](World& world, ClothId lower) {
            ClothSettings settings = world.cloth_settings(lower).value();
            edit(settings);
            ASSERT_TRUE(world.set_cloth_settings(lower, settings));
        };
    };
    with("removed", [](World& world, ClothId lower) { ASSERT_TRUE(world.remove_cloth(lower)); });
    with("switched off", [](World& world, ClothId lower) { ASSERT_TRUE(world.set_enabled(lower, false)); });
    with("teleported", [](World& world, ClothId lower) {
        ASSERT_TRUE(world.move_cloth(lower, {.translation = {3, 0, 0}}));
    });
    with("switched off by its settings", set([](ClothSettings& s) { s.enabled = false; }));
    with("on another layer", set([](ClothSettings& s) {
             s.self_collision.layers = 2;
             s.self_collision.mask = 2;
         }));
    with("without contact",
         set([](ClothSettings& s) { s.self_collision.method = SelfCollisionMethod::off; }));
}

TEST(LostSupport, WakesByItsOwnHoldsThatAreChanged) {
    const auto hung = [](const char* name, const std::function<void(World&, ClothId)>& change) {
        World world = make_world();
        const ClothId cloth = add_sheet(world, 0, that_sleeps());
        std::vector<std::uint32_t> corners{0, sleeper_side - 1, sleeper_side * (sleeper_side - 1),
                                           sleeper_side * sleeper_side - 1};
        EXPECT_TRUE(world.pin(cloth, corners));
        EXPECT_TRUE(falls_asleep(world, cloth));
        change(world, cloth);
        world.step(h);
        EXPECT_FALSE(world.is_asleep(cloth).value()) << name;
    };
    hung("pin released", [](World& world, ClothId cloth) { ASSERT_TRUE(world.unpin(cloth, 0)); });
    hung("pins by map", [](World& world, ClothId cloth) { ASSERT_TRUE(world.set_map(cloth, Map::pin, {})); });
    hung("gravity", [](World& world, ClothId) {
        WorldSettings settings = world.settings();
        settings.gravity = {1, -9, 0};
        ASSERT_TRUE(world.set_settings(settings));
    });
    hung("friction", [](World& world, ClothId cloth) {
        ClothSettings settings = world.cloth_settings(cloth).value();
        settings.friction = 0;
        ASSERT_TRUE(world.set_cloth_settings(cloth, settings));
    });
    hung("attached to a body", [](World& world, ClothId cloth) {
        const BodyId body = world.add_body({.mass = 1, .inertia = {1, 1, 1}}).value();
        ASSERT_TRUE(world.attach(body, cloth, std::vector<std::uint32_t>{5}));
    });
}

TEST(LostSupport, WakesByItsFirstSkinAndByALeashThatIsTakenAway) {
    World world = make_world();
    const ClothId cloth = add_sheet(world, 0.3f, that_sleeps());
    ASSERT_TRUE(world.pin(cloth, std::vector<std::uint32_t>{0, sleeper_side - 1}));
    ASSERT_TRUE(world.set_map(cloth, Map::leash, std::vector<float>(sleeper_side * sleeper_side, 0.05f)));
    ASSERT_TRUE(falls_asleep(world, cloth));
    std::vector<Vec3> places;
    for (std::uint32_t i = 0; i < sleeper_side * sleeper_side; ++i)
        places.push_back({-0.15f + 0.025f * static_cast<float>(i % sleeper_side), 0.3f,
                          -0.15f + 0.025f * static_cast<float>(i / sleeper_side)});
    ASSERT_TRUE(world.set_skin(cloth, places, {}));
    world.step(h);
    EXPECT_FALSE(world.is_asleep(cloth).value());
    for (int i = 0; i < 60; ++i) {
        ASSERT_TRUE(world.set_skin(cloth, places, {}));
        world.step(h);
    }
    EXPECT_GT(world.cloth(cloth)->bounds.lower.y, 0.24f);
    ASSERT_TRUE(falls_asleep(world, cloth));
    ASSERT_TRUE(world.set_map(cloth, Map::leash, {}));
    world.step(h);
    EXPECT_FALSE(world.is_asleep(cloth).value());
}

TEST(LostSupport, WakesByABodyThatLeaves) {
    const auto on_body = [](const char* name, const std::function<void(World&, BodyId, ColliderId)>& change) {
        World world = make_world();
        const ClothId cloth = add_sheet(world, 0.005f, that_sleeps());
        const BodyId body = world.add_body({.mass = 0}).value();
        const ColliderId box = world.add_collider({.shape = slab(-0.1f)}).value();
        EXPECT_TRUE(world.attach_collider(body, box));
        for (int i = 0; i < 120; ++i) world.step(h);
        change(world, body, box);
        for (int i = 0; i < 60; ++i) world.step(h);
        EXPECT_LT(height_of(world, cloth), -0.3f) << name;
    };
    on_body("set elsewhere", [](World& world, BodyId body, ColliderId) {
        ASSERT_TRUE(world.set_body_state(body, {.position = {5, 0, 0}}));
    });
    on_body("set going", [](World& world, BodyId body, ColliderId) {
        ASSERT_TRUE(world.set_body_state(body, {.velocity = {0, -20, 0}}));
    });
    on_body("its collider removed",
            [](World& world, BodyId, ColliderId box) { ASSERT_TRUE(world.remove_collider(box)); });
    on_body("removed, and its collider moved", [](World& world, BodyId body, ColliderId box) {
        ASSERT_TRUE(world.remove_body(body));
        for (int i = 0; i < 60; ++i) world.step(h);
        ASSERT_TRUE(world.move_collider(box, {.shape = slab(-9)}));
    });
}

}  // namespace
}  // namespace weft::test::lost_support
