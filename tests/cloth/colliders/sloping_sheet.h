#pragma once
// A sheet of 0.5 m laid on a slope, in a vacuum; what it lies on is its user's.

#include <cmath>
#include <span>

#include "engine/vector.h"
#include "tests/cloth/fixtures.h"

namespace weft::test {

class SlopingSheet {
  public:
    explicit SlopingSheet(double angle, int substeps = 1)
        : world(World::create(vacuum({0, -9.80665f, 0})).value()) {
        const auto s = static_cast<float>(std::sin(angle)), c = static_cast<float>(std::cos(angle));
        normal = {s, c, 0};
        down_ = {c, -s, 0};
        ClothSettings settings;
        settings.thickness = 0.005f;
        settings.friction = 1;
        settings.air_damping = 0;
        settings.substeps = substeps;
        settings.sleep_speed = 0;  // it begins to slide slowly
        const Mesh mesh = make_sheet({.rows = 24,
                                      .columns = 24,
                                      .origin = to_vec3(Vector3(0.00501f * normal)),
                                      .u = to_vec3(Vector3(0.5f * down_)),
                                      .v = {0, 0, 0.5f}})
                              .value();
        id_ = world.add_cloth(mesh, settings).value();
    }
    void run(int steps) {
        for (int step = 0; step < steps; ++step) world.step(1.0f / 60);
    }
    /// Means of all particles, down the slope.
    [[nodiscard]] double place() const { return mean(world.cloth(id_)->positions); }   ///< [m]
    [[nodiscard]] double speed() const { return mean(world.cloth(id_)->velocities); }  ///< [m/s]

    World world;
    Vector3 normal;  ///< of the slope

  private:
    [[nodiscard]] double mean(std::span<const Vec4> of) const {
        double sum = 0;
        for (const Vec4& x : of) sum += static_cast<double>(xyz(x).dot(down_));
        return sum / static_cast<double>(of.size());
    }

    Vector3 down_;
    ClothId id_;
};

}  // namespace weft::test
