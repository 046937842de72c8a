// A cloth that is reset begins from rest in its pose, whatever it did before.

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "tests/cloth/meshes.h"
#include "tests/cloth/worn/worn.h"

namespace weft::test::worn {
namespace {

struct ResetCase {
    std::string name;
    ClothSettings settings;
};
void PrintTo(const ResetCase& of, std::ostream* out) {
    *out << of.name;
}

std::vector<ResetCase> reset_cases() {
    std::vector<ResetCase> result;
    const auto add = [&](const char* name, const auto& change) {
        change(result.emplace_back(ResetCase{name, {}}).settings);
    };
    add("Default", [](ClothSettings&) {});
    add("BackwardEuler", [](ClothSettings& s) { s.time_scheme = TimeScheme::backward_euler; });
    add("Tethers", [](ClothSettings& s) { s.tethers.enabled = true; });
    add("Contact", [](ClothSettings& s) { s.self_collision = {.method = SelfCollisionMethod::contact}; });
    add("Xpbd", [](ClothSettings& s) { s.method = Xpbd{}; });
    add("Sleeping", [](ClothSettings& s) { s.sleep_speed = 100; });
    return result;
}

std::vector<Vec3> pose_of(const Mesh& mesh, const Transform& by) {
    std::vector<Vec3> positions;
    for (const Vec3& x : mesh.positions) positions.push_back(rigid_motion(by).point(x));
    return positions;
}

double kinetic_energy(const World& world, ClothId cloth) {
    double energy = 0;
    const ClothView view = *world.cloth(cloth);
    for (std::size_t i = 0; i < view.positions.size(); ++i)
        if (view.positions[i].w > 0)
            energy += 0.5 * static_cast<double>(xyz(view.velocities[i]).squaredNorm() / view.positions[i].w);
    return energy;
}

/// A sheet that hangs from two corners, and swings against a ball.
struct PushedSwing {
    explicit PushedSwing(const ClothSettings& settings) : world(World::create(vacuum(downwards)).value()) {
        cloth = world.add_cloth(mesh, settings).value();
        EXPECT_TRUE(world.pin(cloth, std::vector<std::uint32_t>{0, 11}));
        EXPECT_TRUE(
            world.add_collider({.shape = Sphere{{0.04f, 0.25f, 0.1f}, 0.15f}, .friction = 0.5f}).ok());
    }
    void run(int steps) {
        for (int k = 0; k < steps; ++k) {
            const float way = 0.1f * std::sin(5 * h * static_cast<float>(k + 1));
            for (const std::uint32_t v : {0u, 11u})
                EXPECT_TRUE(world.move_pin(cloth, v, {v == 0 ? -0.3f : 0.3f, 0.6f, way}));
            world.step(h);
        }
    }
    [[nodiscard]] std::vector<Vec4> positions() const {
        const auto view = world.cloth(cloth)->positions;
        return {view.begin(), view.end()};
    }

