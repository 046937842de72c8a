#include "demo/study/physics/experiment.h"

#include <cmath>
#include <utility>

#include "demo/must.h"

namespace weft::study {

namespace {

double squared(const Vec3& v) {
    const double x = v.x, y = v.y, z = v.z;
    return x * x + y * y + z * z;
}

}  // namespace

Experiment::Experiment(Mesh mesh, const ClothSettings& cloth, const WorldSettings& settings)
    : mesh_(std::move(mesh)),
      world_(must(World::create(settings))),
      cloth_(must(world_.add_cloth(mesh_, cloth))) {}

WorldSettings in_vacuum(const Vec3& gravity) {
    WorldSettings settings;
    settings.gravity = gravity;
    settings.wind.air_density = 0;
    settings.threads = 1;
    return settings;
}

void Experiment::pin(const std::function<bool(Vec2)>& of_the_pattern) {
    must(world_.pin(cloth_, vertices(of_the_pattern)));
}

void Experiment::run(double seconds, float step, const std::function<void()>& each) {
    const auto steps = std::lround(seconds / static_cast<double>(step));
    for (long k = 0; k < steps; ++k) {
        world_.step(step);
        if (each) each();
    }
}

bool Experiment::come_to_rest(double damping, double most_seconds, float still) {
    const float before = must(world_.cloth_settings(cloth_)).air_damping;
    change([&](ClothSettings& settings) { settings.air_damping = static_cast<float>(damping); });
    constexpr int wanted = 10;
    int still_steps = 0;
    const double steps = most_seconds / static_cast<double>(usual_step);
    for (int k = 0; k < steps && still_steps < wanted; ++k) {
        world_.step(usual_step);
        still_steps = world_.report().peak_speed < still ? still_steps + 1 : 0;
    }
    change([&](ClothSettings& settings) { settings.air_damping = before; });
    return still_steps == wanted;
}

void Experiment::change(const std::function<void(ClothSettings&)>& how) {
    ClothSettings settings = must(world_.cloth_settings(cloth_));
    how(settings);
    must(world_.set_cloth_settings(cloth_, settings));
}

void Experiment::change_world(const std::function<void(WorldSettings&)>& how) {
    WorldSettings settings = world_.settings();
    how(settings);
    must(world_.set_settings(settings));
}

Vec3 Experiment::at(std::uint32_t vertex) const {
    const ClothView& view = *world_.cloth(cloth_);
    const Vec4& p = view.positions[view.vertex_to_particle[vertex]];
    return {p.x, p.y, p.z};
}

Vec3 Experiment::velocity(std::uint32_t vertex) const {
    const ClothView& view = *world_.cloth(cloth_);
    const Vec4& v = view.velocities[view.vertex_to_particle[vertex]];
    return {v.x, v.y, v.z};
}

double Experiment::mass(std::uint32_t vertex) const {
    const ClothView& view = *world_.cloth(cloth_);
    const double inverse = view.positions[view.vertex_to_particle[vertex]].w;
    return inverse > 0 ? 1 / inverse : 0;
}

std::vector<std::uint32_t> Experiment::vertices(const std::function<bool(Vec2)>& of_the_pattern) const {
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < mesh_.pattern.size(); ++i)
        if (of_the_pattern(mesh_.pattern[i])) found.push_back(i);
    return found;
}

Vec3 Experiment::mean_place(const std::vector<std::uint32_t>& vertices) const {
    double x = 0, y = 0, z = 0;
    for (const std::uint32_t vertex : vertices) {
        const Vec3 p = at(vertex);
        x += static_cast<double>(p.x);
        y += static_cast<double>(p.y);
        z += static_cast<double>(p.z);
    }
    const auto count = static_cast<double>(vertices.size());
    return {static_cast<float>(x / count), static_cast<float>(y / count), static_cast<float>(z / count)};
}

double Experiment::energy() const {
    double sum = 0;
    for (std::uint32_t i = 0; i < mesh_.pattern.size(); ++i)
        sum += mass(i) * (0.5 * squared(velocity(i)) + gravity * static_cast<double>(at(i).y));
    return sum;
}

double Experiment::rms_speed() const {
    double sum = 0, all = 0;
    for (std::uint32_t i = 0; i < mesh_.pattern.size(); ++i) {
        sum += mass(i) * squared(velocity(i));
        all += mass(i);
    }
    return std::sqrt(sum / all);
}

}  // namespace weft::study
