// What steps need for a substep only is the World's, and cloths that are solved one after the other share it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "hwy/targets.h"
#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"
#include "tests/must.h"

namespace weft::test {
namespace {

WorldSettings on_threads(int threads) {
    WorldSettings settings;
    settings.threads = threads;
    return settings;
}

/// Every bit is set: as floats no numbers, as indices out of all bounds.
void spoil(Simulation& world) {
    if (world.scratch.bytes() > 0) std::memset(world.scratch.data(), 0xFF, world.scratch.bytes());
}

/// Of all cloths, in the order of their ids.
std::vector<Vec4> positions_of(const Simulation& world) {
    std::vector<Vec4> all;
    world.cloths.for_each([&](ClothId, const std::unique_ptr<Cloth>& cloth) {
        const auto own = std::as_const(cloth->state.positions).span();
        all.insert(all.end(), own.begin(), own.end());
    });
    return all;
}

struct Kind {
    std::string name;
    ClothSettings settings;
};

std::vector<Kind> kinds() {
    std::vector<Kind> all(11);
    all[0].name = "default";
    all[1] = {"contact", {.self_collision = {.method = SelfCollisionMethod::contact}}};
    all[2] = {"zones", {.self_collision = {.method = SelfCollisionMethod::impact_zones}}};
    all[3].name = "stiffening";
    all[3].settings.fabric.stiffening = 2;
    all[4].name = "unbent";
    all[4].settings.fabric.bending = 0;
    all[5].name = "elements";
    all[5].settings.finite_elements.enabled = true;
    all[6] = {"jacobi", {.method = Jacobi{9}}};
    all[7] = {"chebyshev", {.method = Chebyshev{9}}};
    all[8] = {"gradients", {.method = ConjugateGradient{9}}};
    all[9] = {"dihedral", {.method = ConjugateGradient{9}}};
    all[9].settings.finite_elements = {.enabled = true, .dihedral = true, .consistent_mass = true};
    all[10] = {"explicit", {.method = SymplecticEuler{}, .substeps = 60}};
    return all;
}

std::vector<Mesh> meshes() {
    return {sheet(20, 23), sheet(5, 4), loose_sheet(18, 19), tube(20, 30)};
}

ClothId add(Simulation& world, const Mesh& mesh, const ClothSettings& settings) {
    auto cloth = std::make_unique<Cloth>(must(cook(mesh)), settings);
    cloth->pin({{0, 3}});
    world.prepare(*cloth);
    return world.add(std::move(cloth));
}

class StepScratchOn : public testing::TestWithParam<std::int64_t> {
  protected:
    void SetUp() override { hwy::SetSupportedTargetsForTest(GetParam()); }
    void TearDown() override { hwy::SetSupportedTargetsForTest(0); }
};
INSTANTIATE_TEST_SUITE_P(Targets, StepScratchOn, testing::ValuesIn(hwy::SupportedAndGeneratedTargets()),
                         [](const auto& info) { return std::string(hwy::TargetName(info.param)); });

// Narrow vectors leave more lanes of a last group unwritten.
TEST_P(StepScratchOn, MayHoldAnything) {
    for (const Kind& kind : kinds()) {
        for (const Mesh& mesh : meshes()) {
            SCOPED_TRACE(kind.name + ", " + std::to_string(mesh.positions.size()));
            Simulation clean(on_threads(1)), spoilt(on_threads(1));
            for (Simulation* world : {&clean, &spoilt}) add(*world, mesh, kind.settings);
            for (int k = 0; k < 4; ++k) {
                spoil(spoilt);
                clean.step(h);
                spoilt.step(h);
                ASSERT_TRUE(same_bytes(positions_of(clean), positions_of(spoilt))) << "step " << k;
            }
            EXPECT_EQ(clean.report.restored_cloths, 0u);
        }
    }
}

// Whoever shares it with whom: on one thread all do, on many few.
TEST(StepScratch, OfManyClothsThatComeAndGoAndChangeGivesTheSameBytesOnAnyThreads) {
    const std::vector<Kind> some = kinds();
    const std::vector<Mesh> shapes = meshes();
    std::vector<std::vector<Vec4>> expected;
    for (const int threads : {1, 2, 7}) {
        Simulation world(on_threads(threads));
        std::mt19937 random(5);
        const auto below = [&](std::size_t n) { return random() % n; };
        std::vector<ClothId> ids;
        for (std::size_t k = 0; k < 40; ++k) {
            const std::size_t act = ids.size() < 4 ? 0 : below(4);
            const ClothSettings& settings = some[below(some.size())].settings;
            if (act < 2) {
                ids.push_back(add(world, shapes[below(shapes.size())], settings));
            } else if (act == 2) {
                world.apply(**world.cloths.find(ids[below(ids.size())]), settings);
            } else {
                const std::size_t gone = below(ids.size());
                world.cloths.erase(ids[gone]);
                ids.erase(ids.begin() + static_cast<std::ptrdiff_t>(gone));
                world.cloth_has_gone();
            }
            spoil(world);
            world.step(h);
            if (threads == 1)
                expected.push_back(positions_of(world));
            else
                ASSERT_TRUE(same_bytes(positions_of(world), expected[k]))
                    << threads << " threads, step " << k;
        }
    }
}

// Of what a copy has for itself most is its state. The bounds are what was measured, and a twentieth.
TEST(StepScratch, LeavesACopyItsStateAlone) {
    struct Case {
        Mesh mesh;
        ClothSettings settings;
        double most;  // bytes a particle
    };
    const ClothSettings contact{.self_collision = {.method = SelfCollisionMethod::contact}};
    const Case cases[] = {{sheet(64, 64), {}, 300}, {tube(64, 64), {}, 300}, {tube(64, 64), contact, 450}};
    for (const auto& [mesh, settings, most] : cases) {
        const Cloth cooked(must(cook(mesh)), settings);
        const Cloth copy(cooked);
        const double own = static_cast<double>(copy.info().bytes - copy.scratch_bytes);
        EXPECT_LT(own / copy.model.particle_count, most) << mesh.rows;
        EXPECT_GT(own / copy.model.particle_count, most / 2) << mesh.rows;
    }
}

}  // namespace
}  // namespace weft::test
