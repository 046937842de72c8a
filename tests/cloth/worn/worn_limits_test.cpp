// Leashes and backstops: exact at the end of every step, whatever moves; what hangs from them hangs; and
// nothing trembles.

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <string>

#include "tests/cloth/worn/worn.h"

namespace weft::test::worn {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// A skin: the sheet as it starts, moved rigidly.
struct Skin {
    std::vector<Vec3> rest, places, normals;
    Vector3 normal;

    Skin(const Mesh& mesh, const Vector3& n)
        : rest(mesh.positions), places(rest), normals(rest.size(), to_vec3(n)), normal(n) {}
    void move(const RigidMotion& to) {
        for (std::size_t v = 0; v < rest.size(); ++v) places[v] = to.point(rest[v]);
        std::ranges::fill(normals, to_vec3(to.vector(normal)));
    }
};

struct Limits {
    std::vector<float> leash, backstop, radius;
};

/// The farthest that a free particle is beyond its limits, in double precision [m].
double farthest_beyond(const ClothView& view, const Skin& skin, const Limits& limits) {
    double most = -1;
    for (std::size_t v = 0; v < skin.places.size(); ++v) {
        const Vec4& at = view.positions[view.vertex_to_particle[v]];
        if (at.w == 0) continue;
        const Eigen::Vector3d p = to_vector(skin.places[v]).cast<double>(),
                              n = to_vector(skin.normals[v]).cast<double>().normalized(),
                              x = xyz(at).cast<double>();
        const auto leash = static_cast<double>(limits.leash[v]),
                   offset = static_cast<double>(limits.backstop[v]),
                   radius = static_cast<double>(limits.radius[v]);
        most = std::max(most, (x - p).norm() - leash);
        if (std::isinf(offset)) continue;
        most = std::max(most, std::isinf(radius) ? -(n.dot(x - p) + offset)
                                                 : radius - (x - (p - (offset + radius) * n)).norm());
    }
    return most;
}

/// All kinds of limits at random, some of them none.
Limits random_limits(std::size_t vertices) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> unit(0, 1);
    Limits limits;
    for (std::size_t v = 0; v < vertices; ++v) {
        const float kind = unit(random);
        limits.leash.push_back(kind < 0.2f ? infinity : kind < 0.25f ? 0 : 0.06f * unit(random));
        const float least = std::isinf(limits.leash[v]) ? 0.02f : limits.leash[v];
        limits.backstop.push_back(unit(random) < 0.2f ? infinity : (1.5f * unit(random) - 0.9f) * least);
        limits.radius.push_back(unit(random) < 0.3f ? infinity : 0.01f + 20 * unit(random) * unit(random));
    }
    return limits;
}

void set_limits(World& world, ClothId cloth, const Limits& limits) {
    ASSERT_TRUE(world.set_map(cloth, Map::leash, limits.leash));
    ASSERT_TRUE(world.set_map(cloth, Map::backstop, limits.backstop));
    ASSERT_TRUE(world.set_map(cloth, Map::backstop_radius, limits.radius));
}

struct LimitsCase {
    std::string name;
    ClothSettings settings;
};
void PrintTo(const LimitsCase& of, std::ostream* out) {
    *out << of.name;
}
std::vector<LimitsCase> limits_cases() {
    std::vector<LimitsCase> result;
    const auto add = [&](const char* name, const auto& change) {
        change(result.emplace_back(LimitsCase{name, {}}).settings);
    };
    add("Default", [](ClothSettings&) {});
    add("Substeps", [](ClothSettings& s) { s.substeps = 3; });
    add("Jacobi", [](ClothSettings& s) { s.method = Jacobi{}; });
    add("Xpbd", [](ClothSettings& s) { s.method = Xpbd{}; });
    add("Elements", [](ClothSettings& s) { s.finite_elements.enabled = true; });
    add("Explicit", [](ClothSettings& s) {
        s.method = SymplecticEuler{};
        s.substeps = 32;
    });
    return result;
}

class WornBy : public testing::TestWithParam<LimitsCase> {};
INSTANTIATE_TEST_SUITE_P(, WornBy, testing::ValuesIn(limits_cases()),
                         [](const auto& info) { return info.param.name; });

