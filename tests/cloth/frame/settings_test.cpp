// Settings as a host gives them: every range is held at both its ends, none of which breaks a step, and what
// lies outside is refused by name.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"

namespace weft::test {
namespace {

constexpr float infinite_setting = std::numeric_limits<float>::infinity();

struct Settings {
    WorldSettings world{.threads = 1};
    ClothSettings cloth;
};

/// All numbers of settings. Settings with_air() have those of each kind of source and shelter.
std::vector<SettingNumber> numbers(Settings& of) {
    std::vector<SettingNumber> all = must(numbers_of(of.world));
    for (const SettingNumber& each : must(numbers_of(of.cloth))) all.push_back(each);
    return all;
}
Settings with_air() {
    Settings settings;
    settings.world.wind.sources[0].kind = AirSourceKind::jet;
    settings.world.wind.shelters[0].kind = AirShelterKind::ball;
    settings.world.wind.shelters[1].kind = AirShelterKind::box;
    return settings;
}

std::string name(const SettingNumber& number) {
    return std::string(number.type) + "::" + number.field;
}
/// Returns true if it counts steps, passes or threads, which take too long at the upper end.
bool is_whole(const SettingNumber& number) {
    return std::holds_alternative<int*>(number.value);
}
void set(const SettingNumber& number, float value) {
    if (auto* const* vector = std::get_if<Vec3*>(&number.value))
        (*vector)->y = value;
    else if (auto* const* whole = std::get_if<int*>(&number.value))
        **whole = static_cast<int>(value);
    else
        *std::get<float*>(number.value) = value;
}
/// The greatest value in the range.
float greatest(const SettingNumber& number) {
    return number.below_greatest ? std::nextafter(number.greatest, 0.0f) : number.greatest;
}

struct ChosenMethod {
    const char* name;
    void (*choose)(ClothSettings&);
};
constexpr ChosenMethod methods[] = {
    {"multilevel", [](ClothSettings&) {}},
    {"bdf2", [](ClothSettings& s) { s.time_scheme = TimeScheme::bdf2; }},
    {"jacobi", [](ClothSettings& s) { s.method = Jacobi{}; }},
    {"chebyshev", [](ClothSettings& s) { s.method = Chebyshev{}; }},
    {"conjugate gradients", [](ClothSettings& s) { s.method = ConjugateGradient{}; }},
    {"xpbd", [](ClothSettings& s) { s.method = Xpbd{}; }},
    {"fibres", [](ClothSettings& s) { s.method = Fibres{}; }},
    {"symplectic euler", [](ClothSettings& s) { s.method = SymplecticEuler{}; }},
    {"elements", [](ClothSettings& s) { s.finite_elements.enabled = true; }},
    {"hinges",
     [](ClothSettings& s) {
         s.finite_elements.enabled = s.finite_elements.dihedral = s.finite_elements.consistent_mass = true;
     }},
};

/// A sheet that hangs by two corners with a sphere inside its plane; some steps of it, which must all be
/// sound.
void expect_sound_steps(const Settings& settings) {
    World world = must(World::create(settings.world));
    const ClothId id = must(world.add_cloth(sheet(6, 6), settings.cloth));
    ASSERT_TRUE(world.pin(id, 0).ok() && world.pin(id, 5).ok());
    ASSERT_TRUE(world.add_collider({.shape = Sphere{.center = {0, -0.02f, 0}, .radius = 0.1f}}).ok());
    for (int step = 0; step < 6; ++step) {
        const StepReport& report = world.step(1.0f / 60);
        ASSERT_FALSE(has(report.flags, StepFlags::state_restored)) << "in step " << step;
        for (const Vec4& p : world.cloth(id)->positions)
            ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.w));
    }
    EXPECT_TRUE(std::isfinite(must(world.cloth_info(id)).mass));
}

