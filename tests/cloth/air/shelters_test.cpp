// Shelters from the wind, and each cloth's own share of wind and gravity.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/cloth/worn/worn.h"

namespace weft::test {
namespace {

/// A World with a wind along z.
WorldSettings windy(float speed, float gust = 0) {
    WorldSettings settings;
    settings.threads = 1;
    settings.wind.velocity = {0, 0, speed};
    settings.wind.gust = gust;
    return settings;
}

float air_at(const World& world, const Vec3& point) {
    Vec3 air{};
    EXPECT_TRUE(world.sample_air({&point, 1}, {&air, 1}));
    return air.z;
}

/// A banner of 1 m that hangs by its upper edge.
ClothId add_banner(World& world, const Vec3& at, const ClothSettings& settings = {}) {
    const Mesh mesh =
        make_sheet({.rows = 17, .columns = 17, .origin = at, .u = {1, 0, 0}, .v = {0, -1, 0}}).value();
    const ClothId cloth = world.add_cloth(mesh, settings).value();
    std::vector<std::uint32_t> top(17);
    for (std::uint32_t k = 0; k < 17; ++k) top[k] = k;
    EXPECT_TRUE(world.pin(cloth, top));
    return cloth;
}

float peak_speed(const World& world, ClothId cloth) {
    float peak = 0;
    for (const Vec4& v : world.cloth(cloth)->velocities) peak = std::max(peak, xyz(v).norm());
    return peak;
}

TEST(Shelters, ABannerIndoorsHangsStillWhileTheOneOutsideFlies) {
    for (const float gust : {0.0f, 0.3f}) {
        WorldSettings settings = windy(15, gust);
        settings.wind.shelters[3] = {.kind = AirShelterKind::box,
                                     .position = {0.5f, -0.5f, 0},
                                     .half_extents = {1, 1, 1},
                                     .border = 0.5f};
        World world = World::create(settings).value();
        const ClothId inside = add_banner(world, {}), outside = add_banner(world, {5, 0, 0});
        for (int k = 0; k < 180; ++k) world.step(h);
        EXPECT_LT(peak_speed(world, inside), 0.01f);
        EXPECT_GT(peak_speed(world, outside), 0.3f);
        EXPECT_LT(world.cloth(inside)->bounds.upper.z, 0.01f);
        EXPECT_GT(world.cloth(outside)->bounds.upper.z, 0.5f);
    }
}

TEST(Shelters, LetTheWindRiseSmoothlyAcrossTheirBorders) {
    WorldSettings settings = windy(10);
    settings.wind.shelters[0] = {.kind = AirShelterKind::ball, .radius = 2, .border = 1, .exposure = 0.2f};
    settings.wind.shelters[7] = {.kind = AirShelterKind::box,
                                 .position = {20, 0, 0},
                                 .rotation = worn::turn({0, 0, 1}, 0.5),
                                 .half_extents = {3, 1, 2},
                                 .border = 2};
    World world = World::create(settings).value();
    EXPECT_FLOAT_EQ(air_at(world, {0, 0, 0}), 2);
    EXPECT_FLOAT_EQ(air_at(world, {0, 2, 0}), 2);
    EXPECT_NEAR(air_at(world, {0, 0, 2.5f}), 2 + 0.5f * 8, 1e-4f);
    EXPECT_FLOAT_EQ(air_at(world, {0, 3.01f, 0}), 10);
    const auto in_box = [&](float x, float y, float z) {
        const float c = std::cos(0.5f), s = std::sin(0.5f);
        return air_at(world, {20 + c * x - s * y, s * x + c * y, z});
    };
    EXPECT_FLOAT_EQ(in_box(2.9f, -0.9f, 1.9f), 0);
    EXPECT_NEAR(in_box(4, 0, 0), 5, 1e-4f);
    EXPECT_NEAR(in_box(0, -2, 0), 5, 1e-4f);
    EXPECT_NEAR(in_box(3.6f, 1.8f, 0), 5, 1e-4f) << "round its edges";
    EXPECT_FLOAT_EQ(in_box(0, 3.1f, 0), 10);
    float last = 0;
    for (int k = 0; k <= 100; ++k) {
        const float now = in_box(0, 1 + 0.02f * static_cast<float>(k), 0);
        EXPECT_GE(now, last);
        EXPECT_LT(now - last, 0.2f);
        last = now;
    }
}

TEST(Shelters, KeepOffTheWindAndNoFan) {
    WorldSettings settings = windy(10, 0.5f);
    settings.wind.shelters[0] = {.kind = AirShelterKind::ball, .radius = 3};
    settings.wind.sources[0] = {AirSourceKind::jet, {0, 0, 0}, {0, 0, 4}, 0.5f};
    World world = World::create(settings).value();
    EXPECT_NEAR(air_at(world, {0, 0, 0}), 4, 1e-4f);
    ASSERT_TRUE(world.shift_origin({50, 0, -20}));
    EXPECT_NEAR(air_at(world, {-50, 0, 20}), 4, 1e-4f) << "they move with the origin";
    const auto beyond = world.shift_origin({-99990, 0, 0});
    EXPECT_TRUE(beyond.ok());
    EXPECT_FALSE(world.shift_origin({-1000, 0, 0}).ok());
}

TEST(Shelters, NameWhatIsWrong) {
    World world = World::create({}).value();
    const AirShelter box{.kind = AirShelterKind::box}, ball{.kind = AirShelterKind::ball};
    const auto refused = [&](AirShelter shelter, const char* words) {
        WorldSettings settings;
        settings.wind.shelters[2] = shelter;
        const auto answer = world.set_settings(settings);
        ASSERT_FALSE(answer);
        EXPECT_NE(answer.error().message.find(words), std::string::npos) << answer.error().message;
    };
    const auto with = [](AirShelter of, const auto& change) {
        change(of);
        return of;
    };
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    refused({.kind = static_cast<AirShelterKind>(3)}, "AirShelter::kind is 3");
    refused(with(ball, [](AirShelter& s) { s.radius = 0; }), "AirShelter::radius is 0");
    refused(with(ball, [](AirShelter& s) { s.border = 0; }), "AirShelter::border is 0");
    refused(with(ball, [](AirShelter& s) { s.exposure = 1.5f; }), "AirShelter::exposure is 1.5");
    refused(with(ball, [](AirShelter& s) { s.position.y = nan; }), "AirShelter::position");
    refused(with(box, [](AirShelter& s) { s.half_extents.z = -1; }), "AirShelter::half_extents is -1");
    refused(with(box, [](AirShelter& s) { s.rotation = {0, 0, 0, 0}; }), "AirShelter::rotation is 0");
    WorldSettings settings;
    settings.wind.shelters[2] = {.radius = nan};
    EXPECT_TRUE(world.set_settings(settings)) << "none has no values";
}

// In the mean wind to the last bit: a scale of one half only changes exponents.
TEST(WindScale, IsThatOfTheWindItself) {
    for (const bool with_fan : {false, true}) {
        WorldSettings whole = windy(6), half = windy(3);
        if (with_fan) {
            whole.wind.sources[0] = {AirSourceKind::jet, {0.5f, -0.5f, -2}, {0, 1, 4}, 0.5f};
            half.wind.sources[0] = {AirSourceKind::jet, {0.5f, -0.5f, -2}, {0, 0.5f, 2}, 0.5f};
        }
        World one = World::create(whole).value(), other = World::create(half).value();
        const ClothId scaled = add_banner(one, {}, {.wind_scale = 0.5f}), plain = add_banner(other, {});
        for (int k = 0; k < 60; ++k) {
            one.step(h);
            other.step(h);
        }
        const auto a = one.cloth(scaled)->positions, b = other.cloth(plain)->positions;
        EXPECT_TRUE(same_bytes({a.begin(), a.end()}, {b.begin(), b.end()}));
        EXPECT_GT(one.cloth(scaled)->bounds.upper.z, 0.1f);
    }
}

TEST(WindScale, OfNothingLeavesTheAirStanding) {
    World world = World::create(windy(15, 0.3f)).value();
    const ClothId cloth = add_banner(world, {}, {.wind_scale = 0});
    for (int k = 0; k < 180; ++k) world.step(h);
    EXPECT_LT(peak_speed(world, cloth), 0.01f);
}

TEST(DragScale, IsThatOfTheWindItself) {
    WorldSettings whole = windy(6), scaled = windy(6);
    scaled.wind.drag *= 0.5f;
    scaled.wind.lift *= 0.25f;
    World one = World::create(whole).value(), other = World::create(scaled).value();
    const ClothId loose = add_banner(one, {}, {.drag_scale = 0.5f, .lift_scale = 0.25f}),
                  plain = add_banner(other, {});
    for (int k = 0; k < 60; ++k) {
        one.step(h);
        other.step(h);
    }
    const auto a = one.cloth(loose)->positions, b = other.cloth(plain)->positions;
    EXPECT_TRUE(same_bytes({a.begin(), a.end()}, {b.begin(), b.end()}));
    EXPECT_GT(one.cloth(loose)->bounds.upper.z, 0.1f);
}

TEST(DragScale, OfNothingLeavesClothAlone) {
    World world = World::create(windy(15, 0.3f)).value();
    const ClothId cloth = add_banner(world, {}, {.drag_scale = 0, .lift_scale = 0});
    for (int k = 0; k < 180; ++k) world.step(h);
    EXPECT_LT(peak_speed(world, cloth), 0.01f);
}

TEST(GravityScale, IsThatOfTheFallInAVacuum) {
    for (const float scale : {0.0f, 0.5f, 1.0f, -2.0f}) {
        World world = World::create(vacuum(downwards)).value();
        ClothSettings settings;
        settings.air_damping = 0;
        settings.gravity_scale = scale;
        const ClothId cloth = world.add_cloth(sheet(9, 9), settings).value();
        for (int k = 0; k < 60; ++k) world.step(h);
        for (const Vec4& v : world.cloth(cloth)->velocities) EXPECT_NEAR(v.y, -9.81f * scale, 2e-3f);
    }
}

// A level sheet falls level: half rho Cd v^2 is its weight per area.
TEST(GravityScale, GivesTheTerminalFallOfItsWeight) {
    for (const float scale : {1.0f, 0.5f}) {
        World world = World::create({}).value();
        ClothSettings settings;
        settings.air_damping = 0;
        settings.gravity_scale = scale;
        const ClothId cloth = world.add_cloth(sheet(9, 9), settings).value();
        for (int k = 0; k < 180; ++k) world.step(h);
        const float fall = std::sqrt(2 * 0.2f * 9.81f * scale / 1.2f);
        for (const Vec4& v : world.cloth(cloth)->velocities) EXPECT_NEAR(-v.y, fall, 0.01f * fall);
    }
}

}  // namespace
}  // namespace weft::test