    Mesh mesh = hanging(13, 12);
    World world;
    ClothId cloth;
};

const Transform far_off{.translation = {12, 3, -16}, .rotation = turn({0, 1, 0}, 2.2)};

class ResetCloth : public testing::TestWithParam<ResetCase> {};
INSTANTIATE_TEST_SUITE_P(, ResetCloth, testing::ValuesIn(reset_cases()),
                         [](const auto& info) { return info.param.name; });

TEST_P(ResetCloth, BeginsFromRestThere) {
    PushedSwing swing(GetParam().settings);
    swing.run(40);
    const std::vector<Vec3> pose = pose_of(swing.mesh, far_off);
    ASSERT_TRUE(swing.world.reset_cloth(swing.cloth, pose));
    EXPECT_FALSE(*swing.world.is_asleep(swing.cloth));
    const ClothView there = *swing.world.cloth(swing.cloth);
    for (std::size_t v = 0; v < pose.size(); ++v) {
        const std::uint32_t i = there.vertex_to_particle[v];
        EXPECT_EQ(xyz(there.positions[i]), to_vector(pose[v]));
        EXPECT_EQ(xyz(there.previous_positions[i]), to_vector(pose[v])) << "a blend shows no path";
        EXPECT_EQ(xyz(there.velocities[i]), Vector3::Zero());
    }

    World fresh = World::create(vacuum(downwards)).value();
    Mesh mesh = swing.mesh;
    mesh.positions = pose;
    const ClothId other = fresh.add_cloth(mesh, GetParam().settings).value();
    ASSERT_TRUE(fresh.pin(other, std::vector<std::uint32_t>{0, 11}));
    for (int k = 0; k < 5; ++k) {
        const StepReport& report = swing.world.step(h);
        EXPECT_EQ(report.flags, StepFlags::none);
        EXPECT_EQ(report.crossings, 0u);
        fresh.step(h);
        const double expected = kinetic_energy(fresh, other);
        EXPECT_NEAR(kinetic_energy(swing.world, swing.cloth), expected, 0.01 * expected) << "step " << k + 1;
    }
    const ClothView after = *swing.world.cloth(swing.cloth);
    for (const std::uint32_t v : {0u, 11u})
        EXPECT_EQ(xyz(after.positions[after.vertex_to_particle[v]]), to_vector(pose[v])) << "a pin";
}

TEST_P(ResetCloth, ForgetsWhatWasBefore) {
    PushedSwing one(GetParam().settings), other(GetParam().settings);
    one.run(40);
    other.run(13);
    for (PushedSwing* swing : {&one, &other}) {
        ASSERT_TRUE(swing->world.reset_cloth(swing->cloth, swing->mesh.positions));
        swing->run(30);
    }
    EXPECT_TRUE(same_bytes(one.positions(), other.positions()));
}

// Crumpled on the ground, it is put back where it came from: no tangle is left over, and none arises.
TEST(ResetClothTo, APoseThatDoesNotCrossNeverCrosses) {
    World world = World::create({}).value();
    const Mesh mesh = hanging(20, 20, 0.5f);
    const ClothId cloth =
        world.add_cloth(mesh, {.self_collision = {.method = SelfCollisionMethod::contact}}).value();
    ASSERT_TRUE(world.add_collider({.shape = Plane{{0, 1, 0}, 0}, .friction = 0.3f}).ok());
    for (int round = 0; round < 2; ++round) {
        for (int k = 0; k < 60; ++k) {
            const StepReport& report = world.step(h);
            EXPECT_EQ(report.crossings, 0u);
            EXPECT_FALSE(has(report.flags, StepFlags::crossed));
        }
        ASSERT_TRUE(world.reset_cloth(cloth, pose_of(mesh, {.rotation = turn({1, 0, 0}, 1.5)})));
    }
}

TEST(ResetClothTo, APlaceInAColliderComesOutOfItSlowly) {
    World world = World::create(vacuum({})).value();
    const Mesh mesh = hanging(16, 16, 0.4f);
    const ClothId cloth = world.add_cloth(mesh).value();
    ASSERT_TRUE(world.add_collider({.shape = Sphere{{20, 0.1f, 0.2f}, 0.15f}}).ok());
    world.step(h);
    ASSERT_TRUE(world.reset_cloth(cloth, pose_of(mesh, {.translation = {20, -0.25f, 0}})));
    for (int k = 0; k < 120; ++k) {
        const StepReport& report = world.step(h);
        EXPECT_LT(report.peak_speed, 1) << "0.15 m within a step would be 9 m/s";
        EXPECT_FALSE(has(report.flags, StepFlags::state_restored));
    }
    for (const Vec4& x : world.cloth(cloth)->positions)
        EXPECT_GT((xyz(x) - Vector3(20, 0.1f, 0.2f)).norm(), 0.15f);
}

// The frame and the skin that the host has set for this step are where they are.
TEST(ResetClothTo, TheFramesNewPlaceIsNotCarriedThereAgain) {
    World world = World::create(vacuum({})).value();
    const Mesh mesh = hanging(8, 8);
    const ClothId cloth = world.add_cloth(mesh, {.frame_inertia = {0, 0, 0}}).value();
    const std::vector<float> leash(mesh.positions.size(), 0.05f);
    ASSERT_TRUE(world.set_map(cloth, Map::leash, leash));
    ASSERT_TRUE(world.set_frame(cloth, {}));
    ASSERT_TRUE(world.set_skin(cloth, mesh.positions, {}));
    world.step(h);
    const std::vector<Vec3> pose = pose_of(mesh, far_off);
    ASSERT_TRUE(world.set_frame(cloth, far_off));
    ASSERT_TRUE(world.set_skin(cloth, pose, {}));
    ASSERT_TRUE(world.reset_cloth(cloth, pose));
    world.step(h);
    EXPECT_LT(world.report().peak_speed, 1e-3f);
    const ClothView view = *world.cloth(cloth);
    for (std::size_t v = 0; v < pose.size(); ++v)
        EXPECT_LT((xyz(view.positions[view.vertex_to_particle[v]]) - to_vector(pose[v])).norm(), 1e-4f);
}

TEST(ResetClothTo, TakesTheLastOfWeldedVertices) {
    World world = World::create({}).value();
    const Mesh mesh = tube(6, 8);
    const ClothId cloth = world.add_cloth(mesh).value();
    std::vector<Vec3> pose = mesh.positions;
    const ClothView view = *world.cloth(cloth);
    std::vector<std::size_t> last(view.positions.size());
    for (std::size_t v = 0; v < pose.size(); ++v) {
        pose[v].x += 0.001f * static_cast<float>(v);
        last[view.vertex_to_particle[v]] = v;
    }
    ASSERT_LT(view.positions.size(), pose.size());
    ASSERT_TRUE(world.reset_cloth(cloth, pose));
    for (std::size_t i = 0; i < last.size(); ++i)
        EXPECT_EQ(xyz(world.cloth(cloth)->positions[i]), to_vector(pose[last[i]]));
}

TEST(ResetClothTo, NamesWhatIsWrongAndChangesNothing) {
    PushedSwing swing({});
    swing.run(5);
    const std::uint64_t before = swing.world.state_hash();
    const auto refused = [&](ClothId id, const std::vector<Vec3>& pose, const char* words) {
        const auto answer = swing.world.reset_cloth(id, pose);
        ASSERT_FALSE(answer);
        EXPECT_NE(answer.error().message.find(words), std::string::npos) << answer.error().message;
        EXPECT_EQ(swing.world.state_hash(), before);
    };
    std::vector<Vec3> pose = swing.mesh.positions;
    refused({}, pose, "ClothId is null");
    pose[7].y = std::numeric_limits<float>::quiet_NaN();
    refused(swing.cloth, pose, "the position of vertex 7");
    pose[7].y = 2e5f;
    refused(swing.cloth, pose, "the position of vertex 7");
    pose.pop_back();
    refused(swing.cloth, pose, "155 positions; the mesh has 156 vertices");
}

}  // namespace
}  // namespace weft::test::worn