/// Takes back what is refused together: stiffening where none is known, or that is too stiff; restitution
/// without impact zones.
void make_acceptable(ClothSettings& settings) {
    if (settings.self_collision.restitution > 0)
        settings.self_collision.method = SelfCollisionMethod::impact_zones;
    Fabric& fabric = settings.fabric;
    const bool knows_none = settings.finite_elements.enabled ||
                            std::holds_alternative<Xpbd>(settings.method) ||
                            std::holds_alternative<Fibres>(settings.method);
    if (knows_none) fabric.stiffening = 0;
    const float most = 3e9f / (fabric.stiffening + 3) * 0.999f;
    if (fabric.stiffening > 0) fabric.warp = std::min(fabric.warp, most);
    if (fabric.stiffening > 0) fabric.weft = std::min(fabric.weft, most);
}

Settings with_everything_on(const ChosenMethod& method) {
    Settings settings = with_air();
    settings.world.wind.velocity = {1, 0, 2};
    settings.world.wind.gust = 0.5f;
    settings.cloth.self_collision.method = SelfCollisionMethod::contact;
    method.choose(settings.cloth);
    return settings;
}

TEST(SettingRanges, NeitherEndOfAnyBreaksAStep) {
    for (const ChosenMethod& method : methods) {
        Settings settings = with_everything_on(method);
        for (std::size_t k = 0; k < numbers(settings).size(); ++k) {
            for (const bool least : {true, false}) {
                settings = with_everything_on(method);
                const SettingNumber number = numbers(settings)[k];
                if (is_whole(number)) continue;
                SCOPED_TRACE(std::string(method.name) + ", " + name(number) + (least ? "-" : "+"));
                set(number, least ? number.least : greatest(number));
                make_acceptable(settings.cloth);
                expect_sound_steps(settings);
                if (HasFatalFailure()) return;
            }
        }
    }
}

TEST(SettingRanges, EndsOfManyAtOnceBreakNoStep) {
    std::mt19937 random(19);
    for (const ChosenMethod& method : methods) {
        for (int trial = 0; trial < 30; ++trial) {
            Settings settings = with_everything_on(method);
            std::string chosen;
            for (const SettingNumber& number : numbers(settings)) {
                const std::uint32_t choice = random() % 4;
                if (choice > 1 || is_whole(number)) continue;
                set(number, choice == 0 ? number.least : greatest(number));
                chosen += " " + name(number) + (choice == 0 ? "-" : "+");
            }
            SCOPED_TRACE(std::string(method.name) + chosen);
            make_acceptable(settings.cloth);
            expect_sound_steps(settings);
            if (HasFatalFailure()) return;
        }
    }
}

/// The message of the refusal; empty: none.
std::string refusal(const Settings& settings) {
    const auto world = World::create(settings.world);
    if (!world) return world.error().message;
    World sound = must(World::create());
    const auto cloth = sound.add_cloth(sheet(3, 3), settings.cloth);
    return cloth ? "" : cloth.error().message;
}

TEST(SettingRanges, WhatLiesOutsideIsRefusedByNameWithTheRange) {
    Settings settings = with_air();
    for (std::size_t k = 0; k < numbers(settings).size(); ++k) {
        settings = with_air();
        const SettingNumber number = numbers(settings)[k];
        std::vector<float> outside{number.least - 1, number.greatest + 1};
        if (!is_whole(number))
            outside = {std::nextafter(number.least, -infinite_setting),
                       std::nextafter(greatest(number), infinite_setting),
                       infinite_setting,
                       -infinite_setting,
                       std::numeric_limits<float>::quiet_NaN(),
                       std::numeric_limits<float>::max()};
        for (const float value : outside) {
            EXPECT_FALSE(number.has(static_cast<double>(value))) << name(number) << " " << value;
            set(number, value);
            const std::string message = refusal(settings);
            EXPECT_NE(message.find(name(number)), std::string::npos) << name(number) << value << message;
            EXPECT_NE(message.find("must be"), std::string::npos) << message;
        }
    }
    Settings tiny;
    tiny.world.wind.gust_length = 1e-39f;
    EXPECT_EQ(refusal(tiny), "Wind::gust_length is 1e-39; it must be from 0.001 to 100000");
    tiny = {};
    tiny.cloth.self_collision.distance = 1e-7f;
    EXPECT_EQ(refusal(tiny), "SelfCollision::distance is 1e-07; it must be 0, or from 1e-06 to 10");
    tiny = {};
    tiny.cloth.finite_elements.poisson = 0.5f;
    EXPECT_EQ(refusal(tiny), "FiniteElements::poisson is 0.5; it must be below 0.5");
    tiny = {};
    tiny.world.gravity.x = 2e4f;
    EXPECT_EQ(
        refusal(tiny),
        "WorldSettings::gravity is (20000, -9.81, 0); it must be from -10000 to 10000 in every component");
}

