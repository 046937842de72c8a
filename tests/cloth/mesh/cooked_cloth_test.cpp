// CookedCloth, as a host uses it: made beside the frame, added as often as is wanted, read back from a file.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <ctime>
#include <future>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/platform.h"
#include "weft/weft.h"

namespace weft::test {
namespace {

/// All of its springs of one kind are of one length.
Mesh hung_sheet(float height) {
    return make_sheet({.rows = 12,
                       .columns = 48,
                       .origin = {0, height, 0},
                       .u = {47 / 128.0f, 0, 0},
                       .v = {0, 0, 11 / 32.0f}})
        .value();
}

World windy_world() {
    WorldSettings settings;
    settings.threads = 1;
    settings.wind = {.velocity = {1, 0, 2}, .gust = 0.4f};
    settings.contact_reports = 32;
    World world = World::create(settings).value();
    EXPECT_TRUE(world.add_collider({.shape = Sphere{{0.2f, 0.3f, 0.2f}, 0.15f}}));
    return world;
}

struct CookedKind {
    std::string name;
    ClothSettings settings;
    bool grid = true;
};

std::vector<CookedKind> cooked_kinds() {
    std::vector<CookedKind> all;
    const auto add = [&](const char* name, auto change) {
        for (const bool grid : {true, false}) {
            CookedKind made{name + std::string(grid ? "OfGrid" : "OfMesh"), {}, grid};
            change(made.settings);
            all.push_back(made);
        }
    };
    add("Plain", [](ClothSettings&) {});
    add("Tethers", [](ClothSettings& s) { s.tethers.enabled = true; });
    add("Contact", [](ClothSettings& s) { s.self_collision = {.method = SelfCollisionMethod::contact}; });
    add("Zones", [](ClothSettings& s) { s.self_collision = {.method = SelfCollisionMethod::impact_zones}; });
    add("Avoidance", [](ClothSettings& s) { s.self_collision = {.method = SelfCollisionMethod::avoidance}; });
    add("Sleep", [](ClothSettings& s) { s.sleep_speed = 1e-3f; });
    add("Stiffening", [](ClothSettings& s) { s.fabric.stiffening = 100; });
    add("BendingRatio", [](ClothSettings& s) { s.fabric.bending_ratio = 4; });
    add("BendingRatioAvoidance", [](ClothSettings& s) {
        s.fabric.bending_ratio = 0.3f;
        s.self_collision = {.method = SelfCollisionMethod::avoidance};
    });
    add("Elements", [](ClothSettings& s) { s.finite_elements.enabled = true; });
    add("Dihedral", [](ClothSettings& s) {
        s.finite_elements = {.enabled = true, .dihedral = true, .consistent_mass = true};
    });
    add("Jacobi", [](ClothSettings& s) { s.method = Jacobi{}; });
    add("Chebyshev", [](ClothSettings& s) { s.method = Chebyshev{}; });
    add("Gradients", [](ClothSettings& s) { s.method = ConjugateGradient{}; });
    add("Fibres", [](ClothSettings& s) { s.method = Fibres{}; });
    add("Xpbd", [](ClothSettings& s) { s.method = Xpbd{}; });
    add("Explicit", [](ClothSettings& s) { s.method = SymplecticEuler{}; });
    return all;
}

class CookedCase : public testing::TestWithParam<CookedKind> {
  protected:
    static Mesh mesh(float height) {
        Mesh made = hung_sheet(height);
        made.positions[0].x = -0.0f;  // which must not come out as 0
        if (!GetParam().grid) made.rows = made.columns = 0;
        return made;
    }
};

INSTANTIATE_TEST_SUITE_P(All, CookedCase, testing::ValuesIn(cooked_kinds()),
                         [](const auto& info) { return info.param.name; });

// What one does to itself must be nothing to the others.
TEST_P(CookedCase, MovesAsByItsMeshWhateverBecomesOfTheOthers) {
    const ClothSettings& settings = GetParam().settings;
    World by_mesh = windy_world(), cooked_world = windy_world(), other = windy_world();
    ClothId a, b, changed;
    {
        const CookedCloth cooked = CookedCloth::create(mesh(0.6f), settings).value();
        EXPECT_EQ(cooked.info().particles, 576u);
        a = by_mesh.add_cloth(mesh(0.6f), settings).value();
        changed = other.add_cloth(cooked).value();
        b = cooked_world.add_cloth(cooked).value();
        // Another one that lies on it.
        ASSERT_TRUE(by_mesh.add_cloth(mesh(0.602f), settings));
        ASSERT_TRUE(cooked_world.add_cloth(CookedCloth::create(mesh(0.602f), settings).value()));
    }
    ASSERT_TRUE(by_mesh.pin(a, 0));
    ASSERT_TRUE(cooked_world.pin(b, 0));
    ASSERT_TRUE(other.pin(changed, {{3, 7, 9}}));
    ClothSettings stiff = settings;
    stiff.fabric.warp *= 2;
    stiff.fabric.shear *= 3;
    stiff.fabric.areal_density *= 2;
    if (stiff.fabric.stiffening > 0) stiff.fabric.stiffening *= 2;
    ASSERT_TRUE(other.set_cloth_settings(changed, stiff));
    if (!settings.finite_elements.consistent_mass) {  // which goes with no maps
        const std::vector<float> map(576, 2.5f);
        ASSERT_TRUE(other.set_map(changed, Map::stiffness, map));
        ASSERT_TRUE(other.set_map(changed, Map::mass, map));
    }
    for (int step = 0; step < 20; ++step) {
        by_mesh.step(1.0f / 60);
        other.step(1.0f / 60);
        cooked_world.step(1.0f / 60);
        ASSERT_EQ(by_mesh.state_hash(), cooked_world.state_hash()) << "step " << step;
    }
    ASSERT_TRUE(other.remove_cloth(changed));
    for (int step = 0; step < 20; ++step) {
        by_mesh.step(1.0f / 60);
        cooked_world.step(1.0f / 60);
    }
    EXPECT_EQ(by_mesh.state_hash(), cooked_world.state_hash());
}

TEST_P(CookedCase, ChangesAsOneByItsMeshDoes) {
    const ClothSettings& settings = GetParam().settings;
    World by_mesh = windy_world(), cooked_world = windy_world();
    const CookedCloth cooked = CookedCloth::create(mesh(0.6f), settings).value();
    const ClothId a = by_mesh.add_cloth(mesh(0.6f), settings).value();
    const ClothId b = cooked_world.add_cloth(cooked).value();
    ClothSettings stiff = settings;
    stiff.fabric.weft *= 2;
    if (stiff.fabric.stiffening > 0) stiff.fabric.stiffening *= 2;
    for (const auto& [world, cloth] : {std::pair(&by_mesh, a), std::pair(&cooked_world, b)}) {
        ASSERT_TRUE(world->pin(cloth, {{0, 47}}));
        ASSERT_TRUE(world->set_cloth_settings(cloth, stiff));
        for (int step = 0; step < 5; ++step) world->step(1.0f / 60);
        ASSERT_TRUE(world->unpin(cloth, 0));
        for (int step = 0; step < 5; ++step) world->step(1.0f / 60);
    }
    EXPECT_EQ(by_mesh.state_hash(), cooked_world.state_hash());
}

TEST_P(CookedCase, ComesBackFromItsBytes) {
    const ClothSettings& settings = GetParam().settings;
    World made = windy_world(), read = windy_world();
    const CookedCloth cooked = CookedCloth::create(mesh(0.6f), settings).value();
    std::vector<std::byte> bytes(cooked.save_size() + 1);
    ASSERT_TRUE(cooked.save(std::span(bytes).subspan(1)));
    const auto loaded = CookedCloth::load(std::span(bytes).subspan(1), settings);
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_EQ(loaded->info(), cooked.info());
    EXPECT_EQ(loaded->report(), cooked.report());
    const ClothId a = made.add_cloth(cooked).value(), b = read.add_cloth(*loaded).value();
    ASSERT_TRUE(made.pin(a, 5));
    ASSERT_TRUE(read.pin(b, 5));
    for (int step = 0; step < 10; ++step) {
        made.step(1.0f / 60);
        read.step(1.0f / 60);
    }
    EXPECT_EQ(made.state_hash(), read.state_hash());
}

// The owner's bytes are read as long as there is a cloth of theirs, and never written.
TEST_P(CookedCase, IsUsedWhereItLies) {
    const ClothSettings& settings = GetParam().settings;
    const CookedCloth cooked = CookedCloth::create(mesh(0.6f), settings).value();
    struct alignas(64) Line {
        std::array<std::byte, 64> bytes;
    };
    auto lines = std::make_shared<std::vector<Line>>(cooked.save_size() / sizeof(Line));
    const auto bytes = std::as_writable_bytes(std::span(*lines));
    ASSERT_TRUE(cooked.save(bytes));
    const std::vector<std::byte> before(bytes.begin(), bytes.end());
    const std::weak_ptr<const void> watch = lines;
    World made = windy_world(), read = windy_world();
    const ClothId a = made.add_cloth(cooked).value();
    ClothId b;
    {
        const auto loaded = CookedCloth::load_in_place(bytes, lines, settings);
        ASSERT_TRUE(loaded) << loaded.error().message;
        EXPECT_EQ(loaded->info(), cooked.info());
        b = read.add_cloth(*loaded).value();
    }
    lines.reset();
    ClothSettings stiff = settings;
    stiff.fabric.weft *= 2;
    if (stiff.fabric.stiffening > 0) stiff.fabric.stiffening *= 2;
    for (int step = 0; step < 10; ++step) {
        for (const auto& [world, cloth] : {std::pair(&made, a), std::pair(&read, b)}) {
            Result<void> change;
            if (step == 2) change = world->pin(cloth, {{0, 47}});
            if (step == 4) change = world->set_cloth_settings(cloth, stiff);
            if (step == 6 && !settings.finite_elements.consistent_mass)
                change = world->set_map(cloth, Map::stiffness, std::vector<float>(576, 1.5f));
            ASSERT_TRUE(change) << change.error().message;
            world->step(1.0f / 60);
        }
        ASSERT_EQ(made.state_hash(), read.state_hash()) << "step " << step;
    }
    ASSERT_FALSE(watch.expired());
    EXPECT_TRUE(std::ranges::equal(before, bytes));
    ASSERT_TRUE(read.remove_cloth(b));
    EXPECT_TRUE(watch.expired());
}

TEST_P(CookedCase, TakesOtherSettingsThanThoseOfItsCooking) {
    const CookedCloth cooked = CookedCloth::create(mesh(0.6f), GetParam().settings).value();
    std::vector<std::byte> bytes(cooked.save_size());
    ASSERT_TRUE(cooked.save(bytes));
    std::vector<ClothSettings> others(7, GetParam().settings);
    others[0].fabric.warp *= 3;
    if (others[0].fabric.stiffening > 0) others[0].fabric.stiffening *= 2;
    others[0].fabric.areal_density *= 2;
    others[1] = {};
    others[2] = {};
    others[2].finite_elements.enabled = true;
    if (others[3].self_collision.method != SelfCollisionMethod::off)
        others[3].self_collision.distance = 0.03f;
    others[4].self_collision = {.method = SelfCollisionMethod::contact};
    others[5].self_collision = {.method = SelfCollisionMethod::avoidance};
    others[6].fabric.bending_ratio *= 5;
    for (const ClothSettings& settings : others) {
        World by_mesh = windy_world(), read = windy_world();
        ASSERT_TRUE(by_mesh.add_cloth(mesh(0.6f), settings));
        const auto loaded = CookedCloth::load(bytes, settings);
        ASSERT_TRUE(loaded) << loaded.error().message;
        ASSERT_TRUE(read.add_cloth(*loaded));
        for (int step = 0; step < 10; ++step) {
            by_mesh.step(1.0f / 60);
            read.step(1.0f / 60);
        }
        EXPECT_EQ(by_mesh.state_hash(), read.state_hash());
    }
}

#ifndef WEFT_WITHOUT_THREADS
TEST(CookedCloth, IsMadeAndAddedOnAnyThread) {
    const CookedCloth shared = CookedCloth::create(hung_sheet(0.5f)).value();
    std::vector<std::future<std::uint64_t>> hashes;
    for (int k = 0; k < 4; ++k)
        hashes.push_back(std::async(std::launch::async, [&shared] {
            World world = windy_world();
            const CookedCloth own = CookedCloth::create(hung_sheet(0.9f)).value();
            const ClothId a = world.add_cloth(shared).value(), b = world.add_cloth(own).value();
            EXPECT_TRUE(world.pin(a, 0));
            ClothSettings stiff;
            stiff.fabric.warp *= 2;
            EXPECT_TRUE(world.set_cloth_settings(b, stiff));
            for (int step = 0; step < 10; ++step) world.step(1.0f / 60);
            return world.state_hash();
        }));
    const std::uint64_t first = hashes[0].get();
    for (int k = 1; k < 4; ++k) EXPECT_EQ(hashes[static_cast<std::size_t>(k)].get(), first);
}
#endif

TEST(CookedCloth, OfManyTakesLittleMoreThanTheirStates) {
    const Mesh mesh = make_sheet({.rows = 64, .columns = 64}).value();
    World world = World::create().value();
    const ClothInfo alone = world.cloth_info(world.add_cloth(mesh).value()).value();
    EXPECT_EQ(alone.shared_bytes, 0u);
    const CookedCloth cooked = CookedCloth::create(mesh).value();
    const ClothInfo one = world.cloth_info(world.add_cloth(cooked).value()).value();
    EXPECT_NEAR(static_cast<double>(one.bytes + one.shared_bytes), static_cast<double>(alone.bytes),
                0.01 * static_cast<double>(alone.bytes));
    EXPECT_EQ(one.scratch_bytes, alone.scratch_bytes);
    EXPECT_LT(one.bytes - one.scratch_bytes, 185 * std::uint64_t{one.particles})
        << "without its steps' scratch";
    EXPECT_EQ(one.particles, alone.particles);
}

// The bounds are some hundredths above what demo/guide/memory.md says.
TEST(CookedCloth, TakesNoMoreMemoryAParticleThanTheGuideSays) {
    Mesh mesh = make_sheet({.rows = 128, .columns = 128}).value();
    const World world = World::create().value();
    EXPECT_LT(world.measure_cloth(mesh)->bytes, 1060 * std::uint64_t{128 * 128});
    const ClothSettings contact{.self_collision = {.method = SelfCollisionMethod::contact}};
    EXPECT_LT(world.measure_cloth(mesh, contact)->bytes, 5700 * std::uint64_t{128 * 128});
    mesh.rows = mesh.columns = 0;
    EXPECT_LT(world.measure_cloth(mesh)->bytes, 1470 * std::uint64_t{128 * 128});
}

TEST(CookedCloth, OfAnArtistsMeshSaysWhatItDid) {
    Mesh mesh = make_sheet({.rows = 5, .columns = 6}).value();
    mesh.rows = mesh.columns = 0;
    const auto triangles = static_cast<std::uint32_t>(mesh.triangles.size());
    mesh.positions.push_back(mesh.positions[7]);  // 30: split for a renderer
    mesh.positions.push_back({0.1f, 2, 0});       // 31: a fin's
    mesh.positions.push_back({3, 3, 3});          // 32: loose
    for (std::uint32_t& corner : mesh.triangles[0]) corner = corner == 7 ? 30 : corner;
    const Triangle inner = mesh.triangles[15];
    mesh.triangles.push_back({inner[0], inner[1], 31});        // at an edge that has two
    mesh.triangles.push_back({inner[1], inner[0], inner[2]});  // once more
    mesh.triangles.push_back({inner[0], inner[0], inner[1]});  // none
    std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
    mesh.texcoords.clear();

    const auto cooked = CookedCloth::create(mesh);
    ASSERT_TRUE(cooked) << cooked.error().message;
    const CookReport& report = cooked->report();
    EXPECT_EQ(report.welded, (std::vector<CookReport::Welded>{{30, 7}}));
    EXPECT_EQ(report.turned, std::vector<std::uint32_t>{3});
    EXPECT_EQ(report.loose, (std::vector<std::uint32_t>{31, 32}));
    EXPECT_EQ(report.dropped, (std::vector<CookReport::Dropped>{{triangles, DropReason::crowded_edge},
                                                                {triangles + 1, DropReason::doubled},
                                                                {triangles + 2, DropReason::no_area}}));
    const ClothInfo& info = cooked->info();
    EXPECT_EQ(info.welded_vertices, 1u);
    EXPECT_EQ(info.turned_triangles, 1u);
    EXPECT_EQ(info.dropped_triangles, 3u);
    EXPECT_EQ(info.loose_particles, 2u);
    EXPECT_EQ(info.misoriented_edges, 0u);
    EXPECT_EQ(info.triangles, triangles);

    World world = World::create().value();
    const ClothId cloth = world.add_cloth(*cooked).value();
    ASSERT_TRUE(world.pin(cloth, 0));
    for (int step = 0; step < 60; ++step) world.step(1.0f / 60);
    EXPECT_EQ(world.report().flags, StepFlags::none);
    EXPECT_TRUE(std::isfinite(world.cloth(cloth)->positions[5].y));
}

TEST(CookedCloth, RefusesWhatAddClothRefuses) {
    const auto no_mesh = CookedCloth::create({});
    ASSERT_FALSE(no_mesh);
    EXPECT_EQ(no_mesh.error().message, World::create()->add_cloth(Mesh{}).error().message);
    ClothSettings bad;
    bad.substeps = 0;
    EXPECT_FALSE(CookedCloth::create(hung_sheet(1), bad));
}

}  // namespace
}  // namespace weft::test
