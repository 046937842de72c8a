// Garments of several meshes: one takes over from another, by the host or by the World's budget.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cloth/simulation/simulation.h"
#include "tests/cloth/fixtures.h"
#include "weft/weft.h"

namespace weft::test::garments {
namespace {

/// A curtain that hangs by its upper edge.
Mesh curtain(std::uint32_t side, float x = 0) {
    return make_sheet(
               {.rows = side, .columns = side, .origin = {x, 2, 0}, .u = {0.5f, 0, 0}, .v = {0, -0.5f, 0}})
        .value();
}
std::vector<std::uint32_t> upper_edge(std::uint32_t side) {
    std::vector<std::uint32_t> vertices(side);
    for (std::uint32_t v = 0; v < side; ++v) vertices[v] = v;
    return vertices;
}

constexpr std::array<std::uint32_t, 3> sides{33, 17, 9};

/// A microsecond a particle as the cloth is set; what the rungs save is as measured on curtains.
std::int64_t known_cost(const Cloth& cloth) {
    constexpr std::int64_t costs[] = {1000, 800, 1000};
    const DetailState& detail = *cloth.state.detail;
    if (detail.left + 1 < detail.rate) return 60 * cloth.model.particle_count;  // it glides
    return costs[detail.rung] * cloth.model.particle_count;
}
std::int64_t noisy_cost(const Cloth& cloth) {
    static std::int64_t turn = 0;
    return known_cost(cloth) * (90 + turn++ * 7 % 21) / 100;
}

/// Garments of three meshes each, the first the most important, in a World with a budget.
struct Wardrobe {
    static constexpr std::size_t count = 8;
    explicit Wardrobe(float budget)
        : simulation({.wind = {.velocity = {0, 0, 2}}, .threads = 1, .budget = budget}) {
        simulation.cost_of = known_cost;
        for (std::size_t g = 0; g < count; ++g) {
            for (std::size_t k = 0; k < sides.size(); ++k) {
                ClothSettings settings;
                settings.sleep_speed = 0;
                settings.importance = 1 / static_cast<float>(1 + g);
                auto cloth =
                    std::make_unique<Cloth>(cook(curtain(sides[k], static_cast<float>(g))).value(), settings);
                cloth->pin(upper_edge(sides[k]));
                simulation.prepare(*cloth);
                cloths[g][k] = cloth.get();
                ids[g][k] = simulation.add(std::move(cloth));
                if (k > 0) {
                    EXPECT_TRUE(simulation.add_level(ids[g][0], ids[g][k], 0.1f));
                }
            }
        }
    }
    /// Returns the time that a step takes, by known costs [ms].
    float step() {
        const std::vector<std::uint32_t> before = simulation.state.levels;
        simulation.step(h);
        float milliseconds = 0;
        for (const Cloth* cloth : simulation.present)
            milliseconds += 1e-6f * static_cast<float>(known_cost(*cloth));
        simulation.take_chosen_levels();
        for (std::size_t g = 0; g < count; ++g) changes += simulation.state.levels[g] != before[g] ? 1 : 0;
        return milliseconds;
    }
    void run(int steps) {
        for (int s = 0; s < steps; ++s) step();
    }
    [[nodiscard]] std::uint32_t level(std::size_t g) const { return simulation.state.levels[g]; }

