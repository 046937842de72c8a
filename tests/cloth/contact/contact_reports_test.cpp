// World::contacts(), as a host reads it: what touched what, where, and with impulses that obey mechanics.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "engine/vector.h"
#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"
#include "weft/weft.h"

namespace weft::test {
namespace {

constexpr float g = 9.81f;
constexpr int room = 1 << 14;

WorldSettings reporting(int reports = room, Vec3 pull = {0, -g, 0}) {
    WorldSettings settings;
    settings.gravity = pull;
    settings.wind.air_density = 0;
    settings.threads = 1;
    settings.contact_reports = reports;
    return settings;
}

ClothSettings undamped(const Method& method = {}, int substeps = 1) {
    ClothSettings settings;
    settings.method = method;
    settings.substeps = substeps;
    settings.air_damping = 0;
    settings.sleep_speed = 0;  // cloth that sleeps reports nothing
    return settings;
}

ClothSettings with_self(SelfCollisionMethod method) {
    ClothSettings settings = undamped();
    settings.self_collision = {.method = method};
    return settings;
}

/// Sums over contacts that `counts` says.
template <class Counts>
Eigen::Vector3d impulse(const World& world, const Counts& counts) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Contact& c : world.contacts())
        if (counts(c)) sum += to_vector(c.impulse).cast<double>();
    return sum;
}
Eigen::Vector3d impulse(const World& world) {
    return impulse(world, [](const Contact&) { return true; });
}
bool is_with_collider(const Contact& c) {
    return c.other_cloth == ClothId{};
}

double mass(const World& world, ClothId id) {
    return static_cast<double>(world.cloth_info(id).value().mass);
}

Eigen::Vector3d momentum(const World& world, ClothId id) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    const ClothView view = world.cloth(id).value();
    for (std::size_t i = 0; i < view.velocities.size(); ++i)
        if (view.positions[i].w > 0)
            sum += xyz(view.velocities[i]).cast<double>() / static_cast<double>(view.positions[i].w);
    return sum;
}

struct NamedCloth {
    const char* name;
    ClothSettings settings;
};
std::vector<NamedCloth> reporting_methods() {
    std::vector<NamedCloth> cases{{"multilevel", undamped()},
                                  {"backward Euler", undamped()},
                                  {"substeps", undamped(Multilevel{}, 3)},
                                  {"jacobi", undamped(Jacobi{.iterations = 100})},
                                  {"conjugate gradients", undamped(ConjugateGradient{.iterations = 60})},
                                  {"elements", undamped()},
                                  {"xpbd", undamped(Xpbd{}, 4)},
                                  {"fibres", undamped(Fibres{}, 4)},
                                  {"symplectic Euler", undamped(SymplecticEuler{}, 40)}};
    cases[1].settings.time_scheme = TimeScheme::backward_euler;
    cases[5].settings.finite_elements.enabled = true;
    return cases;
}

TEST(ContactReports, OfClothAtRestOnThingsAddUpToItsWeightByEveryMethod) {
    for (const NamedCloth& with : reporting_methods()) {
        for (const int substeps : {1, 3}) {
            const bool on_ball = substeps == 1;
            SCOPED_TRACE(std::string(with.name) + (on_ball ? ", ball, " : ", plane, ") +
                         std::to_string(substeps));
            WorldSettings settings = reporting();
            settings.substeps = substeps;
            World world = World::create(settings).value();
            ClothSettings cloth = with.settings;
            cloth.air_damping = 2;
            cloth.friction = 10;
            const ClothId id = world.add_cloth(turned_sheet(0.0055f), cloth).value();
            if (on_ball)
                EXPECT_TRUE(world.add_collider({.shape = Sphere{{0, -0.3f, 0}, 0.3f}}));
            else
                EXPECT_TRUE(world.add_collider({.shape = Plane{}}));
            for (int k = 0; k < 240; ++k) world.step(h);
            Eigen::Vector3d sum = Eigen::Vector3d::Zero();
            const Eigen::Vector3d before = momentum(world, id);
            constexpr int steps = 120;
            for (int k = 0; k < steps; ++k) {
                world.step(h);
                sum += impulse(world);
            }
            const double of_fall = mass(world, id) * static_cast<double>(g * h) * steps;
            const Eigen::Vector3d changed = momentum(world, id) - before;
            // The residual that Jacobi and conjugate gradients leave at a hanging rim counts as contact's.
            const bool leaves_more = std::holds_alternative<Jacobi>(cloth.method) ||
                                     std::holds_alternative<ConjugateGradient>(cloth.method);
            EXPECT_NEAR((sum.y() - changed.y()) / of_fall, 1, leaves_more && on_ball ? 0.3 : 0.02);
            EXPECT_NEAR((sum.x() - changed.x()) / of_fall, 0, 0.02);
        }
    }
}

