// A scene's picture besides its cloth: figures, holders, and colours that tell sheets apart.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "collision/colliders/nearest_surface.h"
#include "demo/scene_simulation.h"
#include "demo/time/timeline.h"
#include "engine/vector.h"
#include "tests/demo/small_world.h"

namespace weft::demo {
namespace {

float distance_to_segment(const Vector3& p, const Vec3& from, const Vec3& to) {
    const Vector3 a = to_vector(from), ab = to_vector(to) - a;
    const float t = ab.isZero(0) ? 0 : std::clamp((p - a).dot(ab) / ab.squaredNorm(), 0.0f, 1.0f);
    return (p - a - t * ab).norm();
}

/// From a point to the nearest solid that is drawn [m].
float distance_to_solids(const Simulation& simulation, const Annotation& drawn, const Vector3& p) {
    float least = std::numeric_limits<float>::infinity();
    for (const auto& sphere : drawn.spheres)
        least = std::min(least, (p - to_vector(sphere.center)).norm() - sphere.radius);
    for (const auto& rod : drawn.capsules)
        least = std::min(least, distance_to_segment(p, rod.a, rod.b) - rod.radius);
    for (const ColliderId id : simulation.content().drawn_colliders) {
        const auto collider = simulation.world().collider(id);
        if (const auto* rod = std::get_if<Capsule>(&collider->shape))
            least = std::min(least, distance_to_segment(p, rod->a, rod->b) - rod->radius);
    }
    for (const SceneSolid& solid : simulation.content().solids) {
        std::vector<Vec3> corners = solid.mesh.positions;
        if (solid.place) solid.place(corners, SolidMoment::now);
        for (const Vec3& corner : corners) least = std::min(least, (p - to_vector(corner)).norm());
    }
    return least;
}

/// The scene after so many steps.
Simulation after(const char* scene, int steps) {
    Simulation simulation = simulation_of(scene, 600, {});
    for (int i = 0; i < steps; ++i) simulation.step(1.0f / 60);
    return simulation;
}

class Holders : public testing::TestWithParam<const char*> {};

TEST_P(Holders, AreDrawnWhereClothIsHeld) {
    const Simulation simulation = after(GetParam(), 30);
    Annotation drawn;
    simulation.scene().annotate(simulation.world(), drawn);
    std::size_t held = 0;
    for (const SceneCloth& cloth : simulation.content().cloths)
        for (const Vec4& particle : simulation.world().cloth(cloth.id)->positions) {
            if (particle.w != 0) continue;
            ++held;
            EXPECT_LT(distance_to_solids(simulation, drawn, xyz(particle)), 0.06f)
                << particle.x << ' ' << particle.y << ' ' << particle.z;
        }
    EXPECT_GT(held, 1u);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Holders,
                         testing::Values("banner", "bar", "ball", "curtain", "flag", "gathered", "hammock",
                                         "release", "tangled", "tear", "trampoline", "twist", "yank"),
                         [](const auto& scene) { return std::string(scene.param); });

TEST_F(Holders, LetGoWithTheCloth) {
    const Simulation simulation = after("release", 260);  // its lower end is free from 4 s on
    Annotation drawn;
    simulation.scene().annotate(simulation.world(), drawn);
    EXPECT_EQ(drawn.capsules.size(), 1u);
}

// Figures are within the colliders that cloth meets, and where the World is in time.

std::vector<Vec3> places_of(const SceneSolid& solid, SolidMoment moment = SolidMoment::now) {
    std::vector<Vec3> places(solid.mesh.positions.size());
    solid.place(places, moment);
    return places;
}

class Figures : public testing::TestWithParam<const char*> {};

TEST_P(Figures, AreWithinWhatClothMeets) {
    const Simulation simulation = after(GetParam(), 75);
    const SceneContent& content = simulation.content();
    ASSERT_FALSE(content.solids.empty());
    EXPECT_TRUE(content.drawn_colliders.empty()) << "the figure is drawn in their place";
    std::vector<Collider> colliders;
    for (const ColliderId id : content.clad_colliders) colliders.push_back(*simulation.world().collider(id));
    for (std::size_t person = 0; person < content.solids.size(); person += 3) {
        const SceneSolid& solid = content.solids[person];
        const std::vector<Vec3> places = places_of(solid);
        float most = -1;
        for (const Triangle& t : solid.mesh.triangles) {
            const Vector3 middle =
                (to_vector(places[t[0]]) + to_vector(places[t[1]]) + to_vector(places[t[2]])) / 3;
            float nearest = 1;
            for (const Collider& collider : colliders)
                nearest = std::min(nearest, nearest_surface(collider, middle).distance);
            most = std::max(most, nearest);
        }
        EXPECT_LT(most, 1e-3f) << "[m] outside, person " << person;
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Figures,
                         testing::Values("character", "runner", "crowd", "capes", "worn_truth"),
                         [](const auto& scene) { return std::string(scene.param); });

TEST(Figure, IsDrawnWhereTheWorldIsInTime) {
    for (const char* scene : {"character", "capes", "worn_truth"}) {
        Simulation simulation = after(scene, 60);
        Timeline timeline;
        ASSERT_TRUE(timeline.keep(simulation).ok());
        const std::vector<Vec3> then = places_of(simulation.content().solids[0]);
        for (int i = 0; i < 20; ++i) simulation.step(1.0f / 60);
        const std::vector<Vec3> later = places_of(simulation.content().solids[0]);
        ASSERT_TRUE(timeline.go_to(0, simulation).ok());
        const std::vector<Vec3> again = places_of(simulation.content().solids[0]);
        float moved = 0, off = 0;
        for (std::size_t v = 0; v < then.size(); ++v) {
            moved = std::max(moved, (to_vector(later[v]) - to_vector(then[v])).norm());
            off = std::max(off, (to_vector(again[v]) - to_vector(then[v])).norm());
        }
        EXPECT_GT(moved, 0.02f) << scene;
        EXPECT_LT(off, 1e-4f) << scene;
    }
}

/// A picture between two steps shows the body as late as it shows the cloth.
TEST(Figure, IsKnownBeforeTheLastStep) {
    for (const char* scene : {"character", "capes", "worn_truth"}) {
        Simulation simulation = after(scene, 70);
        const std::vector<Vec3> then = places_of(simulation.content().solids[0]);
        simulation.step(1.0f / 60);
        const std::vector<Vec3> before =
            places_of(simulation.content().solids[0], SolidMoment::before_last_step);
        for (std::size_t v = 0; v < then.size(); ++v)
            ASSERT_LT((to_vector(before[v]) - to_vector(then[v])).norm(), 1e-4f) << scene;
    }
}

}  // namespace
}  // namespace weft::demo
