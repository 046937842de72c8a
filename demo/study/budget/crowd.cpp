#include "demo/study/budget/crowd.h"

#include <cmath>
#include <ctime>
#include <memory>
#include <numbers>
#include <utility>

namespace weft::study {

namespace {

constexpr std::size_t count = 50;
constexpr std::uint32_t side = 17;
constexpr float frame = 1.0f / 60;
constexpr float turn = 8;        // time of the camera's full turn [s]
constexpr float half_sight = 1;  // half the camera's angle of view [rad]

std::int64_t processor_nanoseconds() noexcept {
    return static_cast<std::int64_t>(std::clock()) * (1'000'000'000 / CLOCKS_PER_SEC);
}

WorldSettings world_of(const CrowdSettings& settings) {
    WorldSettings world;
    world.wind.velocity = {0.5f, 0, 3};
    world.wind.gust = 0.5f;
    world.threads = 1;
    world.budget = settings.rung > 0 ? 1000.0f : settings.budget;
    return world;
}

Mesh curtain(float x, float z) {
    return make_sheet({.rows = side, .columns = side, .origin = {x, 2, z}, .u = {1, 0, 0}, .v = {0, -1, 0}})
        .value();
}

}  // namespace

Crowd::Crowd(const CrowdSettings& settings) : simulation_(world_of(settings)) {
    simulation_.clock = processor_nanoseconds;
    simulation_.has_given_choices = settings.rung > 0;
    ClothSettings of_cloth;
    of_cloth.method = settings.method;
    of_cloth.substeps = settings.substeps;
    for (std::size_t i = 0; i < count; ++i) {
        // Curtains stand all round, at distances that grow quadratically from 2 towards 60 m.
        const float part = static_cast<float>(i) / count;
        distances_.push_back(2 + 58 * part * part);
        angles_.push_back(std::fmod(2.4f * static_cast<float>(i), 2 * std::numbers::pi_v<float>));
        const Mesh mesh = curtain(distances_[i] * std::cos(angles_[i]), distances_[i] * std::sin(angles_[i]));
        auto cloth = std::make_unique<Cloth>(cook(mesh).value(), of_cloth);
        std::vector<std::uint32_t> top;
        for (std::uint32_t k = 0; k < side; ++k) top.push_back(cloth->model.vertex_to_particle[k]);
        cloth->pin(top);
        simulation_.prepare(*cloth);
        if (settings.rung > 0) cloth->state.detail->rung = settings.rung;
        cloths_.push_back(cloth.get());
        simulation_.add(std::move(cloth));
    }
}

bool Crowd::is_seen(std::size_t cloth) const {
    const float ahead = 2 * std::numbers::pi_v<float> * static_cast<float>(steps_) * frame / turn;
    return std::cos(angles_[cloth] - ahead) > std::cos(half_sight);
}

double Crowd::step() {
    ++steps_;
    for (std::size_t i = 0; i < size(); ++i) {
        cloths_[i]->settings.importance = (is_seen(i) ? 1.0f : 0.02f) / distances_[i];
    }
    const std::int64_t begin = processor_nanoseconds();
    simulation_.step(frame);
    return 1e-6 * static_cast<double>(processor_nanoseconds() - begin);
}

}  // namespace weft::study