TEST(ContactReports, OfAnImpactAddUpToTheMomentumThatItTakes) {
    for (const NamedCloth& with : reporting_methods()) {
        SCOPED_TRACE(with.name);
        World world = World::create(reporting()).value();
        const ClothId id = world.add_cloth(turned_sheet(0.3f), with.settings).value();
        ASSERT_TRUE(world.add_collider({.shape = Plane{}}));
        double sum = 0, fallen = 0, before = 0;
        for (int k = 0; k < 30; ++k) {
            before = momentum(world, id).y();
            world.step(h);
            fallen += mass(world, id) * static_cast<double>(g * h);
            sum += impulse(world).y();
        }
        EXPECT_LT(before, 1) << "it has landed";
        EXPECT_NEAR(sum, fallen + momentum(world, id).y(), 0.02 * fallen);
    }
}

TEST(ContactReports, SayWhereWhichColliderHoldsWhat) {
    World world = World::create(reporting()).value();
    const ColliderId gone = world.add_collider({.shape = Sphere{{9, 0, 0}, 0.1f}}).value();
    const ColliderId left =
        world.add_collider({.shape = Capsule{{-0.15f, 0, -1}, {-0.15f, 0, 1}, 0.05f}}).value();
    const ColliderId right = world.add_collider({.shape = Sphere{{0.15f, -0.05f, 0}, 0.1f}}).value();
    ASSERT_TRUE(world.remove_collider(gone));
    const ClothId id = world.add_cloth(turned_sheet(0.06f), undamped()).value();
    for (int k = 0; k < 8; ++k) world.step(h);
    const ClothView view = world.cloth(id).value();
    int of_left = 0, of_right = 0;
    for (const Contact& c : world.contacts()) {
        EXPECT_EQ(c.cloth, id);
        EXPECT_EQ(c.other_cloth, ClothId{});
        ASSERT_TRUE(c.collider == left || c.collider == right);
        const bool is_left = c.collider == left;
        (is_left ? of_left : of_right) += 1;
        const Vector3 axis = is_left ? Vector3(-0.15f, 0, c.point.z) : Vector3(0.15f, -0.05f, 0);
        const Vector3 out = to_vector(c.point) - axis, n = to_vector(c.normal);
        EXPECT_NEAR(out.norm(), is_left ? 0.05f : 0.1f, 1e-4f);
        EXPECT_NEAR(out.normalized().dot(n), 1, 1e-4f);
        EXPECT_GT(to_vector(c.impulse).dot(n), 0);
        // The cloth is kept its thickness away.
        EXPECT_NEAR((xyz(view.positions[c.particle]) - to_vector(c.point) - 0.005f * n).norm(), 0, 1e-4f);
    }
    EXPECT_GT(of_left, 5);
    EXPECT_GT(of_right, 3);
    EXPECT_EQ(world.report().contacts, world.contacts().size());
}

TEST(ContactReports, HaveFrictionThatStopsASlide) {
    World world = World::create(reporting()).value();
    ClothSettings settings = undamped();
    settings.friction = 1;
    const ClothId id = world.add_cloth(turned_sheet(0.0051f), settings).value();
    constexpr float friction = 0.3f;
    ASSERT_TRUE(world.add_collider({.shape = Plane{}, .friction = friction}));
    WorldSettings slope = world.settings();
    slope.gravity = {g, -g, 0};
    ASSERT_TRUE(world.set_settings(slope));
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int k = 0; k < 10; ++k) world.step(h);
    for (int k = 0; k < 20; ++k) {
        world.step(h);
        sum += impulse(world);
    }
    const double of_fall = mass(world, id) * static_cast<double>(g * h) * 20;
    EXPECT_NEAR(sum.y() / of_fall, 1, 0.02);
    EXPECT_NEAR(sum.x() / of_fall, static_cast<double>(-friction), 0.03);
}

