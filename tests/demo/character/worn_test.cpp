// Somebody dressed, over some steps: what is worn stays outside the body, does not cross, and is not
// stretched.

#include <gtest/gtest.h>

#include <optional>

#include "demo/character/character.h"
#include "demo/character/garment/wear.h"
#include "demo/study/crossings/crossings.h"
#include "tests/demo/character/temporary_file.h"
#include "tests/demo/garments.h"

namespace weft::demo {
namespace {

constexpr float dt = 1.0f / 60;

CharacterSettings with_contact() {
    CharacterSettings settings;
    settings.cloth.fabric.areal_density = 0.16f;
    settings.cloth.self_collision.method = SelfCollisionMethod::contact;
    return settings;
}

struct Worn {
    std::uint32_t inside_at_end = 0, frames_inside = 0;
    float deepest = 0;  ///< [m]
    float stretch_99 = 0, mean_stretch_99 = 0;
    std::uint64_t crossings = 0;
};

/// After `seconds`, of which what comes before `from` is not judged.
Worn wear(const CharacterSettings& settings, double seconds, double from) {
    auto made = Character::create(settings);
    if (!made) throw std::runtime_error(made.error().message);
    Character character = std::move(*made);
    auto world = World::create({.threads = 2});
    if (auto entered = character.enter(*world); !entered) throw std::runtime_error(entered.error().message);
    WearMeter meter(character.garment().mesh, settings.cloth.thickness);
    Worn worn;
    int judged = 0;
    for (int step = 0; step < static_cast<int>(60 * seconds); ++step) {
        character.before_step(*world, step / 60.0, dt);
        EXPECT_FALSE(has(world->step(dt).flags, StepFlags::state_restored));
        if (step / 60.0 < from) continue;
        const auto measured = meter.measure(*world->cloth(character.cloth()), character.capsules());
        worn.frames_inside += measured.inside > 0;
        worn.inside_at_end = measured.inside;
        worn.deepest = std::max(worn.deepest, measured.deepest);
        ++judged;
        worn.mean_stretch_99 += (measured.stretch_99 - worn.mean_stretch_99) / static_cast<float>(judged);
        worn.stretch_99 = std::max(worn.stretch_99, measured.stretch_99);
    }
    study::TriangleSoup soup;
    soup.add(*world->cloth(character.cloth()));
    worn.crossings = study::count_crossings(soup).all;
    return worn;
}

TEST(Worn, DressOnAWalkStaysOutside) {
    CharacterSettings settings = with_contact();
    const Worn worn = wear(settings, 4, 0);
    EXPECT_EQ(worn.frames_inside, 0u);
    EXPECT_EQ(worn.crossings, 0u);
    EXPECT_LT(worn.mean_stretch_99, 1.025f);
    EXPECT_LT(worn.stretch_99, 1.08f);
}

/// A dress of the scene crowd, over its ten seconds. The drawn figure is 2 mm within its knees.
TEST(Worn, CoarseDressShowsNoKnee) {
    CharacterSettings settings = with_contact();
    settings.particles = 800;
    settings.cloth.thickness = 0.01f;
    settings.ahead = 0.137 * 7;
    const Worn worn = wear(settings, 10, 0);
    EXPECT_EQ(worn.frames_inside, 0u);
    EXPECT_LT(worn.deepest, 1e-3f);
}

class Wardrobe : public testing::TestWithParam<const char*> {};

TEST_P(Wardrobe, FitsAfterASecond) {
    WEFT_NEEDS_DATA();
    CharacterSettings settings = with_contact();
    settings.garment = data_folder() / "garments" / (std::string(GetParam()) + ".obj");
    settings.motion = data_folder() / "motion" / "walk.bvh";
    const Worn worn = wear(settings, 1.5, 1.2);
    EXPECT_EQ(worn.inside_at_end, 0u);
    EXPECT_EQ(worn.crossings, 0u);
}

// On somebody who runs, an arm bends into where the shirt is fixed, and legs go faster than the cloth of a
// dress turns out of their way.
TEST(Worn, StaysOutsideOfSomebodyWhoRuns) {
    WEFT_NEEDS_DATA();
    CharacterSettings settings = with_contact();
    settings.motion = data_folder() / "motion" / "run.bvh";
    settings.garment = data_folder() / "garments" / "tshirt-iso.obj";
    EXPECT_EQ(wear(settings, 2.5, 1.5).frames_inside, 0u);
    settings.garment.clear();
    settings.speed = 2;
    EXPECT_LE(wear(settings, 3.5, 1.5).frames_inside, 4u);  // of 120
}

INSTANTIATE_TEST_SUITE_P(Garments, Wardrobe,
                         testing::Values("tshirt-iso", "skirt-iso", "dress-victor-iso-draped"),
                         [](const auto& garment) {
                             const std::string name = garment.param;
                             return name.substr(0, name.find('-'));
                         });

TEST(Worn, FixedVerticesAreWhereTheBodyIs) {
    auto made = Character::create([] {
        CharacterSettings settings = with_contact();
        settings.particles = 300;
        settings.place = {5, 0, -3};
        return settings;
    }());
    ASSERT_TRUE(made.ok()) << made.error().message;
    auto world = World::create({.threads = 1});
    ASSERT_TRUE(made->enter(*world).ok());
    for (int step = 0; step < 120; ++step) {
        made->before_step(*world, step / 60.0, dt);
        world->step(dt);
    }
    const ClothView& view = *world->cloth(made->cloth());
    for (const std::uint32_t vertex : made->garment().fixed) {
        const Vec4& p = view.positions[view.vertex_to_particle[vertex]];
        EXPECT_EQ(p.w, 0);
        float least = 1;
        for (const TaperedCapsule& capsule : made->capsules())
            least = std::min(least, distance_to(capsule, xyz(p)).distance);
        EXPECT_LT(least, 0.03f);
        EXPECT_GT(least, -0.012f);
        EXPECT_NEAR(p.x, 5, 0.4f);
    }
    for (std::size_t i = 0; i < made->capsules().size(); ++i) {
        const auto collider = world->collider(made->colliders()[i]);
        EXPECT_EQ(std::get<TaperedCapsule>(collider->shape).a.y, made->capsules()[i].a.y);
    }
}

/// Somebody in a small dress, in a World of their own.
struct Walker {
    explicit Walker(BodySurface surface) : world(std::move(World::create({.threads = 1})).value()) {
        CharacterSettings settings = with_contact();
        settings.particles = 400;
        settings.surface = surface;
        character.emplace(std::move(Character::create(settings)).value());
        EXPECT_TRUE(character->enter(world).ok());
    }
    void run(int steps) {
        for (const int end = step + steps; step < end; ++step) {
            character->before_step(world, step / 60.0, dt);
            world.step(dt);
        }
    }
    [[nodiscard]] Vector3 vertex(std::uint32_t v) const {
        const ClothView view = *world.cloth(character->cloth());
        return xyz(view.positions[view.vertex_to_particle[v]]);
    }
    [[nodiscard]] std::vector<float> lengths() const {
        std::vector<float> found;
        for (const Triangle& t : character->garment().mesh.triangles)
            for (std::size_t c = 0; c < 3; ++c)
                found.push_back((vertex(t[c]) - vertex(t[(c + 1) % 3])).norm());
        return found;
    }

