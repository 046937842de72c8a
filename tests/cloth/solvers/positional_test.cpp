// What holds for every positional method: what it converges to, what it keeps, and what it survives.

#include "cloth/methods/positional/xpbd.h"
#include "cloth/solver/make_system.h"

#include <gtest/gtest.h>

#include "positional.h"
#include "tests/cloth/meshes.h"

namespace weft::test {
namespace {

/// |gamma f - M (v - v_base)| of backward Euler at v.
double residual(Cloth& cloth, float h, std::span<const Vec4> velocities, const Vector3& gravity) {
    Parallel serial(1);
    const auto system = make_system(cloth.model, cloth.settings);
    AlignedBuffer<Vec4> left(cloth.model.particle_count);
    system->residual(serial, equation_of(cloth, h, gravity), velocities, left.span());
    return flat(left.span()).norm();
}

// XPBD's fixed point is backward Euler's, spring damping included, but for one thing: each correction goes
// along the springs as they lie in its iteration, where backward Euler pulls along them as they lie at the
// end (the paper takes its g(x, lambda) as 0).
TEST(Positional, ConvergesToBackwardEuler) {
    const Vector3 gravity(0, -9.81f, 0);
    for (const auto& [name, method] : positional_methods(1000)) {
        Cloth cloth = crumpled(sheet(6, 5), 0.02f, 100);
        cloth.settings.fabric.damping = 2e-3f;
        cloth.settings.fabric.bending = 0;  // of which each step takes one iteration
        cloth.pin(0);
        cloth.pin(4);
        const float h = 1.0f / 60;
        const AlignedBuffer<Vec4> change = velocity_change(cloth, method, h);
        AlignedBuffer<Vec4> solved(change.size());
        for (std::size_t i = 0; i < change.size(); ++i)
            solved[i] = to_vec4(xyz(cloth.state.velocities[i]) + xyz(change[i]), 0);
        EXPECT_EQ(xyz(change[0]).norm(), 0) << "pinned";
        EXPECT_LT(residual(cloth, h, solved.span(), gravity),
                  0.01 * residual(cloth, h, cloth.state.velocities.span(), gravity))
            << name;
    }
}

TEST(Positional, IsAsStiffAfterMoreIterations) {
    for (std::size_t m = 0; m < positional_methods(1).size(); ++m) {
        Cloth cloth = crumpled(sheet(6, 5), 0.02f, 100);
        const auto changes = [&](int iterations) {
            return flat(velocity_change(cloth, positional_methods(iterations)[m].second, 1.0f / 60).span());
        };
        const Eigen::VectorXd some = changes(300), more = changes(1500);
        EXPECT_LT((more - some).norm(), 1e-3 * more.norm()) << positional_methods(1)[m].first;
    }
}

TEST(Positional, KeepsLinearMomentum) {
    for (const auto& [name, method] : positional_methods(5)) {
        Cloth cloth = crumpled(sheet(9, 8), 0.05f, 1000);
        const AlignedBuffer<Vec4> change = velocity_change(cloth, method, 1.0f / 60, Vector3::Zero());
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        double total = 0;
        for (std::uint32_t i = 0; i < change.size(); ++i) {
            sum += static_cast<double>(cloth.mass(i)) * xyz(change[i]).cast<double>();
            total += static_cast<double>(cloth.mass(i) * xyz(change[i]).norm());
        }
        EXPECT_GT(total, 0.01);
        EXPECT_LT(sum.norm(), 1e-6 * total) << name;
    }
}

/// A World with one cloth, hung by the first row of a sheet of 0.2 m by 1 m.
struct HungStrip {
    explicit HungStrip(const ClothSettings& settings, int threads = 1) {
        WorldSettings world_settings;
        world_settings.threads = threads;
        world_settings.wind.air_density = 0;
        world = std::make_unique<World>(must(World::create(world_settings)));
        id = must(world->add_cloth(
            must(make_sheet(
                {.rows = rows, .columns = columns, .origin = {0, 0, 0}, .u = {0.2f, 0, 0}, .v = {0, -1, 0}})),
            settings));
        for (std::uint32_t column = 0; column < columns; ++column) must_succeed(world->pin(id, column));
    }
    static void must_succeed(const Result<void>& result) {
        if (!result) give_up(result.error().message);
    }
    [[nodiscard]] std::span<const Vec4> positions() const { return must(world->cloth(id)).positions; }

