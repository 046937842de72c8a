// Saves that somebody has changed, checksum and all: each is refused, or the World goes on from it, and is
// none the worse once it gets its own back.

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "cloth/store/save_format.h"
#include "engine/state_hash.h"
#include "tests/collision/colliders/solids.h"
#include "weft/weft.h"

namespace weft::test {
namespace {

constexpr float frame_time = 1.0f / 60;
using Bytes = std::vector<std::byte>;

Bytes bytes_of(const World& world) {
    Bytes bytes(world.save_size());
    EXPECT_TRUE(world.save(bytes));
    return bytes;
}

/// With the checksum and the length that it has now.
Bytes sealed(Bytes bytes) {
    SaveHead head;
    std::memcpy(&head, bytes.data(), sizeof head);
    StateHash hash;
    hash.add(std::span<const std::byte>(bytes).subspan(sizeof head));
    head.hash = hash.value();
    head.bytes = bytes.size();
    std::memcpy(bytes.data(), &head, sizeof head);
    return bytes;
}
template <class T>
Bytes changed_in(Bytes bytes, std::size_t at, const T& value) {
    std::memcpy(bytes.data() + at, &value, sizeof value);
    return sealed(std::move(bytes));
}

bool has_finite_state(const World& world, ClothId id) {
    const ClothView& view = *world.cloth(id);
    for (const auto& rows : {view.positions, view.previous_positions, view.velocities, view.normals})
        for (const Vec4& row : rows)
            if (!std::isfinite(row.x + row.y + row.z)) return false;
    return true;
}

/// Of all that a save can have: pins, a frame, a skin, bodies, a shape that was deformed, contact, a budget.
struct FullWorld {
    FullWorld() : world(World::create({.threads = 1, .budget = 1000}).value()) {
        ClothSettings worn, contact;
        worn.tethers.enabled = true;
        worn.sleep_speed = 0.01f;
        worn.frame_inertia = {0.5f, 0.5f, 0.5f};
        contact.self_collision = {.method = SelfCollisionMethod::contact};
        const Mesh mesh = make_sheet({.rows = 3, .columns = 4}).value();
        for (const ClothSettings& settings : {worn, contact, ClothSettings{}})
            cloths.push_back(world.add_cloth(mesh, settings).value());
        EXPECT_TRUE(world.pin(cloths[0], std::vector<std::uint32_t>{0, 3}));
        EXPECT_TRUE(world.set_frame(cloths[0], {}));
        for (const Map map : {Map::leash, Map::backstop})
            EXPECT_TRUE(world.set_map(cloths[0], map, std::vector<float>(12, 0.3f)));
        EXPECT_TRUE(world.set_skin(cloths[0], mesh.positions, std::vector<Vec3>(12, Vec3{0, 1, 0})));
        const BodyId body = world.add_body({}, {.position = {0, -0.4f, 0}}).value();
        const ColliderId box = world.add_collider({.shape = Box{{0, -0.4f, 0}}}).value();
        EXPECT_TRUE(world.attach_collider(body, box));
        EXPECT_TRUE(world.attach(body, cloths[2], std::vector<std::uint32_t>{5}));
        EXPECT_TRUE(world.add_collider({.shape = Sphere{{0, -0.2f, 0}, 0.15f}}));
        const Solid solid = box_mesh({0.1f, 0.1f, 0.1f});
        const ShapeId shape = world.add_shape(solid.mesh()).value();
        EXPECT_TRUE(world.add_collider({.shape = PlacedShape{.shape = shape, .position = {0.2f, -0.1f, 0}}}));
        std::vector<Vec3> larger = solid.vertices;
        for (Vec3& v : larger) v.y *= 1.2f;
        EXPECT_TRUE(world.deform_shape(shape, larger));
    }
    void step(int steps) {
        for (int k = 0; k < steps; ++k) world.step(frame_time);
    }
    World world;
    std::vector<ClothId> cloths;
};

TEST(ForgedSave, WhateverWordIsChangedTheWorldIsNoneTheWorse) {
    FullWorld full;
    full.step(12);
    const Bytes good = bytes_of(full.world);
    full.step(2);
    const auto plain_hash = full.world.state_hash();
    const std::uint32_t words[] = {0,
                                   1,
                                   5,
                                   0x10000,
                                   ~0u,
                                   std::bit_cast<std::uint32_t>(std::numeric_limits<float>::quiet_NaN()),
                                   std::bit_cast<std::uint32_t>(-std::numeric_limits<float>::infinity()),
                                   std::bit_cast<std::uint32_t>(3e38f)};
    for (std::size_t at = offsetof(SaveHead, cloths); at + 4 <= good.size(); at += 4)
        for (std::size_t w = at / 4 % 2; w < std::size(words); w += 2) {  // neighbours get all of them
            const std::uint32_t word = words[w];
            SCOPED_TRACE("word " + std::to_string(word) + " at " + std::to_string(at));
            const std::uint64_t before = full.world.state_hash();
            const auto taken = full.world.restore(changed_in(good, at, word));
            if (!taken)
                ASSERT_EQ(full.world.state_hash(), before);
            else
                for (const ClothId id : full.cloths) ASSERT_TRUE(has_finite_state(full.world, id));
            if (taken && at % 16 == 8) {
                full.step(2);
                for (const ClothId id : full.cloths) ASSERT_TRUE(has_finite_state(full.world, id));
            }
        }
    ASSERT_TRUE(full.world.restore(good));
    full.step(2);
    EXPECT_EQ(full.world.state_hash(), plain_hash);
}

TEST(ForgedSave, CutOffWhereverOrLongerIsRefused) {
    FullWorld full;
    full.step(3);
    const Bytes good = bytes_of(full.world);
    for (std::size_t size = sizeof(SaveHead); size < good.size(); size += 4)
        ASSERT_FALSE(full.world.restore(sealed({good.begin(), good.begin() + size}))) << size;
    Bytes longer = good;
    longer.resize(good.size() + 4);
    EXPECT_FALSE(full.world.restore(sealed(longer)));
    EXPECT_TRUE(full.world.restore(good));
}

/// A sheet of nine particles, and where its save has what.
struct OneCloth {
    explicit OneCloth(float budget = 0) : world(World::create({.threads = 1, .budget = budget}).value()) {
        cloth = world.add_cloth(make_sheet({.rows = 3, .columns = 3}).value()).value();
        EXPECT_TRUE(world.pin(cloth, std::vector<std::uint32_t>{0, 2}));
        world.step(frame_time);
        good = bytes_of(world);
    }
    void expect_refused(const Bytes& bytes, const std::string& says) {
        const std::uint64_t before = world.state_hash();
        const auto result = world.restore(bytes);
        ASSERT_FALSE(result) << says;
        EXPECT_EQ(result.error().code, ErrorCode::malformed_file);
        EXPECT_NE(result.error().message.find(says), std::string::npos) << result.error().message;
        EXPECT_EQ(world.state_hash(), before);
    }
    static constexpr std::size_t rows = 9 * sizeof(Vec4), head = sizeof(SaveHead) + 40,
                                 positions = head + sizeof(ClothHead), velocities = positions + 2 * rows,
                                 pins = positions + 4 * rows, record = pins + 2 * 16,
                                 detail = record + 4 + 3 * rows + sizeof(Rest);
    World world;
    ClothId cloth;
    Bytes good;
};

TEST(ForgedSave, SaysWhatIsWrong) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    OneCloth one;
    const auto refuses = [&](std::size_t at, auto value, const char* says) {
        one.expect_refused(changed_in(one.good, at, value), says);
    };
    refuses(one.positions + 4, nan, "cloth 0 a particle is at no place");
    refuses(one.positions + one.rows, 1e30f, "cloth 0 a particle is at no place");
    refuses(one.velocities, -nan, "cloth 0 a particle has no velocity");
    refuses(one.velocities, 2e6f, "cloth 0 a particle has no velocity");
    refuses(one.pins, 9u, "pin 0 holds particle 9; it must be from 0 to 8");
    refuses(one.pins + 16, 0u, "pin 1 holds particle 0; it must be from 1 to 8");
    refuses(one.pins + 4, nan, "pin 0 has a target that is no place");
    refuses(one.record, nan, "its last step");
    refuses(one.record, -0.01f, "its last step");
    refuses(one.record + 4, nan, "its last step");
    refuses(one.head, ~0u, "is not whole");
    refuses(one.head + offsetof(ClothHead, frame), 2u, "2 frames");
    refuses(sizeof(SaveHead) + 8, std::numeric_limits<double>::infinity(), "the time");
    EXPECT_TRUE(one.world.restore(one.good));