// Shares of pairs are found by few sweeps: a quarter of what they pass on can go astray.
TEST(ContactReports, OfAStackPassItsWeightOn) {
    World world = World::create(reporting()).value();
    ClothSettings settings = with_self(SelfCollisionMethod::contact);
    settings.air_damping = 2;
    const ClothId lower = world.add_cloth(turned_sheet(0.006f, 0, 13, 0.5f), settings).value();
    const ClothId upper = world.add_cloth(turned_sheet(0.018f, 0.3f), settings).value();
    ASSERT_TRUE(world.add_collider({.shape = Plane{}}));
    for (int k = 0; k < 120; ++k) world.step(h);
    double on_ground = 0, between = 0;
    constexpr int steps = 120;
    for (int k = 0; k < steps; ++k) {
        world.step(h);
        on_ground += impulse(world, is_with_collider).y();
        between +=
            impulse(world, [&](const Contact& c) { return c.cloth == lower && c.other_cloth == upper; }).y();
    }
    const double fall = static_cast<double>(g * h) * steps;
    EXPECT_NEAR(-between / (mass(world, upper) * fall), 1, 0.3);
    EXPECT_NEAR(on_ground / ((mass(world, upper) + mass(world, lower)) * fall), 1, 0.3);
}

TEST(ContactReports, OfTwoClothsThatMeetAreWhatChangesTheirMomentum) {
    for (const TimeScheme scheme : {TimeScheme::backward_euler, TimeScheme::bdf2}) {
        World world = World::create(reporting()).value();
        ClothSettings settings = with_self(SelfCollisionMethod::contact);
        settings.time_scheme = scheme;
        const ClothId lower = world.add_cloth(turned_sheet(0), settings).value();
        const ClothId upper = world.add_cloth(turned_sheet(0.2f, 0.3f), settings).value();
        // The upper one is let fall for a moment, and then there is no gravity.
        std::vector<std::uint32_t> all(world.cloth(lower)->positions.size());
        for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
        ASSERT_TRUE(world.pin(lower, all));
        for (int k = 0; k < 6; ++k) world.step(h);
        ASSERT_TRUE(world.unpin(lower, all));
        ASSERT_TRUE(world.set_settings(reporting(room, {})));
        for (int k = 0; k < 6; ++k) {  // BDF2 goes on with what a push was for some steps
            world.step(h);
            ASSERT_TRUE(world.contacts().empty());
        }
        const Eigen::Vector3d of_lower = momentum(world, lower), of_upper = momentum(world, upper);
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (int k = 0; k < 60; ++k) {
            world.step(h);
            sum +=
                impulse(world, [&](const Contact& c) { return c.other_cloth == upper && c.cloth == lower; });
            EXPECT_LE(impulse(world, [](const Contact& c) { return c.other_cloth == c.cloth; }).norm(),
                      0.05 * of_upper.norm());
        }
        const double moved = of_upper.norm();
        ASSERT_LT((momentum(world, upper) - of_upper).norm(), 1.5 * moved);
        ASSERT_GT((momentum(world, lower) - of_lower).norm(), 0.3 * moved);
        EXPECT_NEAR((momentum(world, lower) - of_lower - sum).norm() / moved, 0, 0.25);
        EXPECT_NEAR((momentum(world, upper) - of_upper + sum).norm() / moved, 0, 0.25);
    }
}

