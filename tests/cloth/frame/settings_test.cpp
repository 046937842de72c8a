// Settings as a host gives them: every range is held at both its ends, none of which breaks a step, and what
// lies outside is refused by name.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <span>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "cloth/settings/fields.h"
#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"

namespace weft::test {
namespace {

constexpr float infinite_setting = std::numeric_limits<float>::infinity();

struct Settings {
    WorldSettings world{.threads = 1};
    ClothSettings cloth;
};

/// A number that can be set, and the ends of its range.
struct Knob {
    const char* name;
    float least, greatest;
    std::function<float&(Settings&)> of;
};

AirShelter& shelter(Settings& s, AirShelterKind kind) {
    s.world.wind.shelters[0].kind = kind;
    return s.world.wind.shelters[0];
}
AirShelter& ball(Settings& s) {
    return shelter(s, AirShelterKind::ball);
}
AirShelter& box(Settings& s) {
    return shelter(s, AirShelterKind::box);
}

AirSource& jet(Settings& settings) {
    AirSource& source = settings.world.wind.sources[0];
    source.kind = AirSourceKind::jet;
    return source;
}

std::vector<Knob> knobs() {
    using S = Settings;
    return {
        {"Fabric::areal_density", 1e-4f, 1e4f, [](S& s) -> float& { return s.cloth.fabric.areal_density; }},
        {"Fabric::warp", 0, 1e9f, [](S& s) -> float& { return s.cloth.fabric.warp; }},
        {"Fabric::shear", 0, 1e9f, [](S& s) -> float& { return s.cloth.fabric.shear; }},
        {"Fabric::weft", 0, 1e9f, [](S& s) -> float& { return s.cloth.fabric.weft; }},
        {"Fabric::bending", 0, 1e4f, [](S& s) -> float& { return s.cloth.fabric.bending; }},
        {"Fabric::bending_ratio", 0.01f, 100, [](S& s) -> float& { return s.cloth.fabric.bending_ratio; }},
        {"Fabric::damping", 0, 100, [](S& s) -> float& { return s.cloth.fabric.damping; }},
        // Of the default's stiffness; only what stretches honours it.
        {"Fabric::stiffening", 0, 1000, [](S& s) -> float& { return s.cloth.fabric.stiffening; }},
        {"Multilevel::tolerance", 0, 1e9f,
         [](S& s) -> float& {
             if (!std::holds_alternative<Multilevel>(s.cloth.method)) s.cloth.method = Multilevel{};
             return std::get<Multilevel>(s.cloth.method).tolerance;
         }},
        {"FiniteElements::poisson", 0, 0.49f, [](S& s) -> float& { return s.cloth.finite_elements.poisson; }},
        {"Tethers::slack", 1, 1e3f, [](S& s) -> float& { return s.cloth.tethers.slack; }},
        {"SelfCollision::distance", 1e-6f, 10,
         [](S& s) -> float& { return s.cloth.self_collision.distance; }},
        {"SelfCollision::friction", 0, 1e3f, [](S& s) -> float& { return s.cloth.self_collision.friction; }},
        {"SelfCollision::restitution", 0, 1,
         [](S& s) -> float& {
             s.cloth.self_collision.method = SelfCollisionMethod::impact_zones;
             return s.cloth.self_collision.restitution;
         }},
        {"ClothSettings::air_damping", 0, 1e6f, [](S& s) -> float& { return s.cloth.air_damping; }},
        {"ClothSettings::thickness", 0, 10, [](S& s) -> float& { return s.cloth.thickness; }},
        {"ClothSettings::friction", 0, 1e3f, [](S& s) -> float& { return s.cloth.friction; }},
        {"ClothSettings::back_friction_ratio", 0, 1e3f,
         [](S& s) -> float& { return s.cloth.back_friction_ratio; }},
        {"ClothSettings::restitution", 0, 1, [](S& s) -> float& { return s.cloth.restitution; }},
        {"ClothSettings::sleep_speed", 0, 1e3f, [](S& s) -> float& { return s.cloth.sleep_speed; }},
        {"FrameInertia::linear", 0, 1, [](S& s) -> float& { return s.cloth.frame_inertia.linear; }},
        {"FrameInertia::angular", 0, 1, [](S& s) -> float& { return s.cloth.frame_inertia.angular; }},
        {"FrameInertia::centrifugal", 0, 1, [](S& s) -> float& { return s.cloth.frame_inertia.centrifugal; }},
        {"ClothSettings::importance", 0, 1e6f, [](S& s) -> float& { return s.cloth.importance; }},
        {"ClothSettings::gravity_scale", -10, 10, [](S& s) -> float& { return s.cloth.gravity_scale; }},
        {"ClothSettings::wind_scale", 0, 10, [](S& s) -> float& { return s.cloth.wind_scale; }},
        {"Filling::pressure", -1e5f, 1e7f, [](S& s) -> float& { return s.cloth.filling.pressure; }},
        {"Filling::volume", 1e-12f, 1e9f, [](S& s) -> float& { return s.cloth.filling.volume; }},
        {"Filling::outside", 0, 1e7f, [](S& s) -> float& { return s.cloth.filling.outside; }},
        {"ClothSettings::teleport_distance", 0, 1e6f,
         [](S& s) -> float& { return s.cloth.teleport_distance; }},
        {"ClothSettings::teleport_angle", 0, 3.2f, [](S& s) -> float& { return s.cloth.teleport_angle; }},
        {"WorldSettings::gravity", -1e4f, 1e4f, [](S& s) -> float& { return s.world.gravity.y; }},
        {"Wind::velocity", -1e3f, 1e3f, [](S& s) -> float& { return s.world.wind.velocity.z; }},
        {"Wind::gust", 0, 100, [](S& s) -> float& { return s.world.wind.gust; }},
        {"Wind::gust_length", 1e-3f, 1e5f, [](S& s) -> float& { return s.world.wind.gust_length; }},
        {"Wind::air_density", 0, 1e4f, [](S& s) -> float& { return s.world.wind.air_density; }},
        {"Wind::drag", 0, 1e3f, [](S& s) -> float& { return s.world.wind.drag; }},
        {"Wind::lift", 0, 1e3f, [](S& s) -> float& { return s.world.wind.lift; }},
        {"AirSource::position", -1e5f, 1e5f, [](S& s) -> float& { return jet(s).position.x; }},
        {"AirSource::velocity", -1e3f, 1e3f, [](S& s) -> float& { return jet(s).velocity.y; }},
        {"AirSource::radius", 1e-3f, 1e5f, [](S& s) -> float& { return jet(s).radius; }},
        {"AirShelter::position", -1e5f, 1e5f, [](S& s) -> float& { return ball(s).position.y; }},
        {"AirShelter::half_extents", 1e-3f, 1e5f, [](S& s) -> float& { return box(s).half_extents.z; }},
        {"AirShelter::radius", 1e-3f, 1e5f, [](S& s) -> float& { return ball(s).radius; }},
        {"AirShelter::border", 1e-3f, 1e5f, [](S& s) -> float& { return ball(s).border; }},
        {"AirShelter::exposure", 0, 1, [](S& s) -> float& { return ball(s).exposure; }},
        {"WorldSettings::max_speed", 1e-3f, 1e4f, [](S& s) -> float& { return s.world.max_speed; }},
        {"WorldSettings::budget", 0, 1e3f, [](S& s) -> float& { return s.world.budget; }},
    };
}

/// Calls visit(name, components) for each float of settings, and for each vector.
template <class Fields, class Visit>
void for_each_number(Fields& of, const Visit& visit) {
    for_each_field(of, [&]<class T>(const char* name, T& value) {
        if constexpr (std::is_same_v<T, float>)
            visit(name, std::span(&value, 1));
        else if constexpr (std::is_same_v<T, Vec3>)
            visit(name, std::span(&value.x, 3));
        else if constexpr (std::is_same_v<T, Method>)
            std::visit([&](auto& method) { for_each_number(method, visit); }, value);
        else if constexpr (HasFields<T>)
            for_each_number(value, visit);
        else if constexpr (std::ranges::range<T>)
            for_each_number(value[0], visit);
        else
            static_assert(std::is_integral_v<T> || std::is_enum_v<T> || std::is_same_v<T, Rotation>,
                          "a kind of setting to visit");
    });
}

TEST(SettingRanges, EveryNumberHasAKnob) {
    Settings settings;
    std::vector<const float*> turned;
    for (const Knob& knob : knobs()) turned.push_back(&knob.of(settings));
    const auto is_turned = [&](const char* name, std::span<float> components) {
        EXPECT_TRUE(std::ranges::any_of(components, [&](const float& component) {
            return std::ranges::find(turned, &component) != turned.end();
        })) << name;
    };
    for_each_number(settings.world, is_turned);
    for_each_number(settings.cloth, is_turned);
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

/// Takes back what is refused together: stiffening where none is known, or that is too stiff.
void make_acceptable(ClothSettings& settings) {
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
    Settings settings;
    settings.world.wind = {.velocity = {1, 0, 2}, .gust = 0.5f};
    settings.cloth.self_collision.method = SelfCollisionMethod::contact;
    method.choose(settings.cloth);
    return settings;
}

TEST(SettingRanges, NeitherEndOfAnyBreaksAStep) {
    for (const ChosenMethod& method : methods) {
        for (const Knob& knob : knobs()) {
            for (const float value : {knob.least, knob.greatest}) {
                SCOPED_TRACE(std::string(method.name) + ", " + knob.name + " " + std::to_string(value));
                Settings settings = with_everything_on(method);
                knob.of(settings) = value;
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
            std::string set;
            for (const Knob& knob : knobs()) {
                const std::uint32_t choice = random() % 4;
                if (choice > 1) continue;
                knob.of(settings) = choice == 0 ? knob.least : knob.greatest;
                set += std::string(" ") + knob.name + (choice == 0 ? "-" : "+");
            }
            SCOPED_TRACE(std::string(method.name) + set);
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
    for (const Knob& knob : knobs()) {
        const std::vector<float> outside{std::nextafter(knob.least, -infinite_setting),
                                         infinite_setting,
                                         -infinite_setting,
                                         std::numeric_limits<float>::quiet_NaN(),
                                         knob.greatest * 1.1f + 0.01f,
                                         std::numeric_limits<float>::max()};
        for (const float value : outside) {
            Settings settings;
            knob.of(settings) = value;
            const std::string message = refusal(settings);
            EXPECT_NE(message.find(knob.name), std::string::npos) << knob.name << " " << value << message;
            EXPECT_NE(message.find("must be"), std::string::npos) << message;
        }
    }
    Settings tiny;
    tiny.world.wind.gust_length = 1e-39f;
    EXPECT_NE(refusal(tiny).find("Wind::gust_length is 1e-39; it must be from 0.001 to 100000"),
              std::string::npos)
        << refusal(tiny);
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
