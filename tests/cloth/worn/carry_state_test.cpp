// A garment of two simulated meshes, between which a World changes from step to step.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/vector.h"
#include "weft/drawn_mesh.h"
#include "weft/world.h"

namespace weft {
namespace {

constexpr float h = 1.0f / 60;

Mesh sheet(std::uint32_t side) {
    return *make_sheet(
        {.rows = side, .columns = side, .origin = {-0.5f, 0, 0}, .u = {1, 0, 0}, .v = {0, -1, 0}});
}

/// A curtain that hangs by its upper edge in wind, as a fine and as a coarse mesh, and a finer one that is
/// drawn.
struct Curtain {
    explicit Curtain(float wind = 3, float gust = 0) {
        WorldSettings settings{.threads = 1};
        settings.wind.velocity = {1, 0, wind};
        settings.wind.gust = gust;
        EXPECT_TRUE(world.set_settings(settings));
        for (std::size_t k = 0; k < 2; ++k) {
            meshes[k] = sheet(k == 0 ? 41 : 21);
            ClothSettings of;
            of.enabled = k == 0;
            cloths[k] = *world.add_cloth(meshes[k], of);
            for (std::uint32_t v = 0; v < (k == 0 ? 41u : 21u); ++v) EXPECT_TRUE(world.pin(cloths[k], v));
        }
        const Mesh fine = sheet(121);
        for (std::size_t k = 0; k < 2; ++k) {
            drawn.push_back(bound(k, fine));
            carriers.push_back(bound(k, meshes[1 - k]));  // from cloth k to the other
        }
    }
    DrawnMesh bound(std::size_t to, const Mesh& mesh) {
        return *DrawnMesh::bind(*world.cloth(cloths[to]),
                                {.vertices = mesh.positions, .triangles = mesh.triangles});
    }
    void run(int steps) {
        for (int step = 0; step < steps; ++step) world.step(h);
    }
    void change(std::size_t to) {
        ASSERT_TRUE(world.set_enabled(cloths[to], true));
        const auto done = carry_state(world, cloths[1 - to], cloths[to], carriers[1 - to]);
        ASSERT_TRUE(done.ok()) << done.error().message;
        ASSERT_TRUE(world.set_enabled(cloths[1 - to], false));
    }
    [[nodiscard]] std::vector<Vector3> picture(std::size_t of) const {
        std::vector<Vec4> places(drawn[of].size());
        drawn[of].update(*world.cloth(cloths[of]), {.positions = places});
        std::vector<Vector3> picture;
        for (const Vec4& p : places) picture.push_back(xyz(p));
        return picture;
    }
    /// The mean velocity of free particles by mass, and the root of the mean square of their speeds [m/s].
    struct Motion {
        Vector3 velocity = Vector3::Zero();
        float speed = 0;
    };
    [[nodiscard]] Motion motion(std::size_t of) const {
        const ClothView view = *world.cloth(cloths[of]);
        Motion motion;
        float all = 0;
        for (std::size_t i = 0; i < view.positions.size(); ++i) {
            if (!(view.positions[i].w > 0)) continue;
            const float mass = 1 / view.positions[i].w;
            all += mass;
            motion.velocity += mass * xyz(view.velocities[i]);
            motion.speed += mass * xyz(view.velocities[i]).squaredNorm();
        }
        return {motion.velocity / all, std::sqrt(motion.speed / all)};
    }