    Simulation simulation;
    std::array<std::array<Cloth*, sides.size()>, count> cloths{};
    std::array<std::array<ClothId, sides.size()>, count> ids{};
    int changes = 0;
};

// Eight garments of 1089 particles take 8.7 ms as they are set, 4.6 ms on their last rungs.
TEST(GarmentLevels, ABudgetTakesWhatCountsLeastToCoarserMeshes) {
    for (const float budget : {2.2f, 3.0f}) {
        Wardrobe wardrobe(budget);
        wardrobe.run(600);
        float most = 0;
        for (int s = 0; s < 60; ++s) most = std::max(most, wardrobe.step());
        EXPECT_LT(most, 1.2f * budget);
        EXPECT_EQ(wardrobe.level(0), 0u) << budget;
        EXPECT_GT(wardrobe.level(Wardrobe::count - 1), 0u) << budget;
        for (std::size_t g = 1; g < Wardrobe::count; ++g)
            EXPECT_GE(wardrobe.level(g), wardrobe.level(g - 1)) << g;
        for (std::size_t g = 0; g < Wardrobe::count; ++g)
            for (std::size_t k = 0; k < sides.size(); ++k)
                EXPECT_EQ(wardrobe.cloths[g][k]->settings.enabled, k == wardrobe.level(g)) << g << ", " << k;
        wardrobe.simulation.settings.budget = 30;
        wardrobe.run(600);
        for (std::size_t g = 0; g < Wardrobe::count; ++g) EXPECT_EQ(wardrobe.level(g), 0u) << g;
    }
}

TEST(GarmentLevels, ABudgetThatStaysChangesNoLevelToAndFro) {
    for (const float budget : {0.7f, 1.3f, 2.1f, 3.4f}) {
        Wardrobe wardrobe(budget);
        wardrobe.simulation.cost_of = noisy_cost;
        wardrobe.run(900);
        EXPECT_GT(wardrobe.changes, 0) << budget;
        wardrobe.changes = 0;
        wardrobe.run(900);
        EXPECT_LE(wardrobe.changes, 1) << budget;
    }
}

TEST(GarmentLevels, TheHostSetsTheFinestThatABudgetMayTake) {
    Wardrobe wardrobe(30);
    wardrobe.simulation.garments[2].least = 1;
    wardrobe.simulation.set_level(wardrobe.simulation.garments[2], 1, 0);
    wardrobe.run(200);
    for (std::size_t g = 0; g < Wardrobe::count; ++g) EXPECT_EQ(wardrobe.level(g), g == 2 ? 1u : 0u);
}

/// A garment stays on a level for half a second before it coarsens, and for a second before it refines.
TEST(GarmentLevels, ABudgetThatChangesKeepsLevelsForAWhile) {
    Wardrobe wardrobe(30);
    std::array<int, Wardrobe::count> since{};
    int coarsened = 0, refined = 0;
    for (int s = 0; s < 900; ++s) {
        wardrobe.simulation.settings.budget = s / 45 % 2 == 0 ? 30 : 0.1f;
        const std::vector<std::uint32_t> before = wardrobe.simulation.state.levels;
        wardrobe.step();
        for (std::size_t g = 0; g < Wardrobe::count; ++g) {
            if (wardrobe.level(g) == before[g]) continue;
            const bool refines = wardrobe.level(g) < before[g];
            EXPECT_GE(s - since[g], refines ? 60 : 30) << g << ", step " << s;
            (refines ? refined : coarsened) += 1;
            since[g] = s;
        }
    }
    EXPECT_GT(coarsened, 0);
    for (int s = 0; s < 300; ++s) {
        wardrobe.simulation.settings.budget = 30;
        const std::uint32_t before = wardrobe.level(0);
        wardrobe.step();
        if (wardrobe.level(0) == before) continue;
        EXPECT_GE(900 + s - since[0], 60);
        since[0] = 900 + s;
        ++refined;
    }
    EXPECT_GT(refined, 0);
}

std::int64_t low_cost(const Cloth& cloth) {
    return known_cost(cloth) / 100;
}

/// A mesh that was never stepped is taken to cost as the present one does, by its size, not by the first
/// guess, here thirty times the cost: garments for which the last rung suffices keep their level.
TEST(GarmentLevels, ABudgetGuessesACoarserMeshByThePresentOne) {
    Wardrobe wardrobe(0.065f);
    wardrobe.simulation.cost_of = low_cost;
    wardrobe.run(300);
    EXPECT_EQ(wardrobe.changes, 0);
    EXPECT_GT(wardrobe.cloths[Wardrobe::count - 1][0]->state.detail->rung, 0u);
}

/// Amid a long step the cloth is on its way to places that the other mesh does not have.
TEST(GarmentLevels, AmidALongStepBdf2BeginsAnew) {
    Wardrobe wardrobe(0.1f);
    wardrobe.simulation.garments[0].least = 0;
    Cloth &fine = *wardrobe.cloths[0][0], &coarse = *wardrobe.cloths[0][1];
    for (int s = 0; s < 29 && !fine.is_gliding(); ++s) wardrobe.step();
    ASSERT_TRUE(fine.is_gliding());
    ASSERT_GT(fine.state.record.h, 0);
    wardrobe.simulation.set_level(wardrobe.simulation.garments[0], 1, 0);
    EXPECT_FALSE(fine.is_gliding());
    EXPECT_EQ(coarse.state.record.h, 0);
}

TEST(GarmentLevels, AFramesMotionGoesOn) {
    Wardrobe wardrobe(0);
    const auto bytes_of = [](const Vec3& v) { return std::array{v.x, v.y, v.z}; };
    const FrameState moves{
        .pose = {}, .target = {}, .velocity = {1, 2, 3}, .velocity_change = {0.1f, 0.2f, 0.3f}};
    for (Cloth* cloth : wardrobe.cloths[0]) cloth->state.frame = moves;
    wardrobe.simulation.set_level(wardrobe.simulation.garments[0], 2, 0);
    const FrameState& now = *wardrobe.cloths[0][2]->state.frame;
    EXPECT_EQ(bytes_of(now.velocity), bytes_of(moves.velocity));
    EXPECT_EQ(bytes_of(now.velocity_change), bytes_of(moves.velocity_change));
}

/// A level that the host allowed no finer than, and that is gone, binds the coarsest that is left no more.
TEST(GarmentLevels, TheFinestAllowedIsOneThatIsLeft) {
    Wardrobe wardrobe(0.05f);
    Garment& garment = wardrobe.simulation.garments[0];
    garment.least = 2;
    wardrobe.simulation.set_level(garment, 2, 0);
    wardrobe.simulation.refine_from(*wardrobe.cloths[0][2]);
    wardrobe.simulation.drop_level(*wardrobe.cloths[0][2]);
    ASSERT_EQ(wardrobe.level(0), 1u);
    const Cloth& left = *wardrobe.cloths[0][1];
    for (int s = 0; s < 60; ++s) wardrobe.simulation.step(h);
    ASSERT_GT(left.state.detail->rung, 0u);
    wardrobe.simulation.settings.budget = 30;
    for (int s = 0; s < 60; ++s) wardrobe.simulation.step(h);
    EXPECT_EQ(wardrobe.level(0), 1u);
    EXPECT_EQ(left.state.detail->rung, 0u);
}

TEST(GarmentLevels, OthersStayWhenOneEnds) {
    Wardrobe wardrobe(0);
    Simulation& simulation = wardrobe.simulation;
    simulation.drop_level(*wardrobe.cloths[2][1]);
    ASSERT_EQ(simulation.garments.size(), Wardrobe::count - 1);
    for (std::size_t g = 0; g < Wardrobe::count; ++g)
        for (std::size_t k = 0; k < sides.size(); ++k) {
            const Cloth& cloth = *wardrobe.cloths[g][k];
            ASSERT_EQ(cloth.garment, g == 2 ? no_garment : g > 2 ? g - 1 : g);
            if (g != 2) {
                EXPECT_EQ(simulation.garments[cloth.garment].levels[cloth.level], wardrobe.ids[g][k]);
            }
        }
}

/// A garment of two meshes and a finer drawn one hangs in a wind that gusts.
struct Hanging {
    explicit Hanging(float budget = 0) {
        EXPECT_TRUE(world.set_settings(
            {.wind = {.velocity = {1, 0, 6}, .gust = 0.5f}, .threads = 1, .budget = budget}));
        for (std::size_t k = 0; k < 2; ++k) {
            cloths[k] = world.add_cloth(curtain(sides[k])).value();
            EXPECT_TRUE(world.pin(cloths[k], upper_edge(sides[k])));
        }
        EXPECT_TRUE(world.add_level(cloths[0], cloths[1]));
        const Mesh fine = curtain(97);
        for (const ClothId cloth : cloths)
            drawn.push_back(DrawnMesh::bind(world.cloth(cloth).value(),
                                            {.vertices = fine.positions, .triangles = fine.triangles})
                                .value());
        places.resize(fine.positions.size());
        normals.resize(fine.positions.size());
    }
    [[nodiscard]] std::uint32_t level() const { return world.level(cloths[0]).value(); }
    void draw() {
        drawn[level()].update(world.cloth(cloths[level()]).value(),
                              {.positions = places, .normals = normals});
    }
    /// Draws, and returns how far the farthest vertex is from where it was drawn last.
    float draw_way() {
        const std::vector<Vec4> before = places;
        draw();
        float most = 0;
        for (std::size_t v = 0; v < places.size(); ++v)
            most = std::max(most, (xyz(places[v]) - xyz(before[v])).norm());
        return most;
    }
    void run(int steps) {
        for (int s = 0; s < steps; ++s) world.step(h);
    }