TEST_P(WornBy, HoldExactlyHoweverTheSkinMoves) {
    World world = World::create(vacuum(downwards)).value();
    const Mesh mesh = hanging(11, 10);
    const ClothId cloth = world.add_cloth(mesh, GetParam().settings).value();
    const Limits limits = random_limits(mesh.positions.size());
    set_limits(world, cloth, limits);
    ASSERT_TRUE(world.pin(cloth, 0));
    ASSERT_TRUE(world.add_collider({.shape = Sphere{{0, 0.55f, 0.3f}, 0.1f}}));
    Skin skin(mesh, Vector3(0, 0.6f, 0.8f));
    for (int k = 0; k <= 40; ++k) {
        const float t = h * static_cast<float>(k);
        skin.move(rigid_motion({.translation = {0.5f * t, 0.1f * std::sin(9 * t), 0},
                                .rotation = turn({1, 1, 0}, 2 * static_cast<double>(t))}));
        ASSERT_TRUE(world.set_skin(cloth, skin.places, skin.normals));
        EXPECT_FALSE(has(world.step(h).flags, StepFlags::state_restored));
        ASSERT_LT(farthest_beyond(*world.cloth(cloth), skin, limits), 1e-6) << "step " << k;
        EXPECT_EQ(world.report().limits_exceeded, 0u);
    }
}

/// Mean over particles and steps of what velocities change by [m/s^2].
float mean_acceleration(World& world, ClothId cloth, int steps) {
    std::vector<Vector3> before;
    double sum = 0;
    std::size_t count = 0;
    for (int k = 0; k < steps; ++k) {
        std::vector<Vector3> now;
        for (const Vec4& v : world.cloth(cloth)->velocities) now.push_back(xyz(v));
        for (std::size_t i = 0; i < before.size(); ++i) {
            sum += static_cast<double>((now[i] - before[i]).norm() / h);
            ++count;
        }
        before = now;
        world.step(h);
    }
    return static_cast<float>(sum / static_cast<double>(count));
}

// A sheet that hangs by the leashes of one row: those above lie on the others' places, and below hangs cloth,
// as from pins.
TEST_P(WornBy, ClothHangsFromLeashesAtRest) {
    // Others have no limits in their equation.
    if (GetParam().name == "Xpbd" || GetParam().name == "Explicit") GTEST_SKIP();
    World world = World::create(vacuum(downwards)).value();
    const Mesh mesh =
        make_sheet({.rows = 12, .columns = 8, .origin = {0, 1, 0}, .u = {0.35f, 0, 0}, .v = {0, -0.55f, 0}})
            .value();
    ClothSettings settings = GetParam().settings;
    settings.air_damping = 3;
    settings.fabric.warp = settings.fabric.weft = 2000;
    const ClothId cloth = world.add_cloth(mesh, settings).value();
    std::vector<float> leash(mesh.positions.size(), infinity);
    for (std::size_t v = 0; v < 8; ++v) leash[v] = 0.02f;
    ASSERT_TRUE(world.set_map(cloth, Map::leash, leash));
    ASSERT_TRUE(world.set_skin(cloth, mesh.positions, {}));
    const std::vector<Vector3> rest = places_of(world, cloth);
    for (int k = 0; k < 240; ++k) world.step(h);
    const float trembling = mean_acceleration(world, cloth, 30);
    EXPECT_LT(trembling, 0.1f);
    RecordProperty("acceleration", std::to_string(trembling));
    if (GetParam().name == "Jacobi") return;  // it leaves cloth soft, pinned or not
    EXPECT_LT(largest_strain(*world.cloth(cloth), rest), 0.03f);
    for (std::size_t v = 0; v < 8; ++v)
        EXPECT_NEAR(world.cloth(cloth)->positions[v].y, 0.98f, 0.002f) << "taut, downwards";
}