    OneCloth budgeted(1000);
    budgeted.expect_refused(changed_in(budgeted.good, OneCloth::detail, 5u),
                            "its rung is 5; it must be from 0 to 2");
    budgeted.expect_refused(changed_in(budgeted.good, OneCloth::detail + offsetof(DetailState, phase), 2u),
                            "its long steps begin at 2; it must be below 2");
    budgeted.expect_refused(changed_in(budgeted.good, OneCloth::detail + 4, 0u), "its step is 0 long");
    budgeted.expect_refused(changed_in(budgeted.good, OneCloth::detail + 8, 2u), "of which 2 are left");
    // A place to move on to counts only where a long step goes on.
    const Bytes nowhere = changed_in(budgeted.good, OneCloth::detail + sizeof(DetailState), nan);
    EXPECT_TRUE(budgeted.world.restore(nowhere));
    EXPECT_TRUE(budgeted.world.restore(budgeted.good));
    budgeted.expect_refused(
        changed_in(changed_in(nowhere, OneCloth::detail + 4, 2u), OneCloth::detail + 8, 2u),
        "where it is to move on to is no place");
    EXPECT_TRUE(budgeted.world.restore(budgeted.good));
}

// A cloth's rest, or its memory of tangles, is the last of a save.
TEST(ForgedSave, RestAndTanglesThatNoStepLeavesAreRefused) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const auto saved_with = [](World& world, const ClothSettings& settings) {
        EXPECT_TRUE(world.add_cloth(make_sheet({.rows = 3, .columns = 3}).value(), settings));
        world.step(frame_time);
        return bytes_of(world);
    };
    ClothSettings settings;
    settings.sleep_speed = 0.01f;
    World calm = World::create({.threads = 1}).value();
    const Bytes rests = saved_with(calm, settings);
    const std::size_t rest = rests.size() - sizeof(Rest);
    for (const float still_for : {nan, -1.0f})
        EXPECT_FALSE(calm.restore(changed_in(rests, rest + offsetof(Rest, still_for), still_for)));
    EXPECT_FALSE(calm.restore(changed_in(rests, rest + offsetof(Rest, asleep), 2u)));
    EXPECT_TRUE(calm.restore(changed_in(rests, rest + offsetof(Rest, asleep), 1u)));
    EXPECT_EQ(calm.step(frame_time).sleeping_cloths, 0u);  // it has not been still

