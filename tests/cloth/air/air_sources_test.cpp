// Fans, blasts and balls that pass, by what each keeps.

#include "cloth/air/air_sources.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/cloth/fixtures.h"

namespace weft::test {
namespace {

constexpr float step = 1.0f / 60;

Vector3 air_at(const AirSource& source, const Vector3& point) {
    Parallel serial(1);
    AlignedBuffer<Vec4> points(1), velocities(1);
    points[0] = to_vec4(point, 0);
    velocities[0] = {};
    Wind wind;
    wind.sources[5] = source;
    add_air_of_sources(serial, wind, points.span(), velocities.span());
    return xyz(velocities[0]);
}

TEST(AirSources, AJetKeepsItsMomentumAsItWidens) {
    const Vector3 axis = Vector3(2, -1, 0.5f).normalized(), side = axis.cross(Vector3(0, 0, 1)).normalized();
    const Vector3 hub(0.3f, 1, -2);
    const AirSource fan{AirSourceKind::jet, to_vec3(hub), to_vec3(7 * axis), 0.25f};
    const auto momentum = [&](float ahead) {
        const double b = 0.25 + 0.1 * static_cast<double>(ahead), dr = 0.01 * b;
        double sum = 0;
        for (double r = 0.5 * dr; r < 40 * b; r += dr) {
            const Vector3 air = air_at(fan, hub + ahead * axis + static_cast<float>(r) * side);
            EXPECT_LT(air.cross(axis).norm(), 1e-5f);
            sum += 2 * std::numbers::pi * r * dr * static_cast<double>(air.squaredNorm());
        }
        return sum;
    };
    EXPECT_NEAR(air_at(fan, hub).dot(axis), 7, 1e-5f);
    for (const float ahead : {0.0f, 1.0f, 4.0f}) {
        EXPECT_NEAR(momentum(ahead) / momentum(0), 1, 0.01);
        const Vector3 middle = hub + ahead * axis;
        const float b = 0.25f + 0.1f * ahead;
        EXPECT_NEAR(air_at(fan, middle + b * side).norm() / air_at(fan, middle).norm(), 0.5f, 1e-4f);
    }
    EXPECT_EQ(air_at(fan, hub - 0.26f * axis).norm(), 0);
}

TEST(AirSources, ABlastDrivesOutTheSameVolumeAtEveryDistance) {
    const Vector3 middle(1, 2, 3), way = Vector3(-1, 2, 0.7f).normalized();
    const AirSource blast{AirSourceKind::blast, to_vec3(middle), {0, 9, 12}, 0.5f};
    for (const float distance : {0.5f, 0.8f, 3.0f, 20.0f}) {
        const Vector3 air = air_at(blast, middle + distance * way);
        EXPECT_NEAR(air.dot(way) * distance * distance, 15 * 0.5f * 0.5f, 1e-3f) << distance << " m";
        EXPECT_LT(air.cross(way).norm(), 1e-4f);
    }
    EXPECT_NEAR(air_at(blast, middle + 0.2f * way).dot(way), 15 * 0.4f, 1e-4f);
    EXPECT_EQ(air_at(blast, middle), Vector3(0, 0, 0));
}

TEST(AirSources, ABallPushesTheAirBeforeItAndDragsAlongWhatIsBehind) {
    const Vector3 middle(-1, 0.5f, 0), velocity(0, -3, 4), axis = velocity / 5;
    constexpr float radius = 0.2f;
    const AirSource ball{AirSourceKind::wake, to_vec3(middle), to_vec3(velocity), radius};
    for (const Vector3& inside : {Vector3(0, 0, 0), Vector3(0.1f, 0.1f, 0)})
        EXPECT_EQ(air_at(ball, middle + inside), velocity);
    // No air goes through its front.
    for (const float angle : {0.0f, 0.4f, 0.9f, 1.5f}) {
        const Vector3 out = std::cos(angle) * axis + std::sin(angle) * Vector3(1, 0, 0);
        EXPECT_NEAR(air_at(ball, middle + 1.0001f * radius * out).dot(out), velocity.dot(out), 2e-3f);
    }
    // A dipole: by the cube of the distance.
    EXPECT_NEAR(air_at(ball, middle + 2 * axis).norm() / air_at(ball, middle + axis).norm(), 0.125f, 1e-4f);
    // A wake: U b^2 is kept, and far behind there is nothing else.
    for (const float behind : {2.0f, 10.0f}) {
        const float squared_b = radius * (radius + behind);
        const float dipole = 5 * radius * radius * radius / (behind * behind * behind);
        const Vector3 air = air_at(ball, middle - behind * axis);
        EXPECT_NEAR((air.dot(axis) - dipole) * squared_b, 5 * radius * radius, 1e-3f);
    }
}

TEST(AirSources, AddUpOnTopOfTheWind) {
    Parallel serial(1);
    AlignedBuffer<Vec4> points(37), velocities(37);
    for (std::uint32_t i = 0; i < 37; ++i) {
        points[i] = {0.03f * static_cast<float>(i), 0.4f, 0.1f, 0};
        velocities[i] = {1, 2, 3, 0};
    }
    Wind wind;
    wind.sources[1] = {AirSourceKind::jet, {0, 0.4f, 0}, {3, 0, 0}, 0.3f};
    wind.sources[4] = {AirSourceKind::blast, {0, 0, 0}, {2, 0, 0}, 0.3f};
    add_air_of_sources(serial, wind, points.span(), velocities.span());
    for (std::uint32_t i = 0; i < 37; ++i) {
        const Vector3 p = xyz(points[i]);
        const Vector3 expected = Vector3(1, 2, 3) + air_at(wind.sources[1], p) + air_at(wind.sources[4], p);
        EXPECT_LT((xyz(velocities[i]) - expected).norm(), 1e-5f);
    }
    for (std::uint32_t i = 37; i < 48; ++i) EXPECT_EQ(velocities.data()[i].x, 0);
}

/// A sheet that hangs by its upper edge in still air.
struct Hung {
    explicit Hung(int threads = 1, float gust = 0) : world(World::create(settings(threads, gust)).value()) {
        const Mesh mesh =
            make_sheet({.rows = 24, .columns = 24, .origin = {-0.5f, 2, 0}, .u = {1, 0, 0}, .v = {0, -1, 0}})
                .value();
        cloth = world.add_cloth(mesh).value();
        std::vector<std::uint32_t> top(24);
        for (std::uint32_t k = 0; k < 24; ++k) top[k] = k;
        EXPECT_TRUE(world.pin(cloth, top));
    }
    static WorldSettings settings(int threads, float gust) {
        WorldSettings made;
        made.threads = threads;
        made.wind.gust = gust;
        return made;
    }
    void blow(const AirSource& source, std::size_t which = 0) {
        WorldSettings changed = world.settings();
        changed.wind.sources[which] = source;
        ASSERT_TRUE(world.set_settings(changed));
    }
    [[nodiscard]] Vector3 mean_velocity() {
        Vector3 sum = Vector3::Zero();
        const auto velocities = world.cloth(cloth)->velocities;
        for (const Vec4& v : velocities) sum += xyz(v) / static_cast<float>(velocities.size());
        return sum;
    }
    World world;
    ClothId cloth;
};

TEST(AirSources, AreFeltInTheNextStepAndNoMoreWhereTheyAreGone) {
    Hung hung, calm;
    const AirSource fan{AirSourceKind::jet, {0, 1.5f, -1}, {0, 0, 8}, 0.3f};
    hung.blow(fan);
    hung.world.step(step);
    calm.world.step(step);
    EXPECT_GT(hung.mean_velocity().z(), calm.mean_velocity().z() + 0.02f);
    hung.blow({});
    EXPECT_EQ(hung.world.cloth_info(hung.cloth)->bytes, calm.world.cloth_info(calm.cloth)->bytes);
}

TEST(AirSources, GoWithTheOrigin) {
    Hung here, there;
    const AirSource fan{AirSourceKind::jet, {0.125f, 1.5f, -1}, {0, 0, 8}, 0.3f};
    for (Hung* each : {&here, &there}) each->blow(fan, 2);
    // Not far: places that are rounded otherwise are other springs.
    ASSERT_TRUE(there.world.shift_origin({8, 0, -4}));
    for (int k = 0; k < 30; ++k) {
        here.world.step(step);
        there.world.step(step);
    }
    EXPECT_EQ(there.world.settings().wind.sources[2].position.x, 0.125f - 8);
    EXPECT_GT(here.mean_velocity().norm(), 0.01f);
    EXPECT_LT((here.mean_velocity() - there.mean_velocity()).norm(), 2e-3f);
    there.blow({AirSourceKind::blast, {-9.9e4f, 0, 0}, {1, 0, 0}, 1});
    const auto beyond = there.world.shift_origin({2000, 0, 0});
    ASSERT_FALSE(beyond);
    EXPECT_NE(beyond.error().message.find("AirSource::position"), std::string::npos);
}

TEST(AirSources, CanBeSampledWithWindAndGusts) {
    Hung hung(1, 0.4f);
    WorldSettings settings = hung.world.settings();
    settings.wind.velocity = {2, 0, 1};
    settings.wind.sources[0] = {AirSourceKind::jet, {0, 1, 0}, {0, 6, 0}, 0.2f};
    ASSERT_TRUE(hung.world.set_settings(settings));
    for (int k = 0; k < 10; ++k) hung.world.step(step);
    std::vector<Vec3> points(300), air(300), without(300);
    for (std::size_t k = 0; k < points.size(); ++k) points[k] = {0.01f * static_cast<float>(k), 1.5f, 0.1f};
    ASSERT_TRUE(hung.world.sample_air(points, air));
    hung.blow({});
    ASSERT_TRUE(hung.world.sample_air(points, without));
    float gusts = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Vector3 jet = air_at(settings.wind.sources[0], to_vector(points[k]));
        EXPECT_LT((to_vector(air[k]) - to_vector(without[k]) - jet).norm(), 1e-5f);
        gusts = std::max(gusts, (to_vector(without[k]) - Vector3(2, 0, 1)).norm());
    }
    EXPECT_GT(gusts, 0.3f);
    EXPECT_FALSE(hung.world.sample_air(points, std::span(air).first(299)));
}

TEST(AirSources, AreNotSampledWhereThereIsNoPlace) {
    for (const float gust : {0.0f, 0.4f}) {
        Hung hung(1, gust);
        hung.blow({AirSourceKind::blast, {0, 1, 0}, {3, 0, 0}, 0.2f});
        std::vector<Vec3> points(300, Vec3{0, 1, 0}), air(300, Vec3{7, 7, 7});
        ASSERT_TRUE(hung.world.sample_air(points, air));
        for (const Vec3& v : air) ASSERT_TRUE(std::isfinite(v.x + v.y + v.z));
        const std::vector<Vec3> before = air;
        for (const float lost : {NAN, INFINITY, -1.01e5f}) {
            points[287] = {0, 1, lost};
            const auto sampled = hung.world.sample_air(points, air);
            ASSERT_FALSE(sampled) << lost;
            EXPECT_NE(sampled.error().message.find("points[287]"), std::string::npos)
                << sampled.error().message;
            EXPECT_EQ(std::memcmp(air.data(), before.data(), air.size() * sizeof(Vec3)), 0);
        }
        points[287] = {0, 1, -1e5f};
        EXPECT_TRUE(hung.world.sample_air(points, air));
    }
}

TEST(AirSources, OutOfTheirRangesAreRefused) {
    const auto refused = [](const AirSource& source) {
        WorldSettings settings;
        settings.wind.sources[6] = source;
        const auto world = World::create(settings);
        return world ? std::string() : world.error().message;
    };
    EXPECT_NE(refused({AirSourceKind::jet, {}, {}, 0}).find("AirSource::radius"), std::string::npos);
    EXPECT_NE(refused({AirSourceKind::blast, {}, {0, 1e4f, 0}, 1}).find("velocity"), std::string::npos);
    EXPECT_NE(refused({AirSourceKind::wake, {NAN, 0, 0}, {}, 1}).find("position"), std::string::npos);
    EXPECT_NE(refused({static_cast<AirSourceKind>(9), {}, {}, 1}).find("kind"), std::string::npos);
    EXPECT_EQ(refused({AirSourceKind::none, {NAN, 0, 0}, {}, 0}), "");
}

}  // namespace
}  // namespace weft::test