TEST_P(WornBy, ClothLiesStillOnItsBackstop) {
    for (const float radius : {infinity, 1.0f}) {
        World world = World::create(vacuum(downwards)).value();
        const Mesh mesh = sheet(10, 10);
        ClothSettings settings = GetParam().settings;
        settings.air_damping = 3;
        const ClothId cloth = world.add_cloth(mesh, settings).value();
        const std::size_t n = mesh.positions.size();
        ASSERT_TRUE(world.set_map(cloth, Map::backstop, std::vector<float>(n, 0.01f)));
        ASSERT_TRUE(world.set_map(cloth, Map::backstop_radius, std::vector<float>(n, radius)));
        ASSERT_TRUE(world.set_map(cloth, Map::leash, std::vector<float>(n, 0.05f)));
        const Skin skin(mesh, Vector3(0, 1, 0));
        ASSERT_TRUE(world.set_skin(cloth, skin.places, skin.normals));
        for (int k = 0; k < 120; ++k) world.step(h);
        EXPECT_LT(mean_acceleration(world, cloth, 30), 0.1f) << radius;
        for (const Vec4& x : world.cloth(cloth)->positions) {
            EXPECT_NEAR(x.y, -0.01f, 2e-3f);
            EXPECT_GT(x.y, -0.01001f);
        }
    }
}

// What is at its limit goes with the skin and not farther out: no velocity is left that the next step would
// have to take.
TEST(WornLimits, LeaveNoVelocityOutOfThem) {
    World world = World::create(vacuum(downwards)).value();
    const Mesh mesh = sheet(6, 6);
    const ClothId cloth = world.add_cloth(mesh).value();
    ASSERT_TRUE(world.set_map(cloth, Map::leash, std::vector<float>(36, 0.03f)));
    Skin skin(mesh, Vector3(0, 1, 0));
    for (int k = 0; k < 40; ++k) {
        skin.move({.shift = {0, 0.02 * k, 0}});
        ASSERT_TRUE(world.set_skin(cloth, skin.places, skin.normals));
        world.step(h);
    }
    int at_limit = 0;
    const ClothView view = *world.cloth(cloth);
    for (std::size_t v = 0; v < 36; ++v) {
        const Vector3 y = xyz(view.positions[v]) - to_vector(skin.places[v]);
        if (y.norm() < 0.0299f) continue;
        ++at_limit;
        const Vector3 relative = xyz(view.velocities[v]) - Vector3(0, 0.02f / h, 0);
        EXPECT_LT(y.normalized().dot(relative), 1e-3f);
        EXPECT_NEAR(view.velocities[v].y, 1.2f, 0.05f);
    }
    EXPECT_GT(at_limit, 30);
}

// The skin is below pinned cloth, and the leashes want a second sheet there: cloth has the last word, and the
// report says by how much.
TEST(WornLimits, YieldToClothAndSaySo) {
    World world = World::create(vacuum()).value();
    ClothSettings settings;
    settings.self_collision = {.method = SelfCollisionMethod::contact};
    const ClothId below = world.add_cloth(sheet(12, 12), settings).value();
    std::vector<std::uint32_t> all(144);
    for (std::uint32_t v = 0; v < 144; ++v) all[v] = v;
    ASSERT_TRUE(world.pin(below, all));
    const Mesh mesh =
        make_sheet(
            {.rows = 6, .columns = 6, .origin = {-0.2f, 0.1f, -0.2f}, .u = {0.4f, 0, 0}, .v = {0, 0, 0.4f}})
            .value();
    const ClothId above = world.add_cloth(mesh, settings).value();
    ASSERT_TRUE(world.set_map(above, Map::leash, std::vector<float>(36, 0.01f)));
    Skin skin(mesh, Vector3(0, 1, 0));
    for (int k = 0; k < 30; ++k) {
        skin.move({.shift = {0, -0.01 * std::min(k, 20), 0}});
        ASSERT_TRUE(world.set_skin(above, skin.places, skin.normals));
        const StepReport& report = world.step(h);
        EXPECT_EQ(report.crossings, 0u);
        EXPECT_FALSE(has(report.flags, StepFlags::crossed));
    }
    EXPECT_GT(world.report().limits_exceeded, 30u);
    EXPECT_NEAR(world.report().limit_lag, 0.09f, 0.03f);
    ASSERT_TRUE(world.move_cloth(above, {}));  // what is moved is looked at for crossings
    EXPECT_EQ(world.step(h).crossings, 0u);
}