    World world = World::create({.threads = 1}).value();
    const Bytes good = saved_with(world, {.self_collision = {.method = SelfCollisionMethod::contact}});
    const std::size_t halved = good.size() - 4, may_cross = halved - 4,
                      tangles = may_cross - 9 * sizeof(TangleMemory);
    EXPECT_TRUE(world.restore(changed_in(good, halved, ClothState::most_halved)));
    EXPECT_FALSE(world.restore(changed_in(good, halved, ClothState::most_halved + 1)));
    EXPECT_FALSE(world.restore(changed_in(good, may_cross, 2u)));
    EXPECT_FALSE(world.restore(changed_in(good, tangles + offsetof(TangleMemory, steps), 1'000'000u)));
    EXPECT_FALSE(world.restore(changed_in(good, tangles + offsetof(TangleMemory, votes), 2u)));
    for (const float stalled : {nan, -1.0f})
        EXPECT_FALSE(world.restore(changed_in(good, tangles + offsetof(TangleMemory, stalled), stalled)));
    EXPECT_TRUE(world.restore(good));
}

// If this fails, raise save_version, and write both numbers here.
TEST(ForgedSave, AnotherLayoutHasAnotherVersion) {
    EXPECT_EQ(std::pair(save_version, FullWorld().world.save_size()), std::pair(13u, std::size_t{8106}));
}