    World world;
    std::optional<Character> character;
    int step = 0;
};

/// Beside one who stays no edge is longer or shorter by more than a twentieth.
TEST(Worn, TeleportsKeepWhatHangs) {
    for (const BodySurface surface : {BodySurface::capsules, BodySurface::skin}) {
        Walker stays(surface), goes(surface);
        stays.run(90);
        goes.run(90);
        for (const Transform& by : {Transform{.translation = {40, 0, 0}}, Transform{.rotation = {0, 1, 0, 0}},
                                    Transform{.translation = {-8, 0, 3}, .rotation = {0, 0.6f, 0, 0.8f}}}) {
            const std::vector<float> before = goes.lengths();
            const Vector3 from = goes.vertex(0);
            ASSERT_TRUE(goes.character->teleport(goes.world, by).ok());
            const std::vector<float> at_once = goes.lengths();
            for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(at_once[i] / before[i], 1, 1e-3f);
            EXPECT_GT((goes.vertex(0) - from).norm(), 5);
            for (int k = 0; k < 3; ++k) {
                stays.run(1);
                goes.run(1);
                const std::vector<float> expected = stays.lengths(), after = goes.lengths();
                float worst = 0;
                for (std::size_t i = 0; i < before.size(); ++i)
                    worst = std::max(worst, std::abs(after[i] / expected[i] - 1));
                EXPECT_LT(worst, 0.05f) << "after " << k + 1 << " steps";
            }
        }
    }
}

TEST(Worn, ErrorsNameTheFile) {
    CharacterSettings settings;
    settings.garment = "no/such.obj";
    EXPECT_NE(Character::create(settings).error().message.find("no/such.obj"), std::string::npos);
    settings = {};
    const TemporaryFile stick("stick.bvh",
                              "HIERARCHY ROOT a { OFFSET 0 0 0 CHANNELS 0 End Site { OFFSET 0 1 0 } } MOTION "
                              "Frames: 1 Frame Time: 0.1");
    settings.motion = stick.path();
    const auto made = Character::create(settings);
    ASSERT_FALSE(made.ok());
    EXPECT_NE(made.error().message.find("stick.bvh"), std::string::npos) << made.error().message;
    EXPECT_NE(made.error().message.find("no joint named hips"), std::string::npos) << made.error().message;
}

}  // namespace
}  // namespace weft::demo