    World world = *World::create({.threads = 1});
    Mesh meshes[2];
    ClothId cloths[2];
    std::vector<DrawnMesh> drawn, carriers;
};

float largest_difference(const std::vector<Vector3>& a, const std::vector<Vector3>& b) {
    float most = 0;
    for (std::size_t v = 0; v < a.size(); ++v) most = std::max(most, (a[v] - b[v]).norm());
    return most;
}

/// The drawn mesh jumps by the folds that the coarse mesh cannot have: little in a breeze, more where fine
/// folds flutter.
TEST(CarryState, TheDrawnMeshHardlyJumps) {
    struct Case {
        float wind, gust, to_coarse, to_fine;  // [m/s], [m]
    };
    for (const Case& of : {Case{3, 0, 0.003f, 0.001f}, Case{6, 0.5f, 0.04f, 0.002f}}) {
        Curtain curtain(of.wind, of.gust);
        curtain.run(40);
        for (const std::size_t to : {1u, 0u}) {  // to the coarse mesh, and back
            const auto before = curtain.picture(1 - to);
            const auto moving = curtain.motion(1 - to);
            curtain.change(to);
            const float jump = largest_difference(before, curtain.picture(to));
            RecordProperty("jump_mm_" + std::to_string(of.wind) + (to == 1 ? "_to_coarse" : "_to_fine"),
                           std::to_string(1e3f * jump));
            EXPECT_LT(jump, to == 1 ? of.to_coarse : of.to_fine);
            const auto moved = curtain.motion(to);
            EXPECT_LT((moved.velocity - moving.velocity).norm(), 0.02f * moving.speed)
                << moving.speed << " m/s, then " << moved.speed;
            EXPECT_GT(moved.speed, 0.9f * moving.speed);
            EXPECT_LT(moved.speed, 1.05f * moving.speed);
            // The step after it is one of the motion.
            const auto at = curtain.picture(to);
            curtain.run(1);
            const float most = h * curtain.world.report().peak_speed;
            EXPECT_LT(largest_difference(at, curtain.picture(to)), 1.5f * most);
            curtain.run(30);
            EXPECT_EQ(curtain.world.report().flags, StepFlags::none);
        }
    }
}

TEST(CarryState, ABlendGoesOn) {
    Curtain curtain;
    curtain.run(40);
    const ClothView old = *curtain.world.cloth(curtain.cloths[0]);
    std::vector<Vec4> before(curtain.drawn[0].size()), after(before.size());
    ClothView start = old;
    start.positions = old.previous_positions;
    curtain.drawn[0].update(start, {.positions = before});
    curtain.change(1);
    const ClothView next = *curtain.world.cloth(curtain.cloths[1]);
    start = next;
    start.positions = next.previous_positions;
    curtain.drawn[1].update(start, {.positions = after});
    float most = 0;
    for (std::size_t v = 0; v < before.size(); ++v)
        most = std::max(most, (xyz(before[v]) - xyz(after[v])).norm());
    EXPECT_LT(most, 0.004f);
}

/// The same mesh takes over: nothing but the equation's memory of the last step is lost.
TEST(CarryState, ToTheSameMeshChangesNothing) {
    auto world = *World::create({.threads = 1});
    const Mesh mesh = sheet(15);
    const ClothId one = *world.add_cloth(mesh), other = *world.add_cloth(mesh);
    const auto bonds = DrawnMesh::bind(*world.cloth(one), {.vertices = mesh.positions}, {.rounding = 0});
    for (const ClothId id : {one, other}) ASSERT_TRUE(world.pin(id, 0));
    for (int step = 0; step < 20; ++step) world.step(h);
    ASSERT_TRUE(world.move_cloth(other, {.translation = {5, 0, 0}}));
    ASSERT_TRUE(carry_state(world, one, other, *bonds));
    const ClothView from = *world.cloth(one), to = *world.cloth(other);
    for (std::size_t i = 0; i < from.positions.size(); ++i) {
        EXPECT_LT((xyz(from.positions[i]) - xyz(to.positions[i])).norm(), 1e-6f);
        EXPECT_LT((xyz(from.previous_positions[i]) - xyz(to.previous_positions[i])).norm(), 1e-6f);
        EXPECT_LT((xyz(from.velocities[i]) - xyz(to.velocities[i])).norm(), 1e-5f);
    }
}

TEST(CarryState, ErrorsNameWhatIsWrong) {
    Curtain curtain;
    const auto refusal = [&](std::size_t from, std::size_t to, const DrawnMesh& bonds) {
        const auto done = carry_state(curtain.world, curtain.cloths[from], curtain.cloths[to], bonds);
        return done.ok() ? std::string() : done.error().message;
    };
    EXPECT_EQ(refusal(0, 1, curtain.carriers[0]), "");
    EXPECT_NE(refusal(1, 0, curtain.carriers[0]).find("another mesh"), std::string::npos);
    EXPECT_NE(refusal(0, 1, curtain.drawn[0]).find("14641 vertices; the mesh of the cloth `to` has 441"),
              std::string::npos);
    const std::vector<Vec3> two(2), all(441, Vec3{1, NAN, 1});
    const auto& places = curtain.meshes[1].positions;
    const auto resumed = [&](const auto& previous, const auto& velocities) {
        const auto done = curtain.world.resume_cloth(curtain.cloths[1], places, previous, velocities);
        return done.ok() ? std::string() : done.error().message;
    };
    EXPECT_NE(resumed(two, places).find("2 previous positions"), std::string::npos);
    EXPECT_NE(resumed(places, two).find("2 velocities"), std::string::npos);
    EXPECT_NE(resumed(places, all).find("the velocity of vertex 0"), std::string::npos);
    ASSERT_TRUE(curtain.world.remove_cloth(curtain.cloths[1]));
    EXPECT_NE(refusal(0, 1, curtain.carriers[0]), "");
}

}  // namespace
}  // namespace weft
