#pragma once
// A World that has seen every call, recorded; and what tests do to recordings.

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "cloth/record/record_format.h"
#include "weft/weft.h"

namespace weft::test {

using Bytes = std::vector<std::byte>;
inline constexpr float h = 1.0f / 60;

inline RecordingSink sink_to(Bytes& bytes) {
    return {[](void* to, std::span<const std::byte> more) {
                static_cast<Bytes*>(to)->insert(static_cast<Bytes*>(to)->end(), more.begin(), more.end());
                return true;
            },
            &bytes};
}

/// Where each record begins, and what it is.
struct Record {
    std::size_t at;
    RecordHead head;
    [[nodiscard]] Call call() const { return static_cast<Call>(head.call); }
    [[nodiscard]] std::size_t given() const { return at + sizeof head; }
    [[nodiscard]] std::size_t end() const { return given() + head.bytes; }
};
inline std::vector<Record> records_of(const Bytes& bytes) {
    std::vector<Record> records;
    for (std::size_t at = sizeof(RecordingHead); at < bytes.size();) {
        Record record{at, {}};
        std::memcpy(&record.head, bytes.data() + at, sizeof record.head);
        records.push_back(record);
        at = record.end();
    }
    return records;
}
/// Makes the checksums of a record right again.
inline void seal(Bytes& bytes, const Record& record) {
    RecordHead head;
    std::memcpy(&head, bytes.data() + record.at, sizeof head);
    StateHash hasher;
    hasher.add(std::span<const std::byte>(bytes).subspan(record.given(), record.head.bytes));
    head.hash = hasher.value();
    head.own_hash = head.hash_of_head(hasher);
    std::memcpy(bytes.data() + record.at, &head, sizeof head);
}

inline Mesh small_sheet(float height, std::uint32_t side = 9) {
    return make_sheet({.rows = side,
                       .columns = side,
                       .origin = {-0.3f, height, -0.3f},
                       .u = {0.6f, 0, 0},
                       .v = {0, 0.02f, 0.6f}})
        .value();
}

/// Every call that changes a World, with steps between them.
struct EveryCall {
    explicit EveryCall(World& w) : world(w) {}

    void play() {
        WorldSettings settings;
        settings.threads = 1;
        settings.wind.velocity = {1, 0, 3};
        settings.wind.sources[1] = {AirSourceKind::jet, {0, 0.5f, -1}, {0, 0, 4}, 0.5f};
        settings.wind.shelters[2] = {.kind = AirShelterKind::ball, .position = {0, 2, 0}};
        settings.contact_reports = 32;
        settings.budget = 1e-4f;  // less than there is
        EXPECT_TRUE(world.set_settings(settings));
        add();
        step(3);
        wear();
        step(3);
        carry();
        step(3);
        change();
        step(3);
        go_back();
        step(3);
        remove();
        step(2);
    }