// What a limit holds does not press on the collider that is nearest to it.
TEST(WornLimits, AreNoContactsOfColliders) {
    WorldSettings settings = vacuum(downwards);
    settings.contact_reports = 1000;
    World world = World::create(settings).value();
    const Mesh mesh = sheet(6, 6);
    const ClothId cloth = world.add_cloth(mesh).value();
    ASSERT_TRUE(world.add_collider({.shape = Plane{{0, 1, 0}, -1}}));
    ASSERT_TRUE(world.set_map(cloth, Map::backstop, std::vector<float>(36, 0.01f)));
    const Skin skin(mesh, Vector3(0, 1, 0));
    ASSERT_TRUE(world.set_skin(cloth, skin.places, skin.normals));
    for (int k = 0; k < 60; ++k) {
        world.step(h);
        EXPECT_EQ(world.contacts().size(), 0u) << "step " << k;
    }
    EXPECT_NEAR(world.cloth(cloth)->positions[14].y, -0.01f, 1e-3f);
}

TEST(WornLimits, AreNoneBeforeTheSkinIsKnownAndOnceTheMapsAreGone) {
    World world = World::create(vacuum(downwards)).value(), free = World::create(vacuum(downwards)).value();
    const Mesh mesh = sheet(5, 5);
    const ClothId cloth = world.add_cloth(mesh).value(), other = free.add_cloth(mesh).value();
    const ClothInfo before = world.cloth_info(cloth).value();
    ASSERT_TRUE(world.set_map(cloth, Map::leash, std::vector<float>(25, 0.0f)));
    EXPECT_GT(world.cloth_info(cloth)->bytes, before.bytes);
    const auto step = [&] {
        world.step(h);
        free.step(h);
        EXPECT_LT(farthest(places_of(world, cloth), {}, places_of(free, other)), 1e-6f);
    };
    step();
    ASSERT_TRUE(world.set_map(cloth, Map::leash, {}));
    EXPECT_EQ(world.cloth_info(cloth).value(), before);
    step();
    EXPECT_FALSE(world.set_skin(cloth, mesh.positions, {}));
}

TEST(WornLimits, ErrorsNameTheVertex) {
    World world = World::create(vacuum()).value();
    const Mesh mesh = sheet(4, 4);
    const ClothId cloth = world.add_cloth(mesh).value();
    const auto message = [](const Result<void>& result) {
        EXPECT_FALSE(result);
        return result ? std::string() : result.error().message;
    };
    std::vector<float> leash(16, 0.1f), backstop(16, 0.0f);
    EXPECT_NE(message(world.set_skin(cloth, mesh.positions, {})).find("Map::leash"), std::string::npos);
    leash[3] = -1;
    EXPECT_NE(message(world.set_map(cloth, Map::leash, leash)).find("Map::leash[3] is -1"),
              std::string::npos);
    leash[3] = 0.1f;
    ASSERT_TRUE(world.set_map(cloth, Map::leash, leash));
    backstop[7] = -0.2f;
    EXPECT_NE(message(world.set_map(cloth, Map::backstop, backstop)).find("vertex 7 is -0.2"),
              std::string::npos);
    backstop[7] = 0;
    ASSERT_TRUE(world.set_map(cloth, Map::backstop, backstop));
    const std::uint64_t before = world.state_hash();
    std::vector<Vec3> places = mesh.positions, normals(16, Vec3{0, 2, 0});
    EXPECT_NE(message(world.set_skin(cloth, places, {})).find("16 places and 0 normals"), std::string::npos);
    places[5].y = infinity;
    EXPECT_NE(message(world.set_skin(cloth, places, normals)).find("place of vertex 5"), std::string::npos);
    places[5].y = 0;
    normals[9] = {};
    EXPECT_NE(message(world.set_skin(cloth, places, normals)).find("normal of vertex 9"), std::string::npos);
    normals[9] = {0, 1, 0};
    EXPECT_EQ(world.state_hash(), before);
    EXPECT_TRUE(world.set_skin(cloth, places, normals));
    EXPECT_FALSE(world.set_map(cloth, static_cast<Map>(99), leash));
    EXPECT_FALSE(world.set_map({}, Map::leash, leash));
}

}  // namespace
}  // namespace weft::test::worn