/// Places at which two saves of one World differ.
std::vector<std::size_t> places_of_change(const Bytes& a, const Bytes& b) {
    std::vector<std::size_t> places;
    for (std::size_t k = sizeof(SaveHead); k < a.size(); ++k)
        if (a[k] != b[k]) places.push_back(k);
    return places;
}

TEST(ForgedSave, ABoolThatIsNoneIsRefused) {
    World world = World::create({.threads = 1}).value();
    const ColliderId ball = world.add_collider({.shape = Sphere{}}).value();
    const Bytes solid = bytes_of(world);
    ASSERT_TRUE(world.place_collider(ball, {.shape = Sphere{}, .is_trigger = true}));
    const Bytes trigger = bytes_of(world);
    const std::vector<std::size_t> places = places_of_change(solid, trigger);
    ASSERT_EQ(places.size(), 2u) << "now, and at the step's end";
    for (const std::size_t at : places) {
        EXPECT_TRUE(world.restore(changed_in(trigger, at, std::byte{0})));
        EXPECT_FALSE(world.restore(changed_in(trigger, at, std::byte{2})));
    }
}

TEST(ForgedSave, ABodyOrAShapeThatIsNowhereIsRefused) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    World world = World::create({.gravity = {}, .threads = 1}).value();
    const BodyId body = world.add_body({}, {.position = {1, 2, 3}}).value();
    const Solid solid = box_mesh({0.1f, 0.1f, 0.1f});
    const ShapeId shape = world.add_shape(solid.mesh()).value();
    for (int k = 0; k < 2; ++k)  // with two, whose bools take four bytes, numbers begin at multiples of four
        ASSERT_TRUE(world.add_collider({.shape = PlacedShape{.shape = shape}}));
    std::vector<Vec3> larger = solid.vertices;
    for (Vec3& v : larger) v.y *= 1.2f;
    ASSERT_TRUE(world.deform_shape(shape, larger));
    const Bytes good = bytes_of(world);
    const auto refuses_nan_where = [&](const auto& change) {
        change();
        const std::vector<std::size_t> places = places_of_change(good, bytes_of(world));
        EXPECT_FALSE(places.empty());
        for (const std::size_t at : places)
            EXPECT_FALSE(world.restore(changed_in(good, at / 4 * 4, nan))) << at;
        ASSERT_TRUE(world.restore(good));
    };
    const auto moves_body = [&](const BodyState& state) {
        return [&world, body, state] { ASSERT_TRUE(world.set_body_state(body, state)); };
    };
    refuses_nan_where(moves_body({.position = {2, 3, 4}}));
    refuses_nan_where(moves_body({.position = {1, 2, 3}, .velocity = {1, 1, 1}}));
    refuses_nan_where(moves_body({.position = {1, 2, 3}, .angular_velocity = {1, 1, 1}}));
    refuses_nan_where([&] {
        for (Vec3& v : larger) v.y *= 1.1f;
        ASSERT_TRUE(world.deform_shape(shape, larger));
    });
}

// Masses are the cloth's own: no save makes it heavier, or lets a pin go.
TEST(ForgedSave, DoesNotChangeMasses) {
    OneCloth one;
    const Bytes forged =
        changed_in(changed_in(one.good, OneCloth::positions + 12, 1e20f), OneCloth::positions + 28, -1.0f);
    ASSERT_TRUE(one.world.restore(forged));
    EXPECT_TRUE(bytes_of(one.world) == one.good);
}

TEST(ForgedSave, WhatABodyTookFarOutIsTakenBack) {
    World world = World::create({.gravity = {}, .threads = 1}).value();
    const BodyId body = world.add_body({}, {.position = {99990, 0, 0}}).value();
    const ColliderId ball = world.add_collider({.shape = Sphere{{99999, 0, 0}}}).value();
    ASSERT_TRUE(world.attach_collider(body, ball));
    ASSERT_TRUE(world.set_body_state(body, {.position = {99999, 0, 0}}));
    world.step(frame_time);
    ASSERT_GT(std::get<Sphere>(world.collider(ball)->shape).center.x, 1e5f);
    const Bytes then = bytes_of(world);
    world.step(frame_time);
    ASSERT_TRUE(world.restore(then));
    EXPECT_TRUE(bytes_of(world) == then);
}

}  // namespace
}  // namespace weft::test
