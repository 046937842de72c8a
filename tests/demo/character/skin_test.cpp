// The skin of a body: closed, where its limbs are, and met by cloth.

#include "demo/character/body/skin.h"

#include <gtest/gtest.h>

#include <map>

#include "demo/character/character.h"
#include "demo/character/motion/generated_walk.h"

namespace weft::demo {
namespace {

float distance_from(const std::vector<TaperedCapsule>& limbs, const Vec3& point) {
    float least = 1;
    for (const TaperedCapsule& limb : limbs)
        least = std::min(least, distance_to(limb, to_vector(point)).distance);
    return least;
}

TEST(Skin, IsClosedAndWhereLimbsAre) {
    const Skeleton skeleton = plain_skeleton();
    const Body body = Body::create(skeleton).value();
    const Skin skin = Skin::round_limbs(body, skeleton, 0.9f);
    ASSERT_GT(skin.size(), 1000u);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (const Triangle& t : skin.triangles())
        for (std::size_t c = 0; c < 3; ++c) ++sides[{t[c], t[(c + 1) % 3]}];
    for (const auto& [side, count] : sides) {
        EXPECT_EQ(count, 1);
        EXPECT_EQ(sides.count({side.second, side.first}), 1u) << "one triangle on each side of an edge";
    }
    std::vector<Vec3> places(skin.size());
    for (const auto& [arms, apart, within] : {std::tuple(30.0f, 0.25f, 2e-3f), {60.0f, 0.1f, 0.02f}}) {
        Pose pose;
        place_joints(skeleton, body.stance(skeleton, arms, apart), pose);
        std::vector<TaperedCapsule> limbs;
        body.place(pose, 0.9f, limbs);
        skin.place(pose, limbs, 1, places);
        for (const Vec3& p : places) EXPECT_NEAR(distance_from(limbs, p), 0, within);
        double volume = 0;
        for (const Triangle& t : skin.triangles())
            volume += static_cast<double>(
                to_vector(places[t[0]]).dot(to_vector(places[t[1]]).cross(to_vector(places[t[2]]))) / 6);
        EXPECT_GT(volume, 0.015) << "m^3, outside out";
        EXPECT_LT(volume, 0.08);
    }
}

TEST(Skin, CarriesADress) {
    CharacterSettings settings;
    settings.particles = 600;
    settings.surface = BodySurface::skin;
    settings.cloth.fabric.areal_density = 0.16f;
    auto made = Character::create(settings);
    ASSERT_TRUE(made.ok()) << made.error().message;
    auto world = World::create({.threads = 1});
    ASSERT_TRUE(made->enter(*world).ok());
    ASSERT_EQ(made->colliders().size(), 1u);
    for (int step = 0; step < 120; ++step) {
        made->before_step(*world, step / 60.0, 1.0f / 60);
        ASSERT_FALSE(has(world->step(1.0f / 60).flags, StepFlags::state_restored));
    }
    const ClothView& view = *world->cloth(made->cloth());
    EXPECT_GT(view.bounds.lower.y, 0.25f);
    std::size_t deep = 0;
    for (const Vec4& p : view.positions)
        deep += p.w > 0 && distance_from(made->capsules(), {p.x, p.y, p.z}) < -0.01f ? 1 : 0;
    EXPECT_LT(deep, view.positions.size() / 100) << "but for where limbs fold";
}

}  // namespace
}  // namespace weft::demo
