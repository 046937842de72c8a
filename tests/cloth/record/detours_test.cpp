// Save and restore, and a recording's replay, between any two calls: what follows has the bytes that it has
// without them. What a call leaves in caches and a save does not hold would show.

#include <algorithm>
#include <array>
#include <functional>

#include "tests/cloth/record/recordings.h"

namespace weft::test {
namespace {

/// A grid, or the same triangles as a mesh like any other.
Mesh cloth_mesh(bool is_grid, float height) {
    Mesh mesh = make_sheet({.rows = 5,
                            .columns = 6,
                            .origin = {-0.25f, height, -0.2f},
                            .u = {0.5f, 0, 0},
                            .v = {0.03f, 0.02f, 0.4f}})
                    .value();
    if (!is_grid) mesh.rows = mesh.columns = 0;
    return mesh;
}

/// Cloths in contact, in a frame, on a skin and on a body, over colliders of several kinds, in gusts.
struct Scene {
    explicit Scene(bool is_grid) : grid(is_grid), world(World::create(settings()).value()) {}

    static WorldSettings settings() {
        WorldSettings settings;
        settings.threads = 1;
        settings.wind = {.velocity = {1, 0, 2}, .gust = 0.4f};
        return settings;
    }
    void build() {
        ClothSettings meets;
        meets.self_collision = {.method = SelfCollisionMethod::contact};
        ClothSettings worn;
        worn.frame_inertia = {.linear = 0.4f, .angular = 0.7f};
        ClothSettings calm;
        calm.sleep_speed = 0.3f;
        cloths = {world.add_cloth(cloth_mesh(grid, 0.5f), meets).value(),
                  world.add_cloth(cloth_mesh(grid, 0.52f), meets).value(),
                  world.add_cloth(cloth_mesh(grid, 2), worn).value(),
                  world.add_cloth(cloth_mesh(grid, 4), calm).value()};
        coarse = world
                     .add_cloth(make_sheet({.rows = 3,
                                            .columns = 3,
                                            .origin = {-0.25f, 2, -0.2f},
                                            .u = {0.5f, 0, 0},
                                            .v = {0.03f, 0.02f, 0.4f}})
                                    .value(),
                                worn)
                     .value();
        EXPECT_TRUE(world.set_frame(coarse, {}));
        EXPECT_TRUE(world.add_level(cloths[2], coarse));
        EXPECT_TRUE(world.pin(cloths[0], std::vector<std::uint32_t>{0, 5}));
        EXPECT_TRUE(world.pin(cloths[2], std::vector<std::uint32_t>{0, 5}));
        EXPECT_TRUE(world.set_map(cloths[2], Map::leash, std::vector<float>(30, 0.2f)));
        EXPECT_TRUE(world.set_frame(cloths[2], {}));
        const std::array<Vec3, 4> corners{{{0, 0, 0}, {0.2f, 0, 0}, {0, 0.2f, 0}, {0, 0, 0.2f}}};
        const std::array<std::array<std::uint32_t, 3>, 4> sides{{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
        shapes = {world.add_shape(TriangleMesh{corners, sides}).value()};
        colliders = {world.add_collider({.shape = Sphere{{0, 0.35f, 0}, 0.12f}}).value(),
                     world.add_collider({.shape = PlacedShape{shapes[0], {-0.2f, 0.35f, 0}, {}}}).value(),
                     world.add_collider({.shape = Box{{0, 3.85f, 0}, {}, {0.3f, 0.1f, 0.3f}}}).value(),
                     world.add_collider({.shape = Sphere{{0.3f, 1.9f, 0}, 0.05f}}).value()};
        bodies = {world.add_body({.mass = 0.05f}, {.position = {0.3f, 1.9f, 0}}).value()};
        EXPECT_TRUE(world.attach_collider(bodies[0], colliders[3]));
        EXPECT_TRUE(world.attach(bodies[0], cloths[2], std::vector<std::uint32_t>{17}));
    }
    void step(int count) {
        for (int k = 0; k < count; ++k)
            hashes.push_back((world.step(k % 2 == 0 ? h : 0.9f * h), world.state_hash()));
    }
    void save_and_restore() {
        Bytes saved(world.save_size());
        EXPECT_TRUE(world.save(saved));
        const auto restored = world.restore(saved);
        EXPECT_TRUE(restored) << restored.error().message;
    }

    bool grid;
    World world;
    std::vector<ClothId> cloths;
    ClothId coarse;  ///< another level of the third
    std::vector<ShapeId> shapes;
    std::vector<ColliderId> colliders;
    std::vector<BodyId> bodies;
    std::vector<std::uint64_t> hashes;
};

struct NamedCall {
    const char* name;
    std::function<void(Scene&)> make;
};

/// Calls whose objects an earlier one has removed are refused, with and without the detour.
std::vector<NamedCall> calls() {
    const std::vector<std::uint32_t> corner{5}, two{0, 5};
    return {
        {"set_settings",
         [](Scene& s) {
             auto w = s.world.settings();
             w.gravity.y = -5;
             w.wind.velocity.x = -2;
             (void)s.world.set_settings(w);
         }},
        {"set_settings substeps",
         [](Scene& s) {
             auto w = s.world.settings();
             w.substeps = 3;
             (void)s.world.set_settings(w);
         }},
        {"set_settings no wind",
         [](Scene& s) {
             auto w = s.world.settings();
             w.wind = {};
             (void)s.world.set_settings(w);
         }},
        {"add_cloth",
         [](Scene& s) { s.cloths.push_back(s.world.add_cloth(cloth_mesh(s.grid, 0.6f)).value()); }},
        {"remove_cloth", [](Scene& s) { (void)s.world.remove_cloth(s.cloths[1]); }},
        {"set_cloth_settings",
         [](Scene& s) {
             if (auto c = s.world.cloth_settings(s.cloths[0])) {
                 c->fabric.warp *= 3;
                 c->fabric.areal_density *= 2;
                 (void)s.world.set_cloth_settings(s.cloths[0], *c);
             }
         }},
        {"set_cloth_settings method",
         [](Scene& s) {
             if (auto c = s.world.cloth_settings(s.cloths[3])) {
                 c->method = Xpbd{};
                 (void)s.world.set_cloth_settings(s.cloths[3], *c);
             }
         }},
        {"set_cloth_settings alone",
         [](Scene& s) {
             if (auto c = s.world.cloth_settings(s.cloths[0])) {
                 c->self_collision.method = SelfCollisionMethod::off;
                 (void)s.world.set_cloth_settings(s.cloths[0], *c);
             }
         }},
        {"set_enabled off", [](Scene& s) { (void)s.world.set_enabled(s.cloths[2], false); }},
        {"set_enabled on", [](Scene& s) { (void)s.world.set_enabled(s.cloths[2], true); }},
        {"set_enabled off and on",
         [](Scene& s) {
             (void)s.world.set_enabled(s.cloths[0], false);
             (void)s.world.set_enabled(s.cloths[0], true);
         }},
        {"wake", [](Scene& s) { (void)s.world.wake(s.cloths[3]); }},
        {"set_importance", [](Scene& s) { (void)s.world.set_importance(s.cloths[0], 2); }},
        {"pin",
         [](Scene& s) {
             (void)s.world.pin(s.cloths[1], std::vector<std::uint32_t>{3, 9});
         }},
        {"pin a sleeper", [](Scene& s) { (void)s.world.pin(s.cloths[3], 7); }},
        {"unpin", [=](Scene& s) { (void)s.world.unpin(s.cloths[0], corner); }},
        {"move_pins",
         [=](Scene& s) {
             (void)s.world.move_pins(s.cloths[0], two,
                                     std::vector<Vec3>{{-0.25f, 0.55f, -0.2f}, {0.2f, 0.6f, -0.25f}});
         }},
        {"move_cloth",
         [](Scene& s) {
             (void)s.world.move_cloth(s.cloths[1], {{0.1f, 0.2f, 0.3f}, {0, 0.6f, 0, 0.8f}});
         }},
        {"reset_cloth",
         [](Scene& s) { (void)s.world.reset_cloth(s.cloths[1], cloth_mesh(s.grid, 1.4f).positions); }},
        {"resume_cloth",
         [](Scene& s) {
             const auto pose = cloth_mesh(s.grid, 1.4f).positions;
             (void)s.world.resume_cloth(s.cloths[1], pose, pose, pose);
         }},
        {"set_level", [](Scene& s) { (void)s.world.set_level(s.cloths[2], 1); }},
        {"set_level back", [](Scene& s) { (void)s.world.set_level(s.cloths[2], 0); }},
        {"set_frame",
         [](Scene& s) {
             (void)s.world.set_frame(s.cloths[2], {{0.1f, 0, 0.05f}, {0, 0.1f, 0, 0.995f}});
         }},
        {"leave_frame", [](Scene& s) { (void)s.world.leave_frame(s.cloths[2]); }},
        {"set_map leash",
         [](Scene& s) { (void)s.world.set_map(s.cloths[2], Map::leash, std::vector<float>(30, 0.05f)); }},
        {"set_map mass",
         [](Scene& s) { (void)s.world.set_map(s.cloths[1], Map::mass, std::vector<float>(30, 1.7f)); }},
        {"set_map friction",
         [](Scene& s) { (void)s.world.set_map(s.cloths[0], Map::friction, std::vector<float>(30, 0.5f)); }},
        {"set_skin",
         [](Scene& s) { (void)s.world.set_skin(s.cloths[2], cloth_mesh(s.grid, 2.1f).positions, {}); }},
        {"set_skin far off",
         [](Scene& s) { (void)s.world.set_skin(s.cloths[2], cloth_mesh(s.grid, 4.1f).positions, {}); }},
        {"shift_origin",
         [](Scene& s) {
             (void)s.world.shift_origin({0.3f, 1.7f, -2.1f});
         }},
        {"deform_shape",
         [](Scene& s) {
             (void)s.world.deform_shape(
                 s.shapes[0], std::vector<Vec3>{{0, 0, 0}, {0.25f, 0, 0}, {0, 0.22f, 0}, {0, 0, 0.2f}});
         }},
        {"remove_shape", [](Scene& s) { (void)s.world.remove_shape(s.shapes[0]); }},
        {"add_collider",
         [](Scene& s) {
             (void)s.world.add_collider({.shape = Capsule{{-0.3f, 0.4f, 0}, {0.3f, 0.4f, 0}, 0.05f}});
         }},
        {"move_collider",
         [](Scene& s) {
             (void)s.world.move_collider(s.colliders[0], {.shape = Sphere{{0, 0.4f, 0.02f}, 0.12f}});
         }},
        {"move_collider below a sleeper",
         [](Scene& s) {
             (void)s.world.move_collider(s.colliders[2],
                                         {.shape = Box{{0, 3.84f, 0}, {}, {0.3f, 0.1f, 0.3f}}});
         }},
        {"place_collider",
         [](Scene& s) {
             (void)s.world.place_collider(s.colliders[0], {.shape = Sphere{{0.1f, 0.4f, 0}, 0.12f}});
         }},
        {"remove_collider", [](Scene& s) { (void)s.world.remove_collider(s.colliders[1]); }},
        {"add_body",
         [](Scene& s) {
             s.bodies.push_back(s.world.add_body({.mass = 0.1f}, {.position = {0, 1, 0}}).value());
         }},
        {"remove_body", [](Scene& s) { (void)s.world.remove_body(s.bodies[0]); }},
        {"set_body_settings", [](Scene& s) { (void)s.world.set_body_settings(s.bodies[0], {.mass = 0.3f}); }},
        {"set_body_state",
         [](Scene& s) {
             (void)s.world.set_body_state(s.bodies[0],
                                          {.position = {0.3f, 1.95f, 0}, .velocity = {0.2f, 0, 0}});
         }},
        {"attach_collider", [](Scene& s) { (void)s.world.attach_collider(s.bodies[0], s.colliders[0]); }},
        {"detach_collider", [](Scene& s) { (void)s.world.detach_collider(s.colliders[3]); }},
        {"attach",
         [](Scene& s) {
             (void)s.world.attach(s.bodies[0], s.cloths[1], std::vector<std::uint32_t>{2, 8});
         }},
        {"detach", [](Scene& s) { (void)s.world.detach(s.cloths[2], std::vector<std::uint32_t>{17}); }},
        {"recut_cloth",
         [](Scene& s) {
             const Mesh whole = cloth_mesh(s.grid, 0.5f);
             const MeshCut cut = cut_mesh(whole, std::vector<MeshEdge>{{12, 13}, {13, 14}, {14, 15}}).value();
             (void)s.world.recut_cloth(s.cloths[0], cut.mesh, cut.from);
         }},
        {"step", [](Scene& s) { s.step(1); }},
        {"begin_step and end_step",
         [](Scene& s) {
             EXPECT_TRUE(s.world.begin_step(h));
             EXPECT_TRUE(s.world.end_step());
         }},
    };
}

class Detours : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Of, Detours, testing::Values(true, false),
                         [](const auto& info) { return info.param ? "Sheets" : "Meshes"; });

std::vector<std::uint64_t> hashes_of(bool is_grid, const NamedCall& a, const NamedCall& b, bool detour,
                                     Bytes* recorded = nullptr) {
    Scene scene(is_grid);
    if (recorded != nullptr) {
        EXPECT_TRUE(scene.world.start_recording(sink_to(*recorded)));
    }
    scene.build();
    scene.step(2);
    a.make(scene);
    if (detour) scene.save_and_restore();
    b.make(scene);
    scene.step(2);
    if (recorded != nullptr) {
        EXPECT_TRUE(scene.world.stop_recording());
    }
    return scene.hashes;
}

TEST_P(Detours, BetweenAnyTwoCallsChangeNothing) {
    const std::vector<NamedCall> all = calls();
    const std::size_t first = GetParam() ? 0 : 1;  // of three pairs one is played on each kind of cloth
    for (std::size_t i = 0; i < all.size() && !HasFailure(); ++i) {
        for (std::size_t j = (i + first) % 3; j < all.size(); j += 3) {
            const NamedCall &a = all[i], &b = all[j];
            Bytes recorded;
            const bool is_replayed = j % 12 < 3;  // each call, in a quarter of its pairs
            const auto direct = hashes_of(GetParam(), a, b, false, is_replayed ? &recorded : nullptr);
            EXPECT_EQ(hashes_of(GetParam(), a, b, true), direct)
                << a.name << ", save and restore, " << b.name;
            if (!is_replayed) continue;
            const auto again = replay(recorded, {.threads = 1});
            ASSERT_TRUE(again) << again.error().message;
            EXPECT_FALSE(again->difference) << "replay of " << a.name << ", " << b.name;
            EXPECT_TRUE(again->is_whole);
        }
    }
}

// What goes on after a while, so that sleepers sleep, and the record of steps is of both lengths.
TEST_P(Detours, AfterAnyCallChangeNothingLater) {
    for (const NamedCall& a : calls()) {
        std::array<std::vector<std::uint64_t>, 2> hashes;
        for (const bool detour : {false, true}) {
            Scene scene(GetParam());
            scene.build();
            scene.step(40);
            a.make(scene);
            if (detour) scene.save_and_restore();
            scene.step(8);
            hashes[detour ? 1 : 0] = scene.hashes;
        }
        EXPECT_EQ(hashes[1], hashes[0]) << a.name;
    }
}

}  // namespace
}  // namespace weft::test
