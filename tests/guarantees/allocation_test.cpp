// World::step does not allocate once it is warm; the tests of scenes' bytes count, too.

#include <gtest/gtest.h>

#include <algorithm>
#include <new>
#include <string>
#include <vector>

#include "tests/guarantees/allocation_count.h"
#include "tests/guarantees/method_cases.h"

namespace weft {
namespace {

TEST(AllocationCount, SeesEveryFormOfNew) {
    constexpr std::align_val_t wide{64};
    const std::uint64_t before = allocation_count();
    ::operator delete(::operator new(1));
    ::operator delete[](::operator new[](1));
    ::operator delete(::operator new(1, wide), wide);
    ::operator delete[](::operator new[](1, wide), wide);
    ::operator delete(::operator new(1, std::nothrow));
    ::operator delete[](::operator new[](1, std::nothrow));
    ::operator delete(::operator new(1, wide, std::nothrow), wide);
    ::operator delete[](::operator new[](1, wide, std::nothrow), wide);
    EXPECT_EQ(allocation_count() - before, 8u);
}

struct WarmSteps {
    std::uint64_t count = 0;  ///< of allocations
    std::uint32_t collider_contacts = 0, self_contacts = 0, restored = 0;
};

/// Of steps after `warm_up` others.
WarmSteps allocations_when_warm(test::LoweredSheet& run, int warm_up, int frames) {
    WarmSteps seen;
    for (int frame = 0; frame < warm_up + frames; ++frame) {
        run.before_step();  // the host may allocate
        const std::uint64_t before = allocation_count();
        const StepReport& report = run.step();
        if (frame < warm_up) continue;
        seen.count += allocation_count() - before;
        seen.collider_contacts += report.collider_contacts;
        seen.self_contacts += report.self_contacts;
        seen.restored += report.restored_cloths;
    }
    return seen;
}

class MethodAllocation : public testing::TestWithParam<test::MethodCase> {};

TEST_P(MethodAllocation, DoesNotHappenInAWarmStepWhateverIsPinned) {
    constexpr std::uint32_t side = 24;
    const SelfCollision& self = GetParam().cloth.self_collision;
    const bool is_slow = meets_cloth(self.method);
    for (const test::PinPattern& pins : test::pin_patterns(side)) {
        std::uint64_t hash = 0;
        const bool folds = pins.name == "corners";  // and meets itself, after half a second
        if (is_slow && !folds) continue;            // what it keeps does not depend on pins
        for (int threads = 1; threads <= (folds ? 2 : 1); ++threads) {
            SCOPED_TRACE(pins.name + ", " + std::to_string(threads) + " threads");
            test::LoweredSheet run(GetParam(), threads, side, pins);
            const WarmSteps seen =
                folds ? allocations_when_warm(run, 30, 30) : allocations_when_warm(run, 15, 15);
            EXPECT_EQ(seen.count, 0u);
            EXPECT_EQ(seen.restored, 0u);
            EXPECT_GT(seen.collider_contacts, 0u);
            if (self.method != SelfCollisionMethod::off && folds) {
                EXPECT_GT(seen.self_contacts, 0u);
            }
            if (threads == 1) hash = run.world().state_hash();
            EXPECT_EQ(run.world().state_hash(), hash);
        }
    }
}

/// A garment: pins, a skin and a frame, all told anew before each step, which takes no memory either. In step
/// 20 the frame jumps; in step 30 the cloth is reset.
std::uint64_t hash_of_worn_cloth(int threads, std::uint64_t& allocations) {
    constexpr std::uint32_t side = 40;
    World world = World::create({.threads = threads}).value();
    ClothSettings settings;
    settings.frame_inertia = {0.5f, 0.2f, 0.5f};
    settings.teleport_distance = 1;
    settings.self_collision = {.method = SelfCollisionMethod::contact};
    const Mesh mesh = make_sheet({.rows = side, .columns = side}).value();
    const std::size_t n = mesh.positions.size();
    const ClothId cloth = world.add_cloth(mesh, settings).value();
    EXPECT_TRUE(world.add_collider({.shape = Sphere{{0, -0.2f, 0}, 0.15f}}));
    EXPECT_TRUE(world.set_map(cloth, Map::leash, std::vector<float>(n, 0.1f)));
    EXPECT_TRUE(world.set_map(cloth, Map::backstop, std::vector<float>(n, 0.05f)));
    EXPECT_TRUE(world.set_map(cloth, Map::friction, std::vector<float>(n, 0.7f)));
    EXPECT_TRUE(world.set_map(cloth, Map::thickness, std::vector<float>(n, 0.5f)));
    const std::vector<std::uint32_t> pins = {0, 5, side - 1};
    EXPECT_TRUE(world.pin(cloth, pins));
    std::vector<Vec3> places = mesh.positions, targets(3);
    const std::vector<Vec3> normals(n, Vec3{0, 1, 0});
    allocations = 0;
    for (int step = 0; step < 40; ++step) {
        const float way = 0.01f * static_cast<float>(step), x = step < 20 ? way : way + 3;
        for (std::size_t v = 0; v < n; ++v)
            places[v] = {mesh.positions[v].x + x, mesh.positions[v].y, mesh.positions[v].z};
        for (std::size_t k = 0; k < 3; ++k) targets[k] = places[pins[k]];
        const std::uint64_t before = allocation_count();
        const bool told =
            world.move_pins(cloth, pins, targets) && world.set_skin(cloth, places, normals) &&
            world.set_frame(cloth, {.translation = {x, 0, 0}, .rotation = {0, 0.1f * way, 0, 1}}) &&
            (step != 30 || world.reset_cloth(cloth, places));
        EXPECT_FALSE(has(world.step(1.0f / 60).flags, StepFlags::state_restored));
        EXPECT_TRUE(told);
        if (step > 0) allocations += allocation_count() - before;
    }
    return world.state_hash();
}

TEST(WornCloth, TakesNoMemoryAndHasTheSameBytesOnAnyThreads) {
    std::uint64_t alone = 0, together = 0;
    const std::uint64_t expected = hash_of_worn_cloth(1, alone);
    EXPECT_EQ(hash_of_worn_cloth(3, together), expected);
    EXPECT_EQ(alone, 0u);
    EXPECT_EQ(together, 0u);
}

/// Two panels that are welded at their borders, a hand apart in the middle. Triangles at corners, all of
/// whose vertices are of both panels, are left out.
Mesh cushion(std::uint32_t side) {
    const auto is_border = [&](std::uint32_t v) {
        const std::uint32_t row = v / side, column = v % side;
        return row == 0 || column == 0 || row + 1 == side || column + 1 == side;
    };
    Mesh mesh;
    for (const float height : {0.05f, -0.05f}) {
        Mesh panel = make_sheet({.rows = side, .columns = side}).value();
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (std::uint32_t v = 0; v < side * side; ++v) {
            panel.positions[v].y += is_border(v) ? 0 : height;
            mesh.positions.push_back(panel.positions[v]);
        }
        for (Triangle t : panel.triangles) {
            if (std::ranges::all_of(t, is_border)) continue;
            if (first > 0) std::swap(t[1], t[2]);
            mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
        }
    }
    return mesh;
}

/// A cushion that hangs from a sheet by a seam, of which stitches break, over ground that half of it meets.
std::uint64_t hash_of_sewn_cushion(const Filling& filling, int threads, std::uint64_t& allocations) {
    constexpr std::uint32_t side = 16;
    World world = World::create({.threads = threads}).value();
    ClothSettings settings;
    settings.self_collision = {.method = SelfCollisionMethod::contact};
    settings.back_friction_ratio = 0.5f;
    const ClothId sheet =
        world.add_cloth(make_sheet({.rows = side, .columns = side}).value(), settings).value();
    settings.filling = filling;
    const ClothId filled = world.add_cloth(cushion(side), settings).value();
    EXPECT_TRUE(world.move_cloth(filled, {.translation = {0, -0.2f, 0}}));
    std::vector<std::uint32_t> last, first;
    for (std::uint32_t k = 1; k + 1 < side; ++k) {
        first.push_back(k);
        last.push_back(side * (side - 1) + k);
    }
    EXPECT_TRUE(world.pin(sheet, first));
    const SeamId seam =
        world.stitch(sheet, last, filled, first, {.rest_length = 0.05f, .break_force = 0.3f}).value();
    EXPECT_TRUE(world.add_collider({.shape = Plane{.offset = -0.5f}}));
    std::vector<float> masks(2 * side * side, 1);
    for (std::size_t v = 0; v < masks.size(); v += 2) masks[v] = 2;
    EXPECT_TRUE(world.set_map(filled, Map::collider_mask, masks));
    allocations = 0;
    for (int step = 0; step < 40; ++step) {
        const std::uint64_t before = allocation_count();
        EXPECT_FALSE(has(world.step(1.0f / 60).flags, StepFlags::state_restored));
        if (step > 0) allocations += allocation_count() - before;
    }
    EXPECT_LT(world.seam_info(seam)->holding, first.size()) << "none broke";
    return world.state_hash();
}

TEST(SewnCushion, TakesNoMemoryAndHasTheSameBytesOnAnyThreads) {
    for (const Filling& filling :
         {Filling{.kind = FillingKind::pressure, .pressure = 200},
          Filling{.kind = FillingKind::gas, .pressure = 500}, Filling{.kind = FillingKind::volume}}) {
        std::uint64_t alone = 0, together = 0;
        const std::uint64_t expected = hash_of_sewn_cushion(filling, 1, alone);
        EXPECT_EQ(hash_of_sewn_cushion(filling, 3, together), expected);
        EXPECT_EQ(alone, 0u);
        EXPECT_EQ(together, 0u);
    }
}

/// A budget that nothing fits takes a garment to its coarser mesh in some step.
TEST(GarmentLevels, TakeNoMemoryWhereABudgetChangesThem) {
    World world = World::create({.threads = 1, .budget = 1e-4f}).value();
    const ClothId fine = world.add_cloth(make_sheet({.rows = 17, .columns = 17}).value()).value();
    const ClothId coarse = world.add_cloth(make_sheet({.rows = 9, .columns = 9}).value()).value();
    for (const ClothId cloth : {fine, coarse}) ASSERT_TRUE(world.pin(cloth, 0));
    ASSERT_TRUE(world.add_level(fine, coarse));
    std::uint64_t allocations = 0;
    for (int step = 0; step < 90; ++step) {
        const std::uint64_t before = allocation_count();
        world.step(1.0f / 60);
        allocations += allocation_count() - before;
    }
    EXPECT_EQ(world.level(fine).value(), 1u);
    EXPECT_EQ(allocations, 0u);
}

INSTANTIATE_TEST_SUITE_P(Methods, MethodAllocation, testing::ValuesIn(test::method_cases()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace weft