    void add() {
        ClothSettings meets;
        meets.self_collision = {.method = SelfCollisionMethod::contact};
        ClothSettings fibres;
        fibres.method = Fibres{.iterations = 2, .shear = Fibres::SetSolver::ldlt};
        ClothSettings limits;
        limits.method = Multilevel{.passes = 2};
        limits.key = 7;
        cloths = {world.add_cloth(small_sheet(0.5f), meets).value(),
                  world.add_cloth(small_sheet(0.55f), meets).value(),
                  world.add_cloth(small_sheet(1.5f), fibres).value(),
                  world.add_cloth(small_sheet(2.5f), limits).value()};
        const CookedCloth cooked = CookedCloth::create(small_sheet(3.5f), fibres).value();
        cloths.push_back(world.add_cloth(cooked, {.translation = {0, 0.1f, 0}}).value());
        for (const std::uint32_t side : {9u, 5u})
            cloths.push_back(world.add_cloth(small_sheet(5.5f, side)).value());
        EXPECT_TRUE(world.add_level(cloths[5], cloths[6]));
        EXPECT_TRUE(world.pin(cloths[0], std::vector<std::uint32_t>{0, 8}));
        EXPECT_TRUE(world.pin(cloths[2], 4));
        const std::array<Vec3, 4> corners{{{0, 0, 0}, {0.2f, 0, 0}, {0, 0.2f, 0}, {0, 0, 0.2f}}};
        const std::array<std::array<std::uint32_t, 3>, 4> sides{{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
        const std::array<float, 4> heights{0, 0.1f, 0, 0.1f};
        const TriangleMesh solid{corners, sides};
        shapes = {world.add_shape(solid).value(), world.add_shape(ConvexHull{corners}).value(),
                  world.add_shape(HeightField{2, 2, 1, heights}).value(),
                  world.add_shape(DistanceField{solid, 0.02f}).value()};
        for (const ShapeId shape : shapes)
            colliders.push_back(
                world.add_collider({.shape = PlacedShape{shape, {-0.1f, 0.2f, -0.1f}, {}}}).value());
        for (const Collider& collider :
             {Collider{.shape = Sphere{{0, 0.2f, 0}, 0.15f}}, Collider{.shape = Plane{}, .friction = 0.6f},
              Collider{.shape = Capsule{{0, 1, 0}, {0.1f, 1, 0}, 0.1f}},
              Collider{.shape = TaperedCapsule{{0, 1.1f, 0}, {0.1f, 1, 0}, 0.1f, 0.05f}},
              Collider{.shape = Box{{0.3f, 1, 0}, {}, {0.1f, 0.1f, 0.1f}}, .is_trigger = true}})
            colliders.push_back(world.add_collider(collider).value());
    }
    void wear() {
        const Mesh mesh = small_sheet(2.5f);
        EXPECT_TRUE(world.set_map(cloths[3], Map::leash, std::vector<float>(mesh.positions.size(), 0.2f)));
        EXPECT_TRUE(
            world.set_map(cloths[3], Map::collider_mask, std::vector<float>(mesh.positions.size(), 3)));
        EXPECT_TRUE(world.set_map(cloths[3], Map::mass, std::vector<float>(mesh.positions.size(), 1.5f)));
        EXPECT_TRUE(world.set_skin(cloths[3], mesh.positions, {}));
        EXPECT_TRUE(world.set_frame(cloths[3], {}));
        EXPECT_TRUE(world.set_frame(cloths[3], {.translation = {0.05f, 0, 0}}));
        EXPECT_TRUE(world.move_cloth(cloths[2], {.translation = {0, 0.1f, 0}}));
        EXPECT_TRUE(world.reset_cloth(cloths[1], small_sheet(0.6f).positions));
        EXPECT_TRUE(world.resume_cloth(cloths[1], small_sheet(0.6f).positions, small_sheet(0.61f).positions,
                                       small_sheet(0.1f).positions));
        EXPECT_TRUE(world.move_pins(cloths[0], std::vector<std::uint32_t>{0, 8},
                                    std::vector<Vec3>{{-0.3f, 0.45f, -0.3f}, {0.3f, 0.45f, -0.3f}}));
        const std::array<Vec3, 4> deformed{{{0, 0, 0}, {0.25f, 0, 0}, {0, 0.2f, 0}, {0, 0, 0.2f}}};
        EXPECT_TRUE(world.deform_shape(shapes[0], deformed));
        EXPECT_TRUE(world.move_collider(colliders[4], {.shape = Sphere{{0.1f, 0.2f, 0}, 0.15f}}));
    }
    void carry() {
        body = world.add_body({.mass = 0.1f}, {.position = {0, 1, 0}}).value();
        EXPECT_TRUE(world.attach_collider(body, colliders[6]));
        EXPECT_TRUE(world.attach(body, cloths[2], std::vector<std::uint32_t>{40, 41}));
        EXPECT_TRUE(world.set_body_settings(body, {.mass = 0.2f}));
        EXPECT_TRUE(world.set_body_state(body, {.position = {0, 1.02f, 0}, .velocity = {0.1f, 0, 0}}));
    }
    void change() {
        ClothSettings stiff = world.cloth_settings(cloths[1]).value();
        stiff.fabric.warp *= 2;
        EXPECT_TRUE(world.set_cloth_settings(cloths[1], stiff));
        EXPECT_TRUE(world.set_enabled(cloths[3], false));
        EXPECT_TRUE(world.wake(cloths[1]));
        EXPECT_TRUE(world.set_importance(cloths[1], 2));
        EXPECT_TRUE(world.set_level(cloths[5], 1));
        EXPECT_TRUE(world.unpin(cloths[0], 8));
        const std::vector<std::uint32_t> corners{72, 80};
        seam = world.stitch(cloths[0], corners, cloths[1], corners, {.rest_length = 0.05f}).value();
        cut();
        EXPECT_TRUE(world.shift_origin({1, 0, 2}));
        EXPECT_TRUE(world.place_collider(
            colliders[7], {.shape = TaperedCapsule{{-1, 1, -2}, {-0.9f, 1, -2}, 0.1f, 0.05f}}));
    }
    void cut() {
        const Mesh whole = small_sheet(0.5f);
        std::vector<MeshEdge> across;
        for (std::uint32_t k = 0; k + 1 < whole.columns; ++k)
            across.push_back({2 * whole.columns + k, 2 * whole.columns + k + 1});
        const MeshCut parted = cut_mesh(whole, across).value();
        EXPECT_TRUE(world.recut_cloth(cloths[0], parted.mesh, parted.from));
    }
    void go_back() {
        Bytes saved(world.save_size());
        EXPECT_TRUE(world.save(saved));
        step(2);
        EXPECT_TRUE(world.restore(saved));
        Bytes of_cloth(world.cloth_save_size(cloths[1]));
        EXPECT_TRUE(world.save_cloth(cloths[1], of_cloth));
        step(1);
        EXPECT_TRUE(world.restore_cloth(cloths[1], of_cloth));
        step(1);
        EXPECT_EQ(world.restore_cloths(saved).value(), 1u);
    }
    void remove() {
        EXPECT_TRUE(world.unstitch(seam));
        EXPECT_TRUE(world.detach(cloths[2], std::vector<std::uint32_t>{40}));
        EXPECT_TRUE(world.detach_collider(colliders[6]));
        EXPECT_TRUE(world.remove_body(body));
        EXPECT_TRUE(world.leave_frame(cloths[3]));
        EXPECT_TRUE(world.remove_collider(colliders[1]));
        EXPECT_TRUE(world.remove_shape(shapes[1]));
        EXPECT_TRUE(world.remove_cloth(cloths[0]));
        // The place of what was removed, under another id.
        cloths[0] = world.add_cloth(small_sheet(0.4f, 5)).value();
        EXPECT_TRUE(world.pin(cloths[0], 3));
    }
    void step(int count) {
        for (int k = 0; k < count; ++k)
            EXPECT_FALSE(has(world.step(1.0f / 60).flags, StepFlags::state_restored));
    }

    World& world;
    std::vector<ClothId> cloths;
    std::vector<ShapeId> shapes;
    std::vector<ColliderId> colliders;
    BodyId body;
    SeamId seam;
};

/// All of it, as it was recorded.
inline Bytes every_call_recorded() {
    Bytes bytes;
    World world = World::create().value();
    EXPECT_TRUE(world.start_recording(sink_to(bytes)));
    EveryCall(world).play();
    EXPECT_TRUE(world.stop_recording());
    return bytes;
}

}  // namespace weft::test
