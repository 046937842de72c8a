// What is seen of a scene besides its cloth: that which holds it, and colours that tell sheets apart.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "demo/scene_simulation.h"
#include "engine/vector.h"

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

class Holders : public testing::TestWithParam<const char*> {
  protected:
    static Simulation after(const char* scene, int steps) {
        auto simulation = Simulation::create(*find_scene(scene), {.particles = 600}, {});
        EXPECT_TRUE(simulation.ok());
        for (int i = 0; i < steps; ++i) simulation->step(1.0f / 60);
        return std::move(*simulation);
    }
};

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

}  // namespace
}  // namespace weft::demo