    static constexpr std::uint32_t rows = 11, columns = 3;
    std::unique_ptr<World> world;
    ClothId id;
};

TEST(Positional, StretchesAHungStripByItsWeightOverStiffnessAndWidthForAnySubsteps) {
    for (const int substeps : {4, 12}) {
        for (const auto& [name, method] : positional_methods(48 / substeps)) {
            ClothSettings settings;
            settings.fabric = {
                .areal_density = 2, .warp = 200, .weft = 200, .shear = 0, .bending = 0, .damping = 5e-3f};
            settings.air_damping = 4;
            settings.method = method;
            settings.substeps = substeps;
            HungStrip strip(settings);
            for (int frame = 0; frame < 150; ++frame) strip.world->step(1.0f / 60);
            // The middle column: each particle weighs a cell; the last one's half cell is below the last
            // edge.
            const float cell = 2 * 0.1f * 0.1f, below = cell * (HungStrip::rows - 2) + cell / 2;
            const auto x = strip.positions();
            const float length = x[1].y - x[1 + HungStrip::columns].y;
            EXPECT_NEAR(length / 0.1f - 1, below * 9.81f / 200 / 0.1f, 0.02f * below * 9.81f / 200 / 0.1f)
                << name << ", " << substeps << " substeps";
        }
    }
}

/// A host's two threads that are one, which takes the blocks last to first.
const Executor backwards{.run =
                             [](void*, std::uint32_t count, Executor::Body body, void* context) {
                                 for (std::uint32_t i = count; i-- > 0;) body(context, i);
                             },
                         .width = 2};

std::uint64_t hash_after_some_frames(const Method& method, int threads, const Executor& executor) {
    WorldSettings world_settings;
    world_settings.threads = threads;
    world_settings.executor = executor;
    World world = must(World::create(world_settings));
    ClothSettings settings;
    settings.method = method;
    settings.tethers.enabled = true;
    const Mesh mesh = joined(loose_sheet(80, 70), sheet(90, 95), {2, 0, 0});
    const ClothId id = must(world.add_cloth(mesh, settings));
    HungStrip::must_succeed(world.pin(id, 3));
    for (int frame = 0; frame < 2; ++frame) world.step(1.0f / 60);
    return world.state_hash();
}

TEST(Positional, HasTheSameBytesForAnyThreads) {
    for (const auto& [name, method] : positional_methods(2)) {
        const std::uint64_t expected = hash_after_some_frames(method, 1, {});
        EXPECT_EQ(hash_after_some_frames(method, 8, {}), expected) << name;
        EXPECT_EQ(hash_after_some_frames(method, 0, backwards), expected) << name;
    }
}

TEST(Positional, PinsGoWhereTheyAreSentAndTheRestFollows) {
    for (const auto& [name, method] : positional_methods(4)) {
        ClothSettings settings;
        settings.method = method;
        settings.substeps = 4;
        HungStrip strip(settings);
        for (int frame = 1; frame <= 60; ++frame) {
            for (std::uint32_t column = 0; column < HungStrip::columns; ++column)
                HungStrip::must_succeed(strip.world->move_pin(
                    strip.id, column,
                    {0.1f * static_cast<float>(column), 0, 0.02f * static_cast<float>(frame)}));
            strip.world->step(1.0f / 60);
        }
        const auto x = strip.positions();
        for (std::uint32_t column = 0; column < HungStrip::columns; ++column)
            EXPECT_LT((xyz(x[column]) - Vector3(0.1f * static_cast<float>(column), 0, 1.2f)).norm(), 1e-6f)
                << name;
        const float last = x[HungStrip::rows * HungStrip::columns - 1].z;
        EXPECT_GT(last, 0.2f) << name;
    }
}

TEST(Positional, PartsCoincidentParticlesTheSameWayAtEveryRun) {
    for (const auto& [name, method] : positional_methods(8)) {
        Cloth cloth = crumpled(sheet(5, 5), 0, 1000);
        for (Vec4& v : cloth.state.velocities.span()) v = {};
        set_xyz(cloth.state.positions[12], xyz(cloth.state.positions[13]));
        const AlignedBuffer<Vec4> change = velocity_change(cloth, method, 1.0f / 60, Vector3::Zero());
        const AlignedBuffer<Vec4> again = velocity_change(cloth, method, 1.0f / 60, Vector3::Zero());
        ASSERT_TRUE(all_finite(change.span())) << name;
        EXPECT_GT((xyz(change[12]) - xyz(change[13])).norm(), 1.0f) << name;
        EXPECT_EQ(flat(change.span()), flat(again.span())) << name;
    }
}

TEST(Positional, OpensACollapsedCloth) {
    for (const auto& [name, method] : positional_methods(4)) {
        Simulation simulation({});
        ClothSettings settings;
        settings.method = method;
        settings.substeps = 8;
        const ClothId id = simulation.add(std::make_unique<Cloth>(must(cook(sheet(9, 9))), settings));
        Cloth& cloth = **simulation.cloths.find(id);
        simulation.settings.gravity = {};
        simulation.prepare(cloth);
        for (Vec4& x : cloth.state.positions.span()) set_xyz(x, Vector3(0.5f, 0.5f, 0.5f));
        for (int frame = 0; frame < 60; ++frame) simulation.step(1.0f / 60);
        ASSERT_TRUE(all_finite(cloth.state.positions.span())) << name;
        double sum = 0, rest = 0;
        for (std::uint32_t i = 0; i < cloth.model.particle_count; ++i) {
            for (std::uint32_t e = cloth.model.spring_offsets[i]; e < cloth.model.spring_offsets[i + 1];
                 ++e) {
                if (cloth.model.kinds[e] != SpringKind::structural) continue;
                sum += static_cast<double>(
                    (xyz(cloth.state.positions[i]) - xyz(cloth.state.positions[cloth.model.neighbours[e]]))
                        .norm());
                rest += static_cast<double>(cloth.model.rest_lengths[e]);
            }
        }
        EXPECT_NEAR(sum / rest, 1, 0.1) << name << ": edges have their lengths again";
    }
}

}  // namespace
}  // namespace weft::test