TEST(SettingRanges, AreListedOfWhatCounts) {
    const auto count = [](Settings settings, const std::string& wanted) {
        return std::ranges::count(numbers(settings), wanted, name);
    };
    Settings settings;
    EXPECT_EQ(count(settings, "AirSource::radius"), 0);
    EXPECT_EQ(count(with_air(), "AirSource::radius"), 1);
    EXPECT_EQ(count(with_air(), "AirShelter::border"), 2);
    EXPECT_EQ(count(with_air(), "AirShelter::radius"), 1) << "a box has none";
    EXPECT_EQ(count(settings, "Multilevel::passes"), 1);
    settings.cloth.method = Jacobi{};
    EXPECT_EQ(count(settings, "Multilevel::passes"), 0);
    EXPECT_EQ(count(settings, "Jacobi::iterations"), 1);
}

TEST(SettingRanges, ValuesThatNoEnumHasAreRefusedByName) {
    const struct {
        const char *names, *right;
        void (*spoil)(ClothSettings&);
    } cases[] = {
        {"ClothSettings::time_scheme is 77", "TimeScheme::bdf2",
         [](ClothSettings& s) { s.time_scheme = static_cast<TimeScheme>(77); }},
        {"ClothSettings::time_scheme is -1", "TimeScheme::backward_euler",
         [](ClothSettings& s) { s.time_scheme = static_cast<TimeScheme>(-1); }},
        {"Fibres::vertical is 9", "SetSolver::ldlt",
         [](ClothSettings& s) { s.method = Fibres{.vertical = static_cast<Fibres::SetSolver>(9)}; }},
        {"Fibres::horizontal is 9", "SetSolver::ldlt",
         [](ClothSettings& s) { s.method = Fibres{.horizontal = static_cast<Fibres::SetSolver>(9)}; }},
        {"Fibres::shear is 9", "SetSolver::ldlt",
         [](ClothSettings& s) { s.method = Fibres{.shear = static_cast<Fibres::SetSolver>(9)}; }},
        {"SelfCollision::method is 7", "SelfCollisionMethod::contact",
         [](ClothSettings& s) { s.self_collision.method = static_cast<SelfCollisionMethod>(7); }},
        {"ClothSettings::collider_response is 9", "ColliderResponse::velocity_filter",
         [](ClothSettings& s) { s.collider_response = static_cast<ColliderResponse>(9); }},
        {"Filling::kind is 9", "FillingKind::volume",
         [](ClothSettings& s) { s.filling.kind = static_cast<FillingKind>(9); }},
        {"SelfCollision::restitution is 1.5", "from 0 to 1",
         [](ClothSettings& s) { s.self_collision.restitution = 1.5f; }},
    };
    for (const auto& c : cases) {
        Settings settings;
        c.spoil(settings.cloth);
        const std::string message = refusal(settings);
        EXPECT_NE(message.find(c.names), std::string::npos) << message;
        EXPECT_NE(message.find(c.right), std::string::npos) << message;
    }
}