    World world = World::create({.threads = 1}).value();
    std::array<ClothId, 2> cloths;
    std::vector<DrawnMesh> drawn;
    std::vector<Vec4> places, normals;
};

/// Folds that the coarse mesh does not have jump without a blend; with one, nothing jumps.
TEST(GarmentLevels, ABlendHidesThatAnotherMeshTakesOver) {
    constexpr int steps_of_blend = 15;
    Hanging hanging;
    float most_without = 0, most_jump = 0, most_way = 0, usual_way = 0;
    for (int change = 0; change < 10; ++change) {
        const auto next = static_cast<std::uint32_t>(1 - change % 2);
        for (int s = 0; s < 40; ++s) {
            hanging.draw();
            hanging.world.step(h);
            const float way = hanging.draw_way();
            if (s >= 20) usual_way = std::max(usual_way, way);
        }
        const std::vector<Vec4> last = hanging.places, last_normals = hanging.normals;
        ASSERT_TRUE(hanging.world.set_level(hanging.cloths[0], next));
        ASSERT_EQ(hanging.level(), next);
        most_without = std::max(most_without, hanging.draw_way());
        hanging.places = last;
        ASSERT_TRUE(hanging.drawn[next].begin_blend(hanging.world.cloth(hanging.cloths[next]).value(), last,
                                                    last_normals));
        most_jump = std::max(most_jump, hanging.draw_way());
        for (std::size_t v = 0; v < last.size(); ++v)
            ASSERT_LT((xyz(hanging.normals[v]) - xyz(last_normals[v]).normalized()).norm(), 1e-4f);
        for (int s = steps_of_blend; s-- > 0;) {
            hanging.world.step(h);
            ASSERT_TRUE(hanging.drawn[next].blend(static_cast<float>(s) / steps_of_blend));
            most_way = std::max(most_way, hanging.draw_way());
        }
    }
    RecordProperty("jump_mm", std::to_string(1e3f * most_jump));
    RecordProperty("jump_without_blend_mm", std::to_string(1e3f * most_without));
    RecordProperty("way_of_a_step_mm", std::to_string(1e3f * usual_way));
    RecordProperty("way_of_a_blended_step_mm", std::to_string(1e3f * most_way));
    EXPECT_GT(most_without, 1e-3f);
    EXPECT_LT(most_jump, 1e-5f);
    EXPECT_LT(most_way, 1.5f * usual_way);
}

TEST(GarmentLevels, AfterABlendBondsAreAsTheyWereBound) {
    Hanging hanging;
    hanging.run(10);
    DrawnMesh& drawn = hanging.drawn[0];
    std::vector<std::byte> before(drawn.save_size()), amid(before), after(before);
    ASSERT_TRUE(drawn.save(before));
    hanging.draw();
    for (Vec4& p : hanging.places) p.z += 0.01f;
    const ClothView& view = hanging.world.cloth(hanging.cloths[0]).value();
    ASSERT_TRUE(drawn.begin_blend(view, hanging.places, hanging.normals));
    ASSERT_TRUE(drawn.save(amid));
    ASSERT_TRUE(drawn.blend(0.5f));
    EXPECT_NEAR(hanging.draw_way(), 0.005f, 1e-5f);
    ASSERT_TRUE(drawn.begin_blend(view, hanging.places, hanging.normals));
    EXPECT_LT(hanging.draw_way(), 1e-5f);
    ASSERT_TRUE(drawn.blend(0));
    ASSERT_TRUE(drawn.save(after));
    EXPECT_EQ(before, amid);
    EXPECT_EQ(before, after);
    const auto says = [&](const Result<void>& answer, const char* what) {
        ASSERT_FALSE(answer);
        EXPECT_NE(answer.error().message.find(what), std::string::npos) << answer.error().message;
    };
    says(drawn.blend(1.1f), "left is 1.1; it must be from 0 to 1");
    says(drawn.blend(NAN), "left is nan; it must be from 0 to 1");
    says(drawn.begin_blend(view, {}), "0 positions and 0 normals; the drawn mesh has 9409 vertices");
    says(drawn.begin_blend(hanging.world.cloth(hanging.cloths[1]).value(), hanging.places), "another mesh");
    hanging.places[7].x = NAN;
    says(drawn.begin_blend(view, hanging.places), "vertex 7 of the drawn surface is not finite");
    ASSERT_TRUE(drawn.save(after));
    EXPECT_EQ(before, after);
}

/// Energy that a curtain loses in two seconds, which is let go level and swings in a vacuum; every so many
/// steps another mesh takes over. 0: none does [J].
double loss_of_swing(int steps_between) {
    World world = World::create({.wind = {.air_density = 0}, .threads = 1}).value();
    std::array<ClothId, 2> cloths;
    for (std::size_t k = 0; k < 2; ++k) {
        const Mesh level =
            make_sheet({.rows = sides[k], .columns = sides[k], .u = {0.5f, 0, 0}, .v = {0, -0.1f, 0.45f}})
                .value();
        cloths[k] = world.add_cloth(level, {.air_damping = 0, .sleep_speed = 0}).value();
        EXPECT_TRUE(world.pin(cloths[k], upper_edge(sides[k])));
    }
    EXPECT_TRUE(world.add_level(cloths[0], cloths[1]));
    const auto energy = [&] {
        double sum = 0;
        const ClothView& view = world.cloth(cloths[0]).value();
        for (std::size_t i = 0; i < view.positions.size(); ++i) {
            if (!(view.positions[i].w > 0)) continue;
            const auto squared = static_cast<double>(xyz(view.velocities[i]).squaredNorm());
            sum += (0.5 * squared + 9.81 * static_cast<double>(view.positions[i].y)) /
                   static_cast<double>(view.positions[i].w);
        }
        return sum;
    };
    const double before = energy();
    for (int step = 1; step <= 120; ++step) {
        world.step(h);
        if (steps_between > 0 && step % steps_between == 0) {
            EXPECT_TRUE(world.set_level(cloths[0], static_cast<std::uint32_t>(step / steps_between % 2)));
        }
    }
    return before - energy();
}

TEST(GarmentLevels, AChangeTakesLittleOfASwingsEnergy) {
    const double without = loss_of_swing(0), with = loss_of_swing(10);
    RecordProperty("loss_without_J", std::to_string(without));
    RecordProperty("loss_with_twelve_changes_J", std::to_string(with));
    EXPECT_NEAR(with, without, 0.1 * without);
}

TEST(GarmentLevels, PinsStayWhereTheHostHasThem) {
    Hanging hanging;
    const auto pins_of = [&](std::size_t k) {
        const ClothView& view = hanging.world.cloth(hanging.cloths[k]).value();
        std::vector<Vector3> places;
        for (const std::uint32_t v : upper_edge(sides[k]))
            places.push_back(xyz(view.positions[view.vertex_to_particle[v]]));
        return places;
    };
    const std::array before{pins_of(0), pins_of(1)};
    for (std::uint32_t change = 1; change < 21; ++change) {
        hanging.run(3);
        ASSERT_TRUE(hanging.world.set_level(hanging.cloths[1], change % 2));
    }
    EXPECT_EQ(before[0], pins_of(0));
    EXPECT_EQ(before[1], pins_of(1));
}

TEST(GarmentLevels, ASaveHasTheLevel) {
    Hanging hanging;
    hanging.run(20);
    ASSERT_TRUE(hanging.world.set_level(hanging.cloths[0], 1));
    hanging.run(5);
    std::vector<std::byte> saved(hanging.world.save_size());
    ASSERT_TRUE(hanging.world.save(saved));
    hanging.run(5);
    const std::uint64_t then = hanging.world.state_hash();
    ASSERT_TRUE(hanging.world.set_level(hanging.cloths[0], 0));
    hanging.run(9);
    ASSERT_TRUE(hanging.world.restore(saved));
    EXPECT_EQ(hanging.level(), 1u);
    EXPECT_TRUE(hanging.world.cloth_settings(hanging.cloths[1])->enabled);
    EXPECT_FALSE(hanging.world.cloth_settings(hanging.cloths[0])->enabled);
    hanging.run(5);
    EXPECT_EQ(hanging.world.state_hash(), then);
    World other = World::create({.threads = 1}).value();
    for (const std::uint32_t side : {sides[0], sides[1]}) (void)other.add_cloth(curtain(side)).value();
    const auto answer = other.restore(saved);
    ASSERT_FALSE(answer);
    EXPECT_NE(answer.error().message.find("1 garments with levels, this one has 0"), std::string::npos)
        << answer.error().message;
}

TEST(GarmentLevels, AReplayMakesTheSameChoices) {
    std::vector<std::byte> recorded;
    World world = World::create({.threads = 1, .budget = 0.3f}).value();
    ASSERT_TRUE(world.start_recording({[](void* to, std::span<const std::byte> more) {
                                           auto& all = *static_cast<std::vector<std::byte>*>(to);
                                           all.insert(all.end(), more.begin(), more.end());
                                           return true;
                                       },
                                       &recorded}));
    std::vector<ClothId> finest;
    for (int g = 0; g < 3; ++g)
        for (const std::uint32_t side : {17u, 9u}) {
            const ClothId cloth = world.add_cloth(curtain(side, static_cast<float>(g))).value();
            ASSERT_TRUE(world.pin(cloth, 0));
            if (side == 17) finest.push_back(cloth);
            if (side == 9) {
                ASSERT_TRUE(world.add_level(finest.back(), cloth));
            }
        }
    int changes = 0;
    for (int s = 0; s < 400; ++s) {
        WorldSettings settings = world.settings();
        settings.budget = s / 100 % 2 == 0 ? 1e-4f : 100;
        ASSERT_TRUE(world.set_settings(settings));
        const std::uint32_t before = world.level(finest[1]).value();
        if (s == 250) {
            ASSERT_TRUE(world.set_level(finest[2], 1));
        }
        world.step(h);
        changes += world.level(finest[1]).value() != before ? 1 : 0;
    }
    EXPECT_GE(changes, 3);
    EXPECT_EQ(world.level(finest[2]).value(), 1u);
    ASSERT_TRUE(world.stop_recording());
    for (const int threads : {1, 3}) {
        const auto replayed = replay(recorded, {.threads = threads});
        ASSERT_TRUE(replayed) << replayed.error().message;
        EXPECT_FALSE(replayed->difference) << "step " << replayed->difference->step;
        EXPECT_EQ(replayed->steps, 400u);
    }
}

TEST(GarmentLevels, OneThatIsOffStaysOff) {
    Hanging hanging;
    ASSERT_TRUE(hanging.world.set_enabled(hanging.cloths[0], false));
    ASSERT_TRUE(hanging.world.set_level(hanging.cloths[0], 1));
    hanging.run(1);
    EXPECT_EQ(hanging.world.report().cloths, 0u);
    ASSERT_TRUE(hanging.world.set_enabled(hanging.cloths[1], true));
    hanging.run(1);
    EXPECT_EQ(hanging.world.report().cloths, 1u);
}

TEST(GarmentLevels, EndWithTheirMeshes) {
    for (const bool cut : {false, true}) {
        Hanging hanging;
        const ClothId third = hanging.world.add_cloth(curtain(9)).value();
        ASSERT_TRUE(hanging.world.add_level(hanging.cloths[0], third));
        ASSERT_TRUE(hanging.world.set_level(hanging.cloths[0], 2));
        const Mesh mesh = curtain(17);
        if (cut) {
            const MeshCut slit = cut_mesh(mesh, std::vector<MeshEdge>{{8, 25}, {25, 42}}).value();
            ASSERT_TRUE(hanging.world.recut_cloth(hanging.cloths[1], slit.mesh, slit.from));
        } else {
            ASSERT_TRUE(hanging.world.remove_cloth(hanging.cloths[1]));
        }
        EXPECT_EQ(hanging.world.level(third).value(), 0u);
        EXPECT_FALSE(hanging.world.set_level(third, 1));
        EXPECT_FALSE(hanging.world.set_level(hanging.cloths[0], 1));
        hanging.run(2);
        EXPECT_EQ(hanging.world.report().flags, StepFlags::none);
    }
}

/// The garment is not lost with the mesh that is stepped.
TEST(GarmentLevels, TheNextFinerTakesOverFromOneThatIsRemoved) {
    Hanging hanging;
    const ClothId third = hanging.world.add_cloth(curtain(9)).value();
    ASSERT_TRUE(hanging.world.pin(third, upper_edge(9)));
    ASSERT_TRUE(hanging.world.add_level(hanging.cloths[0], third));
    ASSERT_TRUE(hanging.world.set_level(hanging.cloths[0], 2));
    hanging.run(30);
    const float out = hanging.world.cloth(third)->bounds.upper.z;
    ASSERT_GT(out, 0.05f);
    ASSERT_TRUE(hanging.world.remove_cloth(third));
    for (const std::size_t left : {1u, 0u}) {
        EXPECT_TRUE(hanging.world.cloth_settings(hanging.cloths[left])->enabled);
        EXPECT_NEAR(hanging.world.cloth(hanging.cloths[left])->bounds.upper.z, out, 0.02f);
        if (left == 1) {
            EXPECT_EQ(hanging.level(), 1u);
            ASSERT_TRUE(hanging.world.remove_cloth(hanging.cloths[1]));
        }
    }
    hanging.run(1);
    EXPECT_EQ(hanging.world.report().cloths, 1u);
}

TEST(GarmentLevels, ErrorsNameWhatIsWrongAndChangeNothing) {
    Hanging hanging;
    World& world = hanging.world;
    const auto [fine, coarse] = hanging.cloths;
    const ClothId far_away = world.add_cloth(curtain(9, 5)).value(),
                  same = world.add_cloth(curtain(17)).value();
    const ClothId sewn = world.add_cloth(curtain(9)).value(), other = world.add_cloth(curtain(5)).value();
    ASSERT_TRUE(world.stitch(sewn, std::vector<std::uint32_t>{0}, other, std::vector<std::uint32_t>{0}));
    const std::uint64_t before = world.state_hash();
    const auto says = [&](const Result<void>& answer, const char* what) {
        ASSERT_FALSE(answer) << what;
        EXPECT_NE(answer.error().message.find(what), std::string::npos) << answer.error().message;
    };
    says(world.add_level({}, coarse), "ClothId is null");
    says(world.add_level(fine, {}), "ClothId is null");
    says(world.add_level(fine, fine), "no level of itself");
    says(world.add_level(far_away, coarse), "a level of a garment already");
    says(world.add_level(coarse, far_away), "level 1 of its garment; name the finest");
    says(world.add_level(fine, same), "289 particles; the level above it has 289");
    says(world.add_level(fine, far_away), "81 of the 81 vertices");
    says(world.add_level(fine, sewn), "seams");
    says(world.add_level(fine, far_away, -1), "DrawnMeshSettings::reach");
    says(world.set_level(fine, 2), "below the number of the garment's levels, 2");
    says(world.set_level(far_away, 1), "below the number of the garment's levels, 1");
    says(world.set_enabled(coarse, true), "level 1 of a garment, which is at level 0; call set_level");
    ClothSettings on = world.cloth_settings(coarse).value();
    on.enabled = true;
    says(world.set_cloth_settings(coarse, on), "call set_level");
    const auto seam =
        world.stitch(fine, std::vector<std::uint32_t>{0}, far_away, std::vector<std::uint32_t>{0});
    ASSERT_FALSE(seam);
    EXPECT_NE(seam.error().message.find("a level of a garment"), std::string::npos);
    EXPECT_EQ(world.state_hash(), before);
    EXPECT_TRUE(world.set_level(far_away, 0));
    EXPECT_FALSE(world.level({}));
}

}  // namespace
}  // namespace weft::test::garments