/// Two layers of one mesh, the lower held.
struct Layers {
    explicit Layers(float gap, const ClothSettings& settings, const WorldSettings& in = reporting())
        : world(World::create(in).value()) {
        Mesh mesh = turned_sheet(0);
        const Mesh other = turned_sheet(gap);
        mesh.rows = mesh.columns = 0;
        const auto count = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
        mesh.texcoords.clear();
        for (const Triangle& t : other.triangles)
            mesh.triangles.push_back({t[0] + count, t[1] + count, t[2] + count});
        id = world.add_cloth(mesh, settings).value();
        std::vector<std::uint32_t> lower(count);
        for (std::uint32_t i = 0; i < count; ++i) lower[i] = i;
        EXPECT_TRUE(world.pin(id, lower));
    }
    World world;
    ClothId id;
};

TEST(ContactReports, OfLayersByAvoidanceHoldTheUpperOneUp) {
    ClothSettings settings = with_self(SelfCollisionMethod::avoidance);
    settings.air_damping = 2;
    Layers layers(0.0251f, settings);
    World& world = layers.world;
    for (int k = 0; k < 60; ++k) world.step(h);
    double up = 0;
    constexpr int steps = 60;
    const double before = momentum(world, layers.id).y();
    const ClothView view = world.cloth(layers.id).value();
    for (int k = 0; k < steps; ++k) {
        world.step(h);
        for (const Contact& c : world.contacts()) {
            ASSERT_EQ(c.cloth, layers.id);
            ASSERT_EQ(c.other_cloth, layers.id);
            const bool is_upper = view.positions[c.particle].w > 0;
            if (is_upper == (view.positions[c.other_particle].w > 0)) continue;
            up += static_cast<double>(is_upper ? c.impulse.y : -c.impulse.y);
        }
    }
    const double fall = static_cast<double>(g * h) * steps;
    const double changed = momentum(world, layers.id).y() - before;
    EXPECT_NEAR((up - changed) / (0.5 * mass(world, layers.id) * fall), 1, 0.05);
}

/// A scene with all there is to touch.
struct Heap {
    explicit Heap(const WorldSettings& settings) : world(World::create(settings).value()) {
        const ClothSettings contact = with_self(SelfCollisionMethod::contact),
                            avoidance = with_self(SelfCollisionMethod::avoidance);
        cloths = {world.add_cloth(turned_sheet(0.12f, 0.3f), contact).value(),
                  world.add_cloth(turned_sheet(0.105f), contact).value(),
                  world.add_cloth(turned_sheet(0.2f, 0, 20, 0.3f), avoidance).value(),
                  world.add_cloth(turned_sheet(0.3f, 0, 13, 0.2f), undamped(Xpbd{}, 4)).value()};
        EXPECT_TRUE(world.add_collider({.shape = Sphere{{0, 0, 0}, 0.1f}}));
        EXPECT_TRUE(world.add_collider({.shape = Plane{}}));
    }
    World world;
    std::vector<ClothId> cloths;
};

/// But for the generations, which differ between Worlds.
std::string bytes_of(std::span<const Contact> contacts) {
    static_assert(sizeof(Contact) == 6 * 4 + 2 * 4 + 9 * 4, "no padding");
    std::vector<Contact> bare(contacts.begin(), contacts.end());
    for (Contact& c : bare) c.cloth.generation = c.other_cloth.generation = c.collider.generation = 0;
    return {reinterpret_cast<const char*>(bare.data()), bare.size() * sizeof(Contact)};
}

TEST(ContactReports, AreTheSameBytesOnAnyThreadsAndChangeNothing) {
    std::vector<std::string> expected;
    std::vector<std::uint64_t> hashes;
    for (const auto& [threads, reports] : {std::pair{1, room}, {2, room}, {4, room}, {1, 0}}) {
        WorldSettings settings = reporting(reports);
        settings.threads = threads;
        settings.substeps = 2;
        Heap heap(settings);
        for (std::size_t k = 0; k < 50; ++k) {
            heap.world.step(h);
            if (threads == 1 && reports > 0) {
                expected.push_back(bytes_of(heap.world.contacts()));
                hashes.push_back(heap.world.state_hash());
            }
            ASSERT_EQ(heap.world.state_hash(), hashes[k]) << threads << " threads, step " << k;
            if (reports > 0)
                ASSERT_TRUE(bytes_of(heap.world.contacts()) == expected[k])
                    << threads << " threads, step " << k;
            else
                ASSERT_TRUE(heap.world.contacts().empty() && heap.world.report().contacts == 0);
        }
    }
    EXPECT_GT(expected.back().size(), 100 * sizeof(Contact));
}