TEST(SettingRanges, RestitutionWithoutImpactZonesIsRefused) {
    Settings settings;
    SelfCollision& self = settings.cloth.self_collision;
    self.restitution = 0.5f;
    for (const auto method : {SelfCollisionMethod::avoidance, SelfCollisionMethod::contact}) {
        self.method = method;
        EXPECT_NE(refusal(settings).find("SelfCollision::restitution is not 0"), std::string::npos);
        EXPECT_NE(refusal(settings).find("SelfCollisionMethod::impact_zones"), std::string::npos);
    }
    self.method = SelfCollisionMethod::impact_zones;
    EXPECT_EQ(refusal(settings), "");
}

TEST(SettingRanges, ElementsThatAMethodCannotHonourAreRefused) {
    Settings settings;
    settings.cloth.finite_elements.enabled = true;
    for (const Method& method : {Method(Xpbd{}), Method(Fibres{})}) {
        settings.cloth.method = method;
        EXPECT_NE(refusal(settings).find("FiniteElements::enabled is true"), std::string::npos);
    }
    settings.cloth.method = SymplecticEuler{};
    EXPECT_EQ(refusal(settings), "");
    settings.cloth.finite_elements.consistent_mass = true;
    EXPECT_NE(refusal(settings).find("FiniteElements::consistent_mass is true"), std::string::npos);
    settings.cloth.finite_elements.enabled = false;
    EXPECT_EQ(refusal(settings), "") << "without elements nothing is asked of their masses";
    settings.cloth.finite_elements.enabled = true;
    settings.cloth.method = Multilevel{};
    EXPECT_EQ(refusal(settings), "");
}

TEST(TinyMeshes, EveryMassAndInverseMassIsFinite) {
    // Slivers and specks, down to what is dropped, under the least and the greatest density.
    int taken = 0;
    for (const float size : {1e-7f, 3e-7f, 1e-6f, 1e-3f, 1.0f, 1e4f}) {
        for (const float height : {1.0f, 1e-3f, 3e-6f}) {
            Mesh mesh;
            mesh.positions = {
                {0, 0, 0}, {size, 0, 0}, {0.5f * size, height * size, 0}, {0.5f * size, -size, 0}};
            mesh.triangles = {{0, 1, 2}, {1, 0, 3}};
            for (const float density : {1e-4f, 1e4f}) {
                SCOPED_TRACE(testing::Message() << size << " " << height << " " << density);
                ClothSettings settings;
                settings.fabric.areal_density = density;
                World world = must(World::create({.threads = 1}));
                const auto id = world.add_cloth(mesh, settings);
                if (!id) {
                    EXPECT_NE(id.error().message.find("have no area"), std::string::npos);
                    continue;
                }
                ++taken;
                const ClothInfo info = must(world.cloth_info(*id));
                EXPECT_TRUE(std::isfinite(info.mass));
                EXPECT_GT(info.mass, 0);
                for (int step = 0; step < 3; ++step)
                    EXPECT_FALSE(has(world.step(1.0f / 60).flags, StepFlags::state_restored));
                for (const Vec4& p : world.cloth(*id)->positions) EXPECT_TRUE(std::isfinite(p.w));
            }
        }
    }
    EXPECT_GE(taken, 20) << "of 36";
}

TEST(ClothViews, AreTheWorldsOwnSoThatALoopOverThemIsSound) {
    static_assert(
        std::is_same_v<decltype(std::declval<const World&>().cloth(ClothId{})), Result<const ClothView&>>);
    World world = must(World::create({.threads = 1}));
    const ClothId id = must(world.add_cloth(sheet(3, 3)));
    const ClothView* const first = &*world.cloth(id);
    int particles = 0;
    for (const Vec4& p : world.cloth(id)->positions) particles += std::isfinite(p.x);
    EXPECT_EQ(particles, 9);
    world.step(1.0f / 60);
    EXPECT_EQ(&*world.cloth(id), first);
    EXPECT_EQ(first->positions.data(), world.cloth(id)->positions.data());
    EXPECT_FALSE(world.cloth(ClothId{}).ok());
}

}  // namespace
}  // namespace weft::test