TEST(ContactReports, AreTheStrongestWhereThereIsNoRoomForAll) {
    constexpr int few = 32;
    for (const int threads : {1, 3}) {
        WorldSettings small = reporting(few);
        small.threads = threads;
        Heap all(reporting()), some(small);
        for (int k = 0; k < 40; ++k) {
            all.world.step(h);
            some.world.step(h);
            ASSERT_EQ(some.world.report().contacts, all.world.contacts().size());
            const auto strength = [](const Contact& c) { return to_vector(c.impulse).norm(); };
            std::vector<Contact> best(all.world.contacts().begin(), all.world.contacts().end());
            if (best.size() > few) {
                std::vector<float> strengths(best.size());
                std::ranges::transform(best, strengths.begin(), strength);
                std::ranges::nth_element(strengths, strengths.begin() + few - 1, std::greater<>());
                std::erase_if(best, [&](const Contact& c) { return strength(c) < strengths[few - 1]; });
                best.resize(std::min<std::size_t>(best.size(), few));
            }
            EXPECT_TRUE(bytes_of(some.world.contacts()) == bytes_of(best)) << "in step " << k;
        }
        EXPECT_GT(some.world.report().contacts, static_cast<std::uint32_t>(few));
    }
}

TEST(ContactReports, GoByCloths) {
    Heap heap(reporting());
    std::uint32_t last = 0;
    std::vector<bool> seen(heap.cloths.size());
    for (int k = 0; k < 60; ++k) {
        heap.world.step(h);
        last = 0;
        for (const Contact& c : heap.world.contacts()) {
            EXPECT_GE(c.cloth.index, last);
            last = c.cloth.index;
            EXPECT_TRUE(is_with_collider(c) || c.other_cloth.index >= c.cloth.index);
            seen[static_cast<std::size_t>(std::ranges::find(heap.cloths, c.cloth) - heap.cloths.begin())] =
                true;
        }
    }
    EXPECT_EQ(std::ranges::count(seen, true), 4);
}

TEST(ContactReports, CanBeSwitchedAtAnyTime) {
    Heap heap(reporting(0));
    World& world = heap.world;
    const std::uint64_t without = world.cloth_info(heap.cloths[0])->bytes;
    const auto set_room = [&](int reports) {
        WorldSettings settings = world.settings();
        settings.contact_reports = reports;
        return world.set_settings(settings);
    };
    for (int k = 0; k < 30; ++k) world.step(h);
    EXPECT_TRUE(world.contacts().empty());
    ASSERT_TRUE(set_room(room));
    EXPECT_TRUE(world.contacts().empty());
    EXPECT_GT(world.cloth_info(heap.cloths[0])->bytes, without);
    world.step(h);
    EXPECT_FALSE(world.contacts().empty());
    ASSERT_TRUE(world.add_collider({.shape = Sphere{{0, 0.1f, 0}, 0.02f}}));
    ASSERT_TRUE(world.remove_cloth(heap.cloths[1]));
    world.step(h);
    for (const Contact& c : world.contacts()) EXPECT_NE(c.cloth, heap.cloths[1]);
    EXPECT_FALSE(world.contacts().empty());
    world.step(0);
    EXPECT_TRUE(world.contacts().empty()) << "of a step that was none";
    ASSERT_TRUE(set_room(0));
    world.step(h);
    EXPECT_TRUE(world.contacts().empty());
    EXPECT_EQ(world.cloth_info(heap.cloths[0])->bytes, without);
}

TEST(ContactReports, RefuseARoomThatIsNone) {
    for (const int bad : {-1, (1 << 20) + 1}) {
        const auto refused = World::create(reporting(bad));
        ASSERT_FALSE(refused.ok());
        EXPECT_NE(refused.error().message.find("WorldSettings::contact_reports"), std::string::npos);
        EXPECT_NE(refused.error().message.find("1048576"), std::string::npos) << refused.error().message;
    }
}

}  // namespace
}  // namespace weft::test
